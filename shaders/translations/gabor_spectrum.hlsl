// Generated from gabor_spectrum.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl; pasted after their texts, it includes nothing.
//
// gabor_spectrum.hlsl: Gabor noise with any power spectrum, isotropic noise, and profiles of stripes.
//
//     float n = gabor_noise_isotropic(p, 2.0, 7u);   // waves in all directions: mean 0, variance 1
//
//     I want                                   call
//     isotropic noise                          gabor_noise_isotropic
//     a range of directions or frequencies     gabor_noise_spread
//     a spectrum of my own                     gabor_field_lobes
//     rectangular, round or sharp stripes      gabor_profile_pulse and so on, after gabor_stripes
//     derivatives, periods, an evolution       a place, then gabor_field_isotropic, _spread or _lobes
//     noise averaged over a pixel              gabor_filter.hlsl
//
// Arguments and fields are those of gabor_noise.hlsl.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#ifndef GABOR_SPECTRUM_HLSL
#define GABOR_SPECTRUM_HLSL 1

// ---- Isotropic noise at a constant cost ----------------------------------------------------------------------------

// float gabor_noise_isotropic(float2 p, float frequency, uint seed)
// GaborField gabor_field_isotropic(GaborPlace place, float frequency, uint seed)
//     Noise of waves in all directions, at the same cost for every frequency: 4 to 6 times that of gabor_noise. It has
//     mean 0 and variance 1; value and gradient are normal at every point. The power varies with direction only because
//     of the window, by 7 % at frequency 0 and 0.1 % at 1. Values at several points together follow a mixture of normal
//     distributions; those of gabor_noise_spread, a sum over directions, are jointly normal. At each point the
//     quadrature is independent of the noise, but not of the noise's gradient.

// ---- A range of waves ----------------------------------------------------------------------------------------------

// float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread,
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
    float2 radius;           // radius of the lobe's kernels along x and y in units of p, positive. The lobe's standard
                           // deviation along each axis is 1/sqrt(12) / radius cycles per unit of p
    float power;           // power relative to the other lobes, not negative
};

GaborLobe GaborLobe_of(float cycles_per_unit, float orientation, float2 radius, float power) {
    GaborLobe made = {cycles_per_unit, orientation, radius, power};
    return made;
}

// A power spectrum: the first `count` lobes, at most GABOR_LOBES.
struct GaborLobes {
    GaborLobe lobe[GABOR_LOBES];
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
// has that length. So a phase of t turns, averaged over w turns, is sin(pi w) / (pi w) float2(cos(2 pi t), sin(2 pi t)).

// float gabor_profile_triangle(float2 stripes)
//     Straight lines from 0 at phase 0 to 1 at half a turn and back.

// float gabor_profile_sawtooth(float2 stripes)
//     A straight line from 0 at phase 0 to 1 after a turn.

// float gabor_profile_pulse(float2 stripes, float duty)
//     1 for the first `duty` (0 to 1) of each turn, then 0.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// ---- Lobes ---------------------------------------------------------------------------------------------------------

// The same position, period and evolution, for kernels whose radius is `radius` times the place's. The position is
// rounded to a float, within the period if there is one.
GaborPlace gabor_impl_stretched(GaborPlace place, float2 radius) {
    int2 cell = int2(gabor_impl_wrap(place.cell.x, place.period.x), gabor_impl_wrap(place.cell.y, place.period.y));
    float2 unit = 1.0 / (place.cells_per_radius * radius);
    GaborPlace stretched = gabor_place_tiled(((float2)(cell) + place.local) * unit, (float2)(place.period) * unit);
    stretched.evolution = place.evolution;
    return stretched;
}

// A lobe's wave vector, in cycles per kernel radius along each axis.
float2 gabor_impl_lobe_wave(GaborLobe lobe) {
    float2 wave = gabor_wave_vector(lobe.cycles_per_unit * lobe.radius.x, lobe.orientation);
    return float2(wave.x, wave.y * (lobe.radius.y / lobe.radius.x));
}

float gabor_impl_lobes_power(GaborLobes lobes) {
    float power = 0.0;
    for (int i = 0; i < min(lobes.count, GABOR_LOBES); ++i)
        power += lobes.lobe[i].power;
    return power;
}

GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, uint seed) {
    GaborField sum = GaborField_of(0.0, (float2)(0.0), 0.0, (float2)(0.0), 0.0);
    float power = gabor_impl_lobes_power(lobes);
    for (int i = 0; i < min(lobes.count, GABOR_LOBES); ++i) {
        GaborLobe lobe = lobes.lobe[i];
        GaborField field = gabor_field(gabor_impl_stretched(place, lobe.radius), gabor_impl_lobe_wave(lobe),
                                       gabor_derived_seed(seed, i));
        gabor_impl_add_field(sum, field, power > 0.0 ? sqrt(lobe.power / power) : 0.0, 1.0 / lobe.radius);
    }
    return sum;
}

GaborLobe gabor_lobe(float cycles_per_unit, float orientation, float radius, float power) {
    return GaborLobe_of(cycles_per_unit, orientation, (float2)(radius), power);
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is cut into equal pieces of at most 0.7 cycles per kernel radius, with a lobe in the middle of each.
// The power of Hann's window has a standard deviation of 1/sqrt(12) cycles per kernel radius, so the sum of the lobes
// is nearly flat. The number of pieces is the integer part of a number c. As the fraction of c goes from 0.8 to 1,
// these pieces fade out and a set with one more piece fades in, so that the noise is continuous in frequency and
// spread.

// The number of lobes for `c`; while one set fades into the next, the total of both.
int gabor_impl_pieces(float c) {
    return frac(c) > 0.8 ? 2 * int(c) + 1 : int(c);
}

// Returns lobe `i` as (position in the range, from -1 to 1; share of the power; number from which its seed derives).
float3 gabor_impl_piece(int i, float c) {
    int n = int(c);
    float left = min(5.0 - 5.0 * frac(c), 1.0);
    if (i >= n) {
        i -= n;
        n += 1;
        left = 1.0 - left;
    }
    float width = 1.0 / float(n);
    return float3((2.0 * float(i) + 1.0) * width - 1.0, gabor_impl_takeover(left) * width, float(i + (n & 1) * 64));
}

GaborField gabor_field_spread(GaborPlace place, float frequency, float orientation, float frequency_spread,
                              float orientation_spread, uint seed) {
    GaborField sum = GaborField_of(0.0, (float2)(0.0), 0.0, (float2)(0.0), 0.0);
    frequency = min(abs(frequency), 1.0e6);
    frequency_spread = clamp(frequency_spread, 0.0, 1.0);
    orientation_spread = clamp(orientation_spread, 0.0, 1.5707963); // pi/2
    float shells = clamp(2.857 * frequency_spread * frequency + 0.8, 1.0, 16.0);
    int shell_count = gabor_impl_pieces(shells);
    for (int j = 0; j < shell_count; ++j) {
        float3 shell = gabor_impl_piece(j, shells);
        float magnitude = frequency * (1.0 + frequency_spread * shell.x);
        float directions = clamp(0.63661977 * orientation_spread * (4.44 * magnitude + 0.6) + 0.8, 1.0, 64.0); // 2/pi
        int direction_count = gabor_impl_pieces(directions);
        for (int i = 0; i < direction_count; ++i) {
            float3 direction = gabor_impl_piece(i, directions);
            float2 wave = gabor_wave_vector(magnitude, orientation + orientation_spread * direction.x);
            GaborField field = gabor_field(place, wave, gabor_derived_seed(seed, int(128.0 * shell.z + direction.z)));
            gabor_impl_add_field(sum, field, sqrt(shell.y * direction.y), (float2)(1.0));
        }
    }
    return sum;
}

float gabor_noise_spread(float2 p, float frequency, float orientation, float frequency_spread, float orientation_spread,
                         uint seed) {
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
#define GABOR_IMPL_STAR (0.57735027 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY))

// The three waves of a node: amplitudes times the waves at the point, and unit vectors along the first two wave
// vectors. The third is their difference, and so is its phase.
struct GaborImplStar {
    float2 first;
    float2 second;
    float2 third;
    float2 u;
    float2 v;
};

GaborImplStar GaborImplStar_of(float2 first, float2 second, float2 third, float2 u, float2 v) {
    GaborImplStar made = {first, second, third, u, v};
    return made;
}

// `d`: offset of the point from the node, in periods of the waves.
GaborImplStar gabor_impl_star(uint4 words, float2 d, float evolution) {
    GaborImplStar star;
    // 3.8805107e-11 is 2^-31 / 12
    star.u = gabor_impl_half_turn(3.8805107e-11 * float(int(words.w))); // up to a twelfth of a turn either way
    star.v = 0.5 * star.u + 0.8660254 * float2(-star.u.y, star.u.x); // sqrt(3)/2
    star.first = gabor_impl_wave(dot(star.u, d));
    star.second = gabor_impl_wave(dot(star.v, d));
    star.third = gabor_impl_product(star.second, float2(star.first.x, -star.first.y));
    star.first = gabor_impl_product(gabor_impl_amplitude_at(words.x, evolution), star.first);
    star.second = gabor_impl_product(gabor_impl_amplitude_at(words.y, evolution), star.second);
    star.third = gabor_impl_product(gabor_impl_amplitude_at(words.z, evolution), star.third);
    return star;
}

// Adds a wave of a node: `a` is its amplitude times the wave at the point, `window` the value and gradient of the
// node's window.
void gabor_impl_add_wave(inout GaborField sum, float3 window, float2 a, float2 wave) {
    float2 value = window.x * a;
    sum.noise += value.y;
    sum.gradient += a.y * window.yz + 6.2831853 * value.x * wave; // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += a.x * window.yz - 6.2831853 * value.y * wave;
}

// Unrolling these loops by hand made them four times slower on lavapipe.
GaborField gabor_field_isotropic(GaborPlace place, float frequency, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, place.cells_per_radius.x);
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                                      place.cells_per_radius.y);
    float2 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    frequency = min(abs(frequency), 1.0e6);
    GaborField sum = GaborField_of(0.0, (float2)(0.0), 0.0, (float2)(0.0), 0.0);
    for (int j = 0; j < GABOR_TAPS; ++j) {
        uint4 row = gabor_impl_row(y.word[j]);
        for (int i = 0; i < GABOR_TAPS; ++i) {
            float2 d = frequency / place.cells_per_radius * float2(x.offset - float(i - 1), y.offset - float(j - 1));
            GaborImplStar star = gabor_impl_star(x.word[i] * row, d, place.evolution);
            float2 h = float2(x.node[i].x, y.node[j].x);
            float3 window = float3(h.x * h.y, stretch * float2(x.node[i].z, y.node[j].z) * h.yx);
            gabor_impl_add_wave(sum, window, star.first, frequency * star.u);
            gabor_impl_add_wave(sum, window, star.second, frequency * star.v);
            gabor_impl_add_wave(sum, window, star.third, frequency * (star.v - star.u));
        }
    }
    GaborField field = GaborField_of(0.0, (float2)(0.0), 0.0, (float2)(0.0), 0.0);
    gabor_impl_add_field(field, sum, GABOR_IMPL_STAR, (float2)(1.0));
    return field;
}

float gabor_noise_isotropic(float2 p, float frequency, uint seed) {
    return gabor_field_isotropic(gabor_place_at(p), frequency, seed).noise;
}

// ---- Profiles ------------------------------------------------------------------------------------------------------

// Returns (phase - width / 2, phase + width / 2, 1 / width) of stripes, in turns. The mean of a unit vector over
// `width` turns has the length sin(pi width) / (pi width); the polynomial inverts this within 0.0025. The mean of a
// profile between the ends is the change of its integral from one end to the other, divided by the width. Each whole
// turn adds the integral of one period.
float3 gabor_impl_ends_at(float phase, float span) {
    float y = max(1.0 - span, 0.0);
    // the others are a fit: see tools/constants.py
    float width = sqrt(y) * (0.7796968 + y * (0.13925488 + y * (0.1322011 * y - 0.05362376))); // sqrt(6)/pi
    width = clamp(width, 0.001, 1.0);
    phase -= floor(phase);
    return float3(phase - 0.5 * width, phase + 0.5 * width, 1.0 / width);
}

float3 gabor_impl_ends(float2 stripes) {
    float2 phasor = gabor_turns_intensity(stripes.yx);
    return gabor_impl_ends_at(phasor.x, phasor.y);
}

float gabor_impl_triangle_integral(float x) {
    float turns = floor(x), t = x - turns;
    return 0.5 * turns + (t < 0.5 ? t * t : 2.0 * t - t * t - 0.5);
}

float gabor_profile_triangle(float2 stripes) {
    float3 ends = gabor_impl_ends(stripes);
    return ends.z * (gabor_impl_triangle_integral(ends.y) - gabor_impl_triangle_integral(ends.x));
}

float gabor_impl_sawtooth_integral(float x) {
    float turns = floor(x), t = x - turns;
    return 0.5 * (turns + t * t);
}

float gabor_profile_sawtooth(float2 stripes) {
    float3 ends = gabor_impl_ends(stripes);
    return ends.z * (gabor_impl_sawtooth_integral(ends.y) - gabor_impl_sawtooth_integral(ends.x));
}

float gabor_impl_pulse_integral(float x, float duty) {
    float turns = floor(x);
    return duty * turns + min(x - turns, duty);
}

float gabor_profile_pulse(float2 stripes, float duty) {
    float3 ends = gabor_impl_ends(stripes);
    return ends.z * (gabor_impl_pulse_integral(ends.y, duty) - gabor_impl_pulse_integral(ends.x, duty));
}

#endif
