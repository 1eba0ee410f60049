// Sums of noises. The passes and copied code include it after the drop-ins.

// A noise or a sum of noises: its quadrature and itself, its derivatives in the picture's kernel radii, and the variance that a
// filter removed.
struct Noise {
    vec2 complex;
    vec3 slope;
    float removed;
};

// `radius`: the radii of the noise's kernels.
#ifdef GABOR_SPARSE_GLSL
Noise noise_of(GaborField field, vec2 radius) {
    return Noise(vec2(field.quadrature, field.noise), vec3(field.gradient / radius, 0.0), 0.0);
}
#else
Noise noise_of(GaborField field, vec2 radius) {
    return Noise(vec2(field.quadrature, field.noise), vec3(field.gradient / radius, 0.0), field.removed);
}
#endif

#ifdef GABOR_NOISE_3D_GLSL
Noise noise_of(GaborField3d field, float radius) {
    return Noise(vec2(field.quadrature, field.noise), field.gradient / radius, field.removed);
}
#endif

void add_noise(inout Noise sum, Noise one, float amplitude) {
    sum.complex += amplitude * one.complex;
    sum.slope += amplitude * one.slope;
    sum.removed += amplitude * amplitude * one.removed;
}

// The components of a colour: the sum of noises in each, and the variance that a filter removed from it.
struct Components {
    vec3 value;
    vec3 removed;
};

// Adds a noise to each component. `weights`: those of its quadrature and itself in each component.
void add_weighted(inout Components sum, Noise one, vec2 weights[3]) {
    vec2 a = weights[0];
    vec2 b = weights[1];
    vec2 c = weights[2];
    sum.value += vec3(dot(a, one.complex), dot(b, one.complex), dot(c, one.complex));
    sum.removed += one.removed * vec3(dot(a, a), dot(b, b), dot(c, c));
}
