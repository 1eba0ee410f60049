// gabor_noise.glsl: Gabor noise in the plane, with mean 0, variance 1 and a normal distribution at every point.
//
// Paste or include this file after `#version`: GLSL 130 to 460, or 300 es. It declares no resources, and every name it
// adds begins with gabor_, Gabor or GABOR_. Names with impl or Impl are private.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//
//     I want                                   call
//     noise                                    gabor_noise(p, frequency, orientation, seed)
//     its derivatives                          gabor_noise_gradient
//     a texture that repeats                   gabor_noise_tiled
//     noise that evolves in place              gabor_noise_animated
//     stripes along any directions             gabor_stripes
//     a phase, for patterns of my own          gabor_turns_intensity(gabor_noise_quadrature(...))
//     a value in [0, 1], or a share of area    gabor_uniform
//     to display it                            gabor_unorm
//     a huge world, or any of these together   a place, then gabor_field
//
// Values are normal up to three standard deviations. Values beyond 3.5 are 13 % too rare overall, and 56 % too rare at
// the nodes of the lattice.
//
// Arguments of all functions:
//     p            position in kernel radii, |p| < 2^31 / GABOR_CELLS_PER_RADIUS. Float rounding shows earlier: at
//                  10^5, p has steps of 0.008. Each wave fades out within one kernel radius of its node.
//     frequency    cycles per kernel radius, up to 10^6; the sign is ignored
//     orientation  direction of the wave vector, in radians from +x towards +y. At frequency 4, rounding adds an error
//                  of up to 2.4e-6 to the noise for each radian.
//     wave         wave vector in cycles per kernel radius, up to 10^6 along each axis. It replaces frequency and
//                  orientation: gabor_wave_vector converts them. (0, 0) gives noise of frequency 0.
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
#define GABOR_NOISE_GLSL 1
// 10000 major + 100 minor + patch
#define GABOR_NOISE_VERSION 30000

#if __VERSION__ > 0 && __VERSION__ < 130
// Here naga has 0, and Babylon.js 200 for WebGL 2.
#error gabor_noise.glsl needs GLSL 130 or GLSL ES 300, which is WebGL 2
#elif defined(GL_ES)
precision highp float;
precision highp int;
#endif

// Quality: each point sums GABOR_TAPS^2 waves. To change GABOR_TAPS, define it before this file. 2 is fastest, but
// shows columns and rows at high frequencies, and at nodes its values end at 2.89, with a Cramer-von Mises index of
// 6.1. The covariance of two points deviates from its mean over positions by up to 5.6 % of the variance with 3 taps,
// and by 1.5 % with 4; positions differ by up to twice as much.
#ifndef GABOR_TAPS
#define GABOR_TAPS 3
#endif
#if GABOR_TAPS < 2 || GABOR_TAPS > 4
#error GABOR_TAPS must be 2, 3 or 4
#endif

// float gabor_noise(vec2 p, float frequency, float orientation, uint seed)
// float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, uint seed)
//     The noise, with continuous first derivatives.

// float gabor_noise_animated(vec2 p, float evolution, float frequency, float orientation, uint seed)
//     Noise that evolves in place and repeats when `evolution` grows by 1; 0 gives gabor_noise. Values t apart have the
//     correlation cos^2(pi t). Costs about twice as much as gabor_noise. Pass the fraction of a large evolution: a
//     float has so few digits at 1000 that the noise errs by 4e-4.

// vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, uint seed)
//     (noise, d/dx, d/dy). The derivatives are per kernel radius, for a constant wave vector.

// vec2 gabor_noise_quadrature(vec2 p, float frequency, float orientation, uint seed)
//     (noise, quadrature). The quadrature is the same waves with cosines instead of sines: the two are the imaginary
//     and the real part of a complex noise. At each point they are independent and have variance 1.

// vec2 gabor_turns_intensity(vec2 noise_quadrature)
//     (phase in turns within [0, 1), intensity) of what gabor_noise_quadrature returns. A profile of the phase, such as
//     step(phase, width), is a pattern of even contrast [Tricard et al., Procedural phasor noise, 2019].

// vec3 gabor_stripes(vec2 p, vec2 wave, float sharpness, uint seed)
//     Stripes of even contrast, at right angles to the wave vector: (cosine, sine, intensity). Sharpness is 0 to 10^6;
//     2 is a good value. If z is the complex noise, the intensity is |z|, and (cosine, sine) is z / |z| where |z|
//     exceeds 1 / sharpness. Elsewhere it is sharpness times z, so stripes fade where they fork.

// float gabor_unorm(float noise)
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// float gabor_uniform(float noise)
// float gabor_uniform_slope(float noise)
//     The noise's rank among all values, uniform in [0, 1], within 2e-5: gabor_uniform(n) < 0.3 is 30 % of the area.
//     And the derivative of the rank by the noise, the density of the normal distribution.

// uint gabor_derived_seed(uint seed, int index)
//     The seed of part `index` of anything made of independent noises, such as octaves, which need a seed each: with
//     one seed, frequencies 4 and 8 have a correlation of 0.63 to 0.95 at nodes of the lattice.

// ---- Any position, wave vector, period and evolution ----------------------------------------------------------------

// Cells of the lattice, from node to node, per kernel radius.
#define GABOR_CELLS_PER_RADIUS (0.5 * float(GABOR_TAPS))

// A position in node spacings of the lattice, with a period and an evolution.
struct GaborPlace {
    ivec2 cell;   // any integers except the last few before 2^31, where the world wraps around
    vec2 local;   // offset from that cell's corner in node spacings, most precise in [0, 1)^2
    vec2 cells_per_radius; // along each axis: GABOR_CELLS_PER_RADIUS, or slightly different to fit a period
    ivec2 period; // period in nodes, 0 for none
    float evolution; // as in gabor_noise_animated, in turns. Set it after calling a constructor, which sets 0
};

// GaborPlace gabor_place_at(vec2 p)
//     The position p, in kernel radii.

// GaborPlace gabor_place(ivec2 cell, vec2 local)
//     The position (cell + local) / GABOR_CELLS_PER_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells
//     along each axis.

// GaborPlace gabor_place_tiled(vec2 p, vec2 period)
//     The position p in noise that repeats after `period` kernel radii; an axis whose period is 0 is endless. A
//     period holds a whole number of nodes, from GABOR_TAPS to 2^31. Opposite edges differ by up to 1.5e-4 where a
//     compiler contracts multiplications and additions.

// A position in node spacings of the lattice, with a period and an evolution: see GaborPlace.
struct GaborPlace3d {
    ivec3 cell;
    vec3 local;
    vec3 cells_per_radius;
    ivec3 period;
    float evolution;
};

// GaborPlace3d gabor_place_3d_at(vec3 p)
// GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local)
// GaborPlace3d gabor_place_3d_tiled(vec3 p, vec3 period)
//     Like gabor_place_at, gabor_place and gabor_place_tiled.

// vec2 gabor_wave_vector(float frequency, float orientation)
//     The wave vector with a frequency and orientation; their ranges are those of gabor_noise.

// A noise, its quadrature, and their gradients per kernel radius: see gabor_noise_quadrature. Unused members cost
// nothing.
struct GaborField {
    float noise;
    vec2 gradient;
    float quadrature;
    vec2 quadrature_gradient;
    float removed; // share of the variance that a filter removed, 0 without one: see gabor_filter.glsl
};

// GaborField gabor_field(GaborPlace place, vec2 wave, uint seed)
//     The noise at `place`. All other functions call it.

// vec3 gabor_stripes_of(GaborField field, float sharpness)
//     The stripes of any noise, like gabor_stripes. If a filter removed variance, each value is its mean over what was
//     removed, within 0.1: (cosine, sine) gets shorter, and its profiles fade to their mean.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// The nodes (x_k, y_j) of a square lattice with R = GABOR_CELLS_PER_RADIUS nodes per kernel radius have independent,
// normal, complex amplitudes A_kj. Each node emits a wave under a window that ends one kernel radius away along both
// axes:
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
// derivatives jump where windows end, midway between nodes for 3 taps and at nodes for 4: along the wave by 0.14 of
// their standard deviation at frequency 1, across it and at frequency 0 by 1.15. The noise is normal because sums of
// independent normal variables are normal.
//
// Each wave's phase starts at its own node, so the wave vector F may vary with the position. From one node to the next,
// the phase turns by u = 2 pi F_x / R along x and v = 2 pi F_y / R along y. If node (0, 0) is next to p, the sum
// separates into one sum per axis:
//
//     n(p) = K Im e^(2 pi i F.(p - (x_0, y_0))) sum_j h(y - y_j) e^(-i v j) sum_k h(x - x_k) e^(-i u k) A_kj.
//
// After [TNVT19] Tavernier, Neyret, Vergne, Thollot: Making Gabor Noise Fast and Normalized, Eurographics 2019.

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Hashes a word; each salt gives a different sequence. The constants are from the hash-prospector project.
uint gabor_impl_mix(uint word, uint salt) {
    uint once = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    uint twice = (once ^ (once >> 15u)) * 0xd35a2d97u;
    return twice ^ (twice >> 15u);
}

uint gabor_derived_seed(uint seed, int index) {
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
    return ((word * (word ^ (word >> 15u))) >> 8u) | 0x800001u;
}

// Like GABOR_IMPL_ROWS, for slices.
#define GABOR_IMPL_SLICES 0x27d4eb2fu

// The word of a row in a slice of nodes: odd with 24 bits, like the words of lines.
uint gabor_impl_slice_word(uint row, uint slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// The standard deviation of each part of an amplitude.
#define GABOR_IMPL_DEVIATION 1.4599553e27

// Computes an amplitude from a word: the real part from the whole word, the imaginary part from its low 20 bits. They
// are independent and nearly normal. For u uniform in [-1, 1], the quantiles of (u - 0.893 clamp(u, -0.937, 0.937))
// (1 + 0.623 u^2) are nearly proportional to those of a normal distribution. The noise's Cramer-von Mises index
// [TNVT19] is 0.002 on average. At the worst point, a node, it is 0.03, because 79 % of the power there comes from that
// node's amplitude.
vec2 gabor_impl_amplitude(uint word) {
    vec2 u = vec2(float(int(word)), float(int(word << 12u)));
    // fit: see tools/constants.py
    return (u - 0.89289313 * clamp(u, -2.0119258e9, 2.0119258e9)) * (u * u + 7.3973916e18);
}

// Derives four more words from a row's word. Multiplied by a column's word, each is as random as a node's own word.
uvec4 gabor_impl_row(uint word) {
    uint first = (word ^ (word >> 15u)) * 0xd35a2d97u;
    uint second = (first ^ (first >> 15u)) * 0xd35a2d97u;
    uint third = (second ^ (second >> 15u)) * 0xd35a2d97u;
    uint fourth = (third ^ (third >> 15u)) * 0xd35a2d97u;
    return uvec4((first >> 8u) | 0x800001u, (second >> 8u) | 0x800001u, (third >> 8u) | 0x800001u,
                 (fourth >> 8u) | 0x800001u);
}

// ---- Waves and windows ---------------------------------------------------------------------------------------------

// The product of two complex numbers.
vec2 gabor_impl_product(vec2 a, vec2 b) {
    return a.x * b + a.y * vec2(-b.y, b.x);
}

// Adds z times a pair of complex numbers to two sums.
void gabor_impl_add_products(inout vec4 sums, vec4 pair, vec2 z) {
    sums = sums + z.x * pair + z.y * vec4(-pair.y, pair.x, -pair.w, pair.z);
}

// (cos, sin) of 2 pi t for |t| <= 1/4, by minimax polynomials, within 2e-7.
vec2 gabor_impl_half_turn(float t) {
    float s = t * t, r = s * s;
    // fits: see tools/constants.py
    return vec2((1.0 - 19.739171 * s) + r * ((64.934591 - 85.240337 * s) + 56.24243 * r),
                t * ((6.2831852 - 41.341655 * s) + r * ((81.601004 - 76.549782 * s) + 39.536707 * r)));
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1]; beyond that, the rounding of t adds to the error. After t is
// reduced to [-1/2, 1/2], cos(2 pi t) = sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), where y = 1/4 - |t|.
vec2 gabor_impl_wave(float t) {
    float within = t - floor(t + 0.5);
    vec2 turn = gabor_impl_half_turn(0.25 - abs(within));
    return vec2(turn.y, within < 0.0 ? -turn.x : turn.x);
}

// The sum of the squared windows.
#define GABOR_IMPL_ENERGY (GABOR_TAPS == 2 ? 1.0 : 0.375 * float(GABOR_TAPS))

// Computes the windows of the nodes k = -1, 0, ... along an axis, h = 1/2 + cos(pi (x - k) / R) / 2, and their
// derivatives per kernel radius. x is in node spacings from node 0: in [-1/2, 1/2] for three taps, [0, 1] for four and
// [-1, 0] for two.
#if GABOR_TAPS == 2
void gabor_impl_windows(float x, out vec4 value, out vec4 slope) {
    // The squares of only two shifts of Hann's window do not sum to a constant. So the windows are 1 - s and s, with
    // s = t^2 (3 - 2 t), divided by the root of the sum of their squares. The gradient's variance still varies.
    float t = x + 1.0, s = t * t * (3.0 - 2.0 * t);
    float scale = inversesqrt(1.0 - 2.0 * s * (1.0 - s));
    value = scale * vec4(1.0 - s, s, 0.0, 0.0);
    slope = 6.0 * t * (1.0 - t) * scale * scale * scale * vec4(-s, 1.0 - s, 0.0, 0.0);
}
#elif GABOR_TAPS == 3
void gabor_impl_windows(float x, out vec4 value, out vec4 slope) {
    float y = x * x;
    // fits: see tools/constants.py
    float c = 0.5 - y * (1.0966099 - y * (0.40054826 - y * 0.05644487)); // cos(2/3 pi x) / 2
    float s = x * (0.90689956 - y * (0.66301124 - y * (0.14532053 - y * 0.01467483))); // sqrt(3)/4 sin(2/3 pi x)
    float a = 0.5 - 0.5 * c;
    float b = 1.8137994 * s; // pi/sqrt(3)
    value = vec4(a - s, 0.5 + c, a + s, 0.0);
    slope = vec4(b - 2.7206991 * c, -2.0 * b, b + 2.7206991 * c, 0.0); // sqrt(3)/2 pi
}
#else
void gabor_impl_windows(float x, out vec4 value, out vec4 slope) {
    // `cosine` and `sine` are the cosine and sine of pi/2 z, times 1/sqrt(8); c and s are those of pi/2 x, times 1/2.
    float z = x - 0.5, y = z * z;
    // fits: see tools/constants.py
    float cosine = 0.35355339 - y * (0.43617809 - y * (0.089663389 - y * 0.0072217699));
    float sine = z * (0.55536036 - y * (0.22838240 - y * (0.028169684 - y * 0.0016236196)));
    float c = cosine - sine, s = cosine + sine;
    value = 0.5 + vec4(-s, c, s, -c);
    slope = 3.1415927 * vec4(-c, -s, c, s); // pi
}
#endif

// The power of a noise that replaces another as x goes from 0 to 1. If the power were x itself, the amplitudes would be
// square roots, with infinite slopes at the ends.
float gabor_impl_takeover(float x) {
    return x * x / (x * x + (1.0 - x) * (1.0 - x));
}

// ---- The sum -------------------------------------------------------------------------------------------------------

// Wraps an index into a period.
int gabor_impl_wrap(int index, int period) {
    if (period != 0) {
        index -= index / max(period, 1) * period; // FXC refuses a division by 0, even one that never runs
        if (index < 0) index += period;
    }
    return index;
}

// The next index, wrapped into a period without a division.
int gabor_impl_next_node(int index, int period) {
    return period == 0 || index + 1 < period ? index + 1 : 0;
}

// The words of four nodes along an axis; the second has the index.
uvec4 gabor_impl_four_line_words(int index, int period, uint salt) {
    int first = gabor_impl_wrap(index - 1, period);
    int second = gabor_impl_next_node(first, period);
    int third = gabor_impl_next_node(second, period);
    return uvec4(gabor_impl_line_word(first, salt), gabor_impl_line_word(second, salt),
                 gabor_impl_line_word(third, salt), gabor_impl_line_word(gabor_impl_next_node(third, period), salt));
}

// The nodes along an axis whose windows reach a point.
struct GaborImplAxis {
    float offset; // offset of the point from node 0, in node spacings
    float turns;  // turns of the wave from one node to the next
    uint word[4];
    vec4 node[4]; // for node k, e^(-i u k) times the window, and times the window's derivative
};

// `wave` is in cycles per kernel radius, `radius` in nodes per kernel radius.
GaborImplAxis gabor_impl_axis(int cell, float local, int period, uint salt, float wave, float radius) {
    GaborImplAxis axis;
    float zero = floor(local + (2.0 - GABOR_CELLS_PER_RADIUS));
    // The clamp matters only if a compiler fuses the product in `local` with this subtraction.
    axis.offset = clamp(local - zero, GABOR_CELLS_PER_RADIUS - 2.0, GABOR_CELLS_PER_RADIUS - 1.0);
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

// The amplitude of a node at an evolution. It is a weighted sum of three amplitudes, from the node's word and two words
// derived from it. The squared weights sum to 1; at evolution 0 the weights are 1, 0, 0. A return within the branch
// would take FXC four times as long through ANGLE.
vec2 gabor_impl_amplitude_at(uint word, float evolution) {
    vec2 amplitude = gabor_impl_amplitude(word);
    if (evolution != 0.0) {
        uint second = (word ^ (word >> 15u)) * 0xd35a2d97u;
        uint third = (second ^ (second >> 15u)) * 0xd35a2d97u;
        vec2 turn = gabor_impl_wave(evolution);
        // 0.70710678 is 1/sqrt(2)
        amplitude = (0.5 + 0.5 * turn.x) * amplitude + (0.5 - 0.5 * turn.x) * gabor_impl_amplitude(second)
                  + 0.70710678 * turn.y * gabor_impl_amplitude(third);
    }
    return amplitude;
}

// The row of nodes whose sums stand behind a test that is always true. The test keeps drivers for CPUs from spilling
// registers, but it would keep C++ from vectorizing: there, no row has it.
#ifdef __cplusplus
#define GABOR_IMPL_TESTED_ROW 4
#else
#define GABOR_IMPL_TESTED_ROW 1
#endif

// Adds row j of nodes to `sum`, weighted by the windows along y, and to `slope`, weighted by the derivatives of these
// windows. In both, xy uses the windows along x, and zw their derivatives. Some compilers do not unroll or vectorize
// loops over nodes and rows, so each node and each row has its own line.
void gabor_impl_add_node_row(inout vec4 sum, inout vec4 slope, GaborImplAxis x, GaborImplAxis y, int j,
                             float evolution) {
    vec4 row = vec4(0.0);
    gabor_impl_add_products(row, x.node[0], gabor_impl_amplitude_at(x.word[0] * y.word[j], evolution));
    gabor_impl_add_products(row, x.node[1], gabor_impl_amplitude_at(x.word[1] * y.word[j], evolution));
    if (GABOR_TAPS > 2)
        gabor_impl_add_products(row, x.node[2], gabor_impl_amplitude_at(x.word[2] * y.word[j], evolution));
    if (GABOR_TAPS > 3)
        gabor_impl_add_products(row, x.node[3], gabor_impl_amplitude_at(x.word[3] * y.word[j], evolution));
    if (j != GABOR_IMPL_TESTED_ROW || x.offset < 8.0) {
        gabor_impl_add_products(sum, row, y.node[j].xy);
        gabor_impl_add_products(slope, row, y.node[j].zw);
    }
}

void gabor_impl_sum(GaborImplAxis x, GaborImplAxis y, float evolution, out vec4 sum, out vec4 slope) {
    sum = slope = vec4(0.0);
    gabor_impl_add_node_row(sum, slope, x, y, 0, evolution);
    gabor_impl_add_node_row(sum, slope, x, y, 1, evolution);
    if (GABOR_TAPS > 2) gabor_impl_add_node_row(sum, slope, x, y, 2, evolution);
    if (GABOR_TAPS > 3) gabor_impl_add_node_row(sum, slope, x, y, 3, evolution);
}

// Multiplies the sums by K and by the wave at the point, whose phase is 0 at node (0, 0). K makes E[n^2] = 1: E[n^2] is
// K^2 / 2 E|A|^2 times the sums of squared windows along x and y. A wave's derivative is the wave times 2 pi i F.
GaborField gabor_impl_field(vec4 sum, vec4 slope, vec2 turn, vec2 wave, vec2 stretch) {
    turn *= 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    vec2 value = gabor_impl_product(sum.xy, turn);
    vec2 turned = 6.2831853 * vec2(-value.y, value.x);
    vec2 along_x = stretch.x * gabor_impl_product(sum.zw, turn) + wave.x * turned;
    vec2 along_y = stretch.y * gabor_impl_product(slope.xy, turn) + wave.y * turned;
    return GaborField(value.y, vec2(along_x.y, along_y.y), value.x, vec2(along_x.x, along_y.x), 0.0);
}

GaborField gabor_field(GaborPlace place, vec2 wave, uint seed) {
    wave = clamp(wave, -1.0e6, 1.0e6);
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      place.cells_per_radius.x);
    salt ^= GABOR_IMPL_ROWS;
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, wave.y,
                                      place.cells_per_radius.y);
    vec2 turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    vec4 sum, slope;
    gabor_impl_sum(x, y, place.evolution, sum, slope);
    return gabor_impl_field(sum, slope, turn, wave, place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
void gabor_impl_add_field(inout GaborField sum, GaborField field, float amplitude, vec2 stretch) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * stretch * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
    sum.removed += amplitude * amplitude * field.removed;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GaborPlace gabor_place(ivec2 cell, vec2 local) {
    return GaborPlace(cell, local, vec2(GABOR_CELLS_PER_RADIUS), ivec2(0), 0.0);
}

GaborPlace gabor_place_at(vec2 p) {
    return gabor_place(ivec2(0), p * GABOR_CELLS_PER_RADIUS);
}

GaborPlace gabor_place_tiled(vec2 p, vec2 period) {
    vec2 side = clamp(period, 0.0009765625, 1.0e9); // 2^-10
    vec2 nodes = max(floor(side * GABOR_CELLS_PER_RADIUS + 0.5), vec2(float(GABOR_TAPS)));
    GaborPlace place = gabor_place(ivec2(0), vec2(0.0));
    place.cells_per_radius = vec2(period.x > 0.0 ? nodes.x / side.x : GABOR_CELLS_PER_RADIUS,
                        period.y > 0.0 ? nodes.y / side.y : GABOR_CELLS_PER_RADIUS);
    place.period = ivec2(period.x > 0.0 ? int(nodes.x) : 0, period.y > 0.0 ? int(nodes.y) : 0);
    place.local = p * place.cells_per_radius;
    return place;
}

GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local) {
    return GaborPlace3d(cell, local, vec3(GABOR_CELLS_PER_RADIUS), ivec3(0), 0.0);
}

GaborPlace3d gabor_place_3d_at(vec3 p) {
    return gabor_place_3d(ivec3(0), p * GABOR_CELLS_PER_RADIUS);
}

GaborPlace3d gabor_place_3d_tiled(vec3 p, vec3 period) {
    GaborPlace xy = gabor_place_tiled(p.xy, period.xy), z = gabor_place_tiled(p.zz, period.zz);
    return GaborPlace3d(ivec3(0), vec3(xy.local, z.local.x), vec3(xy.cells_per_radius, z.cells_per_radius.x),
                        ivec3(xy.period, z.period.x), 0.0);
}

vec2 gabor_wave_vector(float frequency, float orientation) {
    return min(abs(frequency), 1.0e6) * gabor_impl_wave(0.15915494 * clamp(orientation, -1.0e6, 1.0e6)); // 1/(2 pi)
}

float gabor_noise(vec2 p, float frequency, float orientation, uint seed) {
    return gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed).noise;
}

float gabor_noise_tiled(vec2 p, vec2 period, float frequency, float orientation, uint seed) {
    return gabor_field(gabor_place_tiled(p, period), gabor_wave_vector(frequency, orientation), seed).noise;
}

float gabor_noise_animated(vec2 p, float evolution, float frequency, float orientation, uint seed) {
    GaborPlace place = gabor_place_at(p);
    place.evolution = evolution;
    return gabor_field(place, gabor_wave_vector(frequency, orientation), seed).noise;
}

vec3 gabor_noise_gradient(vec2 p, float frequency, float orientation, uint seed) {
    GaborField field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return vec3(field.noise, field.gradient);
}

vec2 gabor_noise_quadrature(vec2 p, float frequency, float orientation, uint seed) {
    GaborField field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return vec2(field.noise, field.quadrature);
}

vec2 gabor_turns_intensity(vec2 noise_quadrature) {
    float intensity = length(noise_quadrature.yx);
    float phase = intensity > 0.0 ? atan(noise_quadrature.x, noise_quadrature.y) * 0.15915494 : 0.0; // 1/(2 pi)
    return vec2(phase < 0.0 ? min(phase + 1.0, 0.99999994) : phase, intensity); // 1 - 2^-24
}

// For z = v + sqrt(r) times a complex normal number with independent parts, the mean of z / |z| is about
// v / sqrt(|v|^2 + 8/pi r), and the mean of |z| about sqrt(|v|^2 + pi/2 r). Both are exact for small and for large |v|.
vec3 gabor_stripes_of(GaborField field, float sharpness) {
    vec2 value = vec2(field.quadrature, field.noise);
    float power = dot(value, value), removed = max(field.removed, 0.0);
    float reach = sqrt(power + 2.5464791 * removed); // 8/pi
    return vec3(sharpness / max(sharpness * reach, 1.0) * value, sqrt(power + 1.5707963 * removed)); // pi/2
}

vec3 gabor_stripes(vec2 p, vec2 wave, float sharpness, uint seed) {
    return gabor_stripes_of(gabor_field(gabor_place_at(p), wave, seed), sharpness);
}

float gabor_unorm(float noise) {
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

float gabor_uniform(float noise) {
    float x = clamp(noise, -8.0, 8.0), y = x * x;
    return 1.0 / (1.0 + exp(-x * (1.5954352 + y * (0.073597476 - y * 0.00063190124)))); // fit: see tools/constants.py
}

float gabor_uniform_slope(float noise) {
    return 0.39894228 * exp(-0.5 * min(noise * noise, 150.0)); // 1/sqrt(2 pi)
}

#endif
