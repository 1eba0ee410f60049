// Fly over eroded mountains; drag the mouse to look around. Paste all of this into shadertoy.com, and change the code at the
// end as you like.

// ---- gabor_noise.glsl unchanged ----
// gabor_noise.glsl: Gabor noise in the plane, with mean 0, variance 1 and a normal distribution at every point.
//
// Paste or include this file after `#version`: GLSL 450, 330 core or 300 es. It declares no resources, and every name
// it adds begins with gabor_, Gabor or GABOR_. Names with gabor_impl_ are private.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//     float v = gabor_unorm(n);                    // in [0, 1], for display
//
// Values are normal up to three standard deviations. Values beyond 3.5 are 13 % too rare overall, and 56 % too rare at
// the nodes of the lattice.
//
// Arguments of all functions:
//     p            position in kernel radii, |p| < 2^31 / GABOR_RADIUS. Float rounding shows earlier: at 10^5, p has
//                  steps of 0.008. Each wave fades out within one kernel radius of its node.
//     frequency    cycles per kernel radius, up to 10^6; the sign is ignored
//     orientation  direction of the wave vector, in radians from +x towards +y. At frequency 4, rounding adds an error
//                  of 1.5e-6 to the noise for each radian.
//     wave         wave vector in cycles per kernel radius, up to 10^6 along each axis. It replaces frequency and
//                  orientation, for example in direction maps; (0, 0) gives noise of frequency 0.
//     period       kernel radii along x and y after which the noise repeats exactly, 1/1024 to 10^9. Kernels shrink to
//                  fit a period below 2; to fit a longer one, their size changes by at most a sixth with GABOR_TAPS 3.
//     seed         any number; different seeds give independent noises
// Frequency, orientation and wave may vary with p; where they are continuous, so is the noise. If a direction map
// jumps, gabor_direction.glsl keeps stripes unbroken. NaN gives an unspecified value.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifdef GABOR_SPARSE_GLSL
#error Include gabor_sparse.glsl or gabor_noise.glsl, not both: they define the same functions
#endif
#ifndef GABOR_NOISE_GLSL
#define GABOR_NOISE_GLSL
#define GABOR_NOISE_VERSION 20000 // 10000 major + 100 minor + patch

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// Quality: each point sums GABOR_TAPS^2 waves. To change GABOR_TAPS, define it before this file. 2 is fastest, but
// shows columns and rows at high frequencies; with 4, the covariance depends less on the position.
#ifndef GABOR_TAPS
#define GABOR_TAPS 3
#endif
#if GABOR_TAPS < 2 || GABOR_TAPS > 4
#error GABOR_TAPS must be 2, 3 or 4
#endif

// float gabor_noise(vec2 p, float frequency, float orientation, uint seed)
// float gabor_noise_wave(vec2 p, vec2 wave, uint seed)
// float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, uint seed)
// float gabor_noise_wave_tiled(vec2 p, vec2 period, vec2 wave, uint seed)
//     The noise, with continuous first derivatives.

// float gabor_noise_animated(vec2 p, float time, float frequency, float orientation, uint seed)
//     Noise that evolves in place with period 1; time 0 gives gabor_noise. Values a time t apart have the correlation
//     cos^2(pi t). Costs three times as much as gabor_noise.

// vec4 gabor_noise_four(vec2 p, float frequency, float orientation, uint seed)
//     Four independent noises, with the seeds `seed` and gabor_lobe_seed(seed, i) for i = -1, -2, -3. Costs four times
//     as much as gabor_noise.

// vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, uint seed)
// vec3 gabor_noise_wave_gradient(vec2 p, vec2 wave, uint seed)
//     (noise, d/dx, d/dy). The derivatives are per kernel radius, for a constant wave vector.

// vec2 gabor_noise_complex(vec2 p, float frequency, float orientation, uint seed)
// vec2 gabor_noise_wave_complex(vec2 p, vec2 wave, uint seed)
//     (quadrature, noise): the real and imaginary parts of a complex noise. The quadrature has cosines instead of
//     sines. At each point the two are independent and have variance 1.

// vec2 gabor_phasor(vec2 value)
//     (phase in turns within [0, 1), intensity) of a complex value. A profile of the phase, such as step(phase, width),
//     is a pattern of even contrast [Tricard et al., "Procedural phasor noise", 2019].

// vec3 gabor_stripes(vec2 p, vec2 wave, float sharpness, uint seed)
// vec3 gabor_stripes_tiled(vec2 p, vec2 period, vec2 wave, float sharpness, uint seed)
//     Stripes of even contrast, at right angles to the wave vector: (cosine, sine, intensity). Sharpness is 0 to 10^6;
//     2 is a good value. If z is the complex noise, the intensity is |z|, and (cosine, sine) is z / |z| where |z|
//     exceeds 1 / sharpness. Elsewhere it is sharpness times z, so stripes fade where they fork.

// vec3 gabor_stripes_of(vec2 value, float sharpness)
//     The same for any complex value.

// float gabor_unorm(float noise)
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// uint gabor_lobe_seed(uint seed, int index)
//     The seed of noise `index` in a sum of independent noises.

// ---- For large worlds, and for periods combined with time ----------------------------------------------------------

#define GABOR_RADIUS (0.5 * float(GABOR_TAPS)) // nodes of the lattice per kernel radius

// A wave vector, returned by gabor_kernel or gabor_kernel_wave.
struct GaborKernel {
    vec2 wave; // cycles per kernel radius
};

// A position in node spacings of the lattice, with a period and a time.
struct GaborPlace {
    ivec2 cell;    // any integers except the last few before 2^31, where the world wraps around
    vec2 local;    // offset from that cell's corner in node spacings, most precise in [0, 1)^2
    vec2 radius;   // nodes per kernel radius along each axis: GABOR_RADIUS, or slightly different to fit a period
    ivec2 period;  // period in nodes, 0 for none
    bool animated; // whether the noise changes with time
    float time;    // time in periods
};

// Complex noise, (quadrature, noise), and its derivatives per kernel radius. Unused parts cost nothing.
struct GaborField {
    vec2 value;
    vec2 slope_x;
    vec2 slope_y;
};

// GaborKernel gabor_kernel(float frequency, float orientation)
//     The kernel with a given frequency and orientation; ranges are those of gabor_noise.

// GaborKernel gabor_kernel_wave(vec2 wave)
//     The kernel with a given wave vector; its range is that of gabor_noise_wave.

// GaborPlace gabor_place(ivec2 cell, vec2 local)
//     The position (cell + local) / GABOR_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells along each
//     axis.

// GaborPlace gabor_place_tiled(vec2 p, vec2 period)
//     The position p in noise that repeats after `period` kernel radii; an axis whose period is 0 is endless. A
//     period holds a whole number of nodes, from GABOR_TAPS to 2^31.

// GaborField gabor_field(GaborPlace place, GaborKernel kernel, uint seed)
//     The noise, its quadrature, and their gradients at `place`. All noise functions call it.

// float gabor_noise_at(ivec2 cell, vec2 local, GaborKernel kernel, uint seed)
//     The noise at gabor_place(cell, local).

// vec3 gabor_stripes_at(GaborPlace place, vec2 wave, float sharpness, uint seed)
//     The same as gabor_stripes, at `place`.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// The nodes (x_k, y_j) of a square lattice with R = GABOR_RADIUS nodes per kernel radius have independent, normal,
// complex amplitudes A_kj. Each node emits a wave under a window that ends one kernel radius away along x and y:
//
//     n(p) = K Im sum_kj A_kj h(x - x_k) h(y - y_j) exp(2 pi i F.(p - (x_k, y_j))),   F = frequency (cos o, sin o).
//
// The window is Hann's, h(d) = (1 + cos pi d) / 2. GABOR_TAPS of its shifts overlap at every x. Three or more evenly
// spaced shifts of cos and of cos^2 over a period sum to a constant, so that
//
//     sum_k h(x - x_k)^2 = 3/8 GABOR_TAPS   at every x.
//
// The squares of the window's derivatives also sum to a constant. So the variances of the noise, its gradient and its
// second derivatives are the same at every point; that of the noise does not depend on the frequency either. The second
// derivatives jump where windows end, midway between nodes for 3 taps and at nodes for 4: by 0.16 of their standard
// deviation at frequency 1, and by 1.1 at frequency 0. The noise is normal because sums of independent normal variables
// are normal.
//
// Each wave's phase starts at its own node, so the wave vector F may vary with the position. From one node to the next,
// the phase turns by u = 2 pi F_x / R along x and v = 2 pi F_y / R along y. If node (0, 0) is next to p, the sum
// separates into one sum per axis:
//
//     n(p) = K Im e^(2 pi i F.(p - (x_0, y_0))) sum_j h(y - y_j) e^(-i v j) sum_k h(x - x_k) e^(-i u k) A_kj.
//
// After [TNVT19] Tavernier, Neyret, Vergne, Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019.

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Hashes a word; each salt gives a different sequence. The constants are from the hash-prospector project.
uint gabor_impl_mix(uint word, uint salt) {
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

uint gabor_lobe_seed(uint seed, int index) {
    return gabor_impl_mix(seed + uint(index) * 0x85ebca6bu, 0x9e3779b1u);
}

#define GABOR_IMPL_ROWS 0x5bd1e995u
// The salt of the columns; xor it with GABOR_IMPL_ROWS to get the salt of the rows. With equal salts, the word of node
// (k, k) would be a square.
uint gabor_impl_salt(uint seed) {
    return gabor_impl_mix(seed * 0x9e3779b1u, 0x2545f491u);
}

// The word of a column or row of nodes; a node's word is the product of its column's and its row's. The words of
// columns and rows are odd and have 24 bits, because GPUs multiply such numbers at a quarter of the cost of 32-bit
// numbers. Their highest bit is set, so that products fill all 32 bits. The factor (word ^ (word >> 15)) mixes better
// than a constant: two indices, however far apart, have equal words with probability 2^-22.
uint gabor_impl_line_word(int index, uint salt) {
    uint word = uint(index) * 0x9e3779b1u + salt;
    word = word * (word ^ (word >> 15u));
    return (word >> 8u) | 0x800001u;
}

#define GABOR_IMPL_DEVIATION 1.4599553e27 // standard deviation of each part of an amplitude
// Computes an amplitude from a word: the real part from the whole word, the imaginary part from its low 20 bits. They
// are independent and nearly normal. For u uniform in [-1, 1], the quantiles of (u - 0.893 clamp(u, -0.937, 0.937))
// (1 + 0.623 u^2) are nearly proportional to those of a normal distribution. The noise's Cramer-von Mises index
// [TNVT19] is 0.001 on average. At the worst point, a node, it is 0.03, because 79 % of the power there comes from that
// node's amplitude.
vec2 gabor_impl_amplitude(uint word) {
    vec2 u = vec2(float(int(word)), float(int(word << 12u)));
    return (u - 0.89289313 * clamp(u, -2.0119258e9, 2.0119258e9)) * (u * u + 7.3973916e18);
}

// ---- Waves and windows ---------------------------------------------------------------------------------------------

// The product of two complex numbers.
vec2 gabor_impl_product(vec2 a, vec2 b) {
    return a.x * b + a.y * vec2(-b.y, b.x);
}

// Adds z times a pair of complex numbers to two sums.
void gabor_impl_add(inout vec4 sums, vec4 pair, vec2 z) {
    sums = sums + z.x * pair + z.y * vec4(-pair.y, pair.x, -pair.w, pair.z);
}

// (cos, sin) of 2 pi t for |t| <= 1/4, by minimax polynomials, within 2e-7.
vec2 gabor_impl_half_turn(float t) {
    float s = t * t, r = s * s;
    return vec2((1.0 - 19.739171 * s) + r * ((64.934591 - 85.240337 * s) + 56.24243 * r),
                t * ((6.2831852 - 41.341655 * s) + r * ((81.601004 - 76.549782 * s) + 39.536707 * r)));
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1]; beyond that, the rounding of t adds to the error. After t is
// reduced to [-1/2, 1/2], cos(2 pi t) = sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), where y = 1/4 - |t|.
vec2 gabor_impl_wave(float t) {
    t -= floor(t + 0.5);
    vec2 turn = gabor_impl_half_turn(0.25 - abs(t));
    return vec2(turn.y, t < 0.0 ? -turn.x : turn.x);
}

// Computes the windows of the nodes k = -1, 0, ... along an axis, h = 1/2 + cos(pi (x - k) / R) / 2, and their
// derivatives per kernel radius. x is in node spacings from node 0: in [-1/2, 1/2] for three taps, [0, 1] for four and
// [-1, 0] for two.
#define GABOR_IMPL_ENERGY (GABOR_TAPS == 2 ? 1.0 : 0.375 * float(GABOR_TAPS)) // the sum of the squared windows
void gabor_impl_windows(float x, out vec4 value, out vec4 slope) {
#if GABOR_TAPS == 2
    // The squares of only two shifts of Hann's window do not sum to a constant. So the windows are 1 - s and s, with
    // s = t^2 (3 - 2 t), divided by the root of the sum of their squares. The gradient's variance still varies.
    float t = x + 1.0, s = t * t * (3.0 - 2.0 * t);
    float scale = inversesqrt(1.0 - 2.0 * s * (1.0 - s));
    value = scale * vec4(1.0 - s, s, 0.0, 0.0);
    slope = 6.0 * t * (1.0 - t) * scale * scale * scale * vec4(-s, 1.0 - s, 0.0, 0.0);
#elif GABOR_TAPS == 3
    float y = x * x;
    float c = 0.5 - y * (1.0966099 - y * (0.40054826 - y * 0.05644487)); // cos(2/3 pi x) / 2
    float s = x * (0.90689956 - y * (0.66301124 - y * (0.14532053 - y * 0.01467483))); // sqrt(3)/4 sin(2/3 pi x)
    float a = 0.5 - 0.5 * c;
    float b = 1.8137994 * s;
    value = vec4(a - s, 0.5 + c, a + s, 0.0);
    slope = vec4(b - 2.7206991 * c, -2.0 * b, b + 2.7206991 * c, 0.0);
#else
    // `cosine` and `sine` are the cosine and sine of pi/2 z, times 1/sqrt(8); c and s are those of pi/2 x, times 1/2.
    float z = x - 0.5, y = z * z;
    float cosine = 0.35355339 - y * (0.43617809 - y * (0.089663389 - y * 0.0072217699));
    float sine = z * (0.55536036 - y * (0.22838240 - y * (0.028169684 - y * 0.0016236196)));
    float c = cosine - sine, s = cosine + sine;
    value = 0.5 + vec4(-s, c, s, -c);
    slope = 3.1415927 * vec4(-c, -s, c, s);
#endif
}

// ---- The sum -------------------------------------------------------------------------------------------------------

// Wraps an index into a period.
int gabor_impl_wrap(int index, int period) {
    if (period == 0) return index;
    int within = index - index / period * period;
    return within < 0 ? within + period : within;
}

// The next index, wrapped into a period without a division.
int gabor_impl_next_node(int index, int period) {
    return period == 0 || index + 1 < period ? index + 1 : 0;
}

// The nodes along an axis whose windows reach a point.
struct GaborAxis {
    float offset; // offset of the point from node 0, in node spacings
    float turns;  // turns of the wave from one node to the next
    uint word[4];
    vec4 node[4]; // for node k, e^(-i u k) times the window, and times the window's derivative
};

// `wave` is in cycles per kernel radius, `radius` in nodes per kernel radius.
GaborAxis gabor_impl_axis(int cell, float local, int period, uint salt, float wave, float radius) {
    GaborAxis axis;
    float zero = floor(local + (2.0 - GABOR_RADIUS));
    // The clamp matters only if a compiler fuses the product in `local` with this subtraction.
    axis.offset = clamp(local - zero, GABOR_RADIUS - 2.0, GABOR_RADIUS - 1.0);
    axis.turns = wave / radius;
    int index = gabor_impl_wrap(cell + int(zero) - 1, period);
    axis.word[0] = gabor_impl_line_word(index, salt);
    index = gabor_impl_next_node(index, period);
    axis.word[1] = gabor_impl_line_word(index, salt);
    index = gabor_impl_next_node(index, period);
    axis.word[2] = gabor_impl_line_word(index, salt);
    axis.word[3] = gabor_impl_line_word(gabor_impl_next_node(index, period), salt);
    vec4 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    vec2 turn = gabor_impl_wave(axis.turns);
    vec2 back = vec2(turn.x, -turn.y);
    vec2 twice = gabor_impl_product(back, back);
    axis.node[0] = vec4(value.x * turn, slope.x * turn);
    axis.node[1] = vec4(value.y, 0.0, slope.y, 0.0);
    axis.node[2] = vec4(value.z * back, slope.z * back);
    axis.node[3] = vec4(value.w * twice, slope.w * twice);
    return axis;
}

// The amplitude of a node. If animated, it is a weighted sum of three amplitudes, from the node's word and two words
// derived from it. The squared weights sum to 1; at time 0 the weights are 1, 0, 0.
vec2 gabor_impl_amplitude_at(uint word, bool animated, float time) {
    vec2 amplitude = gabor_impl_amplitude(word);
    if (!animated) return amplitude;
    uint second = (word ^ (word >> 15u)) * 0xd35a2d97u;
    uint third = (second ^ (second >> 15u)) * 0xd35a2d97u;
    vec2 turn = gabor_impl_wave(time);
    return (0.5 + 0.5 * turn.x) * amplitude + (0.5 - 0.5 * turn.x) * gabor_impl_amplitude(second)
         + 0.70710678 * turn.y * gabor_impl_amplitude(third);
}

// Adds row j of nodes to `sum`, weighted by the windows along y, and to `slope`, weighted by the derivatives of these
// windows. In both, xy uses the windows along x, and zw their derivatives. Some compilers do not unroll or vectorize
// loops over nodes and rows, so each node and each row has its own line.
void gabor_impl_add_row(inout vec4 sum, inout vec4 slope, GaborAxis x, GaborAxis y, int j, bool animated, float time) {
    vec4 row = vec4(0.0);
    gabor_impl_add(row, x.node[0], gabor_impl_amplitude_at(x.word[0] * y.word[j], animated, time));
    gabor_impl_add(row, x.node[1], gabor_impl_amplitude_at(x.word[1] * y.word[j], animated, time));
    if (GABOR_TAPS > 2) gabor_impl_add(row, x.node[2], gabor_impl_amplitude_at(x.word[2] * y.word[j], animated, time));
    if (GABOR_TAPS > 3) gabor_impl_add(row, x.node[3], gabor_impl_amplitude_at(x.word[3] * y.word[j], animated, time));
    if ((GABOR_TAPS > 2 && j != 1) || x.offset < 8.0) { // always true, but keeps CPU compilers from spilling registers
        gabor_impl_add(sum, row, y.node[j].xy);
        gabor_impl_add(slope, row, y.node[j].zw);
    }
}

void gabor_impl_sum(GaborAxis x, GaborAxis y, bool animated, float time, out vec4 sum, out vec4 slope) {
    sum = slope = vec4(0.0);
    gabor_impl_add_row(sum, slope, x, y, 0, animated, time);
    gabor_impl_add_row(sum, slope, x, y, 1, animated, time);
    if (GABOR_TAPS > 2) gabor_impl_add_row(sum, slope, x, y, 2, animated, time);
    if (GABOR_TAPS > 3) gabor_impl_add_row(sum, slope, x, y, 3, animated, time);
}

// Multiplies the sums by K and by the wave at the point, whose phase is 0 at node (0, 0). K makes E[n^2] = 1: E[n^2] is
// K^2 / 2 E|A|^2 times the sums of squared windows along x and y. A wave's derivative is the wave times 2 pi i F.
GaborField gabor_impl_field(vec4 sum, vec4 slope, vec2 turn, vec2 wave, vec2 stretch) {
    turn *= 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    vec2 value = gabor_impl_product(sum.xy, turn);
    vec2 turned = 6.2831853 * vec2(-value.y, value.x);
    return GaborField(value, stretch.x * gabor_impl_product(sum.zw, turn) + wave.x * turned,
                      stretch.y * gabor_impl_product(slope.xy, turn) + wave.y * turned);
}

GaborField gabor_field(GaborPlace place, GaborKernel kernel, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, kernel.wave.x, place.radius.x);
    salt ^= GABOR_IMPL_ROWS;
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, kernel.wave.y, place.radius.y);
    vec2 turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    vec4 sum, slope;
    gabor_impl_sum(x, y, place.animated, place.time, sum, slope);
    return gabor_impl_field(sum, slope, turn, kernel.wave, place.radius / GABOR_RADIUS);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborPlace gabor_place(ivec2 cell, vec2 local) {
    return GaborPlace(cell, local, vec2(GABOR_RADIUS), ivec2(0), false, 0.0);
}

GaborPlace gabor_place_tiled(vec2 p, vec2 period) {
    vec2 nodes = max(floor(period * GABOR_RADIUS + 0.5), vec2(float(GABOR_TAPS)));
    GaborPlace place = gabor_place(ivec2(0), vec2(0.0));
    place.radius = vec2(period.x > 0.0 ? nodes.x / period.x : GABOR_RADIUS,
                        period.y > 0.0 ? nodes.y / period.y : GABOR_RADIUS);
    place.period = ivec2(period.x > 0.0 ? int(nodes.x) : 0, period.y > 0.0 ? int(nodes.y) : 0);
    place.local = p * place.radius;
    return place;
}

GaborKernel gabor_kernel(float frequency, float orientation) {
    return GaborKernel(min(abs(frequency), 1.0e6) * gabor_impl_wave(0.15915494 * clamp(orientation, -1.0e6, 1.0e6)));
}

GaborKernel gabor_kernel_wave(vec2 wave) {
    return GaborKernel(clamp(wave, -1.0e6, 1.0e6));
}

float gabor_noise_at(ivec2 cell, vec2 local, GaborKernel kernel, uint seed) {
    return gabor_field(gabor_place(cell, local), kernel, seed).value.y;
}

float gabor_noise(vec2 p, float frequency, float orientation, uint seed) {
    return gabor_noise_at(ivec2(0), p * GABOR_RADIUS, gabor_kernel(frequency, orientation), seed);
}

vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, uint seed) {
    GaborField field = gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed);
    return vec3(field.value.y, field.slope_x.y, field.slope_y.y);
}

vec2 gabor_noise_complex(vec2 p, float frequency, float orientation, uint seed) {
    return gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel(frequency, orientation), seed).value;
}

vec4 gabor_noise_four(vec2 p, float frequency, float orientation, uint seed) {
    return vec4(gabor_noise(p, frequency, orientation, seed),
                gabor_noise(p, frequency, orientation, gabor_lobe_seed(seed, -1)),
                gabor_noise(p, frequency, orientation, gabor_lobe_seed(seed, -2)),
                gabor_noise(p, frequency, orientation, gabor_lobe_seed(seed, -3)));
}

vec2 gabor_phasor(vec2 value) {
    float intensity = length(value);
    float phase = intensity > 0.0 ? atan(value.y, value.x) * 0.15915494 : 0.0;
    return vec2(phase < 0.0 ? min(phase + 1.0, 0.99999994) : phase, intensity);
}

float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, uint seed) {
    GaborPlace place = gabor_place_tiled(p, clamp(period, 0.0009765625, 1.0e9));
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

float gabor_noise_animated(vec2 p, float time, float frequency, float orientation, uint seed) {
    GaborPlace place = GaborPlace(ivec2(0), p * GABOR_RADIUS, vec2(GABOR_RADIUS), ivec2(0), true, time);
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).value.y;
}

float gabor_noise_wave(vec2 p, vec2 wave, uint seed) {
    return gabor_noise_at(ivec2(0), p * GABOR_RADIUS, gabor_kernel_wave(wave), seed);
}

vec3 gabor_noise_wave_gradient(vec2 p, vec2 wave, uint seed) {
    GaborField field = gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel_wave(wave), seed);
    return vec3(field.value.y, field.slope_x.y, field.slope_y.y);
}

vec2 gabor_noise_wave_complex(vec2 p, vec2 wave, uint seed) {
    return gabor_field(gabor_place(ivec2(0), p * GABOR_RADIUS), gabor_kernel_wave(wave), seed).value;
}

float gabor_noise_wave_tiled(vec2 p, vec2 period, vec2 wave, uint seed) {
    GaborPlace place = gabor_place_tiled(p, clamp(period, 0.0009765625, 1.0e9));
    return gabor_field(place, gabor_kernel_wave(wave), seed).value.y;
}

vec3 gabor_stripes_of(vec2 value, float sharpness) {
    float intensity = length(value);
    return vec3(sharpness / max(sharpness * intensity, 1.0) * value, intensity);
}

vec3 gabor_stripes_at(GaborPlace place, vec2 wave, float sharpness, uint seed) {
    return gabor_stripes_of(gabor_field(place, gabor_kernel_wave(wave), seed).value, sharpness);
}

vec3 gabor_stripes(vec2 p, vec2 wave, float sharpness, uint seed) {
    return gabor_stripes_at(gabor_place(ivec2(0), p * GABOR_RADIUS), wave, sharpness, seed);
}

vec3 gabor_stripes_tiled(vec2 p, vec2 period, vec2 wave, float sharpness, uint seed) {
    GaborPlace place = gabor_place_tiled(p, clamp(period, 0.0009765625, 1.0e9));
    return gabor_stripes_at(place, wave, sharpness, seed);
}

float gabor_unorm(float noise) {
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

#endif // GABOR_NOISE_GLSL
// ---- gabor_erosion.glsl unchanged ----
// gabor_erosion.glsl: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
// Paste or include this file after gabor_noise.glsl.
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height and slope
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_GLSL
#error Include gabor_noise.glsl before gabor_erosion.glsl
#endif
#ifndef GABOR_EROSION_GLSL
#define GABOR_EROSION_GLSL

// A height in units of p, its derivatives, and a ridge value from -1 in creases and valleys to 1 on ridges and peaks.
struct GaborTerrain {
    float height;
    vec2 slope;
    float ridge;
};

struct GaborErosion {
    int octaves;           // octaves of gullies, 0 to 16, each about as costly as gabor_noise_gradient
    float frequency;       // gullies per unit of p in the first octave, 0.001 to 10000
    float strength;        // depth of gullies times their frequency, 0 to 10: how steep they are
    float lacunarity;      // frequency relative to the previous octave, 1 to 8
    float gain;            // depth relative to the previous octave, 0 to 2: 1 / lacunarity keeps slopes equal
    float onset;           // slope at which gullies reach their full depth, 10^-6 to 100
    float detail;          // how far fine gullies reach into creases, ridges and flat areas, 0.1 to 100
    float uniformity;      // how uniform the depths of gullies are, 0 to 100: 1 for natural variety, 4 for even stripes
    float ridge_rounding;  // width of rounded ridges, 0 to 10 radians of the first octave's phase, 0 for sharp ridges
    float crease_rounding; // the same for creases
    float gully_weight;    // depth of gullies, relative to how far peaks rise and valleys sink, 0 to 1
    float branching;       // how much of a gully's slope turns finer gullies, 0 to 10: 0 for none, 1 for all of it
};

// GaborErosion gabor_erosion()
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// GaborTerrain gabor_terrain(vec2 p, uint seed)
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.6 and continuous curvature.

// GaborTerrain gabor_eroded(vec2 p, GaborTerrain base, GaborErosion erosion, uint seed)
//     Adds gullies and ridges to the base at p. Where the base is flat, base.ridge distinguishes valleys, -1, from
//     peaks, 1. The height is continuous where the base and its slope are, and the result can be eroded again. The
//     returned slope takes only the phase of the gullies into account, not how they turn and fade: its rms error is
//     0.63 times the rms slope.

// GaborTerrain gabor_terrain_filtered(vec2 p, vec2 dx, vec2 dy, uint seed)
// GaborTerrain gabor_eroded_filtered(vec2 p, vec2 dx, vec2 dy, GaborTerrain base, GaborErosion erosion, uint seed)
//     The same without features that are too fine for a pixel; the mean height does not change. dx and dy are dFdx(p)
//     and dFdy(p).

// GaborTerrain gabor_terrain_tiled(vec2 p, vec2 period, uint seed)
// GaborTerrain gabor_eroded_tiled(vec2 p, vec2 period, GaborTerrain base, GaborErosion erosion, uint seed)
//     The same with an exact period along x and y, at least 4 units of p. Integer periods do not change the width of
//     the hills.

struct GaborTerrainPlace { // the position cell + local
    ivec2 cell;  // any integers: the world wraps around after 2^32 cells along each axis
    vec2 local;  // most precise in [0, 1)^2
    vec2 period; // 0 for none. With a period, cell + local is rounded to a float
};

// GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, vec2 dx, vec2 dy, uint seed)
// GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, vec2 dx, vec2 dy, GaborTerrain base, GaborErosion erosion,
//                              uint seed)
//     The same with a period, a filter (unless dx and dy are vec2(0.0)), or both. Without a period, the result is
//     precise at any distance from the origin.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice with about `nodes` nodes per unit of p. This number is rounded to a multiple of 1 / 65536, so
// that its product with the cell splits exactly into integer and fraction. The place's `radius` is in nodes per unit of
// p, so that wave vectors and derivatives are per unit of p.
GaborPlace gabor_impl_ground(GaborTerrainPlace ground, float nodes) {
    uint rounded = uint(clamp(nodes, 1.0e-4, 3.0e4) * 65536.0 + 0.5);
    GaborPlace place = gabor_place(ivec2(0), vec2(0.0));
    place.radius = vec2(float(rounded) / 65536.0);
    uvec2 low = (uvec2(ground.cell) & uvec2(0xffffu)) * (rounded & 0xffffu);
    uvec2 high = uvec2(ground.cell) * (rounded >> 16u) + uvec2(ground.cell >> ivec2(16)) * (rounded & 0xffffu);
    place.cell = ivec2(high + (low >> uvec2(16u)));
    place.local = vec2(low & uvec2(0xffffu)) / 65536.0 + ground.local * place.radius;
    if (ground.period.x <= 0.0 && ground.period.y <= 0.0) return place;
    place.period = ivec2(max(floor(ground.period * place.radius + 0.5), 4.0));
    if (ground.period.x > 0.0) place.radius.x = float(place.period.x) / ground.period.x; else place.period.x = 0;
    if (ground.period.y > 0.0) place.radius.y = float(place.period.y) / ground.period.y; else place.period.y = 0;
    place.cell = ivec2(0);
    place.local = (vec2(ground.cell) + ground.local) * place.radius;
    return place;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
void gabor_impl_splines(float t, out vec4 value, out vec4 slope) {
    float u = 1.0 - t;
    value = vec4(u * u * u, 4.0 - 3.0 * t * t * (1.0 + u), 4.0 - 3.0 * u * u * (1.0 + t), t * t * t) / 6.0;
    slope = 0.5 * vec4(-u * u, t * (3.0 * t - 4.0), u * (4.0 - 3.0 * u), t * t);
}

uvec4 gabor_impl_four_line_words(int index, int period, uint salt) {
    int first = gabor_impl_wrap(index - 1, period);
    int second = gabor_impl_next_node(first, period);
    int third = gabor_impl_next_node(second, period);
    return uvec4(gabor_impl_line_word(first, salt), gabor_impl_line_word(second, salt), gabor_impl_line_word(third, salt),
                 gabor_impl_line_word(gabor_impl_next_node(third, period), salt));
}

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises.
void gabor_impl_add_hills(inout GaborField sum, uvec4 words, vec4 x, vec4 slope_x, float y, float slope_y) {
    vec4 a = vec4(ivec4(words)), b = vec4(ivec4(words << 16u));
    vec2 row = vec2(dot(x, a), dot(x, b));
    sum.value += y * row;
    sum.slope_x += y * vec2(dot(slope_x, a), dot(slope_x, b));
    sum.slope_y += slope_y * row;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, vec2 dx, vec2 dy, uint seed) {
    GaborPlace place = gabor_impl_ground(ground, 1.0);
    vec2 zero = floor(place.local);
    vec4 x, y, slope_x, slope_y;
    gabor_impl_splines(place.local.x - zero.x, x, slope_x);
    gabor_impl_splines(place.local.y - zero.y, y, slope_y);
    uint salt = gabor_impl_salt(seed);
    uvec4 columns = gabor_impl_four_line_words(place.cell.x + int(zero.x), place.period.x, salt);
    uvec4 rows = gabor_impl_four_line_words(place.cell.y + int(zero.y), place.period.y, salt ^ GABOR_IMPL_ROWS);
    GaborField hills = GaborField(vec2(0.0), vec2(0.0), vec2(0.0));
    gabor_impl_add_hills(hills, columns * rows.x, x, slope_x, y.x, slope_y.x);
    gabor_impl_add_hills(hills, columns * rows.y, x, slope_x, y.y, slope_y.y);
    gabor_impl_add_hills(hills, columns * rows.z, x, slope_x, y.z, slope_y.z);
    gabor_impl_add_hills(hills, columns * rows.w, x, slope_x, y.w, slope_y.w);
    vec4 s = clamp(vec4(dx, dy), -1.0e9, 1.0e9);
    float area = s.x * s.w - s.y * s.z;
    float kept = inversesqrt(1.0 + 0.34768212 * dot(s, s) + 0.12088286 * area * area);
    float unit = 1.6825360e-9 * kept; // 315 / 151 sqrt(3) / 2^31: variance 1
    vec2 noise = unit * hills.value, wave = exp(3.1582734 * (kept * kept - 1.0)) * gabor_impl_wave(0.4 * noise.y);
    float rough = 0.3 + 0.12 * noise.x, height = noise.x + rough * wave.y;
    vec2 factors = 0.33 * unit * vec2(1.0 + 0.12 * wave.y, 2.5132741 * rough * wave.x);
    vec2 slope = place.radius * vec2(dot(factors, hills.slope_x), dot(factors, hills.slope_y));
    return GaborTerrain(0.33 * height, slope, height * inversesqrt(1.0 + height * height));
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded.
float gabor_impl_mask(float t, float rounding) {
    float s = 1.0 - min(t < rounding ? 0.5 * t * t / rounding : t - 0.5 * rounding, 1.0);
    return 1.0 - s * s;
}

// Where the mask m of an octave is below 1, its gullies, of weight w, fade into those of the previous octave:
//     t_i = (1 - m_i) t_(i-1) + m_i w cos(phase_i),   height = base + sum_i depth_i t_i.
// m_i is 0 where the slope that its gullies follow is 0, and m_(i+1) is 0 where sin(phase_i) is 0: finer gullies end on
// ridges and in creases. To turn finer gullies, each side of a gully adds a constant to the slope that they follow. The
// constant differs between the two sides, but the sides meet where the mask of the finer gullies is 0. If an octave is
// too fine for the pixel, its cosine is replaced by its mean, 0, and the next mask uses the mean of |sin(phase)|.
GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, vec2 dx, vec2 dy, GaborTerrain base, GaborErosion erosion, uint seed) {
    GaborTerrain terrain = base;
    GaborTerrain gully = GaborTerrain(base.ridge, vec2(0.0), base.ridge); // t_i, its slope, and t_i with w = 1
    vec2 steer = base.slope;
    float frequency = erosion.frequency, depth = erosion.strength / erosion.frequency;
    float mask = 1.0, rounding = mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * base.ridge);
    for (int i = 0; i < erosion.octaves; ++i) {
        float steep = max(length(steer), 1.0e-9), full = gabor_impl_mask(steep / max(erosion.onset, 1.0e-6), rounding);
        mask *= full * full;
        vec2 wave = frequency / steep * vec2(-steer.y, steer.x);
        vec2 steps = vec2(dot(wave, dx), dot(wave, dy));
        // The share of a wave that a Gaussian filter of standard deviation half a pixel keeps; small shares are 0.
        float kept = max(1.02 * exp(-4.9348022 * dot(steps, steps)) - 0.02, 0.0);
        vec2 z = vec2(0.0);
        if (kept > 0.0) {
            GaborPlace place = gabor_impl_ground(ground, 0.8 * GABOR_RADIUS * frequency); // 1.25 gullies per radius
            z = erosion.uniformity * gabor_field(place, GaborKernel(wave), gabor_lobe_seed(seed, i)).value;
            z *= kept * inversesqrt(1.0 + dot(z, z)); // brings the length of z near `kept`, except where waves cancel
        }
        gully.height = mix(gully.height, erosion.gully_weight * z.x, mask);
        gully.slope = mix(gully.slope, -6.2831853 * erosion.gully_weight * z.y * wave, mask);
        gully.ridge = mix(gully.ridge, z.x, mask);
        terrain.height += depth * gully.height;
        terrain.slope += depth * gully.slope;
        float side = (z.y < 0.0 ? -6.2831853 : 6.2831853) * kept * erosion.branching * erosion.gully_weight;
        steer -= side * depth * mask * wave;
        rounding = mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * z.x);
        mask = mask * erosion.detail / (1.0 + mask * (erosion.detail - 1.0))
             * gabor_impl_mask(0.5 - 0.5 * kept + abs(z.y), rounding * frequency / erosion.frequency);
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return GaborTerrain(terrain.height, terrain.slope, gully.ridge);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborErosion gabor_erosion() {
    return GaborErosion(5, 1.5, 0.12, 2.0, 0.5, 0.5, 1.5, 2.0, 0.1, 0.1, 0.5, 1.0);
}

GaborTerrain gabor_terrain_filtered(vec2 p, vec2 dx, vec2 dy, uint seed) {
    return gabor_terrain_at(GaborTerrainPlace(ivec2(0), p, vec2(0.0)), dx, dy, seed);
}

GaborTerrain gabor_terrain(vec2 p, uint seed) {
    return gabor_terrain_filtered(p, vec2(0.0), vec2(0.0), seed);
}

GaborTerrain gabor_terrain_tiled(vec2 p, vec2 period, uint seed) {
    return gabor_terrain_at(GaborTerrainPlace(ivec2(0), p, period), vec2(0.0), vec2(0.0), seed);
}

GaborTerrain gabor_eroded_filtered(vec2 p, vec2 dx, vec2 dy, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_at(GaborTerrainPlace(ivec2(0), p, vec2(0.0)), dx, dy, base, erosion, seed);
}

GaborTerrain gabor_eroded(vec2 p, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_filtered(p, vec2(0.0), vec2(0.0), base, erosion, seed);
}

GaborTerrain gabor_eroded_tiled(vec2 p, vec2 period, GaborTerrain base, GaborErosion erosion, uint seed) {
    return gabor_eroded_at(GaborTerrainPlace(ivec2(0), p, period), vec2(0.0), vec2(0.0), base, erosion, seed);
}

#endif // GABOR_EROSION_GLSL
// ---- your code ----

const uint seed = 5u;
const float water = -0.42;
const vec3 sun = vec3(-0.80, 0.38, -0.46);

// The ground at p, without gullies that are too fine for a pixel of width `pixel`.
GaborTerrain ground(vec2 p, float pixel) {
    GaborErosion erosion = gabor_erosion();
    erosion.octaves = 7;
    erosion.detail = 3.0;
    return gabor_eroded_filtered(p, vec2(pixel, 0.0), vec2(0.0, pixel), gabor_terrain(p, seed), erosion, seed);
}

// A lower bound on a point's height above the ground. Erosion adds at most 0.16 to the hills, which are cheap to compute.
float clearance(vec3 at, float pixel) {
    float above = at.y - gabor_terrain(at.xz, seed).height;
    return above > 0.24 ? above - 0.16 : at.y - ground(at.xz, pixel).height;
}

// The distance at which the ray meets the ground, or -1. Steps grow with the height above the ground and the distance.
float march(vec3 eye, vec3 ray, float pixel) {
    float t = 0.02, before = t;
    for (int i = 0; i < 160 && t < 40.0; ++i) {
        vec3 at = eye + t * ray;
        if (at.y > 1.6 && ray.y > 0.0) break;
        float above = clearance(at, pixel * t);
        if (above < 0.0) { // the ground is between the last two steps: bisect
            for (int j = 0; j < 6; ++j) {
                float middle = 0.5 * (before + t);
                vec3 there = eye + middle * ray;
                if (there.y > ground(there.xz, pixel * middle).height) before = middle; else t = middle;
            }
            return t;
        }
        before = t;
        t += max(0.42 * above, pixel * t);
    }
    return -1.0;
}

// The visible share of the sun. The ground that hides it has about two octaves of erosion; shadows have soft edges.
float sunlight(vec3 at) {
    float light = 1.0, t = 0.03;
    for (int i = 0; i < 18 && light > 0.0; ++i) {
        vec3 there = at + t * sun;
        float above = there.y - ground(there.xz, 0.12).height;
        light = min(light, 0.5 + 12.0 * above / t);
        t += clamp(0.7 * above, 0.03, 0.5);
    }
    return smoothstep(0.0, 1.0, clamp(light, 0.0, 1.0));
}

vec3 sky(vec3 ray) {
    float up = max(ray.y, 0.0), toward = max(dot(ray, sun), 0.0);
    vec3 color = mix(vec3(0.50, 0.58, 0.66), vec3(0.08, 0.20, 0.46), 1.0 - exp(-5.0 * up));
    float glow = 0.35 * pow(toward, 8.0) + 0.6 * pow(toward, 200.0) + 4.0 * pow(toward, 3000.0);
    return color + vec3(1.0, 0.68, 0.36) * glow;
}

// The colour of rock, grass, scree or snow, depending on height, slope and ridge.
vec3 colour(vec3 at, vec3 normal, float ridge) {
    vec3 color = mix(vec3(0.24, 0.19, 0.15), vec3(0.34, 0.31, 0.28), smoothstep(-0.2, 0.6, at.y + 0.2 * ridge));
    float grass = smoothstep(0.62, 0.85, normal.y) * smoothstep(0.30, -0.05, at.y + 0.08 * ridge);
    color = mix(color, mix(vec3(0.08, 0.11, 0.045), vec3(0.20, 0.20, 0.085), 0.5 + 0.5 * ridge), grass);
    color = mix(color, vec3(0.36, 0.33, 0.27), 0.5 * smoothstep(-0.3, -0.9, ridge) * (1.0 - grass));
    color = mix(color, vec3(0.46, 0.42, 0.32), smoothstep(water + 0.025, water + 0.005, at.y));
    float snow = smoothstep(0.30, 0.55, at.y - 0.12 * ridge) * smoothstep(0.50, 0.75, normal.y);
    return mix(color, vec3(0.86, 0.89, 0.93), snow);
}

vec3 lit(vec3 at, float pixel) {
    float w = max(pixel, 0.0008);
    GaborTerrain here = ground(at.xz, pixel);
    float x = ground(at.xz + vec2(w, 0.0), pixel).height, z = ground(at.xz + vec2(0.0, w), pixel).height;
    vec3 normal = normalize(vec3(here.height - x, w, here.height - z));
    float open = 0.65 + 0.35 * here.ridge; // creases see less of the sky
    vec3 light = 2.3 * vec3(1.0, 0.80, 0.58) * max(dot(normal, sun), 0.0) * sunlight(at + 0.004 * normal)
               + open * mix(vec3(0.10, 0.08, 0.06), vec3(0.17, 0.25, 0.40), 0.5 + 0.5 * normal.y);
    return colour(at, normal, here.ridge) * light;
}

void mainImage(out vec4 color, vec2 pixel) {
    vec2 screen = (2.0 * pixel - iResolution.xy) / iResolution.y;
    float time = 0.12 * iTime;
    vec2 turn = iMouse.z > 0.0 ? (iMouse.xy / iResolution.xy - 0.5) * vec2(6.2831853, 1.2) : vec2(0.0);
    vec3 eye = vec3(3.0 * sin(0.31 * time) - 0.6, 0.0, 0.8 - 2.0 * time);
    for (int i = -1; i <= 3; ++i) { // keeps the eye above the ground ahead
        float hills = gabor_terrain(eye.xz - vec2(0.0, 0.5 * float(i)), seed).height;
        eye.y = max(eye.y, hills + 0.45);
    }
    float heading = 0.5 * sin(0.23 * time) + turn.x, pitch = -0.16 + turn.y;
    vec3 ahead = vec3(sin(heading) * cos(pitch), sin(pitch), -cos(heading) * cos(pitch));
    vec3 right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0)));
    vec3 ray = normalize(1.6 * ahead + screen.x * right + screen.y * cross(right, ahead));
    float wide = 1.25 / iResolution.y; // a pixel at distance 1
    float t = march(eye, ray, wide), wet = (water - eye.y) / ray.y;
    vec3 view = sky(ray);
    if (wet > 0.0 && (t < 0.0 || wet < t) && wet < 40.0) {
        vec3 at = eye + wet * ray;
        vec2 waves = 0.004 * exp(-0.3 * wet) * gabor_noise_gradient(30.0 * at.xz + 0.2 * iTime, 1.0, 0.6, seed).yz;
        vec3 normal = normalize(vec3(waves.x, 1.0, waves.y));
        vec3 mirror = reflect(ray, normal);
        mirror.y = abs(mirror.y);
        float back = march(at + vec3(0.0, 0.002, 0.0), mirror, 8.0 * wide);
        vec3 seen = back > 0.0 ? lit(at + back * mirror, 16.0 * wide * back) : sky(mirror);
        float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(normal, -ray), 0.0), 5.0);
        view = mix(vec3(0.03, 0.07, 0.08), seen, clamp(fresnel, 0.0, 1.0));
        t = wet;
    } else if (t > 0.0)
        view = lit(eye + t * ray, wide * t);
    if (t > 0.0) view = mix(sky(normalize(vec3(ray.x, max(ray.y, 0.02), ray.z))), view, exp(-0.0018 * t * t - 0.012 * t));
    view = view * (2.51 * view + 0.03) / (view * (2.43 * view + 0.59) + 0.14); // tone mapping [Narkowicz 2015]
    color = vec4(pow(clamp(view, 0.0, 1.0), vec3(0.4545)), 1.0);
}
