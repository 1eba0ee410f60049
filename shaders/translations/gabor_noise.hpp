// clang-format off
// Generated from gabor_noise.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
//
// gabor_noise.hpp: Gabor noise in the plane, with mean 0, variance 1 and a normal distribution at every point.
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
// jumps, gabor_direction.hpp keeps stripes unbroken. NaN gives an unspecified value.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifdef GABOR_SPARSE_HPP
#error Include gabor_sparse.hpp or gabor_noise.hpp, not both: they define the same functions
#endif
#ifndef GABOR_NOISE_HPP
#define GABOR_NOISE_HPP 1
// 10000 major + 100 minor + patch
#define GABOR_NOISE_VERSION 30000

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
#define GABOR_CELLS_PER_RADIUS (0.5f * float(GABOR_TAPS))

// A position in node spacings of the lattice, with a period and an evolution.
struct GaborPlace {
    gabor_ivec2 cell;   // any integers except the last few before 2^31, where the world wraps around
    gabor_vec2 local;   // offset from that cell's corner in node spacings, most precise in [0, 1)^2
    gabor_vec2 cells_per_radius; // along each axis: GABOR_CELLS_PER_RADIUS, or slightly different to fit a period
    gabor_ivec2 period; // period in nodes, 0 for none
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
    gabor_ivec3 cell;
    gabor_vec3 local;
    gabor_vec3 cells_per_radius;
    gabor_ivec3 period;
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
    gabor_vec2 gradient;
    float quadrature;
    gabor_vec2 quadrature_gradient;
    float removed; // share of the variance that a filter removed, 0 without one: see gabor_filter.hpp
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
GABOR_INLINE std::uint32_t gabor_impl_mix(std::uint32_t word, std::uint32_t salt) {
    std::uint32_t once = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    std::uint32_t twice = (once ^ (once >> 15u)) * 0xd35a2d97u;
    return twice ^ (twice >> 15u);
}

GABOR_INLINE std::uint32_t gabor_derived_seed(std::uint32_t seed, int index) {
    return gabor_impl_mix(seed + std::uint32_t(index) * 0x85ebca6bu, 0x9e3779b1u);
}

#define GABOR_IMPL_ROWS 0x5bd1e995u
// The salt of the columns; xor it with GABOR_IMPL_ROWS to get the salt of the rows. With equal salts, the word of node
// (k, k) would be a square.
GABOR_INLINE std::uint32_t gabor_impl_salt(std::uint32_t seed) {
    return gabor_impl_mix(seed * 0x9e3779b1u, 0x2545f491u);
}

// The word of a column or row of nodes; a node's word is the product of its column's and its row's. The words of
// columns and rows are odd and have 24 bits, because GPUs multiply such numbers at a quarter of the cost of 32-bit
// numbers. Their highest bit is set, so that products fill all 32 bits. The factor (word ^ (word >> 15)) mixes better
// than a constant: two indices, however far apart, have equal words with probability 2^-22.
GABOR_INLINE std::uint32_t gabor_impl_line_word(int index, std::uint32_t salt) {
    std::uint32_t word = std::uint32_t(index) * 0x9e3779b1u + salt;
    return ((word * (word ^ (word >> 15u))) >> 8u) | 0x800001u;
}

// Like GABOR_IMPL_ROWS, for slices.
#define GABOR_IMPL_SLICES 0x27d4eb2fu

// The word of a row in a slice of nodes: odd with 24 bits, like the words of lines.
GABOR_INLINE std::uint32_t gabor_impl_slice_word(std::uint32_t row, std::uint32_t slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// The standard deviation of each part of an amplitude.
#define GABOR_IMPL_DEVIATION 1.4599553e27f

// Computes an amplitude from a word: the real part from the whole word, the imaginary part from its low 20 bits. They
// are independent and nearly normal. For u uniform in [-1, 1], the quantiles of (u - 0.893 clamp(u, -0.937, 0.937))
// (1 + 0.623 u^2) are nearly proportional to those of a normal distribution. The noise's Cramer-von Mises index
// [TNVT19] is 0.002 on average. At the worst point, a node, it is 0.03, because 79 % of the power there comes from that
// node's amplitude.
GABOR_INLINE gabor_vec2 gabor_impl_amplitude(std::uint32_t word) {
    gabor_vec2 u = gabor_vec2(float(int(word)), float(int(word << 12u)));
    // fit: see tools/constants.py
    return (u - 0.89289313f * gabor_cpp_clamp(u, -2.0119258e9f, 2.0119258e9f)) * (u * u + 7.3973916e18f);
}

// Derives four more words from a row's word. Multiplied by a column's word, each is as random as a node's own word.
GABOR_INLINE gabor_uvec4 gabor_impl_row(std::uint32_t word) {
    std::uint32_t first = (word ^ (word >> 15u)) * 0xd35a2d97u;
    std::uint32_t second = (first ^ (first >> 15u)) * 0xd35a2d97u;
    std::uint32_t third = (second ^ (second >> 15u)) * 0xd35a2d97u;
    std::uint32_t fourth = (third ^ (third >> 15u)) * 0xd35a2d97u;
    return gabor_uvec4((first >> 8u) | 0x800001u, (second >> 8u) | 0x800001u, (third >> 8u) | 0x800001u,
                 (fourth >> 8u) | 0x800001u);
}

// ---- Waves and windows ---------------------------------------------------------------------------------------------

// The product of two complex numbers.
GABOR_INLINE gabor_vec2 gabor_impl_product(gabor_vec2 a, gabor_vec2 b) {
    return a.x * b + a.y * gabor_vec2(-b.y, b.x);
}

// Adds z times a pair of complex numbers to two sums.
GABOR_INLINE void gabor_impl_add_products(gabor_vec4& sums, gabor_vec4 pair, gabor_vec2 z) {
    sums = sums + z.x * pair + z.y * gabor_vec4(-pair.y, pair.x, -pair.w, pair.z);
}

// (cos, sin) of 2 pi t for |t| <= 1/4, by minimax polynomials, within 2e-7.
GABOR_INLINE gabor_vec2 gabor_impl_half_turn(float t) {
    float s = t * t, r = s * s;
    // fits: see tools/constants.py
    return gabor_vec2((1.0f - 19.739171f * s) + r * ((64.934591f - 85.240337f * s) + 56.24243f * r),
                t * ((6.2831852f - 41.341655f * s) + r * ((81.601004f - 76.549782f * s) + 39.536707f * r)));
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1]; beyond that, the rounding of t adds to the error. After t is
// reduced to [-1/2, 1/2], cos(2 pi t) = sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), where y = 1/4 - |t|.
GABOR_INLINE gabor_vec2 gabor_impl_wave(float t) {
    float within = t - gabor_cpp_floor(t + 0.5f);
    gabor_vec2 turn = gabor_impl_half_turn(0.25f - gabor_cpp_abs(within));
    return gabor_vec2(turn.y, within < 0.0f ? -turn.x : turn.x);
}

// The sum of the squared windows.
#define GABOR_IMPL_ENERGY (GABOR_TAPS == 2 ? 1.0f : 0.375f * float(GABOR_TAPS))

// Computes the windows of the nodes k = -1, 0, ... along an axis, h = 1/2 + cos(pi (x - k) / R) / 2, and their
// derivatives per kernel radius. x is in node spacings from node 0: in [-1/2, 1/2] for three taps, [0, 1] for four and
// [-1, 0] for two.
#if GABOR_TAPS == 2
GABOR_INLINE void gabor_impl_windows(float x, gabor_vec4& value, gabor_vec4& slope) {
    // The squares of only two shifts of Hann's window do not sum to a constant. So the windows are 1 - s and s, with
    // s = t^2 (3 - 2 t), divided by the root of the sum of their squares. The gradient's variance still varies.
    float t = x + 1.0f, s = t * t * (3.0f - 2.0f * t);
    float scale = gabor_cpp_inversesqrt(1.0f - 2.0f * s * (1.0f - s));
    value = scale * gabor_vec4(1.0f - s, s, 0.0f, 0.0f);
    slope = 6.0f * t * (1.0f - t) * scale * scale * scale * gabor_vec4(-s, 1.0f - s, 0.0f, 0.0f);
}
#elif GABOR_TAPS == 3
GABOR_INLINE void gabor_impl_windows(float x, gabor_vec4& value, gabor_vec4& slope) {
    float y = x * x;
    // fits: see tools/constants.py
    float c = 0.5f - y * (1.0966099f - y * (0.40054826f - y * 0.05644487f)); // cos(2/3 pi x) / 2
    float s = x * (0.90689956f - y * (0.66301124f - y * (0.14532053f - y * 0.01467483f))); // sqrt(3)/4 sin(2/3 pi x)
    float a = 0.5f - 0.5f * c;
    float b = 1.8137994f * s; // pi/sqrt(3)
    value = gabor_vec4(a - s, 0.5f + c, a + s, 0.0f);
    slope = gabor_vec4(b - 2.7206991f * c, -2.0f * b, b + 2.7206991f * c, 0.0f); // sqrt(3)/2 pi
}
#else
GABOR_INLINE void gabor_impl_windows(float x, gabor_vec4& value, gabor_vec4& slope) {
    // `cosine` and `sine` are the cosine and sine of pi/2 z, times 1/sqrt(8); c and s are those of pi/2 x, times 1/2.
    float z = x - 0.5f, y = z * z;
    // fits: see tools/constants.py
    float cosine = 0.35355339f - y * (0.43617809f - y * (0.089663389f - y * 0.0072217699f));
    float sine = z * (0.55536036f - y * (0.22838240f - y * (0.028169684f - y * 0.0016236196f)));
    float c = cosine - sine, s = cosine + sine;
    value = 0.5f + gabor_vec4(-s, c, s, -c);
    slope = 3.1415927f * gabor_vec4(-c, -s, c, s); // pi
}
#endif

// The power of a noise that replaces another as x goes from 0 to 1. If the power were x itself, the amplitudes would be
// square roots, with infinite slopes at the ends.
GABOR_INLINE float gabor_impl_takeover(float x) {
    return x * x / (x * x + (1.0f - x) * (1.0f - x));
}

// ---- The sum -------------------------------------------------------------------------------------------------------

// Wraps an index into a period.
GABOR_INLINE int gabor_impl_wrap(int index, int period) {
    if (period != 0) {
        index -= index / gabor_cpp_max(period, 1) * period; // FXC refuses a division by 0, even one that never runs
        if (index < 0) index += period;
    }
    return index;
}

// The next index, wrapped into a period without a division.
GABOR_INLINE int gabor_impl_next_node(int index, int period) {
    return period == 0 || index + 1 < period ? index + 1 : 0;
}

// The words of four nodes along an axis; the second has the index.
GABOR_INLINE gabor_uvec4 gabor_impl_four_line_words(int index, int period, std::uint32_t salt) {
    int first = gabor_impl_wrap(index - 1, period);
    int second = gabor_impl_next_node(first, period);
    int third = gabor_impl_next_node(second, period);
    return gabor_uvec4(gabor_impl_line_word(first, salt), gabor_impl_line_word(second, salt),
                 gabor_impl_line_word(third, salt), gabor_impl_line_word(gabor_impl_next_node(third, period), salt));
}

// The nodes along an axis whose windows reach a point.
struct GaborImplAxis {
    float offset; // offset of the point from node 0, in node spacings
    float turns;  // turns of the wave from one node to the next
    std::uint32_t word[4] = {};
    gabor_vec4 node[4] = {}; // for node k, e^(-i u k) times the window, and times the window's derivative
};

// `wave` is in cycles per kernel radius, `radius` in nodes per kernel radius.
GABOR_INLINE GaborImplAxis gabor_impl_axis(int cell, float local, int period, std::uint32_t salt, float wave, float radius) {
    GaborImplAxis axis;
    float zero = gabor_cpp_floor(local + (2.0f - GABOR_CELLS_PER_RADIUS));
    // The clamp matters only if a compiler fuses the product in `local` with this subtraction.
    axis.offset = gabor_cpp_clamp(local - zero, GABOR_CELLS_PER_RADIUS - 2.0f, GABOR_CELLS_PER_RADIUS - 1.0f);
    axis.turns = wave / radius;
    int index = gabor_impl_wrap(cell + int(zero) - 1, period);
    axis.word[0] = gabor_impl_line_word(index, salt);
    index = gabor_impl_next_node(index, period);
    axis.word[1] = gabor_impl_line_word(index, salt);
    index = gabor_impl_next_node(index, period);
    axis.word[2] = gabor_impl_line_word(index, salt);
    axis.word[3] = gabor_impl_line_word(gabor_impl_next_node(index, period), salt);
    gabor_vec4 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    gabor_vec2 turn = gabor_impl_wave(axis.turns);
    gabor_vec2 back = gabor_vec2(turn.x, -turn.y);
    gabor_vec2 twice = gabor_impl_product(back, back);
    axis.node[0] = gabor_vec4(value.x * turn, slope.x * turn);
    axis.node[1] = gabor_vec4(value.y, 0.0f, slope.y, 0.0f);
    axis.node[2] = gabor_vec4(value.z * back, slope.z * back);
    axis.node[3] = gabor_vec4(value.w * twice, slope.w * twice);
    return axis;
}

// The amplitude of a node at an evolution. It is a weighted sum of three amplitudes, from the node's word and two words
// derived from it. The squared weights sum to 1; at evolution 0 the weights are 1, 0, 0. A return within the branch
// would take FXC four times as long through ANGLE.
GABOR_INLINE gabor_vec2 gabor_impl_amplitude_at(std::uint32_t word, float evolution) {
    gabor_vec2 amplitude = gabor_impl_amplitude(word);
    if (evolution != 0.0f) {
        std::uint32_t second = (word ^ (word >> 15u)) * 0xd35a2d97u;
        std::uint32_t third = (second ^ (second >> 15u)) * 0xd35a2d97u;
        gabor_vec2 turn = gabor_impl_wave(evolution);
        // 0.70710678 is 1/sqrt(2)
        amplitude = (0.5f + 0.5f * turn.x) * amplitude + (0.5f - 0.5f * turn.x) * gabor_impl_amplitude(second)
                  + 0.70710678f * turn.y * gabor_impl_amplitude(third);
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
GABOR_INLINE void gabor_impl_add_node_row(gabor_vec4& sum, gabor_vec4& slope, GaborImplAxis x, GaborImplAxis y, int j,
                             float evolution) {
    gabor_vec4 row = gabor_vec4(0.0f);
    gabor_impl_add_products(row, x.node[0], gabor_impl_amplitude_at(x.word[0] * y.word[j], evolution));
    gabor_impl_add_products(row, x.node[1], gabor_impl_amplitude_at(x.word[1] * y.word[j], evolution));
    if (GABOR_TAPS > 2)
        gabor_impl_add_products(row, x.node[2], gabor_impl_amplitude_at(x.word[2] * y.word[j], evolution));
    if (GABOR_TAPS > 3)
        gabor_impl_add_products(row, x.node[3], gabor_impl_amplitude_at(x.word[3] * y.word[j], evolution));
    if (j != GABOR_IMPL_TESTED_ROW || x.offset < 8.0f) {
        gabor_impl_add_products(sum, row, y.node[j].xy());
        gabor_impl_add_products(slope, row, y.node[j].zw());
    }
}

GABOR_INLINE void gabor_impl_sum(GaborImplAxis x, GaborImplAxis y, float evolution, gabor_vec4& sum, gabor_vec4& slope) {
    sum = slope = gabor_vec4(0.0f);
    gabor_impl_add_node_row(sum, slope, x, y, 0, evolution);
    gabor_impl_add_node_row(sum, slope, x, y, 1, evolution);
    if (GABOR_TAPS > 2) gabor_impl_add_node_row(sum, slope, x, y, 2, evolution);
    if (GABOR_TAPS > 3) gabor_impl_add_node_row(sum, slope, x, y, 3, evolution);
}

// Multiplies the sums by K and by the wave at the point, whose phase is 0 at node (0, 0). K makes E[n^2] = 1: E[n^2] is
// K^2 / 2 E|A|^2 times the sums of squared windows along x and y. A wave's derivative is the wave times 2 pi i F.
GABOR_INLINE GaborField gabor_impl_field(gabor_vec4 sum, gabor_vec4 slope, gabor_vec2 turn, gabor_vec2 wave, gabor_vec2 stretch) {
    turn *= 1.0f / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    gabor_vec2 value = gabor_impl_product(sum.xy(), turn);
    gabor_vec2 turned = 6.2831853f * gabor_vec2(-value.y, value.x);
    gabor_vec2 along_x = stretch.x * gabor_impl_product(sum.zw(), turn) + wave.x * turned;
    gabor_vec2 along_y = stretch.y * gabor_impl_product(slope.xy(), turn) + wave.y * turned;
    return GaborField{value.y, gabor_vec2(along_x.y, along_y.y), value.x, gabor_vec2(along_x.x, along_y.x), 0.0f};
}

GABOR_INLINE GaborField gabor_field(GaborPlace place, gabor_vec2 wave, std::uint32_t seed) {
    wave = gabor_cpp_clamp(wave, -1.0e6f, 1.0e6f);
    std::uint32_t salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      place.cells_per_radius.x);
    salt ^= GABOR_IMPL_ROWS;
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, wave.y,
                                      place.cells_per_radius.y);
    gabor_vec2 turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    gabor_vec4 sum, slope;
    gabor_impl_sum(x, y, place.evolution, sum, slope);
    return gabor_impl_field(sum, slope, turn, wave, place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
GABOR_INLINE void gabor_impl_add_field(GaborField& sum, GaborField field, float amplitude, gabor_vec2 stretch) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * stretch * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
    sum.removed += amplitude * amplitude * field.removed;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

GABOR_INLINE GaborPlace gabor_place(gabor_ivec2 cell, gabor_vec2 local) {
    return GaborPlace{cell, local, gabor_vec2(GABOR_CELLS_PER_RADIUS), gabor_ivec2(0), 0.0f};
}

GABOR_INLINE GaborPlace gabor_place_at(gabor_vec2 p) {
    return gabor_place(gabor_ivec2(0), p * GABOR_CELLS_PER_RADIUS);
}

GABOR_INLINE GaborPlace gabor_place_tiled(gabor_vec2 p, gabor_vec2 period) {
    gabor_vec2 side = gabor_cpp_clamp(period, 0.0009765625f, 1.0e9f); // 2^-10
    gabor_vec2 nodes = gabor_cpp_max(gabor_cpp_floor(side * GABOR_CELLS_PER_RADIUS + 0.5f), gabor_vec2(float(GABOR_TAPS)));
    GaborPlace place = gabor_place(gabor_ivec2(0), gabor_vec2(0.0f));
    place.cells_per_radius = gabor_vec2(period.x > 0.0f ? nodes.x / side.x : GABOR_CELLS_PER_RADIUS,
                        period.y > 0.0f ? nodes.y / side.y : GABOR_CELLS_PER_RADIUS);
    place.period = gabor_ivec2(period.x > 0.0f ? int(nodes.x) : 0, period.y > 0.0f ? int(nodes.y) : 0);
    place.local = p * place.cells_per_radius;
    return place;
}

GABOR_INLINE GaborPlace3d gabor_place_3d(gabor_ivec3 cell, gabor_vec3 local) {
    return GaborPlace3d{cell, local, gabor_vec3(GABOR_CELLS_PER_RADIUS), gabor_ivec3(0), 0.0f};
}

GABOR_INLINE GaborPlace3d gabor_place_3d_at(gabor_vec3 p) {
    return gabor_place_3d(gabor_ivec3(0), p * GABOR_CELLS_PER_RADIUS);
}

GABOR_INLINE GaborPlace3d gabor_place_3d_tiled(gabor_vec3 p, gabor_vec3 period) {
    GaborPlace xy = gabor_place_tiled(p.xy(), period.xy()), z = gabor_place_tiled(p.zz(), period.zz());
    return GaborPlace3d{gabor_ivec3(0), gabor_vec3(xy.local, z.local.x), gabor_vec3(xy.cells_per_radius, z.cells_per_radius.x),
                        gabor_ivec3(xy.period, z.period.x), 0.0f};
}

GABOR_INLINE gabor_vec2 gabor_wave_vector(float frequency, float orientation) {
    return gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f) * gabor_impl_wave(0.15915494f * gabor_cpp_clamp(orientation, -1.0e6f, 1.0e6f)); // 1/(2 pi)
}

GABOR_INLINE float gabor_noise(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed) {
    return gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed).noise;
}

GABOR_INLINE float gabor_noise_tiled(gabor_vec2 p, gabor_vec2 period, float frequency, float orientation, std::uint32_t seed) {
    return gabor_field(gabor_place_tiled(p, period), gabor_wave_vector(frequency, orientation), seed).noise;
}

GABOR_INLINE float gabor_noise_animated(gabor_vec2 p, float evolution, float frequency, float orientation, std::uint32_t seed) {
    GaborPlace place = gabor_place_at(p);
    place.evolution = evolution;
    return gabor_field(place, gabor_wave_vector(frequency, orientation), seed).noise;
}

GABOR_INLINE gabor_vec3 gabor_noise_gradient(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed) {
    GaborField field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return gabor_vec3(field.noise, field.gradient);
}

GABOR_INLINE gabor_vec2 gabor_noise_quadrature(gabor_vec2 p, float frequency, float orientation, std::uint32_t seed) {
    GaborField field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return gabor_vec2(field.noise, field.quadrature);
}

GABOR_INLINE gabor_vec2 gabor_turns_intensity(gabor_vec2 noise_quadrature) {
    float intensity = gabor_cpp_length(noise_quadrature.yx());
    float phase = intensity > 0.0f ? gabor_cpp_atan(noise_quadrature.x, noise_quadrature.y) * 0.15915494f : 0.0f; // 1/(2 pi)
    return gabor_vec2(phase < 0.0f ? gabor_cpp_min(phase + 1.0f, 0.99999994f) : phase, intensity); // 1 - 2^-24
}

// For z = v + sqrt(r) times a complex normal number with independent parts, the mean of z / |z| is about
// v / sqrt(|v|^2 + 8/pi r), and the mean of |z| about sqrt(|v|^2 + pi/2 r). Both are exact for small and for large |v|.
GABOR_INLINE gabor_vec3 gabor_stripes_of(GaborField field, float sharpness) {
    gabor_vec2 value = gabor_vec2(field.quadrature, field.noise);
    float power = gabor_cpp_dot(value, value), removed = gabor_cpp_max(field.removed, 0.0f);
    float reach = gabor_cpp_sqrt(power + 2.5464791f * removed); // 8/pi
    return gabor_vec3(sharpness / gabor_cpp_max(sharpness * reach, 1.0f) * value, gabor_cpp_sqrt(power + 1.5707963f * removed)); // pi/2
}

GABOR_INLINE gabor_vec3 gabor_stripes(gabor_vec2 p, gabor_vec2 wave, float sharpness, std::uint32_t seed) {
    return gabor_stripes_of(gabor_field(gabor_place_at(p), wave, seed), sharpness);
}

GABOR_INLINE float gabor_unorm(float noise) {
    return gabor_cpp_clamp(0.5f + 0.25f * noise, 0.0f, 1.0f);
}

GABOR_INLINE float gabor_uniform(float noise) {
    float x = gabor_cpp_clamp(noise, -8.0f, 8.0f), y = x * x;
    return 1.0f / (1.0f + gabor_cpp_exp(-x * (1.5954352f + y * (0.073597476f - y * 0.00063190124f)))); // fit: see tools/constants.py
}

GABOR_INLINE float gabor_uniform_slope(float noise) {
    return 0.39894228f * gabor_cpp_exp(-0.5f * gabor_cpp_min(noise * noise, 150.0f)); // 1/sqrt(2 pi)
}

#endif
