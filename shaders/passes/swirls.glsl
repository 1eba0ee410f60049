// Fractal noise that a warp moves. The pass and copied code include it after gabor_fractal.glsl.

// The noise at a place whose pixel is (dx, dy), moved by a warp of that strength in kernel radii, 0 for none.
GaborFractalNoise warped_noise(GaborPlace place, bool filtered, vec2 dx, vec2 dy, float strength, GaborFractal fractal, uint seed) {
    GaborWarp warp = GaborWarp(place, vec2(1.0, 0.0), vec2(0.0, 1.0), vec3(0.0));
    if (strength != 0.0) {
        GaborFractal swirl = fractal;
        swirl.shape = GABOR_FBM;
        if (filtered)
            warp = gabor_warp_filtered(place, dx, dy, strength, swirl, gabor_derived_seed(seed, 0));
        else
            warp = gabor_warp(place, strength, swirl, gabor_derived_seed(seed, 0));
    }
    GaborFractalNoise noise;
    if (filtered)
        noise = gabor_fractal_noise_filtered(warp.place, dx.x * warp.dx + dx.y * warp.dy, dy.x * warp.dx + dy.y * warp.dy, fractal, seed);
    else
        noise = gabor_fractal_noise(warp.place, fractal, seed);
    noise.gradient = vec2(dot(noise.gradient, warp.dx), dot(noise.gradient, warp.dy));
    return noise;
}
