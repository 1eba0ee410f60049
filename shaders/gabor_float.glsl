// gabor_float.glsl: gabor_noise.glsl without integers: the same lattice and law, but other values.
//
// Paste this file instead of gabor_noise.glsl where there are no integers: GLSL ES 1.00, which is WebGL 1, GLSL 1.10,
// Skia's SkSL, ISF. It has no directives, so nothing guards it: paste it once, and never beside gabor_noise.glsl, whose
// names it has. In GLSL ES, write `precision highp float;` before it. In SkSL write nothing before it.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7.0);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//
// Functions and arguments are those of gabor_noise.glsl with three taps, where they are described, except that
//     p            is in kernel radii, |p| < 600000. Noise repeats after 10^9 nodes, beyond what p reaches.
//     period       is 1/1024 to 500000 along each axis, 0 for none
//     seed         is a whole number, |seed| <= 900000; a fraction is dropped
// highp must have 32 bits. At 16 bits, the hash fails: its products reach 1041420, but whole numbers are exact only up
// to 2048, and infinite above 65504. The noise is then NaN, or the same for all seeds where max drops NaN.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// float gabor_noise(vec2 p, float frequency, float orientation, float seed)
// float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, float seed)
//     The noise, with mean 0, variance 1, a normal distribution at every point and continuous first derivatives.

// vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, float seed)
//     (noise, d/dx, d/dy). The derivatives are per kernel radius, for a constant wave vector.

// vec3 gabor_stripes(vec2 p, vec2 wave, float sharpness, float seed)
//     Stripes of even contrast, at right angles to the wave vector: (cosine, sine, intensity).

// float gabor_unorm(float noise)
// float gabor_uniform(float noise)
//     For display, [-2, 2] to [0, 1]; and the noise's rank among all values, uniform in [0, 1].

// vec2 gabor_wave_vector(float frequency, float orientation)
//     The wave vector in cycles per kernel radius.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// gabor_noise.glsl derives the sum. Here a node's word is three residues, the products of its column's and its row's
// modulo three primes. Residues are not 0, so neither are products.

const vec3 gabor_impl_primes = vec3(1021.0, 1019.0, 1013.0);
const vec3 gabor_impl_inverses = vec3(0.000979431929, 0.000981354269, 0.000987166831); // 1/1021, 1/1019, 1/1013

// The residues of whole numbers up to 1.05 10^6. Products and differences are exact. 0.00049 is about half a prime's
// inverse, so the quotient is at least 0.00048 away from where its floor jumps: four times the errors of rounding,
// fused or not, and of inverses that are one unit off.
vec3 gabor_impl_residues(vec3 x) {
    return x - gabor_impl_primes * floor(x * gabor_impl_inverses + 0.00049);
}

// The residues of a column, a row or a seed. x, y and z follow x + y z twice, each modulo its own prime: with one step,
// runs of four nodes correlate. After 10^9 nodes, the product of the primes, all residues repeat.
vec3 gabor_impl_line(float index, vec3 salt) {
    vec3 x = gabor_impl_residues(index + salt);
    x = gabor_impl_residues(x + x.yzx * x.zxy);
    return max(gabor_impl_residues(x + x.yzx * x.zxy), 1.0);
}

// A node's amplitude, two independent and nearly normal numbers, as in gabor_noise.glsl. They come from u, the sums of
// two residues over their primes, modulo 1. Such sums are at least 9.6e-7 away from 1.
vec2 gabor_impl_amplitude(vec3 column, vec3 row) {
    vec3 part = gabor_impl_residues(column * row) * gabor_impl_inverses;
    vec2 u = fract(part.xz + part.y) - 0.5;
    // fit: see tools/constants.py
    return (u - 0.89289313 * clamp(u, -0.46843798, 0.46843798)) * (u * u + 0.4010134);
}

// z times each of two complex numbers.
vec4 gabor_impl_products(vec4 pair, vec2 z) {
    return z.x * pair + z.y * vec4(-pair.y, pair.x, -pair.w, pair.z);
}

vec4 gabor_impl_sum(vec4 a, vec4 b, vec4 c, vec2 x, vec2 y, vec2 z) {
    return gabor_impl_products(a, x) + gabor_impl_products(b, y) + gabor_impl_products(c, z);
}

// (cos, sin) of 2 pi t for |t| <= 1/4, by minimax polynomials, within 2e-7.
vec2 gabor_impl_half_turn(float t) {
    float s = t * t, r = s * s;
    // fits: see tools/constants.py
    return vec2((1.0 - 19.739171 * s) + r * ((64.934591 - 85.240337 * s) + 56.24243 * r),
                t * ((6.2831852 - 41.341655 * s) + r * ((81.601004 - 76.549782 * s) + 39.536707 * r)));
}

// (cos, sin) of 2 pi t for any t.
vec2 gabor_impl_wave(float t) {
    float within = t - floor(t + 0.5);
    vec2 turn = gabor_impl_half_turn(0.25 - abs(within));
    return vec2(turn.y, within < 0.0 ? -turn.x : turn.x);
}

// The windows of the nodes -1, 0 and 1, and their derivatives per kernel radius, at x in [-1/2, 1/2].
void gabor_impl_windows(float x, out vec3 value, out vec3 slope) {
    float y = x * x;
    // fits: see tools/constants.py
    float c = 0.5 - y * (1.0966099 - y * (0.40054826 - y * 0.05644487)); // cos(2/3 pi x) / 2
    float s = x * (0.90689956 - y * (0.66301124 - y * (0.14532053 - y * 0.01467483))); // sqrt(3)/4 sin(2/3 pi x)
    float a = 0.5 - 0.5 * c;
    float b = 1.8137994 * s; // pi/sqrt(3)
    value = vec3(a - s, 0.5 + c, a + s);
    slope = vec3(b - 2.7206991 * c, -2.0 * b, b + 2.7206991 * c); // sqrt(3)/2 pi
}

// A node's index within a period. The second step corrects a quotient that the first rounded to a whole number.
float gabor_impl_wrap(float index, float period) {
    if (period > 0.0) {
        index -= period * floor(index / period);
        index += index < 0.0 ? period : index < period ? 0.0 : -period;
    }
    return index;
}

// The three nodes along an axis whose windows reach a point.
struct GaborImplAxis {
    float offset; // offset of the point from the middle node, in node spacings
    float turns;  // turns of the wave from one node to the next
    vec3 before;  // residues of the nodes
    vec3 middle;
    vec3 after;
    vec4 node_before; // the wave times the window, and times the window's derivative
    vec4 node_middle;
    vec4 node_after;
};

// `wave` is in cycles per kernel radius, `radius` in nodes per kernel radius, `period` in nodes.
GaborImplAxis gabor_impl_axis(float local, float period, vec3 salt, float wave, float radius) {
    GaborImplAxis axis;
    float zero = floor(local + 0.5);
    axis.offset = clamp(local - zero, -0.5, 0.5);
    axis.turns = wave / radius;
    axis.before = gabor_impl_line(gabor_impl_wrap(zero - 1.0, period), salt);
    axis.middle = gabor_impl_line(gabor_impl_wrap(zero, period), salt);
    axis.after = gabor_impl_line(gabor_impl_wrap(zero + 1.0, period), salt);
    vec3 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    vec2 turn = gabor_impl_wave(axis.turns), back = vec2(turn.x, -turn.y);
    axis.node_before = vec4(value.x * turn, slope.x * turn);
    axis.node_middle = vec4(value.y, 0.0, slope.y, 0.0);
    axis.node_after = vec4(value.z * back, slope.z * back);
    return axis;
}

vec4 gabor_impl_row(GaborImplAxis x, vec3 row) {
    return gabor_impl_sum(x.node_before, x.node_middle, x.node_after, gabor_impl_amplitude(x.before, row),
                          gabor_impl_amplitude(x.middle, row), gabor_impl_amplitude(x.after, row));
}

// (noise, quadrature, gradient). `local` and `period` are in nodes, and `radius` is the nodes per kernel radius.
vec4 gabor_impl_field(vec2 local, vec2 period, vec2 wave, vec2 radius, float seed) {
    wave = clamp(wave, -1.0e6, 1.0e6);
    vec3 salt = gabor_impl_line(floor(seed), vec3(17.0, 400.0, 811.0));
    GaborImplAxis x = gabor_impl_axis(local.x, period.x, salt, wave.x, radius.x);
    GaborImplAxis y = gabor_impl_axis(local.y, period.y, salt.yzx, wave.y, radius.y);
    vec4 before = gabor_impl_row(x, y.before), middle = gabor_impl_row(x, y.middle), after = gabor_impl_row(x, y.after);
    vec4 sum = gabor_impl_sum(before, middle, after, y.node_before.xy, y.node_middle.xy, y.node_after.xy);
    vec4 slope = gabor_impl_sum(before, middle, after, y.node_before.zw, y.node_middle.zw, y.node_after.zw);
    // 1 / (9/8 times the deviation of amplitudes); fit: see tools/constants.py
    vec2 turn = 48.237801 * gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    vec4 both = gabor_impl_products(sum, turn);
    vec2 along_y = gabor_impl_products(slope, turn).xy;
    // 2/3 is 1 / nodes per kernel radius, 6.2831853 is 2 pi
    vec2 gradient = radius * vec2(both.w, along_y.y) / 1.5 + 6.2831853 * wave * both.x;
    return vec4(both.yx, gradient);
}

vec2 gabor_wave_vector(float frequency, float orientation) {
    return min(abs(frequency), 1.0e6) * gabor_impl_wave(0.15915494 * clamp(orientation, -1.0e6, 1.0e6)); // 1/(2 pi)
}

float gabor_noise(vec2 p, float frequency, float orientation, float seed) {
    return gabor_impl_field(1.5 * p, vec2(0.0), gabor_wave_vector(frequency, orientation), vec2(1.5), seed).x;
}

float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, float seed) {
    vec2 side = clamp(period, 0.0009765625, 500000.0), nodes = max(floor(1.5 * side + 0.5), 3.0); // 2^-10
    vec2 radius = vec2(period.x > 0.0 ? nodes.x / side.x : 1.5, period.y > 0.0 ? nodes.y / side.y : 1.5);
    vec2 wave = gabor_wave_vector(frequency, orientation);
    nodes *= 1.0 - step(period, vec2(0.0));
    return gabor_impl_field(p * radius, nodes, wave, radius, seed).x;
}

vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, float seed) {
    return gabor_impl_field(1.5 * p, vec2(0.0), gabor_wave_vector(frequency, orientation), vec2(1.5), seed).xzw;
}

vec3 gabor_stripes(vec2 p, vec2 wave, float sharpness, float seed) {
    vec2 value = gabor_impl_field(1.5 * p, vec2(0.0), wave, vec2(1.5), seed).yx;
    float intensity = length(value);
    return vec3(sharpness / max(sharpness * intensity, 1.0) * value, intensity);
}

float gabor_unorm(float noise) {
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

float gabor_uniform(float noise) {
    float x = clamp(noise, -8.0, 8.0), y = x * x;
    return 1.0 / (1.0 + exp(-x * (1.5954352 + y * (0.073597476 - y * 0.00063190124)))); // fit: see tools/constants.py
}
