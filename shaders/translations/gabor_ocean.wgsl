// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest d907a910807740a0.
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

// Waves from one wavelength to half of it. `low`, `early`, `late` and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2<f32>, // variance of the slopes along the band's direction and across it
    exponent: i32, // the spacing of nodes is 2^exponent metres
    low: f32, // 65536 times the lowest frequency in Hz
    early: vec3<f32>, // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next 3/16, 4/16,
    late: vec3<f32>, // 4/16, 3/16 and 1/16
    spread: vec3<f32>, // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1],
    widen: vec2<f32>, // times a linear function of the frequency
    drift: vec2<i32>, // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32, // speed in metres per second, 10 m up
    direction: f32, // where the waves go: radians from +x towards +y
    fetch: f32, // metres of open water upwind, 10^3 to 10^6
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
    fold: f32, // determinant of the derivative of p + shift, within 0.1, or 0.2 for a fetch of 1 km: foam below 0.7
    lost: vec3<f32>, // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
}
// GaborWater gabor_water(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(vec2f p, vec2f dx, vec2f dy, f32 seconds, GaborOcean ocean, u32 seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54], if the sea has neither a swell
//     nor a loop. For a fetch below 20 km in a light wind, JONSWAP's waves alone are steeper, up to 1.8 times. dx and dy are
//     dpdx(p), dpdy(p).
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
    var early: vec3<f32>;
    var late: vec3<f32>;
    var ahead: vec3<f32>;
    var n: i32;
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
        local_12 = i32((1u << u32((log2(f32(clamp(loop_, 8i, 4096i))) + 0.0002f))));
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
            early = vec3(0f);
            late = vec3(0f);
            ahead = vec3<f32>(0.0621f, 0.2483f, 0.4965f);
            n = 0i;
            loop {
                let _e453 = n;
                if !((_e453 < 16i)) {
                    break;
                }
                {
                    let _e460 = tick;
                    let _e461 = width;
                    let _e463 = sum_5;
                    let _e466 = tick;
                    let _e467 = low;
                    let _e468 = n;
                    let _e472 = width;
                    let _e476 = peak_1;
                    let _e477 = scale_1;
                    let _e478 = sharp_1;
                    let _e479 = gabor_impl_spectrum((_e466 * (_e467 + ((f32(_e468) + 0.5f) * _e472))), _e476, _e477, _e478);
                    part_1 = (((_e460 * _e461) / _e463.x) * _e479.x);
                    let _e483 = early;
                    let _e485 = ahead;
                    let _e486 = part_1;
                    early = (_e483 + (26.5f * clamp((_e485 / vec3(max(_e486, 0.000000001f))), vec3(0f), vec3(1f))));
                    let _e498 = late;
                    let _e500 = ahead;
                    let _e506 = part_1;
                    late = (_e498 + (26.5f * clamp(((_e500 + vec3<f32>(0.6827f, 0.6827f, 0.5035f)) / vec3(max(_e506, 0.000000001f))), vec3(0f), vec3(1f))));
                    let _e518 = ahead;
                    let _e519 = part_1;
                    ahead = (_e518 - vec3(_e519));
                }
                continuing {
                    let _e457 = n;
                    n = (_e457 + 1i);
                }
            }
            let _e523 = remote;
            if _e523 {
                let _e525 = ocean;
                let _e529 = ocean;
                local_17 = ((0.0625f * _e525.swell.x) * _e529.swell.x);
            } else {
                let _e533 = low;
                if (_e533 > 262144f) {
                    local_16 = 0f;
                } else {
                    let _e537 = sum_5;
                    local_16 = _e537.x;
                }
                let _e540 = local_16;
                local_17 = _e540;
            }
            let _e542 = local_17;
            tall = _e542;
            let _e545 = tall;
            band.amplitude = sqrt(_e545);
            let _e549 = tall;
            let _e551 = sum_5;
            let _e554 = sum_5;
            let _e557 = along;
            let _e559 = along;
            band.slopes = ((((16.195057f * _e549) * _e551.y) / _e554.x) * vec2<f32>(_e557, (1f - _e559)));
            let _e563 = remote;
            if !(_e563) {
                let _e566 = ocean;
                let _e568 = band;
                ocean.tail = (_e566.tail - _e568.slopes);
            }
            let _e572 = remote;
            if _e572 {
                let _e574 = peak_1;
                let _e575 = peak_1;
                local_19 = i32(floor(log2((18f / (_e574 * _e575)))));
            } else {
                let _e583 = power_1;
                let _e586 = i;
                let _e588 = i;
                let _e591 = i;
                if ((_e588 > 0i) && (_e591 < 4i)) {
                    local_18 = 1i;
                } else {
                    local_18 = -1i;
                }
                let _e599 = local_18;
                local_19 = (((34i - (2i * _e583)) - _e586) + _e599);
            }
            let _e602 = local_19;
            band.exponent = _e602;
            let _e604 = low;
            band.low = _e604;
            let _e606 = early;
            let _e608 = early;
            let _e609 = _e608.xy;
            band.early = (floor((((_e606 - vec3<f32>(0f, _e609.x, _e609.y)) * vec3<f32>(4f, 1.3333333f, 1f)) + vec3(0.5f))) / vec3(256f));
            let _e627 = late;
            let _e628 = early;
            let _e630 = late;
            let _e631 = _e630.xy;
            band.late = (floor((((_e627 - vec3<f32>(_e628.z, _e631.x, _e631.y)) * vec3<f32>(1f, 1.3333333f, 4f)) + vec3(0.5f))) / vec3(256f));
            let _e649 = band;
            let _e651 = band;
            let _e654 = band;
            let _e656 = _e654.late.xy;
            band.late = (_e649.late - vec3<f32>(_e651.early.z, _e656.x, _e656.y));
            let _e662 = band;
            let _e665 = band;
            let _e667 = _e665.early.xy;
            band.early = (_e662.early - vec3<f32>(0f, _e667.x, _e667.y));
            let _e674 = a_2;
            let _e675 = b_2;
            let _e676 = c_1;
            band.spread = (floor((511.5f * vec3<f32>(_e674, _e675, _e676))) * vec3<f32>(8f, 0.00390625f, 8f));
            let _e688 = fit;
            let _e692 = widen;
            let _e695 = widen;
            band.widen = floor((16384f * vec2<f32>((1f - ((_e688.x + 1236f) * _e692)), _e695)));
            let _e699 = ocean;
            if (_e699.loop_ > 0i) {
                local_20 = 0f;
            } else {
                let _e705 = gravity;
                let _e708 = tick;
                let _e710 = low;
                let _e715 = band;
                local_20 = (((32768f * _e705) / (((12.566371f * _e708) * _e710) * 1.1892071f)) * exp2(-(f32(_e715.exponent))));
            }
            let _e722 = local_20;
            speed = _e722;
            let _e725 = speed;
            let _e727 = direction_1;
            let _e729 = gabor_impl_wave((0.15915494f * _e727));
            band.drift = vec2<i32>(floor(((_e725 * _e729) + vec2(0.5f))));
            let _e736 = i;
            let _e739 = band;
            ocean.band[_e736] = _e739;
        }
        continuing {
            let _e113 = i;
            i = (_e113 + 1i);
        }
    }
    let _e741 = ocean;
    ocean.tail = max(_e741.tail, vec2(0f));
    let _e746 = ocean;
    return _e746;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e6 = gabor_ocean_of(wind, 0f, 200000f, vec3(0f), 0i);
    return _e6;
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
    var x_6: vec4<f32>;
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
    drifted = ((second & 32767i) * band.drift);
    up = max(band.exponent, 0i);
    down = max(-(band.exponent), 0i);
    spacing = exp2(f32(band.exponent));
    let _e80 = up;
    let _e90 = spacing;
    let _e93 = drifted;
    let _e108 = salt_4;
    let _e112 = salt_4;
    rest_1 = (((((vec2<f32>((cell & vec2((i32((1u << u32(_e80))) - 1i)))) + local) / vec2(_e90)) - (vec2<f32>((_e93 & vec2(32767i))) / vec2(32768f))) - ((fraction / 32768f) * vec2<f32>(band.drift))) + (vec2<f32>(f32((_e108 & 65535u)), f32((_e112 >> 16u))) / vec2(65536f)));
    let _e122 = rest_1;
    first_1 = floor(_e122);
    let _e125 = rest_1;
    let _e126 = first_1;
    offset = clamp((_e125 - _e126), vec2(0f), vec2(1f));
    let _e134 = up;
    let _e138 = down;
    let _e148 = drifted;
    let _e154 = first_1;
    node = (((((cell >> vec2(u32(_e134))) << vec2(u32(_e138))) - ((second >> 15u) * band.drift)) - (_e148 >> vec2(15u))) + vec2<i32>(_e154));
    let _e159 = offset;
    middle = ((2f * _e159) - vec2(1f));
    let _e165 = middle;
    let _e166 = middle;
    let _e168 = middle;
    let _e170 = middle;
    fourth_2 = (((_e165 * _e166) * _e168) * _e170);
    let _e174 = middle;
    let _e177 = fourth_2;
    turns = (vec2(0.125f) + (_e174 * (vec2(0.15625f) - (0.03125f * _e177))));
    let _e186 = turns;
    let _e188 = gabor_impl_half_turn(_e186.x);
    turn_x = (band.amplitude * _e188);
    let _e191 = turns;
    let _e193 = gabor_impl_half_turn(_e191.y);
    turn_y = _e193;
    let _e196 = spacing;
    let _e199 = fourth_2;
    slope_6 = ((1.9634954f / _e196) * (vec2(1f) - _e199));
    let _e204 = turn_x;
    let _e205 = turn_x;
    along_x_1 = vec4<f32>(_e204.x, _e204.y, _e205.x, _e205.y);
    let _e212 = turn_y;
    let _e213 = _e212.xx;
    let _e214 = turn_y;
    let _e215 = _e214.yy;
    along_y_1 = vec4<f32>(_e213.x, _e213.y, _e215.x, _e215.y);
    let _e222 = along_x_1;
    let _e223 = along_y_1;
    window = (_e222 * _e223);
    let _e226 = slope_6;
    let _e228 = turn_x;
    let _e231 = turn_x;
    let _e233 = turn_x;
    let _e236 = turn_x;
    let _e240 = along_y_1;
    window_x = ((_e226.x * vec4<f32>(-(_e228.y), _e231.x, -(_e233.y), _e236.x)) * _e240);
    let _e243 = slope_6;
    let _e245 = turn_y;
    let _e247 = -(_e245.yy);
    let _e248 = turn_y;
    let _e249 = _e248.xx;
    let _e256 = along_x_1;
    window_y = ((_e243.y * vec4<f32>(_e247.x, _e247.y, _e249.x, _e249.y)) * _e256);
    let _e259 = spacing;
    let _e260 = offset;
    from_x = (_e259 * (vec4(_e260.x) - vec4<f32>(0f, 1f, 0f, 1f)));
    let _e271 = spacing;
    let _e272 = offset;
    from_y = (_e271 * (vec4(_e272.y) - vec4<f32>(0f, 0f, 1f, 1f)));
    let _e283 = node;
    let _e285 = salt_4;
    let _e286 = gabor_impl_line_word(_e283.x, _e285);
    west = _e286;
    let _e288 = node;
    let _e292 = salt_4;
    let _e293 = gabor_impl_line_word((_e288.x + 1i), _e292);
    east = _e293;
    let _e295 = node;
    let _e297 = salt_4;
    let _e300 = gabor_impl_line_word(_e295.y, (_e297 ^ 1540483477u));
    south = _e300;
    let _e302 = node;
    let _e306 = salt_4;
    let _e309 = gabor_impl_line_word((_e302.y + 1i), (_e306 ^ 1540483477u));
    north = _e309;
    let _e311 = south;
    let _e312 = west;
    let _e314 = south;
    let _e315 = east;
    let _e317 = north;
    let _e318 = west;
    let _e320 = north;
    let _e321 = east;
    word_5 = vec4<u32>((_e311 * _e312), (_e314 * _e315), (_e317 * _e318), (_e320 * _e321));
    let _e325 = word_5;
    let _e326 = word_5;
    bits = ((_e325 ^ (_e326 >> vec4(15u))) * 3545902487u);
    let _e334 = bits;
    let _e335 = bits;
    bits = (_e334 ^ (_e335 >> vec4(15u)));
    let _e340 = bits;
    share = vec4<f32>((_e340 >> vec4(22u)));
    let _e346 = bits;
    u_1 = vec4<f32>((vec4<i32>((_e346 << vec4(10u))) >> vec4(21u)));
    let _e357 = bits;
    w = vec4<f32>((vec4<i32>((_e357 << vec4(21u))) >> vec4(21u)));
    let _e371 = share;
    let _e377 = share;
    let _e388 = share;
    let _e399 = share;
    let _e410 = share;
    let _e421 = share;
    rise = trunc(((((((vec4(1024f) + (band.early.x * _e371)) + (band.early.y * max((_e377 - vec4(64f)), vec4(0f)))) + (band.early.z * max((_e388 - vec4(256f)), vec4(0f)))) + (band.late.x * max((_e399 - vec4(512f)), vec4(0f)))) + (band.late.y * max((_e410 - vec4(768f)), vec4(0f)))) + (band.late.z * max((_e421 - vec4(960f)), vec4(0f)))));
    let _e437 = u_1;
    let _e439 = u_1;
    bent = trunc((vec4(band.spread.x) + (band.spread.y * trunc(((0.001953125f * _e437) * _e439)))));
    let _e448 = u_1;
    let _e449 = bent;
    let _e451 = w;
    let _e462 = rise;
    angle = (trunc((0.00024414063f * ((_e448 * _e449) + (_e451 * band.spread.z)))) * (vec4(band.widen.x) + (band.widen.y * _e462)));
    let _e469 = angle;
    part_2 = trunc((0.00012207031f * _e469));
    let _e474 = part_2;
    let _e476 = part_2;
    lag = trunc(((0.00048828125f * _e474) * _e476));
    let _e481 = rise;
    let _e483 = rise;
    steep = trunc(((0.0009765625f * _e481) * _e483));
    let _e487 = steep;
    let _e489 = steep;
    let _e491 = lag;
    carried = (_e487 - trunc(((0.0009765625f * _e489) * _e491)));
    let _e496 = scale_2;
    let _e497 = rise;
    let _e499 = half_step;
    count = trunc(((_e496 * _e497) + vec4(_e499)));
    let _e505 = count;
    if (quantum.x > 1f) {
        local_22 = 0f;
    } else {
        local_22 = (band.low / 16384f);
    }
    let _e515 = local_22;
    let _e517 = carried;
    turning = ((quantum.x * _e505) - trunc((_e515 * trunc((6.7265625f * _e517)))));
    if normal {
        local_23 = 0.9986f;
    } else {
        local_23 = 0.978f;
    }
    let _e527 = local_23;
    let _e534 = count;
    let _e536 = count;
    k = (((((_e527 * 0.000000000937f) * quantum.x) * quantum.x) * _e534) * _e536);
    let _e540 = angle;
    chord = (0.00000011920929f * _e540);
    let _e545 = chord;
    let _e547 = chord;
    cosine = (vec4(1f) - ((0.5f * _e545) * _e547));
    let _e552 = chord;
    let _e555 = chord;
    let _e557 = chord;
    sine = (_e552 * sqrt((vec4(1f) - ((0.25f * _e555) * _e557))));
    let _e565 = cosine;
    let _e568 = sine;
    x_6 = ((heading.x * _e565) - (heading.y * _e568));
    let _e573 = cosine;
    let _e576 = sine;
    y_4 = ((heading.y * _e573) + (heading.x * _e576));
    let _e580 = turning;
    let _e585 = word_5;
    ticks = (((vec4<u32>(vec4<i32>(_e580)) * u32(second)) + (_e585 >> vec4(16u))) & vec4(65535u));
    let _e595 = k;
    let _e597 = x_6;
    let _e598 = from_x;
    let _e600 = y_4;
    let _e601 = from_y;
    let _e606 = ticks;
    let _e608 = turning;
    phase_1 = (((0.15915494f * _e595) * ((_e597 * _e598) + (_e600 * _e601))) - (0.000015258789f * (vec4<f32>(_e606) + (_e608 * fraction))));
    let _e614 = phase_1;
    let _e616 = gabor_impl_wave(_e614.x);
    a_3 = _e616;
    let _e618 = phase_1;
    let _e620 = gabor_impl_wave(_e618.y);
    b_3 = _e620;
    let _e622 = phase_1;
    let _e624 = gabor_impl_wave(_e622.z);
    c_2 = _e624;
    let _e626 = phase_1;
    let _e628 = gabor_impl_wave(_e626.w);
    d = _e628;
    let _e631 = word_5;
    square = (0.000015258789f * vec4<f32>((_e631 & vec4(65535u))));
    let _e638 = k;
    let _e639 = x_6;
    let _e642 = y_4;
    steps_x = (_e638 * ((_e639 * dx.x) + (_e642 * dx.y)));
    let _e648 = k;
    let _e649 = x_6;
    let _e652 = y_4;
    steps_y = (_e648 * ((_e649 * dy.x) + (_e652 * dy.y)));
    let _e660 = steps_x;
    let _e661 = steps_x;
    let _e663 = steps_y;
    let _e664 = steps_y;
    kept = exp((-0.125f * ((_e660 * _e661) + (_e663 * _e664))));
    let _e670 = kept;
    let _e671 = square;
    amplitude_2 = (_e670 * sqrt(_e671));
    let _e675 = amplitude_2;
    if normal {
        let _e678 = square;
        let _e684 = square;
        local_24 = ((vec4(1.3034767f) + (0.3870924f * _e678)) + (vec4(0.0960481f) / (vec4(1.0580432f) - _e684)));
    } else {
        local_24 = vec4(2f);
    }
    let _e693 = local_24;
    amplitude_2 = (_e675 * _e693);
    let _e695 = amplitude_2;
    let _e696 = a_3;
    let _e698 = b_3;
    let _e700 = c_2;
    let _e702 = d;
    height = (_e695 * vec4<f32>(_e696.y, _e698.y, _e700.y, _e702.y));
    let _e707 = window;
    let _e708 = amplitude_2;
    let _e710 = a_3;
    let _e712 = b_3;
    let _e714 = c_2;
    let _e716 = d;
    along_2 = ((_e707 * _e708) * vec4<f32>(_e710.x, _e712.x, _e714.x, _e716.x));
    let _e722 = (*sum);
    let _e724 = height;
    let _e725 = window_x;
    let _e727 = height;
    let _e728 = window_y;
    (*sum).slope = (_e722.slope + vec2<f32>(dot(_e724, _e725), dot(_e727, _e728)));
    let _e732 = height;
    let _e733 = window;
    height = (_e732 * _e733);
    let _e735 = k;
    let _e736 = along_2;
    steepness = (_e735 * _e736);
    let _e739 = k;
    let _e740 = height;
    squeezed = (_e739 * _e740);
    if normal {
        local_25 = 1.003f;
    } else {
        local_25 = 1.048f;
    }
    let _e746 = local_25;
    let _e747 = window;
    let _e749 = window;
    let _e751 = k;
    let _e753 = k;
    let _e756 = kept;
    let _e757 = kept;
    lost = (((((_e746 * _e747) * _e749) * _e751) * _e753) * (vec4(1f) - (_e756 * _e757)));
    let _e764 = (*sum);
    let _e766 = height;
    (*sum).height = (_e764.height + dot(_e766, vec4(1f)));
    let _e772 = (*sum);
    let _e774 = steepness;
    let _e775 = x_6;
    let _e777 = steepness;
    let _e778 = y_4;
    (*sum).slope = (_e772.slope + vec2<f32>(dot(_e774, _e775), dot(_e777, _e778)));
    let _e783 = (*sum);
    let _e785 = along_2;
    let _e786 = x_6;
    let _e788 = along_2;
    let _e789 = y_4;
    (*sum).shift = (_e783.shift + vec2<f32>(dot(_e785, _e786), dot(_e788, _e789)));
    let _e793 = (*squeeze);
    let _e794 = squeezed;
    let _e795 = x_6;
    let _e796 = x_6;
    let _e799 = squeezed;
    let _e800 = x_6;
    let _e801 = y_4;
    let _e804 = squeezed;
    (*squeeze) = (_e793 + vec3<f32>(dot(_e794, (_e795 * _e796)), dot(_e799, (_e800 * _e801)), dot(_e804, vec4(1f))));
    let _e811 = (*sum);
    let _e813 = lost;
    let _e814 = x_6;
    let _e815 = x_6;
    let _e818 = lost;
    let _e819 = x_6;
    let _e820 = y_4;
    let _e823 = lost;
    (*sum).lost = (_e811.lost + vec3<f32>(dot(_e813, (_e814 * _e815)), dot(_e818, (_e819 * _e820)), dot(_e823, vec4(1f))));
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

