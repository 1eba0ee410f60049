// Returns one float at p for each function of gabor_noise.tsl.js, like FUNCTIONS in tests/engines/reference.py.
export const functions = (gabor, { dot, normalize, vec2, vec3 }, p) => {
    const [frequency, orientation, seed] = [4, 0.7854, 7];
    const gradient = gabor.gabor_noise_gradient(p, frequency, orientation, seed).toVar();
    const wave = gabor.gabor_wave_vector(frequency, orientation);
    const moving = gabor.gabor_field({ ...gabor.gabor_place_tiled(p, vec2(2, 1)), evolution: 0.3 }, wave, seed);
    const space = gabor.gabor_field_3d(gabor.gabor_place_3d_at(vec3(p, 0.3)), normalize(vec3(1, 2, 3)).mul(frequency), seed);
    const stripes = gabor.gabor_stripes(p, wave, 2, seed).toVar();
    const metal = gabor.gabor_brushed_metal(p, seed);
    return {
        noise: gabor.gabor_noise(p, frequency, orientation, seed),
        complex: gabor.gabor_noise_quadrature(p, frequency, orientation, seed).y,
        gradient: gradient.x.add(gradient.y.div(32)).add(gradient.z.div(16)),
        tiled: gabor.gabor_noise_tiled(p, vec2(2, 1), frequency, orientation, seed),
        animated: gabor.gabor_noise_animated(p, 0.3, frequency, orientation, seed),
        "tiled and animated": moving.noise,
        solid: space.noise.add(dot(space.gradient, vec3(1, 2, 3)).div(64)),
        stripes: stripes.x.mul(0.25).add(stripes.y.mul(0.5)).add(stripes.z.mul(0.75)),
        "brushed metal": metal.colour.x.add(metal.height.mul(200)),
        fbm: gabor.gabor_fbm(p, 3.3, 0.5, seed),
    };
};
