// gabor_noise.wgsl: fast, normalized Gabor noise in two dimensions, for WGSL.
//
// Made from shaders/gabor_noise.glsl: change that file, not this one.
// By tools/translate, naga 30.0.1.
//
// Functions to call, at the end of the file:
//     gabor_noise, gabor_unorm                the noise, and to show it
//     gabor_noise_gradient                    with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor       with its quadrature: phase and intensity
//     gabor_noise_four                        four uncorrelated ones at once
//     gabor_noise_tiled, gabor_noise_animated with exact periods in space, and in time
//     gabor_kernel, gabor_field               all of it by integer cell and local offset, for large worlds
//
// The noise is a sum of Gabor kernels around random places x_i (sparse convolution):
//
//     n(p) = K sum_i w_i g_i(p - x_i),     g_i(d) = q(d.x) q(d.y) sin(2 pi (F d.omega + phase_i))
//
// after Tavernier, Neyret, Vergne and Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019 [TNVT19]:
// a fixed number of impulses in each cell of a grid instead of Poisson counts, and weights that vary little. The unit
// of length is the kernel radius: the window q ends at 1, where it and its slope are 0. K makes the variance exactly 1
// at every frequency and every place.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

const GABOR_NOISE_VERSION: u32 = 100u;

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project), the salt entering between them too, so that no two sequences share a run.
fn gabor_mix(word: u32, salt: u32) -> u32 {
    var word_1: u32;

    word_1 = word;
    let _e3 = word_1;
    let _e4 = word_1;
    word_1 = (((_e3 ^ (_e4 >> 16u)) * 569420461u) + salt);
    let _e11 = word_1;
    let _e12 = word_1;
    word_1 = ((_e11 ^ (_e12 >> 15u)) * 3545902487u);
    let _e18 = word_1;
    let _e19 = word_1;
    return (_e18 ^ (_e19 >> 15u));
}

// The word of `seed`, from which those of the rows follow.
fn gabor_seed_word(seed: u32) -> u32 {
    let _e4 = gabor_mix((seed * 2654435761u), 625341585u);
    return _e4;
}

// The word of a row of cells, from which those of its impulses follow.
fn gabor_row_word(row: i32, seed_word: u32) -> u32 {
    let _e6 = gabor_mix(((u32(row) * 2654435761u) + seed_word), seed_word);
    return _e6;
}

// The word of impulse `index` in a cell; everything about the impulse is in its bits:
//     0 to 22   y in the cell            8 to 30   x in the cell
//     0 to 7    phase                    31        magnitude
//     8 to 10   turns of its phase while time goes by 1
// so the finest bits of a coordinate serve twice. Within 1/256 of a cell, far below what shows, x follows y.
fn gabor_impulse_word(column: i32, row_word: u32, index: i32) -> u32 {
    var salt_1: u32;

    salt_1 = (row_word + (u32(index) * 2246822507u));
    let _e11 = salt_1;
    let _e13 = salt_1;
    let _e14 = gabor_mix(((u32(column) * 2654435761u) + _e11), _e13);
    return _e14;
}

// Place of an impulse in its cell, plus 1: in [1, 2)^2.
fn gabor_place_plus_one(word: u32) -> vec2<f32> {
    return vec2<f32>(bitcast<f32>((1065353216u | ((word >> 8u) & 8388607u))), bitcast<f32>((1065353216u | (word & 8388607u))));
}

// Phase of the impulse at that place, in turns.
fn gabor_phase(place_plus_one: vec2<f32>) -> f32 {
    return fract((place_plus_one.y * 32768f));
}

// Turns of an impulse's phase while time goes by 1: -4 to -1 or 1 to 4.
fn gabor_tempo(word: u32) -> f32 {
    var turns: f32;
    var local: f32;

    turns = (f32(((word >> 8u) & 7u)) - 4f);
    let _e9 = turns;
    if (_e9 < 0f) {
        let _e12 = turns;
        local = _e12;
    } else {
        let _e13 = turns;
        local = (_e13 + 1f);
    }
    let _e17 = local;
    return _e17;
}

// The wave, as (cos, sin), in four channels, each shifted by its own number of quarter turns.
fn gabor_four(wave: vec2<f32>, word: u32) -> vec4<f32> {
    var quarters: u32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var shifted: vec4<f32>;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;

    let _e3 = gabor_mix(word, 2246822507u);
    quarters = _e3;
    let _e5 = quarters;
    if ((_e5 & 1u) == 0u) {
        local_1 = wave.y;
    } else {
        local_1 = wave.x;
    }
    let _e13 = local_1;
    let _e14 = quarters;
    if ((_e14 & 2u) == 0u) {
        local_2 = wave.y;
    } else {
        local_2 = wave.x;
    }
    let _e22 = local_2;
    let _e23 = quarters;
    if ((_e23 & 4u) == 0u) {
        local_3 = wave.y;
    } else {
        local_3 = wave.x;
    }
    let _e31 = local_3;
    let _e32 = quarters;
    if ((_e32 & 8u) == 0u) {
        local_4 = wave.y;
    } else {
        local_4 = wave.x;
    }
    let _e40 = local_4;
    shifted = vec4<f32>(_e13, _e22, _e31, _e40);
    let _e43 = shifted;
    let _e44 = quarters;
    if ((_e44 & 16u) == 0u) {
        local_5 = 1f;
    } else {
        local_5 = -1f;
    }
    let _e53 = local_5;
    let _e54 = quarters;
    if ((_e54 & 32u) == 0u) {
        local_6 = 1f;
    } else {
        local_6 = -1f;
    }
    let _e63 = local_6;
    let _e64 = quarters;
    if ((_e64 & 64u) == 0u) {
        local_7 = 1f;
    } else {
        local_7 = -1f;
    }
    let _e73 = local_7;
    let _e74 = quarters;
    if ((_e74 & 128u) == 0u) {
        local_8 = 1f;
    } else {
        local_8 = -1f;
    }
    let _e83 = local_8;
    return (_e43 * vec4<f32>(_e53, _e63, _e73, _e83));
}

// Magnitude of an impulse's weight.
fn gabor_magnitude(word: u32) -> f32 {
    var local_9: f32;

    if (i32(word) < 0i) {
        local_9 = 1f;
    } else {
        local_9 = 0.675f;
    }
    let _e7 = local_9;
    return _e7;
}

// sin(2 pi t) for any t: reduced to half a turn, then t (1/4 - t^2) times a minimax polynomial in t^2.
// Absolute error below 3e-7 within +-1, growing with the rounding of t beyond.
fn gabor_sin_turns(t: f32) -> f32 {
    var t_1: f32;
    var s: f32;
    var p: f32;

    t_1 = t;
    let _e2 = t_1;
    t_1 = (fract(_e2) - 0.5f);
    if false {
        let _e10 = t_1;
        return -(sin((6.2831855f * _e10)));
    }
    let _e14 = t_1;
    let _e15 = t_1;
    s = (_e14 * _e15);
    let _e19 = s;
    p = ((12.233303f * _e19) - 38.123196f);
    let _e24 = p;
    let _e25 = s;
    p = ((_e24 * _e25) + 67.0439f);
    let _e29 = p;
    let _e30 = s;
    p = ((_e29 * _e30) - 64.83468f);
    let _e34 = p;
    let _e35 = s;
    p = ((_e34 * _e35) + 25.13273f);
    let _e39 = t_1;
    let _e40 = s;
    let _e44 = p;
    return ((_e39 * (_e40 - 0.25f)) * _e44);
}

// The unit vector at an angle in radians: reduced by pi/2 in three steps, then minimax polynomials. Its error stays
// near 1e-7, for a large frequency multiplies it.
fn gabor_direction(angle: f32) -> vec2<f32> {
    var quarter: f32;
    var r: f32;
    var local_10: f32;
    var s_1: f32;
    var sine: f32;
    var cosine: f32;
    var local_11: vec2<f32>;
    var axis: vec2<f32>;
    var local_12: vec2<f32>;

    quarter = floor(((angle * 0.63661975f) + 0.5f));
    let _e7 = quarter;
    r = (angle - (_e7 * 1.5703125f));
    let _e12 = r;
    let _e13 = quarter;
    r = (_e12 - (_e13 * 0.0004837513f));
    let _e17 = r;
    let _e18 = quarter;
    r = (_e17 - (_e18 * 0.0000000754979f));
    let _e22 = r;
    if (abs(_e22) < 1f) {
        let _e26 = r;
        local_10 = _e26;
    } else {
        local_10 = 0f;
    }
    let _e29 = local_10;
    r = _e29;
    let _e30 = r;
    let _e31 = r;
    s_1 = (_e30 * _e31);
    let _e34 = r;
    let _e35 = r;
    let _e36 = s_1;
    let _e40 = s_1;
    let _e42 = s_1;
    sine = (_e34 + ((_e35 * _e36) * (-0.16666654f + (_e40 * (0.008332161f - (_e42 * 0.00019515296f))))));
    let _e53 = s_1;
    let _e56 = s_1;
    let _e57 = s_1;
    let _e60 = s_1;
    let _e63 = s_1;
    cosine = ((1f - (0.5f * _e53)) + ((_e56 * _e57) * (0.041666646f + (_e60 * (-0.0013887316f + (_e63 * 0.000024433157f))))));
    let _e73 = quarter;
    if (fract((0.5f * _e73)) < 0.25f) {
        let _e78 = cosine;
        let _e79 = sine;
        local_11 = vec2<f32>(_e78, _e79);
    } else {
        let _e81 = sine;
        let _e83 = cosine;
        local_11 = vec2<f32>(-(_e81), _e83);
    }
    let _e86 = local_11;
    axis = _e86;
    let _e89 = quarter;
    if (fract((0.25f * _e89)) < 0.375f) {
        let _e94 = axis;
        local_12 = _e94;
    } else {
        let _e95 = axis;
        local_12 = -(_e95);
    }
    let _e98 = local_12;
    return _e98;
}

// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). The five c_n I_n, whose sum is the energy of one axis:
struct GaborEnergy {
    e4567_: vec4<f32>,
    e8_: f32,
    sum: f32,
}

fn gabor_energy() -> GaborEnergy {
    var c: vec3<f32> = vec3<f32>(3f, -4.5f, 2.5f);
    var energy: GaborEnergy;

    let _e8 = c;
    let _e10 = c;
    let _e14 = c;
    let _e17 = c;
    let _e20 = c;
    let _e22 = c;
    let _e26 = c;
    let _e29 = c;
    let _e34 = c;
    let _e37 = c;
    energy.e4567_ = (vec4<f32>((_e8.x * _e10.x), ((2f * _e14.x) * _e17.y), ((_e20.y * _e22.y) + ((2f * _e26.x) * _e29.z)), ((2f * _e34.y) * _e37.z)) * vec4<f32>(0.8126984f, 0.73881674f, 0.68198466f, 0.636519f));
    let _e56 = c;
    let _e58 = c;
    energy.e8_ = ((_e56.z * _e58.z) * 0.59907675f);
    let _e66 = energy;
    let _e71 = energy;
    energy.sum = (dot(_e66.e4567_, vec4(1f)) + _e71.e8_);
    let _e74 = energy;
    return _e74;
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the share by which one axis
// of a sine kernel of k cycles falls short of its energy at high frequency. For small a from 1 - L_n by the power
// series of L_7 and L_8 and downward recurrence; for large a by upward recurrence from L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
fn gabor_deficit(k: f32, energy: GaborEnergy) -> f32 {
    var a: f32;
    var z: f32;
    var d4567_: vec4<f32>;
    var d8_: f32 = 0f;
    var d7_: f32 = 0f;
    var term7_: f32 = 1f;
    var term8_: f32 = 1f;
    var i: i32 = 1i;
    var n: f32;
    var d6_: f32;
    var d5_: f32;
    var d4_: f32;
    var y: f32;
    var l0_: f32;
    var l1_: f32;
    var l2_: f32;
    var l3_: f32;
    var l4_: f32;
    var l5_: f32;
    var l6_: f32;
    var l7_: f32;

    a = (12.566371f * k);
    let _e5 = a;
    let _e6 = a;
    z = (_e5 * _e6);
    let _e12 = z;
    if (_e12 < 64f) {
        {
            loop {
                let _e23 = i;
                if !((_e23 <= 14i)) {
                    break;
                }
                {
                    let _e30 = i;
                    n = f32(_e30);
                    let _e33 = term7_;
                    let _e36 = z;
                    let _e38 = n;
                    let _e39 = n;
                    term7_ = (_e33 * ((-0.25f * _e36) / (_e38 * (_e39 + 7.5f))));
                    let _e45 = term8_;
                    let _e48 = z;
                    let _e50 = n;
                    let _e51 = n;
                    term8_ = (_e45 * ((-0.25f * _e48) / (_e50 * (_e51 + 8.5f))));
                    let _e57 = d7_;
                    let _e58 = term7_;
                    d7_ = (_e57 - _e58);
                    let _e60 = d8_;
                    let _e61 = term8_;
                    d8_ = (_e60 - _e61);
                }
                continuing {
                    let _e27 = i;
                    i = (_e27 + 1i);
                }
            }
            let _e63 = d7_;
            let _e64 = z;
            let _e66 = d8_;
            d6_ = (_e63 + ((_e64 * (1f - _e66)) * 0.003921569f));
            let _e75 = d6_;
            let _e76 = z;
            let _e78 = d7_;
            d5_ = (_e75 + ((_e76 * (1f - _e78)) * 0.0051282053f));
            let _e87 = d5_;
            let _e88 = z;
            let _e90 = d6_;
            d4_ = (_e87 + ((_e88 * (1f - _e90)) * 0.006993007f));
            let _e99 = d4_;
            let _e100 = d5_;
            let _e101 = d6_;
            let _e102 = d7_;
            d4567_ = vec4<f32>(_e99, _e100, _e101, _e102);
        }
    } else {
        {
            let _e105 = z;
            y = (1f / _e105);
            let _e110 = gabor_sin_turns((2f * k));
            let _e111 = a;
            l0_ = (_e110 / _e111);
            let _e115 = y;
            let _e117 = l0_;
            let _e122 = gabor_sin_turns(((2f * k) + 0.25f));
            l1_ = ((3f * _e115) * (_e117 - _e122));
            let _e127 = y;
            let _e129 = l1_;
            let _e130 = l0_;
            l2_ = ((15f * _e127) * (_e129 - _e130));
            let _e135 = y;
            let _e137 = l2_;
            let _e138 = l1_;
            l3_ = ((35f * _e135) * (_e137 - _e138));
            let _e143 = y;
            let _e145 = l3_;
            let _e146 = l2_;
            l4_ = ((63f * _e143) * (_e145 - _e146));
            let _e151 = y;
            let _e153 = l4_;
            let _e154 = l3_;
            l5_ = ((99f * _e151) * (_e153 - _e154));
            let _e159 = y;
            let _e161 = l5_;
            let _e162 = l4_;
            l6_ = ((143f * _e159) * (_e161 - _e162));
            let _e167 = y;
            let _e169 = l6_;
            let _e170 = l5_;
            l7_ = ((195f * _e167) * (_e169 - _e170));
            let _e176 = y;
            let _e178 = l7_;
            let _e179 = l6_;
            d8_ = (1f - ((255f * _e176) * (_e178 - _e179)));
            let _e184 = l4_;
            let _e185 = l5_;
            let _e186 = l6_;
            let _e187 = l7_;
            d4567_ = (vec4(1f) - vec4<f32>(_e184, _e185, _e186, _e187));
        }
    }
    let _e192 = d4567_;
    let _e195 = d8_;
    return ((dot(energy.e4567_, _e192) + (energy.e8_ * _e195)) / energy.sum);
}

// A Gabor kernel ready to be summed: all that the noise needs to know of its frequency and orientation.
struct GaborKernel {
    wave: vec2<f32>,
    amplitude: f32,
    deficit: f32,
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise. Make it once where they do not vary.
//
// There are N R^2 impulses per unit area, so by Campbell's theorem, with a = 4 pi F omega,
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] (J(0)^2 - J(a.x) J(a.y)) / 2,
// where four or more phases average the sin^2 to 1/2 and leave J(0)^2 alone.
fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel {
    var magnitude: f32;
    var local_13: f32;
    var kernel: GaborKernel;
    var density: f32 = 1f;
    var power: f32 = 0.7278125f;
    var energy_2: GaborEnergy;
    var x: f32;
    var y_1: f32;

    magnitude = abs(frequency);
    let _e4 = magnitude;
    if (_e4 > 0.000001f) {
        let _e7 = magnitude;
        local_13 = min(_e7, 1000000f);
    } else {
        local_13 = 0.000001f;
    }
    let _e12 = local_13;
    magnitude = _e12;
    let _e15 = magnitude;
    let _e16 = gabor_direction(orientation);
    kernel.wave = (_e15 * _e16);
    let _e33 = gabor_energy();
    energy_2 = _e33;
    kernel.deficit = 1f;
    if false {
        {
            let _e40 = kernel;
            let _e43 = energy_2;
            let _e44 = gabor_deficit(_e40.wave.x, _e43);
            x = _e44;
            let _e46 = kernel;
            let _e49 = energy_2;
            let _e50 = gabor_deficit(_e46.wave.y, _e49);
            y_1 = _e50;
            let _e53 = x;
            let _e54 = y_1;
            let _e56 = x;
            let _e57 = y_1;
            kernel.deficit = ((_e53 + _e54) - (_e56 * _e57));
        }
    }
    let _e62 = density;
    let _e64 = power;
    let _e66 = energy_2;
    let _e69 = energy_2;
    let _e72 = kernel;
    kernel.amplitude = inverseSqrt((((((0.5f * _e62) * _e64) * _e66.sum) * _e69.sum) * _e72.deficit));
    let _e76 = kernel;
    return _e76;
}

// The window q along one axis, 0 from |x| = 1 on.
fn gabor_window(x: f32) -> f32 {
    var c_1: vec3<f32> = vec3<f32>(3f, -4.5f, 2.5f);
    var u: f32;

    u = max((1f - (x * x)), 0f);
    let _e13 = u;
    let _e14 = u;
    let _e16 = c_1;
    let _e18 = u;
    let _e19 = c_1;
    let _e21 = u;
    let _e22 = c_1;
    return ((_e13 * _e14) * (_e16.x + (_e18 * (_e19.y + (_e21 * _e22.z)))));
}

// Its derivative.
fn gabor_window_slope(x: f32) -> f32 {
    var c_2: vec3<f32> = vec3<f32>(3f, -4.5f, 2.5f);
    var u_1: f32;

    u_1 = max((1f - (x * x)), 0f);
    let _e16 = u_1;
    let _e19 = c_2;
    let _e22 = u_1;
    let _e24 = c_2;
    let _e27 = u_1;
    let _e29 = c_2;
    return (((-2f * x) * _e16) * ((2f * _e19.x) + (_e22 * ((3f * _e24.y) + (_e27 * (4f * _e29.z))))));
}

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace {
    cell: vec2<i32>,
    local: vec2<f32>,
    radius: vec2<f32>,
    period: vec2<i32>,
    time: f32,
}

// (cell + local) / GABOR_RADIUS kernel radii, without periods, at time 0: full precision everywhere in a world of 2^32
// cells each way, where it wraps around.
fn gabor_place(cell: vec2<i32>, local: vec2<f32>) -> GaborPlace {
    return GaborPlace(cell, local, vec2(1f), vec2(0i), 0f);
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part is the same with cosines
// for sines, and its gradient. Parts that are not used cost nothing: compilers leave them out.
struct GaborField {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
    four: vec4<f32>,
}

// A cell's coordinate within a period.
fn gabor_wrap(cell: i32, period: i32) -> i32 {
    var within: i32;
    var local_15: i32;

    if (period == 0i) {
        return cell;
    }
    within = (cell - ((cell / period) * period));
    let _e8 = within;
    if (_e8 < 0i) {
        let _e11 = within;
        local_15 = (_e11 + period);
    } else {
        let _e13 = within;
        local_15 = _e13;
    }
    let _e15 = local_15;
    return _e15;
}

// What a sine kernel's amplitude gains while time turns the phases: of J(0)^2 - J(a.x) J(a.y), gabor_kernel, the second
// term is taken times 1 - u, the mean of cos(4 pi k time) = 1 - 2 sin^2(2 pi k time) over the tempos k.
fn gabor_tempo_gain(kernel: GaborKernel, time: f32) -> f32 {
    var sines: vec4<f32>;
    var u_2: f32;

    if true {
        return 1f;
    }
    let _e6 = gabor_sin_turns(time);
    let _e9 = gabor_sin_turns((2f * time));
    let _e12 = gabor_sin_turns((3f * time));
    let _e15 = gabor_sin_turns((4f * time));
    sines = vec4<f32>(_e6, _e9, _e12, _e15);
    let _e19 = sines;
    let _e20 = sines;
    u_2 = (0.5f * dot(_e19, _e20));
    let _e25 = u_2;
    return inverseSqrt((1f + ((_e25 * (1f - kernel.deficit)) / kernel.deficit)));
}

// The noise at a place, by its cell: what all functions below call.
//   kernel  from gabor_kernel
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^2 N impulses, 9 for the default recipe.
fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    var visited: i32 = 3i;
    var whole: vec2<f32>;
    var local_16: vec2<f32>;
    var first: vec2<f32>;
    var cell_2: vec2<i32>;
    var cell_side: vec2<f32>;
    var time_1: f32;
    var seed_word_1: u32;
    var sum: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
    var j: i32 = 0i;
    var row_word_1: u32;
    var i_1: i32;
    var column_1: i32;
    var k_1: i32;
    var word_6: u32;
    var impulse: vec2<f32>;
    var d: vec2<f32>;
    var turns_1: f32;
    var magnitude_1: f32;
    var window: vec2<f32>;
    var wave_1: vec2<f32>;
    var scale: f32;
    var turned: vec2<f32>;

    whole = floor(place.local);
    let _e15 = whole;
    local_16 = (place.local - _e15);
    let _e18 = local_16;
    first = floor((_e18 - place.radius));
    let _e24 = whole;
    let _e25 = first;
    cell_2 = (place.cell + vec2<i32>((_e24 + _e25)));
    let _e30 = first;
    first = (_e30 - vec2(1f));
    cell_side = (vec2(1f) / place.radius);
    time_1 = fract(place.time);
    let _e42 = gabor_seed_word(seed);
    seed_word_1 = _e42;
    loop {
        let _e56 = j;
        let _e57 = visited;
        if !((_e56 < _e57)) {
            break;
        }
        {
            let _e63 = cell_2;
            let _e65 = j;
            let _e69 = gabor_wrap((_e63.y + _e65), place.period.y);
            let _e70 = seed_word_1;
            let _e71 = gabor_row_word(_e69, _e70);
            row_word_1 = _e71;
            i_1 = 0i;
            loop {
                let _e75 = i_1;
                let _e76 = visited;
                if !((_e75 < _e76)) {
                    break;
                }
                {
                    let _e82 = cell_2;
                    let _e84 = i_1;
                    let _e88 = gabor_wrap((_e82.x + _e84), place.period.x);
                    column_1 = _e88;
                    k_1 = 0i;
                    loop {
                        let _e92 = k_1;
                        if !((_e92 < 1i)) {
                            break;
                        }
                        {
                            let _e99 = column_1;
                            let _e100 = row_word_1;
                            let _e101 = k_1;
                            let _e102 = gabor_impulse_word(_e99, _e100, _e101);
                            word_6 = _e102;
                            let _e104 = word_6;
                            let _e105 = gabor_place_plus_one(_e104);
                            impulse = _e105;
                            let _e107 = local_16;
                            let _e108 = impulse;
                            let _e109 = first;
                            let _e110 = i_1;
                            let _e112 = j;
                            let _e118 = cell_side;
                            d = ((_e107 - (_e108 + (_e109 + vec2<f32>(f32(_e110), f32(_e112))))) * _e118);
                            let _e121 = d;
                            let _e124 = d;
                            if (max(abs(_e121.x), abs(_e124.y)) < 1f) {
                                {
                                    let _e131 = d;
                                    let _e133 = impulse;
                                    let _e134 = gabor_phase(_e133);
                                    let _e136 = word_6;
                                    let _e137 = gabor_tempo(_e136);
                                    let _e138 = time_1;
                                    turns_1 = ((dot(kernel.wave, _e131) + _e134) + (_e137 * _e138));
                                    let _e142 = word_6;
                                    let _e143 = gabor_magnitude(_e142);
                                    magnitude_1 = _e143;
                                    let _e145 = d;
                                    let _e147 = gabor_window(_e145.x);
                                    let _e148 = d;
                                    let _e150 = gabor_window(_e148.y);
                                    window = vec2<f32>(_e147, _e150);
                                    let _e153 = magnitude_1;
                                    let _e154 = turns_1;
                                    let _e157 = gabor_sin_turns((_e154 + 0.25f));
                                    let _e158 = turns_1;
                                    let _e159 = gabor_sin_turns(_e158);
                                    wave_1 = (_e153 * vec2<f32>(_e157, _e159));
                                    let _e164 = sum;
                                    let _e166 = window;
                                    let _e168 = window;
                                    let _e171 = wave_1;
                                    sum.value = (_e164.value + ((_e166.x * _e168.y) * _e171));
                                    let _e175 = sum;
                                    let _e177 = d;
                                    let _e179 = gabor_window_slope(_e177.x);
                                    let _e180 = window;
                                    let _e183 = wave_1;
                                    sum.slope_x = (_e175.slope_x + ((_e179 * _e180.y) * _e183));
                                    let _e187 = sum;
                                    let _e189 = d;
                                    let _e191 = gabor_window_slope(_e189.y);
                                    let _e192 = window;
                                    let _e195 = wave_1;
                                    sum.slope_y = (_e187.slope_y + ((_e191 * _e192.x) * _e195));
                                    let _e199 = sum;
                                    let _e201 = window;
                                    let _e203 = window;
                                    let _e206 = wave_1;
                                    let _e207 = word_6;
                                    let _e208 = gabor_four(_e206, _e207);
                                    sum.four = (_e199.four + ((_e201.x * _e203.y) * _e208));
                                }
                            }
                        }
                        continuing {
                            let _e96 = k_1;
                            k_1 = (_e96 + 1i);
                        }
                    }
                }
                continuing {
                    let _e79 = i_1;
                    i_1 = (_e79 + 1i);
                }
            }
        }
        continuing {
            let _e60 = j;
            j = (_e60 + 1i);
        }
    }
    scale = ((kernel.amplitude * 1f) * inverseSqrt((place.radius.x * place.radius.y)));
    let _e222 = time_1;
    if (_e222 != 0f) {
        let _e225 = scale;
        let _e226 = time_1;
        let _e227 = gabor_tempo_gain(kernel, _e226);
        scale = (_e225 * _e227);
    }
    let _e230 = sum;
    let _e234 = sum;
    turned = (6.2831855f * vec2<f32>(-(_e230.value.y), _e234.value.x));
    let _e240 = scale;
    let _e241 = sum;
    let _e244 = scale;
    let _e245 = sum;
    let _e249 = turned;
    let _e253 = scale;
    let _e254 = sum;
    let _e258 = turned;
    let _e262 = scale;
    let _e263 = sum;
    return GaborField((_e240 * _e241.value), (_e244 * (_e245.slope_x + (kernel.wave.x * _e249))), (_e253 * (_e254.slope_y + (kernel.wave.y * _e258))), (_e262 * _e263.four));
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere: mean 0, variance 1 at every
// place, nearly Gaussian, continuous with its first derivatives. See gabor_place, gabor_kernel and gabor_field.
fn gabor_noise_at(cell: vec2<i32>, local: vec2<f32>, kernel: GaborKernel, seed: u32) -> f32 {
    let _e4 = gabor_place(cell, local);
    let _e5 = gabor_field(_e4, kernel, seed);
    return _e5.value.y;
}

// Gabor noise at p: as gabor_noise_at, in one call.
//   p            position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float
//                steps by 0.008.
//   frequency    cycles per kernel radius; its magnitude is used, within [10^-6, 10^6]. From about 1 up the noise is a
//                distinct lobe; above 64 the places of impulses are too coarse for the exact variance.
//   orientation  direction of the wave vector in radians from +x towards +y, precise within +-400.
//   seed         any; each seed is another instance, independent of the others
// Frequency and orientation may vary from place to place: where they are continuous so is the noise, for each wave
// turns about its own impulse. A slope of theirs adds to that of the noise.
fn gabor_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    let _e8 = gabor_kernel(frequency, orientation);
    let _e9 = gabor_noise_at(vec2(0i), (p * 1f), _e8, seed);
    return _e9;
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
fn gabor_noise_gradient(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    var field: GaborField;

    let _e8 = gabor_place(vec2(0i), (p * 1f));
    let _e9 = gabor_kernel(frequency, orientation);
    let _e10 = gabor_field(_e8, _e9, seed);
    field = _e10;
    let _e12 = field;
    let _e15 = field;
    let _e18 = field;
    return vec3<f32>(_e12.value.y, _e15.slope_x.y, _e18.slope_y.y);
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent; with GABOR_PHASES 2 the real part's variance is 1 only
// from frequency 1.5 up.
fn gabor_noise_complex(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    let _e8 = gabor_place(vec2(0i), (p * 1f));
    let _e9 = gabor_kernel(frequency, orientation);
    let _e10 = gabor_field(_e8, _e9, seed);
    return _e10.value;
}

// Four noises at p from one traversal, for colours and for displacement along vectors: each as gabor_noise,
// uncorrelated with each other. With GABOR_PHASES 2 their variance is 1 only from frequency 1.5 up.
fn gabor_noise_four(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec4<f32> {
    let _e8 = gabor_place(vec2(0i), (p * 1f));
    let _e9 = gabor_kernel(frequency, orientation);
    let _e10 = gabor_field(_e8, _e9, seed);
    return _e10.four;
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
fn gabor_phasor(value: vec2<f32>) -> vec2<f32> {
    var intensity: f32;
    var local_18: f32;
    var phase: f32;
    var local_19: f32;

    intensity = length(value);
    let _e3 = intensity;
    if (_e3 > 0f) {
        local_18 = (atan2(value.y, value.x) * 0.15915494f);
    } else {
        local_18 = 0f;
    }
    let _e13 = local_18;
    phase = _e13;
    let _e15 = phase;
    if (_e15 < 0f) {
        let _e18 = phase;
        local_19 = min((_e18 + 1f), 0.99999994f);
    } else {
        let _e23 = phase;
        local_19 = _e23;
    }
    let _e25 = local_19;
    let _e26 = intensity;
    return vec2<f32>(_e25, _e26);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation.
// Mean and variance are those of gabor_noise. So is the rest of the law where period * R is whole; where it is not,
// cells grow until a whole number fits, and the fewer they become the less normal the values are: cvm 0.6 with 5 %
// fewer cells per radius, 2.2 with 10 %. Each period is at least 2, a kernel's diameter; a shorter one is taken as 2.
fn gabor_noise_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var period_2: vec2<f32>;
    var cells: vec2<f32>;
    var radius: vec2<f32>;
    var within_1: vec2<f32>;
    var place_1: GaborPlace;

    period_2 = period;
    let _e6 = period_2;
    period_2 = max(_e6, vec2(2f));
    let _e10 = period_2;
    cells = floor((_e10 * 1f));
    let _e15 = cells;
    let _e16 = period_2;
    radius = (_e15 / _e16);
    let _e19 = period_2;
    let _e22 = period_2;
    within_1 = (p - (floor((p / _e19)) * _e22));
    let _e28 = within_1;
    let _e29 = radius;
    let _e31 = radius;
    let _e32 = cells;
    place_1 = GaborPlace(vec2(0i), (_e28 * _e29), _e31, vec2<i32>(_e32), 0f);
    let _e37 = place_1;
    let _e38 = gabor_kernel(frequency, orientation);
    let _e39 = gabor_field(_e37, _e38, seed);
    return _e39.value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// is gabor_noise of some instance; after a tenth of the period it has little in common with what it was.
fn gabor_noise_animated(p: vec2<f32>, time: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place_2: GaborPlace;

    let _e9 = gabor_place(vec2(0i), (p * 1f));
    place_2 = _e9;
    place_2.time = time;
    let _e12 = place_2;
    let _e13 = gabor_kernel(frequency, orientation);
    let _e14 = gabor_field(_e12, _e13, seed);
    return _e14.value.y;
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
fn gabor_unorm(noise: f32) -> f32 {
    return clamp((0.5f + (0.25f * noise)), 0f, 1f);
}
