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
#ifndef GABOR_OCEAN_BANDS
#define GABOR_OCEAN_BANDS 9 // octaves of wavelength, 1 to 12, from above the longest waves: 9 reach 0.8 m at 12 m/s
#elif GABOR_OCEAN_BANDS < 1 || GABOR_OCEAN_BANDS > 12
#error GABOR_OCEAN_BANDS must be 1 to 12
#endif

// Waves from one wavelength to half of it. `low`, `early`, `late` and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    float amplitude; // rms height in metres
    float2 slopes;     // variance of the slopes along the band's direction and across it
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    float3 early;      // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next 3/16, 4/16,
    float3 late;       // 4/16, 3/16 and 1/16
    float3 spread;     // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1],
    float2 widen;      // times a linear function of the frequency
    int2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;      // speed in metres per second, 10 m up
    float direction; // where the waves go: radians from +x towards +y
    float fetch;     // metres of open water upwind, 10^3 to 10^6: beyond 2190 wind^2, waves grow no more
    float3 swell;      // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    int loop_seconds; // all repeats after so many, or 0 for never
    float2 tail;       // variance of the slopes of waves shorter than all bands, along the wind and across it
    GaborOceanBand band[GABOR_OCEAN_BANDS + 1]; // the swell is the last
};
// GaborOcean gabor_ocean(float wind)
// GaborOcean gabor_ocean_of(float wind, float direction, float fetch, float3 swell, int loop_seconds)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] until it is fully developed [PM64], and the directions of [HDE80]. A swell, from a remote storm, has a
//     narrow spread of directions and a sharp peak [G10]; float3(0.0) is none. For films, all repeats after a loop of 8, 16, 32
//     ... 4096 seconds, to which other values are rounded down. Its price: groups of waves stand still, and each wave's period
//     becomes an integer fraction of it, so a loop should last several periods of the swell. Compute a sea once, on the CPU if
//     the CPU also asks for heights: the integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    float height;  // metres, of mean 0 and normally distributed
    float2 slope;    // derivatives of the height by p
    float2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float jacobian; // of p + shift by p, within 0.1, or 0.2 for a fetch of 1 km: 1 at rest, lower where water folds,
                    // with foam below 0.7
    float3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
};
// GaborWater gabor_water(float2 p, float seconds, GaborOcean ocean, uint seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(float2 p, float2 dx, float2 dy, float seconds, GaborOcean ocean, uint seed)
//     The same without waves that are too fine for a pixel (dx and dy are dfdx(p), dfdy(p)), whose slopes are in `lost`, as are
//     those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk measured [CM54], if the sea has
//     neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone have up to 1.8 times that.
// float gabor_water_height(float2 p, float seconds, GaborOcean ocean, uint seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.
// GaborWater gabor_water_at(int2 cell, float2 local, int whole_seconds, float fraction, float2 dx, float2 dy,
//                           GaborOcean ocean, uint seed)
//     At the position cell + local in metres, after whole_seconds + fraction: exact for years and anywhere. dx and dy
//     of
//     float2(0.0) do not filter.

// [HBB73] Hasselmann and others, "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project",
// 1973. [HDE80] Hasselmann, Dunckel, Ewing, "Directional wave spectra observed during JONSWAP 1973", 1980. [G10] Goda, "Random
// seas", 2010. [CM54] Cox, Munk, "Measurement of the roughness of the sea surface from photographs of the sun's glitter", 1954.
// [PM64] Pierson, Moskowitz, "A proposed spectral form for fully developed wind seas", 1964.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise of two taps whose nodes have wave vectors of their own, drawn from the band's part of the spectrum:
// an angle d from the band's direction and a frequency F, from which the wave number follows by the dispersion relation of deep
// water, (2 pi F)^2 = g |2 pi k|. The lattice drifts with the band's group velocity V, so that groups travel as they should; seen from
// there, phases turn by F - k.V. With V = g / (4 pi F0) along that direction, k.V = F^2 / (2 F0) cos d. F - k.V is an integer, so that
// the phase is exact after any time, and the same on every device: floats below 2^24 and powers of 2 are exact.
//
// Bands 1 to 3 and the swell hold most of the height: there, amplitudes are normal. In the others, their squares are uniform, to make
// up for the kurtosis that different directions give the slopes. Each seed shifts the lattices, so that no place differs from others.

inline float2 gabor_impl_spectrum(float f, float peak, float scale, float sharp) { // JONSWAP, in m^2 / Hz, and the same times f^4
    float below = peak * peak / (f * f), apart = (f / peak - 1.0) / (f < peak ? 0.07 : 0.09);
    return scale / f * exp(sharp * exp(-0.5 * apart * apart) - 1.25 * below * below) * float2(1.0 / (f * f * f * f), 1.0);
}

inline GaborOcean gabor_ocean_of(float wind, float direction, float fetch, float3 swell, int loop_seconds) {
    float gravity = 9.81, tick = 1.52587890625e-5;
    GaborOcean ocean;
    ocean.wind = clamp(wind, 2.0, 30.0);
    ocean.direction = direction;
    ocean.fetch = clamp(fetch, 1.0e3, 1.0e6);
    ocean.swell = float3(clamp(swell.x, 0.0, 30.0), clamp(swell.y, 5.0, 25.0), swell.z);
    ocean.loop_seconds = loop_seconds > 0 ? int(1u << uint(log2(float(clamp(loop_seconds, 8, 4096))) + 0.0002)) : 0;
    float reach = min(gravity * ocean.fetch / (ocean.wind * ocean.wind), 2.15e4), peak = 3.5 * gravity / ocean.wind * pow(reach, -0.33);
    float scale = 0.076 * pow(reach, -0.22) * gravity * gravity / 1558.5455, sharp = 1.1939225; // (2 pi)^4, ln 3.3
    int power = int(floor(log2(0.62 * peak / tick)));
    ocean.tail = float2(0.00316, 0.00192) * ocean.wind + float2(0.0, 0.003); // [CM54]
    for (int i = 0; i <= GABOR_OCEAN_BANDS; ++i) {
        float low = float(((i & 1) == 0 ? 128u : 181u) << uint(power + i / 2)) / 128.0;
        bool remote = i == GABOR_OCEAN_BANDS;
        if (remote) { // the swell
            peak = 1.0 / ocean.swell.y;
            low = 64.0 * floor(0.0132813 * peak / tick + 0.5); // 0.85 times the peak
            sharp = 2.0794415; // ln 8
            direction = ocean.swell.z;
        }
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        float width = 0.025878906 * low, variance = 0.0;
        float2 sum = float2(0.0);
        float4 fit = float4(0.0);
        for (int j = 0; j < 16; ++j) {
            float f = tick * (low + (float(j) + 0.5) * width), x = 26.5 * float(j) - 198.75; // rise - 1236
            float above = f / peak, s = remote ? 75.0 : 9.77 * pow(above, above < 1.0 ? 4.06 : -2.34), here = 0.5 / (s + 1.0);
            float2 part = tick * width * gabor_impl_spectrum(f, peak, scale, sharp);
            sum += part;
            variance += part.x * here;
            fit += part.x * float4(x, sqrt(here), x * x, x * sqrt(here));
        }
        variance /= sum.x;
        fit /= sum.x;
        float deviation = sqrt(variance), narrow = 0.5 / variance - 1.8, c = 0.9 * deviation * clamp(narrow, 0.0, 1.0);
        float widen = clamp(0.3 * narrow, 0.0, 1.0) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
        widen = floor(clamp(16384.0 * widen, -32.0, 32.0) + 0.5) / 16384.0; // by rise
        float most = 1.0 / (1.0 + 212.0 * abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
        float end = min(1.8 * deviation, most - c), rest = variance - c * c / 3.0;
        // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
        float a = (sqrt(max(0.3047619 * rest - 0.0304762 * end * end, 0.0)) - 0.1142857 * end) / 0.1523810, b = end - a;
        float fourth = a * a * a * (0.2 * a + 0.57142857 * b) + b * b * (0.66666667 * a * a + 0.36363636 * a * b + 0.076923077 * b * b)
                     + c * c * (2.0 * rest + 0.2 * c * c); // the mean of sin(d / 2)^4
        float along = 1.0 - 4.0 * variance + 4.0 * fourth; // the mean of cos^2 d
        // The knots have 0.0621, 0.2483, 0.4965, 0.7448, 0.931 and all of the power below them, instead of 1/16, 4/16, 8/16 and so
        // on: between them, frequencies are uniform, and thus too high. Lower knots keep the variance of the slopes.
        float3 early = float3(0.0), late = float3(0.0), ahead = float3(0.0621, 0.2483, 0.4965);
        for (int n = 0; n < 16; ++n) {
            float part = tick * width / sum.x * gabor_impl_spectrum(tick * (low + (float(n) + 0.5) * width), peak, scale, sharp).x;
            early += 26.5 * clamp(ahead / max(part, 1.0e-9), 0.0, 1.0);
            late += 26.5 * clamp((ahead + float3(0.6827, 0.6827, 0.5035)) / max(part, 1.0e-9), 0.0, 1.0);
            ahead -= part;
        }
        GaborOceanBand band;
        float tall = remote ? 0.0625 * ocean.swell.x * ocean.swell.x : low > 262144.0 ? 0.0 : sum.x; // below 0.1 m, waves are capillary
        band.amplitude = sqrt(tall);
        band.slopes = 16.195056 * tall * sum.y / sum.x * float2(along, 1.0 - along); // (4 pi^2 / g)^2
        if (!remote) ocean.tail -= band.slopes;
        band.exponent = remote ? int(floor(log2(18.0 / (peak * peak)))) : 34 - 2 * power - i + (i > 0 && i < 4 ? 1 : -1);
        band.low = low;
        band.early = floor((early - float3(0.0, early.xy)) * float3(4.0, 1.3333333, 1.0) + 0.5) / 256.0;
        band.late = floor((late - float3(early.z, late.xy)) * float3(1.0, 1.3333333, 4.0) + 0.5) / 256.0;
        band.late -= float3(band.early.z, band.late.xy);
        band.early -= float3(0.0, band.early.xy);
        band.spread = floor(511.5 * float3(a, b, c)) * float3(8.0, 0.00390625, 8.0);
        band.widen = floor(16384.0 * float2(1.0 - (fit.x + 1236.0) * widen, widen));
        float speed = ocean.loop_seconds > 0 ? 0.0
            : 32768.0 * gravity / (12.566371 * tick * low * 1.1892071) * exp2(-float(band.exponent));
        band.drift = int2(floor(speed * gabor_impl_wave(0.15915494 * direction) + 0.5));
        ocean.band[i] = band;
    }
    ocean.tail = max(ocean.tail, 0.0);
    return ocean;
}

inline GaborOcean gabor_ocean(float wind) {
    return gabor_ocean_of(wind, 0.0, 2.0e5, float3(0.0), 0);
}

inline float3 gabor_impl_slopes_along(float2 variances, float2 along) { // xx, xy and xx + yy for these variances along a unit vector and across
    return float3((variances.x - variances.y) * along.x * along + float2(variances.y, 0.0), variances.x + variances.y);
}

// Adds a band's four nodes around a point, together, which CPUs do faster. `quantum` is the spacing of frequencies and its inverse,
// `least` the square of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
inline void gabor_impl_add_band(thread GaborWater& sum, thread float3& squeeze, GaborOceanBand band, bool normal, float2 heading, float2 quantum,
                         float least, int2 cell, float2 local, int second, float fraction, float2 dx, float2 dy, uint seed) {
    float scale = 9.765625e-4 * band.low * quantum.y, half_step = max(0.5, 1.0 - 1024.0 * scale);
    float lowest = quantum.x * floor(1024.0 * scale + half_step), longest = 1.486e-10 * lowest * lowest; // the least k, 2 pi F^2 / g
    if (band.amplitude == 0.0 || longest * longest * least > 1.6) { // each wave would be below 1 / 2700 of its height
        sum.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    // The place on the lattice is 2^-exponent (cell + local) - drift (second + fraction), as a whole number and a rest, exactly.
    uint salt = gabor_impl_salt(seed);
    int2 drifted = (second & 32767) * band.drift; // below 2^31, as drifts are below 65536
    int up = max(band.exponent, 0), down = max(-band.exponent, 0);
    float spacing = exp2(float(band.exponent));
    float2 rest = (float2(cell & (int(1u << uint(up)) - 1)) + local) / spacing - float2(drifted & 32767) / 32768.0
              - fraction / 32768.0 * float2(band.drift) + float2(float(salt & 0xffffu), float(salt >> 16u)) / 65536.0;
    float2 first = floor(rest), offset = clamp(rest - first, 0.0, 1.0);
    int2 node = ((cell >> up) << down) - (second >> 15) * band.drift - (drifted >> 15) + int2(first);
    // The windows along an axis are the cosine and sine of an angle, so that their squares sum to 1.
    float2 middle = 2.0 * offset - 1.0, fourth = middle * middle * middle * middle, turns = 0.125 + middle * (0.15625 - 0.03125 * fourth);
    float2 turn_x = band.amplitude * gabor_impl_half_turn(turns.x), turn_y = gabor_impl_half_turn(turns.y);
    float2 slope = 1.9634954 / spacing * (1.0 - fourth);
    float4 along_x = float4(turn_x, turn_x), along_y = float4(turn_y.xx, turn_y.yy), window = along_x * along_y;
    float4 window_x = slope.x * float4(-turn_x.y, turn_x.x, -turn_x.y, turn_x.x) * along_y;
    float4 window_y = slope.y * float4(-turn_y.yy, turn_y.xx) * along_x;
    float4 from_x = spacing * (offset.x - float4(0.0, 1.0, 0.0, 1.0)), from_y = spacing * (offset.y - float4(0.0, 0.0, 1.0, 1.0));
    uint west = gabor_impl_line_word(node.x, salt), east = gabor_impl_line_word(node.x + 1, salt);
    uint south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS), north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    uint4 word = uint4(south * west, south * east, north * west, north * east), bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    // `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` 1024 (F / low)^2 cos d. `turning` is
    // F - k.V, where k.V is `carried` times 861 / 2048, nearly 2^(-5/4). In a loop, the lattice stands.
    float4 share = float4(bits >> 22u), u = float4(int4(bits << 10u) >> 21), w = float4(int4(bits << 21u) >> 21); // 10, 11 and 11 bits
    float4 rise = trunc(1024.0 + band.early.x * share + band.early.y * max(share - 64.0, 0.0)
                    + band.early.z * max(share - 256.0, 0.0) + band.late.x * max(share - 512.0, 0.0)
                    + band.late.y * max(share - 768.0, 0.0) + band.late.z * max(share - 960.0, 0.0));
    float4 bent = trunc(band.spread.x + band.spread.y * trunc(0.001953125 * u * u));
    float4 angle = trunc(2.44140625e-4 * (u * bent + w * band.spread.z)) * (band.widen.x + band.widen.y * rise);
    float4 part = trunc(1.220703125e-4 * angle), lag = trunc(4.8828125e-4 * part * part);
    float4 steep = trunc(9.765625e-4 * rise * rise), carried = steep - trunc(9.765625e-4 * steep * lag);
    float4 count = trunc(scale * rise + half_step);
    float4 turning = quantum.x * count - trunc((quantum.x > 1.0 ? 0.0 : band.low / 16384.0) * trunc(6.7265625 * carried));
    // 2 pi k, less 0.1 or 2 % for the slopes that the windows add
    float4 k = (normal ? 0.9986 : 0.978) * 9.37e-10 * quantum.x * quantum.x * count * count;
    float4 chord = 1.1920929e-7 * angle, cosine = 1.0 - 0.5 * chord * chord, sine = chord * sqrt(1.0 - 0.25 * chord * chord);
    float4 x = heading.x * cosine - heading.y * sine, y = heading.y * cosine + heading.x * sine;
    uint4 ticks = (uint4(int4(turning)) * uint(second) + (word >> 16u)) & 0xffffu;
    float4 phase = 0.15915494 * k * (x * from_x + y * from_y) - 1.52587890625e-5 * (float4(ticks) + turning * fraction);
    float2 a = gabor_impl_wave(phase.x), b = gabor_impl_wave(phase.y), c = gabor_impl_wave(phase.z), d = gabor_impl_wave(phase.w);
    float4 square = 1.52587890625e-5 * float4(word & 0xffffu), steps_x = k * (x * dx.x + y * dx.y), steps_y = k * (x * dy.x + y * dy.y);
    float4 kept = exp(-0.125 * (steps_x * steps_x + steps_y * steps_y)), amplitude = kept * sqrt(square);
    // The square is uniform. For a normal distribution, the amplitude is nearly sqrt(-2 ln(1 - square)).
    amplitude *= normal ? 1.3034767 + 0.3870924 * square + 0.0960481 / (1.0580433 - square) : float4(2.0);
    float4 height = amplitude * float4(a.y, b.y, c.y, d.y), along = window * amplitude * float4(a.x, b.x, c.x, d.x);
    sum.slope += float2(dot(height, window_x), dot(height, window_y));
    height *= window;
    float4 steepness = k * along, squeezed = k * height, lost = (normal ? 1.003 : 1.048) * window * window * k * k * (1.0 - kept * kept);
    sum.height += dot(height, float4(1.0));
    sum.slope += float2(dot(steepness, x), dot(steepness, y));
    sum.shift += float2(dot(along, x), dot(along, y));
    squeeze += float3(dot(squeezed, x * x), dot(squeezed, x * y), dot(squeezed, float4(1.0)));
    sum.lost += float3(dot(lost, x * x), dot(lost, x * y), dot(lost, float4(1.0)));
}

inline GaborWater gabor_water_at(int2 cell, float2 local, int whole_seconds, float fraction, float2 dx, float2 dy, GaborOcean ocean,
                          uint seed) {
    float2 wind = gabor_impl_wave(0.15915494 * ocean.direction), swell = gabor_impl_wave(0.15915494 * ocean.swell.z);
    GaborWater water = GaborWater{0.0, float2(0.0), float2(0.0), 0.0, gabor_impl_slopes_along(ocean.tail, wind)};
    float3 squeeze = float3(0.0);
    float2 quantum = ocean.loop_seconds > 0
        ? float2(float(65536 / max(ocean.loop_seconds, 1)), 1.52587890625e-5 * float(ocean.loop_seconds)) : float2(1.0);
    float area = dx.x * dy.y - dx.y * dy.x, sides = dot(dx, dx) + dot(dy, dy); // the pixel is an ellipse
    float least = 2.0 * area * area / max(sides + sqrt(max(sides * sides - 4.0 * area * area, 0.0)), 1.0e-30);
    for (int i = 0; i < (ocean.swell.x > 0.0 ? GABOR_OCEAN_BANDS + 1 : GABOR_OCEAN_BANDS); ++i) {
        bool remote = i == GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(water, squeeze, ocean.band[i], remote || (i > 0 && i < 4), remote ? swell : wind, quantum, least, cell, local,
                            whole_seconds, fraction, dx, dy, gabor_derived_seed(seed, remote ? 12 : i));
    }
    water.jacobian = (1.0 - squeeze.x) * (1.0 - squeeze.z + squeeze.x) - squeeze.y * squeeze.y;
    water.lost = float3(water.lost.x, water.lost.z - water.lost.x, water.lost.y);
    return water;
}

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
