// clang-format off
// Generated from gabor_spectrum.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
// Includes gabor_noise.hpp; pasted after their texts, it includes nothing.
//
// gabor_spectrum.hpp: Gabor noise with any power spectrum, isotropic noise, and profiles of stripes.
//
//     float n = gabor_noise_isotropic(p, 2.0, 7u);   // waves in all directions: mean 0, variance 1
//
//     I want                                   call
//     isotropic noise                          gabor_noise_isotropic
//     a range of directions or frequencies     gabor_noise_spread
//     a spectrum of my own                     gabor_field_lobes
//     rectangular, round or sharp stripes      gabor_profile_pulse and so on, after gabor_stripes
//     derivatives, periods, an evolution       a place, then gabor_field_isotropic, _spread or _lobes
//     noise averaged over a pixel              gabor_filter.hpp
//
// Arguments and fields are those of gabor_noise.hpp.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifndef GABOR_NOISE_HPP
#include "gabor_noise.hpp"
#endif
#ifndef GABOR_SPECTRUM_HPP
#define GABOR_SPECTRUM_HPP 1

// ---- Isotropic noise at a constant cost ----------------------------------------------------------------------------

// float gabor_noise_isotropic(vec2 p, float frequency, uint seed)
// GaborField gabor_field_isotropic(GaborPlace place, float frequency, uint seed)
//     Noise of waves in all directions, at the same cost for every frequency: 4 to 6 times that of gabor_noise. It has
//     mean 0 and variance 1; value and gradient are normal at every point. The power varies with direction only because
//     of the window, by 7 % at frequency 0 and 0.1 % at 1. Values at several points together follow a mixture of normal
//     distributions; those of gabor_noise_spread, a sum over directions, are jointly normal. At each point the
//     quadrature is independent of the noise, but not of the noise's gradient.

// ---- A range of waves ----------------------------------------------------------------------------------------------

// float gabor_noise_spread(vec2 p, float frequency, float orientation, float frequency_spread,
//                          float orientation_spread, uint seed)
// GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
//                               float orientation_spread, uint seed)
//     Noise of many waves. Their orientations are within `orientation_spread` radians of `orientation`, and their
//     frequencies within the fraction `frequency_spread` (0 to 1) of `frequency`, spread as evenly as lobes of kernel
//     radius 1 allow. An orientation_spread of pi/2 gives isotropic noise; its power varies with direction by at most
//     5 % at frequencies from 0.12 to 14, by up to 7 % at lower ones, and beyond 14, where 64 directions are too few,
//     by 34 % at 20. The noise has mean 0 and variance 1; it and its derivatives are normal. It is continuous where the
//     arguments are. Costs one gabor_noise per lobe. There are
//         2.86 frequency_spread frequency + 0.8 frequencies, 1 to 16, each with
//         (4.44 frequency + 0.6) orientation_spread / (pi/2) + 0.8 directions, 1 to 64,
//     both rounded down: 10 directions for isotropic noise of frequency 2. Just before one of these numbers changes,
//     for a fifth of all arguments, the noise is a sum of both sets of lobes, the old and the new.

// ---- Sums of lobes -------------------------------------------------------------------------------------------------

// The maximum number of lobes in a GaborLobes; to change it, define it before this file.
#ifndef GABOR_LOBES
#define GABOR_LOBES 4
#endif
#if GABOR_LOBES < 1
#error GABOR_LOBES must be an int, at least 1
#endif

// A lobe: waves around one wave vector.
struct GaborLobe {
    float cycles_per_unit; // the waves' frequency per unit of p, whatever the radius
    float orientation;     // as in gabor_noise
    gabor_vec2 radius;           // radius of the lobe's kernels along x and y in units of p, positive. The lobe's standard
                           // deviation along each axis is 1/sqrt(12) / radius cycles per unit of p
    float power;           // power relative to the other lobes, not negative
};

// A power spectrum: the first `count` lobes, at most GABOR_LOBES.
struct GaborLobes {
    GaborLobe lobe[GABOR_LOBES] = {};
    int count;
};

// GaborLobe gabor_lobe(float cycles_per_unit, float orientation, float radius, float power)
//     A lobe whose kernels are as wide along x as along y.

// GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, uint seed)
//     The noise of several lobes: a sum of independent noises, normal with mean 0 and variance 1. Its gradients are per
//     unit of p. Costs one gabor_noise per lobe.
//         #define GABOR_LOBES 2              // before the file
//         GaborLobes lobes;
//         lobes.lobe[0] = gabor_lobe(4.0, 0.0, 1.0, 2.0);
//         lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.5, 1.0);
//         lobes.count = 2;
//         float n = gabor_field_lobes(gabor_place_at(p), lobes, 7u).noise;

// ---- Profiles of stripes, each from 0 to 1 -------------------------------------------------------------------------
//
// They take the (cosine, sine) of stripes. The profile is sharp where this vector has length 1. Where it is shorter,
// because a filter removed variance or stripes fork, the profile is averaged over a range of phases whose mean vector
// has that length. So a phase of t turns, averaged over w turns, is sin(pi w) / (pi w) vec2(cos(2 pi t), sin(2 pi t)).

// float gabor_profile_triangle(vec2 stripes)
//     Straight lines from 0 at phase 0 to 1 at half a turn and back.

// float gabor_profile_sawtooth(vec2 stripes)
//     A straight line from 0 at phase 0 to 1 after a turn.

// float gabor_profile_pulse(vec2 stripes, float duty)
//     1 for the first `duty` (0 to 1) of each turn, then 0.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// ---- Lobes ---------------------------------------------------------------------------------------------------------

// The same position, period and evolution, for kernels whose radius is `radius` times the place's. The position is
// rounded to a float, within the period if there is one.
GABOR_INLINE GaborPlace gabor_impl_stretched(GaborPlace place, gabor_vec2 radius) {
    gabor_ivec2 cell = gabor_ivec2(gabor_impl_wrap(place.cell.x, place.period.x), gabor_impl_wrap(place.cell.y, place.period.y));
    gabor_vec2 unit = 1.0f / (place.cells_per_radius * radius);
    GaborPlace stretched = gabor_place_tiled((gabor_vec2(cell) + place.local) * unit, gabor_vec2(place.period) * unit);
    stretched.evolution = place.evolution;
    return stretched;
}

// A lobe's wave vector, in cycles per kernel radius along each axis.
GABOR_INLINE gabor_vec2 gabor_impl_lobe_wave(GaborLobe lobe) {
    gabor_vec2 wave = gabor_wave_vector(lobe.cycles_per_unit * lobe.radius.x, lobe.orientation);
    return gabor_vec2(wave.x, wave.y * (lobe.radius.y / lobe.radius.x));
}

GABOR_INLINE float gabor_impl_lobes_power(GaborLobes lobes) {
    float power = 0.0f;
    for (int i = 0; i < gabor_cpp_min(lobes.count, GABOR_LOBES); ++i)
        power += lobes.lobe[i].power;
    return power;
}

GABOR_INLINE GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, std::uint32_t seed) {
    GaborField sum = GaborField{0.0f, gabor_vec2(0.0f), 0.0f, gabor_vec2(0.0f), 0.0f};
    float power = gabor_impl_lobes_power(lobes);
    for (int i = 0; i < gabor_cpp_min(lobes.count, GABOR_LOBES); ++i) {
        GaborLobe lobe = lobes.lobe[i];
        GaborField field = gabor_field(gabor_impl_stretched(place, lobe.radius), gabor_impl_lobe_wave(lobe),
                                       gabor_derived_seed(seed, i));
        gabor_impl_add_field(sum, field, power > 0.0f ? gabor_cpp_sqrt(lobe.power / power) : 0.0f, 1.0f / lobe.radius);
    }
    return sum;
}

GABOR_INLINE GaborLobe gabor_lobe(float cycles_per_unit, float orientation, float radius, float power) {
    return GaborLobe{cycles_per_unit, orientation, gabor_vec2(radius), power};
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is cut into equal pieces of at most 0.7 cycles per kernel radius, with a lobe in the middle of each.
// The power of Hann's window has a standard deviation of 1/sqrt(12) cycles per kernel radius, so the sum of the lobes
// is nearly flat. The number of pieces is the integer part of a number c. As the fraction of c goes from 0.8 to 1,
// these pieces fade out and a set with one more piece fades in, so that the noise is continuous in frequency and
// spread.

// The number of lobes for `c`; while one set fades into the next, the total of both.
GABOR_INLINE int gabor_impl_pieces(float c) {
    return gabor_cpp_fract(c) > 0.8f ? 2 * int(c) + 1 : int(c);
}

// Returns lobe `i` as (position in the range, from -1 to 1; share of the power; number from which its seed derives).
GABOR_INLINE gabor_vec3 gabor_impl_piece(int i, float c) {
    int n = int(c);
    float left = gabor_cpp_min(5.0f - 5.0f * gabor_cpp_fract(c), 1.0f);
    if (i >= n) {
        i -= n;
        n += 1;
        left = 1.0f - left;
    }
    float width = 1.0f / float(n);
    return gabor_vec3((2.0f * float(i) + 1.0f) * width - 1.0f, gabor_impl_takeover(left) * width, float(i + (n & 1) * 64));
}

GABOR_INLINE GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
                              float orientation_spread, std::uint32_t seed) {
    GaborField sum = GaborField{0.0f, gabor_vec2(0.0f), 0.0f, gabor_vec2(0.0f), 0.0f};
    frequency = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f);
    frequency_spread = gabor_cpp_clamp(frequency_spread, 0.0f, 1.0f);
    orientation_spread = gabor_cpp_clamp(orientation_spread, 0.0f, 1.5707963f); // pi/2
    float shells = gabor_cpp_clamp(2.857f * frequency_spread * frequency + 0.8f, 1.0f, 16.0f);
    int shell_count = gabor_impl_pieces(shells);
    for (int j = 0; j < shell_count; ++j) {
        gabor_vec3 shell = gabor_impl_piece(j, shells);
        float magnitude = frequency * (1.0f + frequency_spread * shell.x);
        float directions = gabor_cpp_clamp(0.63661977f * orientation_spread * (4.44f * magnitude + 0.6f) + 0.8f, 1.0f, 64.0f); // 2/pi
        int direction_count = gabor_impl_pieces(directions);
        for (int i = 0; i < direction_count; ++i) {
            gabor_vec3 direction = gabor_impl_piece(i, directions);
            gabor_vec2 wave = gabor_wave_vector(magnitude, orientation + orientation_spread * direction.x);
            GaborField field = gabor_field(place, wave, gabor_derived_seed(seed, int(128.0f * shell.z + direction.z)));
            gabor_impl_add_field(sum, field, gabor_cpp_sqrt(shell.y * direction.y), gabor_vec2(1.0f));
        }
    }
    return sum;
}

GABOR_INLINE float gabor_noise_spread(gabor_vec2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         std::uint32_t seed) {
    return gabor_field_spread(gabor_place_at(p), frequency, orientation, frequency_spread, orientation_spread,
                              seed).noise;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three unit vectors u_cm, 60 degrees apart and turned at random, each with its own amplitude:
//     n(p) = K / sqrt(3) Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with variance 1. Its gradient is normal with the constant covariance
// K^2 E|A|^2 / 2 sum_c (grad h grad h^T + 2 pi^2 F^2 h^2 I), because sum_m u_cm u_cm^T = 3/2 I, with I the identity.
// Value and gradient are independent. Since none of this depends on the directions, both are also normal over random
// directions.

// 0.57735027 is 1/sqrt(3)
#define GABOR_IMPL_STAR (0.57735027f / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY))

// The three waves of a node: amplitudes times the waves at the point, and unit vectors along the first two wave
// vectors. The third is their difference, and so is its phase.
struct GaborImplStar {
    gabor_vec2 first;
    gabor_vec2 second;
    gabor_vec2 third;
    gabor_vec2 u;
    gabor_vec2 v;
};

// `d`: offset of the point from the node, in periods of the waves.
GABOR_INLINE GaborImplStar gabor_impl_star(gabor_uvec4 words, gabor_vec2 d, float evolution) {
    GaborImplStar star;
    // 3.8805107e-11 is 2^-31 / 12
    star.u = gabor_impl_half_turn(3.8805107e-11f * float(int(words.w))); // up to a twelfth of a turn either way
    star.v = 0.5f * star.u + 0.8660254f * gabor_vec2(-star.u.y, star.u.x); // sqrt(3)/2
    star.first = gabor_impl_wave(gabor_cpp_dot(star.u, d));
    star.second = gabor_impl_wave(gabor_cpp_dot(star.v, d));
    star.third = gabor_impl_product(star.second, gabor_vec2(star.first.x, -star.first.y));
    star.first = gabor_impl_product(gabor_impl_amplitude_at(words.x, evolution), star.first);
    star.second = gabor_impl_product(gabor_impl_amplitude_at(words.y, evolution), star.second);
    star.third = gabor_impl_product(gabor_impl_amplitude_at(words.z, evolution), star.third);
    return star;
}

// Adds a wave of a node: `a` is its amplitude times the wave at the point, `window` the value and gradient of the
// node's window.
GABOR_INLINE void gabor_impl_add_wave(GaborField& sum, gabor_vec3 window, gabor_vec2 a, gabor_vec2 wave) {
    gabor_vec2 value = window.x * a;
    sum.noise += value.y;
    sum.gradient += a.y * window.yz() + 6.2831853f * value.x * wave; // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += a.x * window.yz() - 6.2831853f * value.y * wave;
}

// Unrolling these loops by hand made them four times slower on lavapipe.
GABOR_INLINE GaborField gabor_field_isotropic(GaborPlace place, float frequency, std::uint32_t seed) {
    std::uint32_t salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0f, place.cells_per_radius.x);
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0f,
                                      place.cells_per_radius.y);
    gabor_vec2 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    frequency = gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f);
    GaborField sum = GaborField{0.0f, gabor_vec2(0.0f), 0.0f, gabor_vec2(0.0f), 0.0f};
    for (int j = 0; j < GABOR_TAPS; ++j) {
        gabor_uvec4 row = gabor_impl_row(y.word[j]);
        for (int i = 0; i < GABOR_TAPS; ++i) {
            gabor_vec2 d = frequency / place.cells_per_radius * gabor_vec2(x.offset - float(i - 1), y.offset - float(j - 1));
            GaborImplStar star = gabor_impl_star(x.word[i] * row, d, place.evolution);
            gabor_vec2 h = gabor_vec2(x.node[i].x, y.node[j].x);
            gabor_vec3 window = gabor_vec3(h.x * h.y, stretch * gabor_vec2(x.node[i].z, y.node[j].z) * h.yx());
            gabor_impl_add_wave(sum, window, star.first, frequency * star.u);
            gabor_impl_add_wave(sum, window, star.second, frequency * star.v);
            gabor_impl_add_wave(sum, window, star.third, frequency * (star.v - star.u));
        }
    }
    GaborField field = GaborField{0.0f, gabor_vec2(0.0f), 0.0f, gabor_vec2(0.0f), 0.0f};
    gabor_impl_add_field(field, sum, GABOR_IMPL_STAR, gabor_vec2(1.0f));
    return field;
}

GABOR_INLINE float gabor_noise_isotropic(gabor_vec2 p, float frequency, std::uint32_t seed) {
    return gabor_field_isotropic(gabor_place_at(p), frequency, seed).noise;
}

// ---- Profiles ------------------------------------------------------------------------------------------------------

// Returns (phase - width / 2, phase + width / 2, 1 / width) of stripes, in turns. The mean of a unit vector over
// `width` turns has the length sin(pi width) / (pi width); the polynomial inverts this within 0.0025. The mean of a
// profile between the ends is the change of its integral from one end to the other, divided by the width. Each whole
// turn adds the integral of one period.
GABOR_INLINE gabor_vec3 gabor_impl_ends_at(float phase, float span) {
    float y = gabor_cpp_max(1.0f - span, 0.0f);
    // the others are a fit: see tools/constants.py
    float width = gabor_cpp_sqrt(y) * (0.7796968f + y * (0.13925488f + y * (0.1322011f * y - 0.05362376f))); // sqrt(6)/pi
    width = gabor_cpp_clamp(width, 0.001f, 1.0f);
    phase -= gabor_cpp_floor(phase);
    return gabor_vec3(phase - 0.5f * width, phase + 0.5f * width, 1.0f / width);
}

GABOR_INLINE gabor_vec3 gabor_impl_ends(gabor_vec2 stripes) {
    gabor_vec2 phasor = gabor_turns_intensity(stripes.yx());
    return gabor_impl_ends_at(phasor.x, phasor.y);
}

GABOR_INLINE float gabor_impl_triangle_integral(float x) {
    float turns = gabor_cpp_floor(x), t = x - turns;
    return 0.5f * turns + (t < 0.5f ? t * t : 2.0f * t - t * t - 0.5f);
}

GABOR_INLINE float gabor_profile_triangle(gabor_vec2 stripes) {
    gabor_vec3 ends = gabor_impl_ends(stripes);
    return ends.z * (gabor_impl_triangle_integral(ends.y) - gabor_impl_triangle_integral(ends.x));
}

GABOR_INLINE float gabor_impl_sawtooth_integral(float x) {
    float turns = gabor_cpp_floor(x), t = x - turns;
    return 0.5f * (turns + t * t);
}

GABOR_INLINE float gabor_profile_sawtooth(gabor_vec2 stripes) {
    gabor_vec3 ends = gabor_impl_ends(stripes);
    return ends.z * (gabor_impl_sawtooth_integral(ends.y) - gabor_impl_sawtooth_integral(ends.x));
}

GABOR_INLINE float gabor_impl_pulse_integral(float x, float duty) {
    float turns = gabor_cpp_floor(x);
    return duty * turns + gabor_cpp_min(x - turns, duty);
}

GABOR_INLINE float gabor_profile_pulse(gabor_vec2 stripes, float duty) {
    gabor_vec3 ends = gabor_impl_ends(stripes);
    return ends.z * (gabor_impl_pulse_integral(ends.y, duty) - gabor_impl_pulse_integral(ends.x, duty));
}

#endif
