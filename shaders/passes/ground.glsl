// Ground, and noise on it. Include it after gabor_erosion.glsl and gabor_fractal.glsl.
// In space, x and z are the ground's x and y, and y points up.

struct Ground {
    ivec2 cell; // positions are relative to this cell
    vec2 period;
    uint seed;
    GaborErosion erosion;
    float reach; // the most that erosion adds to the hills
    vec2 sun;    // x and y of the unit vector towards the sun
    int cover;   // alpine, meadow, desert or badlands: 0 to 3
    float water; // level of lakes
};

GaborTerrainPlace place_on(Ground ground, vec2 p) {
    return GaborTerrainPlace(ground.cell, p, ground.period);
}

// Noise on the ground, whose first octave has `nodes` nodes per unit of p. Each `part` is independent.
GaborFractalNoise noise_on(Ground ground, vec2 p, vec2 dx, vec2 dy, float nodes, GaborFractal fractal, int part) {
    return gabor_fractal_noise_filtered(gabor_impl_ground(place_on(ground, p), nodes), dx, dy, fractal, gabor_derived_seed(ground.seed, part));
}
