// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 44d9b47a94603263.
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

// Waves from one wavelength to half of it. Frequencies are in units of 1 / 65536 Hz.
struct GaborOceanBand {
    amplitude: f32,
    slopes: vec2<f32>,
    exponent: i32,
    low: i32,
    quarter: i32,
    share: vec3<i32>,
    lean: vec4<i32>,
    spread: vec2<i32>,
    drift: vec2<i32>,
}

struct GaborOcean {
    wind: f32,
    direction: f32,
    fetch: f32,
    tail: vec2<f32>,
    band: array<GaborOceanBand, 9>,
}

// GaborOcean gabor_ocean(f32 wind)
// GaborOcean gabor_ocean_of(f32 wind, f32 direction, f32 fetch)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] and the directions of [HDE80]. Compute it once, on the CPU if the CPU also asks for heights: the
//     integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    height: f32,
    slope: vec2<f32>,
    shift: vec2<f32>,
    fold: f32,
    lost: vec3<f32>,
}

// GaborWater gabor_water(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.

// GaborWater gabor_water_filtered(vec2f p, vec2f dx, vec2f dy, f32 seconds, GaborOcean ocean, u32 seed)
//     The same without waves that are too fine for a pixel, whose slopes are in `lost`, as are those of waves shorter than
//     all bands: with them, the slopes have the variance that Cox and Munk measured [CM54]. dx and dy are dFdx(p), dFdy(p).

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
// Each band is a lattice noise whose nodes have wave vectors of their own, drawn from the band's part of the spectrum. A
// node's frequency F is an integer, and so is the cosine of its angle to the wind: its phase is exact after any time, and
// the same on every device. Its wave number follows from F by the dispersion relation of deep water, (2 pi f)^2 = g |2 pi k|.
// The lattice drifts with the band's group velocity V, so that groups travel as they should; seen from there, phases turn
// by F - k.V. With V = g / (4 pi f0) along the wind, k.V = F^2 / (2 F0) cos d.

fn gabor_impl_spectrum(f: f32, peak: f32, scale: f32) -> f32 {
    var below: f32;
    var local_11: f32;
    var apart: f32;
    below = (peak / f);
    if (f < peak) {
        local_11 = 0.07f;
    } else {
        local_11 = 0.09f;
    }
    let _e12 = local_11;
    apart = (((f / peak) - 1f) / _e12);
    let _e15 = below;
    let _e16 = below;
    below = (_e15 * _e16);
    let _e25 = below;
    let _e27 = below;
    let _e32 = apart;
    let _e34 = apart;
    return ((scale / ((((f * f) * f) * f) * f)) * exp((((-1.25f * _e25) * _e27) + (1.1939225f * exp(((-0.5f * _e32) * _e34))))));
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
    var low: f32;
    var width: f32;
    var sum_5: f32;
    var slopes: f32;
    var variance: f32;
    var first_1: f32;
    var sums_1: vec4<f32>;
    var leans: vec4<f32>;
    var j_1: i32;
    var f_1: f32;
    var step_: f32;
    var middle: f32;
    var last: f32;
    var part: f32;
    var between: f32;
    var above: f32;
    var local_12: f32;
    var end: f32;
    var a_2: f32;
    var b_2: f32;
    var fourth_1: f32;
    var along: f32;
    var speed: f32;
    var band: GaborOceanBand;
    var local_13: f32;
    var shown: f32;
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
            let _e86 = power_1;
            let _e89 = i;
            low = exp2((f32(_e86) + (0.5f * f32(_e89))));
            let _e96 = low;
            width = (0.10355339f * _e96);
            sum_5 = 0f;
            slopes = 0f;
            variance = 0f;
            let _e105 = tick;
            let _e106 = low;
            let _e108 = peak_1;
            let _e109 = scale_1;
            let _e110 = gabor_impl_spectrum((_e105 * _e106), _e108, _e109);
            first_1 = _e110;
            sums_1 = vec4(0f);
            leans = vec4(0f);
            j_1 = 0i;
            loop {
                let _e120 = j_1;
                if !((_e120 < 4i)) {
                    break;
                }
                {
                    let _e127 = tick;
                    let _e128 = low;
                    let _e129 = j_1;
                    let _e131 = width;
                    f_1 = (_e127 * (_e128 + (f32(_e129) * _e131)));
                    let _e136 = tick;
                    let _e137 = width;
                    step_ = (_e136 * _e137);
                    let _e140 = f_1;
                    let _e142 = step_;
                    let _e145 = peak_1;
                    let _e146 = scale_1;
                    let _e147 = gabor_impl_spectrum((_e140 + (0.5f * _e142)), _e145, _e146);
                    middle = _e147;
                    let _e149 = f_1;
                    let _e150 = step_;
                    let _e152 = peak_1;
                    let _e153 = scale_1;
                    let _e154 = gabor_impl_spectrum((_e149 + _e150), _e152, _e153);
                    last = _e154;
                    let _e156 = step_;
                    let _e159 = first_1;
                    let _e161 = middle;
                    let _e164 = last;
                    part = ((_e156 / 6f) * ((_e159 + (4f * _e161)) + _e164));
                    let _e168 = f_1;
                    let _e170 = step_;
                    between = (_e168 + (0.5f * _e170));
                    let _e174 = sum_5;
                    let _e175 = part;
                    sum_5 = (_e174 + _e175);
                    let _e177 = between;
                    let _e178 = peak_1;
                    above = (_e177 / _e178);
                    let _e181 = variance;
                    let _e182 = part;
                    let _e186 = above;
                    let _e187 = above;
                    if (_e187 < 1f) {
                        local_12 = 4.06f;
                    } else {
                        local_12 = -2.34f;
                    }
                    let _e194 = local_12;
                    variance = (_e181 + ((_e182 * 0.5f) / ((9.77f * pow(_e186, _e194)) + 1f)));
                    let _e201 = slopes;
                    let _e202 = part;
                    let _e203 = between;
                    let _e205 = between;
                    let _e207 = between;
                    let _e209 = between;
                    slopes = (_e201 + ((((_e202 * _e203) * _e205) * _e207) * _e209));
                    let _e212 = sums_1;
                    let _e213 = _e212.yzw;
                    let _e214 = sum_5;
                    sums_1 = vec4<f32>(_e213.x, _e213.y, _e213.z, _e214);
                    let _e219 = leans;
                    let _e220 = _e219.yzw;
                    let _e221 = first_1;
                    let _e222 = last;
                    let _e224 = first_1;
                    let _e225 = last;
                    leans = vec4<f32>(_e220.x, _e220.y, _e220.z, ((_e221 - _e222) / (_e224 + _e225)));
                    let _e232 = last;
                    first_1 = _e232;
                }
                continuing {
                    let _e124 = j_1;
                    j_1 = (_e124 + 1i);
                }
            }
            let _e233 = variance;
            let _e234 = sum_5;
            variance = (_e233 / _e234);
            let _e237 = variance;
            end = min((2.2f * sqrt(_e237)), 1f);
            let _e244 = variance;
            let _e247 = end;
            let _e249 = end;
            let _e256 = end;
            a_2 = ((sqrt(max(((0.3047619f * _e244) - ((0.0304762f * _e247) * _e249)), 0f)) - (0.1142857f * _e256)) / 0.152381f);
            let _e262 = end;
            let _e263 = a_2;
            b_2 = (_e262 - _e263);
            let _e266 = a_2;
            let _e267 = a_2;
            let _e269 = a_2;
            let _e272 = a_2;
            let _e275 = b_2;
            let _e279 = b_2;
            let _e280 = b_2;
            let _e283 = a_2;
            let _e285 = a_2;
            let _e288 = a_2;
            let _e290 = b_2;
            let _e294 = b_2;
            let _e296 = b_2;
            fourth_1 = ((((_e266 * _e267) * _e269) * ((0.2f * _e272) + (0.5714286f * _e275))) + ((_e279 * _e280) * ((((0.6666667f * _e283) * _e285) + ((0.36363637f * _e288) * _e290)) + ((0.07692308f * _e294) * _e296))));
            let _e304 = variance;
            let _e308 = fourth_1;
            along = ((1f - (4f * _e304)) + (4f * _e308));
            let _e312 = gravity;
            let _e314 = tick;
            let _e316 = low;
            speed = (_e312 / (((12.566371f * _e314) * _e316) * 1.1892071f));
            let _e323 = low;
            if (_e323 > 262144f) {
                local_13 = 0f;
            } else {
                local_13 = 1f;
            }
            let _e329 = local_13;
            shown = _e329;
            let _e332 = shown;
            let _e333 = sum_5;
            band.amplitude = (_e332 * sqrt(_e333));
            let _e337 = shown;
            let _e338 = slopes;
            let _e342 = along;
            let _e344 = along;
            band.slopes = (((_e337 * _e338) * 16.195057f) * vec2<f32>(_e342, (1f - _e344)));
            let _e349 = ocean;
            let _e351 = band;
            ocean.tail = (_e349.tail - _e351.slopes);
            let _e357 = power_1;
            let _e360 = i;
            band.exponent = ((34i - (2i * _e357)) - _e360);
            let _e363 = low;
            band.low = i32((_e363 + 0.5f));
            let _e368 = width;
            band.quarter = i32((_e368 + 0.5f));
            let _e374 = sum_5;
            let _e376 = sums_1;
            band.share = vec3<i32>((((1024f / _e374) * _e376.xyz) + vec3(0.5f)));
            let _e385 = leans;
            band.lean = vec4<i32>(floor(((1024f * _e385) + vec4(0.5f))));
            let _e394 = a_2;
            let _e395 = b_2;
            band.spread = vec2<i32>(floor(((32767f * vec2<f32>(_e394, _e395)) + vec2(0.5f))));
            let _e405 = speed;
            let _e407 = band;
            let _e413 = heading;
            band.drift = vec2<i32>(floor(((((32768f * _e405) * exp2(-(f32(_e407.exponent)))) * _e413) + vec2(0.5f))));
            let _e420 = i;
            let _e423 = band;
            ocean.band[_e420] = _e423;
        }
        continuing {
            let _e83 = i;
            i = (_e83 + 1i);
        }
    }
    let _e425 = ocean;
    ocean.tail = max(_e425.tail, vec2(0f));
    let _e430 = ocean;
    return _e430;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e3 = gabor_ocean_of(wind, 0f, 200000f);
    return _e3;
}

// Adds a node's wave. `from` is the offset from the node in metres, and a window is (value, derivative).
fn gabor_impl_add_water(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3<f32>>, word: u32, from_: vec2<f32>, window_x: vec2<f32>, window_y: vec2<f32>, band: GaborOceanBand, heading: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>) {
    var bits: u32;
    var draw: i32;
    var u_1: i32;
    var local_14: i32;
    var local_15: i32;
    var local_16: i32;
    var at: i32;
    var within_1: i32;
    var local_17: i32;
    var local_18: i32;
    var local_19: i32;
    var lean: i32;
    var frequency_6: i32;
    var ratio: i32;
    var half_sine: i32;
    var cosine: i32;
    var ahead: i32;
    var turning: i32;
    var f_2: f32;
    var s_2: f32;
    var across: vec2<f32>;
    var unit: vec2<f32>;
    var k: vec2<f32>;
    var turns: f32;
    var z_1: vec2<f32>;
    var steps: vec2<f32>;
    var kept: f32;
    var window: f32;
    var wave_5: vec2<f32>;
    var around: vec2<f32>;
    bits = ((word ^ (word >> 15u)) * 3545902487u);
    let _e18 = bits;
    let _e19 = bits;
    bits = (_e18 ^ (_e19 >> 15u));
    let _e23 = bits;
    draw = i32((_e23 >> 22u));
    let _e29 = bits;
    u_1 = ((16i * i32((_e29 & 4095u))) - 32760i);
    let _e37 = draw;
    if (_e37 < band.share.x) {
        local_14 = 0i;
    } else {
        local_14 = 1i;
    }
    let _e44 = local_14;
    let _e45 = draw;
    if (_e45 < band.share.y) {
        local_15 = 0i;
    } else {
        local_15 = 1i;
    }
    let _e52 = local_15;
    let _e54 = draw;
    if (_e54 < band.share.z) {
        local_16 = 0i;
    } else {
        local_16 = 1i;
    }
    let _e61 = local_16;
    at = ((_e44 + _e52) + _e61);
    let _e64 = bits;
    within_1 = (i32((_e64 >> 12u)) & 1023i);
    let _e71 = at;
    if (_e71 == 0i) {
        local_19 = band.lean.x;
    } else {
        let _e76 = at;
        if (_e76 == 1i) {
            local_18 = band.lean.y;
        } else {
            let _e81 = at;
            if (_e81 == 2i) {
                local_17 = band.lean.z;
            } else {
                local_17 = band.lean.w;
            }
            let _e89 = local_17;
            local_18 = _e89;
        }
        let _e91 = local_18;
        local_19 = _e91;
    }
    let _e93 = local_19;
    lean = _e93;
    let _e95 = within_1;
    let _e96 = lean;
    let _e97 = within_1;
    let _e98 = within_1;
    within_1 = (_e95 - ((_e96 * ((_e97 * (_e98 ^ 1023i)) >> 4u)) >> 16u));
    let _e110 = within_1;
    let _e111 = at;
    within_1 = (_e110 + (_e111 << 10u));
    let _e118 = within_1;
    frequency_6 = (band.low + ((band.quarter * _e118) >> 10u));
    let _e127 = within_1;
    ratio = (13777i + ((1427i * _e127) >> 10u));
    let _e134 = u_1;
    let _e139 = u_1;
    let _e140 = u_1;
    half_sine = ((_e134 * (band.spread.x + ((band.spread.y * ((_e139 * _e140) >> 15u)) >> 15u))) >> 15u);
    let _e156 = half_sine;
    let _e157 = half_sine;
    cosine = (32768i - ((_e156 * _e157) >> 14u));
    let _e164 = frequency_6;
    let _e168 = ratio;
    let _e176 = cosine;
    ahead = ((((((_e164 >> 2u) * _e168) >> 13u) >> 3u) * _e176) >> 12u);
    let _e182 = frequency_6;
    let _e183 = ahead;
    turning = (_e182 - _e183);
    let _e187 = frequency_6;
    f_2 = (0.000015258789f * f32(_e187));
    let _e191 = half_sine;
    s_2 = (f32(_e191) / 32768f);
    let _e196 = cosine;
    let _e201 = s_2;
    let _e204 = s_2;
    let _e205 = s_2;
    across = vec2<f32>((f32(_e196) / 32768f), ((2f * _e201) * sqrt(max((1f - (_e204 * _e205)), 0f))));
    let _e214 = across;
    let _e218 = across;
    let _e223 = across;
    let _e227 = across;
    unit = vec2<f32>(((_e214.x * heading.x) - (_e218.y * heading.y)), ((_e223.x * heading.y) + (_e227.y * heading.x)));
    let _e235 = f_2;
    let _e237 = f_2;
    let _e239 = unit;
    k = (((0.6383f * _e235) * _e237) * _e239);
    let _e242 = turning;
    let _e251 = turning;
    turns = (f32((((_e242 & 65535i) * (second & 65535i)) & 65535i)) + (f32(_e251) * fraction));
    let _e256 = gabor_impl_amplitude(word);
    let _e257 = k;
    let _e260 = turns;
    let _e263 = gabor_impl_wave((dot(_e257, from_) - (0.000015258789f * _e260)));
    let _e264 = gabor_impl_product(_e256, _e263);
    z_1 = _e264;
    let _e266 = k;
    let _e268 = k;
    steps = vec2<f32>(dot(_e266, dx), dot(_e268, dy));
    let _e274 = steps;
    let _e275 = steps;
    kept = exp((-4.934802f * dot(_e274, _e275)));
    window = (window_x.x * window_y.x);
    let _e284 = z_1;
    let _e285 = kept;
    z_1 = (_e284 * _e285);
    let _e287 = window;
    let _e288 = z_1;
    wave_5 = (_e287 * _e288);
    let _e292 = k;
    around = (6.2831855f * _e292);
    let _e296 = (*sum);
    let _e298 = wave_5;
    (*sum).height = (_e296.height + _e298.y);
    let _e302 = (*sum);
    let _e304 = wave_5;
    let _e306 = around;
    let _e308 = z_1;
    (*sum).slope = (_e302.slope + ((_e304.x * _e306) + (_e308.y * vec2<f32>((window_x.y * window_y.x), (window_x.x * window_y.y)))));
    let _e321 = (*sum);
    let _e323 = wave_5;
    let _e325 = unit;
    (*sum).shift = (_e321.shift + (_e323.x * _e325));
    let _e328 = (*squeeze);
    let _e329 = wave_5;
    let _e331 = around;
    let _e332 = unit;
    let _e333 = (_e331 * _e332);
    let _e334 = around;
    let _e336 = unit;
    (*squeeze) = (_e328 + (_e329.y * vec3<f32>(_e333.x, _e333.y, (_e334.x * _e336.y))));
    let _e345 = (*sum);
    let _e350 = window;
    let _e352 = window;
    let _e355 = kept;
    let _e356 = kept;
    let _e360 = around;
    let _e361 = around;
    let _e362 = (_e360 * _e361);
    let _e363 = around;
    let _e365 = around;
    (*sum).lost = (_e345.lost + (((((band.amplitude * band.amplitude) * _e350) * _e352) * (1f - (_e355 * _e356))) * vec3<f32>(_e362.x, _e362.y, (_e363.x * _e365.y))));
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

fn gabor_water_at(cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, ocean: GaborOcean, seed: u32) -> GaborWater {
    var heading_2: vec2<f32>;
    var water: GaborWater = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
    var squeezed: vec3<f32> = vec3(0f);
    var hidden: vec2<f32>;
    var area: f32;
    var sides: f32;
    var least: f32;
    var i_1: i32 = 0i;
    var band_2: GaborOceanBand;
    var longest: f32;
    var salt_4: u32;
    var whole_x: i32;
    var whole_y: i32;
    var rest_x: f32;
    var rest_y: f32;
    var zero_1: vec2<f32>;
    var offset: vec2<f32>;
    var node: vec2<i32>;
    var x_5: vec4<f32>;
    var y_4: vec4<f32>;
    var slope_x: vec4<f32>;
    var slope_y: vec4<f32>;
    var spacing: f32;
    var left: u32;
    var middle_1: u32;
    var right: u32;
    var sum_7: GaborWater;
    var squeeze_1: vec3<f32>;
    var j_2: i32;
    var row_1: u32;
    var local_22: vec2<f32>;
    var local_23: vec2<f32>;
    var window_1: vec2<f32>;
    var from_1: vec2<f32>;
    var local_24: f32;
    var scale_2: f32;
    var local_25: f32;
    var local_26: f32;
    var along_1: vec3<f32>;
    var across_1: vec3<f32>;
    let _e11 = gabor_impl_wave((0.15915494f * ocean.direction));
    heading_2 = _e11;
    hidden = ocean.tail;
    area = ((dx.x * dy.y) - (dx.y * dy.x));
    sides = (dot(dx, dx) + dot(dy, dy));
    let _e41 = area;
    let _e43 = area;
    let _e45 = sides;
    let _e46 = sides;
    let _e47 = sides;
    let _e50 = area;
    let _e52 = area;
    least = (((2f * _e41) * _e43) / max((_e45 + sqrt(max(((_e46 * _e47) - ((4f * _e50) * _e52)), 0f))), 0.000000000000000000000000000001f));
    loop {
        let _e65 = i_1;
        if !((_e65 < 9i)) {
            break;
        }
        {
            let _e72 = i_1;
            band_2 = ocean.band[_e72];
            let _e77 = band_2;
            let _e81 = band_2;
            longest = ((0.0000000001486f * f32(_e77.low)) * f32(_e81.low));
            let _e86 = band_2;
            let _e90 = longest;
            let _e91 = longest;
            let _e93 = least;
            if ((_e86.amplitude == 0f) || (((_e90 * _e91) * _e93) > 1.6f)) {
                {
                    let _e98 = hidden;
                    let _e99 = band_2;
                    hidden = (_e98 + _e99.slopes);
                    continue;
                }
            }
            let _e102 = i_1;
            let _e103 = gabor_lobe_seed(seed, _e102);
            let _e104 = gabor_impl_salt(_e103);
            salt_4 = _e104;
            let _e112 = band_2;
            let _e114 = band_2;
            gabor_impl_float_by(cell.x, local.x, _e112.exponent, _e114.drift.x, second, fraction, (&whole_x), (&rest_x));
            let _e123 = band_2;
            let _e125 = band_2;
            gabor_impl_float_by(cell.y, local.y, _e123.exponent, _e125.drift.y, second, fraction, (&whole_y), (&rest_y));
            let _e132 = rest_x;
            let _e133 = rest_y;
            zero_1 = floor((vec2<f32>(_e132, _e133) + vec2(0.5f)));
            let _e140 = rest_x;
            let _e141 = rest_y;
            let _e143 = zero_1;
            offset = clamp((vec2<f32>(_e140, _e141) - _e143), vec2(-0.5f), vec2(0.5f));
            let _e152 = whole_x;
            let _e153 = whole_y;
            let _e155 = zero_1;
            node = (vec2<i32>(_e152, _e153) + vec2<i32>(_e155));
            let _e163 = offset;
            gabor_impl_windows(_e163.x, (&x_5), (&slope_x));
            let _e169 = offset;
            gabor_impl_windows(_e169.y, (&y_4), (&slope_y));
            let _e175 = band_2;
            spacing = exp2(f32(_e175.exponent));
            let _e180 = slope_x;
            let _e185 = spacing;
            slope_x = (_e180 / vec4((1.5f * _e185)));
            let _e189 = slope_y;
            let _e194 = spacing;
            slope_y = (_e189 / vec4((1.5f * _e194)));
            let _e198 = node;
            let _e202 = salt_4;
            let _e203 = gabor_impl_line_word((_e198.x - 1i), _e202);
            left = _e203;
            let _e205 = node;
            let _e207 = salt_4;
            let _e208 = gabor_impl_line_word(_e205.x, _e207);
            middle_1 = _e208;
            let _e210 = node;
            let _e214 = salt_4;
            let _e215 = gabor_impl_line_word((_e210.x + 1i), _e214);
            right = _e215;
            sum_7 = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
            squeeze_1 = vec3(0f);
            j_2 = 0i;
            loop {
                let _e232 = j_2;
                if !((_e232 < 3i)) {
                    break;
                }
                {
                    let _e239 = node;
                    let _e241 = j_2;
                    let _e245 = salt_4;
                    let _e248 = gabor_impl_line_word(((_e239.y + _e241) - 1i), (_e245 ^ 1540483477u));
                    row_1 = _e248;
                    let _e250 = j_2;
                    if (_e250 == 0i) {
                        let _e253 = y_4;
                        let _e255 = slope_y;
                        local_23 = vec2<f32>(_e253.x, _e255.x);
                    } else {
                        let _e258 = j_2;
                        if (_e258 == 1i) {
                            let _e261 = y_4;
                            let _e263 = slope_y;
                            local_22 = vec2<f32>(_e261.y, _e263.y);
                        } else {
                            let _e266 = y_4;
                            let _e268 = slope_y;
                            local_22 = vec2<f32>(_e266.z, _e268.z);
                        }
                        let _e272 = local_22;
                        local_23 = _e272;
                    }
                    let _e274 = local_23;
                    window_1 = _e274;
                    let _e276 = spacing;
                    let _e277 = offset;
                    let _e280 = j_2;
                    from_1 = (_e276 * (_e277 + vec2<f32>(1f, (1f - f32(_e280)))));
                    let _e289 = row_1;
                    let _e290 = left;
                    let _e292 = from_1;
                    let _e293 = x_5;
                    let _e295 = slope_x;
                    let _e298 = window_1;
                    let _e299 = band_2;
                    let _e300 = heading_2;
                    gabor_impl_add_water((&sum_7), (&squeeze_1), (_e289 * _e290), _e292, vec2<f32>(_e293.x, _e295.x), _e298, _e299, _e300, second, fraction, dx, dy);
                    let _e304 = from_1;
                    let _e306 = spacing;
                    from_1.x = (_e304.x - _e306);
                    let _e310 = row_1;
                    let _e311 = middle_1;
                    let _e313 = from_1;
                    let _e314 = x_5;
                    let _e316 = slope_x;
                    let _e319 = window_1;
                    let _e320 = band_2;
                    let _e321 = heading_2;
                    gabor_impl_add_water((&sum_7), (&squeeze_1), (_e310 * _e311), _e313, vec2<f32>(_e314.y, _e316.y), _e319, _e320, _e321, second, fraction, dx, dy);
                    let _e325 = from_1;
                    let _e327 = spacing;
                    from_1.x = (_e325.x - _e327);
                    let _e331 = row_1;
                    let _e332 = right;
                    let _e334 = from_1;
                    let _e335 = x_5;
                    let _e337 = slope_x;
                    let _e340 = window_1;
                    let _e341 = band_2;
                    let _e342 = heading_2;
                    gabor_impl_add_water((&sum_7), (&squeeze_1), (_e331 * _e332), _e334, vec2<f32>(_e335.z, _e337.z), _e340, _e341, _e342, second, fraction, dx, dy);
                }
                continuing {
                    let _e236 = j_2;
                    j_2 = (_e236 + 1i);
                }
            }
            let _e345 = band_2;
            if false {
                local_24 = 1f;
            } else {
                local_24 = 1.125f;
            }
            let _e357 = local_24;
            scale_2 = (_e345.amplitude / (1459955300000000000000000000f * _e357));
            let _e362 = water;
            let _e364 = scale_2;
            let _e365 = sum_7;
            water.height = (_e362.height + (_e364 * _e365.height));
            let _e370 = water;
            let _e372 = scale_2;
            let _e373 = sum_7;
            water.slope = (_e370.slope + (_e372 * _e373.slope));
            let _e378 = water;
            let _e380 = scale_2;
            let _e381 = sum_7;
            water.shift = (_e378.shift + (_e380 * _e381.shift));
            let _e385 = squeezed;
            let _e386 = scale_2;
            let _e387 = squeeze_1;
            squeezed = (_e385 + (_e386 * _e387));
            let _e391 = water;
            let _e393 = sum_7;
            if false {
                local_25 = 1f;
            } else {
                local_25 = 1.125f;
            }
            let _e404 = local_25;
            if false {
                local_26 = 1f;
            } else {
                local_26 = 1.125f;
            }
            let _e414 = local_26;
            water.lost = (_e391.lost + (_e393.lost / vec3((_e404 * _e414))));
        }
        continuing {
            let _e69 = i_1;
            i_1 = (_e69 + 1i);
        }
    }
    let _e421 = squeezed;
    let _e425 = squeezed;
    let _e429 = squeezed;
    let _e431 = squeezed;
    water.fold = (((1f - _e421.x) * (1f - _e425.y)) - (_e429.z * _e431.z));
    let _e435 = heading_2;
    let _e436 = heading_2;
    let _e437 = (_e435 * _e436);
    let _e438 = heading_2;
    let _e440 = heading_2;
    along_1 = vec3<f32>(_e437.x, _e437.y, (_e438.x * _e440.y));
    let _e447 = along_1;
    let _e448 = _e447.yx;
    let _e449 = along_1;
    across_1 = vec3<f32>(_e448.x, _e448.y, -(_e449.z));
    let _e457 = water;
    let _e459 = hidden;
    let _e461 = along_1;
    let _e463 = hidden;
    let _e465 = across_1;
    water.lost = (_e457.lost + ((_e459.x * _e461) + (_e463.y * _e465)));
    let _e469 = water;
    return _e469;
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
    var at_1: vec2<f32>;
    var i_2: i32 = 0i;
    at_1 = p;
    loop {
        let _e7 = i_2;
        if !((_e7 < 5i)) {
            break;
        }
        let _e14 = at_1;
        let _e15 = gabor_water(_e14, seconds, ocean, seed);
        at_1 = (p - _e15.shift);
        continuing {
            let _e11 = i_2;
            i_2 = (_e11 + 1i);
        }
    }
    let _e18 = at_1;
    let _e19 = gabor_water(_e18, seconds, ocean, seed);
    return _e19.height;
}

