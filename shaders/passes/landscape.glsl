// Shows ground in colour, lit by a sun and the sky, with lakes, from above or in perspective. Include it after srgb.glsl, and ranges.glsl or
// other definitions of its hills_at, ground_on and ground_at.

vec3 sun_of(Ground ground) {
    return vec3(ground.sun.x, sqrt(max(1.0 - dot(ground.sun, ground.sun), 0.0)), ground.sun.y);
}

bool has_lakes(Ground ground) {
    return ground.water > -2.0; // below which there is no ground
}

vec3 normal_of(GaborTerrain here) {
    return normalize(vec3(-here.slope.x, 1.0, -here.slope.y));
}

// What the eye sees of the ground at p, whose pixel is dx and dy: the ground, how steep it is, and its noises, which are normal.
struct Site {
    GaborTerrain here;
    float steep;
    vec2 place;
    vec2 dx;
    vec2 dy;
    float span;              // of height in the pixel
    GaborFractalNoise fine;  // from a quarter of a unit down to the pixel
    float broad;             // of a few units
};

GaborFractal octaves_of(float octaves, float gain, int shape) {
    GaborFractal fractal = gabor_fractal(octaves, gain);
    fractal.shape = shape;
    return fractal;
}

Site site_at(Ground ground, GaborTerrain here, vec2 p, vec2 dx, vec2 dy) {
    vec2 rise = vec2(dot(here.slope, dx), dot(here.slope, dy)), up = vec2(0.35, -0.5); // noise that moves with the height has no streaks on cliffs
    GaborFractalNoise fine = noise_on(ground, p + up * here.height, dx + up * rise.x, dy + up * rise.y, 6.0, gabor_fractal(9.0, 0.6), 2);
    fine.gradient += dot(fine.gradient, up) * here.slope;
    return Site(here, length(here.slope), p, dx, dy, length(rise), fine, noise_on(ground, p, dx, dy, 0.7, gabor_fractal(3.0, 0.6), 3).noise);
}

// 1 below the edges, 0 above them. GLSL leaves smoothstep undefined where its edges fall.
float falling(float low, float high, float x) {
    return 1.0 - smoothstep(low, high, x);
}

// Layers that a height crosses, `turns` of them in a unit: -1 to 1, 0 where a pixel crosses many.
float layers(float height, float turns, float span) {
    float kept = exp(-4.9348022 * span * span * turns * turns); // pi^2 / 2
    return kept * smoothstep(-0.6, 0.6, gabor_impl_wave(turns * height).y) * 2.0 - kept;
}

// Trees as seen from afar: crowns with dark gaps. Returns the colour and the share of the ground that they hide.
vec4 trees(Ground ground, Site site, float dense) {
    GaborFractalNoise crowns = noise_on(ground, site.place, site.dx, site.dy, 70.0, octaves_of(3.0, 0.7, GABOR_BILLOW), 4);
    float bare = 1.6 - 3.2 * dense - 0.5 * site.broad - 0.6 * site.fine.noise, soft = 0.35 + 1.2 * crowns.removed;
    vec3 colour = mix(vec3(0.012, 0.023, 0.012), vec3(0.04, 0.056, 0.022), smoothstep(-1.4, 1.8, crowns.noise + 0.5 * site.fine.noise));
    return vec4(colour, smoothstep(bare - soft, bare + soft, crowns.noise) * smoothstep(0.02, 0.2, dense));
}

vec3 alpine_colour(Ground ground, Site site) {
    GaborTerrain here = site.here;
    float n = site.fine.noise, broad = site.broad, height = here.height + 0.05 * n + 0.05 * broad;
    float bed = here.height + 0.05 * broad + 0.05 * dot(site.place, vec2(0.6, 0.8)) + 0.006 * n; // beds dip
    float stripes = 0.6 * layers(bed, 9.0, site.span) + 0.4 * layers(bed, 23.0, site.span);
    vec3 rock = mix(vec3(0.115, 0.11, 0.108), vec3(0.245, 0.22, 0.19), smoothstep(-2.2, 2.2, broad + n));
    rock *= 1.0 + 0.16 * stripes;
    rock = mix(rock, vec3(0.17, 0.135, 0.1), 0.5 * smoothstep(0.5, 1.8, n - broad)); // stains
    vec3 scree = mix(vec3(0.19, 0.175, 0.15), vec3(0.29, 0.265, 0.23), smoothstep(-1.5, 1.5, n));
    float green = falling(-0.15, 0.3, height - 0.12 * here.ridge);
    vec3 grass = mix(vec3(0.07, 0.085, 0.028), vec3(0.16, 0.135, 0.06), smoothstep(-1.8, 1.6, broad + 0.8 * n + 2.5 * here.height));
    vec3 colour = mix(scree, grass, green);
    colour = mix(colour, rock, smoothstep(0.6, 0.95, site.steep * (1.0 + 0.18 * n) + 0.12 * here.ridge));
    vec4 wood = trees(ground, site, falling(-0.25, 0.2, height - 0.06 * here.ridge) * falling(1.0, 1.7, site.steep + 0.15 * n));
    colour = mix(colour, wood.xyz, wood.w);
    // Snow lies where it is high and not too steep, longest in creases and away from the sun.
    float shade = dot(here.slope, ground.sun), lies = here.height - 0.1 * here.ridge + 0.1 * shade + 0.05 * n + 0.05 * broad;
    float snow = smoothstep(0.3, 0.44, lies) * falling(0.85, 1.35, site.steep * (1.0 + 0.15 * n) - 0.5 * smoothstep(0.4, 0.9, lies));
    return mix(colour, vec3(0.8, 0.83, 0.87), snow);
}

// Fields of many sizes, whose edges follow a noise: a colour for each, and dark hedges between.
vec3 field_colour(Ground ground, Site site) {
    vec2 q = 3.2 * vec2(0.8 * site.place.x + 0.6 * site.place.y, 0.8 * site.place.y - 0.6 * site.place.x) + 0.3 * site.broad;
    q.x += 0.5 * gabor_uniform(float(int(gabor_derived_seed(ground.seed, int(floor(q.y)) + 4000) >> 8u)) / 4194304.0 - 2.0);
    vec2 cell = floor(q), inside = q - cell;
    uint word = gabor_derived_seed(gabor_derived_seed(ground.seed, int(cell.x) + 9000), int(cell.y));
    float cut = 0.3 + 0.4 * float(word & 255u) / 255.0; // each cell is cut in two
    bool across = (word & 256u) != 0u;
    float side = across ? inside.x : inside.y;
    if (side > cut) word = gabor_derived_seed(word, 1);
    float edge = min(min(min(inside.x, 1.0 - inside.x), min(inside.y, 1.0 - inside.y)), abs(side - cut));
    float pixel = 3.2 * max(length(site.dx), length(site.dy)), hedge = falling(0.02 - 0.4 * pixel, 0.025 + 0.6 * pixel, edge);
    float kind = float((word >> 9u) & 1023u) / 1023.0, kept = 1.0 / (1.0 + 4.0 * pixel * pixel);
    vec3 colour = mix(vec3(0.06, 0.105, 0.025), vec3(0.12, 0.16, 0.04), kind);
    if (kind > 0.72) colour = vec3(0.28, 0.23, 0.085); // corn
    if (kind < 0.14) colour = vec3(0.15, 0.105, 0.065); // ploughed
    colour = mix(vec3(0.105, 0.125, 0.042), colour, kept);
    return mix(colour, vec3(0.03, 0.05, 0.018), hedge * mix(0.3, 1.0, kept));
}

vec3 meadow_colour(Ground ground, Site site) {
    GaborTerrain here = site.here;
    float n = site.fine.noise;
    vec3 grass = mix(vec3(0.06, 0.095, 0.024), vec3(0.16, 0.15, 0.055), smoothstep(-1.2, 1.8, site.broad + 0.5 * n + 2.2 * here.height));
    float low = falling(-0.08, 0.12, here.height + 0.06 * site.broad) * falling(0.3, 0.5, site.steep + 0.04 * n);
    vec3 colour = mix(grass, field_colour(ground, site), low);
    vec4 wood = trees(ground, site, 0.75 * smoothstep(0.3, 0.6, site.steep + 0.1 * site.broad) * falling(0.1, 0.35, here.height + 0.1 * here.ridge + 0.1 * n));
    colour = mix(colour, wood.xyz, wood.w);
    return mix(colour, vec3(0.2, 0.18, 0.15), smoothstep(0.95, 1.5, site.steep * (1.0 + 0.2 * n))) * (1.0 + 0.08 * n);
}

// Sand and scree below layered cliffs, which water has stained.
vec3 desert_colour(Site site) {
    float n = site.fine.noise, broad = site.broad, bed = site.here.height + 0.012 * broad + 0.004 * n;
    vec3 rock = mix(vec3(0.3, 0.115, 0.055), vec3(0.47, 0.25, 0.135), 0.5 + 0.5 * layers(bed, 3.2, site.span));
    rock = mix(rock, vec3(0.55, 0.4, 0.27), 0.35 + 0.35 * layers(bed + 0.05, 11.3, site.span));
    rock *= 1.0 + 0.1 * layers(bed, 37.0, site.span) + 0.07 * n;
    rock = mix(rock, vec3(0.12, 0.055, 0.035), 0.55 * smoothstep(0.6, 2.0, n + 0.6 * broad)); // varnish
    vec3 sand = mix(vec3(0.32, 0.16, 0.085), vec3(0.42, 0.26, 0.15), smoothstep(-1.6, 1.6, n + broad));
    float shrub = smoothstep(0.9, 1.5, site.fine.noise + 0.4 * broad) * falling(0.15, 0.35, site.steep);
    return mix(mix(sand, vec3(0.085, 0.085, 0.045), 0.6 * shrub), rock, smoothstep(0.4, 0.75, site.steep + 0.09 * n));
}

// Beds of clay, which dip and bend, above pale wash.
vec3 badlands_colour(Site site) {
    float n = site.fine.noise, bed = site.here.height + 0.1 * site.broad + 0.07 * dot(site.place, vec2(0.3, -0.95)) + 0.006 * n;
    float wide = layers(bed, 4.3, site.span), thin = layers(bed, 13.7, site.span);
    vec3 clay = mix(vec3(0.24, 0.125, 0.095), vec3(0.4, 0.34, 0.27), 0.5 + 0.3 * wide + 0.2 * thin);
    clay = mix(clay, vec3(0.2, 0.19, 0.175), 0.5 * smoothstep(0.3, 0.9, layers(bed + 0.3, 2.1, site.span)));
    clay *= 1.0 + 0.05 * n;
    vec3 wash = mix(vec3(0.36, 0.32, 0.26), vec3(0.44, 0.4, 0.33), smoothstep(-1.5, 1.5, n));
    return mix(wash, clay, smoothstep(-0.15, 0.3, site.steep - 0.5 - 0.3 * min(site.here.ridge, 0.0) + 0.06 * n));
}

vec3 ground_colour(Ground ground, Site site) {
    vec3 colour;
    if (ground.cover == 0) colour = alpine_colour(ground, site);
    else if (ground.cover == 1) colour = meadow_colour(ground, site);
    else if (ground.cover == 2) colour = desert_colour(site);
    else colour = badlands_colour(site);
    if (!has_lakes(ground)) return colour;
    // A beach, which is wet and dark at the water.
    float above = site.here.height - ground.water + 0.006 * site.fine.noise;
    vec3 beach = mix(vec3(0.2, 0.18, 0.145), vec3(0.3, 0.27, 0.22), smoothstep(-1.5, 1.5, site.fine.noise));
    colour = mix(beach, colour, smoothstep(0.012, 0.03, above - 0.01 * site.steep));
    return colour * mix(0.45, 1.0, smoothstep(0.0, 0.008, above));
}

// The normal of ground that is rougher where it is steep.
vec3 rough_normal(Ground ground, Site site) {
    float steep = smoothstep(0.25, 1.0, site.steep), amount = ground.cover == 1 ? 0.003 : ground.cover == 3 ? 0.002 : mix(0.003, ground.cover == 2 ? 0.008 : 0.024, steep);
    vec2 slope = site.here.slope + amount * (1.0 + 0.6 * site.steep) * site.fine.gradient;
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// The colour of sunlight, which is warm where the sun is low: the air takes more blue than red.
vec3 sun_colour(vec3 sun) {
    return 3.2 * exp(-vec3(0.12, 0.2, 0.37) / (sun.y + 0.06));
}

vec3 sunlit(vec3 sun, GaborTerrain here, vec3 normal, vec3 colour, float sunlight) {
    float open = 0.8 + 0.4 * clamp(here.ridge, -1.0, 1.0); // creases see less of the sky
    vec3 light = sun_colour(sun) * max(dot(normal, sun), 0.0) * sunlight
               + open * mix(vec3(0.15, 0.12, 0.09), vec3(0.24, 0.33, 0.5), 0.5 + 0.5 * normal.y); // from the ground and the sky
    return light * colour;
}

vec3 air_along(vec3 sun, vec3 ray) {
    float toward = max(dot(ray, sun), 0.0), up = max(ray.y, 0.0);
    vec3 low = mix(vec3(0.85, 0.62, 0.42), vec3(0.55, 0.66, 0.8), smoothstep(0.0, 0.5, sun.y + 0.25 * (1.0 - toward)));
    vec3 light = mix(vec3(0.1, 0.22, 0.5), low, 0.75 * exp(-4.0 * up) + 0.25 * exp(-16.0 * up));
    return light + vec3(1.0, 0.66, 0.36) * (0.3 * pow(toward, 6.0) + 0.3 * pow(toward, 60.0)) * exp(-1.5 * up);
}

// The sky, with thin clouds and the sun.
vec3 sky_along(Ground ground, vec3 ray, float wide) {
    vec3 sun = sun_of(ground), light = air_along(sun, ray);
    if (ray.y < 0.02) return light;
    float toward = max(dot(ray, sun), 0.0), far = 1.0 / (ray.y + 0.08);
    vec2 p = far * ray.xz * vec2(0.5, 1.1);
    GaborFractalNoise cloud = gabor_fractal_noise_filtered(gabor_place_at(p), wide * far * vec2(1.0, 0.0), wide * far * far * vec2(0.0, 1.0),
                                                           gabor_fractal(5.0, 0.55), ground.seed + 77u);
    float cover = smoothstep(0.1, 2.6, cloud.noise) * smoothstep(0.02, 0.2, ray.y);
    light = mix(light, mix(vec3(0.95, 0.82, 0.72), vec3(0.92, 0.94, 0.97), smoothstep(0.1, 0.5, sun.y)) + 0.4 * pow(toward, 8.0), 0.75 * cover);
    return light + 12.0 * vec3(1.0, 0.85, 0.65) * smoothstep(0.99985, 0.99996, toward);
}

// The height of a point above the ground. If the point is more than `margin` above anything that erosion could add to the
// hills, returns its height above that instead, which costs less. No ray from the point meets the ground within the distance
// `stride`, unless the ground is extremely steep.
float height_above(Ground ground, vec3 at, float pixel, float margin, out float stride) {
    GaborTerrain hills = hills_at(ground, at.xz, 0.0);
    float above = at.y - hills.height - ground.reach;
    stride = 0.45 * above;
    if (above > margin) return above;
    above = at.y - ground_on(ground, at.xz, pixel, hills).height;
    stride = 0.18 * above;
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
    vec2 over = vec2(0.0), under = vec2(0.0); // (t, height) on both sides of the end
    int narrowed = -1;
    RayEnd end = RayEnd(-1.0, 0.0, 0.0);
    for (int i = 0; i < 500 && t < far; ++i) {
        vec3 at = eye + t * ray;
        if (at.y > 1.7 + ground.reach && ray.y > 0.0) break;
        above = height_above(ground, at, max(wide * t, 0.3 * above), 0.5 * ground.reach, stride);
        if (above < 0.0 || narrowed >= 0) {
            if (narrowed < 0) over = resumed > 0.0 ? vec2(steps.z, heights.z) : vec2(steps.x, heights.x);
            if (above < 0.0) under = vec2(t, above); else over = vec2(t, above);
            t = mix(over.x, under.x, clamp(over.y / (over.y - under.y), 0.15, 0.85));
            ++narrowed;
            if (narrowed < 4) continue;
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
    for (int i = 0; i < 80 && light > 0.0 && at.y + t * sun.y < 1.7 + ground.reach; ++i) {
        float above = height_above(ground, at + t * sun, 0.08, t / 12.0, stride);
        light = min(light, 0.5 + 12.0 * above / t);
        t += max(stride, max(2.0 * pixel, 0.006 + 0.025 * t)); // longer steps would jump over ridges and make shadows ragged
    }
    return smoothstep(0.0, 1.0, clamp(light, 0.0, 1.0));
}

// The ground that a ray hits, its colour, and the light towards the eye. For a ray into the sky, the ground is 0; in a lake, it is
// the bed.
struct RayHit {
    GaborTerrain ground;
    float added; // height that erosion added
    vec3 colour;
    vec3 light;
};

// The ground at p, in a pixel that is `pixel` wide at right angles to the ray. From above, the sun lights all of it.
RayHit ground_hit(Ground ground, vec2 p, vec3 ray, float pixel, bool from_above) {
    RayHit hit;
    GaborTerrain hills = hills_at(ground, p, pixel);
    hit.ground = ground_on(ground, p, pixel, hills);
    hit.added = hit.ground.height - hills.height;
    // The pixel on the ground: sideways, and along the ray, where it is longer.
    vec2 forward = length(ray.xz) > 1.0e-3 ? normalize(ray.xz) : vec2(0.0, 1.0);
    vec3 normal = normal_of(hit.ground);
    float facing = clamp(-dot(normal, ray), 0.12, 1.0);
    Site site = site_at(ground, hit.ground, p, pixel * vec2(forward.y, -forward.x), pixel * mix(1.0, 1.0 / facing, normal.y) * forward);
    hit.colour = ground_colour(ground, site);
    vec3 sun = sun_of(ground), at = vec3(p.x, hit.ground.height, p.y) + 0.004 * normal;
    normal = rough_normal(ground, site);
    float sunlight = from_above ? 1.0 : dot(normal, sun) > 0.0 ? sunlight_at(ground, at, pixel) : 0.0;
    hit.light = sunlit(sun, hit.ground, normal, hit.colour, sunlight);
    return hit;
}

// How much air leaves of what is seen at the distance t. It is clear up to the distance `clear`, and thicker in valleys.
float clear_air(float t, float height, float clear) {
    return exp(-0.045 * t * t / (clear * clear) * mix(1.6, 0.7, smoothstep(-0.5, 0.8, height)));
}

// What is below the surface of a lake whose bed has this colour or light.
vec3 under_water(vec3 bed, vec3 deep, float depth) {
    return mix(deep, bed * vec3(0.35, 0.55, 0.5), exp(-22.0 * max(depth, 0.0)));
}

// Slopes of waves on a lake in x and y, and their spread below a pixel. Wind ruffles some places more than others.
vec3 waves_at(Ground ground, vec2 p, vec2 dx, vec2 dy) {
    float wind = noise_on(ground, p, dx, dy, 1.0, gabor_fractal(3.0, 0.6), 5).noise;
    GaborFractalNoise waves = noise_on(ground, p, dx, dy, 180.0, gabor_fractal(4.0, 0.6), 6);
    return mix(0.00001, 0.00013, smoothstep(-1.0, 1.5, wind)) * vec3(waves.gradient, sqrt(waves.lost.x + waves.lost.y));
}

// What a ray hits: the ground, the sky, or a lake, which mirrors what a second ray hits.
RayHit seen_along(Ground ground, vec3 eye, vec3 ray, float wide, float clear) {
    GaborTerrain none = GaborTerrain(0.0, vec2(0.0), 0.0, vec3(0.0), vec2(0.0));
    RayHit hit = RayHit(none, 0.0, vec3(0.0), vec3(0.0));
    vec3 below = vec3(0.0), edge = vec3(0.0);
    float mirrored = 0.0, covered = 0.0, hidden = 0.0, far = 7.0 * clear;
    for (int bounce = 0; bounce < (has_lakes(ground) ? 2 : 1); ++bounce) {
        float lake = has_lakes(ground) && ray.y < 0.0 ? (ground.water - eye.y) / ray.y : 2.0 * far;
        RayEnd end = end_of_ray(ground, eye, ray, wide, min(far, lake));
        bool wet = end.ground < 0.0 && lake < far;
        vec3 seen = sky_along(ground, ray, wide), air = air_along(sun_of(ground), normalize(vec3(ray.x, max(ray.y, 0.02), ray.z)));
        for (int i = 0; i < 2; ++i) { // what lies behind an edge, then the edge
            float t = i == 1 ? end.edge : wet ? lake : end.ground;
            if (t < 0.0 || i == 1 && end.covered <= 0.0) continue;
            vec3 at = eye + t * ray;
            RayHit near = ground_hit(ground, at.xz, ray, wide * t, i == 0 && wet);
            float clean = clear_air(t, at.y, clear);
            near.light = mix(air, near.light, clean);
            if (i == 0 && wet) {
                float depth = ground.water - near.ground.height;
                below = under_water(near.light, vec3(0.008, 0.035, 0.04), depth);
                near.colour = below;
                mirrored = smoothstep(-0.0005, 0.002, depth);
                hidden = 1.0 - clean;
            }
            if (bounce == 0 && i == 1 && wet) {
                edge = near.light;
                covered = end.covered;
            } else seen = mix(seen, near.light, i == 0 ? 1.0 : end.covered);
            if (bounce == 0) hit = near;
        }
        if (bounce == 0) hit.light = seen;
        else hit.light = mix(mix(mix(below, seen, mirrored), air, hidden), edge, covered);
        if (!wet) break;
        eye += lake * ray;
        vec2 forward = normalize(ray.xz + 1.0e-6);
        vec3 waves = waves_at(ground, eye.xz, wide * lake * vec2(forward.y, -forward.x), wide * lake / max(-ray.y, 0.01) * forward);
        vec3 normal = normalize(vec3(-waves.x, 1.0, -waves.y));
        mirrored *= 0.02 + 0.98 * pow(1.0 - clamp(-dot(normal, ray), 0.0, 1.0), 5.0);
        ray -= 2.0 * dot(normal, ray) * normal;
        ray = normalize(vec3(ray.x, abs(ray.y) + waves.z, ray.z)); // rough water mirrors higher parts
        eye.y = ground.water + 0.001;
        wide *= 4.0;
    }
    return hit;
}

// The height from which an eye sees past the hills before it.
float height_of_eye(Ground ground, vec3 eye, vec2 ahead, float clear) {
    float height = eye.y;
    for (int i = 0; i <= 6; ++i) {
        float part = 0.1 * float(i), hills = hills_at(ground, eye.xz + part * clear * ahead, 0.0).height;
        height = max(height, (hills + (i == 0 ? ground.reach + 0.02 : 0.5 * ground.reach)) / (1.0 - 0.6 * part));
    }
    return height;
}

// What a camera sees in a pixel. It looks at the point `target` of the plane y = 0 from the distance `away`; `yaw` and `pitch` are (cosine,
// sine) of its angles. Hills before it raise it. `place` is the offset from the middle of the picture in pixels, with y growing downwards,
// and `wide` the side of a pixel at distance 1.
RayHit seen_by_camera(Ground ground, vec2 target, float away, vec2 yaw, vec2 pitch, vec2 place, float wide) {
    vec3 toward_eye = vec3(pitch.x * yaw.x, pitch.y, pitch.x * yaw.y);
    vec3 right = vec3(yaw.y, 0.0, -yaw.x);
    vec3 up = vec3(-pitch.y * yaw.x, pitch.x, -pitch.y * yaw.y);
    vec2 at = wide * place;
    vec3 ray = normalize(at.x * right - at.y * up - toward_eye), eye = vec3(target.x, 0.0, target.y) + away * toward_eye;
    eye.y = height_of_eye(ground, eye, -yaw * pitch.x, away);
    return seen_along(ground, eye, ray, wide, away);
}

// The ground from above. Lakes mirror the sky.
RayHit seen_from_above(Ground ground, vec2 p, float pixel) {
    RayHit hit = ground_hit(ground, p, vec3(0.0, -1.0, 0.0), pixel, true);
    float depth = ground.water - hit.ground.height;
    if (depth > 0.0) {
        hit.colour = under_water(hit.colour, vec3(0.012, 0.05, 0.06), depth);
        hit.light = under_water(hit.light, vec3(0.02, 0.06, 0.085), depth);
    }
    return hit;
}
