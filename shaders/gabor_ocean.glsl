// gabor_ocean.glsl: a sea that never repeats, at any point and time, without textures or state, alike on CPU and GPU.
//
// Paste or include this file after gabor_noise.glsl.
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

#ifndef GABOR_NOISE_GLSL
#error Include gabor_noise.glsl before gabor_ocean.glsl
#endif
#ifndef GABOR_OCEAN_GLSL
#define GABOR_OCEAN_GLSL 1
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
    vec2 slopes;     // variance of the slopes along the band's direction and across it
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    vec3 early;      // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next
    vec3 late;       // 3/16, 4/16, 4/16, 3/16 and 1/16
    vec3 spread;     // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in
    vec2 widen;      // [-1, 1], times a linear function of the frequency
    ivec2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;      // speed in metres per second, 10 m up
    float direction; // where the waves go: radians from +x towards +y
    float fetch;     // metres of open water upwind, 10^3 to 10^6: beyond 2190 wind^2, waves grow no more
    vec3 swell;      // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    int loop_seconds; // all repeats after so many, or 0 for never
    vec2 tail;       // variance of the slopes of waves shorter than all bands, along the wind and across it
    GaborOceanBand band[GABOR_OCEAN_BANDS + 1]; // the swell is the last
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
    vec2 slope;    // derivatives of the height by p
    vec2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float jacobian; // of p + shift by p, within 0.1, or 0.2 for a fetch of 1 km: 1 at rest, lower where water folds,
                    // with foam below 0.7
    vec3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
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
#define GABOR_IMPL_TICK 1.52587890625e-5
#define GABOR_IMPL_GRAVITY 9.81

// A JONSWAP spectrum: the frequency of its peak, its scale, and the logarithm of how much its peak is raised.
struct GaborImplJonswap {
    float peak;
    float scale;
    float sharp;
};

// The spectrum of waves that a wind raises over a fetch.
GaborImplJonswap gabor_impl_wind_waves(float wind, float fetch) {
    float gravity = GABOR_IMPL_GRAVITY, reach = min(gravity * fetch / (wind * wind), 2.15e4);
    float peak = 3.5 * gravity / wind * pow(reach, -0.33);
    float scale = 0.076 * pow(reach, -0.22) * gravity * gravity / 1558.5455; // (2 pi)^4
    return GaborImplJonswap(peak, scale, 1.1939225);                         // ln 3.3
}

// The spectrum at a frequency in m^2 / Hz, and the same times f^4.
vec2 gabor_impl_spectrum(float f, GaborImplJonswap sea) {
    float below = sea.peak * sea.peak / (f * f);
    float apart = (f / sea.peak - 1.0) / (f < sea.peak ? 0.07 : 0.09);
    return sea.scale / f * exp(sea.sharp * exp(-0.5 * apart * apart) - 1.25 * below * below)
         * vec2(1.0 / (f * f * f * f), 1.0);
}

// The frequency of step j of the 16, `width` wide, that a band's frequencies from `low` up are divided into.
float gabor_impl_step_frequency(int j, float low, float width) {
    return GABOR_IMPL_TICK * (low + (float(j) + 0.5) * width);
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less 1236 here.
struct GaborImplBandPower {
    vec2 sum;       // the power, and the same times f^4
    float variance; // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    vec4 fit;       // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
};

GaborImplBandPower gabor_impl_band_power(float low, GaborImplJonswap sea, bool remote) {
    GaborImplBandPower power = GaborImplBandPower(vec2(0.0), 0.0, vec4(0.0));
    float width = 0.025878906 * low; // 26.5/1024
    for (int j = 0; j < 16; ++j) {
        // 198.75 is 7.5 * 26.5
        float f = gabor_impl_step_frequency(j, low, width), x = 26.5 * float(j) - 198.75, above = f / sea.peak;
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        float s = remote ? 75.0 : 9.77 * pow(above, above < 1.0 ? 4.06 : -2.34);
        float here = 0.5 / (s + 1.0);
        vec2 part = GABOR_IMPL_TICK * width * gabor_impl_spectrum(f, sea);
        power.sum += part;
        power.variance += part.x * here;
        power.fit += part.x * vec4(x, sqrt(here), x * x, x * sqrt(here));
    }
    power.variance /= power.sum.x;
    power.fit /= power.sum.x;
    return power;
}

// The directions of a band: its members `spread` and `widen`, and the mean of cos^2 d.
struct GaborImplBandSpread {
    vec3 spread;
    vec2 widen;
    float along;
};

// sin(d / 2) is (a u + b u^3 + c v) times 1 + widen rise, where u and v are uniform in [-1, 1].
GaborImplBandSpread gabor_impl_band_spread(GaborImplBandPower power) {
    float variance = power.variance, deviation = sqrt(variance), narrow = 0.5 / variance - 1.8;
    vec4 fit = power.fit;
    float c = 0.9 * deviation * clamp(narrow, 0.0, 1.0);
    float widen = clamp(0.3 * narrow, 0.0, 1.0) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
    widen = floor(clamp(16384.0 * widen, -32.0, 32.0) + 0.5) / 16384.0;
    float most = 1.0 / (1.0 + 212.0 * abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
    // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
    float end = min(1.8 * deviation, most - c), rest = variance - c * c / 3.0;
    // 0.3047619 is 32/105, 0.0304762 is 16/525, 0.1142857 is 4/35 and 0.1523810 is 16/105
    float a = (sqrt(max(0.3047619 * rest - 0.0304762 * end * end, 0.0)) - 0.1142857 * end) / 0.1523810, b = end - a;
    // The mean of sin(d / 2)^4.
    // 0.57142857 is 4/7, 0.66666667 is 2/3, 0.36363636 is 4/11 and 0.076923077 is 1/13
    float fourth = a * a * a * (0.2 * a + 0.57142857 * b)
                 + b * b * (0.66666667 * a * a + 0.36363636 * a * b + 0.076923077 * b * b)
                 + c * c * (2.0 * rest + 0.2 * c * c);
    // 0.00390625 is 2^-8
    return GaborImplBandSpread(floor(511.5 * vec3(a, b, c)) * vec3(8.0, 0.00390625, 8.0),
                               floor(16384.0 * vec2(1.0 - (fit.x + 1236.0) * widen, widen)),
                               1.0 - 4.0 * variance + 4.0 * fourth);
}

// The frequencies of a band whose power is `whole`: its members `early` and `late`, by the inverse of the distribution.
// The knots have 0.0621, 0.2483, 0.4965, 0.7448, 0.931 and all of the power below them, instead of 1/16, 4/16, 8/16 and
// so on: between them, frequencies are uniform, and thus too high. Lower knots keep the variance of the slopes.
void gabor_impl_band_knots(float low, float whole, GaborImplJonswap sea, out vec3 early, out vec3 late) {
    vec3 first = vec3(0.0), second = vec3(0.0), ahead = vec3(0.0621, 0.2483, 0.4965);
    float width = 0.025878906 * low; // 26.5/1024
    for (int n = 0; n < 16; ++n) {
        float f = gabor_impl_step_frequency(n, low, width);
        float part = GABOR_IMPL_TICK * width / whole * gabor_impl_spectrum(f, sea).x;
        first += 26.5 * clamp(ahead / max(part, 1.0e-9), 0.0, 1.0);
        second += 26.5 * clamp((ahead + vec3(0.6827, 0.6827, 0.5035)) / max(part, 1.0e-9), 0.0, 1.0);
        ahead -= part;
    }
    early = floor((first - vec3(0.0, first.xy)) * vec3(4.0, 1.3333333, 1.0) + 0.5) / 256.0; // 4/3
    late = floor((second - vec3(first.z, second.xy)) * vec3(1.0, 1.3333333, 4.0) + 0.5) / 256.0;
    late -= vec3(early.z, late.xy);
    early -= vec3(0.0, early.xy);
}

GaborOcean gabor_ocean_of(float wind, float direction, float fetch, vec3 swell, int loop_seconds) {
    GaborOcean ocean;
    ocean.wind = clamp(wind, 2.0, 30.0);
    ocean.direction = direction;
    ocean.fetch = clamp(fetch, 1.0e3, 1.0e6);
    ocean.swell = vec3(clamp(swell.x, 0.0, 30.0), clamp(swell.y, 5.0, 25.0), swell.z);
    ocean.loop_seconds = loop_seconds > 0 ? int(1u << uint(log2(float(clamp(loop_seconds, 8, 4096))) + 0.0002)) : 0;
    ocean.tail = vec2(0.00316, 0.00192) * ocean.wind + vec2(0.0, 0.003); // [CM54]
    GaborImplJonswap sea = gabor_impl_wind_waves(ocean.wind, ocean.fetch);
    int octave = int(floor(log2(0.62 * sea.peak / GABOR_IMPL_TICK)));
    for (int i = 0; i <= GABOR_OCEAN_BANDS; ++i) {
        float low = float(((i & 1) == 0 ? 128u : 181u) << uint(octave + i / 2)) / 128.0;
        bool remote = i == GABOR_OCEAN_BANDS;
        if (remote) { // the swell
            sea.peak = 1.0 / ocean.swell.y;
            sea.sharp = 2.0794415; // ln 8
            // 0.0132813 is 0.85/64
            low = 64.0 * floor(0.0132813 * sea.peak / GABOR_IMPL_TICK + 0.5); // 0.85 times the peak
            direction = ocean.swell.z;
        }
        GaborImplBandPower power = gabor_impl_band_power(low, sea, remote);
        GaborImplBandSpread spread = gabor_impl_band_spread(power);
        GaborOceanBand band;
        float tall = remote ? 0.0625 * ocean.swell.x * ocean.swell.x
                     : low > 262144.0 ? 0.0 // below 0.1 m, waves are capillary
                                      : power.sum.x;
        band.amplitude = sqrt(tall);
        // (4 pi^2 / g)^2
        // 16.195056 was chosen near (4 pi^2 / g)^2, which is 16.195019
        band.slopes = 16.195056 * tall * power.sum.y / power.sum.x * vec2(spread.along, 1.0 - spread.along);
        if (!remote) ocean.tail -= band.slopes;
        band.exponent = remote ? int(floor(log2(18.0 / (sea.peak * sea.peak))))
                               : 34 - 2 * octave - i + (i > 0 && i < 4 ? 1 : -1);
        band.low = low;
        vec3 early, late;
        gabor_impl_band_knots(low, power.sum.x, sea, early, late);
        band.early = early;
        band.late = late;
        band.spread = spread.spread;
        band.widen = spread.widen;
        // 12.566371 is 4 pi and 1.1892071 is 2^(1/4)
        float speed = ocean.loop_seconds > 0 ? 0.0
                                     : 32768.0 * GABOR_IMPL_GRAVITY / (12.566371 * GABOR_IMPL_TICK * low * 1.1892071)
                                           * exp2(-float(band.exponent));
        band.drift = ivec2(floor(speed * gabor_impl_wave(0.15915494 * direction) + 0.5)); // 1/(2 pi)
        ocean.band[i] = band;
    }
    ocean.tail = max(ocean.tail, 0.0);
    return ocean;
}

GaborOcean gabor_ocean(float wind) {
    return gabor_ocean_of(wind, 0.0, 2.0e5, vec3(0.0), 0);
}

// ---- The water -----------------------------------------------------------------------------------------------------

// xx, xy and xx + yy of slopes with these variances along a unit vector and across it.
vec3 gabor_impl_slopes_along(vec2 variances, vec2 along) {
    return vec3((variances.x - variances.y) * along.x * along + vec2(variances.y, 0.0), variances.x + variances.y);
}

// The four nodes of a band around a point, together, which CPUs do faster: south west, south east, north west and
// north east.
struct GaborImplOceanNodes {
    uvec4 word;
    vec4 from_x; // offset of the point from the node, in metres
    vec4 from_y;
    vec4 window; // times the band's amplitude, as are its derivatives
    vec4 window_x;
    vec4 window_y;
};

GaborImplOceanNodes gabor_impl_ocean_nodes(GaborOceanBand band, ivec2 cell, vec2 local, int second, float fraction,
                                           uint salt) {
    // The place on the lattice is 2^-exponent (cell + local) - drift (second + fraction), as a whole number and a rest,
    // exactly.
    ivec2 drifted = (second & 32767) * band.drift; // below 2^31, as drifts are below 65536
    int up = max(band.exponent, 0), down = max(-band.exponent, 0);
    float spacing = exp2(float(band.exponent));
    vec2 rest = (vec2(cell & (int(1u << uint(up)) - 1)) + local) / spacing - vec2(drifted & 32767) / 32768.0
              - fraction / 32768.0 * vec2(band.drift) + vec2(float(salt & 0xffffu), float(salt >> 16u)) / 65536.0;
    vec2 first = floor(rest), offset = clamp(rest - first, 0.0, 1.0);
    ivec2 node = ((cell >> up) << down) - (second >> 15) * band.drift - (drifted >> 15) + ivec2(first);
    // The windows along an axis are the cosine and sine of an angle, so that their squares sum to 1.
    vec2 middle = 2.0 * offset - 1.0, fourth = middle * middle * middle * middle;
    // 0.15625 is 5/32 and 1.9634954 is 5/8 pi
    vec2 turns = 0.125 + middle * (0.15625 - 0.03125 * fourth), slope = 1.9634954 / spacing * (1.0 - fourth);
    vec2 turn_x = band.amplitude * gabor_impl_half_turn(turns.x), turn_y = gabor_impl_half_turn(turns.y);
    vec4 along_x = vec4(turn_x, turn_x), along_y = vec4(turn_y.xx, turn_y.yy);
    uint west = gabor_impl_line_word(node.x, salt), east = gabor_impl_line_word(node.x + 1, salt);
    uint south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS);
    uint north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    return GaborImplOceanNodes(uvec4(south * west, south * east, north * west, north * east),
                               spacing * (offset.x - vec4(0.0, 1.0, 0.0, 1.0)),
                               spacing * (offset.y - vec4(0.0, 0.0, 1.0, 1.0)), along_x * along_y,
                               slope.x * vec4(-turn_x.y, turn_x.x, -turn_x.y, turn_x.x) * along_y,
                               slope.y * vec4(-turn_y.yy, turn_y.xx) * along_x);
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    vec4 turning; // F - k.V, in quanta of frequency
    vec4 k;       // wave number, 2 pi over the wavelength in metres
    vec4 heading_x;
    vec4 heading_y;
};

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` 1024 (F / low)^2 cos d.
// `turning` is F - k.V, where k.V is `carried` times 861 / 2048, nearly 2^(-5/4). In a loop, the lattice stands.
GaborImplOceanWaves gabor_impl_ocean_waves(GaborOceanBand band, uvec4 word, bool normal, vec2 heading, float quantum,
                                           float scale, float half_step) {
    uvec4 bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    // 10, 11 and 11 bits
    vec4 share = vec4(bits >> 22u), u = vec4(ivec4(bits << 10u) >> 21), w = vec4(ivec4(bits << 21u) >> 21);
    vec4 rise = trunc(1024.0 + band.early.x * share + band.early.y * max(share - 64.0, 0.0)
                      + band.early.z * max(share - 256.0, 0.0) + band.late.x * max(share - 512.0, 0.0)
                      + band.late.y * max(share - 768.0, 0.0) + band.late.z * max(share - 960.0, 0.0));
    vec4 bent = trunc(band.spread.x + band.spread.y * trunc(0.001953125 * u * u)); // 2^-9
    vec4 angle = trunc(2.44140625e-4 * (u * bent + w * band.spread.z)) * (band.widen.x + band.widen.y * rise); // 2^-12
    vec4 part = trunc(1.220703125e-4 * angle), lag = trunc(4.8828125e-4 * part * part); // 2^-13, 2^-11
    vec4 steep = trunc(9.765625e-4 * rise * rise), carried = steep - trunc(9.765625e-4 * steep * lag); // 2^-10
    vec4 count = trunc(scale * rise + half_step);
    // 6.7265625 is 861/128
    vec4 turning = quantum * count - trunc((quantum > 1.0 ? 0.0 : band.low / 16384.0) * trunc(6.7265625 * carried));
    // 2 pi k, less 0.1 or 2 % for the slopes that the windows add
    vec4 k = (normal ? 0.9986 : 0.978) * 9.37e-10 * quantum * quantum * count * count;
    vec4 chord = 1.1920929e-7 * angle, cosine = 1.0 - 0.5 * chord * chord; // 2^-23
    vec4 sine = chord * sqrt(1.0 - 0.25 * chord * chord);
    return GaborImplOceanWaves(turning, k, heading.x * cosine - heading.y * sine,
                               heading.y * cosine + heading.x * sine);
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
void gabor_impl_add_band(inout GaborWater sum, inout vec3 squeeze, GaborOceanBand band, bool normal, vec2 heading,
                         vec2 quantum, float least, ivec2 cell, vec2 local, int second, float fraction, vec2 dx,
                         vec2 dy, uint seed) {
    float scale = 9.765625e-4 * band.low * quantum.y, half_step = max(0.5, 1.0 - 1024.0 * scale); // 2^-10
    float lowest = quantum.x * floor(1024.0 * scale + half_step);
    float longest = 1.486e-10 * lowest * lowest; // the least k, 2 pi F^2 / g
    if (band.amplitude == 0.0 || longest * longest * least > 1.6) { // each wave would be below 1 / 2700 of its height
        sum.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    GaborImplOceanNodes nodes = gabor_impl_ocean_nodes(band, cell, local, second, fraction, gabor_impl_salt(seed));
    GaborImplOceanWaves waves = gabor_impl_ocean_waves(band, nodes.word, normal, heading, quantum.x, scale, half_step);
    vec4 k = waves.k, x = waves.heading_x, y = waves.heading_y;
    uvec4 ticks = (uvec4(ivec4(waves.turning)) * uint(second) + (nodes.word >> 16u)) & 0xffffu;
    // 0.15915494 is 1/(2 pi) and 1.52587890625e-5 is 2^-16
    vec4 phase = 0.15915494 * k * (x * nodes.from_x + y * nodes.from_y)
               - 1.52587890625e-5 * (vec4(ticks) + waves.turning * fraction);
    vec2 a = gabor_impl_wave(phase.x), b = gabor_impl_wave(phase.y);
    vec2 c = gabor_impl_wave(phase.z), d = gabor_impl_wave(phase.w);
    vec4 steps_x = k * (x * dx.x + y * dx.y), steps_y = k * (x * dy.x + y * dy.y);
    vec4 kept = exp(-0.125 * (steps_x * steps_x + steps_y * steps_y));
    // The amplitude's square is uniform. For a normal distribution, the amplitude is nearly sqrt(-2 ln(1 - square)).
    vec4 square = 1.52587890625e-5 * vec4(nodes.word & 0xffffu), amplitude = kept * sqrt(square);
    // fit: see tools/constants.py
    amplitude *= normal ? 1.3034767 + 0.3870924 * square + 0.0960481 / (1.0580433 - square) : vec4(2.0);
    vec4 height = amplitude * vec4(a.y, b.y, c.y, d.y), along = nodes.window * amplitude * vec4(a.x, b.x, c.x, d.x);
    sum.slope += vec2(dot(height, nodes.window_x), dot(height, nodes.window_y));
    height *= nodes.window;
    vec4 steepness = k * along, squeezed = k * height;
    vec4 lost = (normal ? 1.003 : 1.048) * nodes.window * nodes.window * k * k * (1.0 - kept * kept);
    sum.height += dot(height, vec4(1.0));
    sum.slope += vec2(dot(steepness, x), dot(steepness, y));
    sum.shift += vec2(dot(along, x), dot(along, y));
    squeeze += vec3(dot(squeezed, x * x), dot(squeezed, x * y), dot(squeezed, vec4(1.0)));
    sum.lost += vec3(dot(lost, x * x), dot(lost, x * y), dot(lost, vec4(1.0)));
}

GaborWater gabor_water_at(ivec2 cell, vec2 local, int second, float fraction, vec2 dx, vec2 dy, GaborOcean ocean,
                          uint seed) {
    // 0.15915494 is 1/(2 pi)
    vec2 wind = gabor_impl_wave(0.15915494 * ocean.direction), swell = gabor_impl_wave(0.15915494 * ocean.swell.z);
    GaborWater water = GaborWater(0.0, vec2(0.0), vec2(0.0), 0.0, gabor_impl_slopes_along(ocean.tail, wind));
    vec3 squeeze = vec3(0.0);
    // 1.52587890625e-5 is 2^-16
    vec2 quantum = ocean.loop_seconds > 0
        ? vec2(float(65536 / max(ocean.loop_seconds, 1)), 1.52587890625e-5 * float(ocean.loop_seconds))
                                  : vec2(1.0);
    float area = dx.x * dy.y - dx.y * dy.x, sides = dot(dx, dx) + dot(dy, dy); // the pixel is an ellipse
    float least = 2.0 * area * area / max(sides + sqrt(max(sides * sides - 4.0 * area * area, 0.0)), 1.0e-30);
    for (int i = 0; i < (ocean.swell.x > 0.0 ? GABOR_OCEAN_BANDS + 1 : GABOR_OCEAN_BANDS); ++i) {
        bool remote = i == GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(water, squeeze, ocean.band[i], remote || (i > 0 && i < 4), remote ? swell : wind, quantum,
                            least, cell, local, second, fraction, dx, dy, gabor_derived_seed(seed, remote ? 12 : i));
    }
    water.jacobian = (1.0 - squeeze.x) * (1.0 - squeeze.z + squeeze.x) - squeeze.y * squeeze.y;
    water.lost = vec3(water.lost.x, water.lost.z - water.lost.x, water.lost.y);
    return water;
}

GaborWater gabor_water_filtered(vec2 p, vec2 dx, vec2 dy, float seconds, GaborOcean ocean, uint seed) {
    vec2 cell = floor(p);
    float second = floor(seconds);
    return gabor_water_at(ivec2(cell), p - cell, int(second), seconds - second, dx, dy, ocean, seed);
}

GaborWater gabor_water(vec2 p, float seconds, GaborOcean ocean, uint seed) {
    return gabor_water_filtered(p, vec2(0.0), vec2(0.0), seconds, ocean, seed);
}

float gabor_water_height(vec2 p, float seconds, GaborOcean ocean, uint seed) {
    GaborWater water = GaborWater(0.0, vec2(0.0), vec2(0.0), 0.0, vec3(0.0));
    for (int i = 0; i < 6; ++i) water = gabor_water(p - water.shift, seconds, ocean, seed);
    return water.height;
}

#endif
