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
//     white water                                      gabor_foam
//     a world of any size, or months of time           gabor_water_at
//     a swell, another fetch or depth, a loop          gabor_ocean_of
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

// Waves from one wavelength to half of it, or to 0.7 of it. Frequencies and directions are multiples of powers of 2, so
// that sums are exact. The structs are laid out alike in C++, std430 and std140.
struct GaborOceanBand {
    float amplitude; // rms height in metres
    int exponent;    // the spacing of nodes is 2^exponent metres
    float low;       // 65536 times the lowest frequency in Hz
    float orbit;     // how much longer than high the orbits of water are: 1 in deep water
    vec2 slopes;     // variance of the slopes along the band's direction and across it
    vec2 widen;      // spread, blunt: sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v
    vec2 spread;     // uniform in [-1, 1], times a linear function of the frequency
    float blunt;
    float rise;      // how fast the frequency rises from `low`
    vec4 knots;      // at these shares of power, of 1024, and at last.x,
    vec4 faster;     // it rises faster from there on, by these, and by last.y
    vec2 last;
    vec2 carry;      // the wave number over the frequency, times the group velocity: at 0 Hz, and how fast it rises
    vec2 number;     // the wave number over the frequency likewise
    ivec2 drift;     // 32768 times the group velocity in nodes per second
};

struct GaborOcean {
    float wind;
    float direction;
    float fetch;
    float water_depth;
    vec3 swell; // height, period and direction
    int loop_seconds;
    vec2 tail; // variance of the slopes of waves shorter than all bands, along the wind and across it
    vec2 high; // rms height, and rms displacement along the wind, in metres
    GaborOceanBand band[GABOR_OCEAN_BANDS + 2]; // the swell's longer and shorter waves are the last two
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
    vec2 slope;    // derivatives of the height by p
    vec2 shift;    // horizontal displacement in metres, towards crests, which it sharpens
    float jacobian; // of p + shift by p, within 0.2, or 0.3 for a fetch of 1 km: 1 at rest, lower where it folds
    vec3 lost;     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
    vec3 velocity; // of the water in metres per second: along x, along y, and up
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
#define GABOR_IMPL_TICK 1.52587890625e-5
#define GABOR_IMPL_GRAVITY 9.81

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
GaborImplJonswap gabor_impl_wind_waves(float wind, float fetch, float depth) {
    float gravity = GABOR_IMPL_GRAVITY, reach = min(gravity * fetch / (wind * wind), 2.15e4);
    float peak = 3.5 * gravity / wind * pow(reach, -0.33);
    float scale = 0.076 * pow(reach, -0.22) * gravity * gravity / 1558.5455; // (2 pi)^4
    float age = min(22.0 * pow(reach, -0.33), 2.0);                          // the wind over the peak's phase speed
    return GaborImplJonswap(peak, scale, 1.1939225, depth, -2.33 - 1.45 * (age - 1.17)); // ln 3.3
}

// Of waves of a frequency: the wave number, 2 pi over the wavelength in metres, and 2 depth / (sinh(2 depth)) for a
// depth in wave numbers, 0 in deep water.
vec2 gabor_impl_dispersion(float f, float depth) {
    float deep = 39.478418 / GABOR_IMPL_GRAVITY * f * f; // 4 pi^2
    if (depth <= 0.0) return vec2(deep, 0.0);
    // Newton's method for x tanh x = y, where x is the wave number times the depth
    float y = deep * depth, x = y * inversesqrt(1.0 - exp(-2.0 * y)), e = 0.0;
    for (int n = 0; n < 4; ++n) {
        e = exp(-2.0 * x);
        float slow = (1.0 - e) / (1.0 + e);
        x -= (x * slow - y) / (slow + x * (1.0 - slow * slow));
    }
    e = exp(-2.0 * x);
    return vec2(x / depth, 4.0 * x * e / (1.0 - e * e));
}

// The spectrum at a frequency in m^2 / Hz, in finite depth by [BGR85].
float gabor_impl_spectrum(float f, GaborImplJonswap sea) {
    float below = sea.peak * sea.peak / (f * f);
    float apart = (f / sea.peak - 1.0) / (f < sea.peak ? 0.07 : 0.09);
    float deep = sea.scale / (f * f * f * f * f)
               * exp(sea.sharp * exp(-0.5 * apart * apart) - 1.25 * below * below);
    vec2 waves = gabor_impl_dispersion(f, sea.depth);
    float slow = 39.478418 / GABOR_IMPL_GRAVITY * f * f / waves.x; // 4 pi^2
    return deep * slow * slow / (1.0 + waves.y);
}

// A band's frequencies, from `low` to 1 + reach / 1024 times that, are divided into 32 steps: their width in Hz, and
// the frequency of step j.
float gabor_impl_step_width(float low, float reach) {
    return GABOR_IMPL_TICK * low * reach / 32768.0; // 32 * 1024
}
float gabor_impl_step_frequency(int j, float low, float reach) {
    return GABOR_IMPL_TICK * low + (float(j) + 0.5) * gabor_impl_step_width(low, reach);
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less the band's middle.
struct GaborImplBandPower {
    float sum;
    float steep;    // the mean square of the wave number
    float variance; // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    vec4 fit;       // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
};

GaborImplBandPower gabor_impl_band_power(float low, float reach, GaborImplJonswap sea, bool remote) {
    GaborImplBandPower power = GaborImplBandPower(0.0, 0.0, 0.0, vec4(0.0));
    for (int j = 0; j < 32; ++j) {
        float f = gabor_impl_step_frequency(j, low, reach), x = (float(j) - 15.5) * reach / 32.0, above = f / sea.peak;
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        float s = remote ? 75.0 : above < 1.0 ? 6.97 * pow(above, 4.06) : 9.77 * pow(above, sea.young); // [HDE80]
        float here = 0.5 / (s + 1.0), k = gabor_impl_dispersion(f, sea.depth).x;
        float part = gabor_impl_step_width(low, reach) * gabor_impl_spectrum(f, sea);
        power.sum += part;
        power.steep += part * k * k;
        power.variance += part * here;
        power.fit += part * vec4(x, sqrt(here), x * x, x * sqrt(here));
    }
    power.steep /= power.sum;
    power.variance /= power.sum;
    power.fit /= power.sum;
    return power;
}

// Sets the directions of a band, and returns the mean of cos^2 d. sin(d / 2) is (a u + b u^3 + c v) times
// 1 + widen rise, where u and v are uniform in [-1, 1].
float gabor_impl_set_directions(inout GaborOceanBand band, float reach, GaborImplBandPower power) {
    float variance = power.variance, deviation = sqrt(variance), narrow = 0.5 / variance - 1.8;
    vec4 fit = power.fit;
    float c = 0.9 * deviation * clamp(narrow, 0.0, 1.0);
    float widen = clamp(0.3 * narrow, 0.0, 1.0) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
    widen = floor(clamp(16384.0 * widen, -32.0, 32.0) + 0.5) / 16384.0;
    float most = 1.0 / (1.0 + 0.5 * reach * abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
    // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
    float end = min(1.8 * deviation, most - c), rest = variance - c * c / 3.0;
    // 0.3047619 is 32/105, 0.0304762 is 16/525, 0.1142857 is 4/35 and 0.1523810 is 16/105
    float a = (sqrt(max(0.3047619 * rest - 0.0304762 * end * end, 0.0)) - 0.1142857 * end) / 0.1523810, b = end - a;
    // The mean of sin(d / 2)^4.
    // 0.57142857 is 4/7, 0.66666667 is 2/3, 0.36363636 is 4/11 and 0.076923077 is 1/13
    float fourth = a * a * a * (0.2 * a + 0.57142857 * b)
                 + b * b * (0.66666667 * a * a + 0.36363636 * a * b + 0.076923077 * b * b)
                 + c * c * (2.0 * rest + 0.2 * c * c);
    band.spread = floor(511.5 * vec2(a, b)) * vec2(8.0, 0.00390625); // 2^-8
    band.blunt = 8.0 * floor(511.5 * c);
    band.widen = floor(16384.0 * vec2(1.0 - (fit.x + 1024.0 + 0.5 * reach) * widen, widen));
    return 1.0 - 4.0 * variance + 4.0 * fourth;
}

// Of a step, the power before windows blur it by `blur` Hz, and how much the spectrum changes there. A band's low end
// is blurred more than the high end of the band before.
vec2 gabor_impl_step_sharp(int n, float low, float reach, float blur, vec2 edge, GaborImplJonswap sea) {
    float f = gabor_impl_step_frequency(n, low, reach);
    vec3 power = vec3(0.0); // here, before and after
    for (int i = 0; i < 3; ++i) { // a single call, because compilers copy what it calls to each place
        float here = gabor_impl_spectrum(i == 0 ? f : i == 1 ? f - blur : f + blur, sea);
        power = i == 0 ? vec3(here, 0.0, 0.0) : i == 1 ? vec3(power.x, here, 0.0) : vec3(power.xy, here);
    }
    float sharp = max(2.0 * power.x - 0.5 * (power.y + power.z), 0.2 * power.x);
    return vec2(sharp * (n < 4 ? edge.x : n < 28 ? 1.0 : edge.y), abs(power.z - power.y));
}

// Sets the frequencies of a band, by the inverse of their distribution. Between six knots, all have the same chance.
// Knots stand closer where the spectrum changes. At least 8 of 1024 shares of power are between two.
void gabor_impl_set_frequencies(inout GaborOceanBand band, float reach, float blur, vec2 beside,
                                GaborImplJonswap sea) {
    vec2 sum = vec2(0.0);
    float steps = 32.0 * gabor_impl_step_width(band.low, reach);
    vec2 edge = clamp(1.0 + 2.3 * blur / steps * (1.0 - beside), 0.3, 1.7);
    for (int j = 0; j < 32; ++j) sum += gabor_impl_step_sharp(j, band.low, reach, blur, edge, sea);
    // The shares of power below the knots, and how far the knots are from the lowest frequency.
    vec3 first = vec3(0.0), second = vec3(0.0), to_first = vec3(0.0), to_second = vec3(0.0);
    vec3 ahead = vec3(1.0, 2.0, 3.0) / 6.0;
    for (int n = 0; n < 32; ++n) {
        vec2 part = gabor_impl_step_sharp(n, band.low, reach, blur, edge, sea) / sum;
        float both = 0.5 * part.y + 0.015625; // 1/64
        vec3 early = clamp(ahead / both, 0.0, 1.0), late = clamp((ahead + 0.5) / both, 0.0, 1.0);
        first += 1024.0 * part.x * early;
        second += 1024.0 * part.x * late;
        to_first += 0.03125 * reach * early;
        to_second += 0.03125 * reach * late;
        ahead -= both;
    }
    first = clamp(floor(first + 0.5), vec3(8.0, 16.0, 24.0), vec3(984.0, 992.0, 1000.0));
    second = clamp(floor(second + 0.5), vec3(32.0, 40.0, 1024.0), vec3(1008.0, 1016.0, 1024.0));
    first.y = max(first.y, first.x + 8.0);
    first.z = max(first.z, first.y + 8.0);
    second.x = max(second.x, first.z + 8.0);
    second.y = max(second.y, second.x + 8.0);
    vec3 early = floor(256.0 * (to_first - vec3(0.0, to_first.xy)) / (first - vec3(0.0, first.xy)) + 0.5) / 256.0;
    vec3 late = (to_second - vec3(to_first.z, to_second.xy)) / (second - vec3(first.z, second.xy));
    late = floor(256.0 * late + 0.5) / 256.0;
    band.rise = early.x;
    band.knots = vec4(first, second.x);
    band.faster = vec4(early.yz, late.xy) - vec4(early, late.x);
    band.last = vec2(second.y, late.z - late.y);
}

// A band of frequencies from `low` to 1 + reach / 1024 times that, with nodes 2^(exponent - halvings) metres apart.
// `beside` is the blur of the bands below and above it, relative to this band's. `along` becomes the mean of cos^2 d.
GaborOceanBand gabor_impl_band(float low, float reach, int exponent, int halvings, float direction, vec2 beside,
                               GaborImplJonswap sea, bool remote, bool stands, out float along) {
    GaborImplBandPower power = gabor_impl_band_power(low, reach, sea, remote);
    // Each member has a value, which FXC demands of an inout argument.
    GaborOceanBand band = GaborOceanBand(0.0, exponent - halvings, low, 0.0, vec2(0.0), vec2(0.0), vec2(0.0), 0.0, 0.0,
                                         vec4(0.0), vec4(0.0), vec2(0.0), vec2(0.0), vec2(0.0), ivec2(0));
    along = gabor_impl_set_directions(band, reach, power);
    band.slopes = power.sum * power.steep * vec2(along, 1.0 - along);
    // The wave number over the frequency, nearly: exact at a quarter and three quarters of the band, and in deep water.
    float quarter = 0.25 * GABOR_IMPL_TICK * low * reach / 1024.0, first = GABOR_IMPL_TICK * low + quarter;
    vec2 lower = gabor_impl_dispersion(first, sea.depth) / first;
    vec2 upper = gabor_impl_dispersion(first + 2.0 * quarter, sea.depth) / (first + 2.0 * quarter);
    float deep = 39.478418 / GABOR_IMPL_GRAVITY; // 4 pi^2
    float rate = sea.depth > 0.0 ? (upper.x - lower.x) / (2.0 * quarter) : deep;
    float base = sea.depth > 0.0 ? lower.x - rate * first : 0.0;
    // The group velocity at the mean frequency is half the phase velocity times 1 + 2 depth / sinh(2 depth).
    float mean = GABOR_IMPL_TICK * low * (1.0 + (power.fit.x + 0.5 * reach) / 1024.0);
    vec2 waves = gabor_impl_dispersion(mean, sea.depth);
    float speed = 3.1415927 * mean / waves.x * (1.0 + waves.y), spacing = exp2(float(exponent)); // pi
    // Nodes that are nearer by 2^halvings move slower, so that as many pass in a second.
    float nearer = exp2(float(halvings));
    band.orbit = waves.x / (deep * mean * mean);
    // 2097152.0 is 2^21, and 0.15915494 is 1/(2 pi)
    float carry = 2097152.0 * 0.15915494 / 861.0 * speed / nearer;
    band.carry = floor(carry * vec2(1024.0 * base, rate * GABOR_IMPL_TICK * low) + 0.5) / 1024.0;
    vec2 drift = (stands ? 0.0 : 32768.0 * speed / spacing) * gabor_impl_wave(0.15915494 * direction);
    band.drift = ivec2(floor(drift + 0.5));
    // The share of slopes that windows add. Longer waves make up for half of it, as set_frequencies has sharpened the
    // spectrum; for what nearer nodes add, waves are both longer and lower.
    float added = 5.482 / (spacing * spacing * power.steep); // 64/45 (5/8 pi)^2: 64/45 is the integral of (1 - x^4)^2
    float more = added * (nearer * nearer - 1.0);
    band.amplitude = sqrt(power.sum / (1.0 + 0.3 * more));
    band.number = (1.0 - 0.27 * added - 0.35 * more) * GABOR_IMPL_TICK * vec2(base, GABOR_IMPL_TICK * rate);
    // The windows blur frequencies by 3.372^(1/2) / (2 pi) for each spacing that passes in a second.
    gabor_impl_set_frequencies(band, reach, 0.2923 * speed / spacing, beside, sea);
    return band;
}

// 2^(q/4), nearly, such that sums are exact.
float gabor_impl_quarter_octave(int q) {
    uint part = (q & 2) == 0 ? ((q & 1) == 0 ? 128u : 152u) : (q & 1) == 0 ? 181u : 215u;
    return float(part << uint(q >> 2)) / 128.0;
}

GaborSea gabor_sea() {
    return GaborSea(10.0, 2.0e5, 0.0, 12.0, 1.0471976, 0.0, 0.0, 0); // pi/3
}

GaborOcean gabor_ocean_of(GaborSea state) {
    GaborOcean ocean;
    ocean.wind = clamp(state.wind, 2.0, 30.0);
    ocean.direction = state.direction;
    ocean.fetch = clamp(state.fetch, 1.0e3, 1.0e6);
    ocean.water_depth = state.water_depth > 0.0 ? clamp(state.water_depth, 1.0, 1.0e4) : 0.0;
    float height = clamp(state.swell_height, 0.0, 30.0), period = clamp(state.swell_period, 5.0, 25.0);
    int seconds = clamp(state.loop_seconds, 8, 4096);
    ocean.loop_seconds = state.loop_seconds > 0 ? int(1u << uint(log2(float(seconds)) + 0.0002)) : 0;
    ocean.tail = vec2(0.00316, 0.00192) * ocean.wind + vec2(0.0, 0.003); // [CM54]
    ocean.high = vec2(0.0);
    bool stands = ocean.loop_seconds > 0;
    float along;
    GaborImplJonswap sea = gabor_impl_wind_waves(ocean.wind, ocean.fetch, ocean.water_depth);
    int first = int(floor(4.0 * log2(0.6 * sea.peak / GABOR_IMPL_TICK)));
    GaborImplJonswap swell = GaborImplJonswap(1.0 / period, 1.0, 2.0794415, ocean.water_depth, 0.0); // ln 8
    // 0.07 of the wavelength, or 0.44 of the depth in shallow water: 0.14 pi over k^2, times k of deep water
    float k = gabor_impl_dispersion(swell.peak, ocean.water_depth).x;
    // 17.363515 is 0.56 pi^3
    height = min(height, 17.363515 / GABOR_IMPL_GRAVITY * swell.peak * swell.peak / (k * k));
    ocean.swell = vec3(height, period, state.swell_direction);
    float turn = gabor_impl_wave(0.15915494 * (state.swell_direction - ocean.direction)).x; // 1/(2 pi)
    // One loop, and one that copies: FXC unrolls loops that write to an array in a struct, and took 40 times as long.
    GaborOceanBand bands[GABOR_OCEAN_BANDS + 2];
    for (int i = 0; i < GABOR_OCEAN_BANDS + 2; ++i) {
        bool remote = i >= GABOR_OCEAN_BANDS, longer = i == GABOR_OCEAN_BANDS;
        // Bands are half an octave wide, and a quarter around the peak.
        int q = first + 2 * i - (i < 2 ? 0 : i == 2 ? 1 : 2), exponent = 34 - ((q - (first & 1)) >> 1);
        float low = gabor_impl_quarter_octave(q), high = gabor_impl_quarter_octave(q + (i == 1 || i == 2 ? 1 : 2));
        float reach = 1024.0 * (high / low - 1.0);
        int halvings = clamp(i - 4, 0, 2); // short waves go in all directions, so that their crests are short
        vec2 beside = vec2(i == 1 || i == 3 ? 0.65 : i == 2 ? 1.19 : 0.7, i == 1 ? 0.84 : i == 2 ? 1.54 : 1.41);
        if (remote) { // from 0.73 to 1.03 and on to 2.06 times the peak
            low = 64.0 * floor((longer ? 0.0114 : 0.0161) * swell.peak / GABOR_IMPL_TICK + 0.5);
            reach = longer ? 424.0 : 1024.0;
            exponent = int(floor(log2((longer ? 9.0 : 4.5) * period * period)));
            halvings = 0;
            beside = longer ? vec2(1.0, 1.2) : vec2(0.8, 1.0);
        }
        GaborImplJonswap waves = sea;
        if (remote) waves = swell;
        GaborOceanBand band = gabor_impl_band(low, reach, exponent, halvings, remote ? ocean.swell.z : ocean.direction,
                                              beside, waves, remote, stands, along);
        if (low > 262144.0) { // below 0.1 m, waves are capillary
            band.amplitude = 0.0;
            band.slopes = vec2(0.0);
        }
        float power = band.amplitude * band.amplitude;
        if (remote) {
            power = (longer ? 0.0333 : 0.0292) * height * height; // in all 1/16
            band.slopes *= power / (band.amplitude * band.amplitude);
            band.amplitude = sqrt(power);
            along = 1.0 - along + (2.0 * along - 1.0) * turn * turn;
        } else {
            ocean.tail -= band.slopes;
        }
        ocean.high += power * vec2(1.0, band.orbit * band.orbit * along);
        bands[i] = band;
    }
    for (int j = 0; j < GABOR_OCEAN_BANDS + 2; ++j) ocean.band[j] = bands[j];
    ocean.tail = max(ocean.tail, 0.0);
    ocean.high = sqrt(ocean.high);
    return ocean;
}

GaborOcean gabor_ocean(float wind) {
    GaborSea sea = gabor_sea();
    sea.wind = wind;
    return gabor_ocean_of(sea);
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
    vec2 window_x; // along each axis, of west and east times the band's amplitude, and of south and north
    vec2 window_y;
    vec2 rate; // the derivatives of window_x and window_y are rate (-y, x) of them
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
    uint west = gabor_impl_line_word(node.x, salt), east = gabor_impl_line_word(node.x + 1, salt);
    uint south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS);
    uint north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    return GaborImplOceanNodes(uvec4(south * west, south * east, north * west, north * east),
                               spacing * (offset.x - vec4(0.0, 1.0, 0.0, 1.0)),
                               spacing * (offset.y - vec4(0.0, 0.0, 1.0, 1.0)),
                               band.amplitude * gabor_impl_half_turn(turns.x), gabor_impl_half_turn(turns.y), slope);
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    vec4 turning; // F - k.V, in quanta of frequency
    vec4 k;       // wave number, 2 pi over the wavelength in metres
    vec4 fast;    // 2 pi F, in radians per second
    vec4 heading_x;
    vec4 heading_y;
};

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` k.V by `low`, times 2^21 /
// 861. `turning` is F - k.V. In a loop, the lattice stands.
GaborImplOceanWaves gabor_impl_ocean_waves(GaborOceanBand band, uvec4 word, vec2 heading, float quantum, float scale,
                                           float half_step) {
    uvec4 bits = (word ^ (word >> 15u)) * 0xd35a2d97u;
    bits ^= bits >> 15u;
    // 10, 11 and 11 bits
    vec4 share = vec4(bits >> 22u), u = vec4(ivec4(bits << 10u) >> 21), w = vec4(ivec4(bits << 21u) >> 21);
    vec4 rise = trunc(1024.0 + band.rise * share + band.faster.x * max(share - band.knots.x, 0.0)
                      + band.faster.y * max(share - band.knots.y, 0.0) + band.faster.z * max(share - band.knots.z, 0.0)
                      + band.faster.w * max(share - band.knots.w, 0.0) + band.last.y * max(share - band.last.x, 0.0));
    vec4 bent = trunc(band.spread.x + band.spread.y * trunc(0.001953125 * u * u)); // 2^-9
    vec4 angle = trunc(2.44140625e-4 * (u * bent + w * band.blunt)) * (band.widen.x + band.widen.y * rise); // 2^-12
    vec4 part = trunc(1.220703125e-4 * angle), lag = trunc(4.8828125e-4 * part * part); // 2^-13, 2^-11
    vec4 steep = trunc(9.765625e-4 * rise * trunc(band.carry.x + band.carry.y * rise)); // 2^-10
    vec4 carried = steep - trunc(9.765625e-4 * steep * lag), ticks = quantum * trunc(scale * rise + half_step);
    // 6.7265625 is 861/128, and 9.5873799e-5 is 2 pi / 65536
    vec4 turning = ticks - trunc((quantum > 1.0 ? 0.0 : band.low / 16384.0) * trunc(6.7265625 * carried));
    vec4 k = ticks * (band.number.x + band.number.y * ticks);
    vec4 chord = 1.1920929e-7 * angle, cosine = 1.0 - 0.5 * chord * chord; // 2^-23
    vec4 sine = chord * sqrt(1.0 - 0.25 * chord * chord);
    return GaborImplOceanWaves(turning, k, 9.5873799e-5 * ticks, heading.x * cosine - heading.y * sine,
                               heading.y * cosine + heading.x * sine);
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
void gabor_impl_add_band(inout GaborWater sum, inout vec3 squeeze, GaborOceanBand band, bool normal, vec2 heading,
                         vec2 quantum, float least, ivec2 cell, vec2 local, int second, float fraction, vec2 dx,
                         vec2 dy, uint seed) {
    float scale = 9.765625e-4 * band.low * quantum.y, half_step = max(0.5, 1.0 - 1024.0 * scale); // 2^-10
    float lowest = quantum.x * floor(1024.0 * scale + half_step);
    float longest = 0.15915494 * lowest * (band.number.x + band.number.y * lowest); // 1/(2 pi) of the least k
    if (band.amplitude == 0.0 || longest * longest * least > 1.6) { // each wave would be below 1 / 2700 of its height
        sum.lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    GaborImplOceanNodes nodes = gabor_impl_ocean_nodes(band, cell, local, second, fraction, gabor_impl_salt(seed));
    GaborImplOceanWaves waves = gabor_impl_ocean_waves(band, nodes.word, heading, quantum.x, scale, half_step);
    vec4 k = waves.k, x = waves.heading_x, y = waves.heading_y;
    uvec4 ticks = (uvec4(ivec4(waves.turning)) * uint(second) + (nodes.word >> 16u)) & 0xffffu;
    // 0.15915494 is 1/(2 pi) and 1.52587890625e-5 is 2^-16
    vec4 phase = 0.15915494 * k * (x * nodes.from_x + y * nodes.from_y)
               - 1.52587890625e-5 * (vec4(ticks) + waves.turning * fraction);
    vec2 a = gabor_impl_wave(phase.x), b = gabor_impl_wave(phase.y);
    vec2 c = gabor_impl_wave(phase.z), d = gabor_impl_wave(phase.w);
    vec4 steps_x = k * (x * dx.x + y * dx.y), steps_y = k * (x * dy.x + y * dy.y);
    vec4 kept = exp(-0.125 * (steps_x * steps_x + steps_y * steps_y));
    // The amplitude's square is uniform or, for a normal distribution, exponential.
    vec4 square = 1.52587890625e-5 * vec4(nodes.word & 0xffffu);
    vec4 amplitude = kept * sqrt(normal ? -2.0 * log(1.0 - square) : 4.0 * square);
    vec4 height = amplitude * vec4(a.y, b.y, c.y, d.y), along = amplitude * vec4(a.x, b.x, c.x, d.x);
    float spacing = exp2(float(band.exponent));
    vec2 south_north = nodes.window_y, rows = nodes.window_x.x * height.xz + nodes.window_x.y * height.yw;
    vec2 rows_x = nodes.window_x.x * height.yw - nodes.window_x.y * height.xz;
    vec2 change = nodes.rate * vec2(dot(rows_x, south_north), south_north.x * rows.y - south_north.y * rows.x);
    vec4 window_x = vec4(nodes.window_x, nodes.window_x), window_y = vec4(south_north.xx, south_north.yy);
    vec4 window = window_x * window_y;
    vec2 drift = spacing / 32768.0 * vec2(band.drift), pass = drift * nodes.rate;
    vec4 passing = pass.x * vec4(-window_x.y, window_x.x, -window_x.y, window_x.x) * window_y
                 + pass.y * vec4(-window_y.zw, window_y.xy) * window_x;
    sum.height += dot(rows, south_north);
    sum.slope += change;
    height *= window;
    vec4 moving = waves.fast * height - passing * along;
    along *= window;
    sum.velocity += vec3(band.orbit * vec2(dot(moving, x), dot(moving, y)),
                         -dot(drift, change) - dot(waves.fast, along));
    vec4 steepness = k * along, squeezed = k * height, squeezed_x = squeezed * x;
    vec4 lost = window * window * (k * k + 5.482 / (spacing * spacing)) * (1.0 - kept * kept);
    sum.slope += vec2(dot(steepness, x), dot(steepness, y));
    sum.shift += band.orbit * vec2(dot(along, x), dot(along, y));
    squeeze += band.orbit * vec3(dot(squeezed_x, x), dot(squeezed_x, y), dot(squeezed, vec4(1.0)));
    sum.lost += vec3(dot(lost, x * x), dot(lost, x * y), dot(lost, vec4(1.0)));
}

GaborWater gabor_water_at(ivec2 cell, vec2 local, int second, float fraction, vec2 dx, vec2 dy, GaborOcean ocean,
                          uint seed) {
    // 0.15915494 is 1/(2 pi)
    vec2 wind = gabor_impl_wave(0.15915494 * ocean.direction), swell = gabor_impl_wave(0.15915494 * ocean.swell.z);
    GaborWater water = GaborWater(0.0, vec2(0.0), vec2(0.0), 0.0, gabor_impl_slopes_along(ocean.tail, wind), vec3(0.0));
    vec3 squeeze = vec3(0.0);
    // 1.52587890625e-5 is 2^-16
    vec2 quantum = ocean.loop_seconds > 0
        ? vec2(float(65536 / max(ocean.loop_seconds, 1)), 1.52587890625e-5 * float(ocean.loop_seconds))
                                  : vec2(1.0);
    float area = dx.x * dy.y - dx.y * dy.x, sides = dot(dx, dx) + dot(dy, dy); // the pixel is an ellipse
    float least = 2.0 * area * area / max(sides + sqrt(max(sides * sides - 4.0 * area * area, 0.0)), 1.0e-30);
    for (int i = 0; i < (ocean.swell.x > 0.0 ? GABOR_OCEAN_BANDS + 2 : GABOR_OCEAN_BANDS); ++i) {
        bool remote = i >= GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(water, squeeze, ocean.band[i], remote || i < 5, remote ? swell : wind, quantum,
                            least, cell, local, second, fraction, dx, dy,
                            gabor_derived_seed(seed, remote ? i - GABOR_OCEAN_BANDS + 12 : i));
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
    GaborWater water = GaborWater(0.0, vec2(0.0), vec2(0.0), 0.0, vec3(0.0), vec3(0.0));
    for (int i = 0; i < 6; ++i) water = gabor_water(p - water.shift, seconds, ocean, seed);
    return water.height;
}

// ---- Foam ----------------------------------------------------------------------------------------------------------

// The share of a noise's amplitude that a pixel keeps. `density` is in kernel radii per metre, `wave` in turns. The
// variance along a side is a twelfth of its square.
float gabor_impl_foam_kept(vec4 pixel, vec2 density, vec2 wave) {
    vec2 turns = wave.x * density.x * pixel.xz + wave.y * density.y * pixel.yw;
    vec4 radii = pixel * vec4(density, density);
    return exp(-1.645 * dot(turns, turns) - 0.137 * dot(radii, radii)); // 2 pi^2 / 12, and of a window
}

float gabor_foam(vec2 p, vec2 dx, vec2 dy, GaborWater water, GaborOcean ocean, uint seed) {
    float covered = 3.84e-6 * pow(ocean.wind, 3.41); // [MO80]
    covered = min(covered, ocean.wind < 6.0 ? 0.0015 : 0.3);
    vec2 along = gabor_impl_wave(0.15915494 * ocean.direction); // 1/(2 pi)
    // Along the wind and across it, as all from here on
    vec4 pixel = vec4(dot(along, dx), along.x * dx.y - along.y * dx.x, dot(along, dy), along.x * dy.y - along.y * dy.x);
    vec2 sides = vec2(dot(pixel.xz, pixel.xz), dot(pixel.yw, pixel.yw));
    float kept = 1.0e-6;
    for (int j = 0; j < GABOR_OCEAN_BANDS + 2; ++j) {
        float power = ocean.band[j].amplitude * ocean.band[j].amplitude;
        // Instead of exp(-3 (rest - 1)), because waves differ
        float rest = 1.0 + dot(ocean.band[j].slopes, sides) / max(12.0 * power, 1.0e-9);
        kept += power / (rest * rest * rest);
    }
    kept /= ocean.high.x * ocean.high.x;
    // Half the square of the height of a crest that has passed here, in variances, and how long ago, in radians. Foam
    // is where a high one passed not long ago.
    vec2 crest = vec2(water.height, dot(along, water.shift)) / (sqrt(max(kept, 0.01)) * ocean.high);
    float age = atan(crest.y, crest.x), energy = 0.5 * dot(crest, crest);
    energy /= 1.0 + 0.06 * (age < 0.0 ? age + 6.2831853 : age); // 2 pi
    // The energy above which that share of the sea is, with the noises' variance.
    float rare = -log(covered);
    float least = 0.7546 + (0.5536 + 0.01386 * rare) * rare + 0.9014 * log(rare); // fit: see tools/constants.py
    // Foam is torn along the wind, and a net of bubbles: the zeros of noises.
    vec2 place = clamp(0.6 / ocean.high.x, 0.3, 6.0) * vec2(dot(along, p), along.x * p.y - along.y * p.x);
    pixel *= clamp(0.6 / ocean.high.x, 0.3, 6.0);
    // 1.763 is the variance of all five in the fit. Each noise that the pixel shows takes its share from it.
    float value = energy - least, removed = 1.763;
    for (int i = 0; i < 5; ++i) { // a single call, because compilers copy what it calls to each place
        vec2 density = i == 0 ? vec2(0.06, 0.25) : i == 1 ? vec2(0.4, 1.1) : i == 2 ? vec2(0.8, 1.6)
                     : i == 3 ? vec2(2.6, 4.6) : vec2(10.0, 16.0);
        float frequency = i == 0 ? 0.4 : i == 1 ? 0.6 : 0.0, direction = i == 0 ? 1.3 : i == 1 ? 1.2 : 0.0;
        vec2 wave = i == 0 ? vec2(0.107, 0.3854) : i == 1 ? vec2(0.2174, 0.5592) : vec2(0.0);
        float weight = i == 0 ? 0.96 : i == 1 ? 0.72 : i == 2 ? 0.58 : i == 3 ? 0.44 : 0.33;
        float noise = gabor_noise(density * place, frequency, direction, gabor_derived_seed(seed, i + 14));
        float share = gabor_impl_foam_kept(pixel, density, wave);
        weight *= i < 2 ? share : share * share; // zeros are thinner than waves
        // |n| of a normal n has the mean (2 / pi)^(1/2) and the variance 1 - 2 / pi.
        value += weight * (i < 2 ? noise : 0.7979 - abs(noise));
        removed -= weight * weight * (i < 2 ? 1.0 : 0.3634);
    }
    float x = value * inversesqrt(removed);
    // Nearly the normal distribution: 1.5957691 is 2 (2/pi)^(1/2), and 0.044715 was chosen for the least error.
    float share = 1.0 / (1.0 + exp(-1.5957691 * x * (1.0 + 0.044715 * x * x)));
    return mix(covered, share, min(kept, 1.0));
}

#endif
