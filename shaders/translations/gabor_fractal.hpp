// clang-format off
// Generated from gabor_fractal.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
// Includes gabor_noise.hpp; pasted after their texts, it includes nothing.
//
// gabor_fractal.hpp: fBm, billows, ridges and warps of smooth or Perlin-like noise, each with mean 0 and variance 1.
//
//     float clouds = gabor_fbm(p, 5.0, 0.5, 7u);                 // 5 octaves, each half as strong, seed 7
//     float sky = gabor_uniform(clouds) < 0.3 ? 1.0 : 0.0;       // covers 30 % of the area
//
//     I want                                   call
//     fBm, billows, ridges                     gabor_fbm, gabor_billow, gabor_ridged
//     the same in a volume                     gabor_fbm_3d, or a place, then gabor_fractal_noise_3d
//     one octave                               gabor_smooth, or gabor_perlin, which replaces Perlin and simplex noise
//     derivatives, periods, other octaves      a place and a GaborFractal, then gabor_fractal_noise
//     no flicker in the distance               gabor_fractal_noise_filtered
//     marble, smoke, swirls                    gabor_warp, then any noise at the place that it returns
//     a flow without sources                   vec2(-g.y, g.x), where g is the gradient of any noise
//
// All noises have mean 0 and variance 1 at every point, for any number of octaves, gain, period and evolution. One
// octave and fBm are normal; so gabor_uniform gives their rank among all values. Octaves are independent, and each is
// turned against the previous one.
//
// Arguments of all functions, besides those of gabor_noise.hpp:
//     octaves  1 to 16. The last octave fades in with the fraction: at 4.3, the fifth has 0.3 of its amplitude. Keep
//              |p| lacunarity^octaves below 2^30.
//     gain     amplitude of an octave relative to the previous one, 0 to 4
//     dx, dy   the pixel: see gabor_filter.hpp
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifndef GABOR_NOISE_HPP
#include "gabor_noise.hpp"
#endif
#ifndef GABOR_NOISE_HPP
#error Include gabor_noise.hpp before gabor_fractal.hpp
#elif GABOR_TAPS != 3
#error gabor_fractal.hpp needs GABOR_TAPS 3
#endif
#ifndef GABOR_FRACTAL_HPP
#define GABOR_FRACTAL_HPP 1

// The noise of an octave. Smooth noise has most power at low frequencies: within 0.5 cycles per kernel radius. Perlin
// noise has little there: the centroid of its spectrum is 0.52 cycles per kernel radius. Along the axes of their
// lattice, they have 0.97 and 0.92 of the power along the diagonals.
#define GABOR_SMOOTH 0
#define GABOR_PERLIN 1

// What the octaves n become before they are summed: n; |n|, minus its mean and over its deviation; or minus that.
#define GABOR_FBM 0
#define GABOR_BILLOW 1
#define GABOR_RIDGED 2

struct GaborFractal {
    float octaves;
    float gain;
    float lacunarity; // frequency of an octave relative to the previous one, 1 to 4, rounded to a multiple of 1/4096
    float turn;       // angle in radians by which an octave is turned against the previous one, unused with a period
    int basis;        // GABOR_SMOOTH or GABOR_PERLIN
    int shape;        // GABOR_FBM, GABOR_BILLOW or GABOR_RIDGED
};

// GaborFractal gabor_fractal(float octaves, float gain)
//     fBm of smooth noise, with lacunarity 2 and turns of 0.6435 radians.

struct GaborFractalNoise {
    float noise;
    gabor_vec2 gradient; // per kernel radius of the first octave, with a filter at a fixed footprint
    float removed; // share of the variance that a filter removed
    gabor_vec3 lost;     // covariance xx, yy, xy of the slopes that a filter removed, such as materials add to roughness
};

struct GaborFractalNoise3d {
    float noise;
    gabor_vec3 gradient;
    float removed;
    gabor_vec3 lost;       // covariance xx, yy, zz
    gabor_vec3 lost_mixed; // covariance xy, xz, yz
};

// float gabor_smooth(vec2 p, uint seed)
// float gabor_perlin(vec2 p, uint seed)
// float gabor_perlin_3d(vec3 p, uint seed)
//     One octave. gabor_perlin's p is in the cells of Perlin noise, so both have the same size; to match its contrast,
//     multiply by its deviation, 0.25 to 0.3: see docs/other-noises.md.

// float gabor_fbm(vec2 p, float octaves, float gain, uint seed)
// float gabor_fbm_3d(vec3 p, float octaves, float gain, uint seed)
// float gabor_billow(vec2 p, float octaves, float gain, uint seed)
// float gabor_ridged(vec2 p, float octaves, float gain, uint seed)
//     Sums of smooth octaves. Ridges are billows upside down: at most 1.32 for one octave.

// GaborFractalNoise gabor_fractal_noise(GaborPlace place, GaborFractal fractal, uint seed)
// GaborFractalNoise3d gabor_fractal_noise_3d(GaborPlace3d place, GaborFractal fractal, uint seed)
//     Any sum of octaves at a place. Its evolution changes all octaves in place, and repeats when it grows by 1. With a
//     period of at least 8/3 kernel radii, every octave has a whole number of nodes along it, and none is turned.
//     Gradients of fBm are continuous. The variance of a smooth octave's is the same everywhere; a Perlin octave's is
//     0.6 to 1.5 of the mean, largest at nodes. Lit alone, a smooth octave shows where its second derivatives jump.

// GaborFractalNoise gabor_fractal_noise_filtered(GaborPlace place, vec2 dx, vec2 dy, GaborFractal fractal, uint seed)
// GaborFractalNoise3d gabor_fractal_noise_3d_filtered(GaborPlace3d place, vec3 dx, vec3 dy, GaborFractal fractal,
//                                                     uint seed)
//     The sum averaged over a pixel. |n| becomes its mean over what was removed, so billows and ridges keep their
//     brightness. The noise's rms error is 0.02 of a deviation for one smooth octave whose pixel has a standard
//     deviation of 0.1 kernel radii, and 0.23 for 1. Octaves that keep less than 1/1000 of their variance are left out.

// A warp moves a place along two noises, or three in a volume, whose deviation is its strength in kernel radii.
struct GaborWarp {
    GaborPlace place; // moved
    gabor_vec2 dx;          // the moved position's derivative along x: a gradient g there becomes (dot(g, dx), dot(g, dy)),
    gabor_vec2 dy;          // and a pixel (a, b) becomes a dx + b dy
    gabor_vec3 lost;        // what a filter removed of it adds dot(g, g) times this to the lost slopes of a noise there
};

struct GaborWarp3d {
    GaborPlace3d place;
    gabor_vec3 dx;
    gabor_vec3 dy;
    gabor_vec3 dz;
    gabor_vec3 lost;       // xx, yy, zz
    gabor_vec3 lost_mixed; // xy, xz, yz
};

// GaborWarp gabor_warp(GaborPlace place, float strength, GaborFractal fractal, uint seed)
// GaborWarp gabor_warp_filtered(GaborPlace place, vec2 dx, vec2 dy, float strength, GaborFractal fractal, uint seed)
// GaborWarp3d gabor_warp_3d(GaborPlace3d place, float strength, GaborFractal fractal, uint seed)
// GaborWarp3d gabor_warp_3d_filtered(GaborPlace3d place, vec3 dx, vec3 dy, float strength, GaborFractal fractal,
//                                    uint seed)
//     The place moved by a warp, plain or filtered.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// An octave is noise on the lattice of gabor_noise.hpp, with node spacings as unit of length. Smooth noise has real
// amplitudes A, Perlin noise gradients (A, B) at its nodes c:
//
//     smooth = sum A_c u(x) u(y),   Perlin = 1/sqrt(2) sum A_c v(x) u(y) + B_c u(x) v(y).
//
// u is a window h, and v its derivative h', of p - c. Each is divided by the root of the sum of its squares over the
// nodes that reach the point, so that the variance is 1 at every point. Smooth noise has Hann's window over three
// nodes. For Perlin noise, h = c^2 over four nodes, where c = (1 + cos(pi d / 2)) / 2: h'' is continuous, and so is the
// gradient.
//
// A filter widens the windows: with the pixel's deviation s along the axis, Hann's to a half-width of
// 3/2 sqrt(1 + s^2 / 0.294), at most 2; and Perlin noise's to c^2 (1 + t (1 - c)), where t = 5.5 s^2, at most 2. Each
// window is then multiplied by its correlation with the exactly filtered one, averaged over places: see
// gabor_impl_kept_even and gabor_impl_kept_odd. A pixel that is oblique to the axes keeps more: its covariance
// multiplies smooth noise by 1 / (1 - k^2 / 2), where k = 2.9 s_xy / sqrt((1 + 2.9 s_x^2) (1 + 2.9 s_y^2)), and Perlin
// noise by the cube of that.

// The windows of four nodes along an axis, from the one at or before node -1, and their derivatives.
struct GaborImplLine {
    gabor_uvec4 word;
    gabor_vec4 even; // u, for three nodes with w = 0
    gabor_vec4 even_slope;
    gabor_vec4 odd; // v
    gabor_vec4 odd_slope;
};

// The squared correlations of filtered windows u and v with the exactly filtered ones: their roots are within 0.006.
GABOR_INLINE float gabor_impl_kept_even(float variance) {
    return gabor_cpp_inversesqrt(1.0f + variance * (2.888f + 1.52f * variance * variance / (variance + 0.5855f)));
}

GABOR_INLINE float gabor_impl_kept_odd(float variance) {
    float y = gabor_cpp_inversesqrt(1.0f + variance * (2.704f + 1.173f * variance * variance / (variance + 0.149f)));
    return y * y * y;
}

// Hann's windows as gabor_impl_windows returns them: the sum must be divided by the root of GABOR_IMPL_ENERGY, and its
// derivatives by GABOR_CELLS_PER_RADIUS as well.
GABOR_INLINE GaborImplLine gabor_impl_smooth_line(int cell, float local, int period, std::uint32_t salt) {
    float zero = gabor_cpp_floor(local + 0.5f);
    gabor_vec4 value, slope;
    gabor_impl_windows(gabor_cpp_clamp(local - zero, -0.5f, 0.5f), value, slope);
    return GaborImplLine{gabor_impl_four_line_words(cell + int(zero), period, salt), value, slope, gabor_vec4(0.0f),
                         gabor_vec4(0.0f)};
}

// Divides a window and its derivative by the root of the sum of the squared windows, and multiplies both by `kept`.
GABOR_INLINE void gabor_impl_normalize_windows(gabor_vec4& value, gabor_vec4& slope, float kept) {
    float scale = gabor_cpp_inversesqrt(gabor_cpp_dot(value, value));
    value *= scale;
    slope = kept * scale * (slope - gabor_cpp_dot(value, slope) * value);
    value *= kept;
}

// One over the half-width of Hann's windows, in node spacings, for a filter.
GABOR_INLINE float gabor_impl_inverse_width(float variance) {
    return gabor_cpp_inversesqrt(gabor_cpp_min(2.25f + 7.6530612f * variance, 4.0f)); // 2.25 / 0.294
}

// Those windows, not normalized: the sum of their squares is within 1 % of 3/4 of the half-width. The nodes are at
// -3/2, -1/2, 1/2 and 3/2 times an angle from the middle, which is at the angle of `a`.
GABOR_INLINE GaborImplLine gabor_impl_smooth_line_filtered(int cell, float local, int period, std::uint32_t salt, float inverse_width) {
    float zero = gabor_cpp_floor(local), d = gabor_cpp_clamp(local - zero, 0.0f, 1.0f);
    gabor_vec2 a = 0.5f * gabor_impl_half_turn(0.5f * inverse_width * (d - 0.5f));
    gabor_vec2 inner = gabor_impl_half_turn(0.25f * inverse_width);
    float square = 4.0f * inner.x * inner.x;
    gabor_vec2 outer = inner * gabor_vec2(square - 3.0f, square - 1.0f); // the cosine and sine of thrice the angle
    gabor_vec4 cosine = a.x * gabor_vec4(outer.x, inner.x, inner.x, outer.x) - a.y * gabor_vec4(outer.y, inner.y, -inner.y, -outer.y);
    gabor_vec4 sine = a.y * gabor_vec4(outer.x, inner.x, inner.x, outer.x) + a.x * gabor_vec4(outer.y, inner.y, -inner.y, -outer.y);
    gabor_vec4 value = 0.5f + cosine, slope = -3.1415927f * inverse_width * sine; // pi
    bool first = (d + 1.0f) * inverse_width < 1.0f, last = (2.0f - d) * inverse_width < 1.0f;
    value = gabor_vec4(first ? value.x : 0.0f, value.yz(), last ? value.w : 0.0f);
    slope = gabor_vec4(first ? slope.x : 0.0f, slope.yz(), last ? slope.w : 0.0f);
    return GaborImplLine{gabor_impl_four_line_words(cell + int(zero), period, salt), value, slope, gabor_vec4(0.0f),
                         gabor_vec4(0.0f)};
}

// How much a filter widens Perlin noise's windows: t in the comment above.
GABOR_INLINE float gabor_impl_widening(float variance) {
    return gabor_cpp_min(5.5f * variance, 2.0f);
}

// A variance of 0 is no filter.
GABOR_INLINE GaborImplLine gabor_impl_perlin_line(int cell, float local, int period, std::uint32_t salt, float variance) {
    float zero = gabor_cpp_floor(local), t = gabor_impl_widening(variance);
    gabor_vec2 turn = gabor_impl_half_turn(0.25f * gabor_cpp_clamp(local - zero, 0.0f, 1.0f));
    gabor_vec4 cosine = gabor_vec4(-turn.y, turn.x, turn.y, -turn.x); // of pi d / 2
    gabor_vec4 hann = 0.5f + 0.5f * cosine, hann_slope = 0.78539816f * gabor_vec4(-turn.x, -turn.y, turn.x, turn.y); // pi/4
    gabor_vec4 share = 2.0f + 2.0f * t - 3.0f * t * hann;
    gabor_vec4 even = hann * hann * (1.0f + t - t * hann), even_slope = hann_slope * hann * share, odd = even_slope;
    gabor_vec4 odd_slope = -1.2337006f * cosine * hann * share + hann_slope * hann_slope * (share - 3.0f * t * hann); // pi^2/8
    gabor_impl_normalize_windows(even, even_slope, gabor_cpp_sqrt(gabor_impl_kept_even(variance)));
    gabor_impl_normalize_windows(odd, odd_slope, gabor_cpp_sqrt(gabor_impl_kept_odd(variance)));
    return GaborImplLine{gabor_impl_four_line_words(cell + int(zero), period, salt), even, even_slope, odd, odd_slope};
}

// Adds a row of nodes of smooth noise to (value, d/dx, d/dy). `even` is the row's window and its derivative.
GABOR_INLINE void gabor_impl_add_smooth_row(gabor_vec3& sum, GaborImplLine x, std::uint32_t word, gabor_vec2 even, bool four, float evolution) {
    gabor_uvec4 words = x.word * word;
    gabor_vec4 a = gabor_vec4(gabor_impl_amplitude_at(words.x, evolution).x, gabor_impl_amplitude_at(words.y, evolution).x,
                  gabor_impl_amplitude_at(words.z, evolution).x, 0.0f);
    if (four) a.w = gabor_impl_amplitude_at(words.w, evolution).x;
    float row = gabor_cpp_dot(x.even.xyz(), a.xyz()), side = gabor_cpp_dot(x.even_slope.xyz(), a.xyz());
    if (four) {
        row += x.even.w * a.w;
        side += x.even_slope.w * a.w;
    }
    sum += gabor_vec3(even.x * row, even.x * side, even.y * row);
}

// A smooth noise and its gradient. `four` is whether the windows of four nodes reach a point, not three.
GABOR_INLINE gabor_vec3 gabor_impl_smooth_sum(GaborImplLine x, GaborImplLine y, bool four, float evolution) {
    gabor_vec3 sum = gabor_vec3(0.0f);
    gabor_impl_add_smooth_row(sum, x, y.word.x, gabor_vec2(y.even.x, y.even_slope.x), four, evolution);
    gabor_impl_add_smooth_row(sum, x, y.word.y, gabor_vec2(y.even.y, y.even_slope.y), four, evolution);
    gabor_impl_add_smooth_row(sum, x, y.word.z, gabor_vec2(y.even.z, y.even_slope.z), four, evolution);
    if (four) gabor_impl_add_smooth_row(sum, x, y.word.w, gabor_vec2(y.even.w, y.even_slope.w), four, evolution);
    return sum / GABOR_IMPL_DEVIATION;
}

// The same for Perlin noise. `even` and `odd` are the row's windows and their derivatives.
GABOR_INLINE void gabor_impl_add_perlin_row(gabor_vec3& sum, GaborImplLine x, std::uint32_t word, gabor_vec2 even, gabor_vec2 odd, float evolution) {
    gabor_uvec4 words = x.word * word;
    gabor_vec2 g0 = gabor_impl_amplitude_at(words.x, evolution), g1 = gabor_impl_amplitude_at(words.y, evolution);
    gabor_vec2 g2 = gabor_impl_amplitude_at(words.z, evolution), g3 = gabor_impl_amplitude_at(words.w, evolution);
    gabor_vec4 a = gabor_vec4(g0.x, g1.x, g2.x, g3.x), b = gabor_vec4(g0.y, g1.y, g2.y, g3.y);
    float odd_row = gabor_cpp_dot(x.odd, a), even_row = gabor_cpp_dot(x.even, b);
    sum += gabor_vec3(even.x * odd_row + odd.x * even_row, even.x * gabor_cpp_dot(x.odd_slope, a) + odd.x * gabor_cpp_dot(x.even_slope, b),
                even.y * odd_row + odd.y * even_row);
}

// The sum of two of a Perlin noise's terms, with variance 2.
GABOR_INLINE gabor_vec3 gabor_impl_perlin_sum(GaborImplLine x, GaborImplLine y, float evolution) {
    gabor_vec3 sum = gabor_vec3(0.0f);
    gabor_impl_add_perlin_row(sum, x, y.word.x, gabor_vec2(y.even.x, y.even_slope.x), gabor_vec2(y.odd.x, y.odd_slope.x),
                              evolution);
    gabor_impl_add_perlin_row(sum, x, y.word.y, gabor_vec2(y.even.y, y.even_slope.y), gabor_vec2(y.odd.y, y.odd_slope.y),
                              evolution);
    gabor_impl_add_perlin_row(sum, x, y.word.z, gabor_vec2(y.even.z, y.even_slope.z), gabor_vec2(y.odd.z, y.odd_slope.z),
                              evolution);
    gabor_impl_add_perlin_row(sum, x, y.word.w, gabor_vec2(y.even.w, y.even_slope.w), gabor_vec2(y.odd.w, y.odd_slope.w),
                              evolution);
    return sum / GABOR_IMPL_DEVIATION;
}

GABOR_INLINE GaborImplLine gabor_impl_nodes(int cell, float local, int period, std::uint32_t salt, float variance, int basis, bool filtered) {
    GaborImplLine line_;
    if (basis == GABOR_PERLIN) line_ = gabor_impl_perlin_line(cell, local, period, salt, variance);
    else if (filtered) {
        line_ = gabor_impl_smooth_line_filtered(cell, local, period, salt, gabor_impl_inverse_width(variance));
        gabor_vec4 even = line_.even, slope = line_.even_slope;
        gabor_impl_normalize_windows(even, slope, gabor_cpp_sqrt(gabor_impl_kept_even(variance)));
        line_.even = even;
        line_.even_slope = slope;
    }
    else line_ = gabor_impl_smooth_line(cell, local, period, salt);
    return line_;
}

// The variances of the derivatives of u and v per node spacing, averaged over places. Hann's window of half-width w has
// pi^2/3 w^-2. Perlin noise's window is a sum of cosines of multiples of pi d / 2.
GABOR_INLINE gabor_vec2 gabor_impl_slope_powers(float variance, bool perlin) {
    if (!perlin) {
        float inverse_width = gabor_impl_inverse_width(variance);
        return gabor_vec2(3.2898681f * inverse_width * inverse_width, 0.0f); // pi^2/3
    }
    float t = gabor_impl_widening(variance), mean = 0.375f + 0.0625f * t;
    gabor_vec3 power = gabor_vec3(0.5f + 0.03125f * t, 0.125f - 0.0625f * t, 0.03125f * t);
    power *= power;
    float slope = gabor_cpp_dot(power, gabor_vec3(1.0f, 4.0f, 9.0f));
    return 2.4674011f * gabor_vec2(slope / (2.0f * mean * mean + gabor_cpp_dot(power, gabor_vec3(1.0f))),
                            gabor_cpp_dot(power, gabor_vec3(1.0f, 16.0f, 81.0f)) / slope); // pi^2/4
}

GABOR_INLINE std::uint32_t gabor_impl_octave_salt(std::uint32_t seed, int octave) {
    return gabor_impl_mix(seed * 0x9e3779b1u + std::uint32_t(octave) * 0x85ebca6bu, 0xc2b2ae35u);
}

// By how much an oblique pixel keeps more of two axes' windows.
GABOR_INLINE float gabor_impl_oblique(float covariance, float variance_x, float variance_y) {
    // 4.205 is 2.9^2 / 2
    return 1.0f / (1.0f - 4.205f * covariance * covariance / ((1.0f + 2.9f * variance_x) * (1.0f + 2.9f * variance_y)));
}

// 1, but 0 for what keeps less than 1/1000 of its variance.
GABOR_INLINE float gabor_impl_visible(float kept) {
    return gabor_cpp_clamp(1000.0f * kept - 1.0f, 0.0f, 1.0f);
}

// The mean of |n + sqrt(1 - kept) z| over a normal z of variance 1, and its derivative by n. 0.79788456 is sqrt(2/pi).
GABOR_INLINE gabor_vec2 gabor_impl_mean_magnitude(float n, float kept) {
    float deviation = gabor_cpp_sqrt(gabor_cpp_max(1.0f - kept, 1.0e-8f));
    float t = gabor_cpp_clamp(n / deviation, -9.0f, 9.0f), slope = 2.0f * gabor_uniform(t) - 1.0f;
    return kept < 1.0f ? gabor_vec2(0.79788456f * deviation * gabor_cpp_exp(-0.5f * t * t) + n * slope, slope) : gabor_vec2(gabor_cpp_abs(n), gabor_cpp_sign(n));
}

// The variance of |n| that is left where a filter leaves n the share `kept`, within 8e-6. With correlation r, two
// normal values have E|a b| = 2/pi (sqrt(1 - r^2) + r asin(r)), but some drivers' asin errs by 4e-4.
GABOR_INLINE float gabor_impl_kept_magnitude(float kept) {
    float square = gabor_cpp_min(kept * kept, 1.0f), rest = 1.0f - square;
    // fit: see tools/constants.py
    return square * (0.65746669f - 0.07981755f * square) + rest * gabor_cpp_sqrt(rest) * (0.19638946f + 0.01788676f * rest)
         - 0.21427622f;
}

GABOR_INLINE GaborFractal gabor_fractal(float octaves, float gain) {
    // 0.64350111, atan(3/4), was chosen because five such turns spread evenly over a right angle
    return GaborFractal{octaves, gain, 2.0f, 0.64350111f, GABOR_SMOOTH, GABOR_FBM};
}

// ---- In the plane --------------------------------------------------------------------------------------------------

// A place on the lattice of an octave. A unit of x or y in kernel radii of the first octave is along_x or along_y.
struct GaborImplOctave {
    gabor_ivec2 cell;
    gabor_vec2 local;
    gabor_ivec2 period;
    gabor_vec2 along_x;
    gabor_vec2 along_y;
};

// A multiple of 1/4096, so that its product with a cell splits exactly into integer and fraction.
GABOR_INLINE gabor_vec2 gabor_impl_octave_step(GaborFractal fractal) {
    gabor_vec2 turn = gabor_impl_wave(0.15915494f * gabor_cpp_clamp(fractal.turn, -1.0e6f, 1.0e6f)); // 1/(2 pi)
    return gabor_cpp_floor(4096.0f * gabor_cpp_clamp(fractal.lacunarity, 1.0f, 4.0f) * turn + 0.5f) / 4096.0f;
}

// How many nodes octave i has along a period of `nodes`, and a factor for an axis without a period.
GABOR_INLINE float gabor_impl_octave_nodes(float nodes, float scale) {
    return nodes > 0.0f ? gabor_cpp_min(gabor_cpp_floor(nodes * scale + 0.5f), 1.0e9f) : scale;
}

// Goes to octave i from the previous one, or with a period from the first one. Its lattice is moved, so that its nodes
// are not those of the previous one.
GABOR_INLINE void gabor_impl_next_octave(GaborImplOctave& octave, GaborPlace place, gabor_vec2 by, float lacunarity, int i) {
    gabor_vec2 moved = gabor_vec2(0.382f, 0.731f);
    if (place.period.x == 0 && place.period.y == 0) {
        octave.local = gabor_impl_product(by, octave.local) + moved;
        if (place.cell.x != 0 || place.cell.y != 0) {
            gabor_ivec2 m = gabor_ivec2(by * 4096.0f), low = octave.cell & gabor_ivec2(4095);
            gabor_uvec2 high = gabor_uvec2(octave.cell >> gabor_ivec2(12)), n = gabor_uvec2(m);
            gabor_ivec2 part = m.x * low + m.y * gabor_ivec2(-low.y, low.x);
            octave.cell = gabor_ivec2(n.x * high + n.y * gabor_uvec2(0u - high.y, high.x)) + (part >> gabor_ivec2(12));
            octave.local += gabor_vec2(part & gabor_ivec2(4095)) / 4096.0f;
        }
        octave.along_x = gabor_impl_product(by, octave.along_x);
        octave.along_y = gabor_impl_product(by, octave.along_y);
    } else {
        float scale = gabor_cpp_pow(gabor_cpp_clamp(lacunarity, 1.0f, 4.0f), float(i));
        gabor_vec2 first = gabor_vec2(place.period);
        gabor_vec2 within = gabor_vec2(float(gabor_impl_wrap(place.cell.x, place.period.x)),
                           float(gabor_impl_wrap(place.cell.y, place.period.y))) + place.local;
        gabor_vec2 nodes = gabor_vec2(gabor_impl_octave_nodes(first.x, scale), gabor_impl_octave_nodes(first.y, scale));
        gabor_vec2 growth = nodes / gabor_cpp_max(first, 1.0f);
        octave.cell = gabor_ivec2(0);
        octave.local = growth * (within - first * gabor_cpp_floor(within / gabor_cpp_max(first, 1.0f))) + float(i) * moved;
        octave.period = gabor_ivec2(place.period.x == 0 ? 0 : int(nodes.x), place.period.y == 0 ? 0 : int(nodes.y));
        octave.along_x = gabor_vec2(growth.x * place.cells_per_radius.x, 0.0f);
        octave.along_y = gabor_vec2(0.0f, growth.y * place.cells_per_radius.y);
    }
}

// The noise of an octave, and its gradient per node spacing.
GABOR_INLINE gabor_vec3 gabor_impl_octave_noise(GaborImplOctave octave, std::uint32_t salt, gabor_vec2 variance, int basis, bool filtered,
                             float evolution) {
    GaborImplLine x = gabor_impl_nodes(octave.cell.x, octave.local.x, octave.period.x, salt, variance.x, basis,
                                      filtered);
    GaborImplLine y = gabor_impl_nodes(octave.cell.y, octave.local.y, octave.period.y, salt ^ GABOR_IMPL_ROWS,
                                      variance.y, basis, filtered);
    gabor_vec3 noise;
    if (basis == GABOR_PERLIN) noise = 0.70710678f * gabor_impl_perlin_sum(x, y, evolution); // 1/sqrt(2)
    else noise = gabor_impl_smooth_sum(x, y, filtered, evolution);
    if (basis != GABOR_PERLIN && !filtered)
        noise *= gabor_vec3(1.0f, gabor_vec2(1.0f / GABOR_CELLS_PER_RADIUS)) / GABOR_IMPL_ENERGY;
    return noise;
}

// Adds an octave (value, d/dx, d/dy per node spacing) to the sum, of which `kept` of the variance is left, with an
// amplitude. `lost` is the variance of its lost slopes along the lattice's axes.
GABOR_INLINE void gabor_impl_add_octave(GaborFractalNoise& sum, GaborImplOctave octave, int shape, float amplitude, gabor_vec3 noise,
                           float kept, gabor_vec2 lost) {
    gabor_vec2 gradient = gabor_vec2(gabor_cpp_dot(noise.yz(), octave.along_x), gabor_cpp_dot(noise.yz(), octave.along_y));
    gabor_vec3 covariance = gabor_vec3(gabor_cpp_dot(lost, octave.along_x * octave.along_x), gabor_cpp_dot(lost, octave.along_y * octave.along_y),
                           gabor_cpp_dot(lost, octave.along_x * octave.along_y));
    float value = noise.x;
    if (shape != GABOR_FBM) {
        gabor_vec2 mean = gabor_impl_mean_magnitude(value, kept);
        value = mean.x - 0.79788456f; // sqrt(2/pi)
        covariance += (1.0f - mean.y * mean.y) * gabor_vec3(gradient * gradient, gradient.x * gradient.y);
        gradient *= mean.y;
        kept = gabor_impl_kept_magnitude(kept);
        amplitude *= shape == GABOR_RIDGED ? -1.6588967f : 1.6588967f; // 1/sqrt(1 - 2/pi)
    }
    sum.noise += amplitude * value;
    sum.gradient += amplitude * gradient;
    sum.removed += amplitude * amplitude * kept;
    sum.lost += amplitude * amplitude * covariance;
}

GABOR_INLINE GaborFractalNoise gabor_impl_fractal(GaborPlace place, bool filtered, gabor_vec2 dx, gabor_vec2 dy, GaborFractal fractal,
                                     std::uint32_t seed) {
    GaborFractalNoise sum = GaborFractalNoise{0.0f, gabor_vec2(0.0f), 0.0f, gabor_vec3(0.0f)};
    if (!(gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy) < 1.0e6f)) { // too large, or NaN: nothing is left
        dx = gabor_vec2(1.0e3f, 0.0f);
        dy = gabor_vec2(0.0f, 1.0e3f);
    }
    GaborImplOctave octave = GaborImplOctave{place.cell, place.local, place.period, gabor_vec2(place.cells_per_radius.x, 0.0f),
                                             gabor_vec2(0.0f, place.cells_per_radius.y)};
    gabor_vec2 by = gabor_impl_octave_step(fractal);
    float octaves = gabor_cpp_clamp(fractal.octaves, 1.0f, 16.0f), amplitude = 1.0f, power = 0.0f;
    bool perlin = fractal.basis == GABOR_PERLIN;
    int count = int(gabor_cpp_ceil(octaves));
    for (int i = 0; i < count; ++i) {
        float weight = amplitude * gabor_cpp_min(octaves - float(i), 1.0f);
        power += weight * weight;
        amplitude *= fractal.gain;
        std::uint32_t salt = gabor_impl_octave_salt(seed, i);
        gabor_vec2 variance = gabor_vec2(0.0f), lost = gabor_vec2(0.0f);
        float oblique = 1.0f, kept = 1.0f;
        if (filtered) {
            gabor_vec2 a = gabor_cpp_clamp(0.5f * (dx.x * octave.along_x + dx.y * octave.along_y), -1.0e3f, 1.0e3f);
            gabor_vec2 b = gabor_cpp_clamp(0.5f * (dy.x * octave.along_x + dy.y * octave.along_y), -1.0e3f, 1.0e3f);
            variance = a * a + b * b;
            oblique = gabor_impl_oblique(a.x * a.y + b.x * b.y, variance.x, variance.y);
            gabor_vec2 even = gabor_vec2(gabor_impl_kept_even(variance.x), gabor_impl_kept_even(variance.y));
            kept = even.x * even.y;
            gabor_vec2 x = gabor_impl_slope_powers(variance.x, perlin), y = gabor_impl_slope_powers(variance.y, perlin);
            gabor_vec2 slopes = kept * gabor_vec2(x.x, y.x); // of u(x) u(y), or the terms of v(x) u(y) and u(x) v(y)
            if (perlin) {
                gabor_vec2 odd = gabor_vec2(gabor_impl_kept_odd(variance.x), gabor_impl_kept_odd(variance.y));
                odd = 0.5f * kept * odd / even;
                slopes = gabor_vec2(odd.x * x.y + odd.y * x.x, odd.x * y.x + odd.y * y.y);
                kept = odd.x + odd.y;
                oblique *= oblique * oblique;
            }
            oblique = gabor_cpp_min(oblique, gabor_cpp_inversesqrt(kept)) * gabor_impl_visible(kept * oblique * oblique);
            kept *= oblique * oblique;
            lost = gabor_cpp_max((perlin ? 2.6788926f : 1.4621636f) - oblique * oblique * slopes, 0.0f); // 19/70 pi^2, 4/27 pi^2
        }
        gabor_vec3 noise = gabor_vec3(0.0f);
        if (kept > 0.0f) {
            noise = gabor_impl_octave_noise(octave, salt, variance, fractal.basis, filtered, place.evolution);
            if (filtered) noise *= oblique;
        }
        gabor_impl_add_octave(sum, octave, fractal.shape, weight, noise, kept, lost);
        gabor_impl_next_octave(octave, place, by, fractal.lacunarity, i + 1);
    }
    float scale = gabor_cpp_inversesqrt(gabor_cpp_max(power, 1.0e-30f));
    sum.noise *= scale;
    sum.gradient *= scale;
    sum.lost *= scale * scale;
    sum.removed = filtered ? gabor_cpp_clamp(1.0f - scale * scale * sum.removed, 0.0f, 1.0f) : 0.0f;
    return sum;
}

GABOR_INLINE GaborFractalNoise gabor_fractal_noise(GaborPlace place, GaborFractal fractal, std::uint32_t seed) {
    return gabor_impl_fractal(place, false, gabor_vec2(0.0f), gabor_vec2(0.0f), fractal, seed);
}

GABOR_INLINE GaborFractalNoise gabor_fractal_noise_filtered(GaborPlace place, gabor_vec2 dx, gabor_vec2 dy, GaborFractal fractal, std::uint32_t seed) {
    return gabor_impl_fractal(place, true, dx, dy, fractal, seed);
}

GABOR_INLINE float gabor_smooth(gabor_vec2 p, std::uint32_t seed) {
    return gabor_fractal_noise(gabor_place_at(p), gabor_fractal(1.0f, 0.0f), seed).noise;
}

GABOR_INLINE float gabor_perlin(gabor_vec2 p, std::uint32_t seed) {
    GaborFractal fractal = gabor_fractal(1.0f, 0.0f);
    fractal.basis = GABOR_PERLIN;
    // the centroids of the spectra are 0.62 cycles per cell of Perlin noise and 0.5227 per kernel radius
    return gabor_fractal_noise(gabor_place_at(1.186f * p), fractal, seed).noise;
}

GABOR_INLINE float gabor_fbm(gabor_vec2 p, float octaves, float gain, std::uint32_t seed) {
    return gabor_fractal_noise(gabor_place_at(p), gabor_fractal(octaves, gain), seed).noise;
}

GABOR_INLINE float gabor_billow(gabor_vec2 p, float octaves, float gain, std::uint32_t seed) {
    GaborFractal fractal = gabor_fractal(octaves, gain);
    fractal.shape = GABOR_BILLOW;
    return gabor_fractal_noise(gabor_place_at(p), fractal, seed).noise;
}

GABOR_INLINE float gabor_ridged(gabor_vec2 p, float octaves, float gain, std::uint32_t seed) {
    return -gabor_billow(p, octaves, gain, seed);
}

GABOR_INLINE GaborWarp gabor_impl_moved(GaborPlace place, bool filtered, gabor_vec2 dx, gabor_vec2 dy, float strength, GaborFractal fractal,
                           std::uint32_t seed) {
    GaborFractalNoise x = gabor_impl_fractal(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 0));
    GaborFractalNoise y = gabor_impl_fractal(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 1));
    place.local += strength * gabor_vec2(x.noise, y.noise) * place.cells_per_radius;
    return GaborWarp{place, strength * gabor_vec2(x.gradient.x, y.gradient.x) + gabor_vec2(1.0f, 0.0f),
                     strength * gabor_vec2(x.gradient.y, y.gradient.y) + gabor_vec2(0.0f, 1.0f),
                     0.5f * strength * strength * (x.lost + y.lost)};
}

GABOR_INLINE GaborWarp gabor_warp(GaborPlace place, float strength, GaborFractal fractal, std::uint32_t seed) {
    return gabor_impl_moved(place, false, gabor_vec2(0.0f), gabor_vec2(0.0f), strength, fractal, seed);
}

GABOR_INLINE GaborWarp gabor_warp_filtered(GaborPlace place, gabor_vec2 dx, gabor_vec2 dy, float strength, GaborFractal fractal, std::uint32_t seed) {
    return gabor_impl_moved(place, true, dx, dy, strength, fractal, seed);
}

// ---- In a volume ---------------------------------------------------------------------------------------------------

// A place on the lattice of an octave: see GaborImplOctave.
struct GaborImplOctave3d {
    gabor_ivec3 cell;
    gabor_vec3 local;
    gabor_ivec3 period;
    gabor_vec3 along_x;
    gabor_vec3 along_y;
    gabor_vec3 along_z;
};

// A step to the next octave: lacunarity times a rotation about (1, 1, 1), v.x times the vector, v.y times its yzx and
// v.z times its zxy.
GABOR_INLINE gabor_vec3 gabor_impl_octave_step_3d(GaborFractal fractal) {
    gabor_vec2 turn = gabor_impl_wave(0.15915494f * gabor_cpp_clamp(fractal.turn, -1.0e6f, 1.0e6f)); // 1/(2 pi)
    float rest = (1.0f - turn.x) / 3.0f, side = 0.57735027f * turn.y; // 1/sqrt(3)
    return gabor_cpp_floor(4096.0f * gabor_cpp_clamp(fractal.lacunarity, 1.0f, 4.0f) * gabor_vec3(turn.x + rest, rest - side, rest + side) + 0.5f)
         / 4096.0f;
}

GABOR_INLINE gabor_vec3 gabor_impl_step_3d(gabor_vec3 by, gabor_vec3 v) {
    return by.x * v + by.y * v.yzx() + by.z * v.zxy();
}

GABOR_INLINE void gabor_impl_next_octave_3d(GaborImplOctave3d& octave, GaborPlace3d place, gabor_vec3 by, float lacunarity, int i) {
    gabor_vec3 moved = gabor_vec3(0.382f, 0.731f, 0.545f);
    if (place.period.x == 0 && place.period.y == 0 && place.period.z == 0) {
        octave.local = gabor_impl_step_3d(by, octave.local) + moved;
        if (place.cell.x != 0 || place.cell.y != 0 || place.cell.z != 0) {
            gabor_ivec3 m = gabor_ivec3(by * 4096.0f), low = octave.cell & gabor_ivec3(4095);
            gabor_uvec3 high = gabor_uvec3(octave.cell >> gabor_ivec3(12)), n = gabor_uvec3(m);
            gabor_ivec3 part = m.x * low + m.y * low.yzx() + m.z * low.zxy();
            octave.cell = gabor_ivec3(n.x * high + n.y * high.yzx() + n.z * high.zxy()) + (part >> gabor_ivec3(12));
            octave.local += gabor_vec3(part & gabor_ivec3(4095)) / 4096.0f;
        }
        octave.along_x = gabor_impl_step_3d(by, octave.along_x);
        octave.along_y = gabor_impl_step_3d(by, octave.along_y);
        octave.along_z = gabor_impl_step_3d(by, octave.along_z);
    } else {
        float scale = gabor_cpp_pow(gabor_cpp_clamp(lacunarity, 1.0f, 4.0f), float(i));
        gabor_vec3 first = gabor_vec3(place.period);
        gabor_vec3 within = gabor_vec3(float(gabor_impl_wrap(place.cell.x, place.period.x)),
                           float(gabor_impl_wrap(place.cell.y, place.period.y)),
                           float(gabor_impl_wrap(place.cell.z, place.period.z))) + place.local;
        gabor_vec3 nodes = gabor_vec3(gabor_impl_octave_nodes(first.x, scale), gabor_impl_octave_nodes(first.y, scale),
                          gabor_impl_octave_nodes(first.z, scale));
        gabor_vec3 growth = nodes / gabor_cpp_max(first, 1.0f);
        octave.cell = gabor_ivec3(0);
        octave.local = growth * (within - first * gabor_cpp_floor(within / gabor_cpp_max(first, 1.0f))) + float(i) * moved;
        octave.period = gabor_ivec3(place.period.x == 0 ? 0 : int(nodes.x), place.period.y == 0 ? 0 : int(nodes.y),
                              place.period.z == 0 ? 0 : int(nodes.z));
        octave.along_x = gabor_vec3(growth.x * place.cells_per_radius.x, 0.0f, 0.0f);
        octave.along_y = gabor_vec3(0.0f, growth.y * place.cells_per_radius.y, 0.0f);
        octave.along_z = gabor_vec3(0.0f, 0.0f, growth.z * place.cells_per_radius.z);
    }
}

GABOR_INLINE void gabor_impl_add_octave_3d(GaborFractalNoise3d& sum, GaborImplOctave3d octave, int shape, float amplitude,
                              gabor_vec4 noise, float kept, gabor_vec3 lost) {
    gabor_vec3 gradient = gabor_vec3(gabor_cpp_dot(noise.yzw(), octave.along_x), gabor_cpp_dot(noise.yzw(), octave.along_y),
                         gabor_cpp_dot(noise.yzw(), octave.along_z));
    gabor_vec3 covariance = gabor_vec3(gabor_cpp_dot(lost, octave.along_x * octave.along_x), gabor_cpp_dot(lost, octave.along_y * octave.along_y),
                           gabor_cpp_dot(lost, octave.along_z * octave.along_z));
    gabor_vec3 mixed = gabor_vec3(gabor_cpp_dot(lost, octave.along_x * octave.along_y), gabor_cpp_dot(lost, octave.along_x * octave.along_z),
                      gabor_cpp_dot(lost, octave.along_y * octave.along_z));
    float value = noise.x;
    if (shape != GABOR_FBM) {
        gabor_vec2 mean = gabor_impl_mean_magnitude(value, kept);
        value = mean.x - 0.79788456f; // sqrt(2/pi)
        covariance += (1.0f - mean.y * mean.y) * gradient * gradient;
        mixed += (1.0f - mean.y * mean.y) * gabor_vec3(gradient.x * gradient.yz(), gradient.y * gradient.z);
        gradient *= mean.y;
        kept = gabor_impl_kept_magnitude(kept);
        amplitude *= shape == GABOR_RIDGED ? -1.6588967f : 1.6588967f; // 1/sqrt(1 - 2/pi)
    }
    sum.noise += amplitude * value;
    sum.gradient += amplitude * gradient;
    sum.removed += amplitude * amplitude * kept;
    sum.lost += amplitude * amplitude * covariance;
    sum.lost_mixed += amplitude * amplitude * mixed;
}

// The words of the lattice's rows in slice k, given those of rows in any slice, and as many words independent of them.
GABOR_INLINE gabor_uvec4 gabor_impl_slice_words(gabor_uvec4 rows, std::uint32_t slice) {
    return gabor_uvec4(gabor_impl_slice_word(rows.x, slice), gabor_impl_slice_word(rows.y, slice),
                 gabor_impl_slice_word(rows.z, slice), gabor_impl_slice_word(rows.w, slice));
}

GABOR_INLINE gabor_uvec4 gabor_impl_other_words(gabor_uvec4 words) {
    return (((words ^ (words >> gabor_uvec4(15u))) * 0xd35a2d97u) >> gabor_uvec4(8u)) | gabor_uvec4(0x800001u);
}

// Adds a slice of smooth noise to (value, d/dx, d/dy, d/dz).
GABOR_INLINE void gabor_impl_add_smooth_slice(gabor_vec4& sum, GaborImplLine x, GaborImplLine y, std::uint32_t slice, gabor_vec2 even, bool four,
                                 float evolution) {
    y.word = gabor_impl_slice_words(y.word, slice);
    gabor_vec3 noise = gabor_impl_smooth_sum(x, y, four, evolution);
    sum += gabor_vec4(even.x * noise, even.y * noise.x);
}

GABOR_INLINE gabor_vec4 gabor_impl_smooth_sum_3d(GaborImplLine x, GaborImplLine y, GaborImplLine z, bool four, float evolution) {
    gabor_vec4 sum = gabor_vec4(0.0f);
    gabor_impl_add_smooth_slice(sum, x, y, z.word.x, gabor_vec2(z.even.x, z.even_slope.x), four, evolution);
    gabor_impl_add_smooth_slice(sum, x, y, z.word.y, gabor_vec2(z.even.y, z.even_slope.y), four, evolution);
    gabor_impl_add_smooth_slice(sum, x, y, z.word.z, gabor_vec2(z.even.z, z.even_slope.z), four, evolution);
    if (four) gabor_impl_add_smooth_slice(sum, x, y, z.word.w, gabor_vec2(z.even.w, z.even_slope.w), four, evolution);
    return sum;
}

// Adds a slice of Perlin noise: v(x) u(y) and u(x) v(y) times u(z), and u(x) u(y) times v(z).
GABOR_INLINE void gabor_impl_add_perlin_slice(gabor_vec4& sum, GaborImplLine x, GaborImplLine y, std::uint32_t slice, gabor_vec2 even, gabor_vec2 odd,
                                 float evolution) {
    y.word = gabor_impl_slice_words(y.word, slice);
    gabor_vec3 noise = gabor_impl_perlin_sum(x, y, evolution);
    y.word = gabor_impl_other_words(y.word);
    gabor_vec3 third = gabor_impl_smooth_sum(x, y, true, evolution);
    sum += gabor_vec4(even.x * noise + odd.x * third, even.y * noise.x + odd.y * third.x);
}

// Three terms, with variance 3.
GABOR_INLINE gabor_vec4 gabor_impl_perlin_sum_3d(GaborImplLine x, GaborImplLine y, GaborImplLine z, float evolution) {
    gabor_vec4 sum = gabor_vec4(0.0f);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.x, gabor_vec2(z.even.x, z.even_slope.x), gabor_vec2(z.odd.x, z.odd_slope.x),
                                evolution);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.y, gabor_vec2(z.even.y, z.even_slope.y), gabor_vec2(z.odd.y, z.odd_slope.y),
                                evolution);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.z, gabor_vec2(z.even.z, z.even_slope.z), gabor_vec2(z.odd.z, z.odd_slope.z),
                                evolution);
    gabor_impl_add_perlin_slice(sum, x, y, z.word.w, gabor_vec2(z.even.w, z.even_slope.w), gabor_vec2(z.odd.w, z.odd_slope.w),
                                evolution);
    return sum;
}

GABOR_INLINE gabor_vec4 gabor_impl_octave_noise_3d(GaborImplOctave3d octave, std::uint32_t salt, gabor_vec3 variance, int basis, bool filtered,
                                float evolution) {
    GaborImplLine x = gabor_impl_nodes(octave.cell.x, octave.local.x, octave.period.x, salt, variance.x, basis,
                                      filtered);
    GaborImplLine y = gabor_impl_nodes(octave.cell.y, octave.local.y, octave.period.y, salt ^ GABOR_IMPL_ROWS,
                                      variance.y, basis, filtered);
    GaborImplLine z = gabor_impl_nodes(octave.cell.z, octave.local.z, octave.period.z, salt ^ GABOR_IMPL_SLICES,
                                      variance.z, basis, filtered);
    gabor_vec4 noise;
    if (basis == GABOR_PERLIN) noise = 0.57735027f * gabor_impl_perlin_sum_3d(x, y, z, evolution); // 1/sqrt(3)
    else noise = gabor_impl_smooth_sum_3d(x, y, z, filtered, evolution);
    if (basis != GABOR_PERLIN && !filtered)
        noise *= gabor_vec4(1.0f, gabor_vec3(1.0f / GABOR_CELLS_PER_RADIUS)) * (gabor_cpp_inversesqrt(GABOR_IMPL_ENERGY) / GABOR_IMPL_ENERGY);
    return noise;
}

GABOR_INLINE GaborFractalNoise3d gabor_impl_fractal_3d(GaborPlace3d place, bool filtered, gabor_vec3 dx, gabor_vec3 dy, GaborFractal fractal,
                                          std::uint32_t seed) {
    GaborFractalNoise3d sum = GaborFractalNoise3d{0.0f, gabor_vec3(0.0f), 0.0f, gabor_vec3(0.0f), gabor_vec3(0.0f)};
    if (!(gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy) < 1.0e6f)) { // too large, or NaN: nothing is left
        dx = gabor_vec3(1.0e3f, 0.0f, 0.0f);
        dy = gabor_vec3(0.0f, 1.0e3f, 1.0e3f);
    }
    GaborImplOctave3d octave = GaborImplOctave3d{place.cell, place.local, place.period,
                                                 gabor_vec3(place.cells_per_radius.x, 0.0f, 0.0f),
                                                 gabor_vec3(0.0f, place.cells_per_radius.y, 0.0f),
                                                 gabor_vec3(0.0f, 0.0f, place.cells_per_radius.z)};
    gabor_vec3 by = gabor_impl_octave_step_3d(fractal);
    float octaves = gabor_cpp_clamp(fractal.octaves, 1.0f, 16.0f), amplitude = 1.0f, power = 0.0f;
    bool perlin = fractal.basis == GABOR_PERLIN;
    int count = int(gabor_cpp_ceil(octaves));
    for (int i = 0; i < count; ++i) {
        float weight = amplitude * gabor_cpp_min(octaves - float(i), 1.0f);
        power += weight * weight;
        amplitude *= fractal.gain;
        std::uint32_t salt = gabor_impl_octave_salt(seed, i);
        gabor_vec3 variance = gabor_vec3(0.0f), lost = gabor_vec3(0.0f);
        float oblique = 1.0f, kept = 1.0f;
        if (filtered) {
            gabor_vec3 a = 0.5f * (dx.x * octave.along_x + dx.y * octave.along_y + dx.z * octave.along_z);
            gabor_vec3 b = 0.5f * (dy.x * octave.along_x + dy.y * octave.along_y + dy.z * octave.along_z);
            a = gabor_cpp_clamp(a, -1.0e3f, 1.0e3f);
            b = gabor_cpp_clamp(b, -1.0e3f, 1.0e3f);
            variance = a * a + b * b;
            oblique = gabor_impl_oblique(a.x * a.y + b.x * b.y, variance.x, variance.y)
                    * gabor_impl_oblique(a.x * a.z + b.x * b.z, variance.x, variance.z)
                    * gabor_impl_oblique(a.y * a.z + b.y * b.z, variance.y, variance.z);
            gabor_vec3 even = gabor_vec3(gabor_impl_kept_even(variance.x), gabor_impl_kept_even(variance.y),
                             gabor_impl_kept_even(variance.z));
            kept = even.x * even.y * even.z;
            gabor_vec2 x = gabor_impl_slope_powers(variance.x, perlin), y = gabor_impl_slope_powers(variance.y, perlin);
            gabor_vec2 z = gabor_impl_slope_powers(variance.z, perlin);
            gabor_vec3 slopes = kept * gabor_vec3(x.x, y.x, z.x);
            if (perlin) {
                gabor_vec3 odd = gabor_vec3(gabor_impl_kept_odd(variance.x), gabor_impl_kept_odd(variance.y),
                                gabor_impl_kept_odd(variance.z));
                odd = 0.33333333f * kept * odd / even; // 1/3
                slopes = gabor_vec3(odd.x * x.y + (odd.y + odd.z) * x.x, odd.y * y.y + (odd.x + odd.z) * y.x,
                              odd.z * z.y + (odd.x + odd.y) * z.x);
                kept = odd.x + odd.y + odd.z;
                oblique *= oblique * oblique;
            }
            oblique = gabor_cpp_min(oblique, gabor_cpp_inversesqrt(kept)) * gabor_impl_visible(kept * oblique * oblique);
            kept *= oblique * oblique;
            lost = gabor_cpp_max((perlin ? 2.2559096f : 1.4621636f) - oblique * oblique * slopes, 0.0f); // 8/35 pi^2, 4/27 pi^2
        }
        gabor_vec4 noise = gabor_vec4(0.0f);
        if (kept > 0.0f) {
            noise = gabor_impl_octave_noise_3d(octave, salt, variance, fractal.basis, filtered, place.evolution);
            if (filtered) noise *= oblique;
        }
        gabor_impl_add_octave_3d(sum, octave, fractal.shape, weight, noise, kept, lost);
        gabor_impl_next_octave_3d(octave, place, by, fractal.lacunarity, i + 1);
    }
    float scale = gabor_cpp_inversesqrt(gabor_cpp_max(power, 1.0e-30f));
    sum.noise *= scale;
    sum.gradient *= scale;
    sum.lost *= scale * scale;
    sum.lost_mixed *= scale * scale;
    sum.removed = filtered ? gabor_cpp_clamp(1.0f - scale * scale * sum.removed, 0.0f, 1.0f) : 0.0f;
    return sum;
}

GABOR_INLINE GaborFractalNoise3d gabor_fractal_noise_3d(GaborPlace3d place, GaborFractal fractal, std::uint32_t seed) {
    return gabor_impl_fractal_3d(place, false, gabor_vec3(0.0f), gabor_vec3(0.0f), fractal, seed);
}

GABOR_INLINE GaborFractalNoise3d gabor_fractal_noise_3d_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, GaborFractal fractal,
                                                    std::uint32_t seed) {
    return gabor_impl_fractal_3d(place, true, dx, dy, fractal, seed);
}

GABOR_INLINE float gabor_perlin_3d(gabor_vec3 p, std::uint32_t seed) {
    GaborFractal fractal = gabor_fractal(1.0f, 0.0f);
    fractal.basis = GABOR_PERLIN;
    return gabor_fractal_noise_3d(gabor_place_3d_at(1.186f * p), fractal, seed).noise; // as in gabor_perlin
}

GABOR_INLINE float gabor_fbm_3d(gabor_vec3 p, float octaves, float gain, std::uint32_t seed) {
    return gabor_fractal_noise_3d(gabor_place_3d_at(p), gabor_fractal(octaves, gain), seed).noise;
}

GABOR_INLINE GaborWarp3d gabor_impl_moved_3d(GaborPlace3d place, bool filtered, gabor_vec3 dx, gabor_vec3 dy, float strength,
                                GaborFractal fractal, std::uint32_t seed) {
    GaborFractalNoise3d x = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 0));
    GaborFractalNoise3d y = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 1));
    GaborFractalNoise3d z = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 2));
    place.local += strength * gabor_vec3(x.noise, y.noise, z.noise) * place.cells_per_radius;
    float power = strength * strength / 3.0f;
    return GaborWarp3d{place, strength * gabor_vec3(x.gradient.x, y.gradient.x, z.gradient.x) + gabor_vec3(1.0f, 0.0f, 0.0f),
                       strength * gabor_vec3(x.gradient.y, y.gradient.y, z.gradient.y) + gabor_vec3(0.0f, 1.0f, 0.0f),
                       strength * gabor_vec3(x.gradient.z, y.gradient.z, z.gradient.z) + gabor_vec3(0.0f, 0.0f, 1.0f),
                       power * (x.lost + y.lost + z.lost), power * (x.lost_mixed + y.lost_mixed + z.lost_mixed)};
}

GABOR_INLINE GaborWarp3d gabor_warp_3d(GaborPlace3d place, float strength, GaborFractal fractal, std::uint32_t seed) {
    return gabor_impl_moved_3d(place, false, gabor_vec3(0.0f), gabor_vec3(0.0f), strength, fractal, seed);
}

GABOR_INLINE GaborWarp3d gabor_warp_3d_filtered(GaborPlace3d place, gabor_vec3 dx, gabor_vec3 dy, float strength, GaborFractal fractal,
                                   std::uint32_t seed) {
    return gabor_impl_moved_3d(place, true, dx, dy, strength, fractal, seed);
}

#endif
