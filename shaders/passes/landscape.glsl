// Shows eroded ground in colour, lit by a sun and the sky, from above or in perspective. Include it after gabor_erosion.glsl.
// In space, x and z are the ground's x and y, and y points up.

struct Ground {
    ivec2 cell; // positions are relative to this cell
    vec2 period;
    uint seed;
    GaborErosion erosion;
    float reach; // the most that erosion adds to the hills
    vec2 sun;    // x and y of the unit vector towards the sun
    int cover;   // alpine, meadow, desert or badlands: 0 to 3
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

// The share of pale layers in rock whose layers are level, for a pixel that spans the height `span`.
float pale_layers(float height, float span) {
    vec2 turns = vec2(5.3, 13.7) * height, kept = exp(-4.9348022 * span * span * vec2(5.3, 13.7) * vec2(5.3, 13.7));
    vec2 wave = sin(6.2831853 * (turns + 0.15 * sin(6.2831853 * 0.37 * turns.yx)));
    return 0.5 + dot(vec2(0.6, 0.4) * kept, smoothstep(-0.5, 0.5, wave) - 0.5);
}

vec3 ground_colour(Ground ground, GaborTerrain here, vec3 normal, float pixel) {
    float steep = length(normal.xz) / normal.y;
    if (ground.cover == 0) {
        vec4 share = gabor_ground_cover(here);
        return share.x * vec3(0.1, 0.155, 0.05) + share.y * vec3(0.3, 0.245, 0.145) + share.z * vec3(0.26, 0.23, 0.205)
             + share.w * vec3(0.68, 0.7, 0.73);
    }
    if (ground.cover == 1) { // grass, dry where it is high or steep
        vec3 colour = mix(vec3(0.085, 0.15, 0.035), vec3(0.21, 0.2, 0.075), smoothstep(-0.4, 0.6, here.height + 0.2 * here.ridge));
        return mix(colour, vec3(0.27, 0.24, 0.19), smoothstep(0.9, 1.7, steep));
    }
    float pale = pale_layers(here.height, pixel * steep);
    if (ground.cover == 2) // sand below layered cliffs
        return mix(mix(vec3(0.4, 0.25, 0.13), vec3(0.46, 0.3, 0.18), smoothstep(-0.3, 0.35, here.height)),
                   mix(vec3(0.34, 0.125, 0.06), vec3(0.56, 0.33, 0.19), pale), smoothstep(0.25, 0.7, steep));
    vec3 clay = mix(vec3(0.3, 0.17, 0.13), vec3(0.5, 0.43, 0.34), pale); // layered clay above pale wash
    return mix(vec3(0.47, 0.42, 0.34), clay, smoothstep(-0.15, 0.3, steep - 0.5 - 0.3 * min(here.ridge, 0.0)));
}

// The colour of sunlight, which is warm where the sun is low: the air takes more blue than red.
vec3 sun_colour(vec3 sun) {
    return 1.66 * exp(-vec3(0.16, 0.2, 0.28) / (sun.y + 0.06));
}

vec3 sunlit(vec3 sun, GaborTerrain here, vec3 normal, vec3 colour, float sunlight) {
    float open = 1.0 + 0.25 * clamp(here.ridge, -1.0, 1.0); // creases see less of the sky
    vec3 light = sun_colour(sun) * max(dot(normal, sun), 0.0) * sunlight
               + mix(vec3(0.2, 0.17, 0.13), vec3(0.24, 0.31, 0.42), 0.5 + 0.5 * normal.y); // from the ground and the sky
    return open * light * colour;
}

vec3 sky_along(vec3 sun, vec3 ray) {
    float toward = max(dot(ray, sun), 0.0);
    float glow = 0.3 * pow(toward, 8.0) + 2.0 * pow(toward, 2000.0);
    vec3 low = mix(vec3(0.66, 0.5, 0.36), vec3(0.5, 0.6, 0.7), smoothstep(0.0, 0.45, sun.y + 0.2 * (1.0 - toward)));
    return mix(vec3(0.1, 0.23, 0.5), low, exp(-5.0 * max(ray.y, 0.0))) + vec3(1.0, 0.75, 0.5) * glow;
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
    stride = 0.1 * above;
    return above;
}

// Where a ray meets the ground, or -1; where it passed closest to an edge before, and how much of the pixel that covers.
struct RayEnd {
    float ground;
    float edge;
    float covered;
};

// Far above the ground, details too small to reach the ray are left out. Where a parabola through the last three heights above
// the ground comes close to it, the next step returns to its vertex. `wide` is the width of a pixel at distance 1.
RayEnd end_of_ray(Ground ground, vec3 eye, vec3 ray, float wide, float far) {
    vec3 steps = vec3(0.0), heights = vec3(1.0e9); // the last three, the latest first
    float t = 0.0, above = 0.0, resumed = -1.0, stride;
    RayEnd end = RayEnd(-1.0, 0.0, 0.0);
    for (int i = 0; i < 500 && t < far; ++i) {
        vec3 at = eye + t * ray;
        if (at.y > 1.0 + ground.reach && ray.y > 0.0) break;
        above = height_above(ground, at, max(wide * t, 0.3 * above), 0.5 * ground.reach, stride);
        if (above < 0.0) { // the ground is between the last two steps
            float before = resumed > 0.0 ? steps.z : steps.x;
            for (int j = 0; j < 6; ++j) {
                float middle = 0.5 * (before + t);
                vec3 there = eye + middle * ray;
                if (there.y > ground_at(ground, there.xz, wide * middle).height) before = middle; else t = middle;
            }
            end.ground = t;
            if (t - end.edge < 8.0 * wide * t) end.covered = 0.0; // the same slope
            break;
        }
        float covered = 1.0 - above / (wide * t);
        if (covered > end.covered) end = RayEnd(-1.0, t, covered);
        if (resumed > 0.0) {
            t = resumed;
            resumed = -1.0;
            continue;
        }
        steps = vec3(t, steps.xy);
        heights = vec3(above, heights.xy);
        t += max(stride, wide * t);
        if (heights.y < min(heights.x, heights.z)) {
            vec2 far = steps.xz - steps.y, rise = (heights.xz - heights.y) / far; // before and after the lowest of the three
            float bend = (rise.x - rise.y) / (far.x - far.y), vertex = -0.5 * (rise.x - bend * far.x) / bend;
            if (heights.y - bend * vertex * vertex < 2.0 * wide * steps.y) {
                resumed = t;
                t = steps.y + vertex;
            }
        }
    }
    return end;
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
    hit.colour = ground_colour(ground, hit.ground, normal, pixel);
    hit.light = sunlit(sun_of(ground), hit.ground, normal, hit.colour, 1.0);
    return hit;
}

// The ground at the distance t along a ray. Air begins to hide it at the distance `clear`.
RayHit ground_along(Ground ground, vec3 eye, vec3 ray, float t, float wide, float clear) {
    vec3 sun = sun_of(ground), at = eye + t * ray;
    RayHit hit = seen_from_above(ground, at.xz, wide * t);
    vec3 normal = normal_of(hit.ground);
    float sunlight = dot(normal, sun) > 0.0 ? sunlight_at(ground, at + 0.004 * normal, wide * t) : 0.0;
    vec3 air = sky_along(sun, normalize(vec3(ray.x, max(ray.y, 0.02), ray.z)));
    hit.light = mix(air, sunlit(sun, hit.ground, normal, hit.colour, sunlight), exp(-0.1 * t * t / (clear * clear)));
    return hit;
}

// The ground or sky along a ray. Raises an eye that is too low.
RayHit seen_along(Ground ground, vec3 eye, vec3 ray, float wide, float clear) {
    eye.y = max(eye.y, hills_at(ground, eye.xz, 0.0).height + ground.reach + 0.02);
    GaborTerrain none = GaborTerrain(0.0, vec2(0.0), 0.0, vec3(0.0), vec2(0.0));
    RayHit hit = RayHit(none, 0.0, vec3(0.0), sky_along(sun_of(ground), ray));
    RayEnd end = end_of_ray(ground, eye, ray, wide, 6.0 * clear);
    for (int i = 0; i < 2; ++i) { // what lies behind an edge, then the edge
        float t = i == 0 ? end.ground : end.edge, share = i == 0 ? 1.0 : end.covered;
        if (t < 0.0 || share <= 0.0) continue;
        RayHit near = ground_along(ground, eye, ray, t, wide, clear);
        near.light = mix(hit.light, near.light, share);
        hit = near;
    }
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
