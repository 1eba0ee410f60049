// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest e8a5f3bb49fb35bf.
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
// time: gabor_water_at. Another direction or fetch: gabor_ocean_of.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Waves from one wavelength to half of it. `low`, `quarter` and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2<f32>, // variance of the slopes along the wind and across it
    exponent: i32, // the spacing of nodes is 2^exponent metres
    low: f32, // 65536 times the lowest frequency in Hz
    quarter: vec4<f32>, // the ranges of frequency that have a quarter of the power each, in 1/1024 of the lowest frequency
    spread: vec3<f32>, // sin(d / 2) of an angle d from the wind is a u + b u^3 + c v, u and v uniform in [-1, 1], here times 4092,
    widen: vec2<f32>, // times a linear function of the frequency, here times 16384
    drift: vec2<i32>, // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32, // speed in metres per second, 10 m up
    direction: f32, // where the waves go: radians from +x towards +y
    fetch: f32, // metres of open water upwind
    tail: vec2<f32>, // variance of the slopes of waves shorter than all bands, along the wind and across it
    band: array<GaborOceanBand, 9>,
}

// GaborOcean gabor_ocean(f32 wind)
// GaborOcean gabor_ocean_of(f32 wind, f32 direction, f32 fetch)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] and the directions of [HDE80]. Compute it once, on the CPU if the CPU also asks for heights: the
//     integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    height: f32, // metres, of mean 0 and normally distributed
    slope: vec2<f32>, // derivatives of the height by p
    shift: vec2<f32>, // horizontal displacement in metres, towards crests, which it sharpens
    fold: f32, // determinant of the derivative of p + shift, within 0.1: foam where it falls below 0.4
    lost: vec3<f32>, // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
}

// GaborWater gabor_water(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.

// GaborWater gabor_water_filtered(vec2f p, vec2f dx, vec2f dy, f32 seconds, GaborOcean ocean, u32 seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54]. dx and dy are dpdx(p), dpdy(p).

// f32 gabor_water_height(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.

// GaborWater gabor_water_at(vec2i cell, vec2f local, i32 second, f32 fraction, vec2f dx, vec2f dy, GaborOcean ocean, u32 seed)
//     At the position cell + local in metres, second + fraction in seconds: exact for years and anywhere. dx and dy of
//     vec2f(0.0) do not filter.

// [HBB73] Hasselmann and others, "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project",
// 1973. [HDE80] Hasselmann, Dunckel, Ewing, "Directional wave spectra observed during JONSWAP 1973", 1980.
// [CM54] Cox, Munk, "Measurement of the roughness of the sea surface from photographs of the sun's glitter", 1954.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise whose nodes have wave vectors of their own, drawn from the band's part of the spectrum: a
// frequency F and an angle d from the wind, from which the wave number follows by the dispersion relation of deep water,
// (2 pi f)^2 = g |2 pi k|. The lattice drifts with the band's group velocity V, so that groups travel as they should; seen
// from there, phases turn by F - k.V. With V = g / (4 pi f0) along the wind, k.V = F^2 / (2 F0) cos d. F - k.V is an integer,
// so that the phase is exact after any time, and the same on every device: floats below 2^24 and powers of 2 are exact.
//
// Bands 1 to 3 hold most of the height. There, three nodes along each axis, of normal amplitudes, keep it normal. In the
// other bands, which hold most of the slopes, two nodes suffice, and uniform amplitudes make up for the kurtosis that the
// waves' directions give the slopes. Each seed shifts the lattices, so that no place differs from others.

fn gabor_impl_spectrum(f: f32, peak: f32, scale: f32) -> vec2<f32> {
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
    let _e12 = local_11;
    apart = (((f / peak) - 1f) / _e12);
    squares = (((f * f) * f) * f);
    let _e19 = below;
    let _e20 = below;
    below = (_e19 * _e20);
    let _e26 = apart;
    let _e28 = apart;
    let _e33 = below;
    let _e35 = below;
    let _e41 = squares;
    return (((scale / f) * exp(((1.1939225f * exp(((-0.5f * _e26) * _e28))) - ((1.25f * _e33) * _e35)))) * vec2<f32>((1f / _e41), 1f));
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

fn gabor_ocean_of(wind: f32, direction: f32, fetch: f32) -> GaborOcean {
    var gravity: f32 = 9.81f;
    var tick: f32 = 0.000015258789f;
    var ocean: GaborOcean;
    var heading: vec2<f32>;
    var reach_1: f32;
    var peak_1: f32;
    var scale_1: f32;
    var power_1: i32;
    var i: i32 = 0i;
    var local_18: i32;
    var low: f32;
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
    var local_19: f32;
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
    var local_20: f32;
    var shown: f32;
    var local_21: i32;
    ocean.wind = clamp(wind, 2f, 30f);
    ocean.direction = direction;
    ocean.fetch = clamp(fetch, 1000f, 1000000f);
    let _e19 = gabor_impl_wave((0.15915494f * direction));
    heading = _e19;
    let _e21 = gravity;
    let _e22 = ocean;
    let _e25 = ocean;
    let _e27 = ocean;
    reach_1 = ((_e21 * _e22.fetch) / (_e25.wind * _e27.wind));
    let _e33 = gravity;
    let _e35 = ocean;
    let _e38 = reach_1;
    peak_1 = (((3.5f * _e33) / _e35.wind) * pow(_e38, -0.33f));
    let _e45 = reach_1;
    let _e50 = gravity;
    let _e52 = gravity;
    scale_1 = ((((0.076f * pow(_e45, -0.22f)) * _e50) * _e52) / 1558.5455f);
    let _e58 = peak_1;
    let _e60 = tick;
    power_1 = i32(floor(log2(((0.62f * _e58) / _e60))));
    let _e70 = ocean;
    ocean.tail = ((vec2<f32>(0.00316f, 0.00192f) * _e70.wind) + vec2<f32>(0f, 0.003f));
    loop {
        let _e79 = i;
        if !((_e79 < 9i)) {
            break;
        }
        {
            let _e86 = i;
            if ((_e86 & 1i) == 0i) {
                local_18 = 128i;
            } else {
                local_18 = 181i;
            }
            let _e94 = local_18;
            let _e95 = power_1;
            let _e96 = i;
            low = (f32((_e94 << u32((_e95 + (_e96 / 2i))))) / 128f);
            let _e107 = low;
            width = (0.10351562f * _e107);
            variance = 0f;
            sum_5 = vec2(0f);
            let _e115 = tick;
            let _e116 = low;
            let _e118 = peak_1;
            let _e119 = scale_1;
            let _e120 = gabor_impl_spectrum((_e115 * _e116), _e118, _e119);
            first_1 = _e120;
            sums_2 = vec4(0f);
            starts_1 = vec4(0f);
            ends_1 = vec4(0f);
            fit = vec4(0f);
            j_1 = 0i;
            loop {
                let _e136 = j_1;
                if !((_e136 < 4i)) {
                    break;
                }
                {
                    let _e143 = tick;
                    let _e144 = low;
                    let _e145 = j_1;
                    let _e147 = width;
                    f_1 = (_e143 * (_e144 + (f32(_e145) * _e147)));
                    let _e152 = tick;
                    let _e153 = width;
                    step_ = (_e152 * _e153);
                    let _e157 = j_1;
                    x_5 = ((106f * f32(_e157)) - 159f);
                    let _e163 = f_1;
                    let _e165 = step_;
                    let _e168 = peak_1;
                    let _e169 = scale_1;
                    let _e170 = gabor_impl_spectrum((_e163 + (0.5f * _e165)), _e168, _e169);
                    middle = _e170;
                    let _e172 = f_1;
                    let _e173 = step_;
                    let _e175 = peak_1;
                    let _e176 = scale_1;
                    let _e177 = gabor_impl_spectrum((_e172 + _e173), _e175, _e176);
                    last = _e177;
                    let _e179 = step_;
                    let _e182 = first_1;
                    let _e184 = middle;
                    let _e187 = last;
                    part = ((_e179 / 6f) * ((_e182 + (4f * _e184)) + _e187));
                    let _e191 = sum_5;
                    let _e192 = part;
                    sum_5 = (_e191 + _e192);
                    let _e194 = f_1;
                    let _e196 = step_;
                    let _e199 = peak_1;
                    above = ((_e194 + (0.5f * _e196)) / _e199);
                    let _e204 = above;
                    let _e205 = above;
                    if (_e205 < 1f) {
                        local_19 = 4.06f;
                    } else {
                        local_19 = -2.34f;
                    }
                    let _e212 = local_19;
                    here = (0.5f / ((9.77f * pow(_e204, _e212)) + 1f));
                    let _e219 = variance;
                    let _e220 = part;
                    let _e222 = here;
                    variance = (_e219 + (_e220.x * _e222));
                    let _e225 = fit;
                    let _e226 = part;
                    let _e228 = x_5;
                    let _e229 = here;
                    let _e231 = x_5;
                    let _e232 = x_5;
                    let _e234 = x_5;
                    let _e235 = here;
                    fit = (_e225 + (_e226.x * vec4<f32>(_e228, sqrt(_e229), (_e231 * _e232), (_e234 * sqrt(_e235)))));
                    let _e241 = sums_2;
                    let _e242 = _e241.yzw;
                    let _e243 = sum_5;
                    sums_2 = vec4<f32>(_e242.x, _e242.y, _e242.z, _e243.x);
                    let _e249 = starts_1;
                    let _e250 = _e249.yzw;
                    let _e251 = first_1;
                    starts_1 = vec4<f32>(_e250.x, _e250.y, _e250.z, _e251.x);
                    let _e257 = ends_1;
                    let _e258 = _e257.yzw;
                    let _e259 = last;
                    ends_1 = vec4<f32>(_e258.x, _e258.y, _e258.z, _e259.x);
                    let _e265 = last;
                    first_1 = _e265;
                }
                continuing {
                    let _e140 = j_1;
                    j_1 = (_e140 + 1i);
                }
            }
            let _e266 = variance;
            let _e267 = sum_5;
            variance = (_e266 / _e267.x);
            let _e270 = fit;
            let _e271 = sum_5;
            fit = (_e270 / vec4(_e271.x));
            let _e275 = variance;
            deviation = sqrt(_e275);
            let _e279 = variance;
            narrow = ((0.5f / _e279) - 1.8f);
            let _e285 = deviation;
            let _e287 = narrow;
            c_1 = ((0.9f * _e285) * clamp(_e287, 0f, 1f));
            let _e294 = narrow;
            let _e299 = fit;
            let _e301 = fit;
            let _e303 = fit;
            let _e308 = fit;
            let _e310 = fit;
            let _e312 = fit;
            let _e316 = deviation;
            widen = ((clamp((0.3f * _e294), 0f, 1f) * (_e299.w - (_e301.x * _e303.y))) / ((_e308.z - (_e310.x * _e312.x)) * _e316));
            let _e322 = widen;
            widen = (0.000061035156f * floor(clamp((16384f * _e322), -32f, 32f)));
            let _e333 = widen;
            let _e337 = fit;
            let _e339 = widen;
            most = (1f / ((1f + (212f * abs(_e333))) - (_e337.x * _e339)));
            let _e345 = deviation;
            let _e347 = most;
            let _e348 = c_1;
            end = min((1.8f * _e345), (_e347 - _e348));
            let _e352 = variance;
            let _e353 = c_1;
            let _e354 = c_1;
            rest_1 = (_e352 - ((_e353 * _e354) / 3f));
            let _e361 = rest_1;
            let _e364 = end;
            let _e366 = end;
            let _e373 = end;
            a_2 = ((sqrt(max(((0.3047619f * _e361) - ((0.0304762f * _e364) * _e366)), 0f)) - (0.1142857f * _e373)) / 0.152381f);
            let _e379 = end;
            let _e380 = a_2;
            b_2 = (_e379 - _e380);
            let _e383 = a_2;
            let _e384 = a_2;
            let _e386 = a_2;
            let _e389 = a_2;
            let _e392 = b_2;
            let _e396 = b_2;
            let _e397 = b_2;
            let _e400 = a_2;
            let _e402 = a_2;
            let _e405 = a_2;
            let _e407 = b_2;
            let _e411 = b_2;
            let _e413 = b_2;
            let _e418 = c_1;
            let _e419 = c_1;
            let _e422 = rest_1;
            let _e425 = c_1;
            let _e427 = c_1;
            fourth_1 = (((((_e383 * _e384) * _e386) * ((0.2f * _e389) + (0.5714286f * _e392))) + ((_e396 * _e397) * ((((0.6666667f * _e400) * _e402) + ((0.36363637f * _e405) * _e407)) + ((0.07692308f * _e411) * _e413)))) + ((_e418 * _e419) * ((2f * _e422) + ((0.2f * _e425) * _e427))));
            let _e435 = variance;
            let _e439 = fourth_1;
            along = ((1f - (4f * _e435)) + (4f * _e439));
            let _e443 = gravity;
            let _e445 = tick;
            let _e447 = low;
            speed = (_e443 / (((12.566371f * _e445) * _e447) * 1.1892071f));
            let _e454 = sums_2;
            let _e455 = starts_1;
            let _e456 = ends_1;
            let _e457 = gabor_impl_quantile(0.2443f, _e454, _e455, _e456);
            let _e459 = sums_2;
            let _e460 = starts_1;
            let _e461 = ends_1;
            let _e462 = gabor_impl_quantile(0.4885f, _e459, _e460, _e461);
            let _e464 = sums_2;
            let _e465 = starts_1;
            let _e466 = ends_1;
            let _e467 = gabor_impl_quantile(0.7328f, _e464, _e465, _e466);
            quartile = floor((vec3<f32>(_e457, _e462, _e467) + vec3(0.5f)));
            let _e475 = low;
            if (_e475 > 262144f) {
                local_20 = 0f;
            } else {
                local_20 = 1f;
            }
            let _e481 = local_20;
            shown = _e481;
            let _e484 = shown;
            let _e485 = sum_5;
            band.amplitude = (_e484 * sqrt(_e485.x));
            let _e490 = shown;
            let _e491 = sum_5;
            let _e496 = along;
            let _e498 = along;
            band.slopes = (((_e490 * _e491.y) * 16.195057f) * vec2<f32>(_e496, (1f - _e498)));
            let _e503 = ocean;
            let _e505 = band;
            ocean.tail = (_e503.tail - _e505.slopes);
            let _e511 = power_1;
            let _e514 = i;
            let _e516 = i;
            let _e519 = i;
            if ((_e516 > 0i) && (_e519 < 4i)) {
                local_21 = 0i;
            } else {
                local_21 = 1i;
            }
            let _e526 = local_21;
            band.exponent = (((34i - (2i * _e511)) - _e514) - _e526);
            let _e529 = low;
            band.low = _e529;
            let _e531 = quartile;
            let _e538 = quartile;
            band.quarter = (vec4<f32>(_e531.x, _e531.y, _e531.z, 424f) - vec4<f32>(0f, _e538.x, _e538.y, _e538.z));
            let _e546 = a_2;
            let _e547 = b_2;
            let _e548 = c_1;
            band.spread = floor((4092f * vec3<f32>(_e546, _e547, _e548)));
            let _e555 = fit;
            let _e557 = widen;
            let _e560 = widen;
            band.widen = floor((16384f * vec2<f32>((1f - (_e555.x * _e557)), _e560)));
            let _e566 = speed;
            let _e568 = band;
            let _e574 = heading;
            band.drift = vec2<i32>(floor(((((32768f * _e566) * exp2(-(f32(_e568.exponent)))) * _e574) + vec2(0.5f))));
            let _e581 = i;
            let _e584 = band;
            ocean.band[_e581] = _e584;
        }
        continuing {
            let _e83 = i;
            i = (_e83 + 1i);
        }
    }
    let _e586 = ocean;
    ocean.tail = max(_e586.tail, vec2(0f));
    let _e591 = ocean;
    return _e591;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e3 = gabor_ocean_of(wind, 0f, 200000f);
    return _e3;
}

// The whole part of x >= 0. For it, C++ compilers have no fast floor.
fn gabor_impl_whole(x: f32) -> f32 {
    return floor(x);
}

// Adds a node's wave. `from` is the offset from the node in metres, `window` is (value, derivatives). Vectors but the
// derivatives are along the wind and across it. `wave` is the wave number of rise 1, in turns per metre. The first parts of
// `shape` make an amplitude normal, as in gabor_impl_amplitude, or uniform; the last is its deviation, times k / wave. `tilt` collects the
// slopes of the windows, `squeeze` the derivatives of the shift. It and `lost` have the parts xx, xy and xx + yy.
fn gabor_impl_add_water(sum: ptr<function, GaborWater>, tilt: ptr<function, vec2<f32>>, squeeze: ptr<function, vec3<f32>>, word: u32, from_: vec2<f32>, window: vec3<f32>, band: GaborOceanBand, wave: f32, shape: vec3<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>) {
    var bits: u32;
    var share_2: f32;
    var below_1: vec4<f32>;
    var rise: f32;
    var square: f32;
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
    var local_22: f32;
    var chord: f32;
    var unit: vec2<f32>;
    var turns: f32;
    var uniforms: vec2<f32>;
    var amplitude_2: vec2<f32>;
    var z_1: vec2<f32>;
    var steps: vec2<f32>;
    var kept: f32;
    var along_1: vec2<f32>;
    var squeezing: f32;
    var power_2: f32;
    var lost: f32;
    bits = ((word ^ (word >> 15u)) * 3545902487u);
    let _e19 = bits;
    let _e20 = bits;
    bits = (_e19 ^ (_e20 >> 15u));
    let _e25 = bits;
    share_2 = (0.00390625f * f32((_e25 >> 22u)));
    let _e32 = share_2;
    below_1 = (band.quarter * clamp((vec4(_e32) - vec4<f32>(0f, 1f, 2f, 3f)), vec4(0f), vec4(1f)));
    let _e48 = below_1;
    let _e51 = below_1;
    let _e54 = below_1;
    let _e57 = below_1;
    let _e60 = gabor_impl_whole(((((1024f + _e48.x) + _e51.y) + _e54.z) + _e57.w));
    rise = _e60;
    let _e62 = rise;
    let _e63 = rise;
    square = (_e62 * _e63);
    let _e67 = bits;
    u_1 = ((2f * f32(((_e67 >> 11u) & 2047u))) - 2047f);
    let _e78 = bits;
    v = ((2f * f32((_e78 & 2047u))) - 2047f);
    let _e93 = u_1;
    let _e95 = u_1;
    let _e97 = gabor_impl_whole(((0.00048828125f * _e93) * _e95));
    let _e100 = gabor_impl_whole((band.spread.x + ((0.00048828125f * band.spread.y) * _e97)));
    bent = _e100;
    let _e102 = u_1;
    let _e103 = bent;
    let _e105 = v;
    side_1 = ((_e102 * _e103) + (_e105 * band.spread.z));
    let _e112 = side_1;
    let _e115 = gabor_impl_whole((0.00012207031f * abs(_e112)));
    let _e120 = rise;
    angle = (_e115 * (band.widen.x + (band.widen.y * (_e120 - 1236f))));
    let _e128 = angle;
    let _e130 = gabor_impl_whole((0.00012207031f * _e128));
    part_1 = _e130;
    let _e133 = part_1;
    let _e135 = part_1;
    let _e137 = gabor_impl_whole(((0.00048828125f * _e133) * _e135));
    lag = _e137;
    let _e140 = square;
    let _e142 = gabor_impl_whole((0.0009765625f * _e140));
    steep = _e142;
    let _e144 = steep;
    let _e146 = steep;
    let _e148 = lag;
    let _e150 = gabor_impl_whole(((0.0009765625f * _e146) * _e148));
    carried = (_e144 - _e150);
    let _e155 = rise;
    let _e158 = carried;
    let _e162 = gabor_impl_whole((0.0078125f * ((2048f * _e155) - (861f * _e158))));
    turning = _e162;
    let _e164 = turning;
    let _e169 = gabor_impl_whole((_e164 * (0.000061035156f * band.low)));
    turning = _e169;
    let _e170 = square;
    k = (wave * _e170);
    let _e174 = k;
    around = (6.2831855f * _e174);
    let _e177 = side_1;
    if (_e177 < 0f) {
        local_22 = -0.00000011920929f;
    } else {
        local_22 = 0.00000011920929f;
    }
    let _e184 = local_22;
    let _e185 = angle;
    chord = (_e184 * _e185);
    let _e190 = chord;
    let _e192 = chord;
    let _e195 = chord;
    let _e198 = chord;
    let _e200 = chord;
    unit = vec2<f32>((1f - ((0.5f * _e190) * _e192)), (_e195 * sqrt((1f - ((0.25f * _e198) * _e200)))));
    let _e207 = turning;
    let _e218 = turning;
    turns = (f32((((u32(_e207) & 65535u) * (u32(second) & 65535u)) & 65535u)) + (_e218 * fraction));
    uniforms = vec2<f32>(f32(i32(word)), f32(i32((word << 12u))));
    let _e230 = uniforms;
    let _e232 = uniforms;
    let _e241 = uniforms;
    let _e242 = uniforms;
    amplitude_2 = ((_e230 - (shape.x * clamp(_e232, vec2(-2011925800f), vec2(2011925800f)))) * ((_e241 * _e242) + vec2(shape.y)));
    let _e249 = amplitude_2;
    let _e250 = k;
    let _e251 = unit;
    let _e255 = turns;
    let _e258 = gabor_impl_wave(((_e250 * dot(_e251, from_)) - (0.000015258789f * _e255)));
    let _e259 = gabor_impl_product(_e249, _e258);
    z_1 = _e259;
    let _e261 = around;
    let _e262 = unit;
    let _e264 = unit;
    steps = (_e261 * vec2<f32>(dot(_e262, dx), dot(_e264, dy)));
    let _e271 = steps;
    let _e272 = steps;
    kept = exp((-0.125f * dot(_e271, _e272)));
    let _e277 = z_1;
    let _e278 = kept;
    z_1 = (_e277 * _e278);
    let _e280 = (*tilt);
    let _e281 = z_1;
    (*tilt) = (_e280 + (_e281.y * window.yz));
    let _e286 = z_1;
    z_1 = (_e286 * window.x);
    let _e289 = z_1;
    let _e291 = unit;
    along_1 = (_e289.x * _e291);
    let _e294 = around;
    let _e295 = z_1;
    squeezing = (_e294 * _e295.y);
    let _e302 = around;
    power_2 = ((shape.z * window.x) * _e302);
    let _e305 = power_2;
    let _e306 = power_2;
    let _e309 = kept;
    let _e310 = kept;
    lost = ((_e305 * _e306) * (1f - (_e309 * _e310)));
    let _e316 = (*sum);
    let _e318 = z_1;
    (*sum).height = (_e316.height + _e318.y);
    let _e322 = (*sum);
    let _e324 = around;
    let _e325 = along_1;
    (*sum).slope = (_e322.slope + (_e324 * _e325));
    let _e329 = (*sum);
    let _e331 = along_1;
    (*sum).shift = (_e329.shift + _e331);
    let _e333 = (*squeeze);
    let _e334 = squeezing;
    let _e335 = unit;
    let _e337 = unit;
    let _e338 = (_e335.x * _e337);
    (*squeeze) = (_e333 + (_e334 * vec3<f32>(_e338.x, _e338.y, 1f)));
    let _e346 = (*sum);
    let _e348 = lost;
    let _e349 = unit;
    let _e351 = unit;
    let _e352 = (_e349.x * _e351);
    (*sum).lost = (_e346.lost + (_e348 * vec3<f32>(_e352.x, _e352.y, 1f)));
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
    (*rest) = (_e53 + ((f32((cell & ((1i << u32(_e55)) - 1i))) + local) * exp2(-(f32(exponent)))));
    return;
}

// The windows of three nodes, or two, along an axis. `x` is in node spacings from the first node.
fn gabor_impl_water_windows(three: bool, x: f32, value: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>) {
    var s_2: f32;
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
            s_2 = ((x * x) * (3f - (2f * x)));
            let _e26 = s_2;
            let _e29 = s_2;
            scale_2 = inverseSqrt((1f - ((2f * _e26) * (1f - _e29))));
            let _e35 = scale_2;
            let _e37 = s_2;
            let _e39 = s_2;
            (*value) = (_e35 * vec4<f32>((1f - _e37), _e39, 0f, 0f));
            let _e49 = scale_2;
            let _e51 = scale_2;
            let _e53 = scale_2;
            let _e55 = s_2;
            let _e58 = s_2;
            (*slope) = ((((((6f * x) * (1f - x)) * _e49) * _e51) * _e53) * vec4<f32>(-(_e55), (1f - _e58), 0f, 0f));
            return;
        }
    }
}

// The parts of v along a unit vector and across it.
fn gabor_impl_into(v: vec2<f32>, by: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(((v.x * by.x) + (v.y * by.y)), ((v.y * by.x) - (v.x * by.y)));
}

fn gabor_water_at(cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, ocean: GaborOcean, seed: u32) -> GaborWater {
    var dx_2: vec2<f32>;
    var dy_2: vec2<f32>;
    var heading_1: vec2<f32>;
    var back_1: vec2<f32>;
    var water: GaborWater = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
    var tilt_1: vec2<f32> = vec2(0f);
    var hidden: vec2<f32>;
    var squeeze_1: vec3<f32> = vec3(0f);
    var area: f32;
    var sides: f32;
    var least: f32;
    var i_1: i32 = 0i;
    var band_2: GaborOceanBand;
    var longest: f32;
    var three_1: bool;
    var salt_4: u32;
    var whole_x: i32;
    var whole_y: i32;
    var rest_x: f32;
    var rest_y: f32;
    var rest_3: vec2<f32>;
    var local_25: f32;
    var inset: f32;
    var spacing: f32;
    var local_26: f32;
    var local_27: f32;
    var energy: f32;
    var first_2: vec2<f32>;
    var offset: vec2<f32>;
    var node: vec2<i32>;
    var x_8: vec4<f32>;
    var y_4: vec4<f32>;
    var slope_x: vec4<f32>;
    var slope_y: vec4<f32>;
    var local_28: f32;
    var deviation_1: f32;
    var local_29: vec3<f32>;
    var shape_1: vec3<f32>;
    var f_2: f32;
    var local_30: f32;
    var wave_6: f32;
    var left: u32;
    var middle_1: u32;
    var right: u32;
    var across: vec2<f32>;
    var from_1: vec2<f32>;
    var down_1: vec2<f32>;
    var j_2: i32;
    var local_31: i32;
    var row_1: u32;
    var local_32: vec2<f32>;
    var local_33: vec2<f32>;
    var w: vec2<f32>;
    var mean: f32;
    var parts: vec2<f32>;
    dx_2 = dx;
    dy_2 = dy;
    let _e13 = gabor_impl_wave((0.15915494f * ocean.direction));
    heading_1 = _e13;
    let _e15 = heading_1;
    let _e17 = heading_1;
    back_1 = vec2<f32>(_e15.x, -(_e17.y));
    hidden = ocean.tail;
    let _e40 = dx_2;
    let _e42 = dy_2;
    let _e45 = dx_2;
    let _e47 = dy_2;
    area = ((_e40.x * _e42.y) - (_e45.y * _e47.x));
    let _e52 = dx_2;
    let _e53 = dx_2;
    let _e55 = dy_2;
    let _e56 = dy_2;
    sides = (dot(_e52, _e53) + dot(_e55, _e56));
    let _e61 = area;
    let _e63 = area;
    let _e65 = sides;
    let _e66 = sides;
    let _e67 = sides;
    let _e70 = area;
    let _e72 = area;
    least = (((2f * _e61) * _e63) / max((_e65 + sqrt(max(((_e66 * _e67) - ((4f * _e70) * _e72)), 0f))), 0.000000000000000000000000000001f));
    let _e83 = dx_2;
    let _e84 = heading_1;
    let _e85 = gabor_impl_into(_e83, _e84);
    dx_2 = _e85;
    let _e86 = dy_2;
    let _e87 = heading_1;
    let _e88 = gabor_impl_into(_e86, _e87);
    dy_2 = _e88;
    loop {
        let _e91 = i_1;
        if !((_e91 < 9i)) {
            break;
        }
        {
            let _e98 = i_1;
            band_2 = ocean.band[_e98];
            let _e103 = band_2;
            let _e106 = band_2;
            longest = ((0.0000000001486f * _e103.low) * _e106.low);
            let _e110 = band_2;
            let _e114 = longest;
            let _e115 = longest;
            let _e117 = least;
            if ((_e110.amplitude == 0f) || (((_e114 * _e115) * _e117) > 1.6f)) {
                {
                    let _e122 = hidden;
                    let _e123 = band_2;
                    hidden = (_e122 + _e123.slopes);
                    continue;
                }
            }
            let _e126 = i_1;
            let _e129 = i_1;
            three_1 = ((_e126 > 0i) && (_e129 < 4i));
            let _e134 = i_1;
            let _e135 = gabor_lobe_seed(seed, _e134);
            let _e136 = gabor_impl_salt(_e135);
            salt_4 = _e136;
            let _e144 = band_2;
            let _e146 = band_2;
            gabor_impl_float_by(cell.x, local.x, _e144.exponent, _e146.drift.x, second, fraction, (&whole_x), (&rest_x));
            let _e155 = band_2;
            let _e157 = band_2;
            gabor_impl_float_by(cell.y, local.y, _e155.exponent, _e157.drift.y, second, fraction, (&whole_y), (&rest_y));
            let _e164 = rest_x;
            let _e165 = rest_y;
            let _e168 = salt_4;
            let _e172 = salt_4;
            rest_3 = (vec2<f32>(_e164, _e165) + (0.000015258789f * vec2<f32>(f32((_e168 & 65535u)), f32((_e172 >> 16u)))));
            let _e180 = three_1;
            if _e180 {
                local_25 = 0.5f;
            } else {
                local_25 = 0f;
            }
            let _e184 = local_25;
            inset = _e184;
            let _e186 = band_2;
            spacing = exp2(f32(_e186.exponent));
            let _e191 = three_1;
            if _e191 {
                if false {
                    local_26 = 1f;
                } else {
                    local_26 = 1.125f;
                }
                let _e201 = local_26;
                local_27 = _e201;
            } else {
                local_27 = 1f;
            }
            let _e204 = local_27;
            energy = _e204;
            let _e206 = rest_3;
            let _e207 = inset;
            first_2 = floor((_e206 - vec2(_e207)));
            let _e212 = inset;
            let _e213 = rest_3;
            let _e214 = inset;
            let _e217 = first_2;
            offset = (vec2(_e212) + clamp(((_e213 - vec2(_e214)) - _e217), vec2(0f), vec2(1f)));
            let _e227 = whole_x;
            let _e228 = whole_y;
            let _e230 = first_2;
            node = (vec2<i32>(_e227, _e228) + vec2<i32>(_e230));
            let _e238 = three_1;
            let _e239 = offset;
            gabor_impl_water_windows(_e238, _e239.x, (&x_8), (&slope_x));
            let _e245 = three_1;
            let _e246 = offset;
            gabor_impl_water_windows(_e245, _e246.y, (&y_4), (&slope_y));
            let _e252 = three_1;
            if _e252 {
                local_28 = 1459955300000000000000000000f;
            } else {
                local_28 = 1243281800000000000000000000000f;
            }
            let _e256 = local_28;
            deviation_1 = _e256;
            let _e258 = three_1;
            if _e258 {
                let _e262 = deviation_1;
                local_29 = vec3<f32>(0.89289314f, 7397391600000000000f, (1.0034f * _e262));
            } else {
                let _e268 = deviation_1;
                local_29 = vec3<f32>(0f, 1000000000000000000000f, (1.0297f * _e268));
            }
            let _e272 = local_29;
            shape_1 = _e272;
            let _e274 = x_8;
            let _e275 = band_2;
            let _e277 = energy;
            let _e278 = deviation_1;
            x_8 = (_e274 * (_e275.amplitude / (_e277 * _e278)));
            let _e282 = slope_x;
            let _e283 = band_2;
            let _e285 = energy;
            let _e286 = deviation_1;
            let _e288 = spacing;
            slope_x = (_e282 * (_e283.amplitude / ((_e285 * _e286) * _e288)));
            let _e292 = slope_y;
            let _e293 = spacing;
            slope_y = (_e292 / vec4(_e293));
            let _e297 = band_2;
            f_2 = (0.000000014901161f * _e297.low);
            let _e301 = three_1;
            if _e301 {
                local_30 = 0.6383f;
            } else {
                local_30 = 0.622f;
            }
            let _e305 = local_30;
            let _e306 = f_2;
            let _e308 = f_2;
            wave_6 = ((_e305 * _e306) * _e308);
            let _e311 = node;
            let _e313 = salt_4;
            let _e314 = gabor_impl_line_word(_e311.x, _e313);
            left = _e314;
            let _e316 = node;
            let _e320 = salt_4;
            let _e321 = gabor_impl_line_word((_e316.x + 1i), _e320);
            middle_1 = _e321;
            let _e323 = node;
            let _e327 = salt_4;
            let _e328 = gabor_impl_line_word((_e323.x + 2i), _e327);
            right = _e328;
            let _e330 = spacing;
            let _e331 = back_1;
            across = (_e330 * _e331);
            let _e334 = spacing;
            let _e335 = offset;
            let _e337 = heading_1;
            let _e338 = gabor_impl_into((_e334 * _e335), _e337);
            from_1 = _e338;
            let _e340 = spacing;
            let _e341 = heading_1;
            down_1 = (_e340 * _e341.yx);
            j_2 = 0i;
            loop {
                let _e347 = j_2;
                let _e348 = three_1;
                if _e348 {
                    local_31 = 3i;
                } else {
                    local_31 = 2i;
                }
                let _e352 = local_31;
                if !((_e347 < _e352)) {
                    break;
                }
                {
                    let _e358 = node;
                    let _e360 = j_2;
                    let _e362 = salt_4;
                    let _e365 = gabor_impl_line_word((_e358.y + _e360), (_e362 ^ 1540483477u));
                    row_1 = _e365;
                    let _e367 = j_2;
                    if (_e367 == 0i) {
                        let _e370 = y_4;
                        let _e372 = slope_y;
                        local_33 = vec2<f32>(_e370.x, _e372.x);
                    } else {
                        let _e375 = j_2;
                        if (_e375 == 1i) {
                            let _e378 = y_4;
                            let _e380 = slope_y;
                            local_32 = vec2<f32>(_e378.y, _e380.y);
                        } else {
                            let _e383 = y_4;
                            let _e385 = slope_y;
                            local_32 = vec2<f32>(_e383.z, _e385.z);
                        }
                        let _e389 = local_32;
                        local_33 = _e389;
                    }
                    let _e391 = local_33;
                    w = _e391;
                    let _e396 = row_1;
                    let _e397 = left;
                    let _e399 = from_1;
                    let _e400 = x_8;
                    let _e402 = w;
                    let _e405 = slope_x;
                    let _e407 = w;
                    let _e410 = x_8;
                    let _e412 = w;
                    let _e416 = band_2;
                    let _e417 = wave_6;
                    let _e418 = shape_1;
                    let _e419 = dx_2;
                    let _e420 = dy_2;
                    gabor_impl_add_water((&water), (&tilt_1), (&squeeze_1), (_e396 * _e397), _e399, vec3<f32>((_e400.x * _e402.x), (_e405.x * _e407.x), (_e410.x * _e412.y)), _e416, _e417, _e418, second, fraction, _e419, _e420);
                    let _e427 = row_1;
                    let _e428 = middle_1;
                    let _e430 = from_1;
                    let _e431 = across;
                    let _e433 = x_8;
                    let _e435 = w;
                    let _e438 = slope_x;
                    let _e440 = w;
                    let _e443 = x_8;
                    let _e445 = w;
                    let _e449 = band_2;
                    let _e450 = wave_6;
                    let _e451 = shape_1;
                    let _e452 = dx_2;
                    let _e453 = dy_2;
                    gabor_impl_add_water((&water), (&tilt_1), (&squeeze_1), (_e427 * _e428), (_e430 - _e431), vec3<f32>((_e433.y * _e435.x), (_e438.y * _e440.x), (_e443.y * _e445.y)), _e449, _e450, _e451, second, fraction, _e452, _e453);
                    let _e457 = three_1;
                    if _e457 {
                        let _e461 = row_1;
                        let _e462 = right;
                        let _e464 = from_1;
                        let _e466 = across;
                        let _e469 = x_8;
                        let _e471 = w;
                        let _e474 = slope_x;
                        let _e476 = w;
                        let _e479 = x_8;
                        let _e481 = w;
                        let _e485 = band_2;
                        let _e486 = wave_6;
                        let _e487 = shape_1;
                        let _e488 = dx_2;
                        let _e489 = dy_2;
                        gabor_impl_add_water((&water), (&tilt_1), (&squeeze_1), (_e461 * _e462), (_e464 - (2f * _e466)), vec3<f32>((_e469.z * _e471.x), (_e474.z * _e476.x), (_e479.z * _e481.y)), _e485, _e486, _e487, second, fraction, _e488, _e489);
                    }
                    let _e493 = from_1;
                    let _e494 = down_1;
                    from_1 = (_e493 - _e494);
                }
                continuing {
                    let _e355 = j_2;
                    j_2 = (_e355 + 1i);
                }
            }
        }
        continuing {
            let _e95 = i_1;
            i_1 = (_e95 + 1i);
        }
    }
    let _e497 = water;
    let _e499 = back_1;
    let _e500 = gabor_impl_into(_e497.slope, _e499);
    let _e501 = tilt_1;
    water.slope = (_e500 + _e501);
    let _e504 = water;
    let _e506 = back_1;
    let _e507 = gabor_impl_into(_e504.shift, _e506);
    water.shift = _e507;
    let _e510 = squeeze_1;
    let _e514 = squeeze_1;
    let _e517 = squeeze_1;
    let _e521 = squeeze_1;
    let _e523 = squeeze_1;
    water.fold = (((1f - _e510.x) * ((1f - _e514.z) + _e517.x)) - (_e521.y * _e523.y));
    let _e528 = water;
    let _e531 = hidden;
    let _e534 = hidden;
    mean = (0.5f * ((_e528.lost.z + _e531.x) + _e534.y));
    let _e539 = water;
    let _e542 = hidden;
    let _e545 = mean;
    let _e547 = water;
    let _e551 = back_1;
    let _e552 = gabor_impl_into(vec2<f32>(((_e539.lost.x + _e542.x) - _e545), _e547.lost.y), _e551);
    let _e553 = back_1;
    let _e554 = gabor_impl_into(_e552, _e553);
    parts = _e554;
    let _e557 = mean;
    let _e558 = parts;
    let _e561 = mean;
    let _e562 = parts;
    let _e565 = parts;
    water.lost = vec3<f32>((_e557 + _e558.x), (_e561 - _e562.x), _e565.y);
    let _e568 = water;
    return _e568;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_water_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    var cell_4: vec2<f32>;
    var second_5: f32;
    cell_4 = floor(p);
    second_5 = floor(seconds);
    let _e10 = cell_4;
    let _e12 = cell_4;
    let _e14 = second_5;
    let _e16 = second_5;
    let _e18 = gabor_water_at(vec2<i32>(_e10), (p - _e12), i32(_e14), (seconds - _e16), dx, dy, ocean, seed);
    return _e18;
}

fn gabor_water(p: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    let _e8 = gabor_water_filtered(p, vec2(0f), vec2(0f), seconds, ocean, seed);
    return _e8;
}

fn gabor_water_height(p: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> f32 {
    var at: vec2<f32>;
    var i_2: i32 = 0i;
    at = p;
    loop {
        let _e7 = i_2;
        if !((_e7 < 5i)) {
            break;
        }
        let _e14 = at;
        let _e15 = gabor_water(_e14, seconds, ocean, seed);
        at = (p - _e15.shift);
        continuing {
            let _e11 = i_2;
            i_2 = (_e11 + 1i);
        }
    }
    let _e18 = at;
    let _e19 = gabor_water(_e18, seconds, ocean, seed);
    return _e19.height;
}

