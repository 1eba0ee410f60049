// Returns one float at p for each function of gabor_noise.tsl.js, like FUNCTIONS in tests/engines/reference.py.
export const functions = (gabor, { float, vec2, vec3 }, p) => {
    const [frequency, orientation, seed] = [4, 0.7854, 7];
    const gradient = gabor.gabor_noise_gradient(p, frequency, orientation, seed).toVar();
    const space = gabor.gabor_field_3d(vec3(p, 0.3), frequency, vec3(1, 2, 3), seed).toVar();
    const stripes = gabor.gabor_stripes(p, gabor.gabor_wave(frequency, orientation), 2, seed).toVar();
    const metal = gabor.gabor_brushed_metal(p, seed);
    return {
        noise: gabor.gabor_noise(p, frequency, orientation, seed),
        complex: gabor.gabor_noise_complex(p, frequency, orientation, seed).x,
        gradient: gradient.x.add(gradient.y.div(32)).add(gradient.z.div(16)),
        tiled: gabor.gabor_noise_tiled(p, vec2(2, 1), frequency, orientation, seed),
        animated: gabor.gabor_noise_animated(p, 0.3, frequency, orientation, seed),
        solid: space.x.add(space.y.div(64)).add(space.z.div(32)).add(space.w.mul(3 / 64)),
        stripes: stripes.x.mul(0.25).add(stripes.y.mul(0.5)).add(stripes.z.mul(0.75)),
        "brushed metal": metal.colour.x.add(metal.height.mul(200)),
    };
};
