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
//     a world of any size, or months of time           gabor_water_at
//     another direction or fetch, a swell, a loop      gabor_ocean_of
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Octaves of wavelength, 1 to 12, from above the longest waves: 9 reach 0.8 m at 12 m/s.
const GABOR_OCEAN_BANDS: i32 = 9;
const_assert !(GABOR_OCEAN_BANDS < 1 || GABOR_OCEAN_BANDS > 12); // GABOR_OCEAN_BANDS must be 1 to 12

// Waves from one wavelength to half of it. `low`, `early`, `late` and `spread` are multiples of powers of 2, so that
// sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2f,  // variance of the slopes along the band's direction and across it
    exponent: i32,  // the spacing of nodes is 2^exponent metres
    low: f32,       // 65536 times the lowest frequency in Hz
    early: vec3f,   // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next
    late: vec3f,    // 3/16, 4/16, 4/16, 3/16 and 1/16
    spread: vec3f,  // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in
    widen: vec2f,   // [-1, 1], times a linear function of the frequency
    drift: vec2i,   // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32,                                          // speed in metres per second, 10 m up
    direction: f32,                                     // where the waves go: radians from +x towards +y
    fetch: f32,                                         // metres of open water upwind, 10^3 to 10^6: beyond 2190 wind^2, waves grow no more
    swell: vec3f,                                       // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    loop_seconds: i32,                                  // all repeats after so many, or 0 for never
    tail: vec2f,                                        // variance of the slopes of waves shorter than all bands, along the wind and across it
    band: array<GaborOceanBand, GABOR_OCEAN_BANDS + 1>, // the swell is the last
}
// fn gabor_ocean(wind: f32) -> GaborOcean
// fn gabor_ocean_of(wind: f32, direction: f32, fetch: f32, swell: vec3f, loop_seconds: i32) -> GaborOcean
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the
//     JONSWAP spectrum [HBB73] until it is fully developed [PM64], and the directions of [HDE80]. A swell, from a
//     remote storm, has a narrow spread of directions and a sharp peak [G10]; vec3f(0.0) is none. For films, all repeats
//     after a loop of 8, 16, 32 ... 4096 seconds, to which other values are rounded down. Its price: groups of waves
//     stand still, and each wave's period becomes an integer fraction of it, so a loop should last several periods of
//     the swell. Compute a sea once, on the CPU if the CPU also asks for heights: the integers may round differently on
//     another device. To change a member, call this again.

// The water particle whose position at rest is p. It is now at p + shift.
struct GaborWater {
    height: f32,   // metres, of mean 0 and normally distributed
    slope: vec2f,  // derivatives of the height by p
    shift: vec2f,  // horizontal displacement in metres, towards crests, which it sharpens
    jacobian: f32, // of p + shift by p, within 0.1, or 0.2 for a fetch of 1 km: 1 at rest, lower where water folds,
                   // with foam below 0.7
    lost: vec3f,   // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
}
// fn gabor_water(p: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// fn gabor_water_filtered(p: vec2f, dx: vec2f, dy: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater
//     The same without waves that are too fine for a pixel (dx and dy are dpdx(p), dpdy(p)), whose slopes are in
//     `lost`, as are those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk
//     measured [CM54], if the sea has neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone
//     have up to 1.8 times that.
// fn gabor_water_height(p: vec2f, seconds: f32, ocean: GaborOcean, seed: u32) -> f32
//     The height of the water above the fixed point p, where a boat floats: six evaluations.
// fn gabor_water_at(cell: vec2i, local: vec2f, second: i32, fraction: f32, dx: vec2f, dy: vec2f, GaborOcean ocean, -> GaborWater
//                            u32 seed)
//     At the position cell + local in metres, after whole_seconds + fraction: exact for years and anywhere. dx and dy
//     of
//     vec2f(0.0) do not filter.

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
const GABOR_IMPL_TICK: f32 = 1.52587890625e-5;
const GABOR_IMPL_GRAVITY: f32 = 9.81;

// A JONSWAP spectrum: the frequency of its peak, its scale, and the logarithm of how much its peak is raised.
struct GaborImplJonswap {
    peak: f32,
    scale: f32,
    sharp: f32,
}

// The spectrum of waves that a wind raises over a fetch.
fn gabor_impl_wind_waves(wind: f32, fetch: f32) -> GaborImplJonswap {
    let gravity = GABOR_IMPL_GRAVITY; let reach = min(gravity * fetch / (wind * wind), 2.15e4);
    let peak = 3.5 * gravity / wind * pow(reach, -0.33);
    let scale = 0.076 * pow(reach, -0.22) * gravity * gravity / 1558.5455; // (2 pi)^4
    return GaborImplJonswap(peak, scale, 1.1939225);                         // ln 3.3
}

// The spectrum at a frequency in m^2 / Hz, and the same times f^4.
fn gabor_impl_spectrum(f: f32, sea: GaborImplJonswap) -> vec2f {
    let below = sea.peak * sea.peak / (f * f);
    let apart = (f / sea.peak - 1.0) / select(0.09, 0.07, f < sea.peak);
    return sea.scale / f * exp(sea.sharp * exp(-0.5 * apart * apart) - 1.25 * below * below)
         * vec2f(1.0 / (f * f * f * f), 1.0);
}

// The frequency of step j of the 16, `width` wide, that a band's frequencies from `low` up are divided into.
fn gabor_impl_step_frequency(j: i32, low: f32, width: f32) -> f32 {
    return GABOR_IMPL_TICK * (low + (f32(j) + 0.5) * width);
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less 1236 here.
struct GaborImplBandPower {
    sum: vec2f,    // the power, and the same times f^4
    variance: f32, // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    fit: vec4f,    // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
}

fn gabor_impl_band_power(low: f32, sea: GaborImplJonswap, remote: bool) -> GaborImplBandPower {
    var power = GaborImplBandPower(vec2f(0.0), 0.0, vec4f(0.0));
    let width = 0.025878906 * low; // 26.5/1024
    for (var j = 0; j < 16; j++) {
        // 198.75 is 7.5 * 26.5
        let f = gabor_impl_step_frequency(j, low, width); let x = 26.5 * f32(j) - 198.75; let above = f / sea.peak;
        // The spread is cos(d / 2)^(2 s). Then sin(d / 2) has the variance 1 / (2 s + 2).
        let s = select(9.77 * pow(above, select(-2.34, 4.06, above < 1.0)), 75.0, remote);
        let here = 0.5 / (s + 1.0);
        let part = GABOR_IMPL_TICK * width * gabor_impl_spectrum(f, sea);
        power.sum += part;
        power.variance += part.x * here;
        power.fit += part.x * vec4f(x, sqrt(here), x * x, x * sqrt(here));
    }
    power.variance /= power.sum.x;
    power.fit /= power.sum.x;
    return power;
}

// The directions of a band: its members `spread` and `widen`, and the mean of cos^2 d.
struct GaborImplBandSpread {
    spread: vec3f,
    widen: vec2f,
    along: f32,
}

// sin(d / 2) is (a u + b u^3 + c v) times 1 + widen rise, where u and v are uniform in [-1, 1].
fn gabor_impl_band_spread(power: GaborImplBandPower) -> GaborImplBandSpread {
    let variance = power.variance; let deviation = sqrt(variance); let narrow = 0.5 / variance - 1.8;
    let fit = power.fit;
    let c = 0.9 * deviation * clamp(narrow, 0.0, 1.0);
    var widen = clamp(0.3 * narrow, 0.0, 1.0) * (fit.w - fit.x * fit.y) / ((fit.z - fit.x * fit.x) * deviation);
    widen = floor(clamp(16384.0 * widen, -32.0, 32.0) + 0.5) / 16384.0;
    let most = 1.0 / (1.0 + 212.0 * abs(widen) - fit.x * widen); // keeps sin(d / 2) below 1
    // a solves a^2 / 3 + 2 a b / 5 + b^2 / 7 = rest, where a + b = end.
    let end = min(1.8 * deviation, most - c); let rest = variance - c * c / 3.0;
    // 0.3047619 is 32/105, 0.0304762 is 16/525, 0.1142857 is 4/35 and 0.1523810 is 16/105
    let a = (sqrt(max(0.3047619 * rest - 0.0304762 * end * end, 0.0)) - 0.1142857 * end) / 0.1523810; let b = end - a;
    // The mean of sin(d / 2)^4.
    // 0.57142857 is 4/7, 0.66666667 is 2/3, 0.36363636 is 4/11 and 0.076923077 is 1/13
    let fourth = a * a * a * (0.2 * a + 0.57142857 * b)
                 + b * b * (0.66666667 * a * a + 0.36363636 * a * b + 0.076923077 * b * b)
                 + c * c * (2.0 * rest + 0.2 * c * c);
    // 0.00390625 is 2^-8
    return GaborImplBandSpread(floor(511.5 * vec3f(a, b, c)) * vec3f(8.0, 0.00390625, 8.0),
                               floor(16384.0 * vec2f(1.0 - (fit.x + 1236.0) * widen, widen)),
                               1.0 - 4.0 * variance + 4.0 * fourth);
}

// The frequencies of a band whose power is `whole`: its members `early` and `late`, by the inverse of the distribution.
// The knots have 0.0621, 0.2483, 0.4965, 0.7448, 0.931 and all of the power below them, instead of 1/16, 4/16, 8/16 and
// so on: between them, frequencies are uniform, and thus too high. Lower knots keep the variance of the slopes.
fn gabor_impl_band_knots(low: f32, whole: f32, sea: GaborImplJonswap, early: ptr<function, vec3f>,
                         late: ptr<function, vec3f>) {
    var first = vec3f(0.0); var second = vec3f(0.0); var ahead = vec3f(0.0621, 0.2483, 0.4965);
    let width = 0.025878906 * low; // 26.5/1024
    for (var n = 0; n < 16; n++) {
        let f = gabor_impl_step_frequency(n, low, width);
        let part = GABOR_IMPL_TICK * width / whole * gabor_impl_spectrum(f, sea).x;
        first += 26.5 * clamp(ahead / max(part, 1.0e-9), vec3f(0.0), vec3f(1.0));
        second += 26.5 * clamp((ahead + vec3f(0.6827, 0.6827, 0.5035)) / max(part, 1.0e-9), vec3f(0.0), vec3f(1.0));
        ahead -= part;
    }
    *early = floor((first - vec3f(0.0, first.xy)) * vec3f(4.0, 1.3333333, 1.0) + 0.5) / 256.0; // 4/3
    *late = floor((second - vec3f(first.z, second.xy)) * vec3f(1.0, 1.3333333, 4.0) + 0.5) / 256.0;
    *late -= vec3f((*early).z, (*late).xy);
    *early -= vec3f(0.0, (*early).xy);
}

fn gabor_ocean_of(wind: f32, direction_in: f32, fetch: f32, swell: vec3f, loop_seconds: i32) -> GaborOcean {
    var direction = direction_in;
    var ocean: GaborOcean;
    ocean.wind = clamp(wind, 2.0, 30.0);
    ocean.direction = direction;
    ocean.fetch = clamp(fetch, 1.0e3, 1.0e6);
    ocean.swell = vec3f(clamp(swell.x, 0.0, 30.0), clamp(swell.y, 5.0, 25.0), swell.z);
    ocean.loop_seconds = select(0, i32(1u << u32(log2(f32(clamp(loop_seconds, 8, 4096))) + 0.0002)), loop_seconds > 0);
    ocean.tail = vec2f(0.00316, 0.00192) * ocean.wind + vec2f(0.0, 0.003); // [CM54]
    var sea = gabor_impl_wind_waves(ocean.wind, ocean.fetch);
    let octave = i32(floor(log2(0.62 * sea.peak / GABOR_IMPL_TICK)));
    for (var i = 0; i <= GABOR_OCEAN_BANDS; i++) {
        var low = f32(select(181u, 128u, (i & 1) == 0) << u32(octave + i / 2)) / 128.0;
        let remote = i == GABOR_OCEAN_BANDS;
        if (remote) { // the swell
            sea.peak = 1.0 / ocean.swell.y;
            sea.sharp = 2.0794415; // ln 8
            // 0.0132813 is 0.85/64
            low = 64.0 * floor(0.0132813 * sea.peak / GABOR_IMPL_TICK + 0.5); // 0.85 times the peak
            direction = ocean.swell.z;
        }
        let power = gabor_impl_band_power(low, sea, remote);
        let spread = gabor_impl_band_spread(power);
        var band: GaborOceanBand;
        let tall = select(select(power.sum.x,
                     0.0, low > 262144.0 /* below 0.1 m, waves are capillary */),
                   0.0625 * ocean.swell.x * ocean.swell.x, remote);
        band.amplitude = sqrt(tall);
        // (4 pi^2 / g)^2
        // 16.195056 was chosen near (4 pi^2 / g)^2, which is 16.195019
        band.slopes = 16.195056 * tall * power.sum.y / power.sum.x * vec2f(spread.along, 1.0 - spread.along);
        if (!remote) { ocean.tail -= band.slopes; }
        band.exponent = select(34 - 2 * octave - i + select(-1, 1, i > 0 && i < 4),
                        i32(floor(log2(18.0 / (sea.peak * sea.peak)))), remote);
        band.low = low;
        var early: vec3f; var late: vec3f;
        gabor_impl_band_knots(low, power.sum.x, sea, &early, &late);
        band.early = early;
        band.late = late;
        band.spread = spread.spread;
        band.widen = spread.widen;
        // 12.566371 is 4 pi and 1.1892071 is 2^(1/4)
        let speed = select(32768.0 * GABOR_IMPL_GRAVITY / (12.566371 * GABOR_IMPL_TICK * low * 1.1892071)
                                         * exp2(-f32(band.exponent)),
                    0.0, ocean.loop_seconds > 0);
        band.drift = vec2i(floor(speed * gabor_impl_wave(0.15915494 * direction) + 0.5)); // 1/(2 pi)
        ocean.band[i] = band;
    }
    ocean.tail = max(ocean.tail, vec2f(0.0));
    return ocean;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    return gabor_ocean_of(wind, 0.0, 2.0e5, vec3f(0.0), 0);
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
    from_x: vec4f, // offset of the point from the node, in metres
    from_y: vec4f,
    window: vec4f, // times the band's amplitude, as are its derivatives
    window_x: vec4f,
    window_y: vec4f,
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
    let turn_x = band.amplitude * gabor_impl_half_turn(turns.x); let turn_y = gabor_impl_half_turn(turns.y);
    let along_x = vec4f(turn_x, turn_x); let along_y = vec4f(turn_y.xx, turn_y.yy);
    let west = gabor_impl_line_word(node.x, salt); let east = gabor_impl_line_word(node.x + 1, salt);
    let south = gabor_impl_line_word(node.y, salt ^ GABOR_IMPL_ROWS);
    let north = gabor_impl_line_word(node.y + 1, salt ^ GABOR_IMPL_ROWS);
    return GaborImplOceanNodes(vec4u(south * west, south * east, north * west, north * east),
                               spacing * (offset.x - vec4f(0.0, 1.0, 0.0, 1.0)),
                               spacing * (offset.y - vec4f(0.0, 0.0, 1.0, 1.0)), along_x * along_y,
                               slope.x * vec4f(-turn_x.y, turn_x.x, -turn_x.y, turn_x.x) * along_y,
                               slope.y * vec4f(-turn_y.yy, turn_y.xx) * along_x);
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    turning: vec4f, // F - k.V, in quanta of frequency
    k: vec4f,       // wave number, 2 pi over the wavelength in metres
    heading_x: vec4f,
    heading_y: vec4f,
}

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` 1024 (F / low)^2 cos d.
// `turning` is F - k.V, where k.V is `carried` times 861 / 2048, nearly 2^(-5/4). In a loop, the lattice stands.
fn gabor_impl_ocean_waves(band: GaborOceanBand, word: vec4u, normal: bool, heading: vec2f, quantum: f32, scale: f32,
                          half_step: f32) -> GaborImplOceanWaves {
    var bits = (word ^ (word >> vec4u(15u))) * 0xd35a2d97u;
    bits ^= bits >> vec4u(15u);
    // 10, 11 and 11 bits
    let share = vec4f(bits >> vec4u(22u)); let u = vec4f(vec4i(bits << vec4u(10u)) >> vec4u(21));
    let w = vec4f(vec4i(bits << vec4u(21u)) >> vec4u(21));
    let rise = trunc(1024.0 + band.early.x * share + band.early.y * max(share - 64.0, vec4f(0.0))
                     + band.early.z * max(share - 256.0, vec4f(0.0)) + band.late.x * max(share - 512.0, vec4f(0.0))
                     + band.late.y * max(share - 768.0, vec4f(0.0)) + band.late.z * max(share - 960.0, vec4f(0.0)));
    let bent = trunc(band.spread.x + band.spread.y * trunc(0.001953125 * u * u)); // 2^-9
    let angle = trunc(2.44140625e-4 * (u * bent + w * band.spread.z)) * (band.widen.x + band.widen.y * rise); // 2^-12
    let part = trunc(1.220703125e-4 * angle); let lag = trunc(4.8828125e-4 * part * part); // 2^-13, 2^-11
    let steep = trunc(9.765625e-4 * rise * rise); let carried = steep - trunc(9.765625e-4 * steep * lag); // 2^-10
    let count = trunc(scale * rise + half_step);
    // 6.7265625 is 861/128
    let turning = quantum * count - trunc(select(band.low / 16384.0, 0.0, quantum > 1.0) * trunc(6.7265625 * carried));
    // 2 pi k, less 0.1 or 2 % for the slopes that the windows add
    let k = select(0.978, 0.9986, normal) * 9.37e-10 * quantum * quantum * count * count;
    let chord = 1.1920929e-7 * angle; let cosine = 1.0 - 0.5 * chord * chord; // 2^-23
    let sine = chord * sqrt(1.0 - 0.25 * chord * chord);
    return GaborImplOceanWaves(turning, k, heading.x * cosine - heading.y * sine,
                               heading.y * cosine + heading.x * sine);
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
fn gabor_impl_add_band(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3f>, band: GaborOceanBand,
                       normal: bool, heading: vec2f, quantum: vec2f, least: f32, cell: vec2i, local: vec2f,
                       second: i32, fraction: f32, dx: vec2f, dy: vec2f, seed: u32) {
    let scale = 9.765625e-4 * band.low * quantum.y; let half_step = max(0.5, 1.0 - 1024.0 * scale); // 2^-10
    let lowest = quantum.x * floor(1024.0 * scale + half_step);
    let longest = 1.486e-10 * lowest * lowest; // the least k, 2 pi F^2 / g
    if (band.amplitude == 0.0 || longest * longest * least > 1.6) { // each wave would be below 1 / 2700 of its height
        (*sum).lost += gabor_impl_slopes_along(band.slopes, heading);
        return;
    }
    let nodes = gabor_impl_ocean_nodes(band, cell, local, second, fraction, gabor_impl_salt(seed));
    let waves = gabor_impl_ocean_waves(band, nodes.word, normal, heading, quantum.x, scale, half_step);
    let k = waves.k; let x = waves.heading_x; let y = waves.heading_y;
    let ticks = (vec4u(vec4i(waves.turning)) * u32(second) + (nodes.word >> vec4u(16u))) & vec4u(0xffffu);
    // 0.15915494 is 1/(2 pi) and 1.52587890625e-5 is 2^-16
    let phase = 0.15915494 * k * (x * nodes.from_x + y * nodes.from_y)
               - 1.52587890625e-5 * (vec4f(ticks) + waves.turning * fraction);
    let a = gabor_impl_wave(phase.x); let b = gabor_impl_wave(phase.y);
    let c = gabor_impl_wave(phase.z); let d = gabor_impl_wave(phase.w);
    let steps_x = k * (x * dx.x + y * dx.y); let steps_y = k * (x * dy.x + y * dy.y);
    let kept = exp(-0.125 * (steps_x * steps_x + steps_y * steps_y));
    // The amplitude's square is uniform. For a normal distribution, the amplitude is nearly sqrt(-2 ln(1 - square)).
    let square = 1.52587890625e-5 * vec4f(nodes.word & vec4u(0xffffu)); var amplitude = kept * sqrt(square);
    // fit: see tools/constants.py
    amplitude *= select(vec4f(2.0), 1.3034767 + 0.3870924 * square + 0.0960481 / (1.0580433 - square), normal);
    var height = amplitude * vec4f(a.y, b.y, c.y, d.y);
    let along = nodes.window * amplitude * vec4f(a.x, b.x, c.x, d.x);
    (*sum).slope += vec2f(dot(height, nodes.window_x), dot(height, nodes.window_y));
    height *= nodes.window;
    let steepness = k * along; let squeezed = k * height;
    let lost = select(1.048, 1.003, normal) * nodes.window * nodes.window * k * k * (1.0 - kept * kept);
    (*sum).height += dot(height, vec4f(1.0));
    (*sum).slope += vec2f(dot(steepness, x), dot(steepness, y));
    (*sum).shift += vec2f(dot(along, x), dot(along, y));
    *squeeze += vec3f(dot(squeezed, x * x), dot(squeezed, x * y), dot(squeezed, vec4f(1.0)));
    (*sum).lost += vec3f(dot(lost, x * x), dot(lost, x * y), dot(lost, vec4f(1.0)));
}

fn gabor_water_at(cell: vec2i, local: vec2f, second: i32, fraction: f32, dx: vec2f, dy: vec2f, ocean_in: GaborOcean,
                  seed: u32) -> GaborWater {
    var ocean = ocean_in;
    // 0.15915494 is 1/(2 pi)
    let wind = gabor_impl_wave(0.15915494 * ocean.direction); let swell = gabor_impl_wave(0.15915494 * ocean.swell.z);
    var water = GaborWater(0.0, vec2f(0.0), vec2f(0.0), 0.0, gabor_impl_slopes_along(ocean.tail, wind));
    var squeeze = vec3f(0.0);
    // 1.52587890625e-5 is 2^-16
    let quantum = select(vec2f(1.0),
                  vec2f(f32(65536 / max(ocean.loop_seconds, 1)), 1.52587890625e-5 * f32(ocean.loop_seconds)),
                  ocean.loop_seconds > 0);
    let area = dx.x * dy.y - dx.y * dy.x; let sides = dot(dx, dx) + dot(dy, dy); // the pixel is an ellipse
    let least = 2.0 * area * area / max(sides + sqrt(max(sides * sides - 4.0 * area * area, 0.0)), 1.0e-30);
    for (var i = 0; i < select(GABOR_OCEAN_BANDS, GABOR_OCEAN_BANDS + 1, ocean.swell.x > 0.0); i++) {
        let remote = i == GABOR_OCEAN_BANDS; // the swell, the same for any bands
        gabor_impl_add_band(&water, &squeeze, ocean.band[i], remote || (i > 0 && i < 4), select(wind, swell, remote), quantum,
                            least, cell, local, second, fraction, dx, dy, gabor_derived_seed(seed, select(i, 12, remote)));
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
    var water = GaborWater(0.0, vec2f(0.0), vec2f(0.0), 0.0, vec3f(0.0));
    for (var i = 0; i < 6; i++) { water = gabor_water(p - water.shift, seconds, ocean, seed); }
    return water.height;
}
