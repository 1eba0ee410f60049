// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl.
// Constants that you may edit: GABOR_OCEAN_BANDS.
//
// gabor_ocean.wgsl: a sea that never repeats, at any point and time, without textures or state, alike on CPU and GPU.
//
//     let sea = gabor_ocean(12.0);              // a wind of 12 m/s; once per draw, or as a uniform
//     let w = gabor_water(p, 60.5, sea, 7u);    // p in metres, after 60.5 seconds
//     let place = p + w.shift;                        // of the water, at the height w.height
//
//     I want                                           call
//     water under a pixel                              gabor_water_filtered
//     a boat's height                                  gabor_water_height
//     white water                                      gabor_foam
//     a world of any size, or months of time           gabor_water_at
//     a swell, another fetch or depth, a loop          gabor_ocean_of
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Octaves of wavelength, 1 to 12, from above the longest waves: 9 reach 0.8 m at 12 m/s.
const GABOR_OCEAN_BANDS: i32 = 9;
const_assert !(GABOR_OCEAN_BANDS < 1 || GABOR_OCEAN_BANDS > 12); // GABOR_OCEAN_BANDS must be 1 to 12

// Waves from one wavelength to half of it, or to 0.7 of it. Frequencies and directions are multiples of powers of 2, so
// that sums are exact. The structs are laid out alike in C++, std430 and std140.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    exponent: i32,  // the spacing of nodes is 2^exponent metres
    low: f32,       // 65536 times the lowest frequency in Hz
    orbit: f32,     // how much longer than high the orbits of water are: 1 in deep water
    slopes: vec2f,  // variance of the slopes along the band's direction and across it
    widen: vec2f,   // spread, blunt: sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v
    spread: vec2f,  // uniform in [-1, 1], times a linear function of the frequency
    blunt: f32,
    rise: f32,      // how fast the frequency rises from `low`
    knots: vec4f,   // at these shares of power, of 1024, and at last.x,
    faster: vec4f,  // it rises faster from there on, by these, and by last.y
    last: vec2f,
    carry: vec2f,   // the wave number over the frequency, times the group velocity: at 0 Hz, and how fast it rises
    number: vec2f,  // the wave number over the frequency likewise
    drift: vec2i,   // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32,
    direction: f32,
    fetch: f32,
    water_depth: f32,
    swell: vec3f,                                       // height, period and direction
    loop_seconds: i32,
    tail: vec2f,                                        // variance of the slopes of waves shorter than all bands, along the wind and across it
    high: vec2f,                                        // rms height, and rms displacement along the wind, in metres
    band: array<GaborOceanBand, GABOR_OCEAN_BANDS + 2>, // the swell's longer and shorter waves are the last two
}

// What a sea depends on.
struct GaborSea {
    wind: f32,            // wind speed at a height of 10 m, 2 to 30 metres per second
    fetch: f32,           // open water upwind, 200 km for a grown sea, 1000 to 1000000 metres: a few kilometres for a
                          // lake, and beyond 2190 wind^2, waves grow no more
    swell_height: f32,    // significant height of a far storm's swell, 0 for none, 0 to 30 metres, usually 0 to 8: up
                          // to 0.07 of its wavelength, 0.11 period^2 in deep water
    swell_period: f32,    // time from crest to crest of the swell, 5 to 25 seconds
    swell_direction: f32, // where the swell goes, from +x towards +y, -628.31853 to 628.31853 radians
    water_depth: f32,     // depth of the water, or 0 for deep water, 0 to 10000 metres, usually 0 to 100: at
                          // least 1 if not 0
    direction: f32,       // where the wind and its waves go: radians from +x towards +y
    loop_seconds: i32,    // all repeats after 8, 16, 32 ... 4096 seconds, or 0 for never
}
// fn gabor_sea() -> GaborSea
//     A wind of 10 m/s along x, a fetch of 200 km, no swell, deep water, no loop.
// fn gabor_ocean(wind: f32) -> GaborOcean
// fn gabor_ocean_of(state: GaborSea) -> GaborOcean
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
    height: f32,     // metres, of mean 0 and normally distributed
    slope: vec2f,    // derivatives of the height by p
    shift: vec2f,    // horizontal displacement in metres, towards crests, which it sharpens
    jacobian: f32,   // of p + shift by p, within 0.2, or 0.3 for a fetch of 1 km: 1 at rest, lower where it folds
    lost: vec3f,     // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
    velocity: vec3f, // of the water in metres per second: along x, along y, and up
}
// fn gabor_water(p: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// fn gabor_water_filtered(p: vec2f, dx: vec2f, dy: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater
//     The same without waves that are too fine for a pixel (dx and dy are dpdx(p), dpdy(p)), whose slopes are in
//     `lost`, as are those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk
//     measured [CM54], if the sea has neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone
//     have up to 1.8 times that.
// fn gabor_water_height(p: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> f32
//     The height of the water above the fixed point p, where a boat floats: six evaluations. CPU and GPU agree.
// fn gabor_foam(p: vec2f, dx: vec2f, dy: vec2f, water: GaborWater, ocean: GaborOcean, seed: u32) -> f32
//     The share of white water, 0 to 1, in a pixel whose water is gabor_water_filtered(p, dx, dy, ...): behind high
//     crests, for some seconds. At any fetch, as much of the sea is white as Monahan and O'Muircheartaigh measured at
//     its wind [MO80], at most 0.3, and at most 0.0015 below 6 m/s. dx and dy of vec2f(0.0) are for a point.
// fn gabor_water_at(cell: vec2i, local: vec2f, second: i32, fraction: f32, dx: vec2f, dy: vec2f, GaborOcean ocean, -> GaborWater
//                            u32 seed)
//     At the position cell + local in metres, after second + fraction: exact for years and anywhere. dx and dy of
//     vec2f(0.0) do not filter.

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
const GABOR_IMPL_TICK: f32 = 1.52587890625e-5;
const GABOR_IMPL_GRAVITY: f32 = 9.81;

// A JONSWAP spectrum: the frequency of its peak, its scale, and the logarithm of how much its peak is raised. `depth`
// is 0 for deep water, and `young` the power of frequencies over the peak's with which directions widen.
struct GaborImplJonswap {
    peak: f32,
    scale: f32,
    sharp: f32,
    depth: f32,
    young: f32,
}

// The spectrum of waves that a wind raises over a fetch.
fn gabor_impl_wind_waves(wind: f32, fetch: f32, depth: f32) -> GaborImplJonswap {
    let gravity = GABOR_IMPL_GRAVITY; let reach = min(gravity * fetch / (wind * wind), 2.15e4);
    let peak = 3.5 * gravity / wind * pow(reach, -0.33);
    let scale = 0.076 * pow(reach, -0.22) * gravity * gravity / 1558.5455; // (2 pi)^4
    let age = min(22.0 * pow(reach, -0.33), 2.0);                          // the wind over the peak's phase speed
    return GaborImplJonswap(peak, scale, 1.1939225, depth, -2.33 - 1.45 * (age - 1.17)); // ln 3.3
}

// Of waves of a frequency: the wave number, 2 pi over the wavelength in metres, and 2 depth / (sinh(2 depth)) for a
// depth in wave numbers, 0 in deep water.
fn gabor_impl_dispersion(f: f32, depth: f32) -> vec2f {
    let deep = 39.478418 / GABOR_IMPL_GRAVITY * f * f; // 4 pi^2
    if (depth <= 0.0) { return vec2f(deep, 0.0); }
    // Newton's method for x tanh x = y, where x is the wave number times the depth
    let y = deep * depth; var x = y * inverseSqrt(1.0 - exp(-2.0 * y)); var e = 0.0;
    for (var n = 0; n < 4; n++) {
        e = exp(-2.0 * x);
        let slow = (1.0 - e) / (1.0 + e);
        x -= (x * slow - y) / (slow + x * (1.0 - slow * slow));
    }
    e = exp(-2.0 * x);
    return vec2f(x / depth, 4.0 * x * e / (1.0 - e * e));
}

// The spectrum at a frequency in m^2 / Hz, in finite depth by [BGR85].
fn gabor_impl_spectrum(f: f32, sea: GaborImplJonswap) -> f32 {
    let below = sea.peak * sea.peak / (f * f);
    let apart = (f / sea.peak - 1.0) / select(0.09, 0.07, f < sea.peak);
    let deep = sea.scale / (f * f * f * f * f)
               * exp(sea.sharp * exp(-0.5 * apart * apart) - 1.25 * below * below);
    let waves = gabor_impl_dispersion(f, sea.depth);
    let slow = 39.478418 / GABOR_IMPL_GRAVITY * f * f / waves.x; // 4 pi^2
    return deep * slow * slow / (1.0 + waves.y);
}

// A band's frequencies, from `low` to 1 + reach / 1024 times that, are divided into 32 steps: their width in Hz, and
// the frequency of step j.
fn gabor_impl_step_width(low: f32, reach: f32) -> f32 {
    return GABOR_IMPL_TICK * low * reach / 32768.0; // 32 * 1024
}
fn gabor_impl_step_frequency(j: i32, low: f32, reach: f32) -> f32 {
    return GABOR_IMPL_TICK * low + (f32(j) + 0.5) * gabor_impl_step_width(low, reach);
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less the band's middle.
struct GaborImplBandPower {
    sum: f32,
    steep: f32,    // the mean square of the wave number
    variance: f32, // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    fit: vec4f,    // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
}

fn gabor_impl_band_power(low: f32, reach: f32, sea: GaborImplJonswap, remote: bool) -> GaborImplBandPower {
    var power = GaborImplBandPower(0.0, 0.0, 0.0, vec4f(0.0));
    for (var j = 0; j < 32; j++) {
        let f = gabor_impl_step_frequency(j, low, reach); let x = (f32(j) - 15.5) * reach / 32.0;
        let above = f / sea.peak;
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        let s = select(select(9.77 * pow(above, sea.young), 6.97 * pow(above, 4.06), above < 1.0), 75.0, remote); // [HDE80]
        let here = 0.5 / (s + 1.0); let k = gabor_impl_dispersion(f, sea.depth).x;
        let part = gabor_impl_step_width(low, reach) * gabor_impl_spectrum(f, sea);
        power.sum += part;
        power.steep += part * k * k;
        power.variance += part * here;
        power.fit += part * vec4f(x, sqrt(here), x * x, x * sqrt(here));
    }
    power.steep /= power.sum;
    power.variance /= power.sum;
    power.fit /= power.sum;
    return power;
}

// Sets the directions of a band, and returns the mean of cos^2 d. sin(d / 2) is (a u + b u^3 + c v) times
// 1 + widen rise, where u and v are uniform in [-1, 1].
fn gabor_impl_set_directions(band: ptr<function, GaborOceanBand>, reach: f32, power: GaborImplBandPower) -> f32 {
    let variance = power.variance; let deviation = sqrt(variance); let narrow = 0.5 / variance - 1.8;
    let fit = power.fit;
    let c = 0.9 * deviation * clamp(narrow, 0.0, 1.0);
    var widen = clamp(0.3 * narrow, 0.0, 1.0) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
    widen = floor(clamp(16384.0 * widen, -32.0, 32.0) + 0.5) / 16384.0;
    let most = 1.0 / (1.0 + 0.5 * reach * abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
    // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
    let end = min(1.8 * deviation, most - c); let rest = variance - c * c / 3.0;
    // 0.3047619 is 32/105, 0.0304762 is 16/525, 0.1142857 is 4/35 and 0.1523810 is 16/105
    let a = (sqrt(max(0.3047619 * rest - 0.0304762 * end * end, 0.0)) - 0.1142857 * end) / 0.1523810; let b = end - a;
    // The mean of sin(d / 2)^4.
    // 0.57142857 is 4/7, 0.66666667 is 2/3, 0.36363636 is 4/11 and 0.076923077 is 1/13
    let fourth = a * a * a * (0.2 * a + 0.57142857 * b)
                 + b * b * (0.66666667 * a * a + 0.36363636 * a * b + 0.076923077 * b * b)
                 + c * c * (2.0 * rest + 0.2 * c * c);
    (*band).spread = floor(511.5 * vec2f(a, b)) * vec2f(8.0, 0.00390625); // 2^-8
    (*band).blunt = 8.0 * floor(511.5 * c);
    (*band).widen = floor(16384.0 * vec2f(1.0 - (fit.x + 1024.0 + 0.5 * reach) * widen, widen));
    return 1.0 - 4.0 * variance + 4.0 * fourth;
}

// Of a step, the power before windows blur it by `blur` Hz, and how much the spectrum changes there. A band's low end
// is blurred more than the high end of the band before.
fn gabor_impl_step_sharp(n: i32, low: f32, reach: f32, blur: f32, edge: vec2f, sea: GaborImplJonswap) -> vec2f {
    let f = gabor_impl_step_frequency(n, low, reach);
    var power = vec3f(0.0); // here, before and after
    for (var i = 0; i < 3; i++) { // a single call, because compilers copy what it calls to each place
        let here = gabor_impl_spectrum(select(select(f + blur, f - blur, i == 1), f, i == 0), sea);
        power = select(select(vec3f(power.xy, here), vec3f(power.x, here, 0.0), i == 1), vec3f(here, 0.0, 0.0), i == 0);
    }
    let sharp = max(2.0 * power.x - 0.5 * (power.y + power.z), 0.2 * power.x);
    return vec2f(sharp * select(select(edge.y, 1.0, n < 28), edge.x, n < 4), abs(power.z - power.y));
}

// Sets the frequencies of a band, by the inverse of their distribution. Between six knots, all have the same chance.
// Knots stand closer where the spectrum changes. At least 8 of 1024 shares of power are between two.
fn gabor_impl_set_frequencies(band: ptr<function, GaborOceanBand>, reach: f32, blur: f32, beside: vec2f,
                              sea: GaborImplJonswap) {
    var sum = vec2f(0.0);
    let steps = 32.0 * gabor_impl_step_width((*band).low, reach);
    let edge = clamp(1.0 + 2.3 * blur / steps * (1.0 - beside), vec2f(0.3), vec2f(1.7));
    for (var j = 0; j < 32; j++) { sum += gabor_impl_step_sharp(j, (*band).low, reach, blur, edge, sea); }
    // The shares of power below the knots, and how far the knots are from the lowest frequency.
    var first = vec3f(0.0); var second = vec3f(0.0); var to_first = vec3f(0.0); var to_second = vec3f(0.0);
    var ahead = vec3f(1.0, 2.0, 3.0) / 6.0;
    for (var n = 0; n < 32; n++) {
        let part = gabor_impl_step_sharp(n, (*band).low, reach, blur, edge, sea) / sum;
        let both = 0.5 * part.y + 0.015625; // 1/64
        let early = clamp(ahead / both, vec3f(0.0), vec3f(1.0));
        let late = clamp((ahead + 0.5) / both, vec3f(0.0), vec3f(1.0));
        first += 1024.0 * part.x * early;
        second += 1024.0 * part.x * late;
        to_first += 0.03125 * reach * early;
        to_second += 0.03125 * reach * late;
        ahead -= both;
    }
    first = clamp(floor(first + 0.5), vec3f(8.0, 16.0, 24.0), vec3f(984.0, 992.0, 1000.0));
    second = clamp(floor(second + 0.5), vec3f(32.0, 40.0, 1024.0), vec3f(1008.0, 1016.0, 1024.0));
    first.y = max(first.y, first.x + 8.0);
    first.z = max(first.z, first.y + 8.0);
    second.x = max(second.x, first.z + 8.0);
    second.y = max(second.y, second.x + 8.0);
    let early = floor(256.0 * (to_first - vec3f(0.0, to_first.xy)) / (first - vec3f(0.0, first.xy)) + 0.5) / 256.0;
    var late = (to_second - vec3f(to_first.z, to_second.xy)) / (second - vec3f(first.z, second.xy));
    late = floor(256.0 * late + 0.5) / 256.0;
    (*band).rise = early.x;
    (*band).knots = vec4f(first, second.x);
    (*band).faster = vec4f(early.yz, late.xy) - vec4f(early, late.x);
    (*band).last = vec2f(second.y, late.z - late.y);
}

// A band of frequencies from `low` to 1 + reach / 1024 times that, with nodes 2^(exponent - halvings) metres apart.
// `beside` is the blur of the bands below and above it, relative to this band's. `along` becomes the mean of cos^2 d.
fn gabor_impl_band(low: f32, reach: f32, exponent: i32, halvings: i32, direction: f32, beside: vec2f,
                   sea: GaborImplJonswap, remote: bool, stands: bool, along: ptr<function, f32>) -> GaborOceanBand {
    let power = gabor_impl_band_power(low, reach, sea, remote);
    // Each member has a value, which FXC demands of an inout argument.
    var band = GaborOceanBand(0.0, exponent - halvings, low, 0.0, vec2f(0.0), vec2f(0.0), vec2f(0.0), 0.0, 0.0,
                              vec4f(0.0), vec4f(0.0), vec2f(0.0), vec2f(0.0), vec2f(0.0), vec2i(0));
    *along = gabor_impl_set_directions(&band, reach, power);
    band.slopes = power.sum * power.steep * vec2f((*along), 1.0 - (*along));
    // The wave number over the frequency, nearly: exact at a quarter and three quarters of the band, and in deep water.
    let quarter = 0.25 * GABOR_IMPL_TICK * low * reach / 1024.0; let first = GABOR_IMPL_TICK * low + quarter;
    let lower = gabor_impl_dispersion(first, sea.depth) / first;
    let upper = gabor_impl_dispersion(first + 2.0 * quarter, sea.depth) / (first + 2.0 * quarter);
    let deep = 39.478418 / GABOR_IMPL_GRAVITY; // 4 pi^2
    let rate = select(deep, (upper.x - lower.x) / (2.0 * quarter), sea.depth > 0.0);
    let base = select(0.0, lower.x - rate * first, sea.depth > 0.0);
    // The group velocity at the mean frequency is half the phase velocity times 1 + 2 depth / sinh(2 depth).
    let mean = GABOR_IMPL_TICK * low * (1.0 + (power.fit.x + 0.5 * reach) / 1024.0);
    let waves = gabor_impl_dispersion(mean, sea.depth);
    let speed = 3.1415927 * mean / waves.x * (1.0 + waves.y); let spacing = exp2(f32(exponent)); // pi
    // Nodes that are nearer by 2^halvings move slower, so that as many pass in a second.
    let nearer = exp2(f32(halvings));
    band.orbit = waves.x / (deep * mean * mean);
    // 2097152.0 is 2^21, and 0.15915494 is 1/(2 pi)
    let carry = 2097152.0 * 0.15915494 / 861.0 * speed / nearer;
    band.carry = floor(carry * vec2f(1024.0 * base, rate * GABOR_IMPL_TICK * low) + 0.5) / 1024.0;
    let drift = select(32768.0 * speed / spacing, 0.0, stands) * gabor_impl_wave(0.15915494 * direction);
    band.drift = vec2i(floor(drift + 0.5));
    // The share of slopes that windows add. Longer waves make up for half of it, as set_frequencies has sharpened the
    // spectrum; for what nearer nodes add, waves are both longer and lower.
    let added = 5.482 / (spacing * spacing * power.steep); // 64/45 (5/8 pi)^2: 64/45 is the integral of (1 - x^4)^2
    let more = added * (nearer * nearer - 1.0);
    band.amplitude = sqrt(power.sum / (1.0 + 0.3 * more));
    band.number = (1.0 - 0.27 * added - 0.35 * more) * GABOR_IMPL_TICK * vec2f(base, GABOR_IMPL_TICK * rate);
    // The windows blur frequencies by 3.372^(1/2) / (2 pi) for each spacing that passes in a second.
    gabor_impl_set_frequencies(&band, reach, 0.2923 * speed / spacing, beside, sea);
    return band;
}

// 2^(q/4), nearly, such that sums are exact.
fn gabor_impl_quarter_octave(q: i32) -> f32 {
    let part = select(select(215u, 181u, (q & 1) == 0), select(152u, 128u, (q & 1) == 0), (q & 2) == 0);
    return f32(part << u32(q >> 2)) / 128.0;
}

fn gabor_sea() -> GaborSea {
    return GaborSea(10.0, 2.0e5, 0.0, 12.0, 1.0471976, 0.0, 0.0, 0); // pi/3
}

fn gabor_ocean_of(state: GaborSea) -> GaborOcean {
    var ocean: GaborOcean;
    ocean.wind = clamp(state.wind, 2.0, 30.0);
    ocean.direction = state.direction;
    ocean.fetch = clamp(state.fetch, 1.0e3, 1.0e6);
    ocean.water_depth = select(0.0, clamp(state.water_depth, 1.0, 1.0e4), state.water_depth > 0.0);
    var height = clamp(state.swell_height, 0.0, 30.0); let period = clamp(state.swell_period, 5.0, 25.0);
    let seconds = clamp(state.loop_seconds, 8, 4096);
    ocean.loop_seconds = select(0, i32(1u << u32(log2(f32(seconds)) + 0.0002)), state.loop_seconds > 0);
    ocean.tail = vec2f(0.00316, 0.00192) * ocean.wind + vec2f(0.0, 0.003); // [CM54]
    ocean.high = vec2f(0.0);
    let stands = ocean.loop_seconds > 0;
    var along: f32;
    let sea = gabor_impl_wind_waves(ocean.wind, ocean.fetch, ocean.water_depth);
    let first = i32(floor(4.0 * log2(0.6 * sea.peak / GABOR_IMPL_TICK)));
    let swell = GaborImplJonswap(1.0 / period, 1.0, 2.0794415, ocean.water_depth, 0.0); // ln 8
    // 0.07 of the wavelength, or 0.44 of the depth in shallow water: 0.14 pi over k^2, times k of deep water
    let k = gabor_impl_dispersion(swell.peak, ocean.water_depth).x;
    // 17.363515 is 0.56 pi^3
    height = min(height, 17.363515 / GABOR_IMPL_GRAVITY * swell.peak * swell.peak / (k * k));
    ocean.swell = vec3f(height, period, state.swell_direction);
    let turn = gabor_impl_wave(0.15915494 * (state.swell_direction - ocean.direction)).x; // 1/(2 pi)
    // One loop, and one that copies: FXC unrolls loops that write to an array in a struct, and took 40 times as long.
    var bands: array<GaborOceanBand, GABOR_OCEAN_BANDS + 2>;
    for (var i = 0; i < GABOR_OCEAN_BANDS + 2; i++) {
        let remote = i >= GABOR_OCEAN_BANDS; let longer = i == GABOR_OCEAN_BANDS;
        // Bands are half an octave wide, and a quarter around the peak.
        let q = first + 2 * i - select(select(2, 1, i == 2), 0, i < 2); var exponent = 34 - ((q - (first & 1)) >> 1);
        var low = gabor_impl_quarter_octave(q);
        let high = gabor_impl_quarter_octave(q + select(2, 1, i == 1 || i == 2));
        var reach = 1024.0 * (high / low - 1.0);
        var halvings = clamp(i - 4, 0, 2); // short waves go in all directions, so that their crests are short
        var beside = vec2f(select(select(0.7, 1.19, i == 2), 0.65, i == 1 || i == 3), select(select(1.41, 1.54, i == 2), 0.84, i == 1));
        if (remote) { // from 0.73 to 1.03 and on to 2.06 times the peak
            low = 64.0 * floor(select(0.0161, 0.0114, longer) * swell.peak / GABOR_IMPL_TICK + 0.5);
            reach = select(1024.0, 424.0, longer);
            exponent = i32(floor(log2(select(4.5, 9.0, longer) * period * period)));
            halvings = 0;
            beside = select(vec2f(0.8, 1.0), vec2f(1.0, 1.2), longer);
        }
        var waves = sea;
        if (remote) { waves = swell; }
        var band = gabor_impl_band(low, reach, exponent, halvings, select(ocean.direction, ocean.swell.z, remote),
                                   beside, waves, remote, stands, &along);
        if (low > 262144.0) { // below 0.1 m, waves are capillary
            band.amplitude = 0.0;
            band.slopes = vec2f(0.0);
        }
        var power = band.amplitude * band.amplitude;
        if (remote) {
            power = select(0.0292, 0.0333, longer) * height * height; // in all 1/16
            band.slopes *= power / (band.amplitude * band.amplitude);
            band.amplitude = sqrt(power);
            along = 1.0 - along + (2.0 * along - 1.0) * turn * turn;
        } else {
            ocean.tail -= band.slopes;
        }
        ocean.high += power * vec2f(1.0, band.orbit * band.orbit * along);
        bands[i] = band;
    }
    for (var j = 0; j < GABOR_OCEAN_BANDS + 2; j++) { ocean.band[j] = bands[j]; }
    ocean.tail = max(ocean.tail, vec2f(0.0));
    ocean.high = sqrt(ocean.high);
    return ocean;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    var sea = gabor_sea();
    sea.wind = wind;
    return gabor_ocean_of(sea);
}

// ---- The water -----------------------------------------------------------------------------------------------------

// xx, xy and xx + yy of slopes with these variances along a unit vector and across it.
fn gabor_impl_slopes_along(variances: vec2f, along: vec2f) -> vec3f {
    return vec3f((variances.x - variances.y) * along.x * along + vec2f(variances.y, 0.0), variances.x + variances.y);
}

// The four nodes of a band around a point, together, which CPUs do faster: south west, south east, north west and
// north east.
struct GaborImplOceanNodes {
    word: vec4u,
    from_x: vec4f,   // offset of the point from the node, in metres
    from_y: vec4f,
    window_x: vec2f, // along each axis, of west and east times the band's amplitude, and of south and north
    window_y: vec2f,
    rate: vec2f,     // the derivatives of window_x and window_y are rate (-y, x) of them
}

fn gabor_impl_ocean_nodes(band: GaborOceanBand, cell: vec2i, local: vec2f, second: i32, fraction: f32, salt: u32) -> GaborImplOceanNodes {
    // The place on the lattice is 2^-exponent (cell + local) - drift (second + fraction), as a whole number and a rest,
    // exactly.
    let drifted = (second & 32767) * band.drift; // below 2^31, as drifts are below 65536
    let up = max(band.exponent, 0); let down = max(-band.exponent, 0);
    let spacing = exp2(f32(band.exponent));
    let rest = (vec2f(cell & vec2i(i32(1u << u32(up)) - 1)) + local) / spacing - vec2f(drifted & vec2i(32767)) / 32768.0
              - fraction / 32768.0 * vec2f(band.drift) + vec2f(f32(salt & 0xffffu), f32(salt >> 16u)) / 65536.0;
    let first = floor(rest); let offset = clamp(rest - first, vec2f(0.0), vec2f(1.0));
    let node = ((cell >> vec2u(u32(up))) << vec2u(u32(down))) - (second >> 15) * band.drift - (drifted >> vec2u(15)) + vec2i(first);
    // The windows along an axis are the cosine and sine of an angle, so that their squares sum to 1.
    let middle = 2.0 * offset - 1.0; let fourth = middle * middle * middle * middle;
    // 0.15625 is 5/32 and 1.9634954 is 5/8 pi
    let turns = 0.125 + middle * (0.15625 - 0.03125 * fourth); let slope = 1.9634954 / spacing * (1.0 - fourth);
    let west = gabor_impl_line_word(node.x, salt); let east = gabor_impl_line_word(node.x + 1, salt);
    let south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS);
    let north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    return GaborImplOceanNodes(vec4u(south * west, south * east, north * west, north * east),
                               spacing * (offset.x - vec4f(0.0, 1.0, 0.0, 1.0)),
                               spacing * (offset.y - vec4f(0.0, 0.0, 1.0, 1.0)),
                               band.amplitude * gabor_impl_half_turn(turns.x), gabor_impl_half_turn(turns.y), slope);
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    turning: vec4f, // F - k.V, in quanta of frequency
    k: vec4f,       // wave number, 2 pi over the wavelength in metres
    fast: vec4f,    // 2 pi F, in radians per second
    heading_x: vec4f,
    heading_y: vec4f,
}

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` k.V by `low`, times 2^21 /
// 861. `turning` is F - k.V. In a loop, the lattice stands.
fn gabor_impl_ocean_waves(band: GaborOceanBand, word: vec4u, heading: vec2f, quantum: f32, scale: f32, half_step: f32) -> GaborImplOceanWaves {
    var bits = (word ^ (word >> vec4u(15u))) * 0xd35a2d97u;
    bits ^= bits >> vec4u(15u);
    // 10, 11 and 11 bits
    let share = vec4f(bits >> vec4u(22u)); let u = vec4f(vec4i(bits << vec4u(10u)) >> vec4u(21));
    let w = vec4f(vec4i(bits << vec4u(21u)) >> vec4u(21));
    let rise = trunc(1024.0 + band.rise * share + band.faster.x * max(share - band.knots.x, vec4f(0.0))
                     + band.faster.y * max(share - band.knots.y, vec4f(0.0)) + band.faster.z * max(share - band.knots.z, vec4f(0.0))
                     + band.faster.w * max(share - band.knots.w, vec4f(0.0)) + band.last.y * max(share - band.last.x, vec4f(0.0)));
    let bent = trunc(band.spread.x + band.spread.y * trunc(0.001953125 * u * u)); // 2^-9
    let angle = trunc(2.44140625e-4 * (u * bent + w * band.blunt)) * (band.widen.x + band.widen.y * rise); // 2^-12
    let part = trunc(1.220703125e-4 * angle); let lag = trunc(4.8828125e-4 * part * part); // 2^-13, 2^-11
    let steep = trunc(9.765625e-4 * rise * trunc(band.carry.x + band.carry.y * rise)); // 2^-10
    let carried = steep - trunc(9.765625e-4 * steep * lag); let ticks = quantum * trunc(scale * rise + half_step);
    // 6.7265625 is 861/128, and 9.5873799e-5 is 2 pi / 65536
    let turning = ticks - trunc(select(band.low / 16384.0, 0.0, quantum > 1.0) * trunc(6.7265625 * carried));
    let k = ticks * (band.number.x + band.number.y * ticks);
    let chord = 1.1920929e-7 * angle; let cosine = 1.0 - 0.5 * chord * chord; // 2^-23
    let sine = chord * sqrt(1.0 - 0.25 * chord * chord);
    return GaborImplOceanWaves(turning, k, 9.5873799e-5 * ticks, heading.x * cosine - heading.y * sine,
                               heading.y * cosine + heading.x * sine);
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
fn gabor_impl_add_band(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3f>, band: GaborOceanBand,
                       normal: bool, heading: vec2f, quantum: vec2f, least: f32, cell: vec2i, local: vec2f,
                       second: i32, fraction: f32, dx: vec2f, dy: vec2f, seed: u32) {
    let scale = 9.765625e-4 * band.low * quantum.y; let half_step = max(0.5, 1.0 - 1024.0 * scale); // 2^-10
    let lowest = quantum.x * floor(1024.0 * scale + half_step);
    let longest = 0.15915494 * lowest * (band.number.x + band.number.y * lowest); // 1/(2 pi) of the least k
    if (band.amplitude == 0.0 || longest * longest * least > 1.6) { // each wave would be below 1 / 2700 of its height
        (*sum).lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    let nodes = gabor_impl_ocean_nodes(band, cell, local, second, fraction, gabor_impl_salt(seed));
    let waves = gabor_impl_ocean_waves(band, nodes.word, heading, quantum.x, scale, half_step);
    let k = waves.k; let x = waves.heading_x; let y = waves.heading_y;
    let ticks = (vec4u(vec4i(waves.turning)) * u32(second) + (nodes.word >> vec4u(16u))) & vec4u(0xffffu);
    // 0.15915494 is 1/(2 pi) and 1.52587890625e-5 is 2^-16
    let phase = 0.15915494 * k * (x * nodes.from_x + y * nodes.from_y)
               - 1.52587890625e-5 * (vec4f(ticks) + waves.turning * fraction);
    let a = gabor_impl_wave(phase.x); let b = gabor_impl_wave(phase.y);
    let c = gabor_impl_wave(phase.z); let d = gabor_impl_wave(phase.w);
    let steps_x = k * (x * dx.x + y * dx.y); let steps_y = k * (x * dy.x + y * dy.y);
    let kept = exp(-0.125 * (steps_x * steps_x + steps_y * steps_y));
    // The amplitude's square is uniform or, for a normal distribution, exponential.
    let square = 1.52587890625e-5 * vec4f(nodes.word & vec4u(0xffffu));
    let amplitude = kept * sqrt(select(4.0 * square, -2.0 * log(1.0 - square), normal));
    var height = amplitude * vec4f(a.y, b.y, c.y, d.y); var along = amplitude * vec4f(a.x, b.x, c.x, d.x);
    let spacing = exp2(f32(band.exponent));
    let south_north = nodes.window_y; let rows = nodes.window_x.x * height.xz + nodes.window_x.y * height.yw;
    let rows_x = nodes.window_x.x * height.yw - nodes.window_x.y * height.xz;
    let change = nodes.rate * vec2f(dot(rows_x, south_north), south_north.x * rows.y - south_north.y * rows.x);
    let window_x = vec4f(nodes.window_x, nodes.window_x); let window_y = vec4f(south_north.xx, south_north.yy);
    let window = window_x * window_y;
    let drift = spacing / 32768.0 * vec2f(band.drift); let pass_ = drift * nodes.rate;
    let passing = pass_.x * vec4f(-window_x.y, window_x.x, -window_x.y, window_x.x) * window_y
                 + pass_.y * vec4f(-window_y.zw, window_y.xy) * window_x;
    (*sum).height += dot(rows, south_north);
    (*sum).slope += change;
    height *= window;
    let moving = waves.fast * height - passing * along;
    along *= window;
    (*sum).velocity += vec3f(band.orbit * vec2f(dot(moving, x), dot(moving, y)),
                             -dot(drift, change) - dot(waves.fast, along));
    let steepness = k * along; let squeezed = k * height; let squeezed_x = squeezed * x;
    let lost = window * window * (k * k + 5.482 / (spacing * spacing)) * (1.0 - kept * kept);
    (*sum).slope += vec2f(dot(steepness, x), dot(steepness, y));
    (*sum).shift += band.orbit * vec2f(dot(along, x), dot(along, y));
    *squeeze += band.orbit * vec3f(dot(squeezed_x, x), dot(squeezed_x, y), dot(squeezed, vec4f(1.0)));
    (*sum).lost += vec3f(dot(lost, x * x), dot(lost, x * y), dot(lost, vec4f(1.0)));
}

fn gabor_water_at(cell: vec2i, local: vec2f, second: i32, fraction: f32, dx: vec2f, dy: vec2f, ocean_in: GaborOcean,
                  seed: u32) -> GaborWater {
    var ocean = ocean_in;
    // 0.15915494 is 1/(2 pi)
    let wind = gabor_impl_wave(0.15915494 * ocean.direction); let swell = gabor_impl_wave(0.15915494 * ocean.swell.z);
    var water = GaborWater(0.0, vec2f(0.0), vec2f(0.0), 0.0, gabor_impl_slopes_along(ocean.tail, wind), vec3f(0.0));
    var squeeze = vec3f(0.0);
    // 1.52587890625e-5 is 2^-16
    let quantum = select(vec2f(1.0),
                  vec2f(f32(65536 / max(ocean.loop_seconds, 1)), 1.52587890625e-5 * f32(ocean.loop_seconds)),
                  ocean.loop_seconds > 0);
    let area = dx.x * dy.y - dx.y * dy.x; let sides = dot(dx, dx) + dot(dy, dy); // the pixel is an ellipse
    let least = 2.0 * area * area / max(sides + sqrt(max(sides * sides - 4.0 * area * area, 0.0)), 1.0e-30);
    for (var i = 0; i < select(GABOR_OCEAN_BANDS, GABOR_OCEAN_BANDS + 2, ocean.swell.x > 0.0); i++) {
        let remote = i >= GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(&water, &squeeze, ocean.band[i], remote || i < 5, select(wind, swell, remote), quantum,
                            least, cell, local, second, fraction, dx, dy,
                            gabor_derived_seed(seed, select(i, i - GABOR_OCEAN_BANDS + 12, remote)));
    }
    water.jacobian = (1.0 - squeeze.x) * (1.0 - squeeze.z + squeeze.x) - squeeze.y * squeeze.y;
    water.lost = vec3f(water.lost.x, water.lost.z - water.lost.x, water.lost.y);
    return water;
}

fn gabor_water_filtered(p: vec2f, dx: vec2f, dy: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    let cell = floor(p);
    let second = floor(seconds);
    return gabor_water_at(vec2i(cell), p - cell, i32(second), seconds - second, dx, dy, ocean, seed);
}

fn gabor_water(p: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    return gabor_water_filtered(p, vec2f(0.0), vec2f(0.0), seconds, ocean, seed);
}

fn gabor_water_height(p: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> f32 {
    var water = GaborWater(0.0, vec2f(0.0), vec2f(0.0), 0.0, vec3f(0.0), vec3f(0.0));
    for (var i = 0; i < 6; i++) { water = gabor_water(p - water.shift, seconds, ocean, seed); }
    return water.height;
}

// ---- Foam ----------------------------------------------------------------------------------------------------------

// The share of a noise's amplitude that a pixel keeps. `density` is in kernel radii per metre, `wave` in turns. The
// variance along a side is a twelfth of its square.
fn gabor_impl_foam_kept(pixel: vec4f, density: vec2f, wave: vec2f) -> f32 {
    let turns = wave.x * density.x * pixel.xz + wave.y * density.y * pixel.yw;
    let radii = pixel * vec4f(density, density);
    return exp(-1.645 * dot(turns, turns) - 0.137 * dot(radii, radii)); // 2 pi^2 / 12, and of a window
}

fn gabor_foam(p: vec2f, dx: vec2f, dy: vec2f, water: GaborWater, ocean_in: GaborOcean, seed: u32) -> f32 {
    var ocean = ocean_in;
    var covered = 3.84e-6 * pow(ocean.wind, 3.41); // [MO80]
    covered = min(covered, select(0.3, 0.0015, ocean.wind < 6.0));
    let along = gabor_impl_wave(0.15915494 * ocean.direction); // 1/(2 pi)
    // Along the wind and across it, as all from here on
    var pixel = vec4f(dot(along, dx), along.x * dx.y - along.y * dx.x, dot(along, dy), along.x * dy.y - along.y * dy.x);
    let sides = vec2f(dot(pixel.xz, pixel.xz), dot(pixel.yw, pixel.yw));
    var kept = 1.0e-6;
    for (var j = 0; j < GABOR_OCEAN_BANDS + 2; j++) {
        let power = ocean.band[j].amplitude * ocean.band[j].amplitude;
        // Instead of exp(-3 (rest - 1)), because waves differ
        let rest = 1.0 + dot(ocean.band[j].slopes, sides) / max(12.0 * power, 1.0e-9);
        kept += power / (rest * rest * rest);
    }
    kept /= ocean.high.x * ocean.high.x;
    // Half the square of the height of a crest that has passed here, in variances, and how long ago, in radians. Foam
    // is where a high one passed not long ago.
    let crest = vec2f(water.height, dot(along, water.shift)) / (sqrt(max(kept, 0.01)) * ocean.high);
    let age = atan2(crest.y, crest.x); var energy = 0.5 * dot(crest, crest);
    energy /= 1.0 + 0.06 * select(age, age + 6.2831853, age < 0.0); // 2 pi
    // The energy above which that share of the sea is, with the noises' variance.
    let rare = -log(covered);
    let least = 0.7546 + (0.5536 + 0.01386 * rare) * rare + 0.9014 * log(rare); // fit: see tools/constants.py
    // Foam is torn along the wind, and a net of bubbles: the zeros of noises.
    let place = clamp(0.6 / ocean.high.x, 0.3, 6.0) * vec2f(dot(along, p), along.x * p.y - along.y * p.x);
    pixel *= clamp(0.6 / ocean.high.x, 0.3, 6.0);
    // 1.763 is the variance of all five in the fit. Each noise that the pixel shows takes its share from it.
    var value = energy - least; var removed = 1.763;
    for (var i = 0; i < 5; i++) { // a single call, because compilers copy what it calls to each place
        let density = select(select(select(select(vec2f(10.0, 16.0), vec2f(2.6, 4.6), i == 3),
                                                                            vec2f(0.8, 1.6), i == 2), vec2f(0.4, 1.1), i == 1), vec2f(0.06, 0.25), i == 0);
        let frequency = select(select(0.0, 0.6, i == 1), 0.4, i == 0);
        let direction = select(select(0.0, 1.2, i == 1), 1.3, i == 0);
        let wave = select(select(vec2f(0.0), vec2f(0.2174, 0.5592), i == 1), vec2f(0.107, 0.3854), i == 0);
        var weight = select(select(select(select(0.33, 0.44, i == 3), 0.58, i == 2), 0.72, i == 1), 0.96, i == 0);
        let noise = gabor_noise(density * place, frequency, direction, gabor_derived_seed(seed, i + 14));
        let share = gabor_impl_foam_kept(pixel, density, wave);
        weight *= select(share * share, share, i < 2); // zeros are thinner than waves
        // |n| of a normal n has the mean (2 / pi)^(1/2) and the variance 1 - 2 / pi.
        value += weight * select(0.7979 - abs(noise), noise, i < 2);
        removed -= weight * weight * select(0.3634, 1.0, i < 2);
    }
    let x = value * inverseSqrt(removed);
    // Nearly the normal distribution: 1.5957691 is 2 (2/pi)^(1/2), and 0.044715 was chosen for the least error.
    let share = 1.0 / (1.0 + exp(-1.5957691 * x * (1.0 + 0.044715 * x * x)));
    return mix(covered, share, min(kept, 1.0));
}
