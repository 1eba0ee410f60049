// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 16c365bd8048380e.
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
            let _e324 = sum_5;
            band.amplitude = sqrt(_e324);
            let _e327 = slopes;
            let _e330 = along;
            let _e332 = along;
            band.slopes = ((_e327 * 16.195057f) * vec2<f32>(_e330, (1f - _e332)));
            let _e337 = ocean;
            let _e339 = band;
            ocean.tail = (_e337.tail - _e339.slopes);
            let _e345 = power_1;
            let _e348 = i;
            band.exponent = ((34i - (2i * _e345)) - _e348);
            let _e351 = low;
            band.low = i32((_e351 + 0.5f));
            let _e356 = width;
            band.quarter = i32((_e356 + 0.5f));
            let _e362 = sum_5;
            let _e364 = sums_1;
            band.share = vec3<i32>((((1024f / _e362) * _e364.xyz) + vec3(0.5f)));
            let _e373 = leans;
            band.lean = vec4<i32>(floor(((1024f * _e373) + vec4(0.5f))));
            let _e382 = a_2;
            let _e383 = b_2;
            band.spread = vec2<i32>(floor(((32767f * vec2<f32>(_e382, _e383)) + vec2(0.5f))));
            let _e393 = speed;
            let _e395 = band;
            let _e401 = heading;
            band.drift = vec2<i32>(floor(((((32768f * _e393) * exp2(-(f32(_e395.exponent)))) * _e401) + vec2(0.5f))));
            let _e408 = i;
            let _e411 = band;
            ocean.band[_e408] = _e411;
        }
        continuing {
            let _e83 = i;
            i = (_e83 + 1i);
        }
    }
    let _e413 = ocean;
    ocean.tail = max(_e413.tail, vec2(0f));
    let _e418 = ocean;
    return _e418;
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
    var local_13: i32;
    var local_14: i32;
    var local_15: i32;
    var at: i32;
    var within_1: i32;
    var local_16: i32;
    var local_17: i32;
    var local_18: i32;
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
        local_13 = 0i;
    } else {
        local_13 = 1i;
    }
    let _e44 = local_13;
    let _e45 = draw;
    if (_e45 < band.share.y) {
        local_14 = 0i;
    } else {
        local_14 = 1i;
    }
    let _e52 = local_14;
    let _e54 = draw;
    if (_e54 < band.share.z) {
        local_15 = 0i;
    } else {
        local_15 = 1i;
    }
    let _e61 = local_15;
    at = ((_e44 + _e52) + _e61);
    let _e64 = bits;
    within_1 = (i32((_e64 >> 12u)) & 1023i);
    let _e71 = at;
    if (_e71 == 0i) {
        local_18 = band.lean.x;
    } else {
        let _e76 = at;
        if (_e76 == 1i) {
            local_17 = band.lean.y;
        } else {
            let _e81 = at;
            if (_e81 == 2i) {
                local_16 = band.lean.z;
            } else {
                local_16 = band.lean.w;
            }
            let _e89 = local_16;
            local_17 = _e89;
        }
        let _e91 = local_17;
        local_18 = _e91;
    }
    let _e93 = local_18;
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
    var local_21: vec2<f32>;
    var local_22: vec2<f32>;
    var window_1: vec2<f32>;
    var from_1: vec2<f32>;
    var local_23: f32;
    var scale_2: f32;
    var local_24: f32;
    var local_25: f32;
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
            let _e86 = longest;
            let _e87 = longest;
            let _e89 = least;
            if (((_e86 * _e87) * _e89) > 1.6f) {
                {
                    let _e93 = hidden;
                    let _e94 = band_2;
                    hidden = (_e93 + _e94.slopes);
                    continue;
                }
            }
            let _e97 = i_1;
            let _e98 = gabor_lobe_seed(seed, _e97);
            let _e99 = gabor_impl_salt(_e98);
            salt_4 = _e99;
            let _e107 = band_2;
            let _e109 = band_2;
            gabor_impl_float_by(cell.x, local.x, _e107.exponent, _e109.drift.x, second, fraction, (&whole_x), (&rest_x));
            let _e118 = band_2;
            let _e120 = band_2;
            gabor_impl_float_by(cell.y, local.y, _e118.exponent, _e120.drift.y, second, fraction, (&whole_y), (&rest_y));
            let _e127 = rest_x;
            let _e128 = rest_y;
            zero_1 = floor((vec2<f32>(_e127, _e128) + vec2(0.5f)));
            let _e135 = rest_x;
            let _e136 = rest_y;
            let _e138 = zero_1;
            offset = clamp((vec2<f32>(_e135, _e136) - _e138), vec2(-0.5f), vec2(0.5f));
            let _e147 = whole_x;
            let _e148 = whole_y;
            let _e150 = zero_1;
            node = (vec2<i32>(_e147, _e148) + vec2<i32>(_e150));
            let _e158 = offset;
            gabor_impl_windows(_e158.x, (&x_5), (&slope_x));
            let _e164 = offset;
            gabor_impl_windows(_e164.y, (&y_4), (&slope_y));
            let _e170 = band_2;
            spacing = exp2(f32(_e170.exponent));
            let _e175 = slope_x;
            let _e180 = spacing;
            slope_x = (_e175 / vec4((1.5f * _e180)));
            let _e184 = slope_y;
            let _e189 = spacing;
            slope_y = (_e184 / vec4((1.5f * _e189)));
            let _e193 = node;
            let _e197 = salt_4;
            let _e198 = gabor_impl_line_word((_e193.x - 1i), _e197);
            left = _e198;
            let _e200 = node;
            let _e202 = salt_4;
            let _e203 = gabor_impl_line_word(_e200.x, _e202);
            middle_1 = _e203;
            let _e205 = node;
            let _e209 = salt_4;
            let _e210 = gabor_impl_line_word((_e205.x + 1i), _e209);
            right = _e210;
            sum_7 = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
            squeeze_1 = vec3(0f);
            j_2 = 0i;
            loop {
                let _e227 = j_2;
                if !((_e227 < 3i)) {
                    break;
                }
                {
                    let _e234 = node;
                    let _e236 = j_2;
                    let _e240 = salt_4;
                    let _e243 = gabor_impl_line_word(((_e234.y + _e236) - 1i), (_e240 ^ 1540483477u));
                    row_1 = _e243;
                    let _e245 = j_2;
                    if (_e245 == 0i) {
                        let _e248 = y_4;
                        let _e250 = slope_y;
                        local_22 = vec2<f32>(_e248.x, _e250.x);
                    } else {
                        let _e253 = j_2;
                        if (_e253 == 1i) {
                            let _e256 = y_4;
                            let _e258 = slope_y;
                            local_21 = vec2<f32>(_e256.y, _e258.y);
                        } else {
                            let _e261 = y_4;
                            let _e263 = slope_y;
                            local_21 = vec2<f32>(_e261.z, _e263.z);
                        }
                        let _e267 = local_21;
                        local_22 = _e267;
                    }
                    let _e269 = local_22;
                    window_1 = _e269;
                    let _e271 = spacing;
                    let _e272 = offset;
                    let _e275 = j_2;
                    from_1 = (_e271 * (_e272 + vec2<f32>(1f, (1f - f32(_e275)))));
                    let _e284 = row_1;
                    let _e285 = left;
                    let _e287 = from_1;
                    let _e288 = x_5;
                    let _e290 = slope_x;
                    let _e293 = window_1;
                    let _e294 = band_2;
                    let _e295 = heading_2;
                    gabor_impl_add_water((&sum_7), (&squeeze_1), (_e284 * _e285), _e287, vec2<f32>(_e288.x, _e290.x), _e293, _e294, _e295, second, fraction, dx, dy);
                    let _e299 = from_1;
                    let _e301 = spacing;
                    from_1.x = (_e299.x - _e301);
                    let _e305 = row_1;
                    let _e306 = middle_1;
                    let _e308 = from_1;
                    let _e309 = x_5;
                    let _e311 = slope_x;
                    let _e314 = window_1;
                    let _e315 = band_2;
                    let _e316 = heading_2;
                    gabor_impl_add_water((&sum_7), (&squeeze_1), (_e305 * _e306), _e308, vec2<f32>(_e309.y, _e311.y), _e314, _e315, _e316, second, fraction, dx, dy);
                    let _e320 = from_1;
                    let _e322 = spacing;
                    from_1.x = (_e320.x - _e322);
                    let _e326 = row_1;
                    let _e327 = right;
                    let _e329 = from_1;
                    let _e330 = x_5;
                    let _e332 = slope_x;
                    let _e335 = window_1;
                    let _e336 = band_2;
                    let _e337 = heading_2;
                    gabor_impl_add_water((&sum_7), (&squeeze_1), (_e326 * _e327), _e329, vec2<f32>(_e330.z, _e332.z), _e335, _e336, _e337, second, fraction, dx, dy);
                }
                continuing {
                    let _e231 = j_2;
                    j_2 = (_e231 + 1i);
                }
            }
            let _e340 = band_2;
            if false {
                local_23 = 1f;
            } else {
                local_23 = 1.125f;
            }
            let _e352 = local_23;
            scale_2 = (_e340.amplitude / (1459955300000000000000000000f * _e352));
            let _e357 = water;
            let _e359 = scale_2;
            let _e360 = sum_7;
            water.height = (_e357.height + (_e359 * _e360.height));
            let _e365 = water;
            let _e367 = scale_2;
            let _e368 = sum_7;
            water.slope = (_e365.slope + (_e367 * _e368.slope));
            let _e373 = water;
            let _e375 = scale_2;
            let _e376 = sum_7;
            water.shift = (_e373.shift + (_e375 * _e376.shift));
            let _e380 = squeezed;
            let _e381 = scale_2;
            let _e382 = squeeze_1;
            squeezed = (_e380 + (_e381 * _e382));
            let _e386 = water;
            let _e388 = sum_7;
            if false {
                local_24 = 1f;
            } else {
                local_24 = 1.125f;
            }
            let _e399 = local_24;
            if false {
                local_25 = 1f;
            } else {
                local_25 = 1.125f;
            }
            let _e409 = local_25;
            water.lost = (_e386.lost + (_e388.lost / vec3((_e399 * _e409))));
        }
        continuing {
            let _e69 = i_1;
            i_1 = (_e69 + 1i);
        }
    }
    let _e416 = squeezed;
    let _e420 = squeezed;
    let _e424 = squeezed;
    let _e426 = squeezed;
    water.fold = (((1f - _e416.x) * (1f - _e420.y)) - (_e424.z * _e426.z));
    let _e430 = heading_2;
    let _e431 = heading_2;
    let _e432 = (_e430 * _e431);
    let _e433 = heading_2;
    let _e435 = heading_2;
    along_1 = vec3<f32>(_e432.x, _e432.y, (_e433.x * _e435.y));
    let _e442 = along_1;
    let _e443 = _e442.yx;
    let _e444 = along_1;
    across_1 = vec3<f32>(_e443.x, _e443.y, -(_e444.z));
    let _e452 = water;
    let _e454 = hidden;
    let _e456 = along_1;
    let _e458 = hidden;
    let _e460 = across_1;
    water.lost = (_e452.lost + ((_e454.x * _e456) + (_e458.y * _e460)));
    let _e464 = water;
    return _e464;
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

