// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 889abcf058de8108.
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

// Waves from one wavelength to half of it. `low`, `quarter` and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2<f32>, // variance of the slopes along the band's direction and across it
    exponent: i32, // the spacing of nodes is 2^exponent metres
    low: f32, // 65536 times the lowest frequency in Hz
    quarter: vec4<f32>, // the ranges of frequency that have a quarter of the power each, in 1/1024 of the lowest frequency
    spread: vec3<f32>, // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1], here
    widen: vec2<f32>, // times 4092, times a linear function of the frequency, here times 16384
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
//     spectrum [HBB73] and the directions of [HDE80]. A swell, from a remote storm, has a narrow spread of directions
//     and a sharp peak [G10]; vec3f(0.0) is none. For films, all repeats after a loop of 8, 16, 32 ... 4096 seconds, to which other
//     values are rounded down. Its price: groups of waves stand still, and each wave's period becomes an integer
//     fraction of it, so a loop should last several periods of the swell. Compute a sea once, on the CPU if the CPU also asks
//     for heights: the integers may round differently on another device. To change a member, call this again.

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

fn gabor_impl_spectrum(f: f32, peak: f32, scale: f32, sharp: f32) -> vec2<f32> {
    var below: f32;
    var local_11: f32;
    var apart: f32;
    var squares: f32;
    below = (peak / f);
    if (f < peak) {
        local_11 = 0.07f;
    } else {
        local_11 = 0.09f;
    }
    let _e13 = local_11;
    apart = (((f / peak) - 1f) / _e13);
    squares = (((f * f) * f) * f);
    let _e20 = below;
    let _e21 = below;
    below = (_e20 * _e21);
    let _e26 = apart;
    let _e28 = apart;
    let _e33 = below;
    let _e35 = below;
    let _e41 = squares;
    return (((scale / f) * exp(((sharp * exp(((-0.5f * _e26) * _e28))) - ((1.25f * _e33) * _e35)))) * vec2<f32>((1f / _e41), 1f));
}

// The position in a band, from 0 to 424, below which this share of the power lies. `sums` are powers up to the ends of four
// intervals, `starts` and `ends` the densities at their ends; in between, the density is linear.
fn gabor_impl_quantile(share: f32, sums: vec4<f32>, starts: vec4<f32>, ends: vec4<f32>) -> f32 {
    var share_1: f32;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var found: vec4<f32>;
    var rest: f32;
    var start: f32;
    var within_1: f32;
    var local_15: f32;
    var local_16: f32;
    var local_17: f32;
    share_1 = share;
    let _e5 = share_1;
    share_1 = (_e5 * sums.w);
    let _e8 = share_1;
    if (_e8 < sums.x) {
        local_14 = vec4<f32>(0f, sums.x, starts.x, ends.x);
    } else {
        let _e16 = share_1;
        if (_e16 < sums.y) {
            let _e19 = sums.xy;
            local_13 = vec4<f32>(_e19.x, _e19.y, starts.y, ends.y);
        } else {
            let _e25 = share_1;
            if (_e25 < sums.z) {
                let _e28 = sums.yz;
                local_12 = vec4<f32>(_e28.x, _e28.y, starts.z, ends.z);
            } else {
                let _e34 = sums.zw;
                local_12 = vec4<f32>(_e34.x, _e34.y, starts.w, ends.w);
            }
            let _e41 = local_12;
            local_13 = _e41;
        }
        let _e43 = local_13;
        local_14 = _e43;
    }
    let _e45 = local_14;
    found = _e45;
    let _e47 = share_1;
    let _e48 = found;
    let _e51 = found;
    let _e53 = found;
    rest = ((_e47 - _e48.x) / (_e51.y - _e53.x));
    let _e59 = found;
    let _e62 = found;
    let _e64 = found;
    start = ((2f * _e59.z) / (_e62.z + _e64.w));
    let _e70 = rest;
    let _e72 = start;
    let _e73 = start;
    let _e74 = start;
    let _e78 = start;
    let _e81 = rest;
    within_1 = ((2f * _e70) / (_e72 + sqrt(max(((_e73 * _e74) + ((4f * (1f - _e78)) * _e81)), 0f))));
    let _e91 = within_1;
    let _e92 = share_1;
    if (_e92 < sums.x) {
        local_17 = 0f;
    } else {
        let _e96 = share_1;
        if (_e96 < sums.y) {
            local_16 = 1f;
        } else {
            let _e100 = share_1;
            if (_e100 < sums.z) {
                local_15 = 2f;
            } else {
                local_15 = 3f;
            }
            let _e106 = local_15;
            local_16 = _e106;
        }
        let _e108 = local_16;
        local_17 = _e108;
    }
    let _e110 = local_17;
    return (106f * (_e91 + _e110));
}

fn gabor_ocean_of(wind: f32, direction: f32, fetch: f32, swell: vec3<f32>, loop_: i32) -> GaborOcean {
    var direction_1: f32;
    var gravity: f32 = 9.81f;
    var tick: f32 = 0.000015258789f;
    var ocean: GaborOcean;
    var local_18: i32;
    var reach_1: f32;
    var peak_1: f32;
    var scale_1: f32;
    var sharp_1: f32 = 1.1939225f;
    var power_1: i32;
    var i: i32 = 0i;
    var local_19: u32;
    var low: f32;
    var remote: bool;
    var width: f32;
    var variance: f32;
    var sum_5: vec2<f32>;
    var first_1: vec2<f32>;
    var sums_2: vec4<f32>;
    var starts_1: vec4<f32>;
    var ends_1: vec4<f32>;
    var fit: vec4<f32>;
    var j_1: i32;
    var f_1: f32;
    var step_: f32;
    var x_5: f32;
    var middle: vec2<f32>;
    var last: vec2<f32>;
    var part: vec2<f32>;
    var above: f32;
    var local_20: f32;
    var local_21: f32;
    var s_2: f32;
    var here: f32;
    var deviation: f32;
    var narrow: f32;
    var c_1: f32;
    var widen: f32;
    var most: f32;
    var end: f32;
    var rest_1: f32;
    var a_2: f32;
    var b_2: f32;
    var fourth_1: f32;
    var along: f32;
    var speed: f32;
    var quartile: vec3<f32>;
    var band: GaborOceanBand;
    var local_22: f32;
    var local_23: f32;
    var tall: f32;
    var local_24: i32;
    var local_25: i32;
    var local_26: f32;
    direction_1 = direction;
    ocean.wind = clamp(wind, 2f, 30f);
    let _e16 = direction_1;
    ocean.direction = _e16;
    ocean.fetch = clamp(fetch, 1000f, 1000000f);
    ocean.swell = vec3<f32>(clamp(swell.x, 0f, 30f), clamp(swell.y, 5f, 25f), swell.z);
    if (loop_ > 0i) {
        local_18 = i32((1u << u32((log2(f32(clamp(loop_, 8i, 4096i))) + 0.01f))));
    } else {
        local_18 = 0i;
    }
    let _e48 = local_18;
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
                local_19 = 128u;
            } else {
                local_19 = 181u;
            }
            let _e124 = local_19;
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
            width = (0.10351562f * _e161);
            variance = 0f;
            sum_5 = vec2(0f);
            let _e169 = tick;
            let _e170 = low;
            let _e172 = peak_1;
            let _e173 = scale_1;
            let _e174 = sharp_1;
            let _e175 = gabor_impl_spectrum((_e169 * _e170), _e172, _e173, _e174);
            first_1 = _e175;
            sums_2 = vec4(0f);
            starts_1 = vec4(0f);
            ends_1 = vec4(0f);
            fit = vec4(0f);
            j_1 = 0i;
            loop {
                let _e191 = j_1;
                if !((_e191 < 4i)) {
                    break;
                }
                {
                    let _e198 = tick;
                    let _e199 = low;
                    let _e200 = j_1;
                    let _e202 = width;
                    f_1 = (_e198 * (_e199 + (f32(_e200) * _e202)));
                    let _e207 = tick;
                    let _e208 = width;
                    step_ = (_e207 * _e208);
                    let _e212 = j_1;
                    x_5 = ((106f * f32(_e212)) - 159f);
                    let _e218 = f_1;
                    let _e220 = step_;
                    let _e223 = peak_1;
                    let _e224 = scale_1;
                    let _e225 = sharp_1;
                    let _e226 = gabor_impl_spectrum((_e218 + (0.5f * _e220)), _e223, _e224, _e225);
                    middle = _e226;
                    let _e228 = f_1;
                    let _e229 = step_;
                    let _e231 = peak_1;
                    let _e232 = scale_1;
                    let _e233 = sharp_1;
                    let _e234 = gabor_impl_spectrum((_e228 + _e229), _e231, _e232, _e233);
                    last = _e234;
                    let _e236 = step_;
                    let _e239 = first_1;
                    let _e241 = middle;
                    let _e244 = last;
                    part = ((_e236 / 6f) * ((_e239 + (4f * _e241)) + _e244));
                    let _e248 = sum_5;
                    let _e249 = part;
                    sum_5 = (_e248 + _e249);
                    let _e251 = f_1;
                    let _e253 = step_;
                    let _e256 = peak_1;
                    above = ((_e251 + (0.5f * _e253)) / _e256);
                    let _e259 = remote;
                    if _e259 {
                        local_21 = 75f;
                    } else {
                        let _e262 = above;
                        let _e263 = above;
                        if (_e263 < 1f) {
                            local_20 = 4.06f;
                        } else {
                            local_20 = -2.34f;
                        }
                        let _e270 = local_20;
                        local_21 = (9.77f * pow(_e262, _e270));
                    }
                    let _e274 = local_21;
                    s_2 = _e274;
                    let _e277 = s_2;
                    here = (0.5f / (_e277 + 1f));
                    let _e282 = variance;
                    let _e283 = part;
                    let _e285 = here;
                    variance = (_e282 + (_e283.x * _e285));
                    let _e288 = fit;
                    let _e289 = part;
                    let _e291 = x_5;
                    let _e292 = here;
                    let _e294 = x_5;
                    let _e295 = x_5;
                    let _e297 = x_5;
                    let _e298 = here;
                    fit = (_e288 + (_e289.x * vec4<f32>(_e291, sqrt(_e292), (_e294 * _e295), (_e297 * sqrt(_e298)))));
                    let _e304 = sums_2;
                    let _e305 = _e304.yzw;
                    let _e306 = sum_5;
                    sums_2 = vec4<f32>(_e305.x, _e305.y, _e305.z, _e306.x);
                    let _e312 = starts_1;
                    let _e313 = _e312.yzw;
                    let _e314 = first_1;
                    starts_1 = vec4<f32>(_e313.x, _e313.y, _e313.z, _e314.x);
                    let _e320 = ends_1;
                    let _e321 = _e320.yzw;
                    let _e322 = last;
                    ends_1 = vec4<f32>(_e321.x, _e321.y, _e321.z, _e322.x);
                    let _e328 = last;
                    first_1 = _e328;
                }
                continuing {
                    let _e195 = j_1;
                    j_1 = (_e195 + 1i);
                }
            }
            let _e329 = variance;
            let _e330 = sum_5;
            variance = (_e329 / _e330.x);
            let _e333 = fit;
            let _e334 = sum_5;
            fit = (_e333 / vec4(_e334.x));
            let _e338 = variance;
            deviation = sqrt(_e338);
            let _e342 = variance;
            narrow = ((0.5f / _e342) - 1.8f);
            let _e348 = deviation;
            let _e350 = narrow;
            c_1 = ((0.9f * _e348) * clamp(_e350, 0f, 1f));
            let _e357 = narrow;
            let _e362 = fit;
            let _e364 = fit;
            let _e366 = fit;
            let _e371 = fit;
            let _e373 = fit;
            let _e375 = fit;
            let _e379 = deviation;
            widen = ((clamp((0.3f * _e357), 0f, 1f) * (_e362.w - (_e364.x * _e366.y))) / ((_e371.z - (_e373.x * _e375.x)) * _e379));
            let _e385 = widen;
            widen = (0.000061035156f * floor((clamp((16384f * _e385), -32f, 32f) + 0.5f)));
            let _e398 = widen;
            let _e402 = fit;
            let _e404 = widen;
            most = (1f / ((1f + (212f * abs(_e398))) - (_e402.x * _e404)));
            let _e410 = deviation;
            let _e412 = most;
            let _e413 = c_1;
            end = min((1.8f * _e410), (_e412 - _e413));
            let _e417 = variance;
            let _e418 = c_1;
            let _e419 = c_1;
            rest_1 = (_e417 - ((_e418 * _e419) / 3f));
            let _e426 = rest_1;
            let _e429 = end;
            let _e431 = end;
            let _e438 = end;
            a_2 = ((sqrt(max(((0.3047619f * _e426) - ((0.0304762f * _e429) * _e431)), 0f)) - (0.1142857f * _e438)) / 0.152381f);
            let _e444 = end;
            let _e445 = a_2;
            b_2 = (_e444 - _e445);
            let _e448 = a_2;
            let _e449 = a_2;
            let _e451 = a_2;
            let _e454 = a_2;
            let _e457 = b_2;
            let _e461 = b_2;
            let _e462 = b_2;
            let _e465 = a_2;
            let _e467 = a_2;
            let _e470 = a_2;
            let _e472 = b_2;
            let _e476 = b_2;
            let _e478 = b_2;
            let _e483 = c_1;
            let _e484 = c_1;
            let _e487 = rest_1;
            let _e490 = c_1;
            let _e492 = c_1;
            fourth_1 = (((((_e448 * _e449) * _e451) * ((0.2f * _e454) + (0.5714286f * _e457))) + ((_e461 * _e462) * ((((0.6666667f * _e465) * _e467) + ((0.36363637f * _e470) * _e472)) + ((0.07692308f * _e476) * _e478)))) + ((_e483 * _e484) * ((2f * _e487) + ((0.2f * _e490) * _e492))));
            let _e500 = variance;
            let _e504 = fourth_1;
            along = ((1f - (4f * _e500)) + (4f * _e504));
            let _e508 = gravity;
            let _e510 = tick;
            let _e512 = low;
            speed = (_e508 / (((12.566371f * _e510) * _e512) * 1.1892071f));
            let _e519 = sums_2;
            let _e520 = starts_1;
            let _e521 = ends_1;
            let _e522 = gabor_impl_quantile(0.2443f, _e519, _e520, _e521);
            let _e524 = sums_2;
            let _e525 = starts_1;
            let _e526 = ends_1;
            let _e527 = gabor_impl_quantile(0.4885f, _e524, _e525, _e526);
            let _e529 = sums_2;
            let _e530 = starts_1;
            let _e531 = ends_1;
            let _e532 = gabor_impl_quantile(0.7328f, _e529, _e530, _e531);
            quartile = floor((vec3<f32>(_e522, _e527, _e532) + vec3(0.5f)));
            let _e540 = remote;
            if _e540 {
                let _e542 = ocean;
                let _e546 = ocean;
                local_23 = ((0.0625f * _e542.swell.x) * _e546.swell.x);
            } else {
                let _e550 = low;
                if (_e550 > 262144f) {
                    local_22 = 0f;
                } else {
                    let _e554 = sum_5;
                    local_22 = _e554.x;
                }
                let _e557 = local_22;
                local_23 = _e557;
            }
            let _e559 = local_23;
            tall = _e559;
            let _e562 = tall;
            band.amplitude = sqrt(_e562);
            let _e566 = tall;
            let _e568 = sum_5;
            let _e571 = sum_5;
            let _e574 = along;
            let _e576 = along;
            band.slopes = ((((16.195057f * _e566) * _e568.y) / _e571.x) * vec2<f32>(_e574, (1f - _e576)));
            let _e580 = remote;
            if !(_e580) {
                let _e583 = ocean;
                let _e585 = band;
                ocean.tail = (_e583.tail - _e585.slopes);
            }
            let _e589 = remote;
            if _e589 {
                let _e591 = peak_1;
                let _e592 = peak_1;
                local_25 = i32(floor(log2((9f / (_e591 * _e592)))));
            } else {
                let _e600 = power_1;
                let _e603 = i;
                let _e605 = i;
                let _e608 = i;
                if ((_e605 > 0i) && (_e608 < 4i)) {
                    local_24 = 0i;
                } else {
                    local_24 = 1i;
                }
                let _e615 = local_24;
                local_25 = (((34i - (2i * _e600)) - _e603) - _e615);
            }
            let _e618 = local_25;
            band.exponent = _e618;
            let _e620 = low;
            band.low = _e620;
            let _e622 = quartile;
            let _e629 = quartile;
            band.quarter = (vec4<f32>(_e622.x, _e622.y, _e622.z, 424f) - vec4<f32>(0f, _e629.x, _e629.y, _e629.z));
            let _e637 = a_2;
            let _e638 = b_2;
            let _e639 = c_1;
            band.spread = floor((4092f * vec3<f32>(_e637, _e638, _e639)));
            let _e646 = fit;
            let _e648 = widen;
            let _e651 = widen;
            band.widen = floor((16384f * vec2<f32>((1f - (_e646.x * _e648)), _e651)));
            let _e655 = speed;
            let _e656 = ocean;
            if (_e656.loop_ > 0i) {
                local_26 = 0f;
            } else {
                let _e662 = band;
                local_26 = (32768f * exp2(-(f32(_e662.exponent))));
            }
            let _e669 = local_26;
            speed = (_e655 * _e669);
            let _e672 = speed;
            let _e674 = direction_1;
            let _e676 = gabor_impl_wave((0.15915494f * _e674));
            band.drift = vec2<i32>(floor(((_e672 * _e676) + vec2(0.5f))));
            let _e683 = i;
            let _e686 = band;
            ocean.band[_e683] = _e686;
        }
        continuing {
            let _e113 = i;
            i = (_e113 + 1i);
        }
    }
    let _e688 = ocean;
    ocean.tail = max(_e688.tail, vec2(0f));
    let _e693 = ocean;
    return _e693;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e6 = gabor_ocean_of(wind, 0f, 200000f, vec3(0f), 0i);
    return _e6;
}

// The whole part of x >= 0. For it, C++ compilers have no fast floor.
fn gabor_impl_whole(x: f32) -> f32 {
    return floor(x);
}

// Adds a node's wave. `from` is the offset from the node in metres, `window` is (value, derivatives). `wave` is the wave number of
// rise 1, in turns per metre. The first parts of `shape` make an amplitude normal, as in gabor_impl_amplitude, or uniform; the
// last is its deviation, times k / wave. `quantum` is (65536 / loop, loop / 65536), or 0. `squeeze` collects the derivatives of the shift. It and
// `lost` have the parts xx, xy and xx + yy.
fn gabor_impl_add_water(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3<f32>>, word: u32, from_: vec2<f32>, window: vec3<f32>, band: GaborOceanBand, heading: vec2<f32>, quantum: vec2<f32>, wave: f32, shape: vec3<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>) {
    var bits: u32;
    var share_2: f32;
    var below_1: vec4<f32>;
    var rise: f32;
    var u_1: f32;
    var v: f32;
    var bent: f32;
    var side_1: f32;
    var angle: f32;
    var part_1: f32;
    var lag: f32;
    var steep: f32;
    var carried: f32;
    var turning: f32;
    var k: f32;
    var around: f32;
    var local_27: f32;
    var chord: f32;
    var unit: vec2<f32>;
    var turns: f32;
    var uniforms: vec2<f32>;
    var amplitude_2: vec2<f32>;
    var z_1: vec2<f32>;
    var steps: vec2<f32>;
    var kept: f32;
    var along_1: vec2<f32>;
    var squares_1: vec3<f32>;
    var power_2: f32;
    bits = ((word ^ (word >> 15u)) * 3545902487u);
    let _e20 = bits;
    let _e21 = bits;
    bits = (_e20 ^ (_e21 >> 15u));
    let _e26 = bits;
    share_2 = (0.00390625f * f32((_e26 >> 22u)));
    let _e33 = share_2;
    below_1 = (band.quarter * clamp((vec4(_e33) - vec4<f32>(0f, 1f, 2f, 3f)), vec4(0f), vec4(1f)));
    let _e49 = below_1;
    let _e52 = below_1;
    let _e55 = below_1;
    let _e58 = below_1;
    let _e61 = gabor_impl_whole(((((1024f + _e49.x) + _e52.y) + _e55.z) + _e58.w));
    rise = _e61;
    let _e64 = bits;
    u_1 = ((2f * f32(((_e64 >> 11u) & 2047u))) - 2047f);
    let _e75 = bits;
    v = ((2f * f32((_e75 & 2047u))) - 2047f);
    let _e90 = u_1;
    let _e92 = u_1;
    let _e94 = gabor_impl_whole(((0.00048828125f * _e90) * _e92));
    let _e97 = gabor_impl_whole((band.spread.x + ((0.00048828125f * band.spread.y) * _e94)));
    bent = _e97;
    let _e99 = u_1;
    let _e100 = bent;
    let _e102 = v;
    side_1 = ((_e99 * _e100) + (_e102 * band.spread.z));
    let _e109 = side_1;
    let _e112 = gabor_impl_whole((0.00012207031f * abs(_e109)));
    let _e117 = rise;
    angle = (_e112 * (band.widen.x + (band.widen.y * (_e117 - 1236f))));
    let _e125 = angle;
    let _e127 = gabor_impl_whole((0.00012207031f * _e125));
    part_1 = _e127;
    let _e130 = part_1;
    let _e132 = part_1;
    let _e134 = gabor_impl_whole(((0.00048828125f * _e130) * _e132));
    lag = _e134;
    let _e137 = rise;
    let _e139 = rise;
    let _e141 = gabor_impl_whole(((0.0009765625f * _e137) * _e139));
    steep = _e141;
    let _e143 = steep;
    let _e145 = steep;
    let _e147 = lag;
    let _e149 = gabor_impl_whole(((0.0009765625f * _e145) * _e147));
    carried = (_e143 - _e149);
    let _e154 = rise;
    let _e157 = carried;
    let _e161 = gabor_impl_whole((0.0078125f * ((2048f * _e154) - (861f * _e157))));
    let _e166 = gabor_impl_whole((_e161 * (0.000061035156f * band.low)));
    turning = _e166;
    if (quantum.x > 0f) {
        {
            let _e172 = rise;
            let _e181 = gabor_impl_whole(((_e172 * ((0.0009765625f * band.low) * quantum.y)) + 0.5f));
            turning = (quantum.x * max(_e181, 1f));
            let _e186 = turning;
            rise = ((1024f * _e186) / band.low);
        }
    }
    let _e190 = rise;
    let _e192 = rise;
    k = ((wave * _e190) * _e192);
    let _e196 = k;
    around = (6.2831855f * _e196);
    let _e199 = side_1;
    if (_e199 < 0f) {
        local_27 = -0.00000011920929f;
    } else {
        local_27 = 0.00000011920929f;
    }
    let _e206 = local_27;
    let _e207 = angle;
    chord = (_e206 * _e207);
    let _e212 = chord;
    let _e214 = chord;
    let _e217 = chord;
    let _e220 = chord;
    let _e222 = chord;
    let _e228 = gabor_impl_product(heading, vec2<f32>((1f - ((0.5f * _e212) * _e214)), (_e217 * sqrt((1f - ((0.25f * _e220) * _e222))))));
    unit = _e228;
    let _e230 = turning;
    let _e241 = turning;
    turns = (f32((((u32(_e230) & 65535u) * (u32(second) & 65535u)) & 65535u)) + (_e241 * fraction));
    uniforms = vec2<f32>(f32(i32(word)), f32(i32((word << 12u))));
    let _e253 = uniforms;
    let _e255 = uniforms;
    let _e264 = uniforms;
    let _e265 = uniforms;
    amplitude_2 = ((_e253 - (shape.x * clamp(_e255, vec2(-2011925800f), vec2(2011925800f)))) * ((_e264 * _e265) + vec2(shape.y)));
    let _e272 = amplitude_2;
    let _e273 = k;
    let _e274 = unit;
    let _e278 = turns;
    let _e281 = gabor_impl_wave(((_e273 * dot(_e274, from_)) - (0.000015258789f * _e278)));
    let _e282 = gabor_impl_product(_e272, _e281);
    z_1 = _e282;
    let _e284 = around;
    let _e285 = unit;
    let _e287 = unit;
    steps = (_e284 * vec2<f32>(dot(_e285, dx), dot(_e287, dy)));
    let _e294 = steps;
    let _e295 = steps;
    kept = exp((-0.125f * dot(_e294, _e295)));
    let _e300 = z_1;
    let _e301 = kept;
    z_1 = (_e300 * _e301);
    let _e304 = (*sum);
    let _e306 = z_1;
    (*sum).slope = (_e304.slope + (_e306.y * window.yz));
    let _e311 = z_1;
    z_1 = (_e311 * window.x);
    let _e314 = z_1;
    let _e316 = unit;
    along_1 = (_e314.x * _e316);
    let _e319 = unit;
    let _e321 = unit;
    let _e322 = (_e319.x * _e321);
    squares_1 = vec3<f32>(_e322.x, _e322.y, 1f);
    let _e331 = around;
    power_2 = ((shape.z * window.x) * _e331);
    let _e335 = (*sum);
    let _e337 = z_1;
    (*sum).height = (_e335.height + _e337.y);
    let _e341 = (*sum);
    let _e343 = around;
    let _e344 = along_1;
    (*sum).slope = (_e341.slope + (_e343 * _e344));
    let _e348 = (*sum);
    let _e350 = along_1;
    (*sum).shift = (_e348.shift + _e350);
    let _e352 = (*squeeze);
    let _e353 = around;
    let _e354 = z_1;
    let _e357 = squares_1;
    (*squeeze) = (_e352 + ((_e353 * _e354.y) * _e357));
    let _e361 = (*sum);
    let _e363 = power_2;
    let _e364 = power_2;
    let _e367 = kept;
    let _e368 = kept;
    let _e372 = squares_1;
    (*sum).lost = (_e361.lost + (((_e363 * _e364) * (1f - (_e367 * _e368))) * _e372));
    return;
}

// Splits 2^-exponent (cell + local) - drift (second + fraction) into a whole number and a rest, exactly.
fn gabor_impl_float_by(cell: i32, local: f32, exponent: i32, drift: i32, second: i32, fraction: f32, whole: ptr<function, i32>, rest: ptr<function, f32>) {
    var high: i32;
    var low_1: i32;
    var up: i32;
    var down: i32;
    high = ((second >> 16u) * drift);
    low_1 = ((second & 65535i) * drift);
    let _e19 = high;
    let _e21 = low_1;
    (*whole) = ((-2i * _e19) - (_e21 >> 15u));
    let _e26 = low_1;
    (*rest) = ((-(f32((_e26 & 32767i))) / 32768f) - ((f32(drift) / 32768f) * fraction));
    up = max(exponent, 0i);
    down = max(-(exponent), 0i);
    let _e45 = (*whole);
    let _e46 = up;
    let _e49 = down;
    (*whole) = (_e45 + ((cell >> u32(_e46)) << u32(_e49)));
    let _e53 = (*rest);
    let _e55 = up;
    (*rest) = (_e53 + ((f32((cell & (i32((1u << u32(_e55))) - 1i))) + local) * exp2(-(f32(exponent)))));
    return;
}

// The windows of three nodes, or two, along an axis. `x` is in node spacings from the first node.
fn gabor_impl_water_windows(three: bool, x: f32, value: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>) {
    var s_3: f32;
    var scale_2: f32;
    if three {
        {
            gabor_impl_windows((x - 1f), value, slope);
            let _e10 = (*slope);
            (*slope) = (_e10 / vec4(1.5f));
            return;
        }
    } else {
        {
            s_3 = ((x * x) * (3f - (2f * x)));
            let _e26 = s_3;
            let _e29 = s_3;
            scale_2 = inverseSqrt((1f - ((2f * _e26) * (1f - _e29))));
            let _e35 = scale_2;
            let _e37 = s_3;
            let _e39 = s_3;
            (*value) = (_e35 * vec4<f32>((1f - _e37), _e39, 0f, 0f));
            let _e49 = scale_2;
            let _e51 = scale_2;
            let _e53 = scale_2;
            let _e55 = s_3;
            let _e58 = s_3;
            (*slope) = ((((((6f * x) * (1f - x)) * _e49) * _e51) * _e53) * vec4<f32>(-(_e55), (1f - _e58), 0f, 0f));
            return;
        }
    }
}

// The parts xx, xy and xx + yy of a covariance with these variances along a unit vector and across it.
fn gabor_impl_slopes_along(variances: vec2<f32>, along: vec2<f32>) -> vec3<f32> {
    let _e11 = ((((variances.x - variances.y) * along.x) * along) + vec2<f32>(variances.y, 0f));
    return vec3<f32>(_e11.x, _e11.y, (variances.x + variances.y));
}

// Adds a band with three nodes along each axis, or two. `least` is the square of a pixel's shorter side.
fn gabor_impl_add_band(water: ptr<function, GaborWater>, squeeze: ptr<function, vec3<f32>>, band: GaborOceanBand, three: bool, heading: vec2<f32>, quantum: vec2<f32>, least: f32, cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, seed: u32) {
    var local_30: f32;
    var lowest: f32;
    var longest: f32;
    var salt_4: u32;
    var whole_x: i32;
    var whole_y: i32;
    var rest_x: f32;
    var rest_y: f32;
    var rest_3: vec2<f32>;
    var local_31: f32;
    var inset: f32;
    var spacing: f32;
    var local_32: f32;
    var local_33: f32;
    var energy: f32;
    var first_2: vec2<f32>;
    var offset: vec2<f32>;
    var node: vec2<i32>;
    var x_8: vec4<f32>;
    var y_4: vec4<f32>;
    var slope_x: vec4<f32>;
    var slope_y: vec4<f32>;
    var local_34: f32;
    var deviation_1: f32;
    var local_35: vec3<f32>;
    var shape_1: vec3<f32>;
    var f_2: f32;
    var local_36: f32;
    var wave_6: f32;
    var left: u32;
    var middle_1: u32;
    var right: u32;
    var from_1: vec2<f32>;
    var j_2: i32 = 0i;
    var local_37: i32;
    var row_1: u32;
    var local_38: vec2<f32>;
    var local_39: vec2<f32>;
    var w: vec2<f32>;
    if (quantum.x > 0f) {
        local_30 = (quantum.x * max(floor(((band.low * quantum.y) + 0.5f)), 1f));
    } else {
        local_30 = band.low;
    }
    let _e29 = local_30;
    lowest = _e29;
    let _e32 = lowest;
    let _e34 = lowest;
    longest = ((0.0000000001486f * _e32) * _e34);
    let _e40 = longest;
    let _e41 = longest;
    if ((band.amplitude == 0f) || (((_e40 * _e41) * least) > 1.6f)) {
        {
            let _e48 = (*water);
            let _e51 = gabor_impl_slopes_along(band.slopes, heading);
            (*water).lost = (_e48.lost + _e51);
            return;
        }
    }
    let _e53 = gabor_impl_salt(seed);
    salt_4 = _e53;
    gabor_impl_float_by(cell.x, local.x, band.exponent, band.drift.x, second, fraction, (&whole_x), (&rest_x));
    gabor_impl_float_by(cell.y, local.y, band.exponent, band.drift.y, second, fraction, (&whole_y), (&rest_y));
    let _e77 = rest_x;
    let _e78 = rest_y;
    let _e81 = salt_4;
    let _e85 = salt_4;
    rest_3 = (vec2<f32>(_e77, _e78) + (0.000015258789f * vec2<f32>(f32((_e81 & 65535u)), f32((_e85 >> 16u)))));
    if three {
        local_31 = 0.5f;
    } else {
        local_31 = 0f;
    }
    let _e96 = local_31;
    inset = _e96;
    spacing = exp2(f32(band.exponent));
    if three {
        if false {
            local_32 = 1f;
        } else {
            local_32 = 1.125f;
        }
        let _e111 = local_32;
        local_33 = _e111;
    } else {
        local_33 = 1f;
    }
    let _e114 = local_33;
    energy = _e114;
    let _e116 = rest_3;
    let _e117 = inset;
    first_2 = floor((_e116 - vec2(_e117)));
    let _e122 = inset;
    let _e123 = rest_3;
    let _e124 = inset;
    let _e127 = first_2;
    offset = (vec2(_e122) + clamp(((_e123 - vec2(_e124)) - _e127), vec2(0f), vec2(1f)));
    let _e137 = whole_x;
    let _e138 = whole_y;
    let _e140 = first_2;
    node = (vec2<i32>(_e137, _e138) + vec2<i32>(_e140));
    let _e148 = offset;
    gabor_impl_water_windows(three, _e148.x, (&x_8), (&slope_x));
    let _e154 = offset;
    gabor_impl_water_windows(three, _e154.y, (&y_4), (&slope_y));
    if three {
        local_34 = 1459955300000000000000000000f;
    } else {
        local_34 = 1243281800000000000000000000000f;
    }
    let _e163 = local_34;
    deviation_1 = _e163;
    if three {
        let _e168 = deviation_1;
        local_35 = vec3<f32>(0.89289314f, 7397391600000000000f, (1.0034f * _e168));
    } else {
        let _e174 = deviation_1;
        local_35 = vec3<f32>(0f, 1000000000000000000000f, (1.0297f * _e174));
    }
    let _e178 = local_35;
    shape_1 = _e178;
    let _e180 = x_8;
    let _e182 = energy;
    let _e183 = deviation_1;
    x_8 = (_e180 * (band.amplitude / (_e182 * _e183)));
    let _e187 = slope_x;
    let _e189 = energy;
    let _e190 = deviation_1;
    let _e192 = spacing;
    slope_x = (_e187 * (band.amplitude / ((_e189 * _e190) * _e192)));
    let _e196 = slope_y;
    let _e197 = spacing;
    slope_y = (_e196 / vec4(_e197));
    f_2 = (0.000000014901161f * band.low);
    if three {
        local_36 = 0.6383f;
    } else {
        local_36 = 0.622f;
    }
    let _e207 = local_36;
    let _e208 = f_2;
    let _e210 = f_2;
    wave_6 = ((_e207 * _e208) * _e210);
    let _e213 = node;
    let _e215 = salt_4;
    let _e216 = gabor_impl_line_word(_e213.x, _e215);
    left = _e216;
    let _e218 = node;
    let _e222 = salt_4;
    let _e223 = gabor_impl_line_word((_e218.x + 1i), _e222);
    middle_1 = _e223;
    let _e225 = node;
    let _e229 = salt_4;
    let _e230 = gabor_impl_line_word((_e225.x + 2i), _e229);
    right = _e230;
    let _e232 = spacing;
    let _e233 = offset;
    from_1 = (_e232 * _e233);
    loop {
        let _e238 = j_2;
        if three {
            local_37 = 3i;
        } else {
            local_37 = 2i;
        }
        let _e242 = local_37;
        if !((_e238 < _e242)) {
            break;
        }
        {
            let _e248 = node;
            let _e250 = j_2;
            let _e252 = salt_4;
            let _e255 = gabor_impl_line_word((_e248.y + _e250), (_e252 ^ 1540483477u));
            row_1 = _e255;
            let _e257 = j_2;
            if (_e257 == 0i) {
                let _e260 = y_4;
                let _e262 = slope_y;
                local_39 = vec2<f32>(_e260.x, _e262.x);
            } else {
                let _e265 = j_2;
                if (_e265 == 1i) {
                    let _e268 = y_4;
                    let _e270 = slope_y;
                    local_38 = vec2<f32>(_e268.y, _e270.y);
                } else {
                    let _e273 = y_4;
                    let _e275 = slope_y;
                    local_38 = vec2<f32>(_e273.z, _e275.z);
                }
                let _e279 = local_38;
                local_39 = _e279;
            }
            let _e281 = local_39;
            w = _e281;
            let _e285 = row_1;
            let _e286 = left;
            let _e288 = from_1;
            let _e289 = x_8;
            let _e291 = w;
            let _e294 = slope_x;
            let _e296 = w;
            let _e299 = x_8;
            let _e301 = w;
            let _e305 = wave_6;
            let _e306 = shape_1;
            gabor_impl_add_water(water, squeeze, (_e285 * _e286), _e288, vec3<f32>((_e289.x * _e291.x), (_e294.x * _e296.x), (_e299.x * _e301.y)), band, heading, quantum, _e305, _e306, second, fraction, dx, dy);
            let _e311 = row_1;
            let _e312 = middle_1;
            let _e314 = from_1;
            let _e315 = spacing;
            let _e319 = x_8;
            let _e321 = w;
            let _e324 = slope_x;
            let _e326 = w;
            let _e329 = x_8;
            let _e331 = w;
            let _e335 = wave_6;
            let _e336 = shape_1;
            gabor_impl_add_water(water, squeeze, (_e311 * _e312), (_e314 - vec2<f32>(_e315, 0f)), vec3<f32>((_e319.y * _e321.x), (_e324.y * _e326.x), (_e329.y * _e331.y)), band, heading, quantum, _e335, _e336, second, fraction, dx, dy);
            if three {
                let _e341 = row_1;
                let _e342 = right;
                let _e344 = from_1;
                let _e346 = spacing;
                let _e351 = x_8;
                let _e353 = w;
                let _e356 = slope_x;
                let _e358 = w;
                let _e361 = x_8;
                let _e363 = w;
                let _e367 = wave_6;
                let _e368 = shape_1;
                gabor_impl_add_water(water, squeeze, (_e341 * _e342), (_e344 - vec2<f32>((2f * _e346), 0f)), vec3<f32>((_e351.z * _e353.x), (_e356.z * _e358.x), (_e361.z * _e363.y)), band, heading, quantum, _e367, _e368, second, fraction, dx, dy);
            }
            let _e372 = from_1;
            let _e374 = spacing;
            from_1.y = (_e372.y - _e374);
        }
        continuing {
            let _e245 = j_2;
            j_2 = (_e245 + 1i);
        }
    }
    return;
}

fn gabor_water_at(cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, ocean: GaborOcean, seed: u32) -> GaborWater {
    var wind_2: vec2<f32>;
    var swell_1: vec2<f32>;
    var water_1: GaborWater;
    var squeeze_2: vec3<f32> = vec3(0f);
    var local_41: vec2<f32>;
    var quantum_2: vec2<f32>;
    var area: f32;
    var sides: f32;
    var least_1: f32;
    var threes: i32 = 3i;
    var local_42: i32;
    var last_1: i32;
    var i_1: i32 = 1i;
    var local_43: i32;
    var k_1: i32;
    var local_44: vec2<f32>;
    var local_45: i32;
    var j_3: i32 = 0i;
    var local_46: i32;
    var k_2: i32;
    let _e11 = gabor_impl_wave((0.15915494f * ocean.direction));
    wind_2 = _e11;
    let _e17 = gabor_impl_wave((0.15915494f * ocean.swell.z));
    swell_1 = _e17;
    let _e26 = wind_2;
    let _e27 = gabor_impl_slopes_along(ocean.tail, _e26);
    water_1 = GaborWater(0f, vec2(0f), vec2(0f), 0f, _e27);
    if (ocean.loop_ > 0i) {
        local_41 = vec2<f32>(f32((65536i / max(ocean.loop_, 1i))), (0.000015258789f * f32(ocean.loop_)));
    } else {
        local_41 = vec2(0f);
    }
    let _e50 = local_41;
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
    if (ocean.swell.x > 0f) {
        let _e97 = threes;
        local_42 = (_e97 + 1i);
    } else {
        let _e100 = threes;
        local_42 = _e100;
    }
    let _e102 = local_42;
    last_1 = _e102;
    loop {
        let _e106 = i_1;
        let _e107 = last_1;
        if !((_e106 <= _e107)) {
            break;
        }
        {
            let _e113 = i_1;
            let _e114 = threes;
            if (_e113 > _e114) {
                local_43 = 9i;
            } else {
                let _e117 = i_1;
                local_43 = _e117;
            }
            let _e119 = local_43;
            k_1 = _e119;
            let _e123 = k_1;
            let _e127 = i_1;
            let _e128 = threes;
            if (_e127 > _e128) {
                let _e130 = swell_1;
                local_44 = _e130;
            } else {
                let _e131 = wind_2;
                local_44 = _e131;
            }
            let _e133 = local_44;
            let _e134 = quantum_2;
            let _e135 = least_1;
            let _e136 = i_1;
            let _e137 = threes;
            if (_e136 > _e137) {
                local_45 = 12i;
            } else {
                let _e140 = k_1;
                local_45 = _e140;
            }
            let _e142 = local_45;
            let _e143 = gabor_lobe_seed(seed, _e142);
            gabor_impl_add_band((&water_1), (&squeeze_2), ocean.band[_e123], true, _e133, _e134, _e135, cell, local, second, fraction, dx, dy, _e143);
        }
        continuing {
            let _e110 = i_1;
            i_1 = (_e110 + 1i);
        }
    }
    loop {
        let _e148 = j_3;
        let _e150 = threes;
        if !((_e148 < (9i - _e150))) {
            break;
        }
        {
            let _e157 = j_3;
            if (_e157 == 0i) {
                local_46 = 0i;
            } else {
                let _e161 = j_3;
                let _e162 = threes;
                local_46 = (_e161 + _e162);
            }
            let _e165 = local_46;
            k_2 = _e165;
            let _e169 = k_2;
            let _e173 = wind_2;
            let _e174 = quantum_2;
            let _e175 = least_1;
            let _e176 = k_2;
            let _e177 = gabor_lobe_seed(seed, _e176);
            gabor_impl_add_band((&water_1), (&squeeze_2), ocean.band[_e169], false, _e173, _e174, _e175, cell, local, second, fraction, dx, dy, _e177);
        }
        continuing {
            let _e154 = j_3;
            j_3 = (_e154 + 1i);
        }
    }
    let _e182 = squeeze_2;
    let _e186 = squeeze_2;
    let _e189 = squeeze_2;
    let _e193 = squeeze_2;
    let _e195 = squeeze_2;
    water_1.fold = (((1f - _e182.x) * ((1f - _e186.z) + _e189.x)) - (_e193.y * _e195.y));
    let _e200 = water_1;
    let _e203 = water_1;
    let _e206 = water_1;
    let _e210 = water_1;
    water_1.lost = vec3<f32>(_e200.lost.x, (_e203.lost.z - _e206.lost.x), _e210.lost.y);
    let _e214 = water_1;
    return _e214;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

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
    var water_2: GaborWater = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
    var i_2: i32 = 0i;
    loop {
        let _e16 = i_2;
        if !((_e16 < 6i)) {
            break;
        }
        let _e23 = water_2;
        let _e26 = gabor_water((p - _e23.shift), seconds, ocean, seed);
        water_2 = _e26;
        continuing {
            let _e20 = i_2;
            i_2 = (_e20 + 1i);
        }
    }
    let _e27 = water_2;
    return _e27.height;
}

