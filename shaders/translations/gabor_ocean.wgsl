// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 3b35e5b1e8831697.
// Paste it after gabor_noise.wgsl.
//
// gabor_ocean.wgsl: a sea that never repeats, at any point and time, without textures or state, the same on CPU and GPU.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     GaborOcean sea = gabor_ocean(12.0);                            // a wind of 12 m/s; once per draw, or as a uniform
//     GaborWater w = gabor_water(p, 60.5, sea, 7u);                  // p in metres, after 60.5 seconds
//     vec2f place = p + w.shift;                                      // of the water, at the height w.height
//
// I want water under a pixel: gabor_water_filtered. A boat's height: gabor_water_height. A world of any size, or months of
// time: gabor_water_at. Another direction or fetch, a swell, or a film that loops: gabor_ocean_of.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Waves from one wavelength to half of it. `low`, the steps and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2<f32>, // variance of the slopes along the band's direction and across it
    exponent: i32, // the spacing of nodes is 2^exponent metres
    low: f32, // 65536 times the lowest frequency in Hz
    steps: vec4<f32>, // how fast the frequency rises in the first eighth of the power, and how much faster in the next three quarters
    last_step: f32, // and in the last eighth
    spread: vec3<f32>, // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1],
    widen: vec2<f32>, // times a linear function of the frequency
    drift: vec2<i32>, // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32, // speed in metres per second, 10 m up
    direction: f32, // where the waves go: radians from +x towards +y
    fetch: f32, // metres of open water upwind
    swell: vec3<f32>, // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    loop_: i32, // the seconds after which all repeats, or 0 for never
    tail: vec2<f32>, // variance of the slopes of waves shorter than all bands, along the wind and across it
    band: array<GaborOceanBand, 10>, // the swell is the last
}
// GaborOcean gabor_ocean(f32 wind)
// GaborOcean gabor_ocean_of(f32 wind, f32 direction, f32 fetch, vec3f swell, i32 loop)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] and the directions of [HDE80]. A swell, from a remote storm, has a narrow spread of directions and a sharp
//     peak [G10]; vec3f(0.0) is none. For films, all repeats after a loop of 8, 16, 32 ... 4096 seconds, to which other values are
//     rounded down. Its price: groups of waves stand still, and each wave's period becomes an integer fraction of it, so a loop
//     should last several periods of the swell. Compute a sea once, on the CPU if the CPU also asks for heights: the integers
//     may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    height: f32, // metres, of mean 0 and normally distributed
    slope: vec2<f32>, // derivatives of the height by p
    shift: vec2<f32>, // horizontal displacement in metres, towards crests, which it sharpens
    fold: f32, // determinant of the derivative of p + shift, within 0.1: foam where it falls below 0.7
    lost: vec3<f32>, // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
}
// GaborWater gabor_water(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(vec2f p, vec2f dx, vec2f dy, f32 seconds, GaborOcean ocean, u32 seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54], if the sea has neither a swell
//     nor a loop. dx and dy are dpdx(p), dpdy(p).
// f32 gabor_water_height(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.
// GaborWater gabor_water_at(vec2i cell, vec2f local, i32 second, f32 fraction, vec2f dx, vec2f dy, GaborOcean ocean, u32 seed)
//     At the position cell + local in metres, second + fraction in seconds: exact for years and anywhere. dx and dy of
//     vec2f(0.0) do not filter.

// [HBB73] Hasselmann and others, "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project",
// 1973. [HDE80] Hasselmann, Dunckel, Ewing, "Directional wave spectra observed during JONSWAP 1973", 1980. [G10] Goda, "Random
// seas", 2010. [CM54] Cox, Munk, "Measurement of the roughness of the sea surface from photographs of the sun's glitter", 1954.

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

fn gabor_impl_spectrum(f: f32, peak: f32, scale: f32, sharp: f32) -> vec2<f32> {
    var below: f32;
    var local_11: f32;
    var apart: f32;
    below = ((peak * peak) / (f * f));
    if (f < peak) {
        local_11 = 0.07f;
    } else {
        local_11 = 0.09f;
    }
    let _e15 = local_11;
    apart = (((f / peak) - 1f) / _e15);
    let _e21 = apart;
    let _e23 = apart;
    let _e28 = below;
    let _e30 = below;
    return (((scale / f) * exp(((sharp * exp(((-0.5f * _e21) * _e23))) - ((1.25f * _e28) * _e30)))) * vec2<f32>((1f / (((f * f) * f) * f)), 1f));
}

fn gabor_ocean_of(wind: f32, direction: f32, fetch: f32, swell: vec3<f32>, loop_: i32) -> GaborOcean {
    var direction_1: f32;
    var gravity: f32 = 9.81f;
    var tick: f32 = 0.000015258789f;
    var ocean: GaborOcean;
    var local_12: i32;
    var reach_1: f32;
    var peak_1: f32;
    var scale_1: f32;
    var sharp_1: f32 = 1.1939225f;
    var power_1: i32;
    var i: i32 = 0i;
    var local_13: u32;
    var low: f32;
    var remote: bool;
    var width: f32;
    var variance: f32;
    var sum_5: vec2<f32>;
    var fit: vec4<f32>;
    var j_1: i32;
    var f_1: f32;
    var x_5: f32;
    var above: f32;
    var local_14: f32;
    var local_15: f32;
    var s_2: f32;
    var here: f32;
    var part: vec2<f32>;
    var deviation: f32;
    var narrow: f32;
    var c_1: f32;
    var widen: f32;
    var most: f32;
    var end: f32;
    var rest: f32;
    var a_2: f32;
    var b_2: f32;
    var fourth_1: f32;
    var along: f32;
    var knots: vec4<f32>;
    var ahead: vec4<f32>;
    var j_2: i32;
    var part_1: f32;
    var band: GaborOceanBand;
    var local_16: f32;
    var local_17: f32;
    var tall: f32;
    var local_18: i32;
    var local_19: i32;
    var local_20: f32;
    var speed: f32;
    direction_1 = direction;
    ocean.wind = clamp(wind, 2f, 30f);
    let _e16 = direction_1;
    ocean.direction = _e16;
    ocean.fetch = clamp(fetch, 1000f, 1000000f);
    ocean.swell = vec3<f32>(clamp(swell.x, 0f, 30f), clamp(swell.y, 5f, 25f), swell.z);
    if (loop_ > 0i) {
        local_12 = i32((1u << u32((log2(f32(clamp(loop_, 8i, 4096i))) + 0.01f))));
    } else {
        local_12 = 0i;
    }
    let _e48 = local_12;
    ocean.loop_ = _e48;
    let _e49 = gravity;
    let _e50 = ocean;
    let _e53 = ocean;
    let _e55 = ocean;
    reach_1 = ((_e49 * _e50.fetch) / (_e53.wind * _e55.wind));
    let _e61 = gravity;
    let _e63 = ocean;
    let _e66 = reach_1;
    peak_1 = (((3.5f * _e61) / _e63.wind) * pow(_e66, -0.33f));
    let _e73 = reach_1;
    let _e78 = gravity;
    let _e80 = gravity;
    scale_1 = ((((0.076f * pow(_e73, -0.22f)) * _e78) * _e80) / 1558.5455f);
    let _e88 = peak_1;
    let _e90 = tick;
    power_1 = i32(floor(log2(((0.62f * _e88) / _e90))));
    let _e100 = ocean;
    ocean.tail = ((vec2<f32>(0.00316f, 0.00192f) * _e100.wind) + vec2<f32>(0f, 0.003f));
    loop {
        let _e109 = i;
        if !((_e109 <= 9i)) {
            break;
        }
        {
            let _e116 = i;
            if ((_e116 & 1i) == 0i) {
                local_13 = 128u;
            } else {
                local_13 = 181u;
            }
            let _e124 = local_13;
            let _e125 = power_1;
            let _e126 = i;
            low = (f32((_e124 << u32((_e125 + (_e126 / 2i))))) / 128f);
            let _e136 = i;
            remote = (_e136 == 9i);
            let _e140 = remote;
            if _e140 {
                {
                    let _e142 = ocean;
                    peak_1 = (1f / _e142.swell.y);
                    let _e148 = peak_1;
                    let _e150 = tick;
                    low = (64f * floor((((0.0132813f * _e148) / _e150) + 0.5f)));
                    sharp_1 = 2.0794415f;
                    let _e157 = ocean;
                    direction_1 = _e157.swell.z;
                }
            }
            let _e161 = low;
            width = (0.025878906f * _e161);
            variance = 0f;
            sum_5 = vec2(0f);
            fit = vec4(0f);
            j_1 = 0i;
            loop {
                let _e174 = j_1;
                if !((_e174 < 16i)) {
                    break;
                }
                {
                    let _e181 = tick;
                    let _e182 = low;
                    let _e183 = j_1;
                    let _e187 = width;
                    f_1 = (_e181 * (_e182 + ((f32(_e183) + 0.5f) * _e187)));
                    let _e193 = j_1;
                    x_5 = ((26.5f * f32(_e193)) - 198.75f);
                    let _e199 = f_1;
                    let _e200 = peak_1;
                    above = (_e199 / _e200);
                    let _e203 = remote;
                    if _e203 {
                        local_15 = 75f;
                    } else {
                        let _e206 = above;
                        let _e207 = above;
                        if (_e207 < 1f) {
                            local_14 = 4.06f;
                        } else {
                            local_14 = -2.34f;
                        }
                        let _e214 = local_14;
                        local_15 = (9.77f * pow(_e206, _e214));
                    }
                    let _e218 = local_15;
                    s_2 = _e218;
                    let _e221 = s_2;
                    here = (0.5f / (_e221 + 1f));
                    let _e226 = tick;
                    let _e227 = width;
                    let _e229 = f_1;
                    let _e230 = peak_1;
                    let _e231 = scale_1;
                    let _e232 = sharp_1;
                    let _e233 = gabor_impl_spectrum(_e229, _e230, _e231, _e232);
                    part = ((_e226 * _e227) * _e233);
                    let _e236 = sum_5;
                    let _e237 = part;
                    sum_5 = (_e236 + _e237);
                    let _e239 = variance;
                    let _e240 = part;
                    let _e242 = here;
                    variance = (_e239 + (_e240.x * _e242));
                    let _e245 = fit;
                    let _e246 = part;
                    let _e248 = x_5;
                    let _e249 = here;
                    let _e251 = x_5;
                    let _e252 = x_5;
                    let _e254 = x_5;
                    let _e255 = here;
                    fit = (_e245 + (_e246.x * vec4<f32>(_e248, sqrt(_e249), (_e251 * _e252), (_e254 * sqrt(_e255)))));
                }
                continuing {
                    let _e178 = j_1;
                    j_1 = (_e178 + 1i);
                }
            }
            let _e261 = variance;
            let _e262 = sum_5;
            variance = (_e261 / _e262.x);
            let _e265 = fit;
            let _e266 = sum_5;
            fit = (_e265 / vec4(_e266.x));
            let _e270 = variance;
            deviation = sqrt(_e270);
            let _e274 = variance;
            narrow = ((0.5f / _e274) - 1.8f);
            let _e280 = deviation;
            let _e282 = narrow;
            c_1 = ((0.9f * _e280) * clamp(_e282, 0f, 1f));
            let _e289 = narrow;
            let _e294 = fit;
            let _e296 = fit;
            let _e298 = fit;
            let _e303 = fit;
            let _e305 = fit;
            let _e307 = fit;
            let _e311 = deviation;
            widen = ((clamp((0.3f * _e289), 0f, 1f) * (_e294.w - (_e296.x * _e298.y))) / ((_e303.z - (_e305.x * _e307.x)) * _e311));
            let _e316 = widen;
            widen = (floor((clamp((16384f * _e316), -32f, 32f) + 0.5f)) / 16384f);
            let _e330 = widen;
            let _e334 = fit;
            let _e336 = widen;
            most = (1f / ((1f + (212f * abs(_e330))) - (_e334.x * _e336)));
            let _e342 = deviation;
            let _e344 = most;
            let _e345 = c_1;
            end = min((1.8f * _e342), (_e344 - _e345));
            let _e349 = variance;
            let _e350 = c_1;
            let _e351 = c_1;
            rest = (_e349 - ((_e350 * _e351) / 3f));
            let _e358 = rest;
            let _e361 = end;
            let _e363 = end;
            let _e370 = end;
            a_2 = ((sqrt(max(((0.3047619f * _e358) - ((0.0304762f * _e361) * _e363)), 0f)) - (0.1142857f * _e370)) / 0.152381f);
            let _e376 = end;
            let _e377 = a_2;
            b_2 = (_e376 - _e377);
            let _e380 = a_2;
            let _e381 = a_2;
            let _e383 = a_2;
            let _e386 = a_2;
            let _e389 = b_2;
            let _e393 = b_2;
            let _e394 = b_2;
            let _e397 = a_2;
            let _e399 = a_2;
            let _e402 = a_2;
            let _e404 = b_2;
            let _e408 = b_2;
            let _e410 = b_2;
            let _e415 = c_1;
            let _e416 = c_1;
            let _e419 = rest;
            let _e422 = c_1;
            let _e424 = c_1;
            fourth_1 = (((((_e380 * _e381) * _e383) * ((0.2f * _e386) + (0.5714286f * _e389))) + ((_e393 * _e394) * ((((0.6666667f * _e397) * _e399) + ((0.36363637f * _e402) * _e404)) + ((0.07692308f * _e408) * _e410)))) + ((_e415 * _e416) * ((2f * _e419) + ((0.2f * _e422) * _e424))));
            let _e432 = variance;
            let _e436 = fourth_1;
            along = ((1f - (4f * _e432)) + (4f * _e436));
            knots = vec4(0f);
            ahead = vec4<f32>(0.1236f, 0.3709f, 0.6181f, 0.8654f);
            j_2 = 0i;
            loop {
                let _e451 = j_2;
                if !((_e451 < 16i)) {
                    break;
                }
                {
                    let _e458 = tick;
                    let _e459 = width;
                    let _e461 = sum_5;
                    let _e464 = tick;
                    let _e465 = low;
                    let _e466 = j_2;
                    let _e470 = width;
                    let _e474 = peak_1;
                    let _e475 = scale_1;
                    let _e476 = sharp_1;
                    let _e477 = gabor_impl_spectrum((_e464 * (_e465 + ((f32(_e466) + 0.5f) * _e470))), _e474, _e475, _e476);
                    part_1 = (((_e458 * _e459) / _e461.x) * _e477.x);
                    let _e481 = knots;
                    let _e483 = ahead;
                    let _e484 = part_1;
                    knots = (_e481 + (26.5f * clamp((_e483 / vec4(max(_e484, 0.000000001f))), vec4(0f), vec4(1f))));
                    let _e496 = ahead;
                    let _e497 = part_1;
                    ahead = (_e496 - vec4(_e497));
                }
                continuing {
                    let _e455 = j_2;
                    j_2 = (_e455 + 1i);
                }
            }
            let _e501 = remote;
            if _e501 {
                let _e503 = ocean;
                let _e507 = ocean;
                local_17 = ((0.0625f * _e503.swell.x) * _e507.swell.x);
            } else {
                let _e511 = low;
                if (_e511 > 262144f) {
                    local_16 = 0f;
                } else {
                    let _e515 = sum_5;
                    local_16 = _e515.x;
                }
                let _e518 = local_16;
                local_17 = _e518;
            }
            let _e520 = local_17;
            tall = _e520;
            let _e523 = tall;
            band.amplitude = sqrt(_e523);
            let _e527 = tall;
            let _e529 = sum_5;
            let _e532 = sum_5;
            let _e535 = along;
            let _e537 = along;
            band.slopes = ((((16.195057f * _e527) * _e529.y) / _e532.x) * vec2<f32>(_e535, (1f - _e537)));
            let _e541 = remote;
            if !(_e541) {
                let _e544 = ocean;
                let _e546 = band;
                ocean.tail = (_e544.tail - _e546.slopes);
            }
            let _e550 = remote;
            if _e550 {
                let _e552 = peak_1;
                let _e553 = peak_1;
                local_19 = i32(floor(log2((18f / (_e552 * _e553)))));
            } else {
                let _e561 = power_1;
                let _e564 = i;
                let _e566 = i;
                let _e569 = i;
                if ((_e566 > 0i) && (_e569 < 4i)) {
                    local_18 = 1i;
                } else {
                    local_18 = -1i;
                }
                let _e577 = local_18;
                local_19 = (((34i - (2i * _e561)) - _e564) + _e577);
            }
            let _e580 = local_19;
            band.exponent = _e580;
            let _e582 = low;
            band.low = _e582;
            let _e584 = knots;
            let _e586 = knots;
            let _e587 = _e586.xyz;
            band.steps = (floor((((_e584 - vec4<f32>(0f, _e587.x, _e587.y, _e587.z)) * vec4<f32>(2f, 1f, 1f, 1f)) + vec4(0.5f))) / vec4(256f));
            let _e609 = knots;
            let _e618 = band;
            band.last_step = ((floor(((2f * (424f - _e609.w)) + 0.5f)) / 256f) - _e618.steps.w);
            let _e623 = band;
            let _e626 = band;
            let _e628 = _e626.steps.xyz;
            band.steps = (_e623.steps - vec4<f32>(0f, _e628.x, _e628.y, _e628.z));
            let _e636 = a_2;
            let _e637 = b_2;
            let _e638 = c_1;
            band.spread = (floor((511.5f * vec3<f32>(_e636, _e637, _e638))) * vec3<f32>(8f, 0.00390625f, 8f));
            let _e650 = fit;
            let _e654 = widen;
            let _e657 = widen;
            band.widen = floor((16384f * vec2<f32>((1f - ((_e650.x + 1236f) * _e654)), _e657)));
            let _e661 = ocean;
            if (_e661.loop_ > 0i) {
                local_20 = 0f;
            } else {
                let _e667 = gravity;
                let _e670 = tick;
                let _e672 = low;
                let _e677 = band;
                local_20 = (((32768f * _e667) / (((12.566371f * _e670) * _e672) * 1.1892071f)) * exp2(-(f32(_e677.exponent))));
            }
            let _e684 = local_20;
            speed = _e684;
            let _e687 = speed;
            let _e689 = direction_1;
            let _e691 = gabor_impl_wave((0.15915494f * _e689));
            band.drift = vec2<i32>(floor(((_e687 * _e691) + vec2(0.5f))));
            let _e698 = i;
            let _e701 = band;
            ocean.band[_e698] = _e701;
        }
        continuing {
            let _e113 = i;
            i = (_e113 + 1i);
        }
    }
    let _e703 = ocean;
    ocean.tail = max(_e703.tail, vec2(0f));
    let _e708 = ocean;
    return _e708;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e6 = gabor_ocean_of(wind, 0f, 200000f, vec3(0f), 0i);
    return _e6;
}

fn gabor_impl_whole(x: vec4<f32>) -> vec4<f32> {
    return trunc(x);
}

fn gabor_impl_slopes_along(variances: vec2<f32>, along: vec2<f32>) -> vec3<f32> {
    let _e11 = ((((variances.x - variances.y) * along.x) * along) + vec2<f32>(variances.y, 0f));
    return vec3<f32>(_e11.x, _e11.y, (variances.x + variances.y));
}

// Adds a band's four nodes around a point, together, which CPUs do faster. `quantum` is the spacing of frequencies and its inverse,
// `least` the square of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
fn gabor_impl_add_band(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3<f32>>, band: GaborOceanBand, normal: bool, heading: vec2<f32>, quantum: vec2<f32>, least: f32, cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, seed: u32) {
    var scale_2: f32;
    var half_step: f32;
    var lowest: f32;
    var longest: f32;
    var salt_4: u32;
    var drifted: vec2<i32>;
    var up: i32;
    var down: i32;
    var spacing: f32;
    var rest_1: vec2<f32>;
    var first_1: vec2<f32>;
    var offset: vec2<f32>;
    var node: vec2<i32>;
    var middle: vec2<f32>;
    var fourth_2: vec2<f32>;
    var turns: vec2<f32>;
    var turn_x: vec2<f32>;
    var turn_y: vec2<f32>;
    var slope_6: vec2<f32>;
    var along_x_1: vec4<f32>;
    var along_y_1: vec4<f32>;
    var window: vec4<f32>;
    var window_x: vec4<f32>;
    var window_y: vec4<f32>;
    var from_x: vec4<f32>;
    var from_y: vec4<f32>;
    var west: u32;
    var east: u32;
    var south: u32;
    var north: u32;
    var word_5: vec4<u32>;
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
    var x_7: vec4<f32>;
    var y_4: vec4<f32>;
    var ticks: vec4<u32>;
    var phase_1: vec4<f32>;
    var a_3: vec2<f32>;
    var b_3: vec2<f32>;
    var c_2: vec2<f32>;
    var d: vec2<f32>;
    var square: vec4<f32>;
    var steps_x: vec4<f32>;
    var steps_y: vec4<f32>;
    var kept: vec4<f32>;
    var amplitude_2: vec4<f32>;
    var local_24: vec4<f32>;
    var height: vec4<f32>;
    var along_2: vec4<f32>;
    var steepness: vec4<f32>;
    var squeezed: vec4<f32>;
    var local_25: f32;
    var lost: vec4<f32>;
    scale_2 = ((0.0009765625f * band.low) * quantum.y);
    let _e23 = scale_2;
    half_step = max(0.5f, (1f - (1024f * _e23)));
    let _e30 = scale_2;
    let _e32 = half_step;
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
    salt_4 = _e59;
    drifted = ((second & 65535i) * band.drift);
    up = max(band.exponent, 0i);
    down = max(-(band.exponent), 0i);
    spacing = exp2(f32(band.exponent));
    let _e80 = up;
    let _e89 = spacing;
    let _e92 = drifted;
    let _e107 = salt_4;
    let _e111 = salt_4;
    rest_1 = (((((vec2<f32>((cell & vec2(((1i << u32(_e80)) - 1i)))) + local) / vec2(_e89)) - (vec2<f32>((_e92 & vec2(32767i))) / vec2(32768f))) - ((fraction / 32768f) * vec2<f32>(band.drift))) + (vec2<f32>(f32((_e107 & 65535u)), f32((_e111 >> 16u))) / vec2(65536f)));
    let _e121 = rest_1;
    first_1 = floor(_e121);
    let _e124 = rest_1;
    let _e125 = first_1;
    offset = clamp((_e124 - _e125), vec2(0f), vec2(1f));
    let _e133 = up;
    let _e137 = down;
    let _e149 = drifted;
    let _e155 = first_1;
    node = (((((cell >> vec2(u32(_e133))) << vec2(u32(_e137))) - ((2i * (second >> 16u)) * band.drift)) - (_e149 >> vec2(15u))) + vec2<i32>(_e155));
    let _e160 = offset;
    middle = ((2f * _e160) - vec2(1f));
    let _e166 = middle;
    let _e167 = middle;
    let _e169 = middle;
    let _e171 = middle;
    fourth_2 = (((_e166 * _e167) * _e169) * _e171);
    let _e175 = middle;
    let _e178 = fourth_2;
    turns = (vec2(0.125f) + (_e175 * (vec2(0.15625f) - (0.03125f * _e178))));
    let _e187 = turns;
    let _e189 = gabor_impl_half_turn(_e187.x);
    turn_x = (band.amplitude * _e189);
    let _e192 = turns;
    let _e194 = gabor_impl_half_turn(_e192.y);
    turn_y = _e194;
    let _e197 = spacing;
    let _e200 = fourth_2;
    slope_6 = ((1.9634954f / _e197) * (vec2(1f) - _e200));
    let _e205 = turn_x;
    let _e206 = turn_x;
    along_x_1 = vec4<f32>(_e205.x, _e205.y, _e206.x, _e206.y);
    let _e213 = turn_y;
    let _e214 = _e213.xx;
    let _e215 = turn_y;
    let _e216 = _e215.yy;
    along_y_1 = vec4<f32>(_e214.x, _e214.y, _e216.x, _e216.y);
    let _e223 = along_x_1;
    let _e224 = along_y_1;
    window = (_e223 * _e224);
    let _e227 = slope_6;
    let _e229 = turn_x;
    let _e232 = turn_x;
    let _e234 = turn_x;
    let _e237 = turn_x;
    let _e241 = along_y_1;
    window_x = ((_e227.x * vec4<f32>(-(_e229.y), _e232.x, -(_e234.y), _e237.x)) * _e241);
    let _e244 = slope_6;
    let _e246 = turn_y;
    let _e248 = -(_e246.yy);
    let _e249 = turn_y;
    let _e250 = _e249.xx;
    let _e257 = along_x_1;
    window_y = ((_e244.y * vec4<f32>(_e248.x, _e248.y, _e250.x, _e250.y)) * _e257);
    let _e260 = spacing;
    let _e261 = offset;
    from_x = (_e260 * (vec4(_e261.x) - vec4<f32>(0f, 1f, 0f, 1f)));
    let _e272 = spacing;
    let _e273 = offset;
    from_y = (_e272 * (vec4(_e273.y) - vec4<f32>(0f, 0f, 1f, 1f)));
    let _e284 = node;
    let _e286 = salt_4;
    let _e287 = gabor_impl_line_word(_e284.x, _e286);
    west = _e287;
    let _e289 = node;
    let _e293 = salt_4;
    let _e294 = gabor_impl_line_word((_e289.x + 1i), _e293);
    east = _e294;
    let _e296 = node;
    let _e298 = salt_4;
    let _e301 = gabor_impl_line_word(_e296.y, (_e298 ^ 1540483477u));
    south = _e301;
    let _e303 = node;
    let _e307 = salt_4;
    let _e310 = gabor_impl_line_word((_e303.y + 1i), (_e307 ^ 1540483477u));
    north = _e310;
    let _e312 = south;
    let _e313 = west;
    let _e315 = south;
    let _e316 = east;
    let _e318 = north;
    let _e319 = west;
    let _e321 = north;
    let _e322 = east;
    word_5 = vec4<u32>((_e312 * _e313), (_e315 * _e316), (_e318 * _e319), (_e321 * _e322));
    let _e326 = word_5;
    let _e327 = word_5;
    bits = ((_e326 ^ (_e327 >> vec4(15u))) * 3545902487u);
    let _e335 = bits;
    let _e336 = bits;
    bits = (_e335 ^ (_e336 >> vec4(15u)));
    let _e341 = bits;
    share = vec4<f32>((_e341 >> vec4(22u)));
    let _e347 = bits;
    u_1 = vec4<f32>((vec4<i32>((_e347 << vec4(10u))) >> vec4(21u)));
    let _e358 = bits;
    w = vec4<f32>((vec4<i32>((_e358 << vec4(21u))) >> vec4(21u)));
    let _e372 = share;
    let _e378 = share;
    let _e389 = share;
    let _e400 = share;
    let _e410 = share;
    let _e419 = gabor_impl_whole((((((vec4(1024f) + (band.steps.x * _e372)) + (band.steps.y * max((_e378 - vec4(128f)), vec4(0f)))) + (band.steps.z * max((_e389 - vec4(384f)), vec4(0f)))) + (band.steps.w * max((_e400 - vec4(640f)), vec4(0f)))) + (band.last_step * max((_e410 - vec4(896f)), vec4(0f)))));
    rise = _e419;
    let _e426 = u_1;
    let _e428 = u_1;
    let _e430 = gabor_impl_whole(((0.001953125f * _e426) * _e428));
    let _e434 = gabor_impl_whole((vec4(band.spread.x) + (band.spread.y * _e430)));
    bent = _e434;
    let _e437 = u_1;
    let _e438 = bent;
    let _e440 = w;
    let _e446 = gabor_impl_whole((0.00024414063f * ((_e437 * _e438) + (_e440 * band.spread.z))));
    let _e451 = rise;
    angle = (_e446 * (vec4(band.widen.x) + (band.widen.y * _e451)));
    let _e458 = angle;
    let _e460 = gabor_impl_whole((0.00012207031f * _e458));
    part_2 = _e460;
    let _e463 = part_2;
    let _e465 = part_2;
    let _e467 = gabor_impl_whole(((0.00048828125f * _e463) * _e465));
    lag = _e467;
    let _e470 = rise;
    let _e472 = rise;
    let _e474 = gabor_impl_whole(((0.0009765625f * _e470) * _e472));
    steep = _e474;
    let _e476 = steep;
    let _e478 = steep;
    let _e480 = lag;
    let _e482 = gabor_impl_whole(((0.0009765625f * _e478) * _e480));
    carried = (_e476 - _e482);
    let _e485 = scale_2;
    let _e486 = rise;
    let _e488 = half_step;
    let _e491 = gabor_impl_whole(((_e485 * _e486) + vec4(_e488)));
    count = _e491;
    let _e494 = count;
    if (quantum.x > 1f) {
        local_22 = 0f;
    } else {
        local_22 = (band.low / 16384f);
    }
    let _e504 = local_22;
    let _e506 = carried;
    let _e508 = gabor_impl_whole((6.7265625f * _e506));
    let _e510 = gabor_impl_whole((_e504 * _e508));
    turning = ((quantum.x * _e494) - _e510);
    if normal {
        local_23 = 0.9986f;
    } else {
        local_23 = 0.978f;
    }
    let _e516 = local_23;
    let _e523 = count;
    let _e525 = count;
    k = (((((_e516 * 0.000000000937f) * quantum.x) * quantum.x) * _e523) * _e525);
    let _e529 = angle;
    chord = (0.00000011920929f * _e529);
    let _e534 = chord;
    let _e536 = chord;
    cosine = (vec4(1f) - ((0.5f * _e534) * _e536));
    let _e541 = chord;
    let _e544 = chord;
    let _e546 = chord;
    sine = (_e541 * sqrt((vec4(1f) - ((0.25f * _e544) * _e546))));
    let _e554 = cosine;
    let _e557 = sine;
    x_7 = ((heading.x * _e554) - (heading.y * _e557));
    let _e562 = cosine;
    let _e565 = sine;
    y_4 = ((heading.y * _e562) + (heading.x * _e565));
    let _e569 = turning;
    let _e574 = word_5;
    ticks = (((vec4<u32>(vec4<i32>(_e569)) * u32(second)) + (_e574 >> vec4(16u))) & vec4(65535u));
    let _e584 = k;
    let _e586 = x_7;
    let _e587 = from_x;
    let _e589 = y_4;
    let _e590 = from_y;
    let _e595 = ticks;
    let _e597 = turning;
    phase_1 = (((0.15915494f * _e584) * ((_e586 * _e587) + (_e589 * _e590))) - (0.000015258789f * (vec4<f32>(_e595) + (_e597 * fraction))));
    let _e603 = phase_1;
    let _e605 = gabor_impl_wave(_e603.x);
    a_3 = _e605;
    let _e607 = phase_1;
    let _e609 = gabor_impl_wave(_e607.y);
    b_3 = _e609;
    let _e611 = phase_1;
    let _e613 = gabor_impl_wave(_e611.z);
    c_2 = _e613;
    let _e615 = phase_1;
    let _e617 = gabor_impl_wave(_e615.w);
    d = _e617;
    let _e620 = word_5;
    square = (0.000015258789f * vec4<f32>((_e620 & vec4(65535u))));
    let _e627 = k;
    let _e628 = x_7;
    let _e631 = y_4;
    steps_x = (_e627 * ((_e628 * dx.x) + (_e631 * dx.y)));
    let _e637 = k;
    let _e638 = x_7;
    let _e641 = y_4;
    steps_y = (_e637 * ((_e638 * dy.x) + (_e641 * dy.y)));
    let _e649 = steps_x;
    let _e650 = steps_x;
    let _e652 = steps_y;
    let _e653 = steps_y;
    kept = exp((-0.125f * ((_e649 * _e650) + (_e652 * _e653))));
    let _e659 = kept;
    let _e660 = square;
    amplitude_2 = (_e659 * sqrt(_e660));
    let _e664 = amplitude_2;
    if normal {
        let _e667 = square;
        let _e673 = square;
        local_24 = ((vec4(1.3034767f) + (0.3870924f * _e667)) + (vec4(0.0960481f) / (vec4(1.0580432f) - _e673)));
    } else {
        local_24 = vec4(2f);
    }
    let _e682 = local_24;
    amplitude_2 = (_e664 * _e682);
    let _e684 = amplitude_2;
    let _e685 = a_3;
    let _e687 = b_3;
    let _e689 = c_2;
    let _e691 = d;
    height = (_e684 * vec4<f32>(_e685.y, _e687.y, _e689.y, _e691.y));
    let _e696 = window;
    let _e697 = amplitude_2;
    let _e699 = a_3;
    let _e701 = b_3;
    let _e703 = c_2;
    let _e705 = d;
    along_2 = ((_e696 * _e697) * vec4<f32>(_e699.x, _e701.x, _e703.x, _e705.x));
    let _e711 = (*sum);
    let _e713 = height;
    let _e714 = window_x;
    let _e716 = height;
    let _e717 = window_y;
    (*sum).slope = (_e711.slope + vec2<f32>(dot(_e713, _e714), dot(_e716, _e717)));
    let _e721 = height;
    let _e722 = window;
    height = (_e721 * _e722);
    let _e724 = k;
    let _e725 = along_2;
    steepness = (_e724 * _e725);
    let _e728 = k;
    let _e729 = height;
    squeezed = (_e728 * _e729);
    if normal {
        local_25 = 1.003f;
    } else {
        local_25 = 1.048f;
    }
    let _e735 = local_25;
    let _e736 = window;
    let _e738 = window;
    let _e740 = k;
    let _e742 = k;
    let _e745 = kept;
    let _e746 = kept;
    lost = (((((_e735 * _e736) * _e738) * _e740) * _e742) * (vec4(1f) - (_e745 * _e746)));
    let _e753 = (*sum);
    let _e755 = height;
    (*sum).height = (_e753.height + dot(_e755, vec4(1f)));
    let _e761 = (*sum);
    let _e763 = steepness;
    let _e764 = x_7;
    let _e766 = steepness;
    let _e767 = y_4;
    (*sum).slope = (_e761.slope + vec2<f32>(dot(_e763, _e764), dot(_e766, _e767)));
    let _e772 = (*sum);
    let _e774 = along_2;
    let _e775 = x_7;
    let _e777 = along_2;
    let _e778 = y_4;
    (*sum).shift = (_e772.shift + vec2<f32>(dot(_e774, _e775), dot(_e777, _e778)));
    let _e782 = (*squeeze);
    let _e783 = squeezed;
    let _e784 = x_7;
    let _e785 = x_7;
    let _e788 = squeezed;
    let _e789 = x_7;
    let _e790 = y_4;
    let _e793 = squeezed;
    (*squeeze) = (_e782 + vec3<f32>(dot(_e783, (_e784 * _e785)), dot(_e788, (_e789 * _e790)), dot(_e793, vec4(1f))));
    let _e800 = (*sum);
    let _e802 = lost;
    let _e803 = x_7;
    let _e804 = x_7;
    let _e807 = lost;
    let _e808 = x_7;
    let _e809 = y_4;
    let _e812 = lost;
    (*sum).lost = (_e800.lost + vec3<f32>(dot(_e802, (_e803 * _e804)), dot(_e807, (_e808 * _e809)), dot(_e812, vec4(1f))));
    return;
}

fn gabor_water_at(cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, ocean: GaborOcean, seed: u32) -> GaborWater {
    var wind_2: vec2<f32>;
    var swell_1: vec2<f32>;
    var water: GaborWater;
    var squeeze_1: vec3<f32> = vec3(0f);
    var local_27: vec2<f32>;
    var quantum_1: vec2<f32>;
    var area: f32;
    var sides: f32;
    var least_1: f32;
    var i_1: i32 = 0i;
    var local_28: i32;
    var remote_1: bool;
    var local_29: vec2<f32>;
    var local_30: i32;
    let _e11 = gabor_impl_wave((0.15915494f * ocean.direction));
    wind_2 = _e11;
    let _e17 = gabor_impl_wave((0.15915494f * ocean.swell.z));
    swell_1 = _e17;
    let _e26 = wind_2;
    let _e27 = gabor_impl_slopes_along(ocean.tail, _e26);
    water = GaborWater(0f, vec2(0f), vec2(0f), 0f, _e27);
    if (ocean.loop_ > 0i) {
        local_27 = vec2<f32>(f32((65536i / max(ocean.loop_, 1i))), (0.000015258789f * f32(ocean.loop_)));
    } else {
        local_27 = vec2(1f);
    }
    let _e50 = local_27;
    quantum_1 = _e50;
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
            local_28 = 10i;
        } else {
            local_28 = 9i;
        }
        let _e99 = local_28;
        if !((_e89 < _e99)) {
            break;
        }
        {
            let _e105 = i_1;
            remote_1 = (_e105 == 9i);
            let _e111 = i_1;
            let _e114 = remote_1;
            let _e115 = i_1;
            let _e118 = i_1;
            let _e123 = remote_1;
            if _e123 {
                let _e124 = swell_1;
                local_29 = _e124;
            } else {
                let _e125 = wind_2;
                local_29 = _e125;
            }
            let _e127 = local_29;
            let _e128 = quantum_1;
            let _e129 = least_1;
            let _e130 = remote_1;
            if _e130 {
                local_30 = 12i;
            } else {
                let _e132 = i_1;
                local_30 = _e132;
            }
            let _e134 = local_30;
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
    var cell_4: vec2<f32>;
    var second_4: f32;
    cell_4 = floor(p);
    second_4 = floor(seconds);
    let _e10 = cell_4;
    let _e12 = cell_4;
    let _e14 = second_4;
    let _e16 = second_4;
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

