// Shows eroded ground in colour, lit by a sun and the sky, from above or in perspective. Include it after gabor_erosion.glsl.
// In space, x and z are the ground's x and y, and y points up.

struct Ground {
    ivec2 cell; // positions are relative to this cell
    vec2 period;
    uint seed;
    GaborErosion erosion;
    float reach; // the most that erosion adds to the hills
    vec2 sun;    // x and y of the unit vector towards the sun
};

vec3 sun_of(Ground ground) {
    return vec3(ground.sun.x, sqrt(max(1.0 - dot(ground.sun, ground.sun), 0.0)), ground.sun.y);
}

// The hills and the ground under a pixel that is `pixel` wide there.
GaborTerrain hills_at(Ground ground, vec2 p, float pixel) {
    return gabor_terrain_at(GaborGround(ground.cell, p, ground.period), vec2(pixel, 0.0), vec2(0.0, pixel), ground.seed);
}
GaborTerrain ground_at(Ground ground, vec2 p, float pixel) {
    return gabor_eroded_at(GaborGround(ground.cell, p, ground.period), vec2(pixel, 0.0), vec2(0.0, pixel),
                           hills_at(ground, p, pixel), ground.erosion, ground.seed);
}

// Grass and dry ground, with rock where it is steep and snow where it is high.
vec3 ground_colour(GaborTerrain here, vec3 normal) {
    float steep = length(normal.xz) / normal.y;
    vec3 colour = mix(vec3(0.1, 0.155, 0.05), vec3(0.3, 0.245, 0.145),
                      smoothstep(-0.3, 0.35, here.height + 0.1 * here.ridge));
    colour = mix(colour, vec3(0.26, 0.23, 0.205), smoothstep(0.55, 1.0, steep));
    float snow = smoothstep(0.42, 0.62, here.height + 0.08 * here.ridge) * (1.0 - smoothstep(0.9, 1.5, steep));
    return mix(colour, vec3(0.68, 0.7, 0.73), snow);
}

vec3 sunlit(vec3 sun, GaborTerrain here, vec3 normal, vec3 colour, float sunlight) {
    float open = 1.0 + 0.25 * clamp(here.ridge, -1.0, 1.0); // creases see less of the sky
    vec3 light = vec3(1.32, 1.23, 1.08) * max(dot(normal, sun), 0.0) * sunlight + vec3(0.2, 0.25, 0.33) * (0.5 + 0.5 * normal.y);
    return open * light * colour;
}

vec3 sky_along(vec3 sun, vec3 ray) {
    float glow = 0.3 * pow(max(dot(ray, sun), 0.0), 8.0) + 2.0 * pow(max(dot(ray, sun), 0.0), 2000.0);
    return mix(vec3(0.1, 0.23, 0.5), vec3(0.5, 0.6, 0.7), exp(-5.0 * max(ray.y, 0.0))) + vec3(1.0, 0.75, 0.5) * glow;
}

// The distance along the ray to the ground, or -1. Steps grow with the height above the ground and with the distance; the
// hills, which are cheap, tell where the ray is too high for any erosion to reach. `wide` is the width of a pixel at distance
// 1.
float distance_to_ground(Ground ground, vec3 eye, vec3 ray, float wide, float far) {
    float t = 0.0, before = 0.0;
    for (int i = 0; i < 200 && t < far; ++i) {
        vec3 at = eye + t * ray;
        if (at.y > 1.0 + ground.reach && ray.y > 0.0) break;
        float above = at.y - hills_at(ground, at.xz, wide * t).height;
        above = above > 1.5 * ground.reach ? above - ground.reach : at.y - ground_at(ground, at.xz, wide * t).height;
        if (above < 0.0) { // the ground is between the last two steps
            for (int j = 0; j < 6; ++j) {
                float middle = 0.5 * (before + t);
                vec3 there = eye + middle * ray;
                if (there.y > ground_at(ground, there.xz, wide * middle).height) before = middle; else t = middle;
            }
            return t;
        }
        before = t;
        t += max(0.45 * above, wide * t);
    }
    return -1.0;
}

// How much of the sun is visible, with one or two octaves of erosion on the ground in between.
float sunlight_at(Ground ground, vec3 at) {
    vec3 sun = sun_of(ground);
    float light = 1.0, t = 0.04;
    for (int i = 0; i < 12 && light > 0.0; ++i) {
        vec3 there = at + t * sun;
        float above = there.y - ground_at(ground, there.xz, 0.15).height;
        light = min(light, 0.5 + 12.0 * above / t);
        t += clamp(0.8 * above, 0.04, 0.5);
    }
    return smoothstep(0.0, 1.0, clamp(light, 0.0, 1.0));
}

// The ground that a ray hits, its colour, and the linear light towards the eye. For a ray into the sky, the ground is 0.
struct Sight {
    GaborTerrain ground;
    float added; // height that erosion added
    vec3 colour;
    vec3 light;
};

// The ground from above, under a pixel that is `pixel` wide.
Sight seen_from_above(Ground ground, vec2 p, float pixel) {
    Sight sight;
    sight.ground = ground_at(ground, p, pixel);
    sight.added = sight.ground.height - hills_at(ground, p, pixel).height;
    vec3 normal = normalize(vec3(-sight.ground.slope.x, 1.0, -sight.ground.slope.y));
    sight.colour = ground_colour(sight.ground, normal);
    sight.light = sunlit(sun_of(ground), sight.ground, normal, sight.colour, 1.0);
    return sight;
}

// The ground from an eye that is at least a little above it. `clear` is the distance at which air begins to hide the ground.
Sight seen_along(Ground ground, vec3 eye, vec3 ray, float wide, float clear) {
    eye.y = max(eye.y, hills_at(ground, eye.xz, 0.0).height + ground.reach + 0.02);
    Sight sight = Sight(GaborTerrain(0.0, vec2(0.0), 0.0), 0.0, vec3(0.0), sky_along(sun_of(ground), ray));
    float t = distance_to_ground(ground, eye, ray, wide, 6.0 * clear);
    if (t < 0.0) return sight;
    vec3 at = eye + t * ray;
    sight = seen_from_above(ground, at.xz, wide * t);
    float w = max(wide * t, 0.0008);
    float x = ground_at(ground, at.xz + vec2(w, 0.0), wide * t).height;
    float z = ground_at(ground, at.xz + vec2(0.0, w), wide * t).height;
    vec3 normal = normalize(vec3(sight.ground.height - x, w, sight.ground.height - z));
    sight.colour = ground_colour(sight.ground, normal);
    sight.light = sunlit(sun_of(ground), sight.ground, normal, sight.colour, sunlight_at(ground, at + 0.004 * normal));
    vec3 air = sky_along(sun_of(ground), normalize(vec3(ray.x, max(ray.y, 0.02), ray.z)));
    sight.light = mix(air, sight.light, exp(-0.25 * t * t / (clear * clear)));
    return sight;
}

// A camera that looks at the origin from distance 1: its position and its rays. `yaw` and `pitch` are (cosine, sine) of its
// angles. `place` is the offset from the middle of the picture, in units of its focal length, with y growing downwards.
vec3 camera_at(vec2 yaw, vec2 pitch) {
    return vec3(pitch.x * yaw.x, pitch.y, pitch.x * yaw.y);
}
vec3 camera_ray(vec2 yaw, vec2 pitch, vec2 place) {
    vec3 up = vec3(-pitch.y * yaw.x, pitch.x, -pitch.y * yaw.y);
    return normalize(place.x * vec3(yaw.y, 0.0, -yaw.x) - place.y * up - camera_at(yaw, pitch));
}
