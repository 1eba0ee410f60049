// photograph.glsl: Gabor noise after photograph.webp, as gabor fit --lobes 6 --glsl writes it, without what needs gabor_filter.glsl.
//     vec3 photograph(vec2 p): colour at p, in pixels of the photograph, 256 x 256. Costs about 6 times gabor_noise.
#ifndef GABOR_NOISE_GLSL
#error Include gabor_noise.glsl before photograph.glsl
#elif !defined(GABOR_TEXTURE_photograph_GLSL)
#define GABOR_TEXTURE_photograph_GLSL 1
const uint photograph_seed = 0u; // another seed gives another piece of the same texture
GaborField photograph_field(GaborPlace place, vec2 dx, vec2 dy, vec2 wave, bool filtered, uint seed) {
    return gabor_field(place, wave, seed);
}
// Adds lobe i. k: its radii along x and y in pixels and its waves per radius; a, b: weights of its noise and quadrature.
void photograph_lobe(inout vec3 z, inout vec3 removed, vec2 p, vec4 d, bool filtered, int i, vec4 k, vec3 a, vec3 b) {
    uint seed = gabor_derived_seed(photograph_seed, i);
    GaborField n = photograph_field(gabor_place_at(p / k.xy), d.xy / k.xy, d.zw / k.xy, k.zw, filtered, seed);
    z += n.noise * a + n.quadrature * b;
    removed += n.removed * (a * a + b * b);
}
void photograph_sum(inout vec3 z, inout vec3 removed, vec2 p, vec4 d, bool filtered) {
    photograph_lobe(z, removed, p, d, filtered, 0, vec4(2.4239662, 1.4990133, 0.291554, -0.020804394), vec3(0.66758245, 0.4359978, 0.16231267), vec3(0.0, 0.0036680594, 0.0003558564));
    photograph_lobe(z, removed, p, d, filtered, 1, vec4(88.585365, 128.0, 1.7318959, 0.055464864), vec3(0.38849905, -0.58552533, -0.04849979), vec3(0.0, -0.067572, 0.28405565));
    photograph_lobe(z, removed, p, d, filtered, 2, vec4(128.0, 86.79363, 0.09498786, -0.58872086), vec3(0.34554607, -0.50001633, -0.27572265), vec3(0.0, -0.29509175, 0.88055605));
    photograph_lobe(z, removed, p, d, filtered, 3, vec4(1.8267862, 13.787701, 0.32521772, 0.01726802), vec3(0.33947185, 0.2298721, 0.052216027), vec3(0.0, -0.060682103, 0.07610062));
    photograph_lobe(z, removed, p, d, filtered, 4, vec4(2.5516531, 2.3629463, 0.83805573, -0.01542621), vec3(0.3338478, 0.20679444, 0.056143872), vec3(0.0, 0.015055375, -0.018725844));
    photograph_lobe(z, removed, p, d, filtered, 5, vec4(14.303121, 11.1793585, 0.27705485, -0.090266526), vec3(0.23938373, -0.1582511, -0.12828557), vec3(0.0, -0.028871547, -0.1036092));
}
vec3 photograph_colour(vec3 z, vec3 v) { // maps normal components to the histogram; v: the variance that a filter removed
    z = clamp(z, -4.0, 4.0);
    vec3 s = z * z, c = vec3(-0.10027873, -0.04808957, 0.087936066) + vec3(0.10212096, 0.062429424, -0.07490686) * (s + v) + vec3(-0.000614077, -0.0047799507, -0.0043430687) * (s * (s + 6.0 * v) + 3.0 * v * v)
           + z * (vec3(0.9473259, 0.96933496, 0.9112131) + vec3(0.016943783, 0.012990525, 0.023972671) * (s + 3.0 * v) + vec3(-0.0005541029, -0.00065801636, 0.00028080764) * (s * (s + 10.0 * v) + 15.0 * v * v));
    return vec3(0.40720007, 0.37626314, 0.34433773) + c.x * vec3(0.030398695, 0.030645331, 0.029288659) + c.y * vec3(-0.0012928067, -0.0011292237, 0.0025233342) + c.z * vec3(0.0014113545, -0.0014646472, 6.764625e-05);
}
vec3 photograph(vec2 p) {
    vec3 z = vec3(0.0), removed = z;
    photograph_sum(z, removed, p, vec4(0.0), false);
    return photograph_colour(z, removed);
}
#endif
