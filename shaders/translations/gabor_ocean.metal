// Generated from gabor_ocean.glsl by tools/translate, for the Metal shading language: change that file, not this one.
//
// gabor_ocean.metal: a sea that never repeats, at any point and time, without textures or state, the same on CPU and GPU.
//
// Paste or include this file after gabor_noise.metal.
//
//     GaborOcean sea = gabor_ocean(12.0);                            // a wind of 12 m/s; once per draw, or as a uniform
//     GaborWater w = gabor_water(p, 60.5, sea, 7u);                  // p in metres, after 60.5 seconds
//     float2 place = p + w.shift;                                      // of the water, at the height w.height
//
// I want water under a pixel: gabor_water_filtered. A boat's height: gabor_water_height. A world of any size, or months of
// time: gabor_water_at. Another direction or fetch, a swell, or a film that loops: gabor_ocean_of.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#include <metal_stdlib>

using namespace metal;

#ifndef GABOR_NOISE_METAL
#error Include gabor_noise.metal before gabor_ocean.metal
#endif
#ifndef GABOR_OCEAN_METAL
#define GABOR_OCEAN_METAL
#if GABOR_TAPS != 3
#error gabor_ocean.metal needs GABOR_TAPS 3
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
    float2 slopes;     // variance of the slopes along the band's direction and across it
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    float4 quarter;    // the ranges of frequency that have a quarter of the power each, in 1/1024 of the lowest frequency
    float3 spread;     // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1], here
    float2 widen;      // times 4092, times a linear function of the frequency, here times 16384
    int2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;      // speed in metres per second, 10 m up
    float direction; // where the waves go: radians from +x towards +y
    float fetch;     // metres of open water upwind
    float3 swell;      // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    int loop;        // the seconds after which all repeats, or 0 for never
    float2 tail;       // variance of the slopes of waves shorter than all bands, along the wind and across it
    GaborOceanBand band[GABOR_OCEAN_BANDS + 1]; // the swell is the last
};

// GaborOcean gabor_ocean(float wind)
// GaborOcean gabor_ocean_of(float wind, float direction, float fetch, float3 swell, int loop)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] and the directions of [HDE80]. A swell, from a remote storm, has a narrow spread of directions
//     and a sharp peak [G10]; float3(0.0) is none. For films, all repeats after a loop of 8, 16, 32 ... 4096 seconds, to which other
//     values are rounded down. Its price: groups of waves stand still, and each wave's period becomes an integer
//     fraction of it, so a loop should last several periods of the swell. Compute a sea once, on the CPU if the CPU also asks
//     for heights: the integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    float height;  // metres, of mean 0 and normally distributed
    float2 slope;    // derivatives of the height by p
    float2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float fold;    // determinant of the derivative of p + shift, within 0.1: foam where it falls below 0.7
    float3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
};

// GaborWater gabor_water(float2 p, float seconds, GaborOcean ocean, uint seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.

// GaborWater gabor_water_filtered(float2 p, float2 dx, float2 dy, float seconds, GaborOcean ocean, uint seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54], if the sea has neither a swell
//     nor a loop. dx and dy are dfdx(p), dfdy(p).

// float gabor_water_height(float2 p, float seconds, GaborOcean ocean, uint seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.

// GaborWater gabor_water_at(int2 cell, float2 local, int second, float fraction, float2 dx, float2 dy, GaborOcean ocean, uint seed)
//     At the position cell + local in metres, second + fraction in seconds: exact for years and anywhere. dx and dy of
//     float2(0.0) do not filter.

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

inline float2 gabor_impl_spectrum(float f, float peak, float scale, float sharp) { // JONSWAP, in m^2 / Hz, and the same times f^4
    float below = peak / f, apart = (f / peak - 1.0) / (f < peak ? 0.07 : 0.09), squares = f * f * f * f;
    below *= below;
    return scale / f * exp(sharp * exp(-0.5 * apart * apart) - 1.25 * below * below) * float2(1.0 / squares, 1.0);
}

// The position in a band, from 0 to 424, below which this share of the power lies. `sums` are powers up to the ends of four
// intervals, `starts` and `ends` the densities at their ends; in between, the density is linear.
inline float gabor_impl_quantile(float share, float4 sums, float4 starts, float4 ends) {
    share *= sums.w;
    float4 found = share < sums.x ? float4(0.0, sums.x, starts.x, ends.x) : share < sums.y ? float4(sums.xy, starts.y, ends.y)
               : share < sums.z ? float4(sums.yz, starts.z, ends.z) : float4(sums.zw, starts.w, ends.w);
    float rest = (share - found.x) / (found.y - found.x), start = 2.0 * found.z / (found.z + found.w);
    float within = 2.0 * rest / (start + sqrt(max(start * start + 4.0 * (1.0 - start) * rest, 0.0)));
    return 106.0 * (within + (share < sums.x ? 0.0 : share < sums.y ? 1.0 : share < sums.z ? 2.0 : 3.0));
}

inline GaborOcean gabor_ocean_of(float wind, float direction, float fetch, float3 swell, int loop) {
    float gravity = 9.81, tick = 1.52587890625e-5;
    GaborOcean ocean;
    ocean.wind = clamp(wind, 2.0, 30.0);
    ocean.direction = direction;
    ocean.fetch = clamp(fetch, 1.0e3, 1.0e6);
    ocean.swell = float3(clamp(swell.x, 0.0, 30.0), clamp(swell.y, 5.0, 25.0), swell.z);
    ocean.loop = loop > 0 ? int(1u << uint(log2(float(clamp(loop, 8, 4096))) + 0.01)) : 0;
    float reach = gravity * ocean.fetch / (ocean.wind * ocean.wind), peak = 3.5 * gravity / ocean.wind * pow(reach, -0.33);
    float scale = 0.076 * pow(reach, -0.22) * gravity * gravity / 1558.5455, sharp = 1.1939225; // (2 pi)^4, ln 3.3
    int power = int(floor(log2(0.62 * peak / tick)));
    ocean.tail = float2(0.00316, 0.00192) * ocean.wind + float2(0.0, 0.003);
    for (int i = 0; i <= GABOR_OCEAN_BANDS; ++i) {
        float low = float(((i & 1) == 0 ? 128u : 181u) << uint(power + i / 2)) / 128.0;
        bool remote = i == GABOR_OCEAN_BANDS;
        if (remote) { // the swell
            peak = 1.0 / ocean.swell.y;
            low = 64.0 * floor(0.0132813 * peak / tick + 0.5); // 0.85 times the peak
            sharp = 2.0794415; // ln 8
            direction = ocean.swell.z;
        }
        float width = 0.10351562 * low, variance = 0.0;
        float2 sum = float2(0.0), first = gabor_impl_spectrum(tick * low, peak, scale, sharp);
        float4 sums = float4(0.0), starts = float4(0.0), ends = float4(0.0), fit = float4(0.0);
        for (int j = 0; j < 4; ++j) { // Simpson's rule
            float f = tick * (low + float(j) * width), step = tick * width, x = 106.0 * float(j) - 159.0; // rise - 1236
            float2 middle = gabor_impl_spectrum(f + 0.5 * step, peak, scale, sharp), last = gabor_impl_spectrum(f + step, peak, scale, sharp);
            float2 part = step / 6.0 * (first + 4.0 * middle + last);
            sum += part;
            // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
            float above = (f + 0.5 * step) / peak, s = remote ? 75.0 : 9.77 * pow(above, above < 1.0 ? 4.06 : -2.34), here = 0.5 / (s + 1.0);
            variance += part.x * here;
            fit += part.x * float4(x, sqrt(here), x * x, x * sqrt(here));
            sums = float4(sums.yzw, sum.x);
            starts = float4(starts.yzw, first.x);
            ends = float4(ends.yzw, last.x);
            first = last;
        }
        variance /= sum.x;
        fit /= sum.x;
        float deviation = sqrt(variance), narrow = 0.5 / variance - 1.8, c = 0.9 * deviation * clamp(narrow, 0.0, 1.0);
        float widen = clamp(0.3 * narrow, 0.0, 1.0) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
        widen = 6.1035156e-5 * floor(clamp(16384.0 * widen, -32.0, 32.0) + 0.5); // by rise, in whole units of 2^-14
        float most = 1.0 / (1.0 + 212.0 * abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
        float end = min(1.8 * deviation, most - c), rest = variance - c * c / 3.0;
        // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
        float a = (sqrt(max(0.3047619 * rest - 0.0304762 * end * end, 0.0)) - 0.1142857 * end) / 0.1523810, b = end - a;
        float fourth = a * a * a * (0.2 * a + 0.57142857 * b) // the mean of sin(d / 2)^4
                     + b * b * (0.66666667 * a * a + 0.36363636 * a * b + 0.076923077 * b * b)
                     + c * c * (2.0 * rest + 0.2 * c * c);
        float along = 1.0 - 4.0 * variance + 4.0 * fourth; // the mean of cos^2 d
        float speed = gravity / (12.566371 * tick * low * 1.1892071);
        // Frequencies are uniform within a quarter, and thus too high. Lower quarters keep the variance of the slopes.
        float3 quartile = floor(float3(gabor_impl_quantile(0.2443, sums, starts, ends), gabor_impl_quantile(0.4885, sums, starts, ends),
                                   gabor_impl_quantile(0.7328, sums, starts, ends)) + 0.5);
        GaborOceanBand band;
        float tall = remote ? 0.0625 * ocean.swell.x * ocean.swell.x : low > 262144.0 ? 0.0 : sum.x; // below 0.1 m, waves are capillary
        band.amplitude = sqrt(tall);
        band.slopes = 16.195056 * tall * sum.y / sum.x * float2(along, 1.0 - along); // (4 pi^2 / g)^2
        if (!remote) ocean.tail -= band.slopes;
        band.exponent = remote ? int(floor(log2(9.0 / (peak * peak)))) : 34 - 2 * power - i - (i > 0 && i < 4 ? 0 : 1);
        band.low = low;
        band.quarter = float4(quartile, 424.0) - float4(0.0, quartile);
        band.spread = floor(4092.0 * float3(a, b, c));
        band.widen = floor(16384.0 * float2(1.0 - fit.x * widen, widen));
        speed *= ocean.loop > 0 ? 0.0 : 32768.0 * exp2(-float(band.exponent));
        band.drift = int2(floor(speed * gabor_impl_wave(0.15915494 * direction) + 0.5));
        ocean.band[i] = band;
    }
    ocean.tail = max(ocean.tail, 0.0);
    return ocean;
}

inline GaborOcean gabor_ocean(float wind) {
    return gabor_ocean_of(wind, 0.0, 2.0e5, float3(0.0), 0);
}

// The whole part of x >= 0. For it, C++ compilers have no fast floor.
inline float gabor_impl_whole(float x) {
#ifdef __cplusplus
    return float(int(x));
#else
    return floor(x);
#endif
}

// Adds a node's wave. `from` is the offset from the node in metres, `window` is (value, derivatives). `wave` is the wave number of
// rise 1, in turns per metre. The first parts of `shape` make an amplitude normal, as in gabor_impl_amplitude, or uniform; the
// last is its deviation, times k / wave. `quantum` is (65536 / loop, loop / 65536), or 0. `squeeze` collects the derivatives of the shift. It and
// `lost` have the parts xx, xy and xx + yy.
inline void gabor_impl_add_water(thread GaborWater& sum, thread float3& squeeze, uint word, float2 from, float3 window, GaborOceanBand band,
                          float2 heading, float2 quantum, float wave, float3 shape, int second, float fraction, float2 dx, float2 dy) {
    uint bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    float share = 0.00390625 * float(bits >> 22u); // of 4
    float4 below = band.quarter * clamp(share - float4(0.0, 1.0, 2.0, 3.0), 0.0, 1.0);
    float rise = gabor_impl_whole(1024.0 + below.x + below.y + below.z + below.w); // 1024 F / low
    float u = 2.0 * float((bits >> 11u) & 2047u) - 2047.0, v = 2.0 * float(bits & 2047u) - 2047.0;
    float bent = gabor_impl_whole(band.spread.x + 4.8828125e-4 * band.spread.y * gabor_impl_whole(4.8828125e-4 * u * u));
    float side = u * bent + v * band.spread.z;
    // `angle` is 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, `carried` 1024 (F / low)^2 cos d, and `turning` F - k.V, where k.V is
    // `carried` times 861 / 2048, nearly 2^(-5/4).
    float angle = gabor_impl_whole(1.2207031e-4 * abs(side)) * (band.widen.x + band.widen.y * (rise - 1236.0));
    float part = gabor_impl_whole(1.2207031e-4 * angle), lag = gabor_impl_whole(4.8828125e-4 * part * part);
    float steep = gabor_impl_whole(9.765625e-4 * rise * rise), carried = steep - gabor_impl_whole(9.765625e-4 * steep * lag);
    float turning = gabor_impl_whole(gabor_impl_whole(0.0078125 * (2048.0 * rise - 861.0 * carried)) * (6.103515625e-5 * band.low));
    if (quantum.x > 0.0) { // the lattice stands, and F becomes a multiple of 1 / loop
        turning = quantum.x * max(gabor_impl_whole(rise * (9.765625e-4 * band.low * quantum.y) + 0.5), 1.0);
        rise = 1024.0 * turning / band.low;
    }
    float k = wave * rise * rise, around = 6.2831853 * k, chord = (side < 0.0 ? -1.1920929e-7 : 1.1920929e-7) * angle;
    float2 unit = gabor_impl_product(heading, float2(1.0 - 0.5 * chord * chord, chord * sqrt(1.0 - 0.25 * chord * chord)));
    float turns = float(((uint(turning) & 0xffffu) * (uint(second) & 0xffffu)) & 0xffffu) + turning * fraction;
    float2 uniforms = float2(float(int(word)), float(int(word << 12u)));
    float2 amplitude = (uniforms - shape.x * clamp(uniforms, -2.0119258e9, 2.0119258e9)) * (uniforms * uniforms + shape.y);
    float2 z = gabor_impl_product(amplitude, gabor_impl_wave(k * dot(unit, from) - 1.52587890625e-5 * turns));
    float2 steps = around * float2(dot(unit, dx), dot(unit, dy));
    float kept = exp(-0.125 * dot(steps, steps));
    z *= kept;
    sum.slope += z.y * window.yz;
    z *= window.x;
    float2 along = z.x * unit;
    float3 squares = float3(unit.x * unit, 1.0);
    float power = shape.z * window.x * around;
    sum.height += z.y;
    sum.slope += around * along;
    sum.shift += along;
    squeeze += around * z.y * squares;
    sum.lost += power * power * (1.0 - kept * kept) * squares;
}

// Splits 2^-exponent (cell + local) - drift (second + fraction) into a whole number and a rest, exactly.
inline void gabor_impl_float_by(int cell, float local, int exponent, int drift, int second, float fraction, thread int& whole, thread float& rest) {
    int high = (second >> 16) * drift, low = (second & 0xffff) * drift;
    whole = -2 * high - (low >> 15);
    rest = -float(low & 32767) / 32768.0 - float(drift) / 32768.0 * fraction;
    int up = max(exponent, 0), down = max(-exponent, 0);
    whole += (cell >> up) << down;
    rest += (float(cell & (int(1u << uint(up)) - 1)) + local) * exp2(-float(exponent));
}

// The windows of three nodes, or two, along an axis. `x` is in node spacings from the first node.
inline void gabor_impl_water_windows(bool three, float x, thread float4& value, thread float4& slope) {
    if (three) {
        gabor_impl_windows(x - 1.0, value, slope);
        slope /= GABOR_RADIUS;
    } else { // 1 - s and s, divided by the root of the sum of their squares
        float s = x * x * (3.0 - 2.0 * x), scale = rsqrt(1.0 - 2.0 * s * (1.0 - s));
        value = scale * float4(1.0 - s, s, 0.0, 0.0);
        slope = 6.0 * x * (1.0 - x) * scale * scale * scale * float4(-s, 1.0 - s, 0.0, 0.0);
    }
}

// The parts xx, xy and xx + yy of a covariance with these variances along a unit vector and across it.
inline float3 gabor_impl_slopes_along(float2 variances, float2 along) {
    return float3((variances.x - variances.y) * along.x * along + float2(variances.y, 0.0), variances.x + variances.y);
}

// Adds a band with three nodes along each axis, or two. `least` is the square of a pixel's shorter side.
inline void gabor_impl_add_band(thread GaborWater& water, thread float3& squeeze, GaborOceanBand band, bool three, float2 heading, float2 quantum,
                         float least, int2 cell, float2 local, int second, float fraction, float2 dx, float2 dy, uint seed) {
    float lowest = quantum.x > 0.0 ? quantum.x * max(floor(band.low * quantum.y + 0.5), 1.0) : band.low;
    float longest = 1.486e-10 * lowest * lowest; // the smallest wave number, 2 pi f^2 / g
    if (band.amplitude == 0.0 || longest * longest * least > 1.6) { // each wave would be below 1 / 2700 of its height
        water.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    uint salt = gabor_impl_salt(seed);
    int whole_x, whole_y;
    float rest_x, rest_y;
    gabor_impl_float_by(cell.x, local.x, band.exponent, band.drift.x, second, fraction, whole_x, rest_x);
    gabor_impl_float_by(cell.y, local.y, band.exponent, band.drift.y, second, fraction, whole_y, rest_y);
    float2 rest = float2(rest_x, rest_y) + 1.52587890625e-5 * float2(float(salt & 0xffffu), float(salt >> 16u));
    float inset = three ? 0.5 : 0.0, spacing = exp2(float(band.exponent)), energy = three ? GABOR_IMPL_ENERGY : 1.0;
    float2 first = floor(rest - inset), offset = inset + clamp(rest - inset - first, 0.0, 1.0);
    int2 node = int2(whole_x, whole_y) + int2(first);
    float4 x, y, slope_x, slope_y;
    gabor_impl_water_windows(three, offset.x, x, slope_x);
    gabor_impl_water_windows(three, offset.y, y, slope_y);
    float deviation = three ? GABOR_IMPL_DEVIATION : 1.2432818e30;
    float3 shape = three ? float3(0.89289313, 7.3973916e18, 1.0034 * deviation) : float3(0.0, 1.0e21, 1.0297 * deviation);
    x *= band.amplitude / (energy * deviation);
    slope_x *= band.amplitude / (energy * deviation * spacing);
    slope_y /= spacing;
    float f = 1.4901161e-8 * band.low;
    float wave = (three ? 0.6383 : 0.622) * f * f; // 2 pi / g, less 0.3 or 3 % for the slopes that the windows add
    uint left = gabor_impl_line_word(node.x, salt), middle = gabor_impl_line_word(node.x + 1, salt);
    uint right = gabor_impl_line_word(node.x + 2, salt);
    float2 from = spacing * offset;
    for (int j = 0; j < (three ? 3 : 2); ++j) {
        uint row = gabor_impl_line_word(node.y + j, salt ^ GABOR_IMPL_ROWS);
        float2 w = j == 0 ? float2(y.x, slope_y.x) : j == 1 ? float2(y.y, slope_y.y) : float2(y.z, slope_y.z);
        gabor_impl_add_water(water, squeeze, row * left, from, float3(x.x * w.x, slope_x.x * w.x, x.x * w.y), band, heading, quantum, wave, shape, second, fraction, dx, dy);
        gabor_impl_add_water(water, squeeze, row * middle, from - float2(spacing, 0.0), float3(x.y * w.x, slope_x.y * w.x, x.y * w.y), band, heading, quantum, wave, shape, second, fraction, dx, dy);
        if (three)
            gabor_impl_add_water(water, squeeze, row * right, from - float2(2.0 * spacing, 0.0), float3(x.z * w.x, slope_x.z * w.x, x.z * w.y), band, heading, quantum, wave, shape, second, fraction, dx, dy);
        from.y -= spacing;
    }
}

inline GaborWater gabor_water_at(int2 cell, float2 local, int second, float fraction, float2 dx, float2 dy, GaborOcean ocean, uint seed) {
    float2 wind = gabor_impl_wave(0.15915494 * ocean.direction), swell = gabor_impl_wave(0.15915494 * ocean.swell.z);
    GaborWater water = GaborWater{0.0, float2(0.0), float2(0.0), 0.0, gabor_impl_slopes_along(ocean.tail, wind)};
    float3 squeeze = float3(0.0);
    float2 quantum = ocean.loop > 0 ? float2(float(65536 / max(ocean.loop, 1)), 1.52587890625e-5 * float(ocean.loop)) : float2(0.0);
    float area = dx.x * dy.y - dx.y * dy.x, sides = dot(dx, dx) + dot(dy, dy); // the pixel is an ellipse
    float least = 2.0 * area * area / max(sides + sqrt(max(sides * sides - 4.0 * area * area, 0.0)), 1.0e-30);
    int threes = min(GABOR_OCEAN_BANDS - 1, 3), last = ocean.swell.x > 0.0 ? threes + 1 : threes;
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
    water.fold = (1.0 - squeeze.x) * (1.0 - squeeze.z + squeeze.x) - squeeze.y * squeeze.y;
    water.lost = float3(water.lost.x, water.lost.z - water.lost.x, water.lost.y);
    return water;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

inline GaborWater gabor_water_filtered(float2 p, float2 dx, float2 dy, float seconds, GaborOcean ocean, uint seed) {
    float2 cell = floor(p);
    float second = floor(seconds);
    return gabor_water_at(int2(cell), p - cell, int(second), seconds - second, dx, dy, ocean, seed);
}

inline GaborWater gabor_water(float2 p, float seconds, GaborOcean ocean, uint seed) {
    return gabor_water_filtered(p, float2(0.0), float2(0.0), seconds, ocean, seed);
}

inline float gabor_water_height(float2 p, float seconds, GaborOcean ocean, uint seed) {
    GaborWater water = GaborWater{0.0, float2(0.0), float2(0.0), 0.0, float3(0.0)};
    for (int i = 0; i < 6; ++i) water = gabor_water(p - water.shift, seconds, ocean, seed);
    return water.height;
}

#endif // GABOR_OCEAN_METAL
