// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 196a1558d7f9b3c1.
// Paste it after gabor_noise.wgsl.
//
// gabor_ocean.wgsl: a sea that never repeats, at any point and time, without textures or state, alike on CPU and GPU.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     GaborOcean sea = gabor_ocean(12.0);              // a wind of 12 m/s; once per draw, or as a uniform
//     GaborWater w = gabor_water(p, 60.5, sea, 7u);    // p in metres, after 60.5 seconds
//     vec2f place = p + w.shift;                        // of the water, at the height w.height
//
//     I want                                           call
//     water under a pixel                              gabor_water_filtered
//     a boat's height                                  gabor_water_height
//     a world of any size, or months of time           gabor_water_at
//     another direction or fetch, a swell, a loop      gabor_ocean_of
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Waves from one wavelength to half of it. `low`, `early`, `late` and `spread` are multiples of powers of 2, so that
// sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2<f32>, // variance of the slopes along the band's direction and across it
    exponent: i32, // the spacing of nodes is 2^exponent metres
    low: f32, // 65536 times the lowest frequency in Hz
    early: vec3<f32>, // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next
    late: vec3<f32>, // 3/16, 4/16, 4/16, 3/16 and 1/16
    spread: vec3<f32>, // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in
    widen: vec2<f32>, // [-1, 1], times a linear function of the frequency
    drift: vec2<i32>, // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32, // speed in metres per second, 10 m up
    direction: f32, // where the waves go: radians from +x towards +y
    fetch: f32, // metres of open water upwind, 10^3 to 10^6: beyond 2190 wind^2, waves grow no more
    swell: vec3<f32>, // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    loop_: i32, // the seconds after which all repeats, or 0 for never
    tail: vec2<f32>, // variance of the slopes of waves shorter than all bands, along the wind and across it
    band: array<GaborOceanBand, 10>, // the swell is the last
}
// GaborOcean gabor_ocean(f32 wind)
// GaborOcean gabor_ocean_of(f32 wind, f32 direction, f32 fetch, vec3f swell, i32 loop)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the
//     JONSWAP spectrum [HBB73] until it is fully developed [PM64], and the directions of [HDE80]. A swell, from a
//     remote storm, has a narrow spread of directions and a sharp peak [G10]; vec3f(0.0) is none. For films, all repeats
//     after a loop of 8, 16, 32 ... 4096 seconds, to which other values are rounded down. Its price: groups of waves
//     stand still, and each wave's period becomes an integer fraction of it, so a loop should last several periods of
//     the swell. Compute a sea once, on the CPU if the CPU also asks for heights: the integers may round differently on
//     another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    height: f32, // metres, of mean 0 and normally distributed
    slope: vec2<f32>, // derivatives of the height by p
    shift: vec2<f32>, // horizontal displacement in metres, towards crests, which it sharpens
    fold: f32, // determinant of the derivative of p + shift, within 0.1, or 0.2 for a fetch of 1 km: foam below 0.7
    lost: vec3<f32>, // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
}
// GaborWater gabor_water(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(vec2f p, vec2f dx, vec2f dy, f32 seconds, GaborOcean ocean, u32 seed)
//     The same without waves that are too fine for a pixel (dx and dy are dpdx(p), dpdy(p)), whose slopes are in
//     `lost`, as are those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk
//     measured [CM54], if the sea has neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone
//     have up to 1.8 times that.
// f32 gabor_water_height(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.
// GaborWater gabor_water_at(vec2i cell, vec2f local, i32 second, f32 fraction, vec2f dx, vec2f dy, GaborOcean ocean,
//                            u32 seed)
//     At the position cell + local in metres, second + fraction in seconds: exact for years and anywhere. dx and dy of
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

// A JONSWAP spectrum: the frequency of its peak, its scale, and the logarithm of how much its peak is raised.
struct GaborImplJonswap {
    peak: f32,
    scale: f32,
    sharp: f32,
}

// The spectrum of waves that a wind raises over a fetch.
fn gabor_impl_wind_waves(wind: f32, fetch: f32) -> GaborImplJonswap {
    var gravity: f32 = 9.81f;
    var reach_1: f32;
    var peak: f32;
    var scale: f32;
    let _e4 = gravity;
    reach_1 = min(((_e4 * fetch) / (wind * wind)), 21500f);
    let _e12 = gravity;
    let _e15 = reach_1;
    peak = (((3.5f * _e12) / wind) * pow(_e15, -0.33f));
    let _e22 = reach_1;
    let _e27 = gravity;
    let _e29 = gravity;
    scale = ((((0.076f * pow(_e22, -0.22f)) * _e27) * _e29) / 1558.5455f);
    let _e34 = peak;
    let _e35 = scale;
    return GaborImplJonswap(_e34, _e35, 1.1939225f);
}

// The spectrum at a frequency in m^2 / Hz, and the same times f^4.
fn gabor_impl_spectrum(f: f32, sea: GaborImplJonswap) -> vec2<f32> {
    var below: f32;
    var local_11: f32;
    var apart: f32;
    below = ((sea.peak * sea.peak) / (f * f));
    if (f < sea.peak) {
        local_11 = 0.07f;
    } else {
        local_11 = 0.09f;
    }
    let _e17 = local_11;
    apart = (((f / sea.peak) - 1f) / _e17);
    let _e25 = apart;
    let _e27 = apart;
    let _e32 = below;
    let _e34 = below;
    return (((sea.scale / f) * exp(((sea.sharp * exp(((-0.5f * _e25) * _e27))) - ((1.25f * _e32) * _e34)))) * vec2<f32>((1f / (((f * f) * f) * f)), 1f));
}

// The frequency of step j of the 16, `width` wide, that a band's frequencies from `low` up are divided into.
fn gabor_impl_step_frequency(j: i32, low: f32, width: f32) -> f32 {
    return (0.000015258789f * (low + ((f32(j) + 0.5f) * width)));
}

// The power of a band, and means over it. `rise` is 1024 F / low, as in gabor_impl_ocean_waves, less 1236 here.
struct GaborImplBandPower {
    sum: vec2<f32>, // the power, and the same times f^4
    variance: f32, // the mean of sin(d / 2)^2, where d is the angle from the band's direction
    fit: vec4<f32>, // means of rise, r, rise^2 and rise r, where r^2 is the mean of sin(d / 2)^2 at that frequency
}

fn gabor_impl_band_power(low: f32, sea: GaborImplJonswap, remote: bool) -> GaborImplBandPower {
    var power_1: GaborImplBandPower = GaborImplBandPower(vec2(0f), 0f, vec4(0f));
    var width_1: f32;
    var j_2: i32 = 0i;
    var f_1: f32;
    var x_5: f32;
    var above: f32;
    var local_12: f32;
    var local_13: f32;
    var s_2: f32;
    var here: f32;
    var part: vec2<f32>;
    width_1 = (0.025878906f * low);
    loop {
        let _e15 = j_2;
        if !((_e15 < 16i)) {
            break;
        }
        {
            let _e22 = j_2;
            let _e23 = width_1;
            let _e24 = gabor_impl_step_frequency(_e22, low, _e23);
            f_1 = _e24;
            let _e27 = j_2;
            x_5 = ((26.5f * f32(_e27)) - 198.75f);
            let _e33 = f_1;
            above = (_e33 / sea.peak);
            if remote {
                local_13 = 75f;
            } else {
                let _e39 = above;
                let _e40 = above;
                if (_e40 < 1f) {
                    local_12 = 4.06f;
                } else {
                    local_12 = -2.34f;
                }
                let _e47 = local_12;
                local_13 = (9.77f * pow(_e39, _e47));
            }
            let _e51 = local_13;
            s_2 = _e51;
            let _e54 = s_2;
            here = (0.5f / (_e54 + 1f));
            let _e60 = width_1;
            let _e62 = f_1;
            let _e63 = gabor_impl_spectrum(_e62, sea);
            part = ((0.000015258789f * _e60) * _e63);
            let _e67 = power_1;
            let _e69 = part;
            power_1.sum = (_e67.sum + _e69);
            let _e72 = power_1;
            let _e74 = part;
            let _e76 = here;
            power_1.variance = (_e72.variance + (_e74.x * _e76));
            let _e80 = power_1;
            let _e82 = part;
            let _e84 = x_5;
            let _e85 = here;
            let _e87 = x_5;
            let _e88 = x_5;
            let _e90 = x_5;
            let _e91 = here;
            power_1.fit = (_e80.fit + (_e82.x * vec4<f32>(_e84, sqrt(_e85), (_e87 * _e88), (_e90 * sqrt(_e91)))));
        }
        continuing {
            let _e19 = j_2;
            j_2 = (_e19 + 1i);
        }
    }
    let _e98 = power_1;
    let _e100 = power_1;
    power_1.variance = (_e98.variance / _e100.sum.x);
    let _e105 = power_1;
    let _e107 = power_1;
    power_1.fit = (_e105.fit / vec4(_e107.sum.x));
    let _e112 = power_1;
    return _e112;
}

// The directions of a band: its members `spread` and `widen`, and the mean of cos^2 d.
struct GaborImplBandSpread {
    spread: vec3<f32>,
    widen: vec2<f32>,
    along: f32,
}

// sin(d / 2) is (a u + b u^3 + c v) times 1 + widen rise, where u and v are uniform in [-1, 1].
fn gabor_impl_band_spread(power: GaborImplBandPower) -> GaborImplBandSpread {
    var variance: f32;
    var deviation: f32;
    var narrow: f32;
    var fit: vec4<f32>;
    var c_1: f32;
    var widen: f32;
    var most: f32;
    var end: f32;
    var rest: f32;
    var a_2: f32;
    var b_2: f32;
    var fourth_1: f32;
    variance = power.variance;
    let _e3 = variance;
    deviation = sqrt(_e3);
    let _e7 = variance;
    narrow = ((0.5f / _e7) - 1.8f);
    fit = power.fit;
    let _e15 = deviation;
    let _e17 = narrow;
    c_1 = ((0.9f * _e15) * clamp(_e17, 0f, 1f));
    let _e24 = narrow;
    let _e29 = fit;
    let _e31 = fit;
    let _e33 = fit;
    let _e38 = fit;
    let _e40 = fit;
    let _e42 = fit;
    let _e46 = deviation;
    widen = ((clamp((0.3f * _e24), 0f, 1f) * (_e29.w - (_e31.x * _e33.y))) / ((_e38.z - (_e40.x * _e42.x)) * _e46));
    let _e51 = widen;
    widen = (floor((clamp((16384f * _e51), -32f, 32f) + 0.5f)) / 16384f);
    let _e65 = widen;
    let _e69 = fit;
    let _e71 = widen;
    most = (1f / ((1f + (212f * abs(_e65))) - (_e69.x * _e71)));
    let _e77 = deviation;
    let _e79 = most;
    let _e80 = c_1;
    end = min((1.8f * _e77), (_e79 - _e80));
    let _e84 = variance;
    let _e85 = c_1;
    let _e86 = c_1;
    rest = (_e84 - ((_e85 * _e86) / 3f));
    let _e93 = rest;
    let _e96 = end;
    let _e98 = end;
    let _e105 = end;
    a_2 = ((sqrt(max(((0.3047619f * _e93) - ((0.0304762f * _e96) * _e98)), 0f)) - (0.1142857f * _e105)) / 0.152381f);
    let _e111 = end;
    let _e112 = a_2;
    b_2 = (_e111 - _e112);
    let _e115 = a_2;
    let _e116 = a_2;
    let _e118 = a_2;
    let _e121 = a_2;
    let _e124 = b_2;
    let _e128 = b_2;
    let _e129 = b_2;
    let _e132 = a_2;
    let _e134 = a_2;
    let _e137 = a_2;
    let _e139 = b_2;
    let _e143 = b_2;
    let _e145 = b_2;
    let _e150 = c_1;
    let _e151 = c_1;
    let _e154 = rest;
    let _e157 = c_1;
    let _e159 = c_1;
    fourth_1 = (((((_e115 * _e116) * _e118) * ((0.2f * _e121) + (0.5714286f * _e124))) + ((_e128 * _e129) * ((((0.6666667f * _e132) * _e134) + ((0.36363637f * _e137) * _e139)) + ((0.07692308f * _e143) * _e145)))) + ((_e150 * _e151) * ((2f * _e154) + ((0.2f * _e157) * _e159))));
    let _e166 = a_2;
    let _e167 = b_2;
    let _e168 = c_1;
    let _e179 = fit;
    let _e183 = widen;
    let _e186 = widen;
    let _e192 = variance;
    let _e196 = fourth_1;
    return GaborImplBandSpread((floor((511.5f * vec3<f32>(_e166, _e167, _e168))) * vec3<f32>(8f, 0.00390625f, 8f)), floor((16384f * vec2<f32>((1f - ((_e179.x + 1236f) * _e183)), _e186))), ((1f - (4f * _e192)) + (4f * _e196)));
}

// The frequencies of a band whose power is `whole`: its members `early` and `late`, by the inverse of the distribution.
// The knots have 0.0621, 0.2483, 0.4965, 0.7448, 0.931 and all of the power below them, instead of 1/16, 4/16, 8/16 and
// so on: between them, frequencies are uniform, and thus too high. Lower knots keep the variance of the slopes.
fn gabor_impl_band_knots(low: f32, whole: f32, sea: GaborImplJonswap, early: ptr<function, vec3<f32>>, late: ptr<function, vec3<f32>>) {
    var first_1: vec3<f32> = vec3(0f);
    var second_2: vec3<f32> = vec3(0f);
    var ahead: vec3<f32> = vec3<f32>(0.0621f, 0.2483f, 0.4965f);
    var width_2: f32;
    var n: i32 = 0i;
    var f_2: f32;
    var part_1: f32;
    width_2 = (0.025878906f * low);
    loop {
        let _e21 = n;
        if !((_e21 < 16i)) {
            break;
        }
        {
            let _e28 = n;
            let _e29 = width_2;
            let _e30 = gabor_impl_step_frequency(_e28, low, _e29);
            f_2 = _e30;
            let _e33 = width_2;
            let _e36 = f_2;
            let _e37 = gabor_impl_spectrum(_e36, sea);
            part_1 = (((0.000015258789f * _e33) / whole) * _e37.x);
            let _e41 = first_1;
            let _e43 = ahead;
            let _e44 = part_1;
            first_1 = (_e41 + (26.5f * clamp((_e43 / vec3(max(_e44, 0.000000001f))), vec3(0f), vec3(1f))));
            let _e56 = second_2;
            let _e58 = ahead;
            let _e64 = part_1;
            second_2 = (_e56 + (26.5f * clamp(((_e58 + vec3<f32>(0.6827f, 0.6827f, 0.5035f)) / vec3(max(_e64, 0.000000001f))), vec3(0f), vec3(1f))));
            let _e76 = ahead;
            let _e77 = part_1;
            ahead = (_e76 - vec3(_e77));
        }
        continuing {
            let _e25 = n;
            n = (_e25 + 1i);
        }
    }
    let _e80 = first_1;
    let _e82 = first_1;
    let _e83 = _e82.xy;
    (*early) = (floor((((_e80 - vec3<f32>(0f, _e83.x, _e83.y)) * vec3<f32>(4f, 1.3333333f, 1f)) + vec3(0.5f))) / vec3(256f));
    let _e100 = second_2;
    let _e101 = first_1;
    let _e103 = second_2;
    let _e104 = _e103.xy;
    (*late) = (floor((((_e100 - vec3<f32>(_e101.z, _e104.x, _e104.y)) * vec3<f32>(1f, 1.3333333f, 4f)) + vec3(0.5f))) / vec3(256f));
    let _e121 = (*late);
    let _e122 = (*early);
    let _e124 = (*late);
    let _e125 = _e124.xy;
    (*late) = (_e121 - vec3<f32>(_e122.z, _e125.x, _e125.y));
    let _e130 = (*early);
    let _e132 = (*early);
    let _e133 = _e132.xy;
    (*early) = (_e130 - vec3<f32>(0f, _e133.x, _e133.y));
    return;
}

fn gabor_ocean_of(wind: f32, direction: f32, fetch: f32, swell: vec3<f32>, loop_: i32) -> GaborOcean {
    var direction_1: f32;
    var ocean: GaborOcean;
    var local_14: i32;
    var sea_3: GaborImplJonswap;
    var octave: i32;
    var i: i32 = 0i;
    var local_15: u32;
    var low_3: f32;
    var remote_1: bool;
    var power_3: GaborImplBandPower;
    var spread: GaborImplBandSpread;
    var band: GaborOceanBand;
    var local_16: f32;
    var local_17: f32;
    var tall: f32;
    var local_18: i32;
    var local_19: i32;
    var early_1: vec3<f32>;
    var late_1: vec3<f32>;
    var local_20: f32;
    var speed: f32;
    direction_1 = direction;
    ocean.wind = clamp(wind, 2f, 30f);
    let _e12 = direction_1;
    ocean.direction = _e12;
    ocean.fetch = clamp(fetch, 1000f, 1000000f);
    ocean.swell = vec3<f32>(clamp(swell.x, 0f, 30f), clamp(swell.y, 5f, 25f), swell.z);
    if (loop_ > 0i) {
        local_14 = i32((1u << u32((log2(f32(clamp(loop_, 8i, 4096i))) + 0.0002f))));
    } else {
        local_14 = 0i;
    }
    let _e44 = local_14;
    ocean.loop_ = _e44;
    let _e49 = ocean;
    ocean.tail = ((vec2<f32>(0.00316f, 0.00192f) * _e49.wind) + vec2<f32>(0f, 0.003f));
    let _e56 = ocean;
    let _e58 = ocean;
    let _e60 = gabor_impl_wind_waves(_e56.wind, _e58.fetch);
    sea_3 = _e60;
    let _e63 = sea_3;
    octave = i32(floor(log2(((0.62f * _e63.peak) / 0.000015258789f))));
    loop {
        let _e74 = i;
        if !((_e74 <= 9i)) {
            break;
        }
        {
            let _e81 = i;
            if ((_e81 & 1i) == 0i) {
                local_15 = 128u;
            } else {
                local_15 = 181u;
            }
            let _e89 = local_15;
            let _e90 = octave;
            let _e91 = i;
            low_3 = (f32((_e89 << u32((_e90 + (_e91 / 2i))))) / 128f);
            let _e101 = i;
            remote_1 = (_e101 == 9i);
            let _e105 = remote_1;
            if _e105 {
                {
                    let _e108 = ocean;
                    sea_3.peak = (1f / _e108.swell.y);
                    sea_3.sharp = 2.0794415f;
                    let _e116 = sea_3;
                    low_3 = (64f * floor((((0.0132813f * _e116.peak) / 0.000015258789f) + 0.5f)));
                    let _e125 = ocean;
                    direction_1 = _e125.swell.z;
                }
            }
            let _e128 = low_3;
            let _e129 = sea_3;
            let _e130 = remote_1;
            let _e131 = gabor_impl_band_power(_e128, _e129, _e130);
            power_3 = _e131;
            let _e133 = power_3;
            let _e134 = gabor_impl_band_spread(_e133);
            spread = _e134;
            let _e137 = remote_1;
            if _e137 {
                let _e139 = ocean;
                let _e143 = ocean;
                local_17 = ((0.0625f * _e139.swell.x) * _e143.swell.x);
            } else {
                let _e147 = low_3;
                if (_e147 > 262144f) {
                    local_16 = 0f;
                } else {
                    let _e151 = power_3;
                    local_16 = _e151.sum.x;
                }
                let _e155 = local_16;
                local_17 = _e155;
            }
            let _e157 = local_17;
            tall = _e157;
            let _e160 = tall;
            band.amplitude = sqrt(_e160);
            let _e164 = tall;
            let _e166 = power_3;
            let _e170 = power_3;
            let _e174 = spread;
            let _e177 = spread;
            band.slopes = ((((16.195057f * _e164) * _e166.sum.y) / _e170.sum.x) * vec2<f32>(_e174.along, (1f - _e177.along)));
            let _e182 = remote_1;
            if !(_e182) {
                let _e185 = ocean;
                let _e187 = band;
                ocean.tail = (_e185.tail - _e187.slopes);
            }
            let _e191 = remote_1;
            if _e191 {
                let _e193 = sea_3;
                let _e195 = sea_3;
                local_19 = i32(floor(log2((18f / (_e193.peak * _e195.peak)))));
            } else {
                let _e204 = octave;
                let _e207 = i;
                let _e209 = i;
                let _e212 = i;
                if ((_e209 > 0i) && (_e212 < 4i)) {
                    local_18 = 1i;
                } else {
                    local_18 = -1i;
                }
                let _e220 = local_18;
                local_19 = (((34i - (2i * _e204)) - _e207) + _e220);
            }
            let _e223 = local_19;
            band.exponent = _e223;
            let _e225 = low_3;
            band.low = _e225;
            let _e228 = low_3;
            let _e229 = power_3;
            let _e232 = sea_3;
            gabor_impl_band_knots(_e228, _e229.sum.x, _e232, (&early_1), (&late_1));
            let _e238 = early_1;
            band.early = _e238;
            let _e240 = late_1;
            band.late = _e240;
            let _e242 = spread;
            band.spread = _e242.spread;
            let _e245 = spread;
            band.widen = _e245.widen;
            let _e247 = ocean;
            if (_e247.loop_ > 0i) {
                local_20 = 0f;
            } else {
                let _e258 = low_3;
                let _e263 = band;
                local_20 = ((321454.1f / ((0.0001917476f * _e258) * 1.1892071f)) * exp2(-(f32(_e263.exponent))));
            }
            let _e270 = local_20;
            speed = _e270;
            let _e273 = speed;
            let _e275 = direction_1;
            let _e277 = gabor_impl_wave((0.15915494f * _e275));
            band.drift = vec2<i32>(floor(((_e273 * _e277) + vec2(0.5f))));
            let _e284 = i;
            let _e287 = band;
            ocean.band[_e284] = _e287;
        }
        continuing {
            let _e78 = i;
            i = (_e78 + 1i);
        }
    }
    let _e289 = ocean;
    ocean.tail = max(_e289.tail, vec2(0f));
    let _e294 = ocean;
    return _e294;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e6 = gabor_ocean_of(wind, 0f, 200000f, vec3(0f), 0i);
    return _e6;
}

// ---- The water -----------------------------------------------------------------------------------------------------

// xx, xy and xx + yy of slopes with these variances along a unit vector and across it.
fn gabor_impl_slopes_along(variances: vec2<f32>, along: vec2<f32>) -> vec3<f32> {
    let _e11 = ((((variances.x - variances.y) * along.x) * along) + vec2<f32>(variances.y, 0f));
    return vec3<f32>(_e11.x, _e11.y, (variances.x + variances.y));
}

// The four nodes of a band around a point, together, which CPUs do faster: south west, south east, north west and
// north east.
struct GaborImplOceanNodes {
    word: vec4<u32>,
    from_x: vec4<f32>, // offset of the point from the node, in metres
    from_y: vec4<f32>,
    window: vec4<f32>, // times the band's amplitude, as are its derivatives
    window_x: vec4<f32>,
    window_y: vec4<f32>,
}

fn gabor_impl_ocean_nodes(band: GaborOceanBand, cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, salt: u32) -> GaborImplOceanNodes {
    var drifted: vec2<i32>;
    var up: i32;
    var down: i32;
    var spacing: f32;
    var rest_1: vec2<f32>;
    var first_2: vec2<f32>;
    var offset: vec2<f32>;
    var node: vec2<i32>;
    var middle: vec2<f32>;
    var fourth_2: vec2<f32>;
    var turns: vec2<f32>;
    var slope_6: vec2<f32>;
    var turn_x: vec2<f32>;
    var turn_y: vec2<f32>;
    var along_x_1: vec4<f32>;
    var along_y_1: vec4<f32>;
    var west: u32;
    var east: u32;
    var south: u32;
    var north: u32;
    drifted = ((second & 32767i) * band.drift);
    up = max(band.exponent, 0i);
    down = max(-(band.exponent), 0i);
    spacing = exp2(f32(band.exponent));
    let _e25 = up;
    let _e35 = spacing;
    let _e38 = drifted;
    rest_1 = (((((vec2<f32>((cell & vec2((i32((1u << u32(_e25))) - 1i)))) + local) / vec2(_e35)) - (vec2<f32>((_e38 & vec2(32767i))) / vec2(32768f))) - ((fraction / 32768f) * vec2<f32>(band.drift))) + (vec2<f32>(f32((salt & 65535u)), f32((salt >> 16u))) / vec2(65536f)));
    let _e65 = rest_1;
    first_2 = floor(_e65);
    let _e68 = rest_1;
    let _e69 = first_2;
    offset = clamp((_e68 - _e69), vec2(0f), vec2(1f));
    let _e77 = up;
    let _e81 = down;
    let _e91 = drifted;
    let _e97 = first_2;
    node = (((((cell >> vec2(u32(_e77))) << vec2(u32(_e81))) - ((second >> 15u) * band.drift)) - (_e91 >> vec2(15u))) + vec2<i32>(_e97));
    let _e102 = offset;
    middle = ((2f * _e102) - vec2(1f));
    let _e108 = middle;
    let _e109 = middle;
    let _e111 = middle;
    let _e113 = middle;
    fourth_2 = (((_e108 * _e109) * _e111) * _e113);
    let _e117 = middle;
    let _e120 = fourth_2;
    turns = (vec2(0.125f) + (_e117 * (vec2(0.15625f) - (0.03125f * _e120))));
    let _e129 = spacing;
    let _e132 = fourth_2;
    slope_6 = ((1.9634954f / _e129) * (vec2(1f) - _e132));
    let _e138 = turns;
    let _e140 = gabor_impl_half_turn(_e138.x);
    turn_x = (band.amplitude * _e140);
    let _e143 = turns;
    let _e145 = gabor_impl_half_turn(_e143.y);
    turn_y = _e145;
    let _e147 = turn_x;
    let _e148 = turn_x;
    along_x_1 = vec4<f32>(_e147.x, _e147.y, _e148.x, _e148.y);
    let _e155 = turn_y;
    let _e156 = _e155.xx;
    let _e157 = turn_y;
    let _e158 = _e157.yy;
    along_y_1 = vec4<f32>(_e156.x, _e156.y, _e158.x, _e158.y);
    let _e165 = node;
    let _e167 = gabor_impl_line_word(_e165.x, salt);
    west = _e167;
    let _e169 = node;
    let _e173 = gabor_impl_line_word((_e169.x + 1i), salt);
    east = _e173;
    let _e175 = node;
    let _e179 = gabor_impl_line_word(_e175.y, (salt ^ 1540483477u));
    south = _e179;
    let _e181 = node;
    let _e187 = gabor_impl_line_word((_e181.y + 1i), (salt ^ 1540483477u));
    north = _e187;
    let _e189 = south;
    let _e190 = west;
    let _e192 = south;
    let _e193 = east;
    let _e195 = north;
    let _e196 = west;
    let _e198 = north;
    let _e199 = east;
    let _e202 = spacing;
    let _e203 = offset;
    let _e213 = spacing;
    let _e214 = offset;
    let _e224 = along_x_1;
    let _e225 = along_y_1;
    let _e227 = slope_6;
    let _e229 = turn_x;
    let _e232 = turn_x;
    let _e234 = turn_x;
    let _e237 = turn_x;
    let _e241 = along_y_1;
    let _e243 = slope_6;
    let _e245 = turn_y;
    let _e247 = -(_e245.yy);
    let _e248 = turn_y;
    let _e249 = _e248.xx;
    let _e256 = along_x_1;
    return GaborImplOceanNodes(vec4<u32>((_e189 * _e190), (_e192 * _e193), (_e195 * _e196), (_e198 * _e199)), (_e202 * (vec4(_e203.x) - vec4<f32>(0f, 1f, 0f, 1f))), (_e213 * (vec4(_e214.y) - vec4<f32>(0f, 0f, 1f, 1f))), (_e224 * _e225), ((_e227.x * vec4<f32>(-(_e229.y), _e232.x, -(_e234.y), _e237.x)) * _e241), ((_e243.y * vec4<f32>(_e247.x, _e247.y, _e249.x, _e249.y)) * _e256));
}

// The waves of four nodes.
struct GaborImplOceanWaves {
    turning: vec4<f32>, // F - k.V, in quanta of frequency
    k: vec4<f32>, // wave number, 2 pi over the wavelength in metres
    heading_x: vec4<f32>,
    heading_y: vec4<f32>,
}

// `rise` is 1024 F / low, `angle` 2^24 sin(d / 2), `lag` 2048 sin(d / 2)^2, and `carried` 1024 (F / low)^2 cos d.
// `turning` is F - k.V, where k.V is `carried` times 861 / 2048, nearly 2^(-5/4). In a loop, the lattice stands.
fn gabor_impl_ocean_waves(band: GaborOceanBand, word: vec4<u32>, normal: bool, heading: vec2<f32>, quantum: f32, scale: f32, half_step: f32) -> GaborImplOceanWaves {
    var bits: vec4<u32>;
    var share: vec4<f32>;
    var u_1: vec4<f32>;
    var w: vec4<f32>;
    var rise: vec4<f32>;
    var bent: vec4<f32>;
    var angle: vec4<f32>;
    var part_2: vec4<f32>;
    var lag: vec4<f32>;
    var steep: vec4<f32>;
    var carried: vec4<f32>;
    var count: vec4<f32>;
    var local_22: f32;
    var turning: vec4<f32>;
    var local_23: f32;
    var k: vec4<f32>;
    var chord: vec4<f32>;
    var cosine: vec4<f32>;
    var sine: vec4<f32>;
    bits = ((word ^ (word >> vec4(15u))) * 3545902487u);
    let _e14 = bits;
    let _e15 = bits;
    bits = (_e14 ^ (_e15 >> vec4(15u)));
    let _e20 = bits;
    share = vec4<f32>((_e20 >> vec4(22u)));
    let _e26 = bits;
    u_1 = vec4<f32>((vec4<i32>((_e26 << vec4(10u))) >> vec4(21u)));
    let _e37 = bits;
    w = vec4<f32>((vec4<i32>((_e37 << vec4(21u))) >> vec4(21u)));
    let _e51 = share;
    let _e57 = share;
    let _e68 = share;
    let _e79 = share;
    let _e90 = share;
    let _e101 = share;
    rise = trunc(((((((vec4(1024f) + (band.early.x * _e51)) + (band.early.y * max((_e57 - vec4(64f)), vec4(0f)))) + (band.early.z * max((_e68 - vec4(256f)), vec4(0f)))) + (band.late.x * max((_e79 - vec4(512f)), vec4(0f)))) + (band.late.y * max((_e90 - vec4(768f)), vec4(0f)))) + (band.late.z * max((_e101 - vec4(960f)), vec4(0f)))));
    let _e117 = u_1;
    let _e119 = u_1;
    bent = trunc((vec4(band.spread.x) + (band.spread.y * trunc(((0.001953125f * _e117) * _e119)))));
    let _e128 = u_1;
    let _e129 = bent;
    let _e131 = w;
    let _e142 = rise;
    angle = (trunc((0.00024414063f * ((_e128 * _e129) + (_e131 * band.spread.z)))) * (vec4(band.widen.x) + (band.widen.y * _e142)));
    let _e149 = angle;
    part_2 = trunc((0.00012207031f * _e149));
    let _e154 = part_2;
    let _e156 = part_2;
    lag = trunc(((0.00048828125f * _e154) * _e156));
    let _e161 = rise;
    let _e163 = rise;
    steep = trunc(((0.0009765625f * _e161) * _e163));
    let _e167 = steep;
    let _e169 = steep;
    let _e171 = lag;
    carried = (_e167 - trunc(((0.0009765625f * _e169) * _e171)));
    let _e176 = rise;
    count = trunc(((scale * _e176) + vec4(half_step)));
    let _e182 = count;
    if (quantum > 1f) {
        local_22 = 0f;
    } else {
        local_22 = (band.low / 16384f);
    }
    let _e191 = local_22;
    let _e193 = carried;
    turning = ((quantum * _e182) - trunc((_e191 * trunc((6.7265625f * _e193)))));
    if normal {
        local_23 = 0.9986f;
    } else {
        local_23 = 0.978f;
    }
    let _e203 = local_23;
    let _e208 = count;
    let _e210 = count;
    k = (((((_e203 * 0.000000000937f) * quantum) * quantum) * _e208) * _e210);
    let _e214 = angle;
    chord = (0.00000011920929f * _e214);
    let _e219 = chord;
    let _e221 = chord;
    cosine = (vec4(1f) - ((0.5f * _e219) * _e221));
    let _e226 = chord;
    let _e229 = chord;
    let _e231 = chord;
    sine = (_e226 * sqrt((vec4(1f) - ((0.25f * _e229) * _e231))));
    let _e238 = turning;
    let _e239 = k;
    let _e241 = cosine;
    let _e244 = sine;
    let _e248 = cosine;
    let _e251 = sine;
    return GaborImplOceanWaves(_e238, _e239, ((heading.x * _e241) - (heading.y * _e244)), ((heading.y * _e248) + (heading.x * _e251)));
}

// Adds a band's four nodes around a point. `quantum` is the spacing of frequencies and its inverse, `least` the square
// of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
fn gabor_impl_add_band(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3<f32>>, band: GaborOceanBand, normal: bool, heading: vec2<f32>, quantum: vec2<f32>, least: f32, cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, seed: u32) {
    var scale_2: f32;
    var half_step_1: f32;
    var lowest: f32;
    var longest: f32;
    var nodes_1: GaborImplOceanNodes;
    var waves: GaborImplOceanWaves;
    var k_1: vec4<f32>;
    var x_6: vec4<f32>;
    var y_4: vec4<f32>;
    var ticks: vec4<u32>;
    var phase_1: vec4<f32>;
    var a_3: vec2<f32>;
    var b_3: vec2<f32>;
    var c_2: vec2<f32>;
    var d: vec2<f32>;
    var steps_x: vec4<f32>;
    var steps_y: vec4<f32>;
    var kept: vec4<f32>;
    var square: vec4<f32>;
    var amplitude_2: vec4<f32>;
    var local_25: vec4<f32>;
    var height: vec4<f32>;
    var along_1: vec4<f32>;
    var steepness: vec4<f32>;
    var squeezed: vec4<f32>;
    var local_26: f32;
    var lost: vec4<f32>;
    scale_2 = ((0.0009765625f * band.low) * quantum.y);
    let _e23 = scale_2;
    half_step_1 = max(0.5f, (1f - (1024f * _e23)));
    let _e30 = scale_2;
    let _e32 = half_step_1;
    lowest = (quantum.x * floor(((1024f * _e30) + _e32)));
    let _e38 = lowest;
    let _e40 = lowest;
    longest = ((0.0000000001486f * _e38) * _e40);
    let _e46 = longest;
    let _e47 = longest;
    if ((band.amplitude == 0f) || (((_e46 * _e47) * least) > 1.6f)) {
        {
            let _e54 = (*sum);
            let _e57 = gabor_impl_slopes_along(band.slopes, heading);
            (*sum).lost = (_e54.lost + _e57);
            return;
        }
    }
    let _e59 = gabor_impl_salt(seed);
    let _e60 = gabor_impl_ocean_nodes(band, cell, local, second, fraction, _e59);
    nodes_1 = _e60;
    let _e62 = nodes_1;
    let _e65 = scale_2;
    let _e66 = half_step_1;
    let _e67 = gabor_impl_ocean_waves(band, _e62.word, normal, heading, quantum.x, _e65, _e66);
    waves = _e67;
    let _e69 = waves;
    k_1 = _e69.k;
    let _e72 = waves;
    x_6 = _e72.heading_x;
    let _e75 = waves;
    y_4 = _e75.heading_y;
    let _e78 = waves;
    let _e84 = nodes_1;
    ticks = (((vec4<u32>(vec4<i32>(_e78.turning)) * u32(second)) + (_e84.word >> vec4(16u))) & vec4(65535u));
    let _e95 = k_1;
    let _e97 = x_6;
    let _e98 = nodes_1;
    let _e101 = y_4;
    let _e102 = nodes_1;
    let _e108 = ticks;
    let _e110 = waves;
    phase_1 = (((0.15915494f * _e95) * ((_e97 * _e98.from_x) + (_e101 * _e102.from_y))) - (0.000015258789f * (vec4<f32>(_e108) + (_e110.turning * fraction))));
    let _e117 = phase_1;
    let _e119 = gabor_impl_wave(_e117.x);
    a_3 = _e119;
    let _e121 = phase_1;
    let _e123 = gabor_impl_wave(_e121.y);
    b_3 = _e123;
    let _e125 = phase_1;
    let _e127 = gabor_impl_wave(_e125.z);
    c_2 = _e127;
    let _e129 = phase_1;
    let _e131 = gabor_impl_wave(_e129.w);
    d = _e131;
    let _e133 = k_1;
    let _e134 = x_6;
    let _e137 = y_4;
    steps_x = (_e133 * ((_e134 * dx.x) + (_e137 * dx.y)));
    let _e143 = k_1;
    let _e144 = x_6;
    let _e147 = y_4;
    steps_y = (_e143 * ((_e144 * dy.x) + (_e147 * dy.y)));
    let _e155 = steps_x;
    let _e156 = steps_x;
    let _e158 = steps_y;
    let _e159 = steps_y;
    kept = exp((-0.125f * ((_e155 * _e156) + (_e158 * _e159))));
    let _e166 = nodes_1;
    square = (0.000015258789f * vec4<f32>((_e166.word & vec4(65535u))));
    let _e174 = kept;
    let _e175 = square;
    amplitude_2 = (_e174 * sqrt(_e175));
    let _e179 = amplitude_2;
    if normal {
        let _e182 = square;
        let _e188 = square;
        local_25 = ((vec4(1.3034767f) + (0.3870924f * _e182)) + (vec4(0.0960481f) / (vec4(1.0580432f) - _e188)));
    } else {
        local_25 = vec4(2f);
    }
    let _e197 = local_25;
    amplitude_2 = (_e179 * _e197);
    let _e199 = amplitude_2;
    let _e200 = a_3;
    let _e202 = b_3;
    let _e204 = c_2;
    let _e206 = d;
    height = (_e199 * vec4<f32>(_e200.y, _e202.y, _e204.y, _e206.y));
    let _e211 = nodes_1;
    let _e213 = amplitude_2;
    let _e215 = a_3;
    let _e217 = b_3;
    let _e219 = c_2;
    let _e221 = d;
    along_1 = ((_e211.window * _e213) * vec4<f32>(_e215.x, _e217.x, _e219.x, _e221.x));
    let _e227 = (*sum);
    let _e229 = height;
    let _e230 = nodes_1;
    let _e233 = height;
    let _e234 = nodes_1;
    (*sum).slope = (_e227.slope + vec2<f32>(dot(_e229, _e230.window_x), dot(_e233, _e234.window_y)));
    let _e239 = height;
    let _e240 = nodes_1;
    height = (_e239 * _e240.window);
    let _e243 = k_1;
    let _e244 = along_1;
    steepness = (_e243 * _e244);
    let _e247 = k_1;
    let _e248 = height;
    squeezed = (_e247 * _e248);
    if normal {
        local_26 = 1.003f;
    } else {
        local_26 = 1.048f;
    }
    let _e254 = local_26;
    let _e255 = nodes_1;
    let _e258 = nodes_1;
    let _e261 = k_1;
    let _e263 = k_1;
    let _e266 = kept;
    let _e267 = kept;
    lost = (((((_e254 * _e255.window) * _e258.window) * _e261) * _e263) * (vec4(1f) - (_e266 * _e267)));
    let _e274 = (*sum);
    let _e276 = height;
    (*sum).height = (_e274.height + dot(_e276, vec4(1f)));
    let _e282 = (*sum);
    let _e284 = steepness;
    let _e285 = x_6;
    let _e287 = steepness;
    let _e288 = y_4;
    (*sum).slope = (_e282.slope + vec2<f32>(dot(_e284, _e285), dot(_e287, _e288)));
    let _e293 = (*sum);
    let _e295 = along_1;
    let _e296 = x_6;
    let _e298 = along_1;
    let _e299 = y_4;
    (*sum).shift = (_e293.shift + vec2<f32>(dot(_e295, _e296), dot(_e298, _e299)));
    let _e303 = (*squeeze);
    let _e304 = squeezed;
    let _e305 = x_6;
    let _e306 = x_6;
    let _e309 = squeezed;
    let _e310 = x_6;
    let _e311 = y_4;
    let _e314 = squeezed;
    (*squeeze) = (_e303 + vec3<f32>(dot(_e304, (_e305 * _e306)), dot(_e309, (_e310 * _e311)), dot(_e314, vec4(1f))));
    let _e321 = (*sum);
    let _e323 = lost;
    let _e324 = x_6;
    let _e325 = x_6;
    let _e328 = lost;
    let _e329 = x_6;
    let _e330 = y_4;
    let _e333 = lost;
    (*sum).lost = (_e321.lost + vec3<f32>(dot(_e323, (_e324 * _e325)), dot(_e328, (_e329 * _e330)), dot(_e333, vec4(1f))));
    return;
}

fn gabor_water_at(cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, ocean: GaborOcean, seed: u32) -> GaborWater {
    var wind_3: vec2<f32>;
    var swell_1: vec2<f32>;
    var water: GaborWater;
    var squeeze_1: vec3<f32> = vec3(0f);
    var local_28: vec2<f32>;
    var quantum_2: vec2<f32>;
    var area: f32;
    var sides: f32;
    var least_1: f32;
    var i_1: i32 = 0i;
    var local_29: i32;
    var remote_2: bool;
    var local_30: vec2<f32>;
    var local_31: i32;
    let _e11 = gabor_impl_wave((0.15915494f * ocean.direction));
    wind_3 = _e11;
    let _e17 = gabor_impl_wave((0.15915494f * ocean.swell.z));
    swell_1 = _e17;
    let _e26 = wind_3;
    let _e27 = gabor_impl_slopes_along(ocean.tail, _e26);
    water = GaborWater(0f, vec2(0f), vec2(0f), 0f, _e27);
    if (ocean.loop_ > 0i) {
        local_28 = vec2<f32>(f32((65536i / max(ocean.loop_, 1i))), (0.000015258789f * f32(ocean.loop_)));
    } else {
        local_28 = vec2(1f);
    }
    let _e50 = local_28;
    quantum_2 = _e50;
    area = ((dx.x * dy.y) - (dx.y * dy.x));
    sides = (dot(dx, dx) + dot(dy, dy));
    let _e65 = area;
    let _e67 = area;
    let _e69 = sides;
    let _e70 = sides;
    let _e71 = sides;
    let _e74 = area;
    let _e76 = area;
    least_1 = (((2f * _e65) * _e67) / max((_e69 + sqrt(max(((_e70 * _e71) - ((4f * _e74) * _e76)), 0f))), 0.000000000000000000000000000001f));
    loop {
        let _e89 = i_1;
        if (ocean.swell.x > 0f) {
            local_29 = 10i;
        } else {
            local_29 = 9i;
        }
        let _e99 = local_29;
        if !((_e89 < _e99)) {
            break;
        }
        {
            let _e105 = i_1;
            remote_2 = (_e105 == 9i);
            let _e111 = i_1;
            let _e114 = remote_2;
            let _e115 = i_1;
            let _e118 = i_1;
            let _e123 = remote_2;
            if _e123 {
                let _e124 = swell_1;
                local_30 = _e124;
            } else {
                let _e125 = wind_3;
                local_30 = _e125;
            }
            let _e127 = local_30;
            let _e128 = quantum_2;
            let _e129 = least_1;
            let _e130 = remote_2;
            if _e130 {
                local_31 = 12i;
            } else {
                let _e132 = i_1;
                local_31 = _e132;
            }
            let _e134 = local_31;
            let _e135 = gabor_lobe_seed(seed, _e134);
            gabor_impl_add_band((&water), (&squeeze_1), ocean.band[_e111], (_e114 || ((_e115 > 0i) && (_e118 < 4i))), _e127, _e128, _e129, cell, local, second, fraction, dx, dy, _e135);
        }
        continuing {
            let _e102 = i_1;
            i_1 = (_e102 + 1i);
        }
    }
    let _e140 = squeeze_1;
    let _e144 = squeeze_1;
    let _e147 = squeeze_1;
    let _e151 = squeeze_1;
    let _e153 = squeeze_1;
    water.fold = (((1f - _e140.x) * ((1f - _e144.z) + _e147.x)) - (_e151.y * _e153.y));
    let _e158 = water;
    let _e161 = water;
    let _e164 = water;
    let _e168 = water;
    water.lost = vec3<f32>(_e158.lost.x, (_e161.lost.z - _e164.lost.x), _e168.lost.y);
    let _e172 = water;
    return _e172;
}

fn gabor_water_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    var cell_5: vec2<f32>;
    var second_6: f32;
    cell_5 = floor(p);
    second_6 = floor(seconds);
    let _e10 = cell_5;
    let _e12 = cell_5;
    let _e14 = second_6;
    let _e16 = second_6;
    let _e18 = gabor_water_at(vec2<i32>(_e10), (p - _e12), i32(_e14), (seconds - _e16), dx, dy, ocean, seed);
    return _e18;
}

fn gabor_water(p: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    let _e8 = gabor_water_filtered(p, vec2(0f), vec2(0f), seconds, ocean, seed);
    return _e8;
}

fn gabor_water_height(p: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> f32 {
    var water_1: GaborWater = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
    var i_2: i32 = 0i;
    loop {
        let _e16 = i_2;
        if !((_e16 < 6i)) {
            break;
        }
        let _e23 = water_1;
        let _e26 = gabor_water((p - _e23.shift), seconds, ocean, seed);
        water_1 = _e26;
        continuing {
            let _e20 = i_2;
            i_2 = (_e20 + 1i);
        }
    }
    let _e27 = water_1;
    return _e27.height;
}

