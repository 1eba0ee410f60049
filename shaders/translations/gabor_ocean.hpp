// clang-format off
// Generated from gabor_ocean.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
// Includes gabor_noise.hpp; pasted after their texts, it includes nothing.
//
// gabor_ocean.hpp: a sea that never repeats, at any point and time, without textures or state, alike on CPU and GPU.
//
//     GaborOcean sea = gabor_ocean(12.0);              // a wind of 12 m/s; once per draw, or as a uniform
//     GaborWater w = gabor_water(p, 60.5, sea, 7u);    // p in metres, after 60.5 seconds
//     vec2 place = p + w.shift;                        // of the water, at the height w.height
//
//     I want                                           call
//     water under a pixel                              gabor_water_filtered
//     a boat's height                                  gabor_water_height
//     a world of any size, or months of time           gabor_water_at
//     another direction or fetch, a swell, a loop      gabor_ocean_of
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_VECTORS_HPP
#include "gabor_vectors.hpp"
#endif

#ifndef GABOR_NOISE_HPP
#include "gabor_noise.hpp"
#endif
#ifndef GABOR_OCEAN_HPP
#define GABOR_OCEAN_HPP 1
// Octaves of wavelength, 1 to 12, from above the longest waves: 9 reach 0.8 m at 12 m/s.
#ifndef GABOR_OCEAN_BANDS
#define GABOR_OCEAN_BANDS 9
#elif GABOR_OCEAN_BANDS < 1 || GABOR_OCEAN_BANDS > 12
#error GABOR_OCEAN_BANDS must be 1 to 12
#endif

// Waves from one wavelength to half of it. `low`, `early`, `late` and `spread` are multiples of powers of 2, so that
// sums are exact.
struct GaborOceanBand {
    float amplitude; // rms height in metres
    gabor_vec2 slopes;     // variance of the slopes along the band's direction and across it
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    gabor_vec3 early;      // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next
    gabor_vec3 late;       // 3/16, 4/16, 4/16, 3/16 and 1/16
    gabor_vec3 spread;     // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in
    gabor_vec2 widen;      // [-1, 1], times a linear function of the frequency
    gabor_ivec2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;      // speed in metres per second, 10 m up
    float direction; // where the waves go: radians from +x towards +y
    float fetch;     // metres of open water upwind, 10^3 to 10^6: beyond 2190 wind^2, waves grow no more
    gabor_vec3 swell;      // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    int loop_seconds; // all repeats after so many, or 0 for never
    gabor_vec2 tail;       // variance of the slopes of waves shorter than all bands, along the wind and across it
    GaborOceanBand band[GABOR_OCEAN_BANDS + 1] = {}; // the swell is the last
};
// GaborOcean gabor_ocean(float wind)
// GaborOcean gabor_ocean_of(float wind, float direction, float fetch, vec3 swell, int loop_seconds)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the
//     JONSWAP spectrum [HBB73] until it is fully developed [PM64], and the directions of [HDE80]. A swell, from a
//     remote storm, has a narrow spread of directions and a sharp peak [G10]; vec3(0.0) is none. For films, all repeats
//     after a loop of 8, 16, 32 ... 4096 seconds, to which other values are rounded down. Its price: groups of waves
//     stand still, and each wave's period becomes an integer fraction of it, so a loop should last several periods of
//     the swell. Compute a sea once, on the CPU if the CPU also asks for heights: the integers may round differently on
//     another device. To change a member, call this again.

// The water particle whose position at rest is p. It is now at p + shift.
struct GaborWater {
    float height;  // metres, of mean 0 and normally distributed
    gabor_vec2 slope;    // derivatives of the height by p
    gabor_vec2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float jacobian; // of p + shift by p, within 0.1, or 0.2 for a fetch of 1 km: 1 at rest, lower where water folds,
                    // with foam below 0.7
    gabor_vec3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
};
// GaborWater gabor_water(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(vec2 p, vec2 dx, vec2 dy, float seconds, GaborOcean ocean, uint seed)
//     The same without waves that are too fine for a pixel (dx and dy are dFdx(p), dFdy(p)), whose slopes are in
//     `lost`, as are those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk
//     measured [CM54], if the sea has neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone
//     have up to 1.8 times that.
// float gabor_water_height(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.
// GaborWater gabor_water_at(ivec2 cell, vec2 local, int second, float fraction, vec2 dx, vec2 dy, GaborOcean ocean,
//                            uint seed)
//     At the position cell + local in metres, after whole_seconds + fraction: exact for years and anywhere. dx and dy
//     of
//     vec2(0.0) do not filter.

// [HBB73] Hasselmann and others: Measurements of wind-wave growth and swell decay during the Joint North Sea Wave
// Project, 1973. [HDE80] Hasselmann, Dunckel, Ewing: Directional wave spectra observed during JONSWAP 1973, 1980.
// [G10] Goda: Random seas, 2010. [CM54] Cox, Munk: Measurement of the roughness of the sea surface from photographs of
// the sun's glitter, 1954. [PM64] Pierson, Moskowitz: A proposed spectral form for fully developed wind seas, 1964.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise of two taps whose nodes have wave vectors of their own, drawn from the band's part of
// the spectrum: an angle d from the band's direction and a frequency F, from which the wave number follows by the
// dispersion relation of deep water, (2 pi F)^2 = g |2 pi k|. The lattice drifts with the band's group velocity V, so
// that groups travel as they should; seen from there, phases turn by F - k.V. With V = g / (4 pi F0) along that
// direction, k.V = F^2 / (2 F0) cos d. F - k.V is an integer, so that the phase is exact after any time, and the same
// on every device: floats below 2^24 and powers of 2 are exact.
//
// Bands 1 to 3 and the swell hold most of the height: there, amplitudes are normal. In the others, their squares are
// uniform, to make up for the kurtosis that different directions give the slopes. Each seed shifts the lattices, so
// that no place differs from others.

// ---- The sea's bands -----------------------------------------------------------------------------------------------

// The frequencies of bands are multiples of this many Hz, 2^-16.
#define GABOR_IMPL_TICK 1.52587890625e-5f
#define GABOR_IMPL_GRAVITY 9.81f

// A JONSWAP spectrum: the frequency of its peak, its scale, and the logarithm of how much its peak is raised.
struct GaborImplJonswap {
    float peak;
    float scale;
    float sharp;
};

// The spectrum of waves that a wind raises over a fetch.
GABOR_INLINE GaborImplJonswap gabor_impl_wind_waves(float wind, float fetch) {
    float gravity = GABOR_IMPL_GRAVITY, reach = gabor_cpp_min(gravity * fetch / (wind * wind), 2.15e4f);
    float peak = 3.5f * gravity / wind * gabor_cpp_pow(reach, -0.33f);
    float scale = 0.076f * gabor_cpp_pow(reach, -0.22f) * gravity * gravity / 1558.5455f; // (2 pi)^4
    return GaborImplJonswap{peak, scale, 1.1939225f};                         // ln 3.3
}

// The spectrum at a frequency in m^2 / Hz, and the same times f^4.
GABOR_INLINE gabor_vec2 gabor_impl_spectrum(float f, GaborImplJonswap sea) {
    float below = sea.peak * sea.peak / (f * f);
    float apart = (f / sea.peak - 1.0f) / (f < sea.peak ? 0.07f : 0.09f);
    return sea.scale / f * gabor_cpp_exp(sea.sharp * gabor_cpp_exp(-0.5f * apart * apart) - 1.25f * below * below)
         * gabor_vec2(1.0f / (f * f * f * f), 1.0f);
}

// The frequency of step j of the 16, `width` wide, that a band's frequencies from `low` up are divided into.
GABOR_INLINE float gabor_impl_step_frequency(int j, float low, float width) {
    return GABOR_IMPL_TICK * (low + (float(j) + 0.5f) * width);
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less 1236 here.
struct GaborImplBandPower {
    gabor_vec2 sum;       // the power, and the same times f^4
    float variance; // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    gabor_vec4 fit;       // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
};

GABOR_INLINE GaborImplBandPower gabor_impl_band_power(float low, GaborImplJonswap sea, bool remote) {
    GaborImplBandPower power = GaborImplBandPower{gabor_vec2(0.0f), 0.0f, gabor_vec4(0.0f)};
    float width = 0.025878906f * low; // 26.5/1024
    for (int j = 0; j < 16; ++j) {
        // 198.75 is 7.5 * 26.5
        float f = gabor_impl_step_frequency(j, low, width), x = 26.5f * float(j) - 198.75f, above = f / sea.peak;
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        float s = remote ? 75.0f : 9.77f * gabor_cpp_pow(above, above < 1.0f ? 4.06f : -2.34f);
        float here = 0.5f / (s + 1.0f);
        gabor_vec2 part = GABOR_IMPL_TICK * width * gabor_impl_spectrum(f, sea);
        power.sum += part;
        power.variance += part.x * here;
        power.fit += part.x * gabor_vec4(x, gabor_cpp_sqrt(here), x * x, x * gabor_cpp_sqrt(here));
    }
    power.variance /= power.sum.x;
    power.fit /= power.sum.x;
    return power;
}

// The directions of a band: its members `spread` and `widen`, and the mean of cos^2 d.
struct GaborImplBandSpread {
    gabor_vec3 spread;
    gabor_vec2 widen;
    float along;
};

// sin(d / 2) is (a u + b u^3 + c v) times 1 + widen rise, where u and v are uniform in [-1, 1].
GABOR_INLINE GaborImplBandSpread gabor_impl_band_spread(GaborImplBandPower power) {
    float variance = power.variance, deviation = gabor_cpp_sqrt(variance), narrow = 0.5f / variance - 1.8f;
    gabor_vec4 fit = power.fit;
    float c = 0.9f * deviation * gabor_cpp_clamp(narrow, 0.0f, 1.0f);
    float widen = gabor_cpp_clamp(0.3f * narrow, 0.0f, 1.0f) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
    widen = gabor_cpp_floor(gabor_cpp_clamp(16384.0f * widen, -32.0f, 32.0f) + 0.5f) / 16384.0f;
    float most = 1.0f / (1.0f + 212.0f * gabor_cpp_abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
    // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
    float end = gabor_cpp_min(1.8f * deviation, most - c), rest = variance - c * c / 3.0f;
    // 0.3047619 is 32/105, 0.0304762 is 16/525, 0.1142857 is 4/35 and 0.1523810 is 16/105
    float a = (gabor_cpp_sqrt(gabor_cpp_max(0.3047619f * rest - 0.0304762f * end * end, 0.0f)) - 0.1142857f * end) / 0.1523810f, b = end - a;
    // The mean of sin(d / 2)^4.
    // 0.57142857 is 4/7, 0.66666667 is 2/3, 0.36363636 is 4/11 and 0.076923077 is 1/13
    float fourth = a * a * a * (0.2f * a + 0.57142857f * b)
                 + b * b * (0.66666667f * a * a + 0.36363636f * a * b + 0.076923077f * b * b)
                 + c * c * (2.0f * rest + 0.2f * c * c);
    // 0.00390625 is 2^-8
    return GaborImplBandSpread{gabor_cpp_floor(511.5f * gabor_vec3(a, b, c)) * gabor_vec3(8.0f, 0.00390625f, 8.0f),
                               gabor_cpp_floor(16384.0f * gabor_vec2(1.0f - (fit.x + 1236.0f) * widen, widen)),
                               1.0f - 4.0f * variance + 4.0f * fourth};
}

// The frequencies of a band whose power is `whole`: its members `early` and `late`, by the inverse of the distribution.
// The knots have 0.0621, 0.2483, 0.4965, 0.7448, 0.931 and all of the power below them, instead of 1/16, 4/16, 8/16 and
// so on: between them, frequencies are uniform, and thus too high. Lower knots keep the variance of the slopes.
GABOR_INLINE void gabor_impl_band_knots(float low, float whole, GaborImplJonswap sea, gabor_vec3& early, gabor_vec3& late) {
    gabor_vec3 first = gabor_vec3(0.0f), second = gabor_vec3(0.0f), ahead = gabor_vec3(0.0621f, 0.2483f, 0.4965f);
    float width = 0.025878906f * low; // 26.5/1024
    for (int n = 0; n < 16; ++n) {
        float f = gabor_impl_step_frequency(n, low, width);
        float part = GABOR_IMPL_TICK * width / whole * gabor_impl_spectrum(f, sea).x;
        first += 26.5f * gabor_cpp_clamp(ahead / gabor_cpp_max(part, 1.0e-9f), 0.0f, 1.0f);
        second += 26.5f * gabor_cpp_clamp((ahead + gabor_vec3(0.6827f, 0.6827f, 0.5035f)) / gabor_cpp_max(part, 1.0e-9f), 0.0f, 1.0f);
        ahead -= part;
    }
    early = gabor_cpp_floor((first - gabor_vec3(0.0f, first.xy())) * gabor_vec3(4.0f, 1.3333333f, 1.0f) + 0.5f) / 256.0f; // 4/3
    late = gabor_cpp_floor((second - gabor_vec3(first.z, second.xy())) * gabor_vec3(1.0f, 1.3333333f, 4.0f) + 0.5f) / 256.0f;
    late -= gabor_vec3(early.z, late.xy());
    early -= gabor_vec3(0.0f, early.xy());
}

GABOR_INLINE GaborOcean gabor_ocean_of(float wind, float direction, float fetch, gabor_vec3 swell, int loop_seconds) {
    GaborOcean ocean;
    ocean.wind = gabor_cpp_clamp(wind, 2.0f, 30.0f);
    ocean.direction = direction;
    ocean.fetch = gabor_cpp_clamp(fetch, 1.0e3f, 1.0e6f);
    ocean.swell = gabor_vec3(gabor_cpp_clamp(swell.x, 0.0f, 30.0f), gabor_cpp_clamp(swell.y, 5.0f, 25.0f), swell.z);
    ocean.loop_seconds = loop_seconds > 0 ? int(1u << std::uint32_t(gabor_cpp_log2(float(gabor_cpp_clamp(loop_seconds, 8, 4096))) + 0.0002f)) : 0;
    ocean.tail = gabor_vec2(0.00316f, 0.00192f) * ocean.wind + gabor_vec2(0.0f, 0.003f); // [CM54]
    GaborImplJonswap sea = gabor_impl_wind_waves(ocean.wind, ocean.fetch);
    int octave = int(gabor_cpp_floor(gabor_cpp_log2(0.62f * sea.peak / GABOR_IMPL_TICK)));
    for (int i = 0; i <= GABOR_OCEAN_BANDS; ++i) {
        float low = float(((i & 1) == 0 ? 128u : 181u) << std::uint32_t(octave + i / 2)) / 128.0f;
        bool remote = i == GABOR_OCEAN_BANDS;
        if (remote) { // the swell
            sea.peak = 1.0f / ocean.swell.y;
            sea.sharp = 2.0794415f; // ln 8
            // 0.0132813 is 0.85/64
            low = 64.0f * gabor_cpp_floor(0.0132813f * sea.peak / GABOR_IMPL_TICK + 0.5f); // 0.85 times the peak
            direction = ocean.swell.z;
        }
        GaborImplBandPower power = gabor_impl_band_power(low, sea, remote);
        GaborImplBandSpread spread = gabor_impl_band_spread(power);
        GaborOceanBand band;
        float tall = remote ? 0.0625f * ocean.swell.x * ocean.swell.x
                     : low > 262144.0f ? 0.0f // below 0.1 m, waves are capillary
                                      : power.sum.x;
        band.amplitude = gabor_cpp_sqrt(tall);
        // (4 pi^2 / g)^2
        // 16.195056 was chosen near (4 pi^2 / g)^2, which is 16.195019
        band.slopes = 16.195056f * tall * power.sum.y / power.sum.x * gabor_vec2(spread.along, 1.0f - spread.along);
        if (!remote) ocean.tail -= band.slopes;
        band.exponent = remote ? int(gabor_cpp_floor(gabor_cpp_log2(18.0f / (sea.peak * sea.peak))))
                               : 34 - 2 * octave - i + (i > 0 && i < 4 ? 1 : -1);
        band.low = low;
        gabor_vec3 early, late;
        gabor_impl_band_knots(low, power.sum.x, sea, early, late);
        band.early = early;
        band.late = late;
        band.spread = spread.spread;
        band.widen = spread.widen;
        // 12.566371 is 4 pi and 1.1892071 is 2^(1/4)
        float speed = ocean.loop_seconds > 0 ? 0.0f
                                     : 32768.0f * GABOR_IMPL_GRAVITY / (12.566371f * GABOR_IMPL_TICK * low * 1.1892071f)
                                           * gabor_cpp_exp2(-float(band.exponent));
        band.drift = gabor_ivec2(gabor_cpp_floor(speed * gabor_impl_wave(0.15915494f * direction) + 0.5f)); // 1/(2 pi)
        ocean.band[i] = band;
    }
    ocean.tail = gabor_cpp_max(ocean.tail, 0.0f);
    return ocean;
}

GABOR_INLINE GaborOcean gabor_ocean(float wind) {
    return gabor_ocean_of(wind, 0.0f, 2.0e5f, gabor_vec3(0.0f), 0);
}

// ---- The water -----------------------------------------------------------------------------------------------------

// xx, xy and xx + yy of slopes with these variances along a unit vector and across it.
GABOR_INLINE gabor_vec3 gabor_impl_slopes_along(gabor_vec2 variances, gabor_vec2 along) {
    return gabor_vec3((variances.x - variances.y) * along.x * along + gabor_vec2(variances.y, 0.0f), variances.x + variances.y);
}

// The four nodes of a band around a point, together, which CPUs do faster: south west, south east, north west and
// north east.
struct GaborImplOceanNodes {
    gabor_uvec4 word;
    gabor_vec4 from_x; // offset of the point from the node, in metres
    gabor_vec4 from_y;
    gabor_vec4 window; // times the band's amplitude, as are its derivatives
    gabor_vec4 window_x;
    gabor_vec4 window_y;
};

GABOR_INLINE GaborImplOceanNodes gabor_impl_ocean_nodes(GaborOceanBand band, gabor_ivec2 cell, gabor_vec2 local, int second, float fraction,
                                           std::uint32_t salt) {
    // The place on the lattice is 2^-exponent (cell + local) - drift (second + fraction), as a whole number and a rest,
    // exactly.
    gabor_ivec2 drifted = (second & 32767) * band.drift; // below 2^31, as drifts are below 65536
    int up = gabor_cpp_max(band.exponent, 0), down = gabor_cpp_max(-band.exponent, 0);
    float spacing = gabor_cpp_exp2(float(band.exponent));
    gabor_vec2 rest = (gabor_vec2(cell & (int(1u << std::uint32_t(up)) - 1)) + local) / spacing - gabor_vec2(drifted & 32767) / 32768.0f
              - fraction / 32768.0f * gabor_vec2(band.drift) + gabor_vec2(float(salt & 0xffffu), float(salt >> 16u)) / 65536.0f;
    gabor_vec2 first = gabor_cpp_floor(rest), offset = gabor_cpp_clamp(rest - first, 0.0f, 1.0f);
    gabor_ivec2 node = ((cell >> up) << down) - (second >> 15) * band.drift - (drifted >> 15) + gabor_ivec2(first);
    // The windows along an axis are the cosine and sine of an angle, so that their squares sum to 1.
    gabor_vec2 middle = 2.0f * offset - 1.0f, fourth = middle * middle * middle * middle;
    // 0.15625 is 5/32 and 1.9634954 is 5/8 pi
    gabor_vec2 turns = 0.125f + middle * (0.15625f - 0.03125f * fourth), slope = 1.9634954f / spacing * (1.0f - fourth);
    gabor_vec2 turn_x = band.amplitude * gabor_impl_half_turn(turns.x), turn_y = gabor_impl_half_turn(turns.y);
    gabor_vec4 along_x = gabor_vec4(turn_x, turn_x), along_y = gabor_vec4(turn_y.xx(), turn_y.yy());
    std::uint32_t west = gabor_impl_line_word(node.x, salt), east = gabor_impl_line_word(node.x + 1, salt);
    std::uint32_t south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS);
    std::uint32_t north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    return GaborImplOceanNodes{gabor_uvec4(south * west, south * east, north * west, north * east),
                               spacing * (offset.x - gabor_vec4(0.0f, 1.0f, 0.0f, 1.0f)),
                               spacing * (offset.y - gabor_vec4(0.0f, 0.0f, 1.0f, 1.0f)), along_x * along_y,
                               slope.x * gabor_vec4(-turn_x.y, turn_x.x, -turn_x.y, turn_x.x) * along_y,
                               slope.y * gabor_vec4(-turn_y.yy(), turn_y.xx()) * along_x};
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    gabor_vec4 turning; // F - k.V, in quanta of frequency
    gabor_vec4 k;       // wave number, 2 pi over the wavelength in metres
    gabor_vec4 heading_x;
    gabor_vec4 heading_y;
};

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` 1024 (F / low)^2 cos d.
// `turning` is F - k.V, where k.V is `carried` times 861 / 2048, nearly 2^(-5/4). In a loop, the lattice stands.
GABOR_INLINE GaborImplOceanWaves gabor_impl_ocean_waves(GaborOceanBand band, gabor_uvec4 word, bool normal, gabor_vec2 heading, float quantum,
                                           float scale, float half_step) {
    gabor_uvec4 bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    // 10, 11 and 11 bits
    gabor_vec4 share = gabor_vec4(bits >> 22u), u = gabor_vec4(gabor_ivec4(bits << 10u) >> 21), w = gabor_vec4(gabor_ivec4(bits << 21u) >> 21);
    gabor_vec4 rise = gabor_cpp_trunc(1024.0f + band.early.x * share + band.early.y * gabor_cpp_max(share - 64.0f, 0.0f)
                      + band.early.z * gabor_cpp_max(share - 256.0f, 0.0f) + band.late.x * gabor_cpp_max(share - 512.0f, 0.0f)
                      + band.late.y * gabor_cpp_max(share - 768.0f, 0.0f) + band.late.z * gabor_cpp_max(share - 960.0f, 0.0f));
    gabor_vec4 bent = gabor_cpp_trunc(band.spread.x + band.spread.y * gabor_cpp_trunc(0.001953125f * u * u)); // 2^-9
    gabor_vec4 angle = gabor_cpp_trunc(2.44140625e-4f * (u * bent + w * band.spread.z)) * (band.widen.x + band.widen.y * rise); // 2^-12
    gabor_vec4 part = gabor_cpp_trunc(1.220703125e-4f * angle), lag = gabor_cpp_trunc(4.8828125e-4f * part * part); // 2^-13, 2^-11
    gabor_vec4 steep = gabor_cpp_trunc(9.765625e-4f * rise * rise), carried = steep - gabor_cpp_trunc(9.765625e-4f * steep * lag); // 2^-10
    gabor_vec4 count = gabor_cpp_trunc(scale * rise + half_step);
    // 6.7265625 is 861/128
    gabor_vec4 turning = quantum * count - gabor_cpp_trunc((quantum > 1.0f ? 0.0f : band.low / 16384.0f) * gabor_cpp_trunc(6.7265625f * carried));
    // 2 pi k, less 0.1 or 2 % for the slopes that the windows add
    gabor_vec4 k = (normal ? 0.9986f : 0.978f) * 9.37e-10f * quantum * quantum * count * count;
    gabor_vec4 chord = 1.1920929e-7f * angle, cosine = 1.0f - 0.5f * chord * chord; // 2^-23
    gabor_vec4 sine = chord * gabor_cpp_sqrt(1.0f - 0.25f * chord * chord);
    return GaborImplOceanWaves{turning, k, heading.x * cosine - heading.y * sine,
                               heading.y * cosine + heading.x * sine};
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
GABOR_INLINE void gabor_impl_add_band(GaborWater& sum, gabor_vec3& squeeze, GaborOceanBand band, bool normal, gabor_vec2 heading,
                         gabor_vec2 quantum, float least, gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx,
                         gabor_vec2 dy, std::uint32_t seed) {
    float scale = 9.765625e-4f * band.low * quantum.y, half_step = gabor_cpp_max(0.5f, 1.0f - 1024.0f * scale); // 2^-10
    float lowest = quantum.x * gabor_cpp_floor(1024.0f * scale + half_step);
    float longest = 1.486e-10f * lowest * lowest; // the least k, 2 pi F^2 / g
    if (band.amplitude == 0.0f || longest * longest * least > 1.6f) { // each wave would be below 1 / 2700 of its height
        sum.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    GaborImplOceanNodes nodes = gabor_impl_ocean_nodes(band, cell, local, second, fraction, gabor_impl_salt(seed));
    GaborImplOceanWaves waves = gabor_impl_ocean_waves(band, nodes.word, normal, heading, quantum.x, scale, half_step);
    gabor_vec4 k = waves.k, x = waves.heading_x, y = waves.heading_y;
    gabor_uvec4 ticks = (gabor_uvec4(gabor_ivec4(waves.turning)) * std::uint32_t(second) + (nodes.word >> 16u)) & 0xffffu;
    // 0.15915494 is 1/(2 pi) and 1.52587890625e-5 is 2^-16
    gabor_vec4 phase = 0.15915494f * k * (x * nodes.from_x + y * nodes.from_y)
               - 1.52587890625e-5f * (gabor_vec4(ticks) + waves.turning * fraction);
    gabor_vec2 a = gabor_impl_wave(phase.x), b = gabor_impl_wave(phase.y);
    gabor_vec2 c = gabor_impl_wave(phase.z), d = gabor_impl_wave(phase.w);
    gabor_vec4 steps_x = k * (x * dx.x + y * dx.y), steps_y = k * (x * dy.x + y * dy.y);
    gabor_vec4 kept = gabor_cpp_exp(-0.125f * (steps_x * steps_x + steps_y * steps_y));
    // The amplitude's square is uniform. For a normal distribution, the amplitude is nearly sqrt(-2 ln(1 - square)).
    gabor_vec4 square = 1.52587890625e-5f * gabor_vec4(nodes.word & 0xffffu), amplitude = kept * gabor_cpp_sqrt(square);
    // fit: see tools/constants.py
    amplitude *= normal ? 1.3034767f + 0.3870924f * square + 0.0960481f / (1.0580433f - square) : gabor_vec4(2.0f);
    gabor_vec4 height = amplitude * gabor_vec4(a.y, b.y, c.y, d.y), along = nodes.window * amplitude * gabor_vec4(a.x, b.x, c.x, d.x);
    sum.slope += gabor_vec2(gabor_cpp_dot(height, nodes.window_x), gabor_cpp_dot(height, nodes.window_y));
    height *= nodes.window;
    gabor_vec4 steepness = k * along, squeezed = k * height;
    gabor_vec4 lost = (normal ? 1.003f : 1.048f) * nodes.window * nodes.window * k * k * (1.0f - kept * kept);
    sum.height += gabor_cpp_dot(height, gabor_vec4(1.0f));
    sum.slope += gabor_vec2(gabor_cpp_dot(steepness, x), gabor_cpp_dot(steepness, y));
    sum.shift += gabor_vec2(gabor_cpp_dot(along, x), gabor_cpp_dot(along, y));
    squeeze += gabor_vec3(gabor_cpp_dot(squeezed, x * x), gabor_cpp_dot(squeezed, x * y), gabor_cpp_dot(squeezed, gabor_vec4(1.0f)));
    sum.lost += gabor_vec3(gabor_cpp_dot(lost, x * x), gabor_cpp_dot(lost, x * y), gabor_cpp_dot(lost, gabor_vec4(1.0f)));
}

GABOR_INLINE GaborWater gabor_water_at(gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy, GaborOcean ocean,
                          std::uint32_t seed) {
    // 0.15915494 is 1/(2 pi)
    gabor_vec2 wind = gabor_impl_wave(0.15915494f * ocean.direction), swell = gabor_impl_wave(0.15915494f * ocean.swell.z);
    GaborWater water = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_impl_slopes_along(ocean.tail, wind)};
    gabor_vec3 squeeze = gabor_vec3(0.0f);
    // 1.52587890625e-5 is 2^-16
    gabor_vec2 quantum = ocean.loop_seconds > 0
        ? gabor_vec2(float(65536 / gabor_cpp_max(ocean.loop_seconds, 1)), 1.52587890625e-5f * float(ocean.loop_seconds))
                                  : gabor_vec2(1.0f);
    float area = dx.x * dy.y - dx.y * dy.x, sides = gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy); // the pixel is an ellipse
    float least = 2.0f * area * area / gabor_cpp_max(sides + gabor_cpp_sqrt(gabor_cpp_max(sides * sides - 4.0f * area * area, 0.0f)), 1.0e-30f);
    for (int i = 0; i < (ocean.swell.x > 0.0f ? GABOR_OCEAN_BANDS + 1 : GABOR_OCEAN_BANDS); ++i) {
        bool remote = i == GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(water, squeeze, ocean.band[i], remote || (i > 0 && i < 4), remote ? swell : wind, quantum,
                            least, cell, local, second, fraction, dx, dy, gabor_derived_seed(seed, remote ? 12 : i));
    }
    water.jacobian = (1.0f - squeeze.x) * (1.0f - squeeze.z + squeeze.x) - squeeze.y * squeeze.y;
    water.lost = gabor_vec3(water.lost.x, water.lost.z - water.lost.x, water.lost.y);
    return water;
}

GABOR_INLINE GaborWater gabor_water_filtered(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, float seconds, GaborOcean ocean, std::uint32_t seed) {
    gabor_vec2 cell = gabor_cpp_floor(p);
    float second = gabor_cpp_floor(seconds);
    return gabor_water_at(gabor_ivec2(cell), p - cell, int(second), seconds - second, dx, dy, ocean, seed);
}

GABOR_INLINE GaborWater gabor_water(gabor_vec2 p, float seconds, GaborOcean ocean, std::uint32_t seed) {
    return gabor_water_filtered(p, gabor_vec2(0.0f), gabor_vec2(0.0f), seconds, ocean, seed);
}

GABOR_INLINE float gabor_water_height(gabor_vec2 p, float seconds, GaborOcean ocean, std::uint32_t seed) {
    GaborWater water = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_vec3(0.0f)};
    for (int i = 0; i < 6; ++i) water = gabor_water(p - water.shift, seconds, ocean, seed);
    return water.height;
}

#endif
