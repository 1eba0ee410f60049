// gabor_noise.wgsl: the sparse Gabor noise of [TNVT19] in two dimensions, with unit variance. For new work take
// gabor_lattice.wgsl, which has the same calls, is faster, and is normal at every place: for WGSL.
//
// Made from shaders/gabor_noise.glsl by tools/translate and naga 30.0.1: change that file, not this one.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // mean 0, variance 1
//     float v = gabor_unorm(n);                    // in [0, 1], to show
//
// Functions to call, at the end of the file:
//     gabor_noise, gabor_unorm                the noise, and to show it
//     gabor_noise_gradient                    with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor       with its quadrature: phase and intensity
//     gabor_noise_four                        four uncorrelated ones at once
//     gabor_noise_tiled, gabor_noise_animated with exact periods in space, and in time
//     gabor_noise_spread                      waves of many orientations and frequencies, up to isotropic
//     gabor_noise_lobes, gabor_noise_sum      any spectrum, as a list of lobes
//     gabor_noise_filtered                    without aliasing, whatever a pixel covers
//     gabor_noise_at, gabor_kernel            by integer cell and local offset, for large worlds
//     gabor_field                             all of it at once
// Names with gabor_impl_ are private.
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

const GABOR_NOISE_VERSION: u32 = 10100u;

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project), the salt entering between them too, so that no two sequences share a run.
fn gabor_impl_mix(word: u32, salt: u32) -> u32 {
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

// The seed of noise `index` of several that are independent of each other, as the lobes of a sum are.
fn gabor_lobe_seed(seed: u32, index: i32) -> u32 {
    let _e7 = gabor_impl_mix((seed + (u32(index) * 2246822507u)), 2654435761u);
    return _e7;
}

// The word of `seed`, from which those of the rows follow.
fn gabor_impl_seed_word(seed: u32) -> u32 {
    let _e4 = gabor_impl_mix((seed * 2654435761u), 625341585u);
    return _e4;
}

// The word of a row of cells, from which those of its impulses follow.
fn gabor_impl_row_word(row: i32, seed_word: u32) -> u32 {
    let _e6 = gabor_impl_mix(((u32(row) * 2654435761u) + seed_word), seed_word);
    return _e6;
}

// The word of impulse `index` in a cell. In its bits are y in the cell (0 to 22), x (8 to 30), the phase (0 to 7), the
// phase rate (8 to 10) and the magnitude (31). x and y share bits 8 to 22, the leading ones of y and the trailing ones
// of x: only offsets in x below 1/256 of a cell depend on y.
fn gabor_impl_impulse_word(column: i32, row_word: u32, index: i32) -> u32 {
    var salt_1: u32;

    salt_1 = (row_word + (u32(index) * 2246822507u));
    let _e11 = salt_1;
    let _e13 = salt_1;
    let _e14 = gabor_impl_mix(((u32(column) * 2654435761u) + _e11), _e13);
    return _e14;
}

// Position of an impulse in its cell, plus 1: in [1, 2)^2, which takes no conversion from integers.
fn gabor_impl_position_plus_one(word: u32) -> vec2<f32> {
    return vec2<f32>(bitcast<f32>((1065353216u | ((word >> 8u) & 8388607u))), bitcast<f32>((1065353216u | (word & 8388607u))));
}

// Phase of the impulse at that position, in turns.
fn gabor_impl_phase(position_plus_one: vec2<f32>, phases: f32) -> f32 {
    return fract((position_plus_one.y * (8388608f / phases)));
}

// Turns of an impulse's phase while time goes by 1: -4 to -1 or 1 to 4.
fn gabor_impl_phase_rate(word: u32) -> f32 {
    var rate: f32;
    var local: f32;

    rate = (f32(((word >> 8u) & 7u)) - 4f);
    let _e9 = rate;
    if (_e9 < 0f) {
        let _e12 = rate;
        local = _e12;
    } else {
        let _e13 = rate;
        local = (_e13 + 1f);
    }
    let _e17 = local;
    return _e17;
}

// The wave, as (cos, sin), in four channels, each shifted by its own number of quarter turns.
fn gabor_impl_four(wave: vec2<f32>, word: u32) -> vec4<f32> {
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

    let _e3 = gabor_impl_mix(word, 2246822507u);
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
fn gabor_impl_magnitude(word: u32) -> f32 {
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
fn gabor_impl_sine(t: f32) -> f32 {
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
fn gabor_impl_direction(angle: f32) -> vec2<f32> {
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

// Product of complex numbers.
fn gabor_impl_product(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(((a.x * b.x) - (a.y * b.y)), ((a.x * b.y) + (a.y * b.x)));
}

// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). The five c_n I_n, whose sum is the energy of one axis:
struct GaborEnergy {
    e4567_: vec4<f32>,
    e8_: f32,
    sum: f32,
}

fn gabor_impl_energy() -> GaborEnergy {
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

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the energy along one axis of
// a sine kernel of k cycles per radius, relative to that at high frequency. For small a from 1 - L_n by the power
// series of L_7 and L_8 and downward recurrence; for large a by upward recurrence from L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
fn gabor_impl_relative_energy(k: f32, energy: GaborEnergy) -> f32 {
    var a_1: f32;
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

    a_1 = (12.566371f * k);
    let _e5 = a_1;
    let _e6 = a_1;
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
            let _e110 = gabor_impl_sine((2f * k));
            let _e111 = a_1;
            l0_ = (_e110 / _e111);
            let _e115 = y;
            let _e117 = l0_;
            let _e122 = gabor_impl_sine(((2f * k) + 0.25f));
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

// Waves around one frequency and orientation.
struct GaborLobe {
    wave: vec2<f32>,
    spread: vec2<f32>,
    power: f32,
}

// The lobe of a frequency and an orientation, with the ranges of gabor_noise, and
//   frequency_spread    a share of the frequency, within [0, 1]
//   orientation_spread  radians: pi/2 and more is every direction, isotropic
//   power               in any unit, up to 10^9
// What is less than 0 or NaN counts as 0.
fn gabor_lobe(frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, power: f32) -> GaborLobe {
    var magnitude: f32;
    var local_13: f32;
    var lobe: GaborLobe;
    var local_14: f32;
    var local_15: f32;
    var local_16: f32;

    magnitude = abs(frequency);
    let _e7 = magnitude;
    if (_e7 > 0.000001f) {
        let _e10 = magnitude;
        local_13 = min(_e10, 1000000f);
    } else {
        local_13 = 0.000001f;
    }
    let _e15 = local_13;
    magnitude = _e15;
    let _e18 = magnitude;
    let _e19 = gabor_impl_direction(orientation);
    lobe.wave = (_e18 * _e19);
    if (frequency_spread > 0f) {
        local_14 = min(frequency_spread, 1f);
    } else {
        local_14 = 0f;
    }
    let _e29 = local_14;
    lobe.spread.x = _e29;
    if (orientation_spread > 0f) {
        local_15 = (0.15915494f * min(orientation_spread, 1.5707963f));
    } else {
        local_15 = 0f;
    }
    let _e40 = local_15;
    lobe.spread.y = _e40;
    if (power > 0f) {
        local_16 = min(power, 1000000000f);
    } else {
        local_16 = 0f;
    }
    let _e48 = local_16;
    lobe.power = _e48;
    let _e49 = lobe;
    return _e49;
}

// A spectrum: what gabor_noise_lobes and gabor_noise_sum take.
struct GaborLobes {
    lobe: array<GaborLobe, 1>,
    count: i32,
}

// Gabor kernels ready to be summed: all that the noise needs to know of its spectrum.
struct GaborKernel {
    lobes: GaborLobes,
    phases: f32,
    amplitude: f32,
    variance_factor: f32,
}

// The kernels of some lobes' spectrum: each impulse has a wave of one lobe, chosen with a probability in proportion to
// its power, so that many lobes have the impulses of one. The variance is 1 whatever the powers. Impulses have 256
// phases, even where GABOR_PHASES is 2: then the variance depends on no frequency.
//
// There are N R^2 impulses per unit area, so by Campbell's theorem
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] J(0)^2 / 2.
fn gabor_kernel_lobes(lobes: GaborLobes) -> GaborKernel {
    var lobes_1: GaborLobes;
    var kernel: GaborKernel;
    var total_power: f32 = 0f;
    var i_1: i32 = 0i;
    var local_17: f32;
    var density: f32 = 1f;
    var power_1: f32 = 0.7278125f;
    var energy_2: f32;

    lobes_1 = lobes;
    let _e4 = lobes_1;
    kernel.lobes = _e4;
    let _e7 = lobes_1;
    kernel.lobes.count = clamp(_e7.count, 1i, 1i);
    loop {
        let _e16 = i_1;
        if !((_e16 < 1i)) {
            break;
        }
        {
            let _e23 = total_power;
            let _e24 = i_1;
            let _e25 = kernel;
            if (_e24 < _e25.lobes.count) {
                let _e29 = i_1;
                let _e32 = lobes_1.lobe[_e29];
                local_17 = _e32.power;
            } else {
                local_17 = 0f;
            }
            let _e36 = local_17;
            total_power = (_e23 + _e36);
            let _e38 = i_1;
            let _e43 = total_power;
            kernel.lobes.lobe[_e38].power = _e43;
        }
        continuing {
            let _e20 = i_1;
            i_1 = (_e20 + 1i);
        }
    }
    kernel.phases = 256f;
    kernel.variance_factor = 1f;
    let _e63 = gabor_impl_energy();
    energy_2 = _e63.sum;
    let _e68 = density;
    let _e70 = power_1;
    let _e72 = energy_2;
    let _e74 = energy_2;
    kernel.amplitude = inverseSqrt(((((0.5f * _e68) * _e70) * _e72) * _e74));
    let _e77 = kernel;
    return _e77;
}

// The kernel of one lobe.
fn gabor_kernel_lobe(lobe: GaborLobe) -> GaborKernel {
    var lobes_2: GaborLobes;
    var i_2: i32 = 0i;

    loop {
        let _e4 = i_2;
        if !((_e4 < 1i)) {
            break;
        }
        let _e11 = i_2;
        lobes_2.lobe[_e11] = lobe;
        continuing {
            let _e8 = i_2;
            i_2 = (_e8 + 1i);
        }
    }
    lobes_2.count = 1i;
    let _e16 = lobes_2;
    let _e17 = gabor_kernel_lobes(_e16);
    return _e17;
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise. Make it once where they do not vary.
//
// With two phases the sin^2 of gabor_kernel_lobes does not average to 1/2: with a = 4 pi F omega,
//     J(0)^2 - J(a.x) J(a.y)   takes the place of   J(0)^2.
fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel {
    var lobe_2: GaborLobe;
    var kernel_1: GaborKernel;
    var energy_3: GaborEnergy;
    var x: f32;
    var y_1: f32;

    let _e5 = gabor_lobe(frequency, orientation, 0f, 0f, 1f);
    lobe_2 = _e5;
    let _e7 = lobe_2;
    let _e8 = gabor_kernel_lobe(_e7);
    kernel_1 = _e8;
    kernel_1.phases = 256f;
    if false {
        {
            let _e16 = gabor_impl_energy();
            energy_3 = _e16;
            let _e18 = lobe_2;
            let _e21 = energy_3;
            let _e22 = gabor_impl_relative_energy(_e18.wave.x, _e21);
            x = _e22;
            let _e24 = lobe_2;
            let _e27 = energy_3;
            let _e28 = gabor_impl_relative_energy(_e24.wave.y, _e27);
            y_1 = _e28;
            let _e31 = x;
            let _e32 = y_1;
            let _e34 = x;
            let _e35 = y_1;
            kernel_1.variance_factor = ((_e31 + _e32) - (_e34 * _e35));
            let _e39 = kernel_1;
            let _e41 = kernel_1;
            kernel_1.amplitude = (_e39.amplitude * inverseSqrt(_e41.variance_factor));
        }
    }
    let _e45 = kernel_1;
    return _e45;
}

// A wave vector within a lobe's spread, as that is written.
fn gabor_impl_wave_within(lobe: GaborLobe, spread: vec2<f32>) -> vec2<f32> {
    var turn: vec2<f32>;

    let _e5 = gabor_impl_sine((spread.y + 0.25f));
    let _e7 = gabor_impl_sine(spread.y);
    turn = vec2<f32>(_e5, _e7);
    let _e14 = turn;
    let _e15 = gabor_impl_product(lobe.wave, _e14);
    return ((1f + spread.x) * _e15);
}

// The wave vector of the impulse that has this word.
fn gabor_impl_wave(kernel: GaborKernel, word: u32) -> vec2<f32> {
    var kernel_3: GaborKernel;
    var lobe_4: GaborLobe;
    var choice: u32;
    var chosen: f32;
    var i_3: i32 = 1i;
    var drawn: vec2<f32>;

    kernel_3 = kernel;
    let _e7 = kernel_3.lobes.lobe[0];
    lobe_4 = _e7;
    let _e10 = gabor_impl_mix(word, 2654435761u);
    choice = _e10;
    let _e12 = kernel_3;
    if (_e12.lobes.count > 1i) {
        {
            let _e23 = kernel_3.lobes.lobe[0];
            let _e25 = choice;
            chosen = (_e23.power * ((f32((_e25 >> 16u)) + 0.5f) / 65536f));
            loop {
                let _e37 = i_3;
                if !((_e37 < 1i)) {
                    break;
                }
                {
                    let _e44 = i_3;
                    let _e45 = kernel_3;
                    let _e49 = chosen;
                    let _e50 = i_3;
                    let _e56 = kernel_3.lobes.lobe[(_e50 - 1i)];
                    if ((_e44 < _e45.lobes.count) && (_e49 >= _e56.power)) {
                        let _e60 = i_3;
                        let _e64 = kernel_3.lobes.lobe[_e60];
                        lobe_4 = _e64;
                    }
                }
                continuing {
                    let _e41 = i_3;
                    i_3 = (_e41 + 1i);
                }
            }
        }
    }
    let _e65 = lobe_4;
    let _e70 = lobe_4;
    if ((_e65.spread.x == 0f) && (_e70.spread.y == 0f)) {
        let _e76 = lobe_4;
        return _e76.wave;
    }
    let _e78 = choice;
    let _e84 = choice;
    drawn = vec2<f32>(f32(((_e78 * 2654435761u) >> 16u)), f32((_e84 & 65535u)));
    let _e90 = lobe_4;
    let _e91 = lobe_4;
    let _e93 = drawn;
    let _e104 = gabor_impl_wave_within(_e90, (_e91.spread * (((_e93 + vec2(0.5f)) / vec2(32768f)) - vec2(1f))));
    return _e104;
}

// The window q along one axis, 0 from |x| = 1 on.
fn gabor_impl_window(x: f32) -> f32 {
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
fn gabor_impl_window_slope(x: f32) -> f32 {
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
fn gabor_impl_wrap(cell: i32, period: i32) -> i32 {
    var within: i32;
    var local_19: i32;

    if (period == 0i) {
        return cell;
    }
    within = (cell - ((cell / period) * period));
    let _e8 = within;
    if (_e8 < 0i) {
        let _e11 = within;
        local_19 = (_e11 + period);
    } else {
        let _e13 = within;
        local_19 = _e13;
    }
    let _e15 = local_19;
    return _e15;
}

// The gain that keeps the variance of sine kernels at 1 while time turns their phases: J(a.x) J(a.y) in gabor_kernel is
// multiplied by 1 - u, the mean of cos(4 pi k time) = 1 - 2 sin^2(2 pi k time) over the phase rates k.
fn gabor_impl_phase_gain(kernel: GaborKernel, time: f32) -> f32 {
    var kernel_5: GaborKernel;
    var sines: vec4<f32>;
    var u_2: f32;

    kernel_5 = kernel;
    let _e3 = kernel_5;
    if ((_e3.phases != 2f) || (time == 0f)) {
        return 1f;
    }
    let _e11 = gabor_impl_sine(time);
    let _e14 = gabor_impl_sine((2f * time));
    let _e17 = gabor_impl_sine((3f * time));
    let _e20 = gabor_impl_sine((4f * time));
    sines = vec4<f32>(_e11, _e14, _e17, _e20);
    let _e24 = sines;
    let _e25 = sines;
    u_2 = (0.5f * dot(_e24, _e25));
    let _e30 = u_2;
    let _e32 = kernel_5;
    let _e36 = kernel_5;
    return inverseSqrt((1f + ((_e30 * (1f - _e32.variance_factor)) / _e36.variance_factor)));
}

// The factor of the sum of kernels: with fewer cells per radius there are fewer impulses.
fn gabor_impl_scale(kernel: GaborKernel, place: GaborPlace) -> f32 {
    var kernel_7: GaborKernel;

    kernel_7 = kernel;
    let _e3 = kernel_7;
    let _e14 = kernel_7;
    let _e17 = gabor_impl_phase_gain(_e14, fract(place.time));
    return (((_e3.amplitude * 1f) * inverseSqrt((place.radius.x * place.radius.y))) * _e17);
}

// The noise at a place, by its cell: what most functions below call.
//   kernel  from gabor_kernel
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^2 N impulses, 9 for the default recipe.
fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    var kernel_9: GaborKernel;
    var visited: i32 = 3i;
    var cell_base: vec2<f32>;
    var local_20: vec2<f32>;
    var first: vec2<f32>;
    var cell_2: vec2<i32>;
    var cell_side: vec2<f32>;
    var time_1: f32;
    var seed_word_1: u32;
    var sum: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
    var j: i32 = 0i;
    var row_word_1: u32;
    var i_4: i32;
    var column_1: i32;
    var k_1: i32;
    var word_7: u32;
    var impulse: vec2<f32>;
    var d: vec2<f32>;
    var cycles: vec2<f32>;
    var turns: f32;
    var magnitude_1: f32;
    var window: vec2<f32>;
    var wave_1: vec2<f32>;
    var turned: vec2<f32>;
    var scale: f32;

    kernel_9 = kernel;
    cell_base = floor(place.local);
    let _e16 = cell_base;
    local_20 = (place.local - _e16);
    let _e19 = local_20;
    first = floor((_e19 - place.radius));
    let _e25 = cell_base;
    let _e26 = first;
    cell_2 = (place.cell + vec2<i32>((_e25 + _e26)));
    let _e31 = first;
    first = (_e31 - vec2(1f));
    cell_side = (vec2(1f) / place.radius);
    time_1 = fract(place.time);
    let _e43 = gabor_impl_seed_word(seed);
    seed_word_1 = _e43;
    loop {
        let _e57 = j;
        let _e58 = visited;
        if !((_e57 < _e58)) {
            break;
        }
        {
            let _e64 = cell_2;
            let _e66 = j;
            let _e70 = gabor_impl_wrap((_e64.y + _e66), place.period.y);
            let _e71 = seed_word_1;
            let _e72 = gabor_impl_row_word(_e70, _e71);
            row_word_1 = _e72;
            i_4 = 0i;
            loop {
                let _e76 = i_4;
                let _e77 = visited;
                if !((_e76 < _e77)) {
                    break;
                }
                {
                    let _e83 = cell_2;
                    let _e85 = i_4;
                    let _e89 = gabor_impl_wrap((_e83.x + _e85), place.period.x);
                    column_1 = _e89;
                    k_1 = 0i;
                    loop {
                        let _e93 = k_1;
                        if !((_e93 < 1i)) {
                            break;
                        }
                        {
                            let _e100 = column_1;
                            let _e101 = row_word_1;
                            let _e102 = k_1;
                            let _e103 = gabor_impl_impulse_word(_e100, _e101, _e102);
                            word_7 = _e103;
                            let _e105 = word_7;
                            let _e106 = gabor_impl_position_plus_one(_e105);
                            impulse = _e106;
                            let _e108 = local_20;
                            let _e109 = impulse;
                            let _e110 = first;
                            let _e111 = i_4;
                            let _e113 = j;
                            let _e119 = cell_side;
                            d = ((_e108 - (_e109 + (_e110 + vec2<f32>(f32(_e111), f32(_e113))))) * _e119);
                            let _e122 = d;
                            let _e125 = d;
                            if (max(abs(_e122.x), abs(_e125.y)) < 1f) {
                                {
                                    let _e131 = kernel_9;
                                    let _e132 = word_7;
                                    let _e133 = gabor_impl_wave(_e131, _e132);
                                    cycles = _e133;
                                    let _e135 = cycles;
                                    let _e136 = d;
                                    let _e138 = impulse;
                                    let _e139 = kernel_9;
                                    let _e141 = gabor_impl_phase(_e138, _e139.phases);
                                    let _e143 = word_7;
                                    let _e144 = gabor_impl_phase_rate(_e143);
                                    let _e145 = time_1;
                                    turns = ((dot(_e135, _e136) + _e141) + (_e144 * _e145));
                                    let _e149 = word_7;
                                    let _e150 = gabor_impl_magnitude(_e149);
                                    magnitude_1 = _e150;
                                    let _e152 = d;
                                    let _e154 = gabor_impl_window(_e152.x);
                                    let _e155 = d;
                                    let _e157 = gabor_impl_window(_e155.y);
                                    window = vec2<f32>(_e154, _e157);
                                    let _e160 = magnitude_1;
                                    let _e161 = turns;
                                    let _e164 = gabor_impl_sine((_e161 + 0.25f));
                                    let _e165 = turns;
                                    let _e166 = gabor_impl_sine(_e165);
                                    wave_1 = (_e160 * vec2<f32>(_e164, _e166));
                                    let _e171 = window;
                                    let _e174 = window;
                                    let _e177 = wave_1;
                                    let _e180 = wave_1;
                                    turned = (((6.2831855f * _e171.x) * _e174.y) * vec2<f32>(-(_e177.y), _e180.x));
                                    let _e186 = sum;
                                    let _e188 = window;
                                    let _e190 = window;
                                    let _e193 = wave_1;
                                    sum.value = (_e186.value + ((_e188.x * _e190.y) * _e193));
                                    let _e197 = sum;
                                    let _e199 = d;
                                    let _e201 = gabor_impl_window_slope(_e199.x);
                                    let _e202 = window;
                                    let _e205 = wave_1;
                                    let _e207 = cycles;
                                    let _e209 = turned;
                                    sum.slope_x = (_e197.slope_x + (((_e201 * _e202.y) * _e205) + (_e207.x * _e209)));
                                    let _e214 = sum;
                                    let _e216 = d;
                                    let _e218 = gabor_impl_window_slope(_e216.y);
                                    let _e219 = window;
                                    let _e222 = wave_1;
                                    let _e224 = cycles;
                                    let _e226 = turned;
                                    sum.slope_y = (_e214.slope_y + (((_e218 * _e219.x) * _e222) + (_e224.y * _e226)));
                                    let _e231 = sum;
                                    let _e233 = window;
                                    let _e235 = window;
                                    let _e238 = wave_1;
                                    let _e239 = word_7;
                                    let _e240 = gabor_impl_four(_e238, _e239);
                                    sum.four = (_e231.four + ((_e233.x * _e235.y) * _e240));
                                }
                            }
                        }
                        continuing {
                            let _e97 = k_1;
                            k_1 = (_e97 + 1i);
                        }
                    }
                }
                continuing {
                    let _e80 = i_4;
                    i_4 = (_e80 + 1i);
                }
            }
        }
        continuing {
            let _e61 = j;
            j = (_e61 + 1i);
        }
    }
    let _e243 = kernel_9;
    let _e244 = gabor_impl_scale(_e243, place);
    scale = _e244;
    let _e246 = scale;
    let _e247 = sum;
    let _e250 = scale;
    let _e251 = sum;
    let _e254 = scale;
    let _e255 = sum;
    let _e258 = scale;
    let _e259 = sum;
    return GaborField((_e246 * _e247.value), (_e250 * _e251.slope_x), (_e254 * _e255.slope_y), (_e258 * _e259.four));
}

// Even polynomial p0 + p1 x^2 + ... + p5 x^10.
struct GaborPolynomial {
    low: vec3<f32>,
    high: vec3<f32>,
}

// P, by least squares: within 1.8 % of the default window in the root mean square, and closer to smoother ones.
fn gabor_impl_normal_window() -> GaborPolynomial {
    var c_3: vec3<f32> = vec3<f32>(3f, -4.5f, 2.5f);
    var p_1: GaborPolynomial;

    let _e8 = c_3;
    let _e15 = c_3;
    let _e23 = c_3;
    p_1.low = (((_e8.x * vec3<f32>(1.0028954f, 0.22776577f, 0.05744543f)) + (_e15.y * vec3<f32>(1.0014522f, 0.11853905f, 0.017965f))) + (_e23.z * vec3<f32>(0.999785f, 0.01664752f, -0.02767342f)));
    let _e33 = c_3;
    let _e42 = c_3;
    let _e52 = c_3;
    p_1.high = (((_e33.x * vec3<f32>(-0.0146696f, -0.00010419f, 0.00005601f)) + (_e42.y * vec3<f32>(-0.01980551f, 0.00225161f, -0.00006904f))) + (_e52.z * vec3<f32>(-0.00584684f, 0.00131062f, -0.00005534f)));
    let _e62 = p_1;
    return _e62;
}

// E[P(x + v)] as a polynomial of x, for v normal of this variance.
fn gabor_impl_averaged(p: GaborPolynomial, variance: f32) -> GaborPolynomial {
    var v: vec3<f32>;
    var w: vec2<f32>;
    var mean: GaborPolynomial;

    v = (variance * vec3<f32>(1f, variance, (variance * variance)));
    let _e7 = v;
    let _e9 = v;
    w = (_e7.y * _e9.yz);
    let _e18 = v;
    let _e32 = w;
    mean.low.x = ((p.low.x + dot(_e18, vec3<f32>(p.low.y, (3f * p.low.z), (15f * p.high.x)))) + dot(_e32, vec2<f32>((105f * p.high.y), (945f * p.high.z))));
    let _e48 = v;
    let _e64 = w;
    mean.low.y = ((p.low.y + dot(_e48, vec3<f32>((6f * p.low.z), (45f * p.high.x), (420f * p.high.y)))) + ((_e64.x * 4725f) * p.high.z));
    let _e76 = v;
    mean.low.z = (p.low.z + dot(_e76, vec3<f32>((15f * p.high.x), (210f * p.high.y), (3150f * p.high.z))));
    let _e96 = v;
    mean.high.x = (p.high.x + dot(_e96.xy, vec2<f32>((28f * p.high.y), (630f * p.high.z))));
    mean.high.y = (p.high.y + ((45f * variance) * p.high.z));
    mean.high.z = p.high.z;
    let _e123 = mean;
    return _e123;
}

// A polynomial of a complex number.
fn gabor_impl_polynomial(p: GaborPolynomial, z: vec2<f32>) -> vec2<f32> {
    var square: vec2<f32>;
    var sum_1: vec2<f32>;

    let _e2 = gabor_impl_product(z, z);
    square = _e2;
    let _e6 = square;
    sum_1 = ((p.high.z * _e6) + vec2<f32>(p.high.y, 0f));
    let _e14 = sum_1;
    let _e15 = square;
    let _e16 = gabor_impl_product(_e14, _e15);
    sum_1 = (_e16 + vec2<f32>(p.high.x, 0f));
    let _e22 = sum_1;
    let _e23 = square;
    let _e24 = gabor_impl_product(_e22, _e23);
    sum_1 = (_e24 + vec2<f32>(p.low.z, 0f));
    let _e30 = sum_1;
    let _e31 = square;
    let _e32 = gabor_impl_product(_e30, _e31);
    sum_1 = (_e32 + vec2<f32>(p.low.y, 0f));
    let _e38 = sum_1;
    let _e39 = square;
    let _e40 = gabor_impl_product(_e38, _e39);
    return (_e40 + vec2<f32>(p.low.x, 0f));
}

// Symmetric matrices are (xx, yy, xy).
fn gabor_impl_symmetric(matrix: vec3<f32>, v: vec2<f32>) -> vec2<f32> {
    return ((matrix.xy * v) + (matrix.z * v.yx));
}

fn gabor_impl_inverse(matrix: vec3<f32>) -> vec3<f32> {
    let _e1 = matrix.yx;
    return (vec3<f32>(_e1.x, _e1.y, -(matrix.z)) / vec3(((matrix.x * matrix.y) - (matrix.z * matrix.z))));
}

// What a pixel covers, and what windows become under it. Lengths are in kernel radii.
struct GaborFootprint {
    covariance: vec3<f32>,
    widening: vec3<f32>,
    inverse: vec3<f32>,
    amplitude: f32,
    reach: vec2<f32>,
    joint: vec2<f32>,
    x: GaborPolynomial,
    y: GaborPolynomial,
}

// The footprint of a pixel, seen through a normal filter whose standard deviation is half a pixel.
//   dx, dy   steps from the pixel's place to its neighbours', dFdx(p) and dFdy(p), in kernel radii. Where they are NaN
//            or infinite or longer than 10^3, 10^3 is taken.
fn gabor_footprint(dx: vec2<f32>, dy: vec2<f32>) -> GaborFootprint {
    var dx_1: vec2<f32>;
    var dy_1: vec2<f32>;
    var unit: vec3<f32> = vec3<f32>(1f, 1f, 0f);
    var covariance: vec3<f32>;
    var footprint: GaborFootprint;
    var mean_1: f32;
    var difference: f32;
    var larger: f32;
    var side: f32;
    var local_21: f32;
    var smaller: f32;
    var kept: vec2<f32>;
    var local_22: vec3<f32>;
    var direction: vec3<f32>;
    var v_2: vec3<f32>;
    var variance_1: vec2<f32>;
    var product: f32;
    var local_23: f32;
    var correlation: f32;
    var local_24: f32;
    var rest: vec2<f32>;

    dx_1 = dx;
    dy_1 = dy;
    let _e10 = dx_1;
    let _e11 = dx_1;
    let _e12 = (_e10 * _e11);
    let _e13 = dx_1;
    let _e15 = dx_1;
    let _e21 = dy_1;
    let _e22 = dy_1;
    let _e23 = (_e21 * _e22);
    let _e24 = dy_1;
    let _e26 = dy_1;
    covariance = (0.25f * (vec3<f32>(_e12.x, _e12.y, (_e13.x * _e15.y)) + vec3<f32>(_e23.x, _e23.y, (_e24.x * _e26.y))));
    let _e35 = covariance;
    let _e37 = covariance;
    if !(((_e35.x + _e37.y) < 250000f)) {
        {
            dx_1 = vec2<f32>(1000f, 0f);
            dy_1 = vec2<f32>(0f, 1000f);
            let _e50 = unit;
            covariance = (250000f * _e50);
        }
    }
    let _e54 = covariance;
    footprint.covariance = _e54;
    let _e56 = covariance;
    let _e58 = covariance;
    mean_1 = (0.5f * (_e56.x + _e58.y));
    let _e64 = covariance;
    let _e66 = covariance;
    let _e70 = covariance;
    difference = length(vec2<f32>((0.5f * (_e64.x - _e66.y)), _e70.z));
    let _e75 = mean_1;
    let _e76 = difference;
    larger = (_e75 + _e76);
    let _e80 = dx_1;
    let _e82 = dy_1;
    let _e85 = dx_1;
    let _e87 = dy_1;
    side = (0.25f * ((_e80.x * _e82.y) - (_e85.y * _e87.x)));
    let _e93 = larger;
    if (_e93 > 0.000000000001f) {
        let _e96 = side;
        let _e97 = larger;
        let _e99 = side;
        let _e101 = mean_1;
        local_21 = min(((_e96 / _e97) * _e99), _e101);
    } else {
        local_21 = 0f;
    }
    let _e105 = local_21;
    smaller = _e105;
    let _e107 = larger;
    let _e108 = smaller;
    kept = min(vec2<f32>(_e107, _e108), vec2(0.25f));
    let _e114 = difference;
    if (_e114 > 0f) {
        let _e117 = covariance;
        let _e118 = mean_1;
        let _e119 = unit;
        let _e122 = difference;
        local_22 = ((_e117 - (_e118 * _e119)) / vec3(_e122));
    } else {
        local_22 = vec3(0f);
    }
    let _e128 = local_22;
    direction = _e128;
    let _e132 = kept;
    let _e134 = kept;
    let _e137 = unit;
    let _e139 = kept;
    let _e141 = kept;
    let _e144 = direction;
    footprint.widening = (0.5f * (((_e132.x + _e134.y) * _e137) + ((_e139.x - _e141.y) * _e144)));
    let _e149 = footprint.widening;
    let _e151 = footprint;
    let _e156 = max(_e151.widening.xy, vec2(0f));
    footprint.widening.x = _e156.x;
    footprint.widening.y = _e156.y;
    let _e163 = unit;
    let _e165 = footprint;
    let _e168 = gabor_impl_inverse(((0.121104f * _e163) + _e165.widening));
    footprint.inverse = _e168;
    let _e171 = footprint;
    let _e174 = footprint;
    let _e178 = footprint;
    let _e181 = footprint;
    footprint.amplitude = (0.121104f * sqrt(((_e171.inverse.x * _e174.inverse.y) - (_e178.inverse.z * _e181.inverse.z))));
    let _e191 = footprint;
    footprint.reach = (vec2(1.045f) + (1.5f * sqrt(_e191.widening.xy)));
    let _e198 = unit;
    let _e200 = footprint;
    v_2 = (_e198 - (0.121104f * _e200.inverse));
    let _e205 = v_2;
    variance_1 = max(_e205.xy, vec2(0f));
    let _e211 = variance_1;
    let _e213 = variance_1;
    product = (_e211.x * _e213.y);
    let _e217 = product;
    if (_e217 > 0f) {
        let _e220 = v_2;
        let _e223 = product;
        local_23 = min((abs(_e220.z) * inverseSqrt(_e223)), 1f);
    } else {
        local_23 = 0f;
    }
    let _e230 = local_23;
    correlation = _e230;
    let _e233 = correlation;
    let _e234 = variance_1;
    let _e238 = v_2;
    if (_e238.z < 0f) {
        local_24 = -1f;
    } else {
        local_24 = 1f;
    }
    let _e246 = local_24;
    footprint.joint = (sqrt((_e233 * _e234)) * vec2<f32>(1f, _e246));
    let _e250 = correlation;
    let _e252 = variance_1;
    rest = ((1f - _e250) * _e252);
    let _e256 = gabor_impl_normal_window();
    let _e257 = rest;
    let _e259 = gabor_impl_averaged(_e256, _e257.x);
    footprint.x = _e259;
    let _e261 = gabor_impl_normal_window();
    let _e262 = rest;
    let _e264 = gabor_impl_averaged(_e261, _e262.y);
    footprint.y = _e264;
    let _e265 = footprint;
    return _e265;
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe taken as normal, of
// the variance B = integral(q'^2) / (4 pi^2 integral(q^2)) along each axis,
//     |1 + 8 pi^2 B S|^(-1/2) e^(-4 pi^2 F S (1 + 8 pi^2 B S)^-1 F).
fn gabor_impl_transmitted(wave: vec2<f32>, covariance: vec3<f32>) -> f32 {
    var c_4: vec3<f32> = vec3<f32>(3f, -4.5f, 2.5f);
    var slope: vec4<f32>;
    var energy_4: f32;
    var widened: vec3<f32>;
    var slower: vec2<f32>;
    var taken: f32;

    let _e9 = c_4;
    let _e12 = c_4;
    let _e16 = c_4;
    let _e19 = c_4;
    let _e23 = c_4;
    let _e26 = c_4;
    let _e30 = c_4;
    let _e33 = c_4;
    let _e38 = c_4;
    let _e41 = c_4;
    slope = (vec4<f32>(((4f * _e9.x) * _e12.x), ((12f * _e16.x) * _e19.y), (((9f * _e23.y) * _e26.y) + ((16f * _e30.x) * _e33.z)), ((24f * _e38.y) * _e41.z)) * vec4<f32>(0.15238096f, 0.1015873f, 0.07388167f, 0.056832056f));
    let _e61 = slope;
    let _e66 = c_4;
    let _e69 = c_4;
    energy_4 = (4f * (dot(_e61, vec4(1f)) + (((16f * _e66.z) * _e69.z) * 0.045465644f)));
    let _e84 = energy_4;
    let _e86 = gabor_impl_energy();
    widened = (vec3<f32>(1f, 1f, 0f) + (((2f * _e84) / _e86.sum) * covariance));
    let _e92 = widened;
    let _e93 = gabor_impl_inverse(_e92);
    let _e94 = gabor_impl_symmetric(_e93, wave);
    slower = _e94;
    let _e97 = slower;
    let _e98 = gabor_impl_symmetric(covariance, _e97);
    taken = (39.478416f * dot(wave, _e98));
    let _e102 = taken;
    let _e107 = widened;
    let _e109 = widened;
    let _e112 = widened;
    let _e114 = widened;
    return (exp(-(min(_e102, 80f))) * inverseSqrt(((_e107.x * _e109.y) - (_e112.z * _e114.z))));
}

// The share of its variance that all of a kernel's noise loses under the footprint: in [0, 1].
fn gabor_removed(kernel: GaborKernel, footprint: GaborFootprint) -> f32 {
    var kernel_11: GaborKernel;
    var kept_1: f32 = 0f;
    var before: f32 = 0f;
    var i_5: i32 = 0i;
    var lobe_5: GaborLobe;
    var mean_2: f32;
    var j_1: i32;
    var within_1: vec2<f32>;
    var local_25: f32;

    kernel_11 = kernel;
    loop {
        let _e9 = i_5;
        if !((_e9 < 1i)) {
            break;
        }
        {
            let _e16 = i_5;
            let _e17 = kernel_11;
            if (_e16 >= _e17.lobes.count) {
                break;
            }
            let _e21 = i_5;
            let _e25 = kernel_11.lobes.lobe[_e21];
            lobe_5 = _e25;
            mean_2 = 0f;
            let _e29 = lobe_5;
            let _e34 = lobe_5;
            if ((_e29.spread.x == 0f) && (_e34.spread.y == 0f)) {
                {
                    let _e40 = lobe_5;
                    let _e43 = gabor_impl_transmitted(_e40.wave, footprint.covariance);
                    mean_2 = _e43;
                }
            } else {
                {
                    j_1 = 0i;
                    loop {
                        let _e46 = j_1;
                        if !((_e46 < 72i)) {
                            break;
                        }
                        {
                            let _e53 = lobe_5;
                            let _e55 = j_1;
                            let _e59 = j_1;
                            within_1 = (_e53.spread * ((vec2<f32>(f32((_e55 % 3i)), f32((_e59 / 3i))) * vec2<f32>(0.6666667f, 0.083333336f)) - vec2<f32>(0.6666667f, 0.9583333f)));
                            let _e82 = mean_2;
                            let _e83 = lobe_5;
                            let _e84 = within_1;
                            let _e85 = gabor_impl_wave_within(_e83, _e84);
                            let _e87 = gabor_impl_transmitted(_e85, footprint.covariance);
                            mean_2 = (_e82 + (_e87 / 72f));
                        }
                        continuing {
                            let _e50 = j_1;
                            j_1 = (_e50 + 1i);
                        }
                    }
                }
            }
            let _e91 = kept_1;
            let _e92 = lobe_5;
            let _e94 = before;
            let _e96 = mean_2;
            kept_1 = (_e91 + ((_e92.power - _e94) * _e96));
            let _e99 = lobe_5;
            before = _e99.power;
        }
        continuing {
            let _e13 = i_5;
            i_5 = (_e13 + 1i);
        }
    }
    let _e101 = before;
    if (_e101 > 0f) {
        let _e105 = kept_1;
        let _e106 = before;
        local_25 = clamp((1f - (_e105 / _e106)), 0f, 1f);
    } else {
        local_25 = 0f;
    }
    let _e114 = local_25;
    return _e114;
}

// A kernel of amplitude 1 under a footprint, as (real, imaginary): at a distance d from an impulse of this phase.
fn gabor_impl_kernel_filtered(d: vec2<f32>, wave: vec2<f32>, phase: f32, footprint: GaborFootprint) -> vec2<f32> {
    var shift: vec2<f32>;
    var real: vec2<f32>;
    var imaginary: vec2<f32>;
    var exponent: f32;
    var window_1: vec2<f32> = vec2(0f);
    var i_6: i32 = -2i;
    var local_26: f32;
    var local_27: f32;
    var point: f32;
    var local_28: f32;
    var local_29: f32;
    var weight: f32;
    var v_3: vec2<f32>;
    var amplitude: f32;
    var turns_1: f32;

    let _e7 = gabor_impl_symmetric(footprint.widening, (6.2831855f * wave));
    shift = _e7;
    let _e10 = gabor_impl_symmetric(footprint.inverse, d);
    real = _e10;
    let _e13 = shift;
    let _e14 = gabor_impl_symmetric(footprint.inverse, _e13);
    imaginary = _e14;
    let _e17 = shift;
    let _e18 = imaginary;
    let _e22 = shift;
    let _e25 = real;
    exponent = (0.5f * ((dot(_e17, _e18) - dot((6.2831855f * wave), _e22)) - dot(d, _e25)));
    let _e30 = real;
    real = (_e30 * 0.348f);
    let _e33 = imaginary;
    imaginary = (_e33 * 0.348f);
    let _e36 = exponent;
    let _e40 = imaginary;
    let _e41 = imaginary;
    if ((_e36 < -20f) || (dot(_e40, _e41) > 40f)) {
        return vec2(0f);
    }
    loop {
        let _e54 = i_6;
        if !((_e54 <= 2i)) {
            break;
        }
        {
            let _e61 = i_6;
            if (_e61 == 0i) {
                local_27 = 0f;
            } else {
                let _e65 = i_6;
                let _e67 = i_6;
                if (abs(_e67) == 1i) {
                    local_26 = 1.3556262f;
                } else {
                    local_26 = 1.428485f;
                }
                let _e74 = local_26;
                local_27 = (f32(_e65) * _e74);
            }
            let _e77 = local_27;
            point = _e77;
            let _e79 = i_6;
            if (_e79 == 0i) {
                local_29 = 0.5333333f;
            } else {
                let _e83 = i_6;
                if (abs(_e83) == 1i) {
                    local_28 = 0.22207592f;
                } else {
                    local_28 = 0.01125741f;
                }
                let _e90 = local_28;
                local_29 = _e90;
            }
            let _e92 = local_29;
            weight = _e92;
            let _e94 = point;
            v_3 = (_e94 * footprint.joint);
            let _e98 = window_1;
            let _e99 = weight;
            let _e101 = real;
            let _e103 = v_3;
            let _e106 = imaginary;
            let _e109 = gabor_impl_polynomial(footprint.x, vec2<f32>((_e101.x + _e103.x), _e106.x));
            let _e111 = real;
            let _e113 = v_3;
            let _e116 = imaginary;
            let _e119 = gabor_impl_polynomial(footprint.y, vec2<f32>((_e111.y + _e113.y), _e116.y));
            let _e120 = gabor_impl_product(_e109, _e119);
            window_1 = (_e98 + (_e99 * _e120));
        }
        continuing {
            let _e58 = i_6;
            i_6 = (_e58 + 1i);
        }
    }
    let _e124 = exponent;
    amplitude = (footprint.amplitude * exp(_e124));
    if ((footprint.widening.x + footprint.widening.y) < (footprint.covariance.x + footprint.covariance.y)) {
        let _e139 = amplitude;
        let _e141 = gabor_impl_transmitted(wave, footprint.covariance);
        let _e143 = gabor_impl_transmitted(wave, footprint.widening);
        amplitude = (_e139 * sqrt((_e141 / _e143)));
    }
    let _e148 = shift;
    let _e149 = real;
    turns_1 = ((dot(wave, d) - (dot(_e148, _e149) / 2.1865485f)) + phase);
    let _e158 = amplitude;
    let _e159 = window_1;
    let _e160 = turns_1;
    let _e163 = gabor_impl_sine((_e160 + 0.25f));
    let _e164 = turns_1;
    let _e165 = gabor_impl_sine(_e164);
    let _e167 = gabor_impl_product(_e159, vec2<f32>(_e163, _e165));
    return (_e158 * _e167);
}

// The noise at a place as a pixel sees it, (real, imaginary), as in gabor_field. Each part is within 2 % of a standard
// deviation, in the root mean square, of the noise seen through the filter, for footprints of up to a kernel radius; in
// larger ones it fades as it should, but is no smoother. Its variance is 1 - gabor_removed, within 1 %: for two phases
// from frequency 1.5 up.
// Cost: (2 reach R + 1)^2 N impulses on average, reach from 1 to 1.8, each about four times that of gabor_field.
fn gabor_field_filtered(place: GaborPlace, kernel: GaborKernel, footprint: GaborFootprint, seed: u32) -> vec2<f32> {
    var kernel_13: GaborKernel;
    var cell_base_1: vec2<f32>;
    var local_30: vec2<f32>;
    var first_1: vec2<i32>;
    var last: vec2<i32>;
    var cell_3: vec2<i32>;
    var time_2: f32;
    var seed_word_2: u32;
    var sum_2: vec2<f32> = vec2(0f);
    var j_2: i32;
    var row_word_2: u32;
    var i_7: i32;
    var column_2: i32;
    var k_2: i32;
    var word_8: u32;
    var impulse_1: vec2<f32>;
    var d_2: vec2<f32>;
    var phase_1: f32;

    kernel_13 = kernel;
    cell_base_1 = floor(place.local);
    let _e9 = cell_base_1;
    local_30 = (place.local - _e9);
    let _e12 = local_30;
    first_1 = vec2<i32>(floor((_e12 - (place.radius * footprint.reach))));
    let _e20 = local_30;
    last = vec2<i32>(floor((_e20 + (place.radius * footprint.reach))));
    let _e29 = cell_base_1;
    cell_3 = (place.cell + vec2<i32>(_e29));
    time_2 = fract(place.time);
    let _e36 = gabor_impl_seed_word(seed);
    seed_word_2 = _e36;
    let _e41 = first_1;
    j_2 = _e41.y;
    loop {
        let _e44 = j_2;
        let _e45 = last;
        if !((_e44 <= _e45.y)) {
            break;
        }
        {
            let _e52 = cell_3;
            let _e54 = j_2;
            let _e58 = gabor_impl_wrap((_e52.y + _e54), place.period.y);
            let _e59 = seed_word_2;
            let _e60 = gabor_impl_row_word(_e58, _e59);
            row_word_2 = _e60;
            let _e62 = first_1;
            i_7 = _e62.x;
            loop {
                let _e65 = i_7;
                let _e66 = last;
                if !((_e65 <= _e66.x)) {
                    break;
                }
                {
                    let _e73 = cell_3;
                    let _e75 = i_7;
                    let _e79 = gabor_impl_wrap((_e73.x + _e75), place.period.x);
                    column_2 = _e79;
                    k_2 = 0i;
                    loop {
                        let _e83 = k_2;
                        if !((_e83 < 1i)) {
                            break;
                        }
                        {
                            let _e90 = column_2;
                            let _e91 = row_word_2;
                            let _e92 = k_2;
                            let _e93 = gabor_impl_impulse_word(_e90, _e91, _e92);
                            word_8 = _e93;
                            let _e95 = word_8;
                            let _e96 = gabor_impl_position_plus_one(_e95);
                            impulse_1 = _e96;
                            let _e98 = local_30;
                            let _e99 = impulse_1;
                            let _e100 = i_7;
                            let _e102 = j_2;
                            d_2 = ((_e98 - (_e99 + (vec2<f32>(f32(_e100), f32(_e102)) - vec2(1f)))) / place.radius);
                            let _e113 = d_2;
                            if all((abs(_e113) < footprint.reach)) {
                                {
                                    let _e118 = impulse_1;
                                    let _e119 = kernel_13;
                                    let _e121 = gabor_impl_phase(_e118, _e119.phases);
                                    let _e122 = word_8;
                                    let _e123 = gabor_impl_phase_rate(_e122);
                                    let _e124 = time_2;
                                    phase_1 = (_e121 + (_e123 * _e124));
                                    let _e128 = sum_2;
                                    let _e129 = word_8;
                                    let _e130 = gabor_impl_magnitude(_e129);
                                    let _e131 = d_2;
                                    let _e132 = kernel_13;
                                    let _e133 = word_8;
                                    let _e134 = gabor_impl_wave(_e132, _e133);
                                    let _e135 = phase_1;
                                    let _e136 = gabor_impl_kernel_filtered(_e131, _e134, _e135, footprint);
                                    sum_2 = (_e128 + (_e130 * _e136));
                                }
                            }
                        }
                        continuing {
                            let _e87 = k_2;
                            k_2 = (_e87 + 1i);
                        }
                    }
                }
                continuing {
                    let _e70 = i_7;
                    i_7 = (_e70 + 1i);
                }
            }
        }
        continuing {
            let _e49 = j_2;
            j_2 = (_e49 + 1i);
        }
    }
    let _e139 = kernel_13;
    let _e140 = gabor_impl_scale(_e139, place);
    let _e141 = sum_2;
    return (_e140 * _e141);
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere: mean 0, variance 1 at every
// place, nearly Gaussian, continuous with its first derivatives. See gabor_place, gabor_kernel and gabor_field.
fn gabor_noise_at(cell: vec2<i32>, local: vec2<f32>, kernel: GaborKernel, seed: u32) -> f32 {
    var kernel_15: GaborKernel;

    kernel_15 = kernel;
    let _e5 = gabor_place(cell, local);
    let _e6 = kernel_15;
    let _e7 = gabor_field(_e5, _e6, seed);
    return _e7.value.y;
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
    var local_32: f32;
    var phase_2: f32;
    var local_33: f32;

    intensity = length(value);
    let _e3 = intensity;
    if (_e3 > 0f) {
        local_32 = (atan2(value.y, value.x) * 0.15915494f);
    } else {
        local_32 = 0f;
    }
    let _e13 = local_32;
    phase_2 = _e13;
    let _e15 = phase_2;
    if (_e15 < 0f) {
        let _e18 = phase_2;
        local_33 = min((_e18 + 1f), 0.99999994f);
    } else {
        let _e23 = phase_2;
        local_33 = _e23;
    }
    let _e25 = local_33;
    let _e26 = intensity;
    return vec2<f32>(_e25, _e26);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation.
// Mean and variance are those of gabor_noise. So is the rest of the law where period * R is whole; else cells grow to
// fit, and values become less normal: for `one` cvm 1.1 with 5 % fewer cells per radius, 6.4 with 10 %, 14 to 425 for
// square periods of 2.3 to 4.9. A period below 2, a kernel's diameter, is taken as 2.
fn gabor_noise_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var period_2: vec2<f32>;
    var cells: vec2<f32>;
    var radius: vec2<f32>;
    var within_2: vec2<f32>;
    var place_3: GaborPlace;

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
    within_2 = (p - (floor((p / _e19)) * _e22));
    let _e28 = within_2;
    let _e29 = radius;
    let _e31 = radius;
    let _e32 = cells;
    place_3 = GaborPlace(vec2(0i), (_e28 * _e29), _e31, vec2<i32>(_e32), 0f);
    let _e37 = place_3;
    let _e38 = gabor_kernel(frequency, orientation);
    let _e39 = gabor_field(_e37, _e38, seed);
    return _e39.value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// is gabor_noise of some instance. Its correlation with itself is the mean of cos(2 pi k lag) over k = 1 to 4: 0.87 at
// a lag of 0.03, 0 at 0.1, -0.38 at 0.16.
fn gabor_noise_animated(p: vec2<f32>, time: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place_4: GaborPlace;

    let _e9 = gabor_place(vec2(0i), (p * 1f));
    place_4 = _e9;
    place_4.time = time;
    let _e12 = place_4;
    let _e13 = gabor_kernel(frequency, orientation);
    let _e14 = gabor_field(_e12, _e13, seed);
    return _e14.value.y;
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` of the frequency, both evenly spread. pi/2 radians are every direction: isotropic noise. As
// gabor_noise, with the ranges of gabor_lobe.
fn gabor_noise_spread(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> f32 {
    var lobe_6: GaborLobe;

    let _e7 = gabor_lobe(frequency, orientation, frequency_spread, orientation_spread, 1f);
    lobe_6 = _e7;
    let _e13 = gabor_place(vec2(0i), (p * 1f));
    let _e14 = lobe_6;
    let _e15 = gabor_kernel_lobe(_e14);
    let _e16 = gabor_field(_e13, _e15, seed);
    return _e16.value.y;
}

// Noise of a spectrum of several lobes at p, as many impulses as for one: see gabor_kernel_lobes.
//     #define GABOR_LOBES 2              // before the file
//     GaborLobes lobes;
//     lobes.lobe[0] = gabor_lobe(4.0, 0.0, 0.0, 0.1, 2.0);
//     lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.3, 0.0, 1.0);
//     lobes.count = 2;
fn gabor_noise_lobes(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> f32 {
    var lobes_4: GaborLobes;

    lobes_4 = lobes;
    let _e8 = gabor_place(vec2(0i), (p * 1f));
    let _e9 = lobes_4;
    let _e10 = gabor_kernel_lobes(_e9);
    let _e11 = gabor_field(_e8, _e10, seed);
    return _e11.value.y;
}

// The same spectrum as a sum of independent noises, one for each lobe [TNVT19, figure 6]: at the cost of each. Every
// place has waves of every lobe, which looks smoother where lobes differ much.
fn gabor_noise_sum(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> f32 {
    var lobes_6: GaborLobes;
    var place_5: GaborPlace;
    var power_2: f32 = 0f;
    var sum_3: f32 = 0f;
    var i_8: i32 = 0i;
    var own_seed: u32;
    var local_34: f32;

    lobes_6 = lobes;
    let _e8 = gabor_place(vec2(0i), (p * 1f));
    place_5 = _e8;
    loop {
        let _e16 = i_8;
        if !((_e16 < 1i)) {
            break;
        }
        {
            let _e23 = i_8;
            let _e24 = lobes_6;
            if (_e23 >= _e24.count) {
                break;
            }
            let _e27 = i_8;
            let _e28 = gabor_lobe_seed(seed, _e27);
            own_seed = _e28;
            let _e30 = sum_3;
            let _e31 = i_8;
            let _e34 = lobes_6.lobe[_e31];
            let _e37 = place_5;
            let _e38 = i_8;
            let _e41 = lobes_6.lobe[_e38];
            let _e42 = gabor_kernel_lobe(_e41);
            let _e43 = own_seed;
            let _e44 = gabor_field(_e37, _e42, _e43);
            sum_3 = (_e30 + (sqrt(_e34.power) * _e44.value.y));
            let _e49 = power_2;
            let _e50 = i_8;
            let _e53 = lobes_6.lobe[_e50];
            power_2 = (_e49 + _e53.power);
        }
        continuing {
            let _e20 = i_8;
            i_8 = (_e20 + 1i);
        }
    }
    let _e56 = power_2;
    if (_e56 > 0f) {
        let _e59 = sum_3;
        let _e60 = power_2;
        local_34 = (_e59 * inverseSqrt(_e60));
    } else {
        local_34 = 0f;
    }
    let _e65 = local_34;
    return _e65;
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this took away: what a material lost in roughness, or a picture in contrast. For small
// steps it is gabor_noise, within 2 %. See gabor_footprint and gabor_field_filtered.
fn gabor_noise_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    var kernel_16: GaborKernel;
    var footprint_4: GaborFootprint;
    var value_4: vec2<f32>;

    let _e6 = gabor_kernel(frequency, orientation);
    kernel_16 = _e6;
    let _e8 = gabor_footprint(dx, dy);
    footprint_4 = _e8;
    let _e14 = gabor_place(vec2(0i), (p * 1f));
    let _e15 = kernel_16;
    let _e16 = footprint_4;
    let _e17 = gabor_field_filtered(_e14, _e15, _e16, seed);
    value_4 = _e17;
    let _e19 = value_4;
    let _e21 = kernel_16;
    let _e22 = footprint_4;
    let _e23 = gabor_removed(_e21, _e22);
    return vec2<f32>(_e19.y, _e23);
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
fn gabor_unorm(noise: f32) -> f32 {
    return clamp((0.5f + (0.25f * noise)), 0f, 1f);
}
