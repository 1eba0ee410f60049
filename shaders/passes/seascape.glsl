// Shows a sea under the sky, in perspective. Include it after gabor_ocean.glsl. In space, x and z are the sea's x and y, and y
// points up.

struct Sea {
    GaborOcean ocean;
    uint seed;
    int second;
    float fraction; // of a second
    vec3 sun;       // unit vector
    float high;     // rms height of the waves
};

// `sun` holds x and y of the unit vector to the sun.
Sea sea_of(GaborOcean ocean, uint seed, int second, float fraction, vec2 sun) {
    vec3 toward = vec3(sun.x, sqrt(max(1.0 - dot(sun, sun), 0.0)), sun.y);
    return Sea(ocean, seed, second, fraction, toward, ocean.high.x);
}

vec3 glow_of(vec3 sun) {
    return mix(vec3(1.0, 0.42, 0.13), vec3(1.0, 0.8, 0.55), smoothstep(-0.02, 0.35, sun.y));
}

// The light of a clear sky, which is redder when the sun is low.
vec3 sky_of(vec3 sun, vec3 ray) {
    float up = max(ray.y, 0.0), toward = max(dot(ray, sun), 0.0), day = smoothstep(-0.02, 0.35, sun.y);
    vec3 light = mix(mix(vec3(0.42, 0.4, 0.42), vec3(0.58, 0.68, 0.76), day), mix(vec3(0.09, 0.15, 0.32), vec3(0.11, 0.27, 0.56), day),
                     1.0 - exp(-4.0 * up));
    return light + glow_of(sun) * (0.3 * pow(toward, 8.0) * exp(-2.0 * up) + 0.35 * pow(toward, 90.0));
}

// The sky with the sun's disc. The disc's edge is only some hundred roundings of a scalar product wide, so it comes from
// 1 - cos a = |ray - sun|^2 / 2.
vec3 sky_and_sun(vec3 sun, vec3 ray) {
    vec3 between = ray - sun;
    return sky_of(sun, ray) + 20.0 * (1.0 - smoothstep(3.0e-5, 1.5e-4, 0.5 * dot(between, between))) * glow_of(sun);
}

// The water that was at rest at a place near x, where `shift` is that of the water at x or of water near it.
GaborWater water_near(Sea sea, vec2 x, vec2 shift, vec2 dx, vec2 dy) {
    vec2 p = x - shift, cell = floor(p);
    return gabor_water_at(ivec2(cell), p - cell, sea.second, sea.fraction, dx, dy, sea.ocean, sea.seed);
}

// The distance along the ray to the water, and the water's shift there. `wide` is the side of a pixel at distance 1. Waves that
// are too small to reach the ray are left out, as are those below a pixel.
float distance_to_water(Sea sea, vec3 eye, vec3 ray, float wide, out vec2 shift) {
    float t = max((eye.y - 4.0 * sea.high) / max(-ray.y, 1.0e-6), 0.0), before = t, was = 1.0e6;
    shift = vec2(0.0);
    for (int i = 0; i < 48; ++i) {
        if (wide * t > 4.0 * sea.high) return max(t, eye.y / max(-ray.y, 1.0e-6)); // waves are lower than a pixel
        vec2 x = eye.xz + t * ray.xz;
        float pixel = max(wide * t, 0.1 * min(was, 20.0));
        GaborWater w = water_near(sea, x, shift, vec2(pixel, 0.0), vec2(0.0, pixel));
        float above = eye.y + t * ray.y - w.height - dot(w.slope, shift - w.shift);
        shift = w.shift;
        if (above < 0.02 * pixel) { // the water is between the last two steps
            t = mix(before, t, clamp(was / max(was - above, 1.0e-6), 0.0, 1.0));
            break;
        }
        before = t;
        was = above;
        t += max(above / (0.5 - ray.y), 0.008 * t);
    }
    return t;
}

// Returns the light that water sends to the eye: the sky and the sun, reflected by facets whose slopes spread by w.lost, light
// from below, which shines through crests, and foam. After Bruneton, Neyret and Holzschuch, Real-time realistic ocean lighting
// using seamless transitions from geometry to BRDF, 2010, and Cox and Munk's normal slopes.
vec3 light_of_water(Sea sea, GaborWater w, vec2 slope, vec3 ray, float foam) {
    vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
    float facing = max(dot(normal, -ray), 0.03), spread = sqrt(0.5 * (w.lost.x + w.lost.y));
    float fresnel = 0.02 + 0.98 * pow(1.0 - facing, 5.0 * exp(-2.69 * spread)) / (1.0 + 22.7 * pow(spread, 1.5));
    vec3 mirror = ray - 2.0 * dot(normal, ray) * normal;
    mirror.y = abs(mirror.y) + spread; // rough water reflects higher parts of the sky
    vec3 raised = sea.sun + vec3(0.0, 0.2, 0.0); // made shorter than 1: its brightest glow is in `glitter`
    vec3 sky = sky_of(raised * min(0.9, 0.99 * inversesqrt(dot(raised, raised))), normalize(mirror));
    vec3 middle = normalize(sea.sun - ray); // facets with this normal reflect the sun
    vec2 apart = -middle.xz / max(middle.y, 0.01) - slope, c = w.lost.xy + 2.0e-5;
    float determinant = max(c.x * c.y - w.lost.z * w.lost.z, 1.0e-12);
    float chance = exp(-0.5 * min((c.y * apart.x * apart.x + c.x * apart.y * apart.y - 2.0 * w.lost.z * apart.x * apart.y) / determinant, 80.0))
                 / (6.2831853 * sqrt(determinant));
    float once = 0.02 + 0.98 * pow(1.0 - max(dot(middle, sea.sun), 0.0), 5.0);
    float day = smoothstep(-0.02, 0.35, sea.sun.y);
    vec3 sunlight = mix(vec3(1.0, 0.5, 0.2), vec3(1.0, 0.93, 0.8), day) * smoothstep(-0.02, 0.05, sea.sun.y);
    // The sun is as bright as on foam, through air with an optical depth of 0.29.
    float glitter = 1.4 * exp(-0.29 / max(sea.sun.y, 0.06)) * chance * once / (4.0 * facing * pow(max(middle.y, 0.1), 4.0));
    float through = pow(max(dot(ray.xz, sea.sun.xz), 0.0), 2.0) * clamp(0.3 + 0.35 * w.height / sea.high, 0.0, 1.3);
    vec3 below = (0.25 + 0.75 * day) * (vec3(0.002, 0.016, 0.042) + vec3(0.006, 0.05, 0.055) * (0.12 + through + 0.25 * max(slope.x * ray.x + slope.y * ray.z, 0.0)));
    vec3 light = mix(below, sky, min(fresnel, 1.0)) + glitter * sunlight;
    return mix(light, (0.3 + 0.5 * day) * (vec3(0.55, 0.6, 0.65) + 0.5 * max(dot(normal, sea.sun), 0.0) * sunlight), foam);
}

// What a ray meets. For a ray into the sky, the water is 0.
struct SeaHit {
    GaborWater water;
    float foam;  // from 0 to 1
    vec3 colour; // of water and foam
    vec3 light;  // linear, towards the eye
};

// The sea or the sky along a ray. Raises an eye that is too low.
SeaHit seen_at_sea(Sea sea, vec3 eye, vec3 ray, float wide) {
    eye.y = max(eye.y, 3.0 * sea.high);
    SeaHit hit = SeaHit(GaborWater(0.0, vec2(0.0), vec2(0.0), 0.0, vec3(0.0), vec3(0.0)), 0.0, vec3(0.0), sky_and_sun(sea.sun, ray));
    if (ray.y > -1.0e-4) return hit;
    vec2 shift;
    float t = distance_to_water(sea, eye, ray, wide, shift);
    vec2 x = eye.xz + t * ray.xz, forward = normalize(ray.xz);
    vec2 across = wide * t * vec2(forward.y, -forward.x), along = wide * t / max(-ray.y, 0.04) * forward;
    hit.water = water_near(sea, x, shift, across, along);
    hit.foam = gabor_foam(x - hit.water.shift, across, along, hit.water, sea.ocean, sea.seed);
    hit.colour = mix(vec3(0.003, 0.022, 0.049), vec3(0.7), hit.foam);
    vec3 air = sky_of(sea.sun, vec3(ray.x, 0.01, ray.z)); // at the horizon; straight down, from no side
    hit.light = mix(air, light_of_water(sea, hit.water, hit.water.slope / clamp(hit.water.jacobian, 0.4, 2.0), ray, hit.foam), exp(-1.2e-4 * t));
    return hit;
}

// What a pixel shows. The camera is above the origin; `yaw` and `pitch` are (cosine, sine) of its angles, `place` is the offset from
// the middle of the picture in pixels, with y growing downwards, and `wide` the side of a pixel at distance 1.
SeaHit seen_at_sea_in_pixel(Sea sea, float altitude, vec2 yaw, vec2 pitch, vec2 place, float wide) {
    vec3 toward_eye = vec3(pitch.x * yaw.x, pitch.y, pitch.x * yaw.y);
    vec3 up = vec3(-pitch.y * yaw.x, pitch.x, -pitch.y * yaw.y);
    vec3 ray = normalize(wide * (place.x * vec3(yaw.y, 0.0, -yaw.x) - place.y * up) - toward_eye);
    return seen_at_sea(sea, vec3(0.0, altitude, 0.0), ray, wide);
}
