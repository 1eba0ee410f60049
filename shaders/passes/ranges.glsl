// Hills in ranges, and their erosion, as ground.glsl declares the ground. Include it after ground.glsl.

// Replaces the height h by f(h), where f(h) = curve.x and its derivatives are curve.y and curve.z.
GaborTerrain remapped(GaborTerrain hills, vec3 curve) {
    vec2 s = hills.slope;
    vec3 curvature = curve.y * hills.curvature + curve.z * vec3(s.x * s.x, s.x * s.y, s.y * s.y);
    return GaborTerrain(curve.x, curve.y * s, hills.ridge, curvature, hills.ridge_slope);
}

// Turns slopes into cliffs and benches, as beds of hard rock do: applies x - a sin(2 pi x) / (2 pi) twice to the height
// x in beds.
vec3 bedded(float height, float beds) {
    const float a = 0.85;
    vec3 curve = vec3(beds * height, beds, 0.0);
    for (int i = 0; i < 2; ++i) {
        vec2 wave = gabor_impl_wave(curve.x);
        float slope = 1.0 - a * wave.x;
        curve = vec3(curve.x - a / 6.2831853 * wave.y, slope * curve.y, slope * curve.z + 6.2831853 * a * wave.y * curve.y * curve.y);
    }
    return curve / beds;
}

// The hills of gabor_terrain in ranges, between long valleys along the zeros of a wide noise w. With t = w^2 / (w^2 + c), their height is
// h = (0.4 + 0.75 t) hills + 0.55 (t - 0.6). Valleys have a floor, and summits are less steep: with soft(x) = (x + sqrt(x^2 + s)) / 2,
// the result is soft(h + 0.42) - 0.42 - 0.5 soft(h - 0.8).
// The curvature of w is left out: near the zeros, it does not matter.
GaborTerrain hills_at(Ground ground, vec2 p, float pixel) {
    GaborTerrain hills = gabor_terrain_at(place_on(ground, p), vec2(pixel, 0.0), vec2(0.0, pixel), ground.seed);
    GaborFractalNoise wide = gabor_fractal_noise(gabor_impl_ground(place_on(ground, p), 0.2), gabor_fractal(1.0, 0.0),
                                                 gabor_derived_seed(ground.seed, 1));
    float w = wide.noise, c = 0.35, all = w * w + c, t = w * w / all, rise = 2.0 * c * w / (all * all);
    vec2 along = rise * wide.gradient, s = hills.slope;
    float bend = 2.0 * c * (c - 3.0 * w * w) / (all * all * all), grown = 0.4 + 0.75 * t, lifted = 0.75 * hills.height + 0.55;
    vec2 g = wide.gradient;
    hills.curvature = grown * hills.curvature + 0.75 * vec3(2.0 * along.x * s.x, along.x * s.y + along.y * s.x, 2.0 * along.y * s.y)
                    + lifted * bend * vec3(g.x * g.x, g.x * g.y, g.y * g.y);
    hills.slope = grown * s + lifted * along;
    hills.height = grown * hills.height + 0.55 * (t - 0.6);
    if (ground.cover == 2) hills = remapped(hills, bedded(hills.height, 3.2));
    vec2 above = hills.height - vec2(-0.42, 0.8), width = vec2(0.02, 0.06), root = sqrt(above * above + width), part = vec2(0.5, -0.25);
    return remapped(hills, vec3(dot(part, above + root) - 0.42, dot(part, 1.0 + above / root), dot(part, width / (root * root * root))));
}

// The ground at p, filtered for a pixel that is `pixel` wide on the ground.
GaborTerrain ground_on(Ground ground, vec2 p, float pixel, GaborTerrain hills) {
    return gabor_eroded_at(place_on(ground, p), vec2(pixel, 0.0), vec2(0.0, pixel), hills, ground.erosion, ground.seed);
}
GaborTerrain ground_at(Ground ground, vec2 p, float pixel) {
    return ground_on(ground, p, pixel, hills_at(ground, p, pixel));
}
