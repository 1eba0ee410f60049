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
//     white water                                      gabor_foam
//     a world of any size, or months of time           gabor_water_at
//     a swell, another fetch or depth, a loop          gabor_ocean_of
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

// Waves from one wavelength to half of it, or to 0.7 of it. Frequencies and directions are multiples of powers of 2, so
// that sums are exact. The structs are laid out alike in C++, std430 and std140.
struct GaborOceanBand {
    float amplitude; // rms height in metres
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    float orbit;     // how much longer than high the orbits of water are: 1 in deep water
    gabor_vec2 slopes;     // variance of the slopes along the band's direction and across it
    gabor_vec2 widen;      // spread, blunt: sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v
    gabor_vec2 spread;     // uniform in [-1, 1], times a linear function of the frequency
    float blunt;
    float rise;      // how fast the frequency rises from `low`
    gabor_vec4 knots;      // at these shares of power, of 1024, and at last.x,
    gabor_vec4 faster;     // it rises faster from there on, by these, and by last.y
    gabor_vec2 last;
    gabor_vec2 carry;      // the wave number over the frequency, times the group velocity: at 0 Hz, and how fast it rises
    gabor_vec2 number;     // the wave number over the frequency likewise
    gabor_ivec2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;
    float direction;
    float fetch;
    float water_depth;
    gabor_vec3 swell; // height, period and direction
    int loop_seconds;
    gabor_vec2 tail; // variance of the slopes of waves shorter than all bands, along the wind and across it
    gabor_vec2 high; // rms height, and rms displacement along the wind, in metres
    GaborOceanBand band[GABOR_OCEAN_BANDS + 2] = {}; // the swell's longer and shorter waves are the last two
};

// What a sea depends on.
struct GaborSea {
    float wind;            // wind speed at a height of 10 m, 2 to 30 metres per second
    float fetch;           // open water upwind, 200 km for a grown sea, 1000 to 1000000 metres: a few kilometres for a
                           // lake, and beyond 2190 wind^2, waves grow no more
    float swell_height;    // significant height of a far storm's swell, 0 for none, 0 to 30 metres, usually 0 to 8: up
                           // to 0.07 of its wavelength, 0.11 period^2 in deep water
    float swell_period;    // time from crest to crest of the swell, 5 to 25 seconds
    float swell_direction; // where the swell goes, from +x towards +y, -628.31853 to 628.31853 radians
    float water_depth;     // depth of the water, or 0 for deep water, 0 to 10000 metres, usually 0 to 100: at
                           // least 1 if not 0
    float direction;       // where the wind and its waves go: radians from +x towards +y
    int loop_seconds;      // all repeats after 8, 16, 32 ... 4096 seconds, or 0 for never
};
// GaborSea gabor_sea()
//     A wind of 10 m/s along x, a fetch of 200 km, no swell, deep water, no loop.
// GaborOcean gabor_ocean(float wind)
// GaborOcean gabor_ocean_of(GaborSea state)
//     The waves of a sea; gabor_ocean is for any wind and what gabor_sea returns. The spectrum is JONSWAP's [HBB73]
//     until the sea is fully developed [PM64], in finite depth that of [BGR85], and directions are those of [HDE80], as
//     if the wind were at most twice as fast as the peak's waves: younger seas would have no direction. A swell has a
//     narrow spread of directions and a sharp peak [G10]; in narrow bins of frequency, its power is wrong by factors of
//     up to 1.23. Waves do not shorten towards a shore: the depth is one for all the sea. A loop's price: groups of
//     waves stand still, and each wave's period becomes an integer fraction of it, so that it should last several
//     periods of the swell; other values are rounded down. Compute a sea once, on the CPU if the CPU also asks for
//     heights: the integers may round differently on another device. To change a member, call this again. Beyond their
//     ranges, members count as the nearest value within.

// The water particle whose position at rest is p. It is now at p + shift.
struct GaborWater {
    float height;  // metres, of mean 0 and normally distributed
    gabor_vec2 slope;    // derivatives of the height by p
    gabor_vec2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float jacobian; // of p + shift by p, within 0.2, or 0.3 for a fetch of 1 km: 1 at rest, lower where it folds
    gabor_vec3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
    gabor_vec3 velocity; // of the water in metres per second: along x, along y, and up
};
// GaborWater gabor_water(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(vec2 p, vec2 dx, vec2 dy, float seconds, GaborOcean ocean, uint seed)
//     The same without waves that are too fine for a pixel (dx and dy are dFdx(p), dFdy(p)), whose slopes are in
//     `lost`, as are those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk
//     measured [CM54], if the sea has neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone
//     have up to 1.8 times that.
// float gabor_water_height(vec2 p, float seconds, GaborOcean ocean, uint seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations. CPU and GPU agree.
// float gabor_foam(vec2 p, vec2 dx, vec2 dy, GaborWater water, GaborOcean ocean, uint seed)
//     The share of white water, 0 to 1, in a pixel whose water is gabor_water_filtered(p, dx, dy, ...): behind high
//     crests, for some seconds. At any fetch, as much of the sea is white as Monahan and O'Muircheartaigh measured at
//     its wind [MO80], at most 0.3, and at most 0.0015 below 6 m/s. dx and dy of vec2(0.0) are for a point.
// GaborWater gabor_water_at(ivec2 cell, vec2 local, int second, float fraction, vec2 dx, vec2 dy, GaborOcean ocean,
//                            uint seed)
//     At the position cell + local in metres, after second + fraction: exact for years and anywhere. dx and dy of
//     vec2(0.0) do not filter.

// [BGR85] Bouws, Gunther, Rosenthal, Vincent: Similarity of the wind wave spectrum in finite depth water, 1985. [CM54]
// Cox, Munk: Measurement of the roughness of the sea surface from photographs of the sun's glitter, 1954. [G10] Goda:
// Random seas, 2010. [HBB73] Hasselmann and others: Measurements of wind-wave growth and swell decay during the Joint
// North Sea Wave Project, 1973. [HDE80] Hasselmann, Dunckel, Ewing: Directional wave spectra observed during JONSWAP
// 1973, 1980. [MO80] Monahan, O'Muircheartaigh: Optimal power-law description of oceanic whitecap coverage dependence
// on wind speed, 1980. [PM64] Pierson, Moskowitz: A proposed spectral form for fully developed wind seas, 1964.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise of two taps whose nodes have wave vectors of their own, drawn from the band's part of
// the spectrum: an angle d from the band's direction and a frequency F, from which the wave number follows by the
// dispersion relation of deep water, (2 pi F)^2 = g |2 pi k|. The lattice drifts with the band's group velocity V, so
// that groups travel as they should; seen from there, phases turn by F - k.V. With V = g / (4 pi F0) along that
// direction, k.V = F^2 / (2 F0) cos d in deep water. F - k.V is an integer, so that the phase is exact after any time,
// and the same on every device: floats below 2^24 and powers of 2 are exact.
//
// Bands 0 to 4 and the swell hold most of the height: there, amplitudes are normal. In the others, their squares are
// uniform, to make up for the kurtosis that different directions give the slopes. Each seed shifts the lattices, so
// that no place differs from others.

// ---- The sea's bands -----------------------------------------------------------------------------------------------

// The frequencies of bands are multiples of this many Hz, 2^-16.
#define GABOR_IMPL_TICK 1.52587890625e-5f
#define GABOR_IMPL_GRAVITY 9.81f

// A JONSWAP spectrum: the frequency of its peak, its scale, and the logarithm of how much its peak is raised. `depth`
// is 0 for deep water, and `young` the power of frequencies over the peak's with which directions widen.
struct GaborImplJonswap {
    float peak;
    float scale;
    float sharp;
    float depth;
    float young;
};

// The spectrum of waves that a wind raises over a fetch.
GABOR_INLINE GaborImplJonswap gabor_impl_wind_waves(float wind, float fetch, float depth) {
    float gravity = GABOR_IMPL_GRAVITY, reach = gabor_cpp_min(gravity * fetch / (wind * wind), 2.15e4f);
    float peak = 3.5f * gravity / wind * gabor_cpp_pow(reach, -0.33f);
    float scale = 0.076f * gabor_cpp_pow(reach, -0.22f) * gravity * gravity / 1558.5455f; // (2 pi)^4
    float age = gabor_cpp_min(22.0f * gabor_cpp_pow(reach, -0.33f), 2.0f);                          // the wind over the peak's phase speed
    return GaborImplJonswap{peak, scale, 1.1939225f, depth, -2.33f - 1.45f * (age - 1.17f)}; // ln 3.3
}

// Of waves of a frequency: the wave number, 2 pi over the wavelength in metres, and 2 depth / (sinh(2 depth)) for a
// depth in wave numbers, 0 in deep water.
GABOR_INLINE gabor_vec2 gabor_impl_dispersion(float f, float depth) {
    float deep = 39.478418f / GABOR_IMPL_GRAVITY * f * f; // 4 pi^2
    if (depth <= 0.0f) return gabor_vec2(deep, 0.0f);
    // Newton's method for x tanh x = y, where x is the wave number times the depth
    float y = deep * depth, x = y * gabor_cpp_inversesqrt(1.0f - gabor_cpp_exp(-2.0f * y)), e = 0.0f;
    for (int n = 0; n < 4; ++n) {
        e = gabor_cpp_exp(-2.0f * x);
        float slow = (1.0f - e) / (1.0f + e);
        x -= (x * slow - y) / (slow + x * (1.0f - slow * slow));
    }
    e = gabor_cpp_exp(-2.0f * x);
    return gabor_vec2(x / depth, 4.0f * x * e / (1.0f - e * e));
}

// The spectrum at a frequency in m^2 / Hz, in finite depth by [BGR85].
GABOR_INLINE float gabor_impl_spectrum(float f, GaborImplJonswap sea) {
    float below = sea.peak * sea.peak / (f * f);
    float apart = (f / sea.peak - 1.0f) / (f < sea.peak ? 0.07f : 0.09f);
    float deep = sea.scale / (f * f * f * f * f)
               * gabor_cpp_exp(sea.sharp * gabor_cpp_exp(-0.5f * apart * apart) - 1.25f * below * below);
    gabor_vec2 waves = gabor_impl_dispersion(f, sea.depth);
    float slow = 39.478418f / GABOR_IMPL_GRAVITY * f * f / waves.x; // 4 pi^2
    return deep * slow * slow / (1.0f + waves.y);
}

// A band's frequencies, from `low` to 1 + reach / 1024 times that, are divided into 32 steps: their width in Hz, and
// the frequency of step j.
GABOR_INLINE float gabor_impl_step_width(float low, float reach) {
    return GABOR_IMPL_TICK * low * reach / 32768.0f; // 32 * 1024
}
GABOR_INLINE float gabor_impl_step_frequency(int j, float low, float reach) {
    return GABOR_IMPL_TICK * low + (float(j) + 0.5f) * gabor_impl_step_width(low, reach);
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less the band's middle.
struct GaborImplBandPower {
    float sum;
    float steep;    // the mean square of the wave number
    float variance; // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    gabor_vec4 fit;       // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
};

GABOR_INLINE GaborImplBandPower gabor_impl_band_power(float low, float reach, GaborImplJonswap sea, bool remote) {
    GaborImplBandPower power = GaborImplBandPower{0.0f, 0.0f, 0.0f, gabor_vec4(0.0f)};
    for (int j = 0; j < 32; ++j) {
        float f = gabor_impl_step_frequency(j, low, reach), x = (float(j) - 15.5f) * reach / 32.0f, above = f / sea.peak;
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        float s = remote ? 75.0f : above < 1.0f ? 6.97f * gabor_cpp_pow(above, 4.06f) : 9.77f * gabor_cpp_pow(above, sea.young); // [HDE80]
        float here = 0.5f / (s + 1.0f), k = gabor_impl_dispersion(f, sea.depth).x;
        float part = gabor_impl_step_width(low, reach) * gabor_impl_spectrum(f, sea);
        power.sum += part;
        power.steep += part * k * k;
        power.variance += part * here;
        power.fit += part * gabor_vec4(x, gabor_cpp_sqrt(here), x * x, x * gabor_cpp_sqrt(here));
    }
    power.steep /= power.sum;
    power.variance /= power.sum;
    power.fit /= power.sum;
    return power;
}

// Sets the directions of a band, and returns the mean of cos^2 d. sin(d / 2) is (a u + b u^3 + c v) times
// 1 + widen rise, where u and v are uniform in [-1, 1].
GABOR_INLINE float gabor_impl_set_directions(GaborOceanBand& band, float reach, GaborImplBandPower power) {
    float variance = power.variance, deviation = gabor_cpp_sqrt(variance), narrow = 0.5f / variance - 1.8f;
    gabor_vec4 fit = power.fit;
    float c = 0.9f * deviation * gabor_cpp_clamp(narrow, 0.0f, 1.0f);
    float widen = gabor_cpp_clamp(0.3f * narrow, 0.0f, 1.0f) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
    widen = gabor_cpp_floor(gabor_cpp_clamp(16384.0f * widen, -32.0f, 32.0f) + 0.5f) / 16384.0f;
    float most = 1.0f / (1.0f + 0.5f * reach * gabor_cpp_abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
    // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
    float end = gabor_cpp_min(1.8f * deviation, most - c), rest = variance - c * c / 3.0f;
    // 0.3047619 is 32/105, 0.0304762 is 16/525, 0.1142857 is 4/35 and 0.1523810 is 16/105
    float a = (gabor_cpp_sqrt(gabor_cpp_max(0.3047619f * rest - 0.0304762f * end * end, 0.0f)) - 0.1142857f * end) / 0.1523810f, b = end - a;
    // The mean of sin(d / 2)^4.
    // 0.57142857 is 4/7, 0.66666667 is 2/3, 0.36363636 is 4/11 and 0.076923077 is 1/13
    float fourth = a * a * a * (0.2f * a + 0.57142857f * b)
                 + b * b * (0.66666667f * a * a + 0.36363636f * a * b + 0.076923077f * b * b)
                 + c * c * (2.0f * rest + 0.2f * c * c);
    band.spread = gabor_cpp_floor(511.5f * gabor_vec2(a, b)) * gabor_vec2(8.0f, 0.00390625f); // 2^-8
    band.blunt = 8.0f * gabor_cpp_floor(511.5f * c);
    band.widen = gabor_cpp_floor(16384.0f * gabor_vec2(1.0f - (fit.x + 1024.0f + 0.5f * reach) * widen, widen));
    return 1.0f - 4.0f * variance + 4.0f * fourth;
}

// Of a step, the power before windows blur it by `blur` Hz, and how much the spectrum changes there. A band's low end
// is blurred more than the high end of the band before.
GABOR_INLINE gabor_vec2 gabor_impl_step_sharp(int n, float low, float reach, float blur, gabor_vec2 edge, GaborImplJonswap sea) {
    float f = gabor_impl_step_frequency(n, low, reach);
    gabor_vec3 power = gabor_vec3(0.0f); // here, before and after
    for (int i = 0; i < 3; ++i) { // a single call, because compilers copy what it calls to each place
        float here = gabor_impl_spectrum(i == 0 ? f : i == 1 ? f - blur : f + blur, sea);
        power = i == 0 ? gabor_vec3(here, 0.0f, 0.0f) : i == 1 ? gabor_vec3(power.x, here, 0.0f) : gabor_vec3(power.xy(), here);
    }
    float sharp = gabor_cpp_max(2.0f * power.x - 0.5f * (power.y + power.z), 0.2f * power.x);
    return gabor_vec2(sharp * (n < 4 ? edge.x : n < 28 ? 1.0f : edge.y), gabor_cpp_abs(power.z - power.y));
}

// Sets the frequencies of a band, by the inverse of their distribution. Between six knots, all have the same chance.
// Knots stand closer where the spectrum changes. At least 8 of 1024 shares of power are between two.
GABOR_INLINE void gabor_impl_set_frequencies(GaborOceanBand& band, float reach, float blur, gabor_vec2 beside,
                                GaborImplJonswap sea) {
    gabor_vec2 sum = gabor_vec2(0.0f);
    float steps = 32.0f * gabor_impl_step_width(band.low, reach);
    gabor_vec2 edge = gabor_cpp_clamp(1.0f + 2.3f * blur / steps * (1.0f - beside), 0.3f, 1.7f);
    for (int j = 0; j < 32; ++j) sum += gabor_impl_step_sharp(j, band.low, reach, blur, edge, sea);
    // The shares of power below the knots, and how far the knots are from the lowest frequency.
    gabor_vec3 first = gabor_vec3(0.0f), second = gabor_vec3(0.0f), to_first = gabor_vec3(0.0f), to_second = gabor_vec3(0.0f);
    gabor_vec3 ahead = gabor_vec3(1.0f, 2.0f, 3.0f) / 6.0f;
    for (int n = 0; n < 32; ++n) {
        gabor_vec2 part = gabor_impl_step_sharp(n, band.low, reach, blur, edge, sea) / sum;
        float both = 0.5f * part.y + 0.015625f; // 1/64
        gabor_vec3 early = gabor_cpp_clamp(ahead / both, 0.0f, 1.0f), late = gabor_cpp_clamp((ahead + 0.5f) / both, 0.0f, 1.0f);
        first += 1024.0f * part.x * early;
        second += 1024.0f * part.x * late;
        to_first += 0.03125f * reach * early;
        to_second += 0.03125f * reach * late;
        ahead -= both;
    }
    first = gabor_cpp_clamp(gabor_cpp_floor(first + 0.5f), gabor_vec3(8.0f, 16.0f, 24.0f), gabor_vec3(984.0f, 992.0f, 1000.0f));
    second = gabor_cpp_clamp(gabor_cpp_floor(second + 0.5f), gabor_vec3(32.0f, 40.0f, 1024.0f), gabor_vec3(1008.0f, 1016.0f, 1024.0f));
    first.y = gabor_cpp_max(first.y, first.x + 8.0f);
    first.z = gabor_cpp_max(first.z, first.y + 8.0f);
    second.x = gabor_cpp_max(second.x, first.z + 8.0f);
    second.y = gabor_cpp_max(second.y, second.x + 8.0f);
    gabor_vec3 early = gabor_cpp_floor(256.0f * (to_first - gabor_vec3(0.0f, to_first.xy())) / (first - gabor_vec3(0.0f, first.xy())) + 0.5f) / 256.0f;
    gabor_vec3 late = (to_second - gabor_vec3(to_first.z, to_second.xy())) / (second - gabor_vec3(first.z, second.xy()));
    late = gabor_cpp_floor(256.0f * late + 0.5f) / 256.0f;
    band.rise = early.x;
    band.knots = gabor_vec4(first, second.x);
    band.faster = gabor_vec4(early.yz(), late.xy()) - gabor_vec4(early, late.x);
    band.last = gabor_vec2(second.y, late.z - late.y);
}

// A band of frequencies from `low` to 1 + reach / 1024 times that, with nodes 2^(exponent - halvings) metres apart.
// `beside` is the blur of the bands below and above it, relative to this band's. `along` becomes the mean of cos^2 d.
GABOR_INLINE GaborOceanBand gabor_impl_band(float low, float reach, int exponent, int halvings, float direction, gabor_vec2 beside,
                               GaborImplJonswap sea, bool remote, bool stands, float& along) {
    GaborImplBandPower power = gabor_impl_band_power(low, reach, sea, remote);
    // Each member has a value, which FXC demands of an inout argument.
    GaborOceanBand band = GaborOceanBand{0.0f, exponent - halvings, low, 0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, 0.0f,
                                         gabor_vec4(0.0f), gabor_vec4(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_ivec2(0)};
    along = gabor_impl_set_directions(band, reach, power);
    band.slopes = power.sum * power.steep * gabor_vec2(along, 1.0f - along);
    // The wave number over the frequency, nearly: exact at a quarter and three quarters of the band, and in deep water.
    float quarter = 0.25f * GABOR_IMPL_TICK * low * reach / 1024.0f, first = GABOR_IMPL_TICK * low + quarter;
    gabor_vec2 lower = gabor_impl_dispersion(first, sea.depth) / first;
    gabor_vec2 upper = gabor_impl_dispersion(first + 2.0f * quarter, sea.depth) / (first + 2.0f * quarter);
    float deep = 39.478418f / GABOR_IMPL_GRAVITY; // 4 pi^2
    float rate = sea.depth > 0.0f ? (upper.x - lower.x) / (2.0f * quarter) : deep;
    float base = sea.depth > 0.0f ? lower.x - rate * first : 0.0f;
    // The group velocity at the mean frequency is half the phase velocity times 1 + 2 depth / sinh(2 depth).
    float mean = GABOR_IMPL_TICK * low * (1.0f + (power.fit.x + 0.5f * reach) / 1024.0f);
    gabor_vec2 waves = gabor_impl_dispersion(mean, sea.depth);
    float speed = 3.1415927f * mean / waves.x * (1.0f + waves.y), spacing = gabor_cpp_exp2(float(exponent)); // pi
    // Nodes that are nearer by 2^halvings move slower, so that as many pass in a second.
    float nearer = gabor_cpp_exp2(float(halvings));
    band.orbit = waves.x / (deep * mean * mean);
    // 2097152.0 is 2^21, and 0.15915494 is 1/(2 pi)
    float carry = 2097152.0f * 0.15915494f / 861.0f * speed / nearer;
    band.carry = gabor_cpp_floor(carry * gabor_vec2(1024.0f * base, rate * GABOR_IMPL_TICK * low) + 0.5f) / 1024.0f;
    gabor_vec2 drift = (stands ? 0.0f : 32768.0f * speed / spacing) * gabor_impl_wave(0.15915494f * direction);
    band.drift = gabor_ivec2(gabor_cpp_floor(drift + 0.5f));
    // The share of slopes that windows add. Longer waves make up for half of it, as set_frequencies has sharpened the
    // spectrum; for what nearer nodes add, waves are both longer and lower.
    float added = 5.482f / (spacing * spacing * power.steep); // 64/45 (5/8 pi)^2: 64/45 is the integral of (1 - x^4)^2
    float more = added * (nearer * nearer - 1.0f);
    band.amplitude = gabor_cpp_sqrt(power.sum / (1.0f + 0.3f * more));
    band.number = (1.0f - 0.27f * added - 0.35f * more) * GABOR_IMPL_TICK * gabor_vec2(base, GABOR_IMPL_TICK * rate);
    // The windows blur frequencies by 3.372^(1/2) / (2 pi) for each spacing that passes in a second.
    gabor_impl_set_frequencies(band, reach, 0.2923f * speed / spacing, beside, sea);
    return band;
}

// 2^(q/4), nearly, such that sums are exact.
GABOR_INLINE float gabor_impl_quarter_octave(int q) {
    std::uint32_t part = (q & 2) == 0 ? ((q & 1) == 0 ? 128u : 152u) : (q & 1) == 0 ? 181u : 215u;
    return float(part << std::uint32_t(q >> 2)) / 128.0f;
}

GABOR_INLINE GaborSea gabor_sea() {
    return GaborSea{10.0f, 2.0e5f, 0.0f, 12.0f, 1.0471976f, 0.0f, 0.0f, 0}; // pi/3
}

GABOR_INLINE GaborOcean gabor_ocean_of(GaborSea state) {
    GaborOcean ocean;
    ocean.wind = gabor_cpp_clamp(state.wind, 2.0f, 30.0f);
    ocean.direction = state.direction;
    ocean.fetch = gabor_cpp_clamp(state.fetch, 1.0e3f, 1.0e6f);
    ocean.water_depth = state.water_depth > 0.0f ? gabor_cpp_clamp(state.water_depth, 1.0f, 1.0e4f) : 0.0f;
    float height = gabor_cpp_clamp(state.swell_height, 0.0f, 30.0f), period = gabor_cpp_clamp(state.swell_period, 5.0f, 25.0f);
    int seconds = gabor_cpp_clamp(state.loop_seconds, 8, 4096);
    ocean.loop_seconds = state.loop_seconds > 0 ? int(1u << std::uint32_t(gabor_cpp_log2(float(seconds)) + 0.0002f)) : 0;
    ocean.tail = gabor_vec2(0.00316f, 0.00192f) * ocean.wind + gabor_vec2(0.0f, 0.003f); // [CM54]
    ocean.high = gabor_vec2(0.0f);
    bool stands = ocean.loop_seconds > 0;
    float along;
    GaborImplJonswap sea = gabor_impl_wind_waves(ocean.wind, ocean.fetch, ocean.water_depth);
    int first = int(gabor_cpp_floor(4.0f * gabor_cpp_log2(0.6f * sea.peak / GABOR_IMPL_TICK)));
    GaborImplJonswap swell = GaborImplJonswap{1.0f / period, 1.0f, 2.0794415f, ocean.water_depth, 0.0f}; // ln 8
    // 0.07 of the wavelength, or 0.44 of the depth in shallow water: 0.14 pi over k^2, times k of deep water
    float k = gabor_impl_dispersion(swell.peak, ocean.water_depth).x;
    // 17.363515 is 0.56 pi^3
    height = gabor_cpp_min(height, 17.363515f / GABOR_IMPL_GRAVITY * swell.peak * swell.peak / (k * k));
    ocean.swell = gabor_vec3(height, period, state.swell_direction);
    float turn = gabor_impl_wave(0.15915494f * (state.swell_direction - ocean.direction)).x; // 1/(2 pi)
    // One loop, and one that copies: FXC unrolls loops that write to an array in a struct, and took 40 times as long.
    GaborOceanBand bands[GABOR_OCEAN_BANDS + 2];
    for (int i = 0; i < GABOR_OCEAN_BANDS + 2; ++i) {
        bool remote = i >= GABOR_OCEAN_BANDS, longer = i == GABOR_OCEAN_BANDS;
        // Bands are half an octave wide, and a quarter around the peak.
        int q = first + 2 * i - (i < 2 ? 0 : i == 2 ? 1 : 2), exponent = 34 - ((q - (first & 1)) >> 1);
        float low = gabor_impl_quarter_octave(q), high = gabor_impl_quarter_octave(q + (i == 1 || i == 2 ? 1 : 2));
        float reach = 1024.0f * (high / low - 1.0f);
        int halvings = gabor_cpp_clamp(i - 4, 0, 2); // short waves go in all directions, so that their crests are short
        gabor_vec2 beside = gabor_vec2(i == 1 || i == 3 ? 0.65f : i == 2 ? 1.19f : 0.7f, i == 1 ? 0.84f : i == 2 ? 1.54f : 1.41f);
        if (remote) { // from 0.73 to 1.03 and on to 2.06 times the peak
            low = 64.0f * gabor_cpp_floor((longer ? 0.0114f : 0.0161f) * swell.peak / GABOR_IMPL_TICK + 0.5f);
            reach = longer ? 424.0f : 1024.0f;
            exponent = int(gabor_cpp_floor(gabor_cpp_log2((longer ? 9.0f : 4.5f) * period * period)));
            halvings = 0;
            beside = longer ? gabor_vec2(1.0f, 1.2f) : gabor_vec2(0.8f, 1.0f);
        }
        GaborImplJonswap waves = sea;
        if (remote) waves = swell;
        GaborOceanBand band = gabor_impl_band(low, reach, exponent, halvings, remote ? ocean.swell.z : ocean.direction,
                                              beside, waves, remote, stands, along);
        if (low > 262144.0f) { // below 0.1 m, waves are capillary
            band.amplitude = 0.0f;
            band.slopes = gabor_vec2(0.0f);
        }
        float power = band.amplitude * band.amplitude;
        if (remote) {
            power = (longer ? 0.0333f : 0.0292f) * height * height; // in all 1/16
            band.slopes *= power / (band.amplitude * band.amplitude);
            band.amplitude = gabor_cpp_sqrt(power);
            along = 1.0f - along + (2.0f * along - 1.0f) * turn * turn;
        } else {
            ocean.tail -= band.slopes;
        }
        ocean.high += power * gabor_vec2(1.0f, band.orbit * band.orbit * along);
        bands[i] = band;
    }
    for (int j = 0; j < GABOR_OCEAN_BANDS + 2; ++j) ocean.band[j] = bands[j];
    ocean.tail = gabor_cpp_max(ocean.tail, 0.0f);
    ocean.high = gabor_cpp_sqrt(ocean.high);
    return ocean;
}

GABOR_INLINE GaborOcean gabor_ocean(float wind) {
    GaborSea sea = gabor_sea();
    sea.wind = wind;
    return gabor_ocean_of(sea);
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
    gabor_vec2 window_x; // along each axis, of west and east times the band's amplitude, and of south and north
    gabor_vec2 window_y;
    gabor_vec2 rate; // the derivatives of window_x and window_y are rate (-y, x) of them
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
    std::uint32_t west = gabor_impl_line_word(node.x, salt), east = gabor_impl_line_word(node.x + 1, salt);
    std::uint32_t south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS);
    std::uint32_t north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    return GaborImplOceanNodes{gabor_uvec4(south * west, south * east, north * west, north * east),
                               spacing * (offset.x - gabor_vec4(0.0f, 1.0f, 0.0f, 1.0f)),
                               spacing * (offset.y - gabor_vec4(0.0f, 0.0f, 1.0f, 1.0f)),
                               band.amplitude * gabor_impl_half_turn(turns.x), gabor_impl_half_turn(turns.y), slope};
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    gabor_vec4 turning; // F - k.V, in quanta of frequency
    gabor_vec4 k;       // wave number, 2 pi over the wavelength in metres
    gabor_vec4 fast;    // 2 pi F, in radians per second
    gabor_vec4 heading_x;
    gabor_vec4 heading_y;
};

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` k.V by `low`, times 2^21 /
// 861. `turning` is F - k.V. In a loop, the lattice stands.
GABOR_INLINE GaborImplOceanWaves gabor_impl_ocean_waves(GaborOceanBand band, gabor_uvec4 word, gabor_vec2 heading, float quantum, float scale,
                                           float half_step) {
    gabor_uvec4 bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    // 10, 11 and 11 bits
    gabor_vec4 share = gabor_vec4(bits >> 22u), u = gabor_vec4(gabor_ivec4(bits << 10u) >> 21), w = gabor_vec4(gabor_ivec4(bits << 21u) >> 21);
    gabor_vec4 rise = gabor_cpp_trunc(1024.0f + band.rise * share + band.faster.x * gabor_cpp_max(share - band.knots.x, 0.0f)
                      + band.faster.y * gabor_cpp_max(share - band.knots.y, 0.0f) + band.faster.z * gabor_cpp_max(share - band.knots.z, 0.0f)
                      + band.faster.w * gabor_cpp_max(share - band.knots.w, 0.0f) + band.last.y * gabor_cpp_max(share - band.last.x, 0.0f));
    gabor_vec4 bent = gabor_cpp_trunc(band.spread.x + band.spread.y * gabor_cpp_trunc(0.001953125f * u * u)); // 2^-9
    gabor_vec4 angle = gabor_cpp_trunc(2.44140625e-4f * (u * bent + w * band.blunt)) * (band.widen.x + band.widen.y * rise); // 2^-12
    gabor_vec4 part = gabor_cpp_trunc(1.220703125e-4f * angle), lag = gabor_cpp_trunc(4.8828125e-4f * part * part); // 2^-13, 2^-11
    gabor_vec4 steep = gabor_cpp_trunc(9.765625e-4f * rise * gabor_cpp_trunc(band.carry.x + band.carry.y * rise)); // 2^-10
    gabor_vec4 carried = steep - gabor_cpp_trunc(9.765625e-4f * steep * lag), ticks = quantum * gabor_cpp_trunc(scale * rise + half_step);
    // 6.7265625 is 861/128, and 9.5873799e-5 is 2 pi / 65536
    gabor_vec4 turning = ticks - gabor_cpp_trunc((quantum > 1.0f ? 0.0f : band.low / 16384.0f) * gabor_cpp_trunc(6.7265625f * carried));
    gabor_vec4 k = ticks * (band.number.x + band.number.y * ticks);
    gabor_vec4 chord = 1.1920929e-7f * angle, cosine = 1.0f - 0.5f * chord * chord; // 2^-23
    gabor_vec4 sine = chord * gabor_cpp_sqrt(1.0f - 0.25f * chord * chord);
    return GaborImplOceanWaves{turning, k, 9.5873799e-5f * ticks, heading.x * cosine - heading.y * sine,
                               heading.y * cosine + heading.x * sine};
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
GABOR_INLINE void gabor_impl_add_band(GaborWater& sum, gabor_vec3& squeeze, GaborOceanBand band, bool normal, gabor_vec2 heading,
                         gabor_vec2 quantum, float least, gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx,
                         gabor_vec2 dy, std::uint32_t seed) {
    float scale = 9.765625e-4f * band.low * quantum.y, half_step = gabor_cpp_max(0.5f, 1.0f - 1024.0f * scale); // 2^-10
    float lowest = quantum.x * gabor_cpp_floor(1024.0f * scale + half_step);
    float longest = 0.15915494f * lowest * (band.number.x + band.number.y * lowest); // 1/(2 pi) of the least k
    if (band.amplitude == 0.0f || longest * longest * least > 1.6f) { // each wave would be below 1 / 2700 of its height
        sum.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    GaborImplOceanNodes nodes = gabor_impl_ocean_nodes(band, cell, local, second, fraction, gabor_impl_salt(seed));
    GaborImplOceanWaves waves = gabor_impl_ocean_waves(band, nodes.word, heading, quantum.x, scale, half_step);
    gabor_vec4 k = waves.k, x = waves.heading_x, y = waves.heading_y;
    gabor_uvec4 ticks = (gabor_uvec4(gabor_ivec4(waves.turning)) * std::uint32_t(second) + (nodes.word >> 16u)) & 0xffffu;
    // 0.15915494 is 1/(2 pi) and 1.52587890625e-5 is 2^-16
    gabor_vec4 phase = 0.15915494f * k * (x * nodes.from_x + y * nodes.from_y)
               - 1.52587890625e-5f * (gabor_vec4(ticks) + waves.turning * fraction);
    gabor_vec2 a = gabor_impl_wave(phase.x), b = gabor_impl_wave(phase.y);
    gabor_vec2 c = gabor_impl_wave(phase.z), d = gabor_impl_wave(phase.w);
    gabor_vec4 steps_x = k * (x * dx.x + y * dx.y), steps_y = k * (x * dy.x + y * dy.y);
    gabor_vec4 kept = gabor_cpp_exp(-0.125f * (steps_x * steps_x + steps_y * steps_y));
    // The amplitude's square is uniform or, for a normal distribution, exponential.
    gabor_vec4 square = 1.52587890625e-5f * gabor_vec4(nodes.word & 0xffffu);
    gabor_vec4 amplitude = kept * gabor_cpp_sqrt(normal ? -2.0f * gabor_cpp_log(1.0f - square) : 4.0f * square);
    gabor_vec4 height = amplitude * gabor_vec4(a.y, b.y, c.y, d.y), along = amplitude * gabor_vec4(a.x, b.x, c.x, d.x);
    float spacing = gabor_cpp_exp2(float(band.exponent));
    gabor_vec2 south_north = nodes.window_y, rows = nodes.window_x.x * height.xz() + nodes.window_x.y * height.yw();
    gabor_vec2 rows_x = nodes.window_x.x * height.yw() - nodes.window_x.y * height.xz();
    gabor_vec2 change = nodes.rate * gabor_vec2(gabor_cpp_dot(rows_x, south_north), south_north.x * rows.y - south_north.y * rows.x);
    gabor_vec4 window_x = gabor_vec4(nodes.window_x, nodes.window_x), window_y = gabor_vec4(south_north.xx(), south_north.yy());
    gabor_vec4 window = window_x * window_y;
    gabor_vec2 drift = spacing / 32768.0f * gabor_vec2(band.drift), pass_ = drift * nodes.rate;
    gabor_vec4 passing = pass_.x * gabor_vec4(-window_x.y, window_x.x, -window_x.y, window_x.x) * window_y
                 + pass_.y * gabor_vec4(-window_y.zw(), window_y.xy()) * window_x;
    sum.height += gabor_cpp_dot(rows, south_north);
    sum.slope += change;
    height *= window;
    gabor_vec4 moving = waves.fast * height - passing * along;
    along *= window;
    sum.velocity += gabor_vec3(band.orbit * gabor_vec2(gabor_cpp_dot(moving, x), gabor_cpp_dot(moving, y)),
                         -gabor_cpp_dot(drift, change) - gabor_cpp_dot(waves.fast, along));
    gabor_vec4 steepness = k * along, squeezed = k * height, squeezed_x = squeezed * x;
    gabor_vec4 lost = window * window * (k * k + 5.482f / (spacing * spacing)) * (1.0f - kept * kept);
    sum.slope += gabor_vec2(gabor_cpp_dot(steepness, x), gabor_cpp_dot(steepness, y));
    sum.shift += band.orbit * gabor_vec2(gabor_cpp_dot(along, x), gabor_cpp_dot(along, y));
    squeeze += band.orbit * gabor_vec3(gabor_cpp_dot(squeezed_x, x), gabor_cpp_dot(squeezed_x, y), gabor_cpp_dot(squeezed, gabor_vec4(1.0f)));
    sum.lost += gabor_vec3(gabor_cpp_dot(lost, x * x), gabor_cpp_dot(lost, x * y), gabor_cpp_dot(lost, gabor_vec4(1.0f)));
}

GABOR_INLINE GaborWater gabor_water_at(gabor_ivec2 cell, gabor_vec2 local, int second, float fraction, gabor_vec2 dx, gabor_vec2 dy, GaborOcean ocean,
                          std::uint32_t seed) {
    // 0.15915494 is 1/(2 pi)
    gabor_vec2 wind = gabor_impl_wave(0.15915494f * ocean.direction), swell = gabor_impl_wave(0.15915494f * ocean.swell.z);
    GaborWater water = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_impl_slopes_along(ocean.tail, wind), gabor_vec3(0.0f)};
    gabor_vec3 squeeze = gabor_vec3(0.0f);
    // 1.52587890625e-5 is 2^-16
    gabor_vec2 quantum = ocean.loop_seconds > 0
        ? gabor_vec2(float(65536 / gabor_cpp_max(ocean.loop_seconds, 1)), 1.52587890625e-5f * float(ocean.loop_seconds))
                                  : gabor_vec2(1.0f);
    float area = dx.x * dy.y - dx.y * dy.x, sides = gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy); // the pixel is an ellipse
    float least = 2.0f * area * area / gabor_cpp_max(sides + gabor_cpp_sqrt(gabor_cpp_max(sides * sides - 4.0f * area * area, 0.0f)), 1.0e-30f);
    for (int i = 0; i < (ocean.swell.x > 0.0f ? GABOR_OCEAN_BANDS + 2 : GABOR_OCEAN_BANDS); ++i) {
        bool remote = i >= GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(water, squeeze, ocean.band[i], remote || i < 5, remote ? swell : wind, quantum,
                            least, cell, local, second, fraction, dx, dy,
                            gabor_derived_seed(seed, remote ? i - GABOR_OCEAN_BANDS + 12 : i));
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
    GaborWater water = GaborWater{0.0f, gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f, gabor_vec3(0.0f), gabor_vec3(0.0f)};
    for (int i = 0; i < 6; ++i) water = gabor_water(p - water.shift, seconds, ocean, seed);
    return water.height;
}

// ---- Foam ----------------------------------------------------------------------------------------------------------

// The share of a noise's amplitude that a pixel keeps. `density` is in kernel radii per metre, `wave` in turns. The
// variance along a side is a twelfth of its square.
GABOR_INLINE float gabor_impl_foam_kept(gabor_vec4 pixel, gabor_vec2 density, gabor_vec2 wave) {
    gabor_vec2 turns = wave.x * density.x * pixel.xz() + wave.y * density.y * pixel.yw();
    gabor_vec4 radii = pixel * gabor_vec4(density, density);
    return gabor_cpp_exp(-1.645f * gabor_cpp_dot(turns, turns) - 0.137f * gabor_cpp_dot(radii, radii)); // 2 pi^2 / 12, and of a window
}

GABOR_INLINE float gabor_foam(gabor_vec2 p, gabor_vec2 dx, gabor_vec2 dy, GaborWater water, GaborOcean ocean, std::uint32_t seed) {
    float covered = 3.84e-6f * gabor_cpp_pow(ocean.wind, 3.41f); // [MO80]
    covered = gabor_cpp_min(covered, ocean.wind < 6.0f ? 0.0015f : 0.3f);
    gabor_vec2 along = gabor_impl_wave(0.15915494f * ocean.direction); // 1/(2 pi)
    // Along the wind and across it, as all from here on
    gabor_vec4 pixel = gabor_vec4(gabor_cpp_dot(along, dx), along.x * dx.y - along.y * dx.x, gabor_cpp_dot(along, dy), along.x * dy.y - along.y * dy.x);
    gabor_vec2 sides = gabor_vec2(gabor_cpp_dot(pixel.xz(), pixel.xz()), gabor_cpp_dot(pixel.yw(), pixel.yw()));
    float kept = 1.0e-6f;
    for (int j = 0; j < GABOR_OCEAN_BANDS + 2; ++j) {
        float power = ocean.band[j].amplitude * ocean.band[j].amplitude;
        // Instead of exp(-3 (rest - 1)), because waves differ
        float rest = 1.0f + gabor_cpp_dot(ocean.band[j].slopes, sides) / gabor_cpp_max(12.0f * power, 1.0e-9f);
        kept += power / (rest * rest * rest);
    }
    kept /= ocean.high.x * ocean.high.x;
    // Half the square of the height of a crest that has passed here, in variances, and how long ago, in radians. Foam
    // is where a high one passed not long ago.
    gabor_vec2 crest = gabor_vec2(water.height, gabor_cpp_dot(along, water.shift)) / (gabor_cpp_sqrt(gabor_cpp_max(kept, 0.01f)) * ocean.high);
    float age = gabor_cpp_atan(crest.y, crest.x), energy = 0.5f * gabor_cpp_dot(crest, crest);
    energy /= 1.0f + 0.06f * (age < 0.0f ? age + 6.2831853f : age); // 2 pi
    // The energy above which that share of the sea is, with the noises' variance.
    float rare = -gabor_cpp_log(covered);
    float least = 0.7546f + (0.5536f + 0.01386f * rare) * rare + 0.9014f * gabor_cpp_log(rare); // fit: see tools/constants.py
    // Foam is torn along the wind, and a net of bubbles: the zeros of noises.
    gabor_vec2 place = gabor_cpp_clamp(0.6f / ocean.high.x, 0.3f, 6.0f) * gabor_vec2(gabor_cpp_dot(along, p), along.x * p.y - along.y * p.x);
    pixel *= gabor_cpp_clamp(0.6f / ocean.high.x, 0.3f, 6.0f);
    // 1.763 is the variance of all five in the fit. Each noise that the pixel shows takes its share from it.
    float value = energy - least, removed = 1.763f;
    for (int i = 0; i < 5; ++i) { // a single call, because compilers copy what it calls to each place
        gabor_vec2 density = i == 0 ? gabor_vec2(0.06f, 0.25f) : i == 1 ? gabor_vec2(0.4f, 1.1f) : i == 2 ? gabor_vec2(0.8f, 1.6f)
                     : i == 3 ? gabor_vec2(2.6f, 4.6f) : gabor_vec2(10.0f, 16.0f);
        float frequency = i == 0 ? 0.4f : i == 1 ? 0.6f : 0.0f, direction = i == 0 ? 1.3f : i == 1 ? 1.2f : 0.0f;
        gabor_vec2 wave = i == 0 ? gabor_vec2(0.107f, 0.3854f) : i == 1 ? gabor_vec2(0.2174f, 0.5592f) : gabor_vec2(0.0f);
        float weight = i == 0 ? 0.96f : i == 1 ? 0.72f : i == 2 ? 0.58f : i == 3 ? 0.44f : 0.33f;
        float noise = gabor_noise(density * place, frequency, direction, gabor_derived_seed(seed, i + 14));
        float share = gabor_impl_foam_kept(pixel, density, wave);
        weight *= i < 2 ? share : share * share; // zeros are thinner than waves
        // |n| of a normal n has the mean (2 / pi)^(1/2) and the variance 1 - 2 / pi.
        value += weight * (i < 2 ? noise : 0.7979f - gabor_cpp_abs(noise));
        removed -= weight * weight * (i < 2 ? 1.0f : 0.3634f);
    }
    float x = value * gabor_cpp_inversesqrt(removed);
    // Nearly the normal distribution: 1.5957691 is 2 (2/pi)^(1/2), and 0.044715 was chosen for the least error.
    float share = 1.0f / (1.0f + gabor_cpp_exp(-1.5957691f * x * (1.0f + 0.044715f * x * x)));
    return gabor_cpp_mix(covered, share, gabor_cpp_min(kept, 1.0f));
}

#endif
