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

// The hills and the ground at p, filtered for a pixel that is `pixel` wide on the ground.
GaborTerrain hills_at(Ground ground, vec2 p, float pixel) {
    return gabor_terrain_at(GaborTerrainPlace(ground.cell, p, ground.period), vec2(pixel, 0.0), vec2(0.0, pixel), ground.seed);
}
GaborTerrain ground_on(Ground ground, vec2 p, float pixel, GaborTerrain hills) {
    return gabor_eroded_at(GaborTerrainPlace(ground.cell, p, ground.period), vec2(pixel, 0.0), vec2(0.0, pixel), hills,
                           ground.erosion, ground.seed);
}
GaborTerrain ground_at(Ground ground, vec2 p, float pixel) {
    return ground_on(ground, p, pixel, hills_at(ground, p, pixel));
}

vec3 normal_of(GaborTerrain here) {
    return normalize(vec3(-here.slope.x, 1.0, -here.slope.y));
}

// How much scree covers grass, how much rock covers both where it is steep, and how much snow covers all where it is high.
vec3 ground_layers(float height, float ridge, float steep) {
    float scree = smoothstep(-0.3, 0.35, height + 0.1 * ridge);
    float rock = smoothstep(0.55, 1.0, steep);
    float snow = smoothstep(0.42, 0.62, height + 0.08 * ridge) * (1.0 - smoothstep(0.9, 1.5, steep));
    return vec3(scree, rock, snow);
}

vec3 ground_colour(GaborTerrain here, vec3 normal) {
    vec3 layers = ground_layers(here.height, here.ridge, length(normal.xz) / normal.y);
    vec3 colour = mix(vec3(0.1, 0.155, 0.05), vec3(0.3, 0.245, 0.145), layers.x);
    return mix(mix(colour, vec3(0.26, 0.23, 0.205), layers.y), vec3(0.68, 0.7, 0.73), layers.z);
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

// The height of a point above the ground. If the point is more than `margin` above anything that erosion could add to the
// hills, returns its height above that instead, which costs less. No ray from the point meets the ground within the distance
// `stride`, unless the ground is extremely steep.
float height_above(Ground ground, vec3 at, float pixel, float margin, out float stride) {
    GaborTerrain hills = hills_at(ground, at.xz, pixel);
    float above = at.y - hills.height - ground.reach;
    stride = 0.45 * above;
    if (above > margin) return above;
    above = at.y - ground_on(ground, at.xz, pixel, hills).height;
    stride = 0.16 * above;
    return above;
}

// The distance along the ray to the ground, or -1. Far above the ground, details too small to reach the ray are left out.
// `wide` is the width of a pixel at distance 1.
float distance_to_ground(Ground ground, vec3 eye, vec3 ray, float wide, float far) {
    float t = 0.0, before = 0.0, above = 0.0, stride;
    for (int i = 0; i < 400 && t < far; ++i) {
        vec3 at = eye + t * ray;
        if (at.y > 1.0 + ground.reach && ray.y > 0.0) break;
        above = height_above(ground, at, max(wide * t, 0.3 * above), 0.5 * ground.reach, stride);
        if (above < 0.0) { // the ground is between the last two steps
            for (int j = 0; j < 6; ++j) {
                float middle = 0.5 * (before + t);
                vec3 there = eye + middle * ray;
                if (there.y > ground_at(ground, there.xz, wide * middle).height) before = middle; else t = middle;
            }
            return t;
        }
        before = t;
        t += max(stride, wide * t);
    }
    return -1.0;
}

// How much of the sun is visible from a point on the ground, for a pixel that is `pixel` wide there. The ground that casts the
// shadow has only one or two octaves of erosion.
float sunlight_at(Ground ground, vec3 at, float pixel) {
    vec3 sun = sun_of(ground);
    float light = 1.0, t = 0.04, stride;
    for (int i = 0; i < 250 && light > 0.0 && at.y + t * sun.y < 1.0 + ground.reach; ++i) {
        float above = height_above(ground, at + t * sun, 0.15, t / 12.0, stride);
        light = min(light, 0.5 + 12.0 * above / t);
        t += max(stride, max(2.0 * pixel, 0.005)); // longer steps would jump over ridges and make shadows ragged
    }
    return smoothstep(0.0, 1.0, clamp(light, 0.0, 1.0));
}

// The ground that a ray hits, its colour, and the linear light towards the eye. For a ray into the sky, the ground is 0.
struct RayHit {
    GaborTerrain ground;
    float added; // height that erosion added
    vec3 colour;
    vec3 light;
};

// The ground from above, under a pixel that is `pixel` wide.
RayHit seen_from_above(Ground ground, vec2 p, float pixel) {
    RayHit hit;
    GaborTerrain hills = hills_at(ground, p, pixel);
    hit.ground = ground_on(ground, p, pixel, hills);
    hit.added = hit.ground.height - hills.height;
    vec3 normal = normal_of(hit.ground);
    hit.colour = ground_colour(hit.ground, normal);
    hit.light = sunlit(sun_of(ground), hit.ground, normal, hit.colour, 1.0);
    return hit;
}

// The ground or sky along a ray. Raises an eye that is too low. `clear` is the distance at which air begins to hide the ground.
RayHit seen_along(Ground ground, vec3 eye, vec3 ray, float wide, float clear) {
    vec3 sun = sun_of(ground);
    eye.y = max(eye.y, hills_at(ground, eye.xz, 0.0).height + ground.reach + 0.02);
    RayHit hit = RayHit(GaborTerrain(0.0, vec2(0.0), 0.0, vec3(0.0), vec2(0.0)), 0.0, vec3(0.0), sky_along(sun, ray));
    float t = distance_to_ground(ground, eye, ray, wide, 6.0 * clear);
    if (t < 0.0) return hit;
    vec3 at = eye + t * ray;
    hit = seen_from_above(ground, at.xz, wide * t);
    vec3 normal = normal_of(hit.ground);
    float sunlight = dot(normal, sun) > 0.0 ? sunlight_at(ground, at + 0.004 * normal, wide * t) : 0.0;
    hit.light = sunlit(sun, hit.ground, normal, hit.colour, sunlight);
    vec3 air = sky_along(sun, normalize(vec3(ray.x, max(ray.y, 0.02), ray.z)));
    hit.light = mix(air, hit.light, exp(-0.25 * t * t / (clear * clear)));
    return hit;
}

// The ground that a camera sees in a pixel. It looks at the point `target` of the plane y = 0 from the distance `away`; `yaw` and `pitch`
// are (cosine, sine) of its angles. `place` is the offset from the middle of the picture in pixels, with y growing downwards, and
// `wide` the side of a pixel at distance 1.
RayHit seen_by_camera(Ground ground, vec2 target, float away, vec2 yaw, vec2 pitch, vec2 place, float wide) {
    vec3 toward_eye = vec3(pitch.x * yaw.x, pitch.y, pitch.x * yaw.y);
    vec3 right = vec3(yaw.y, 0.0, -yaw.x);
    vec3 up = vec3(-pitch.y * yaw.x, pitch.x, -pitch.y * yaw.y);
    vec2 at = wide * place;
    vec3 ray = normalize(at.x * right - at.y * up - toward_eye);
    return seen_along(ground, vec3(target.x, 0.0, target.y) + away * toward_eye, ray, wide, away);
}

// The ground that a pixel shows, from above or, if `away` is not 0, by a camera. The parameters are those of
// passes/terrain_interface.h.
RayHit seen_in_pixel(Ground ground, vec2 corner, float away, vec2 yaw, vec2 pitch, vec2 center, float pixel, vec2 pixel_at) {
    if (away == 0.0) return seen_from_above(ground, corner + pixel * pixel_at, pixel);
    return seen_by_camera(ground, corner, away, yaw, pitch, pixel_at - center, pixel);
}
