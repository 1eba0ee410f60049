// clang-format off
// Generated from gabor_ocean.glsl by tools/translate, for C++ on the CPU: change that file, not this one.
//
// gabor_ocean.hpp: a sea that never repeats, at any point and time, without textures or state, the same on CPU and GPU.
//
// Paste or include this file after gabor_noise.hpp.
//
//     GaborOcean sea = gabor_ocean(12.0);                            // a wind of 12 m/s; once per draw, or as a uniform
//     GaborWater w = gabor_water(p, 60.5, sea, 7u);                  // p in metres, after 60.5 seconds
//     vec2 place = p + w.shift;                                      // of the water, at the height w.height
//
// I want water under a pixel: gabor_water_filtered. A boat's height: gabor_water_height. A world of any size, or months of
// time: gabor_water_at. Another direction or fetch, a swell, or a film that loops: gabor_ocean_of.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#include "gabor_vectors.hpp"

#ifndef GABOR_NOISE_HPP
#error Include gabor_noise.hpp before gabor_ocean.hpp
#endif
#ifndef GABOR_OCEAN_HPP
#define GABOR_OCEAN_HPP
#if GABOR_TAPS != 3
#error gabor_ocean.hpp needs GABOR_TAPS 3
#endif

#ifndef GABOR_OCEAN_BANDS
#define GABOR_OCEAN_BANDS 9 // octaves of wavelength, 1 to 12, from above the longest waves: 9 reach 0.8 m at 12 m/s
#endif
#if GABOR_OCEAN_BANDS < 1 || GABOR_OCEAN_BANDS > 12
#error GABOR_OCEAN_BANDS must be 1 to 12
#endif

// Waves from one wavelength to half of it. `low`, `quarter` and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    float amplitude; // rms height in metres
    gabor_vec2 slopes;     // variance of the slopes along the band's direction and across it
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    gabor_vec4 quarter;    // the ranges of frequency that have a quarter of the power each, in 1/1024 of the lowest frequency
    gabor_vec3 spread;     // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1], here
    gabor_vec2 widen;      // times 4092, times a linear function of the frequency, here times 16384
    gabor_ivec2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;      // speed in metres per second, 10 m up
    float direction; // where the waves go: radians from +x towards +y
    float fetch;     // metres of open water upwind
    gabor_vec3 swell;      // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    int loop;        // the seconds after which all repeats, or 0 for never
    gabor_vec2 tail;       // variance of the slopes of waves shorter than all bands, along the wind and across it
    GaborOceanBand band[GABOR_OCEAN_BANDS + 1] = {}; // the swell is the last
};

// GaborOcean gabor_ocean(float wind)
// GaborOcean gabor_ocean_of(float wind, float direction, float fetch, vec3 swell, int loop)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] and the directions of [HDE80]. A swell, from a remote storm, has a narrow spread of directions
//     and a sharp peak [G10]; vec3(0.0) is none. For films, all repeats after a loop of 8, 16, 32 ... 4096 seconds, to which other
//     values are rounded down. Its price: groups of waves stand still, and each wave's period becomes an integer
//     fraction of it, so a loop should last several periods of the swell. Compute a sea once, on the CPU if the CPU also asks
//     for heights: the integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    float height;  // metres, of mean 0 and normally distributed
    gabor_vec2 slope;    // derivatives of the height by p
    gabor_vec2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float fold;    // determinant of the derivative of p + shift, within 0.1: foam where it falls below 0.7
    gabor_vec3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
};

// GaborWater gabor_water(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.

// GaborWater gabor_water_filtered(vec2 p, vec2 dx, vec2 dy, float seconds, GaborOcean ocean, uint seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54], if the sea has neither a swell
//     nor a loop. dx and dy are dFdx(p), dFdy(p).

// float gabor_water_height(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.

// GaborWater gabor_water_at(ivec2 cell, vec2 local, int second, float fraction, vec2 dx, vec2 dy, GaborOcean ocean, uint seed)
//     At the position cell + local in metres, second + fraction in seconds: exact for years and anywhere. dx and dy of
//     vec2(0.0) do not filter.

// [HBB73] Hasselmann and others, "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project",
// 1973. [HDE80] Hasselmann, Dunckel, Ewing, "Directional wave spectra observed during JONSWAP 1973", 1980. [G10] Goda,
// "Random seas and design of maritime structures", 2010. [CM54] Cox, Munk, "Measurement of the roughness of the
// sea surface from photographs of the sun's glitter", 1954.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise whose nodes have wave vectors of their own, drawn from the band's part of the spectrum: an
// angle d from the band's direction and a frequency F, from which the wave number follows by the dispersion relation of
// deep water, (2 pi f)^2 = g |2 pi k|. The lattice drifts with the band's group velocity V, so that groups travel as they should; seen
// from there, phases turn by F - k.V. With V = g / (4 pi f0) along that direction, k.V = F^2 / (2 F0) cos d. F - k.V is an integer,
// so that the phase is exact after any time, and the same on every device: floats below 2^24 and powers of 2 are exact.
//
// Bands 1 to 3 hold most of the height. There and in the swell, three nodes along each axis, of normal amplitudes, keep it normal. In the
// other bands, which hold most of the slopes, two nodes suffice, and uniform amplitudes make up for the kurtosis that the
// waves' directions give the slopes. Each seed shifts the lattices, so that no place differs from others.

GABOR_INLINE gabor_vec2 gabor_impl_spectrum(float f, float peak, float scale, float sharp) { // JONSWAP, in m^2 / Hz, and the same times f^4
    float below = peak / f, apart = (f / peak - 1.0f) / (f < peak ? 0.07f : 0.09f), squares = f * f * f * f;
    below *= below;
    return scale / f * gabor_cpp_exp(sharp * gabor_cpp_exp(-0.5f * apart * apart) - 1.25f * below * below) * gabor_vec2(1.0f / squares, 1.0f);
}

// The position in a band, from 0 to 424, below which this share of the power lies. `sums` are powers up to the ends of four
// intervals, `starts` and `ends` the densities at their ends; in between, the density is linear.
GABOR_INLINE float gabor_impl_quantile(float share, gabor_vec4 sums, gabor_vec4 starts, gabor_vec4 ends) {
    share *= sums.w;
    gabor_vec4 found = share < sums.x ? gabor_vec4(0.0f, sums.x, starts.x, ends.x) : share < sums.y ? gabor_vec4(sums.xy(), starts.y, ends.y)
               : share < sums.z ? gabor_vec4(sums.yz(), starts.z, ends.z) : gabor_vec4(sums.zw(), starts.w, ends.w);
    float rest = (share - found.x) / (found.y - found.x), start = 2.0f * found.z / (found.z + found.w);
    float within = 2.0f * rest / (start + gabor_cpp_sqrt(gabor_cpp_max(start * start + 4.0f * (1.0f - start) * rest, 0.0f)));
    return 106.0f * (within + (share < sums.x ? 0.0f : share < sums.y ? 1.0f : share < sums.z ? 2.0f : 3.0f));
}

GABOR_INLINE GaborOcean gabor_ocean_of(float wind, float direction, float fetch, gabor_vec3 swell, int loop) {
    float gravity = 9.81f, tick = 1.52587890625e-5f;
    GaborOcean ocean;
    ocean.wind = gabor_cpp_clamp(wind, 2.0f, 30.0f);
    ocean.direction = direction;
    ocean.fetch = gabor_cpp_clamp(fetch, 1.0e3f, 1.0e6f);
    ocean.swell = gabor_vec3(gabor_cpp_clamp(swell.x, 0.0f, 30.0f), gabor_cpp_clamp(swell.y, 5.0f, 25.0f), swell.z);
    ocean.loop = loop > 0 ? int(1u << std::uint32_t(gabor_cpp_log2(float(gabor_cpp_clamp(loop, 8, 4096))) + 0.01f)) : 0;
    float reach = gravity * ocean.fetch / (ocean.wind * ocean.wind), peak = 3.5f * gravity / ocean.wind * gabor_cpp_pow(reach, -0.33f);
    float scale = 0.076f * gabor_cpp_pow(reach, -0.22f) * gravity * gravity / 1558.5455f, sharp = 1.1939225f; // (2 pi)^4, ln 3.3
    int power = int(gabor_cpp_floor(gabor_cpp_log2(0.62f * peak / tick)));
    ocean.tail = gabor_vec2(0.00316f, 0.00192f) * ocean.wind + gabor_vec2(0.0f, 0.003f);
    for (int i = 0; i <= GABOR_OCEAN_BANDS; ++i) {
        float low = float(((i & 1) == 0 ? 128u : 181u) << std::uint32_t(power + i / 2)) / 128.0f;
        bool remote = i == GABOR_OCEAN_BANDS;
        if (remote) { // the swell
            peak = 1.0f / ocean.swell.y;
            low = 64.0f * gabor_cpp_floor(0.0132813f * peak / tick + 0.5f); // 0.85 times the peak
            sharp = 2.0794415f; // ln 8
            direction = ocean.swell.z;
        }
        float width = 0.10351562f * low, variance = 0.0f;
        gabor_vec2 sum = gabor_vec2(0.0f), first = gabor_impl_spectrum(tick * low, peak, scale, sharp);
        gabor_vec4 sums = gabor_vec4(0.0f), starts = gabor_vec4(0.0f), ends = gabor_vec4(0.0f), fit = gabor_vec4(0.0f);
        for (int j = 0; j < 4; ++j) { // Simpson's rule
            float f = tick * (low + float(j) * width), step = tick * width, x = 106.0f * float(j) - 159.0f; // rise - 1236
            gabor_vec2 middle = gabor_impl_spectrum(f + 0.5f * step, peak, scale, sharp), last = gabor_impl_spectrum(f + step, peak, scale, sharp);
            gabor_vec2 part = step / 6.0f * (first + 4.0f * middle + last);
            sum += part;
            // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
            float above = (f + 0.5f * step) / peak, s = remote ? 75.0f : 9.77f * gabor_cpp_pow(above, above < 1.0f ? 4.06f : -2.34f), here = 0.5f / (s + 1.0f);
            variance += part.x * here;
            fit += part.x * gabor_vec4(x, gabor_cpp_sqrt(here), x * x, x * gabor_cpp_sqrt(here));
            sums = gabor_vec4(sums.yzw(), sum.x);
            starts = gabor_vec4(starts.yzw(), first.x);
            ends = gabor_vec4(ends.yzw(), last.x);
            first = last;
        }
        variance /= sum.x;
        fit /= sum.x;
        float deviation = gabor_cpp_sqrt(variance), narrow = 0.5f / variance - 1.8f, c = 0.9f * deviation * gabor_cpp_clamp(narrow, 0.0f, 1.0f);
        float widen = gabor_cpp_clamp(0.3f * narrow, 0.0f, 1.0f) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
        widen = 6.1035156e-5f * gabor_cpp_floor(gabor_cpp_clamp(16384.0f * widen, -32.0f, 32.0f) + 0.5f); // by rise, in whole units of 2^-14
        float most = 1.0f / (1.0f + 212.0f * gabor_cpp_abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
        float end = gabor_cpp_min(1.8f * deviation, most - c), rest = variance - c * c / 3.0f;
        // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
        float a = (gabor_cpp_sqrt(gabor_cpp_max(0.3047619f * rest - 0.0304762f * end * end, 0.0f)) - 0.1142857f * end) / 0.1523810f, b = end - a;
        float fourth = a * a * a * (0.2f * a + 0.57142857f * b) // the mean of sin(d / 2)^4
                     + b * b * (0.66666667f * a * a + 0.36363636f * a * b + 0.076923077f * b * b)
                     + c * c * (2.0f * rest + 0.2f * c * c);
        float along = 1.0f - 4.0f * variance + 4.0f * fourth; // the mean of cos^2 d
        float speed = gravity / (12.566371f * tick * low * 1.1892071f);
        // Frequencies are uniform within a quarter, and thus too high. Lower quarters keep the variance of the slopes.
        gabor_vec3 quartile = gabor_cpp_floor(gabor_vec3(gabor_impl_quantile(0.2443f, sums, starts, ends), gabor_impl_quantile(0.4885f, sums, starts, ends),
                                   gabor_impl_quantile(0.7328f, sums, starts, ends)) + 0.5f);
        GaborOceanBand band;
        float tall = remote ? 0.0625f * ocean.swell.x * ocean.swell.x : low > 262144.0f ? 0.0f : sum.x; // below 0.1 m, waves are capillary
        band.amplitude = gabor_cpp_sqrt(tall);
        band.slopes = 16.195056f * tall * sum.y / sum.x * gabor_vec2(along, 1.0f - along); // (4 pi^2 / g)^2
        if (!remote) ocean.tail -= band.slopes;
        band.exponent = remote ? int(gabor_cpp_floor(gabor_cpp_log2(9.0f / (peak * peak)))) : 34 - 2 * power - i - (i > 0 && i < 4 ? 0 : 1);
        band.low = low;
        band.quarter = gabor_vec4(quartile, 424.0f) - gabor_vec4(0.0f, quartile);
        band.spread = gabor_cpp_floor(4092.0f * gabor_vec3(a, b, c));
        band.widen = gabor_cpp_floor(16384.0f * gabor_vec2(1.0f - fit.x * widen, widen));
        speed *= ocean.loop > 0 ? 0.0f : 32768.0f * gabor_cpp_exp2(-float(band.exponent));
        band.drift = gabor_ivec2(gabor_cpp_floor(speed * gabor_impl_wave(0.15915494f * direction) + 0.5f));
        ocean.band[i] = band;
    }
    ocean.tail = gabor_cpp_max(ocean.tail, 0.0f);
    return ocean;
}

GABOR_INLINE GaborOcean gabor_ocean(float wind) {
    return gabor_ocean_of(wind, 0.0f, 2.0e5f, gabor_vec3(0.0f), 0);
}

// The whole part of x >= 0. For it, C++ compilers have no fast floor.
GABOR_INLINE float gabor_impl_whole(float x) {
#ifdef __cplusplus
    return float(int(x));
#else
    return gabor_cpp_floor(x);
#endif
}

// Adds a node's wave. `from` is the offset from the node in metres, `window` is (value, derivatives). `wave` is the wave number of
// rise 1, in turns per metre. The first parts of `shape` make an amplitude normal, as in gabor_impl_amplitude, or uniform; the
// last is its deviation, times k / wave. `quantum` is (65536 / loop, loop / 65536), or 0. `squeeze` collects the derivatives of the shift. It and
// `lost` have the parts xx, xy and xx + yy.
GABOR_INLINE void gabor_impl_add_water(GaborWater& sum, gabor_vec3& squeeze, std::uint32_t word, gabor_vec2 from, gabor_vec3 window, GaborOceanBand band,
                          gabor_vec2 heading, gabor_vec2 quantum, float wave, gabor_vec3 shape, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy) {
    std::uint32_t bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    float share = 0.00390625f * float(bits >> 22u); // of 4
    gabor_vec4 below = band.quarter * gabor_cpp_clamp(share - gabor_vec4(0.0f, 1.0f, 2.0f, 3.0f), 0.0f, 1.0f);
    float rise = gabor_impl_whole(1024.0f + below.x + below.y + below.z + below.w); // 1024 F / low
    float u = 2.0f * float((bits >> 11u) & 2047u) - 2047.0f, v = 2.0f * float(bits & 2047u) - 2047.0f;
    float bent = gabor_impl_whole(band.spread.x + 4.8828125e-4f * band.spread.y * gabor_impl_whole(4.8828125e-4f * u * u));
    float side = u * bent + v * band.spread.z;
    // `angle` is 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, `carried` 1024 (F / low)^2 cos d, and `turning` F - k.V, where k.V is
    // `carried` times 861 / 2048, nearly 2^(-5/4).
    float angle = gabor_impl_whole(1.2207031e-4f * gabor_cpp_abs(side)) * (band.widen.x + band.widen.y * (rise - 1236.0f));
    float part = gabor_impl_whole(1.2207031e-4f * angle), lag = gabor_impl_whole(4.8828125e-4f * part * part);
    float steep = gabor_impl_whole(9.765625e-4f * rise * rise), carried = steep - gabor_impl_whole(9.765625e-4f * steep * lag);
    float turning = gabor_impl_whole(gabor_impl_whole(0.0078125f * (2048.0f * rise - 861.0f * carried)) * (6.103515625e-5f * band.low));
    if (quantum.x > 0.0f) { // the lattice stands, and F becomes a multiple of 1 / loop
        turning = quantum.x * gabor_cpp_max(gabor_impl_whole(rise * (9.765625e-4f * band.low * quantum.y) + 0.5f), 1.0f);
        rise = 1024.0f * turning / band.low;
    }
    float k = wave * rise * rise, around = 6.2831853f * k, chord = (side < 0.0f ? -1.1920929e-7f : 1.1920929e-7f) * angle;
    gabor_vec2 unit = gabor_impl_product(heading, gabor_vec2(1.0f - 0.5f * chord * chord, chord * gabor_cpp_sqrt(1.0f - 0.25f * chord * chord)));
    float turns = float(((std::uint32_t(turning) & 0xffffu) * (std::uint32_t(second) & 0xffffu)) & 0xffffu) + turning * fraction;
    gabor_vec2 uniforms = gabor_vec2(float(int(word)), float(int(word << 12u)));
    gabor_vec2 amplitude = (uniforms - shape.x * gabor_cpp_clamp(uniforms, -2.0119258e9f, 2.0119258e9f)) * (uniforms * uniforms + shape.y);
    gabor_vec2 z = gabor_impl_product(amplitude, gabor_impl_wave(k * gabor_cpp_dot(unit, from) - 1.52587890625e-5f * turns));
    gabor_vec2 steps = around * gabor_vec2(gabor_cpp_dot(unit, dx), gabor_cpp_dot(unit, dy));
    float kept = gabor_cpp_exp(-0.125f * gabor_cpp_dot(steps, steps));
    z *= kept;
    sum.slope += z.y * window.yz();
    z *= window.x;
    gabor_vec2 along = z.x * unit;
    gabor_vec3 squares = gabor_vec3(unit.x * unit, 1.0f);
    float power = shape.z * window.x * around;
    sum.height += z.y;
    sum.slope += around * along;
    sum.shift += along;
    squeeze += around * z.y * squares;
    sum.lost += power * power * (1.0f - kept * kept) * squares;
}

// Splits 2^-exponent (cell + local) - drift (second + fraction) into a whole number and a rest, exactly.
GABOR_INLINE void gabor_impl_float_by(int cell, float local, int exponent, int drift, int second, float fraction, int& whole, float& rest) {
    int high = (second >> 16) * drift, low = (second & 0xffff) * drift;
    whole = -2 * high - (low >> 15);
    rest = -float(low & 32767) / 32768.0f - float(drift) / 32768.0f * fraction;
    int up = gabor_cpp_max(exponent, 0), down = gabor_cpp_max(-exponent, 0);
    whole += (cell >> up) << down;
    rest += (float(cell & (int(1u << std::uint32_t(up)) - 1)) + local) * gabor_cpp_exp2(-float(exponent));
}

// The windows of three nodes, or two, along an axis. `x` is in node spacings from the first node.
GABOR_INLINE void gabor_impl_water_windows(bool three, float x, gabor_vec4& value, gabor_vec4& slope) {
    if (three) {
        gabor_impl_windows(x - 1.0f, value, slope);
        slope /= GABOR_RADIUS;
    } else { // 1 - s and s, divided by the root of the sum of their squares
        float s = x * x * (3.0f - 2.0f * x), scale = gabor_cpp_inversesqrt(1.0f - 2.0f * s * (1.0f - s));
        value = scale * gabor_vec4(1.0f - s, s, 0.0f, 0.0f);
        slope = 6.0f * x * (1.0f - x) * scale * scale * scale * gabor_vec4(-s, 1.0f - s, 0.0f, 0.0f);
    }
}

// The parts xx, xy and xx + yy of a covariance with these variances along a unit vector and across it.
GABOR_INLINE gabor_vec3 gabor_impl_slopes_along(gabor_vec2 variances, gabor_vec2 along) {
    return gabor_vec3((variances.x - variances.y) * along.x * along + gabor_vec2(variances.y, 0.0f), variances.x + variances.y);
}

// Adds a band with three nodes along each axis, or two. `least` is the square of a pixel's shorter side.
GABOR_INLINE void gabor_impl_add_band(GaborWater& water, gabor_vec3& squeeze, GaborOceanBand band, bool three, gabor_vec2 heading, gabor_vec2 quantum,
                         float least, gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy, std::uint32_t seed) {
    float lowest = quantum.x > 0.0f ? quantum.x * gabor_cpp_max(gabor_cpp_floor(band.low * quantum.y + 0.5f), 1.0f) : band.low;
    float longest = 1.486e-10f * lowest * lowest; // the smallest wave number, 2 pi f^2 / g
    if (band.amplitude == 0.0f || longest * longest * least > 1.6f) { // each wave would be below 1 / 2700 of its height
        water.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    std::uint32_t salt = gabor_impl_salt(seed);
    int whole_x, whole_y;
    float rest_x, rest_y;
    gabor_impl_float_by(cell.x, local.x, band.exponent, band.drift.x, second, fraction, whole_x, rest_x);
    gabor_impl_float_by(cell.y, local.y, band.exponent, band.drift.y, second, fraction, whole_y, rest_y);
    gabor_vec2 rest = gabor_vec2(rest_x, rest_y) + 1.52587890625e-5f * gabor_vec2(float(salt & 0xffffu), float(salt >> 16u));
    float inset = three ? 0.5f : 0.0f, spacing = gabor_cpp_exp2(float(band.exponent)), energy = three ? GABOR_IMPL_ENERGY : 1.0f;
    gabor_vec2 first = gabor_cpp_floor(rest - inset), offset = inset + gabor_cpp_clamp(rest - inset - first, 0.0f, 1.0f);
    gabor_ivec2 node = gabor_ivec2(whole_x, whole_y) + gabor_ivec2(first);
    gabor_vec4 x, y, slope_x, slope_y;
    gabor_impl_water_windows(three, offset.x, x, slope_x);
    gabor_impl_water_windows(three, offset.y, y, slope_y);
    float deviation = three ? GABOR_IMPL_DEVIATION : 1.2432818e30f;
    gabor_vec3 shape = three ? gabor_vec3(0.89289313f, 7.3973916e18f, 1.0034f * deviation) : gabor_vec3(0.0f, 1.0e21f, 1.0297f * deviation);
    x *= band.amplitude / (energy * deviation);
    slope_x *= band.amplitude / (energy * deviation * spacing);
    slope_y /= spacing;
    float f = 1.4901161e-8f * band.low;
    float wave = (three ? 0.6383f : 0.622f) * f * f; // 2 pi / g, less 0.3 or 3 % for the slopes that the windows add
    std::uint32_t left = gabor_impl_line_word(node.x, salt), middle = gabor_impl_line_word(node.x + 1, salt);
    std::uint32_t right = gabor_impl_line_word(node.x + 2, salt);
    gabor_vec2 from = spacing * offset;
    for (int j = 0; j < (three ? 3 : 2); ++j) {
        std::uint32_t row = gabor_impl_line_word(node.y + j, salt ^ GABOR_IMPL_ROWS);
        gabor_vec2 w = j == 0 ? gabor_vec2(y.x, slope_y.x) : j == 1 ? gabor_vec2(y.y, slope_y.y) : gabor_vec2(y.z, slope_y.z);
        gabor_impl_add_water(water, squeeze, row * left, from, gabor_vec3(x.x * w.x, slope_x.x * w.x, x.x * w.y), band, heading, quantum, wave, shape, second, fraction, dx, dy);
        gabor_impl_add_water(water, squeeze, row * middle, from - gabor_vec2(spacing, 0.0f), gabor_vec3(x.y * w.x, slope_x.y * w.x, x.y * w.y), band, heading, quantum, wave, shape, second, fraction, dx, dy);
        if (three)
            gabor_impl_add_water(water, squeeze, row * right, from - gabor_vec2(2.0f * spacing, 0.0f), gabor_vec3(x.z * w.x, slope_x.z * w.x, x.z * w.y), band, heading, quantum, wave, shape, second, fraction, dx, dy);
        from.y -= spacing;
    }
}

GABOR_INLINE GaborWater gabor_water_at(gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy, GaborOcean ocean, std::uint32_t seed) {
    gabor_vec2 wind = gabor_impl_wave(0.15915494f * ocean.direction), swell = gabor_impl_wave(0.15915494f * ocean.swell.z);
    GaborWater water = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_impl_slopes_along(ocean.tail, wind)};
    gabor_vec3 squeeze = gabor_vec3(0.0f);
    gabor_vec2 quantum = ocean.loop > 0 ? gabor_vec2(float(65536 / gabor_cpp_max(ocean.loop, 1)), 1.52587890625e-5f * float(ocean.loop)) : gabor_vec2(0.0f);
    float area = dx.x * dy.y - dx.y * dy.x, sides = gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy); // the pixel is an ellipse
    float least = 2.0f * area * area / gabor_cpp_max(sides + gabor_cpp_sqrt(gabor_cpp_max(sides * sides - 4.0f * area * area, 0.0f)), 1.0e-30f);
    int threes = gabor_cpp_min(GABOR_OCEAN_BANDS - 1, 3), last = ocean.swell.x > 0.0f ? threes + 1 : threes;
    for (int i = 1; i <= last; ++i) {
        int k = i > threes ? GABOR_OCEAN_BANDS : i;
        gabor_impl_add_band(water, squeeze, ocean.band[k], true, i > threes ? swell : wind, quantum, least, cell, local, second,
                            fraction, dx, dy, gabor_lobe_seed(seed, i > threes ? 12 : k)); // the swell is the same for any bands
    }
    for (int j = 0; j < GABOR_OCEAN_BANDS - threes; ++j) {
        int k = j == 0 ? 0 : j + threes;
        gabor_impl_add_band(water, squeeze, ocean.band[k], false, wind, quantum, least, cell, local, second, fraction, dx, dy,
                            gabor_lobe_seed(seed, k));
    }
    water.fold = (1.0f - squeeze.x) * (1.0f - squeeze.z + squeeze.x) - squeeze.y * squeeze.y;
    water.lost = gabor_vec3(water.lost.x, water.lost.z - water.lost.x, water.lost.y);
    return water;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

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

#endif // GABOR_OCEAN_HPP
