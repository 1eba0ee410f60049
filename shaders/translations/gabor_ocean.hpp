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
// time: gabor_water_at. Another direction or fetch: gabor_ocean_of.
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

// Waves from one wavelength to half of it. Frequencies are in units of 1 / 65536 Hz.
struct GaborOceanBand {
    float amplitude; // rms height in metres
    gabor_vec2 slopes;     // variance of the slopes along the wind and across it
    int exponent;    // the spacing of nodes is 2^exponent metres
    int low;         // the lowest frequency, 1 / sqrt(2) of the highest
    int quarter;     // a quarter of the range of frequencies
    gabor_ivec3 share;     // of 1024 waves, those in the lowest quarter, in the lowest two and in the lowest three
    gabor_ivec4 lean;      // 1024 times how much likelier low frequencies are than high ones, in each quarter
    gabor_ivec2 spread;    // sin(d / 2) of an angle d from the wind is a u + b u^3, u uniform in [-1, 1], here times 32768
    gabor_ivec2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;      // speed in metres per second, 10 m up
    float direction; // where the waves go: radians from +x towards +y
    float fetch;     // metres of open water upwind
    gabor_vec2 tail;       // variance of the slopes of waves shorter than all bands, along the wind and across it
    GaborOceanBand band[GABOR_OCEAN_BANDS] = {};
};

// GaborOcean gabor_ocean(float wind)
// GaborOcean gabor_ocean_of(float wind, float direction, float fetch)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] and the directions of [HDE80]. Compute it once, on the CPU if the CPU also asks for heights: the
//     integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    float height;  // metres, of mean 0 and normally distributed
    gabor_vec2 slope;    // derivatives of the height by p
    gabor_vec2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float fold;    // determinant of the derivative of p + shift: foam where it falls below 0.4
    gabor_vec3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
};

// GaborWater gabor_water(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.

// GaborWater gabor_water_filtered(vec2 p, vec2 dx, vec2 dy, float seconds, GaborOcean ocean, uint seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54]. dx and dy are dFdx(p), dFdy(p).

// float gabor_water_height(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.

// GaborWater gabor_water_at(ivec2 cell, vec2 local, int second, float fraction, vec2 dx, vec2 dy, GaborOcean ocean, uint seed)
//     At the position cell + local in metres, second + fraction in seconds: exact for years and anywhere. dx and dy of
//     vec2(0.0) do not filter.

// [HBB73] Hasselmann and others, "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project",
// 1973. [HDE80] Hasselmann, Dunckel, Ewing, "Directional wave spectra observed during JONSWAP 1973", 1980.
// [CM54] Cox, Munk, "Measurement of the roughness of the sea surface from photographs of the sun's glitter", 1954.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise whose nodes have wave vectors of their own, drawn from the band's part of the spectrum. A
// node's frequency F is an integer, and so is the cosine of its angle to the wind: its phase is exact after any time, and
// the same on every device. Its wave number follows from F by the dispersion relation of deep water, (2 pi f)^2 = g |2 pi k|.
// The lattice drifts with the band's group velocity V, so that groups travel as they should; seen from there, phases turn
// by F - k.V. With V = g / (4 pi f0) along the wind, k.V = F^2 / (2 F0) cos d.

GABOR_INLINE float gabor_impl_spectrum(float f, float peak, float scale) { // JONSWAP, in m^2 / Hz
    float below = peak / f, apart = (f / peak - 1.0f) / (f < peak ? 0.07f : 0.09f);
    below *= below;
    return scale / (f * f * f * f * f) * gabor_cpp_exp(-1.25f * below * below + 1.1939225f * gabor_cpp_exp(-0.5f * apart * apart)); // ln 3.3
}

GABOR_INLINE GaborOcean gabor_ocean_of(float wind, float direction, float fetch) {
    float gravity = 9.81f, tick = 1.52587890625e-5f;
    GaborOcean ocean;
    ocean.wind = gabor_cpp_clamp(wind, 2.0f, 30.0f);
    ocean.direction = direction;
    ocean.fetch = gabor_cpp_clamp(fetch, 1.0e3f, 1.0e6f);
    gabor_vec2 heading = gabor_impl_wave(0.15915494f * direction);
    float reach = gravity * ocean.fetch / (ocean.wind * ocean.wind);
    float peak = 3.5f * gravity / ocean.wind * gabor_cpp_pow(reach, -0.33f);
    float scale = 0.076f * gabor_cpp_pow(reach, -0.22f) * gravity * gravity / 1558.5455f; // (2 pi)^4
    int power = int(gabor_cpp_floor(gabor_cpp_log2(0.62f * peak / tick)));
    ocean.tail = gabor_vec2(0.00316f, 0.00192f) * ocean.wind + gabor_vec2(0.0f, 0.003f);
    for (int i = 0; i < GABOR_OCEAN_BANDS; ++i) {
        float low = gabor_cpp_exp2(float(power) + 0.5f * float(i)), width = 0.10355339f * low; // (sqrt(2) - 1) / 4
        float sum = 0.0f, slopes = 0.0f, variance = 0.0f, first = gabor_impl_spectrum(tick * low, peak, scale);
        gabor_vec4 sums = gabor_vec4(0.0f), leans = gabor_vec4(0.0f);
        for (int j = 0; j < 4; ++j) { // Simpson's rule
            float f = tick * (low + float(j) * width), step = tick * width;
            float middle = gabor_impl_spectrum(f + 0.5f * step, peak, scale), last = gabor_impl_spectrum(f + step, peak, scale);
            float part = step / 6.0f * (first + 4.0f * middle + last), between = f + 0.5f * step;
            sum += part;
            // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
            float above = between / peak;
            variance += part * 0.5f / (9.77f * gabor_cpp_pow(above, above < 1.0f ? 4.06f : -2.34f) + 1.0f);
            slopes += part * between * between * between * between;
            sums = gabor_vec4(sums.yzw(), sum);
            leans = gabor_vec4(leans.yzw(), (first - last) / (first + last));
            first = last;
        }
        variance /= sum;
        float end = gabor_cpp_min(2.2f * gabor_cpp_sqrt(variance), 1.0f); // the largest sin(d / 2)
        // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = variance, where a + b = end.
        float a = (gabor_cpp_sqrt(gabor_cpp_max(0.3047619f * variance - 0.0304762f * end * end, 0.0f)) - 0.1142857f * end) / 0.1523810f;
        float b = end - a;
        float fourth = a * a * a * (0.2f * a + 0.57142857f * b) // the mean of sin(d / 2)^4
                     + b * b * (0.66666667f * a * a + 0.36363636f * a * b + 0.076923077f * b * b);
        float along = 1.0f - 4.0f * variance + 4.0f * fourth; // the mean of cos^2 d
        float speed = gravity / (12.566371f * tick * low * 1.1892071f);
        GaborOceanBand band;
        float shown = low > 262144.0f ? 0.0f : 1.0f; // shorter waves than 0.1 m would overflow, and are capillary
        band.amplitude = shown * gabor_cpp_sqrt(sum);
        band.slopes = shown * slopes * 16.195056f * gabor_vec2(along, 1.0f - along); // (4 pi^2 / g)^2
        ocean.tail -= band.slopes;
        band.exponent = 34 - 2 * power - i;
        band.low = int(low + 0.5f);
        band.quarter = int(width + 0.5f);
        band.share = gabor_ivec3(1024.0f / sum * sums.xyz() + 0.5f);
        band.lean = gabor_ivec4(gabor_cpp_floor(1024.0f * leans + 0.5f));
        band.spread = gabor_ivec2(gabor_cpp_floor(32767.0f * gabor_vec2(a, b) + 0.5f));
        band.drift = gabor_ivec2(gabor_cpp_floor(32768.0f * speed * gabor_cpp_exp2(-float(band.exponent)) * heading + 0.5f));
        ocean.band[i] = band;
    }
    ocean.tail = gabor_cpp_max(ocean.tail, 0.0f);
    return ocean;
}

GABOR_INLINE GaborOcean gabor_ocean(float wind) {
    return gabor_ocean_of(wind, 0.0f, 2.0e5f);
}

// Adds a node's wave. `from` is the offset from the node in metres, and a window is (value, derivative).
GABOR_INLINE void gabor_impl_add_water(GaborWater& sum, gabor_vec3& squeeze, std::uint32_t word, gabor_vec2 from, gabor_vec2 window_x, gabor_vec2 window_y,
                         GaborOceanBand band, gabor_vec2 heading, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy) {
    std::uint32_t bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    int draw = int(bits >> 22u), u = 16 * int(bits & 4095u) - 32760;
    int at = (draw < band.share.x ? 0 : 1) + (draw < band.share.y ? 0 : 1) + (draw < band.share.z ? 0 : 1);
    int within = int(bits >> 12u) & 1023; // of the quarter
    int lean = at == 0 ? band.lean.x : at == 1 ? band.lean.y : at == 2 ? band.lean.z : band.lean.w;
    within -= (lean * ((within * (within ^ 1023)) >> 4)) >> 16;
    within += at << 10;
    int frequency = band.low + ((band.quarter * within) >> 10), ratio = 13777 + ((1427 * within) >> 10); // F / F0 in 2^-14
    int half_sine = (u * (band.spread.x + ((band.spread.y * ((u * u) >> 15)) >> 15))) >> 15;
    int cosine = 32768 - ((half_sine * half_sine) >> 14);
    int ahead = (((((frequency >> 2) * ratio) >> 13) >> 3) * cosine) >> 12; // k.V, without overflow for any sea
    int turning = frequency - ahead;
    float f = 1.52587890625e-5f * float(frequency), s = float(half_sine) / 32768.0f;
    gabor_vec2 across = gabor_vec2(float(cosine) / 32768.0f, 2.0f * s * gabor_cpp_sqrt(gabor_cpp_max(1.0f - s * s, 0.0f)));
    gabor_vec2 unit = gabor_vec2(across.x * heading.x - across.y * heading.y, across.x * heading.y + across.y * heading.x);
    gabor_vec2 k = 0.6383f * f * f * unit; // 2 pi / g, less 0.3 % for the slopes that the windows add
    float turns = float(((turning & 0xffff) * (second & 0xffff)) & 0xffff) + float(turning) * fraction;
    gabor_vec2 z = gabor_impl_product(gabor_impl_amplitude(word), gabor_impl_wave(gabor_cpp_dot(k, from) - 1.52587890625e-5f * turns));
    gabor_vec2 steps = gabor_vec2(gabor_cpp_dot(k, dx), gabor_cpp_dot(k, dy));
    float kept = gabor_cpp_exp(-4.9348022f * gabor_cpp_dot(steps, steps)), window = window_x.x * window_y.x;
    z *= kept;
    gabor_vec2 wave = window * z, around = 6.2831853f * k;
    sum.height += wave.y;
    sum.slope += wave.x * around + z.y * gabor_vec2(window_x.y * window_y.x, window_x.x * window_y.y);
    sum.shift += wave.x * unit;
    squeeze += wave.y * gabor_vec3(around * unit, around.x * unit.y);
    sum.lost += band.amplitude * band.amplitude * window * window * (1.0f - kept * kept) * gabor_vec3(around * around, around.x * around.y);
}

// Splits 2^-exponent (cell + local) - drift (second + fraction) into a whole number and a rest, exactly.
GABOR_INLINE void gabor_impl_float_by(int cell, float local, int exponent, int drift, int second, float fraction, int& whole, float& rest) {
    int high = (second >> 16) * drift, low = (second & 0xffff) * drift;
    whole = -2 * high - (low >> 15);
    rest = -float(low & 32767) / 32768.0f - float(drift) / 32768.0f * fraction;
    int up = gabor_cpp_max(exponent, 0), down = gabor_cpp_max(-exponent, 0);
    whole += (cell >> up) << down;
    rest += (float(cell & ((1 << up) - 1)) + local) * gabor_cpp_exp2(-float(exponent));
}

GABOR_INLINE GaborWater gabor_water_at(gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy, GaborOcean ocean, std::uint32_t seed) {
    gabor_vec2 heading = gabor_impl_wave(0.15915494f * ocean.direction);
    GaborWater water = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_vec3(0.0f)};
    gabor_vec3 squeezed = gabor_vec3(0.0f);
    gabor_vec2 hidden = ocean.tail;
    float area = dx.x * dy.y - dx.y * dy.x, sides = gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy); // the pixel is an ellipse
    float least = 2.0f * area * area / gabor_cpp_max(sides + gabor_cpp_sqrt(gabor_cpp_max(sides * sides - 4.0f * area * area, 0.0f)), 1.0e-30f);
    for (int i = 0; i < GABOR_OCEAN_BANDS; ++i) {
        GaborOceanBand band = ocean.band[i];
        float longest = 1.486e-10f * float(band.low) * float(band.low); // the smallest wave number, 2 pi f^2 / g
        if (band.amplitude == 0.0f || longest * longest * least > 1.6f) { // each wave would be below 1 / 2700 of its height
            hidden += band.slopes;
            continue;
        }
        std::uint32_t salt = gabor_impl_salt(gabor_lobe_seed(seed, i));
        int whole_x, whole_y;
        float rest_x, rest_y;
        gabor_impl_float_by(cell.x, local.x, band.exponent, band.drift.x, second, fraction, whole_x, rest_x);
        gabor_impl_float_by(cell.y, local.y, band.exponent, band.drift.y, second, fraction, whole_y, rest_y);
        gabor_vec2 zero = gabor_cpp_floor(gabor_vec2(rest_x, rest_y) + 0.5f), offset = gabor_cpp_clamp(gabor_vec2(rest_x, rest_y) - zero, -0.5f, 0.5f);
        gabor_ivec2 node = gabor_ivec2(whole_x, whole_y) + gabor_ivec2(zero);
        gabor_vec4 x, y, slope_x, slope_y;
        gabor_impl_windows(offset.x, x, slope_x);
        gabor_impl_windows(offset.y, y, slope_y);
        float spacing = gabor_cpp_exp2(float(band.exponent));
        slope_x /= GABOR_RADIUS * spacing;
        slope_y /= GABOR_RADIUS * spacing;
        std::uint32_t left = gabor_impl_line_word(node.x - 1, salt), middle = gabor_impl_line_word(node.x, salt);
        std::uint32_t right = gabor_impl_line_word(node.x + 1, salt);
        GaborWater sum = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_vec3(0.0f)};
        gabor_vec3 squeeze = gabor_vec3(0.0f);
        for (int j = 0; j < 3; ++j) {
            std::uint32_t row = gabor_impl_line_word(node.y + j - 1, salt ^ GABOR_IMPL_ROWS);
            gabor_vec2 window = j == 0 ? gabor_vec2(y.x, slope_y.x) : j == 1 ? gabor_vec2(y.y, slope_y.y) : gabor_vec2(y.z, slope_y.z);
            gabor_vec2 from = spacing * (offset + gabor_vec2(1.0f, 1.0f - float(j)));
            gabor_impl_add_water(sum, squeeze, row * left, from, gabor_vec2(x.x, slope_x.x), window, band, heading, second, fraction, dx, dy);
            from.x -= spacing;
            gabor_impl_add_water(sum, squeeze, row * middle, from, gabor_vec2(x.y, slope_x.y), window, band, heading, second, fraction, dx, dy);
            from.x -= spacing;
            gabor_impl_add_water(sum, squeeze, row * right, from, gabor_vec2(x.z, slope_x.z), window, band, heading, second, fraction, dx, dy);
        }
        float scale = band.amplitude / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
        water.height += scale * sum.height;
        water.slope += scale * sum.slope;
        water.shift += scale * sum.shift;
        squeezed += scale * squeeze;
        water.lost += sum.lost / (GABOR_IMPL_ENERGY * GABOR_IMPL_ENERGY);
    }
    water.fold = (1.0f - squeezed.x) * (1.0f - squeezed.y) - squeezed.z * squeezed.z;
    gabor_vec3 along = gabor_vec3(heading * heading, heading.x * heading.y), across = gabor_vec3(along.yx(), -along.z);
    water.lost += hidden.x * along + hidden.y * across;
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
    gabor_vec2 at = p;
    for (int i = 0; i < 5; ++i) at = p - gabor_water(at, seconds, ocean, seed).shift;
    return gabor_water(at, seconds, ocean, seed).height;
}

#endif // GABOR_OCEAN_HPP
