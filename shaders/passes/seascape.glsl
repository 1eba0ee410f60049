// Shows a sea under the sky, in perspective. Include it after gabor_ocean.glsl, gabor_fractal.glsl and srgb.glsl. In
// space, x and z are the sea's x and y, and y points up.

struct Sea {
    GaborOcean ocean;
    uint seed;
    int second;
    float fraction; // of a second
    vec3 sun;       // unit vector
    float high;     // rms height of the waves
    float weather;  // 0 for a fair sky, 1 for an overcast one
};

// `sun` holds x and y of the unit vector to the sun.
Sea sea_of(GaborOcean ocean, uint seed, int second, float fraction, vec2 sun) {
    vec3 toward = vec3(sun.x, sqrt(max(1.0 - dot(sun, sun), 0.0)), sun.y);
    return Sea(ocean, seed, second, fraction, toward, ocean.high.x, clamp(0.1 * ocean.wind - 0.3, 0.0, 1.0));
}

// ---- The sky -------------------------------------------------------------------------------------------------------

// The irradiance of the sun on a surface that faces it, over pi. None passes an overcast sky.
vec3 sunlight_at_sea(Sea sea) {
    return vec3(3.0, 3.2, 3.7) * (1.0 - smoothstep(0.75, 1.0, sea.weather)) * exp(-vec3(0.12, 0.2, 0.37) / (sea.sun.y + 0.06));
}

// A clear sky: air and haze scatter sunlight, which has lost blue on its way, and air scatters it again. `wide` blurs
// the glow around the sun.
vec3 clear_sky(vec3 sun, vec3 ray, float wide) {
    float up = max(ray.y, 0.0), toward = dot(ray, sun), glow = 0.55 + 0.016 / (1.004 + wide * wide - toward);
    vec3 air = vec3(0.045, 0.105, 0.25), haze = vec3(0.06), all = air + haze;
    vec3 lit = exp(-vec3(0.11, 0.22, 0.42) * (0.22 + 0.75 * exp(-7.0 * up)) / (sun.y + 0.08));
    return lit * (0.5 * air * (1.0 + toward * toward) + 0.8 * haze * glow) / all * (1.0 - exp(-all / (up + 0.1)))
         + vec3(0.02, 0.045, 0.1) * sqrt(sun.y + 0.12) * (1.0 - 0.5 * up);
}

// The noise of clouds along a ray, in a pixel that is `wide`.
GaborFractalNoise clouds_at_sea(Sea sea, vec3 ray, float wide) {
    float far = 1.0 / (max(ray.y, 0.0) + 0.1);
    vec2 forward = normalize(ray.xz + vec2(1.0e-6, 0.0)), across = vec2(forward.y, -forward.x);
    return gabor_fractal_noise_filtered(gabor_place_at(far * ray.xz), min(wide * far, 8.0) * across,
                                        min(wide * far * far, 8.0) * forward, gabor_fractal(6.0, 0.55), sea.seed + 77u);
}

// The sky with clouds and without the sun; its mean for a noise of which all is removed.
vec3 sky_at_sea(Sea sea, vec3 ray, float wide, GaborFractalNoise cloud) {
    float up = max(ray.y, 0.0), toward = max(dot(ray, sea.sun), 0.0), low = exp(-8.0 * up);
    float rare = 1.5 - 4.0 * sea.weather * sea.weather * sea.weather, soft = 0.35 + cloud.removed;
    float cover = smoothstep(rare - soft, rare + 1.0 + soft, cloud.noise);
    float thick = smoothstep(rare, rare + 4.0, cloud.noise * (1.0 - sea.weather * low));
    vec3 clear = clear_sky(sea.sun, ray, wide);
    vec3 grey = vec3(0.74, 0.84, 0.94) * (0.3 + 0.7 * smoothstep(0.0, 0.5, sea.sun.y)) * (0.4 + 0.6 * up);
    vec3 cloudy = grey * (1.2 - 0.7 * thick)
                + sunlight_at_sea(sea) * (1.0 - thick) * (0.15 + 0.5 * pow(toward, 8.0));
    return mix(clear, mix(cloudy, clear, 0.7 * (1.0 - sea.weather) * low), cover);
}

vec3 mean_sky_at_sea(Sea sea, vec3 ray) {
    return sky_at_sea(sea, ray, 2.0, GaborFractalNoise(0.0, vec2(0.0), 1.0, vec3(0.0)));
}

// The sun's disc, half a degree wide, of which `open` is seen, and the light that it scatters in a camera. The angle
// to it comes from |ray - sun|, because the disc is only some hundred roundings of a scalar product wide.
vec3 sun_at_sea(Sea sea, vec3 ray, float wide, float open) {
    float apart = length(ray - sea.sun), disc = 1.0 - smoothstep(0.0047 - 0.5 * wide, 0.0047 + 0.5 * wide, apart);
    return sunlight_at_sea(sea) * (40.0 * open * disc + 0.0006 / (apart * apart + 0.0006));
}

// ---- The water -----------------------------------------------------------------------------------------------------

// The water that was at rest at a place near x, where `shift` is that of the water at x or of water near it.
GaborWater water_near(Sea sea, vec2 x, vec2 shift, vec2 dx, vec2 dy) {
    vec2 p = x - shift, cell = floor(p);
    return gabor_water_at(ivec2(cell), p - cell, sea.second, sea.fraction, dx, dy, sea.ocean, sea.seed);
}

// The distance along the ray to the water, and the water's shift there. `wide` is the side of a pixel at distance 1.
// Waves that are too small to reach the ray are left out, as are those below a pixel.
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

// Moves places, so that waves of a few pixels do not have straight crests for many of them.
vec2 bend_at(Sea sea, vec2 p, float pixel) {
    float level = log2(max(40.0 * pixel, 1.0e-6)), low = floor(level);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 2; ++i) {
        float size = exp2(low + float(i));
        GaborFractalNoise n = gabor_fractal_noise(gabor_place_at(p / size), gabor_fractal(3.0, 0.4),
                                                  sea.seed + uint(int(low) + i + 200));
        sum += 0.04 * size * (i == 0 ? 1.0 + low - level : level - low) * vec2(-n.gradient.y, n.gradient.x);
    }
    return sum;
}

// The mean of exp(-n^2 / (2 width^2)) over what a filter removed: the share of lines where the noise is 0.
float near_zero(GaborFractalNoise n, float width) {
    float variance = width * width + n.removed;
    return width * inversesqrt(variance) * exp(-0.5 * n.noise * n.noise / variance);
}

// What noises add to the water in a pixel.
struct SeaDetail {
    vec2 slope;            // along the wind and across it, of ripples below a decimetre, as far as the pixel shows them
    vec3 lost;             // of these slopes, what the pixel does not show
    float gust;            // normal
    float streak;          // foam in lines along the wind
    GaborFractalNoise net; // of bubbles
    float facets;          // normal, and independent in every pixel
};

// Components along the wind and across it.
vec2 by_wind(Sea sea, vec2 p) {
    vec2 along = gabor_impl_wave(0.15915494 * sea.ocean.direction); // 1/(2 pi)
    return vec2(dot(along, p), along.x * p.y - along.y * p.x);
}

SeaDetail detail_at(Sea sea, vec2 p, vec2 dx, vec2 dy, float pixel) {
    SeaDetail detail;
    float level = log2(max(1.5 * pixel, 0.03)), low = floor(level), share = level - low;
    detail.facets = 0.0;
    for (int i = 0; i < 6; ++i) { // a single call, because compilers copy what it calls to each place
        vec2 size = i == 0 ? vec2(0.08) : i == 1 ? vec2(500.0, 200.0) : i == 2 ? vec2(80.0, 7.0)
                  : i == 3 ? vec2(0.5 + 0.2 * sea.ocean.wind, 1.0) : vec2(exp2(low + float(i - 4)));
        GaborFractal fractal = gabor_fractal(i == 3 ? 6.0 : i > 3 ? 1.0 : 3.0, i == 0 ? 0.5 : 0.6);
        vec2 filters = i > 3 ? vec2(0.0) : 1.0 / size;
        GaborPlace place = gabor_place_at(by_wind(sea, p) / size);
        place.evolution = i == 0 || i > 3 ? 2.0 * sea.fraction : 0.0;
        uint seed = sea.seed + uint(i > 3 ? int(low) + i + 300 : i + 74);
        GaborFractalNoise n = gabor_fractal_noise_filtered(place, filters * by_wind(sea, dx),
                                                           filters * by_wind(sea, dy), fractal, seed);
        if (i == 0) {
            detail.slope = n.gradient;
            detail.lost = n.lost;
        }
        if (i == 1) detail.gust = n.noise;
        if (i == 2) detail.streak = near_zero(n, 0.4);
        if (i == 3) detail.net = n;
        if (i > 3) detail.facets += (i == 4 ? 1.0 - share : share) * n.noise;
    }
    detail.facets *= inversesqrt(1.0 - 2.0 * share * (1.0 - share));
    return detail;
}

// Adds ripples below a decimetre, which the bands lack, as far as a pixel shows them, and gusts, which roughen the sea.
void ruffle(Sea sea, SeaDetail detail, inout GaborWater w) {
    vec2 along = by_wind(sea, vec2(1.0, 0.0));
    vec2 tail = sea.ocean.tail / 7.52, slope = sqrt(tail) * detail.slope; // 7.52: variance of the ripples' gradient
    w.slope += vec2(along.x * slope.x + along.y * slope.y, along.x * slope.y - along.y * slope.x);
    vec3 kept = gabor_impl_slopes_along(tail * (detail.lost.xy - 7.52), vec2(along.x, -along.y));
    vec3 lost = exp(0.35 * detail.gust) * (w.lost + vec3(kept.x, kept.z - kept.x, kept.y));
    w.lost = vec3(max(lost.xy, 0.0), lost.z);
}

// White water, which is a net of bubbles but on crests, and foam that stays, in streaks along the wind.
float foam_seen(Sea sea, SeaDetail detail, float height, float fresh) {
    float solid = smoothstep(0.8, 2.2, height / sea.high);
    float old = smoothstep(9.0, 24.0, sea.ocean.wind) * detail.streak * near_zero(detail.net, 0.25);
    float white = fresh * (0.4 + 1.2 * detail.streak) * mix(near_zero(detail.net, 0.6), 1.0, solid);
    return max(min(white, 1.0), 0.8 * old);
}

// The ratio of facets that others hide to those that are visible, from a direction whose tangent is `steep` deviations
// of the slopes. After Walter and others, Microfacet models for refraction through rough surfaces, 2007.
float hidden_facets(float steep) {
    float a = 0.70710678 * steep; // (1/2)^(1/2)
    return a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) : 0.0;
}

// The light of the sun in a pixel of water, relative to sunlight, reflected by facets with Cox and Munk's normal
// slopes, which spread by w.lost. In a small area, a few facets reflect the sun by chance, so that it sparkles.
float glitter_at_sea(Sea sea, GaborWater w, vec3 ray, float facing, float spread, float area, float facets) {
    vec3 middle = normalize(sea.sun - ray); // facets with this normal reflect the sun
    vec2 d = -middle.xz / max(middle.y, 0.01) - w.slope, c = w.lost.xy + 2.0e-5;
    float determinant = max(c.x * c.y - w.lost.z * w.lost.z, 1.0e-12);
    float steep = (c.y * d.x * d.x + c.x * d.y * d.y - 2.0 * w.lost.z * d.x * d.y) / determinant;
    float chance = exp(-0.5 * min(steep, 80.0)) / (6.2831853 * sqrt(determinant));
    float once = 0.02 + 0.98 * pow(1.0 - max(dot(middle, sea.sun), 0.0), 5.0);
    float hidden = hidden_facets(facing / (spread + 0.001)) + hidden_facets(max(sea.sun.y, 0.01) / (spread + 0.001));
    float variance = min(log(1.0 + 13.0 / max(area * chance, 1.0e-3)), 2.5);
    return 1.2 * chance * once * exp(sqrt(variance) * facets - 0.5 * variance)
         / (4.0 * facing * pow(max(middle.y, 0.1), 4.0) * (1.0 + hidden));
}

// What a ray meets. For a ray into the sky, the water is 0.
struct SeaHit {
    GaborWater water;
    float foam;  // from 0 to 1
    vec3 colour; // of water and foam
    vec3 light;  // linear
};

// The sea or the sky along a ray. Raises an eye that is too low. Water reflects the sky, blurred by the spread of its
// slopes, and light from below shines through it, most through crests before the sun. After Bruneton, Neyret and
// Holzschuch, Real-time realistic ocean lighting using seamless transitions from geometry to BRDF, 2010.
SeaHit seen_at_sea(Sea sea, vec3 eye, vec3 ray, float wide) {
    eye.y = max(eye.y, 3.0 * sea.high);
    SeaHit hit = SeaHit(GaborWater(0.0, vec2(0.0), vec2(0.0), 0.0, vec3(0.0), vec3(0.0)), 0.0, vec3(0.0), vec3(0.0));
    bool wet = ray.y < -1.0e-4;
    vec3 mirror = ray, sunlight = sunlight_at_sea(sea), below = vec3(0.0), white = vec3(0.0);
    float blur = wide, fresnel = 1.0, glitter = 0.0, foam = 0.0, clean = 1.0;
    if (wet) {
        vec2 shift;
        float t = distance_to_water(sea, eye, ray, wide, shift);
        vec2 x = eye.xz + t * ray.xz, forward = normalize(ray.xz);
        vec2 across = wide * t * vec2(forward.y, -forward.x), along = wide * t / max(-ray.y, 0.04) * forward;
        hit.water = water_near(sea, x, shift + bend_at(sea, x, wide * t), across, along);
        GaborWater w = hit.water;
        vec2 p = x - w.shift;
        hit.foam = gabor_foam(p, across, along, w, sea.ocean, sea.seed);
        hit.colour = mix(vec3(0.003, 0.022, 0.049), vec3(0.7), hit.foam);
        SeaDetail detail = detail_at(sea, p, across, wide * t / max(-ray.y, 0.001) * forward, wide * t);
        w.slope /= clamp(w.jacobian, 0.4, 2.0);
        ruffle(sea, detail, w);
        foam = foam_seen(sea, detail, w.height, hit.foam);
        clean = exp(-5.0e-5 * t);
        vec3 normal = normalize(vec3(-w.slope.x, 1.0, -w.slope.y));
        float facing = max(dot(normal, -ray), 0.03), spread = sqrt(0.5 * (w.lost.x + w.lost.y));
        fresnel = 0.02 + 0.98 * pow(1.0 - facing, 5.0 * exp(-2.69 * spread)) / (1.0 + 22.7 * pow(spread, 1.5));
        mirror -= 2.0 * dot(normal, ray) * normal;
        mirror = normalize(vec3(mirror.x, abs(mirror.y) + spread, mirror.z)); // rough water mirrors higher parts
        blur = 0.1 + 2.0 * spread;
        glitter = glitter_at_sea(sea, w, ray, facing, spread, length(across) * length(along), detail.facets);
        vec3 from_sky = mean_sky_at_sea(sea, normalize(vec3(0.3 * normal.x, 1.0, 0.3 * normal.z)));
        float through = pow(max(dot(ray.xz, sea.sun.xz), 0.0), 2.0) * clamp(0.3 + 0.35 * w.height / sea.high, 0.0, 1.3)
                      + 0.25 * max(dot(w.slope, ray.xz), 0.0);
        below = (sunlight * sea.sun.y + from_sky) * (vec3(0.0015, 0.012, 0.028) + through * vec3(0.003, 0.025, 0.0275));
        white = 0.7 * (from_sky + max(dot(normal, sea.sun), 0.0) * sunlight);
    }
    vec3 seen = mix(below, sky_at_sea(sea, mirror, blur, clouds_at_sea(sea, mirror, blur)), min(fresnel, 1.0));
    vec3 air = mean_sky_at_sea(sea, vec3(ray.x, 0.01, ray.z)); // at the horizon; straight down, from no side
    hit.light = mix(air, mix(seen + glitter * sunlight, white, foam), clean);
    hit.light += sun_at_sea(sea, ray, wide, wet ? 0.0 : 1.0);
    return hit;
}

// What a pixel shows, with light for a screen, exposed longer under a low sun. The camera is above the origin; `yaw`
// and `pitch` are (cosine, sine) of its angles, `place` is the offset from the middle of the picture in pixels, with y
// growing downwards, and `wide` the side of a pixel at distance 1.
SeaHit seen_at_sea_in_pixel(Sea sea, float altitude, vec2 yaw, vec2 pitch, vec2 place, float wide) {
    vec3 toward_eye = vec3(pitch.x * yaw.x, pitch.y, pitch.x * yaw.y);
    vec3 up = vec3(-pitch.y * yaw.x, pitch.x, -pitch.y * yaw.y);
    vec3 ray = normalize(wide * (place.x * vec3(yaw.y, 0.0, -yaw.x) - place.y * up) - toward_eye);
    SeaHit hit = seen_at_sea(sea, vec3(0.0, altitude, 0.0), ray, wide);
    hit.light = exposed((1.8 - 0.55 * min(sea.sun.y / 0.35, 1.0)) * hit.light);
    return hit;
}
