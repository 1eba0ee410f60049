// gabor_lattice.wgsl: exactly normalized Gabor noise in two dimensions, from random amplitudes on a lattice: for WGSL.
//
// Made from shaders/gabor_lattice.glsl by tools/translate and naga 30.0.1: change that file, not this one.
//
// The nodes c_ij of a square lattice, R to the unit of length, have random complex amplitudes A_ij, independent and
// normal, and each sends out a wave under a window that ends one unit from it along x and y, the kernel radius:
//     n(p) = K Im sum_ij A_ij h(x - x_i) h(y - y_j) exp(2 pi i F.(p - c_ij)),   F = frequency (cos o, sin o)
// The window is Hann's, h(x) = (1 + cos pi x) / 2. GABOR_TAPS nodes along each axis reach a point, R = GABOR_TAPS / 2,
// and as three or more evenly spaced shifts of cos and of cos^2 over their period sum to a constant,
//     sum_i h(x - x_i)^2 = 3/8 GABOR_TAPS   at every x,
// and likewise for the squares of the derivatives: the variances of the noise, of its gradient and of its second
// derivatives are the same at every place, at every frequency. The sum is normal where the amplitudes are. Each wave's
// phase counts from its own node, so frequency and orientation may vary from place to place. After [TNVT19] Tavernier,
// Neyret, Vergne, Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019, whose last section asks for it.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// 3, 2 or 4: change it here, or give it to the pipeline as a constant.
override GABOR_TAPS: i32 = 3;

// One well-mixed word for each word, another sequence for each salt: two rounds of shift and multiply (constants from
// the hash-prospector project).
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

// The seed of noise `index` of a sum: those of different indices are independent.
fn gabor_lobe_seed(seed: u32, index: i32) -> u32 {
    let _e7 = gabor_impl_mix((seed + (u32(index) * 2246822507u)), 2654435761u);
    return _e7;
}

fn gabor_impl_salt(seed: u32) -> u32 {
    let _e4 = gabor_impl_mix((seed * 2654435761u), 625341585u);
    return _e4;
}

// The word of a column or a row of nodes: odd and of 24 bits, the highest set, so that it takes all products all over
// 32 bits; GPUs multiply 24 bits at a quarter of the cost. It has 2^22 values: of 4096 columns two pairs are alike.
fn gabor_impl_line_word(index: i32, salt: u32) -> u32 {
    var word_2: u32;

    word_2 = ((u32(index) * 2654435761u) + salt);
    let _e7 = word_2;
    let _e8 = word_2;
    word_2 = ((_e7 ^ (_e8 >> 15u)) * 3545902487u);
    let _e14 = word_2;
    return ((_e14 >> 8u) | 8388609u);
}

fn gabor_impl_node_word(column: u32, row: u32) -> u32 {
    return (column * row);
}

// Another word of the same node.
fn gabor_impl_next_word(word: u32) -> u32 {
    return ((word ^ (word >> 15u)) * 3545902487u);
}

fn gabor_impl_amplitude(word: u32) -> vec2<f32> {
    var u: vec2<f32>;

    u = vec2<f32>(f32(i32(word)), f32(i32((word << 16u))));
    let _e9 = u;
    let _e11 = u;
    let _e20 = u;
    let _e21 = u;
    return ((_e9 - (0.89289314f * clamp(_e11, vec2(-2011925800f), vec2(2011925800f)))) * ((_e20 * _e21) + vec2(7397391600000000000f)));
}

// The same at the time with this cosine and sine, if animated: a sum of three amplitudes, of the word and of two that no
// other noise of the node has. Its law is theirs at every time, and its correlation with itself falls with the time
// between as (1 + cos) / 2.
fn gabor_impl_amplitude_at(word: u32, animated: bool, time: vec2<f32>) -> vec2<f32> {
    var a: vec2<f32>;
    var second: u32;
    var b: vec2<f32>;
    var c: vec2<f32>;

    let _e3 = gabor_impl_amplitude(word);
    a = _e3;
    if animated {
        {
            let _e7 = gabor_impl_next_word((word ^ 1759714724u));
            second = _e7;
            let _e9 = second;
            let _e10 = gabor_impl_amplitude(_e9);
            b = _e10;
            let _e12 = second;
            let _e13 = gabor_impl_next_word(_e12);
            let _e14 = gabor_impl_amplitude(_e13);
            c = _e14;
            let _e17 = a;
            let _e18 = b;
            let _e21 = a;
            let _e22 = b;
            let _e30 = c;
            a = ((0.5f * ((_e17 + _e18) + (time.x * (_e21 - _e22)))) + ((0.70710677f * time.y) * _e30));
        }
    }
    let _e33 = a;
    return _e33;
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1] and as t is rounded beyond. With t reduced to half a turn and
// y = |t| - 1/4, cos(2 pi t) = -sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), |2 pi y| <= pi/2: minimax polynomials.
fn gabor_impl_wave(t: f32) -> vec2<f32> {
    var t_1: f32;
    var y: f32;
    var s: f32;
    var r: f32;
    var cosine: f32;
    var sine: f32;
    var local: f32;

    t_1 = t;
    let _e2 = t_1;
    let _e3 = t_1;
    t_1 = (_e2 - floor((_e3 + 0.5f)));
    let _e8 = t_1;
    y = (abs(_e8) - 0.25f);
    let _e13 = y;
    let _e14 = y;
    s = (_e13 * _e14);
    let _e17 = s;
    let _e18 = s;
    r = (_e17 * _e18);
    let _e22 = s;
    let _e26 = r;
    let _e28 = s;
    let _e33 = r;
    cosine = (((41.341656f * _e22) - 6.283185f) + (_e26 * (((76.54978f * _e28) - 81.601006f) - (39.53671f * _e33))));
    let _e41 = s;
    let _e44 = r;
    let _e47 = s;
    let _e51 = r;
    sine = ((1f - (19.73917f * _e41)) + (_e44 * ((64.93459f - (85.24033f * _e47)) + (56.24243f * _e51))));
    let _e57 = y;
    let _e58 = cosine;
    let _e60 = t_1;
    if (_e60 < 0f) {
        let _e63 = sine;
        local = -(_e63);
    } else {
        let _e65 = sine;
        local = _e65;
    }
    let _e67 = local;
    return vec2<f32>((_e57 * _e58), _e67);
}

// Product of complex numbers.
fn gabor_impl_product(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(((a.x * b.x) - (a.y * b.y)), ((a.x * b.y) + (a.y * b.x)));
}

// The windows of the GABOR_TAPS nodes along an axis that reach a point, and their derivatives per kernel radius.
// GABOR_IMPL_ENERGY is the sum of the squares of the windows.
struct GaborWindows {
    value: vec4<f32>,
    slope: vec4<f32>,
}

fn gabor_impl_windows(x: f32) -> GaborWindows {
    if GABOR_TAPS == 2 {
        var s_1: f32;
        var pair: vec2<f32>;
        var scale: f32;
        var slope: vec2<f32>;

        s_1 = ((x * x) * (3f - (2f * x)));
        let _e9 = s_1;
        let _e11 = s_1;
        pair = vec2<f32>((1f - _e9), _e11);
        let _e14 = pair;
        let _e15 = pair;
        scale = inverseSqrt(dot(_e14, _e15));
        let _e24 = scale;
        let _e26 = scale;
        let _e28 = scale;
        let _e30 = pair;
        slope = ((((((6f * x) * (1f - x)) * _e24) * _e26) * _e28) * _e30.yx);
        let _e34 = scale;
        let _e35 = pair;
        let _e36 = (_e34 * _e35);
        let _e42 = slope;
        let _e45 = slope;
        return GaborWindows(vec4<f32>(_e36.x, _e36.y, 0f, 0f), vec4<f32>(-(_e42.x), _e45.y, 0f, 0f));
    } else if GABOR_TAPS == 4 {
        var x_1: f32;
        var s_1: f32;
        var cosine_1: f32;
        var sine_1: f32;
        var c_1: vec2<f32>;

        x_1 = x;
        let _e2 = x_1;
        x_1 = (_e2 - 0.5f);
        let _e5 = x_1;
        let _e6 = x_1;
        s_1 = (_e5 * _e6);
        let _e10 = s_1;
        let _e13 = s_1;
        let _e15 = s_1;
        cosine_1 = (0.35355338f + (_e10 * (-0.43617776f + (_e13 * (0.08966066f - (_e15 * 0.0072154454f))))));
        let _e24 = x_1;
        let _e26 = s_1;
        let _e29 = s_1;
        let _e31 = s_1;
        sine_1 = (_e24 * (0.5553604f + (_e26 * (-0.2283824f + (_e29 * (0.028169686f - (_e31 * 0.0016236193f)))))));
        let _e41 = cosine_1;
        let _e42 = sine_1;
        let _e44 = cosine_1;
        let _e45 = sine_1;
        c_1 = vec2<f32>((_e41 - _e42), (_e44 + _e45));
        let _e50 = c_1;
        let _e53 = c_1;
        let _e55 = c_1;
        let _e57 = c_1;
        let _e64 = c_1;
        let _e67 = c_1;
        let _e70 = c_1;
        let _e72 = c_1;
        return GaborWindows((vec4(0.5f) + vec4<f32>(-(_e50.y), _e53.x, _e55.y, -(_e57.x))), (3.1415927f * vec4<f32>(-(_e64.x), -(_e67.y), _e70.x, _e72.y)));
    } else {
        var s_1: f32;
        var c_1: f32;
        var b_2: f32;
        var a_2: f32;
        var slope: f32;

        s_1 = (x * x);
        let _e4 = s_1;
        let _e7 = s_1;
        let _e9 = s_1;
        c_1 = (0.5f + (_e4 * (-1.09661f + (_e7 * (0.40054825f - (_e9 * 0.05644487f))))));
        let _e19 = s_1;
        let _e22 = s_1;
        let _e24 = s_1;
        b_2 = (x * (0.9068996f + (_e19 * (-0.66301125f + (_e22 * (0.14532053f - (_e24 * 0.01467483f)))))));
        let _e36 = c_1;
        a_2 = (0.5f - (0.5f * _e36));
        let _e41 = b_2;
        slope = (1.8137994f * _e41);
        let _e44 = a_2;
        let _e45 = b_2;
        let _e48 = c_1;
        let _e50 = a_2;
        let _e51 = b_2;
        let _e55 = slope;
        let _e57 = c_1;
        let _e62 = slope;
        let _e64 = slope;
        let _e66 = c_1;
        return GaborWindows(vec4<f32>((_e44 - _e45), (0.5f + _e48), (_e50 + _e51), 0f), vec4<f32>((_e55 - (2.720699f * _e57)), (-2f * _e62), (_e64 + (2.720699f * _e66)), 0f));
    }
}

// A wave vector and all that the noise needs of it: make it once where frequency and orientation do not vary.
struct GaborKernel {
    wave: vec2<f32>,
    step_x: vec2<f32>,
    step_y: vec2<f32>,
}

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace {
    cell: vec2<i32>,
    local: vec2<f32>,
    radius: vec2<f32>,
    period: vec2<i32>,
    animated: bool,
    time: f32,
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Compilers leave out what is not used.
struct GaborField {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
    four: vec4<f32>,
}

// An index within a period.
fn gabor_impl_wrap(index: i32, period: i32) -> i32 {
    var within: i32;
    var local_1: i32;

    if (period == 0i) {
        return index;
    }
    within = (index - ((index / period) * period));
    let _e8 = within;
    if (_e8 < 0i) {
        let _e11 = within;
        local_1 = (_e11 + period);
    } else {
        let _e13 = within;
        local_1 = _e13;
    }
    let _e15 = local_1;
    return _e15;
}

// The nodes of an axis that reach a point: their words, and what their amplitudes are multiplied with along it, h e and
// h' e with e = exp(2 pi i F (x - x_i)), relative to the second node (for two taps, to the first).
struct GaborAxis {
    word: vec4<u32>,
    real: vec4<f32>,
    imaginary: vec4<f32>,
    slope_real: vec4<f32>,
    slope_imaginary: vec4<f32>,
}

//   step             e^(2 pi i F / R): what the wave turns from one node to the next
//   real, imaginary  windows: the latter are there after a filter
fn gabor_impl_axis(first: i32, period: i32, salt: u32, step: vec2<f32>, real: GaborWindows, imaginary: GaborWindows) -> GaborAxis {
    if GABOR_TAPS == 2 {
        var cosine_1: vec4<f32>;
        var sine_1: vec4<f32>;
        var word_6: vec4<u32>;

        cosine_1 = vec4<f32>(1f, step.x, 0f, 0f);
        sine_1 = vec4<f32>(0f, -(step.y), 0f, 0f);
        let _e19 = gabor_impl_wrap(first, period);
        let _e20 = gabor_impl_line_word(_e19, salt);
        let _e23 = gabor_impl_wrap((first + 1i), period);
        let _e24 = gabor_impl_line_word(_e23, salt);
        let _e27 = gabor_impl_wrap((first + 2i), period);
        let _e28 = gabor_impl_line_word(_e27, salt);
        let _e31 = gabor_impl_wrap((first + 3i), period);
        let _e32 = gabor_impl_line_word(_e31, salt);
        word_6 = vec4<u32>(_e20, _e24, _e28, _e32);
        let _e35 = word_6;
        let _e37 = cosine_1;
        let _e40 = sine_1;
        let _e44 = sine_1;
        let _e47 = cosine_1;
        let _e51 = cosine_1;
        let _e54 = sine_1;
        let _e58 = sine_1;
        let _e61 = cosine_1;
        return GaborAxis(_e35, ((real.value * _e37) - (imaginary.value * _e40)), ((real.value * _e44) + (imaginary.value * _e47)), ((real.slope * _e51) - (imaginary.slope * _e54)), ((real.slope * _e58) + (imaginary.slope * _e61)));
    } else if GABOR_TAPS == 4 {
        var two: vec2<f32>;
        var cosine_2: vec4<f32>;
        var sine_2: vec4<f32>;
        var word_6: vec4<u32>;

        let _e6 = gabor_impl_product(step, step);
        two = _e6;
        let _e11 = two;
        cosine_2 = vec4<f32>(step.x, 1f, step.x, _e11.x);
        let _e19 = two;
        sine_2 = vec4<f32>(step.y, 0f, -(step.y), -(_e19.y));
        let _e24 = gabor_impl_wrap(first, period);
        let _e25 = gabor_impl_line_word(_e24, salt);
        let _e28 = gabor_impl_wrap((first + 1i), period);
        let _e29 = gabor_impl_line_word(_e28, salt);
        let _e32 = gabor_impl_wrap((first + 2i), period);
        let _e33 = gabor_impl_line_word(_e32, salt);
        let _e36 = gabor_impl_wrap((first + 3i), period);
        let _e37 = gabor_impl_line_word(_e36, salt);
        word_6 = vec4<u32>(_e25, _e29, _e33, _e37);
        let _e40 = word_6;
        let _e42 = cosine_2;
        let _e45 = sine_2;
        let _e49 = sine_2;
        let _e52 = cosine_2;
        let _e56 = cosine_2;
        let _e59 = sine_2;
        let _e63 = sine_2;
        let _e66 = cosine_2;
        return GaborAxis(_e40, ((real.value * _e42) - (imaginary.value * _e45)), ((real.value * _e49) + (imaginary.value * _e52)), ((real.slope * _e56) - (imaginary.slope * _e59)), ((real.slope * _e63) + (imaginary.slope * _e66)));
    } else {
        var two: vec2<f32>;
        var cosine_1: vec4<f32>;
        var sine_1: vec4<f32>;
        var word_6: vec4<u32>;

        let _e6 = gabor_impl_product(step, step);
        two = _e6;
        let _e11 = two;
        cosine_1 = vec4<f32>(step.x, 1f, step.x, _e11.x);
        let _e19 = two;
        sine_1 = vec4<f32>(step.y, 0f, -(step.y), -(_e19.y));
        let _e24 = gabor_impl_wrap(first, period);
        let _e25 = gabor_impl_line_word(_e24, salt);
        let _e28 = gabor_impl_wrap((first + 1i), period);
        let _e29 = gabor_impl_line_word(_e28, salt);
        let _e32 = gabor_impl_wrap((first + 2i), period);
        let _e33 = gabor_impl_line_word(_e32, salt);
        let _e36 = gabor_impl_wrap((first + 3i), period);
        let _e37 = gabor_impl_line_word(_e36, salt);
        word_6 = vec4<u32>(_e25, _e29, _e33, _e37);
        let _e40 = word_6;
        let _e42 = cosine_1;
        let _e45 = sine_1;
        let _e49 = sine_1;
        let _e52 = cosine_1;
        let _e56 = cosine_1;
        let _e59 = sine_1;
        let _e63 = sine_1;
        let _e66 = cosine_1;
        return GaborAxis(_e40, ((real.value * _e42) - (imaginary.value * _e45)), ((real.value * _e49) + (imaginary.value * _e52)), ((real.slope * _e56) - (imaginary.slope * _e59)), ((real.slope * _e63) + (imaginary.slope * _e66)));
    }
}

// Sums of amplitudes times windows and waves, of four noises, with the windows' derivatives too: along x, along y (of the
// first noise), and along both.
struct GaborSum {
    real: vec4<f32>,
    imaginary: vec4<f32>,
    slope_real: vec4<f32>,
    slope_imaginary: vec4<f32>,
    slope_y: vec2<f32>,
    mixed_real: vec4<f32>,
    mixed_imaginary: vec4<f32>,
}

fn gabor_impl_no_sum() -> GaborSum {
    return GaborSum(vec4(0f), vec4(0f), vec4(0f), vec4(0f), vec2(0f), vec4(0f), vec4(0f));
}

// Adds node k of a row. Loops over nodes and rows would be shorter, but some compilers do not unroll them.
//   time  cosine and sine of time
fn gabor_impl_add_node(row: ptr<function, GaborSum>, columns: GaborAxis, k: i32, row_word: u32, animated: bool, time: vec2<f32>) {
    if GABOR_TAPS == 2 {
        var word_7: u32;
        var second_1: u32;
        var third: u32;
        var a_2: vec2<f32>;
        var b_2: vec2<f32>;
        var c_1: vec2<f32>;
        var d: vec2<f32>;
        var real_1: vec4<f32>;
        var imaginary_1: vec4<f32>;

        let _e8 = gabor_impl_node_word(columns.word[k], row_word);
        word_7 = _e8;
        let _e10 = word_7;
        let _e11 = gabor_impl_next_word(_e10);
        second_1 = _e11;
        let _e13 = second_1;
        let _e14 = gabor_impl_next_word(_e13);
        third = _e14;
        let _e16 = word_7;
        let _e17 = gabor_impl_amplitude_at(_e16, animated, time);
        a_2 = _e17;
        let _e19 = second_1;
        let _e20 = gabor_impl_amplitude_at(_e19, animated, time);
        b_2 = _e20;
        let _e22 = third;
        let _e23 = gabor_impl_amplitude_at(_e22, animated, time);
        c_1 = _e23;
        let _e25 = third;
        let _e26 = gabor_impl_next_word(_e25);
        let _e27 = gabor_impl_amplitude_at(_e26, animated, time);
        d = _e27;
        let _e29 = a_2;
        let _e31 = b_2;
        let _e33 = c_1;
        let _e35 = d;
        real_1 = vec4<f32>(_e29.x, _e31.x, _e33.x, _e35.x);
        let _e39 = a_2;
        let _e41 = b_2;
        let _e43 = c_1;
        let _e45 = d;
        imaginary_1 = vec4<f32>(_e39.y, _e41.y, _e43.y, _e45.y);
        let _e50 = (*row);
        let _e54 = real_1;
        let _e58 = imaginary_1;
        (*row).real = (_e50.real + ((columns.real[k] * _e54) - (columns.imaginary[k] * _e58)));
        let _e63 = (*row);
        let _e67 = imaginary_1;
        let _e71 = real_1;
        (*row).imaginary = (_e63.imaginary + ((columns.real[k] * _e67) + (columns.imaginary[k] * _e71)));
        let _e76 = (*row);
        let _e80 = real_1;
        let _e84 = imaginary_1;
        (*row).slope_real = (_e76.slope_real + ((columns.slope_real[k] * _e80) - (columns.slope_imaginary[k] * _e84)));
        let _e89 = (*row);
        let _e93 = imaginary_1;
        let _e97 = real_1;
        (*row).slope_imaginary = (_e89.slope_imaginary + ((columns.slope_real[k] * _e93) + (columns.slope_imaginary[k] * _e97)));
        return;
    } else if GABOR_TAPS == 4 {
        var word_7: u32;
        var second_1: u32;
        var third: u32;
        var a_2: vec2<f32>;
        var b_2: vec2<f32>;
        var c_2: vec2<f32>;
        var d: vec2<f32>;
        var real_1: vec4<f32>;
        var imaginary_1: vec4<f32>;

        let _e8 = gabor_impl_node_word(columns.word[k], row_word);
        word_7 = _e8;
        let _e10 = word_7;
        let _e11 = gabor_impl_next_word(_e10);
        second_1 = _e11;
        let _e13 = second_1;
        let _e14 = gabor_impl_next_word(_e13);
        third = _e14;
        let _e16 = word_7;
        let _e17 = gabor_impl_amplitude_at(_e16, animated, time);
        a_2 = _e17;
        let _e19 = second_1;
        let _e20 = gabor_impl_amplitude_at(_e19, animated, time);
        b_2 = _e20;
        let _e22 = third;
        let _e23 = gabor_impl_amplitude_at(_e22, animated, time);
        c_2 = _e23;
        let _e25 = third;
        let _e26 = gabor_impl_next_word(_e25);
        let _e27 = gabor_impl_amplitude_at(_e26, animated, time);
        d = _e27;
        let _e29 = a_2;
        let _e31 = b_2;
        let _e33 = c_2;
        let _e35 = d;
        real_1 = vec4<f32>(_e29.x, _e31.x, _e33.x, _e35.x);
        let _e39 = a_2;
        let _e41 = b_2;
        let _e43 = c_2;
        let _e45 = d;
        imaginary_1 = vec4<f32>(_e39.y, _e41.y, _e43.y, _e45.y);
        let _e50 = (*row);
        let _e54 = real_1;
        let _e58 = imaginary_1;
        (*row).real = (_e50.real + ((columns.real[k] * _e54) - (columns.imaginary[k] * _e58)));
        let _e63 = (*row);
        let _e67 = imaginary_1;
        let _e71 = real_1;
        (*row).imaginary = (_e63.imaginary + ((columns.real[k] * _e67) + (columns.imaginary[k] * _e71)));
        let _e76 = (*row);
        let _e80 = real_1;
        let _e84 = imaginary_1;
        (*row).slope_real = (_e76.slope_real + ((columns.slope_real[k] * _e80) - (columns.slope_imaginary[k] * _e84)));
        let _e89 = (*row);
        let _e93 = imaginary_1;
        let _e97 = real_1;
        (*row).slope_imaginary = (_e89.slope_imaginary + ((columns.slope_real[k] * _e93) + (columns.slope_imaginary[k] * _e97)));
        return;
    } else {
        var word_7: u32;
        var second_1: u32;
        var third: u32;
        var a_3: vec2<f32>;
        var b_3: vec2<f32>;
        var c_2: vec2<f32>;
        var d: vec2<f32>;
        var real_1: vec4<f32>;
        var imaginary_1: vec4<f32>;

        let _e8 = gabor_impl_node_word(columns.word[k], row_word);
        word_7 = _e8;
        let _e10 = word_7;
        let _e11 = gabor_impl_next_word(_e10);
        second_1 = _e11;
        let _e13 = second_1;
        let _e14 = gabor_impl_next_word(_e13);
        third = _e14;
        let _e16 = word_7;
        let _e17 = gabor_impl_amplitude_at(_e16, animated, time);
        a_3 = _e17;
        let _e19 = second_1;
        let _e20 = gabor_impl_amplitude_at(_e19, animated, time);
        b_3 = _e20;
        let _e22 = third;
        let _e23 = gabor_impl_amplitude_at(_e22, animated, time);
        c_2 = _e23;
        let _e25 = third;
        let _e26 = gabor_impl_next_word(_e25);
        let _e27 = gabor_impl_amplitude_at(_e26, animated, time);
        d = _e27;
        let _e29 = a_3;
        let _e31 = b_3;
        let _e33 = c_2;
        let _e35 = d;
        real_1 = vec4<f32>(_e29.x, _e31.x, _e33.x, _e35.x);
        let _e39 = a_3;
        let _e41 = b_3;
        let _e43 = c_2;
        let _e45 = d;
        imaginary_1 = vec4<f32>(_e39.y, _e41.y, _e43.y, _e45.y);
        let _e50 = (*row);
        let _e54 = real_1;
        let _e58 = imaginary_1;
        (*row).real = (_e50.real + ((columns.real[k] * _e54) - (columns.imaginary[k] * _e58)));
        let _e63 = (*row);
        let _e67 = imaginary_1;
        let _e71 = real_1;
        (*row).imaginary = (_e63.imaginary + ((columns.real[k] * _e67) + (columns.imaginary[k] * _e71)));
        let _e76 = (*row);
        let _e80 = real_1;
        let _e84 = imaginary_1;
        (*row).slope_real = (_e76.slope_real + ((columns.slope_real[k] * _e80) - (columns.slope_imaginary[k] * _e84)));
        let _e89 = (*row);
        let _e93 = imaginary_1;
        let _e97 = real_1;
        (*row).slope_imaginary = (_e89.slope_imaginary + ((columns.slope_real[k] * _e93) + (columns.slope_imaginary[k] * _e97)));
        return;
    }
}

// Adds row k.
fn gabor_impl_add_row(sum: ptr<function, GaborSum>, columns: GaborAxis, rows: GaborAxis, k: i32, animated: bool, time: vec2<f32>) {
    if GABOR_TAPS == 2 {
        var row_2: GaborSum;
        var factor: vec2<f32>;
        var slope_1: vec2<f32>;

        let _e6 = gabor_impl_no_sum();
        row_2 = _e6;
        gabor_impl_add_node((&row_2), columns, 0i, rows.word[k], animated, time);
        gabor_impl_add_node((&row_2), columns, 1i, rows.word[k], animated, time);
        if false {
            gabor_impl_add_node((&row_2), columns, 2i, rows.word[k], animated, time);
        }
        if false {
            gabor_impl_add_node((&row_2), columns, 3i, rows.word[k], animated, time);
        }
        factor = vec2<f32>(rows.real[k], rows.imaginary[k]);
        let _e40 = factor;
        if (_e40.x > -2f) {
            {
                let _e46 = (*sum);
                let _e48 = factor;
                let _e50 = row_2;
                let _e53 = factor;
                let _e55 = row_2;
                (*sum).real = (_e46.real + ((_e48.x * _e50.real) - (_e53.y * _e55.imaginary)));
                let _e61 = (*sum);
                let _e63 = factor;
                let _e65 = row_2;
                let _e68 = factor;
                let _e70 = row_2;
                (*sum).imaginary = (_e61.imaginary + ((_e63.x * _e65.imaginary) + (_e68.y * _e70.real)));
                let _e76 = (*sum);
                let _e78 = factor;
                let _e80 = row_2;
                let _e83 = factor;
                let _e85 = row_2;
                (*sum).slope_real = (_e76.slope_real + ((_e78.x * _e80.slope_real) - (_e83.y * _e85.slope_imaginary)));
                let _e91 = (*sum);
                let _e93 = factor;
                let _e95 = row_2;
                let _e98 = factor;
                let _e100 = row_2;
                (*sum).slope_imaginary = (_e91.slope_imaginary + ((_e93.x * _e95.slope_imaginary) + (_e98.y * _e100.slope_real)));
                slope_1 = vec2<f32>(rows.slope_real[k], rows.slope_imaginary[k]);
                let _e112 = (*sum);
                let _e114 = row_2;
                let _e117 = row_2;
                let _e121 = slope_1;
                let _e122 = gabor_impl_product(vec2<f32>(_e114.real.x, _e117.imaginary.x), _e121);
                (*sum).slope_y = (_e112.slope_y + _e122);
                let _e125 = (*sum);
                let _e127 = slope_1;
                let _e129 = row_2;
                let _e132 = slope_1;
                let _e134 = row_2;
                (*sum).mixed_real = (_e125.mixed_real + ((_e127.x * _e129.slope_real) - (_e132.y * _e134.slope_imaginary)));
                let _e140 = (*sum);
                let _e142 = slope_1;
                let _e144 = row_2;
                let _e147 = slope_1;
                let _e149 = row_2;
                (*sum).mixed_imaginary = (_e140.mixed_imaginary + ((_e142.x * _e144.slope_imaginary) + (_e147.y * _e149.slope_real)));
                return;
            }
        } else {
            return;
        }
    } else if GABOR_TAPS == 4 {
        var row_2: GaborSum;
        var factor: vec2<f32>;
        var slope: vec2<f32>;

        let _e6 = gabor_impl_no_sum();
        row_2 = _e6;
        gabor_impl_add_node((&row_2), columns, 0i, rows.word[k], animated, time);
        gabor_impl_add_node((&row_2), columns, 1i, rows.word[k], animated, time);
        if true {
            gabor_impl_add_node((&row_2), columns, 2i, rows.word[k], animated, time);
        }
        if true {
            gabor_impl_add_node((&row_2), columns, 3i, rows.word[k], animated, time);
        }
        factor = vec2<f32>(rows.real[k], rows.imaginary[k]);
        let _e40 = factor;
        if (_e40.x > -2f) {
            {
                let _e46 = (*sum);
                let _e48 = factor;
                let _e50 = row_2;
                let _e53 = factor;
                let _e55 = row_2;
                (*sum).real = (_e46.real + ((_e48.x * _e50.real) - (_e53.y * _e55.imaginary)));
                let _e61 = (*sum);
                let _e63 = factor;
                let _e65 = row_2;
                let _e68 = factor;
                let _e70 = row_2;
                (*sum).imaginary = (_e61.imaginary + ((_e63.x * _e65.imaginary) + (_e68.y * _e70.real)));
                let _e76 = (*sum);
                let _e78 = factor;
                let _e80 = row_2;
                let _e83 = factor;
                let _e85 = row_2;
                (*sum).slope_real = (_e76.slope_real + ((_e78.x * _e80.slope_real) - (_e83.y * _e85.slope_imaginary)));
                let _e91 = (*sum);
                let _e93 = factor;
                let _e95 = row_2;
                let _e98 = factor;
                let _e100 = row_2;
                (*sum).slope_imaginary = (_e91.slope_imaginary + ((_e93.x * _e95.slope_imaginary) + (_e98.y * _e100.slope_real)));
                slope = vec2<f32>(rows.slope_real[k], rows.slope_imaginary[k]);
                let _e112 = (*sum);
                let _e114 = row_2;
                let _e117 = row_2;
                let _e121 = slope;
                let _e122 = gabor_impl_product(vec2<f32>(_e114.real.x, _e117.imaginary.x), _e121);
                (*sum).slope_y = (_e112.slope_y + _e122);
                let _e125 = (*sum);
                let _e127 = slope;
                let _e129 = row_2;
                let _e132 = slope;
                let _e134 = row_2;
                (*sum).mixed_real = (_e125.mixed_real + ((_e127.x * _e129.slope_real) - (_e132.y * _e134.slope_imaginary)));
                let _e140 = (*sum);
                let _e142 = slope;
                let _e144 = row_2;
                let _e147 = slope;
                let _e149 = row_2;
                (*sum).mixed_imaginary = (_e140.mixed_imaginary + ((_e142.x * _e144.slope_imaginary) + (_e147.y * _e149.slope_real)));
                return;
            }
        } else {
            return;
        }
    } else {
        var row_2: GaborSum;
        var factor: vec2<f32>;
        var slope_1: vec2<f32>;

        let _e6 = gabor_impl_no_sum();
        row_2 = _e6;
        gabor_impl_add_node((&row_2), columns, 0i, rows.word[k], animated, time);
        gabor_impl_add_node((&row_2), columns, 1i, rows.word[k], animated, time);
        if true {
            gabor_impl_add_node((&row_2), columns, 2i, rows.word[k], animated, time);
        }
        if false {
            gabor_impl_add_node((&row_2), columns, 3i, rows.word[k], animated, time);
        }
        factor = vec2<f32>(rows.real[k], rows.imaginary[k]);
        let _e40 = factor;
        if (_e40.x > -2f) {
            {
                let _e46 = (*sum);
                let _e48 = factor;
                let _e50 = row_2;
                let _e53 = factor;
                let _e55 = row_2;
                (*sum).real = (_e46.real + ((_e48.x * _e50.real) - (_e53.y * _e55.imaginary)));
                let _e61 = (*sum);
                let _e63 = factor;
                let _e65 = row_2;
                let _e68 = factor;
                let _e70 = row_2;
                (*sum).imaginary = (_e61.imaginary + ((_e63.x * _e65.imaginary) + (_e68.y * _e70.real)));
                let _e76 = (*sum);
                let _e78 = factor;
                let _e80 = row_2;
                let _e83 = factor;
                let _e85 = row_2;
                (*sum).slope_real = (_e76.slope_real + ((_e78.x * _e80.slope_real) - (_e83.y * _e85.slope_imaginary)));
                let _e91 = (*sum);
                let _e93 = factor;
                let _e95 = row_2;
                let _e98 = factor;
                let _e100 = row_2;
                (*sum).slope_imaginary = (_e91.slope_imaginary + ((_e93.x * _e95.slope_imaginary) + (_e98.y * _e100.slope_real)));
                slope_1 = vec2<f32>(rows.slope_real[k], rows.slope_imaginary[k]);
                let _e112 = (*sum);
                let _e114 = row_2;
                let _e117 = row_2;
                let _e121 = slope_1;
                let _e122 = gabor_impl_product(vec2<f32>(_e114.real.x, _e117.imaginary.x), _e121);
                (*sum).slope_y = (_e112.slope_y + _e122);
                let _e125 = (*sum);
                let _e127 = slope_1;
                let _e129 = row_2;
                let _e132 = slope_1;
                let _e134 = row_2;
                (*sum).mixed_real = (_e125.mixed_real + ((_e127.x * _e129.slope_real) - (_e132.y * _e134.slope_imaginary)));
                let _e140 = (*sum);
                let _e142 = slope_1;
                let _e144 = row_2;
                let _e147 = slope_1;
                let _e149 = row_2;
                (*sum).mixed_imaginary = (_e140.mixed_imaginary + ((_e142.x * _e144.slope_imaginary) + (_e147.y * _e149.slope_real)));
                return;
            }
        } else {
            return;
        }
    }
}

// The sum over all nodes.
fn gabor_impl_sum(columns: GaborAxis, rows: GaborAxis, animated: bool, time: f32) -> GaborSum {
    if GABOR_TAPS == 2 {
        var turn: vec2<f32>;
        var sum_1: GaborSum;

        let _e4 = gabor_impl_wave(time);
        turn = _e4;
        let _e6 = gabor_impl_no_sum();
        sum_1 = _e6;
        let _e10 = turn;
        gabor_impl_add_row((&sum_1), columns, rows, 0i, animated, _e10);
        let _e14 = turn;
        gabor_impl_add_row((&sum_1), columns, rows, 1i, animated, _e14);
        if false {
            let _e21 = turn;
            gabor_impl_add_row((&sum_1), columns, rows, 2i, animated, _e21);
        }
        if false {
            let _e28 = turn;
            gabor_impl_add_row((&sum_1), columns, rows, 3i, animated, _e28);
        }
        let _e30 = sum_1;
        return _e30;
    } else if GABOR_TAPS == 4 {
        var turn: vec2<f32>;
        var sum_1: GaborSum;

        let _e4 = gabor_impl_wave(time);
        turn = _e4;
        let _e6 = gabor_impl_no_sum();
        sum_1 = _e6;
        let _e10 = turn;
        gabor_impl_add_row((&sum_1), columns, rows, 0i, animated, _e10);
        let _e14 = turn;
        gabor_impl_add_row((&sum_1), columns, rows, 1i, animated, _e14);
        if true {
            let _e21 = turn;
            gabor_impl_add_row((&sum_1), columns, rows, 2i, animated, _e21);
        }
        if true {
            let _e28 = turn;
            gabor_impl_add_row((&sum_1), columns, rows, 3i, animated, _e28);
        }
        let _e30 = sum_1;
        return _e30;
    } else {
        var turn: vec2<f32>;
        var sum_1: GaborSum;

        let _e4 = gabor_impl_wave(time);
        turn = _e4;
        let _e6 = gabor_impl_no_sum();
        sum_1 = _e6;
        let _e10 = turn;
        gabor_impl_add_row((&sum_1), columns, rows, 0i, animated, _e10);
        let _e14 = turn;
        gabor_impl_add_row((&sum_1), columns, rows, 1i, animated, _e14);
        if true {
            let _e21 = turn;
            gabor_impl_add_row((&sum_1), columns, rows, 2i, animated, _e21);
        }
        if false {
            let _e28 = turn;
            gabor_impl_add_row((&sum_1), columns, rows, 3i, animated, _e28);
        }
        let _e30 = sum_1;
        return _e30;
    }
}

// The noise at a place: what the functions below call.
fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    if GABOR_TAPS == 2 {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var local_2: f32;
        var offset: vec2<f32>;
        var node: vec2<i32>;
        var salt_3: u32;
        var none: GaborWindows = GaborWindows(vec4(0f), vec4(0f));
        var columns_3: GaborAxis;
        var rows_2: GaborAxis;
        var base: vec2<f32>;
        var sum_2: GaborSum;
        var value: vec2<f32>;
        var turned: vec2<f32>;
        var stretch: vec2<f32>;

        kernel_1 = kernel;
        first_1 = (floor((place.local - vec2(1f))) + vec2(1f));
        let _e17 = first_1;
        if true {
            local_2 = 0f;
        } else {
            local_2 = 1f;
        }
        let _e25 = local_2;
        offset = ((place.local - _e17) - vec2(_e25));
        let _e30 = first_1;
        node = (place.cell + vec2<i32>(_e30));
        let _e34 = gabor_impl_salt(seed);
        salt_3 = _e34;
        let _e42 = node;
        let _e46 = salt_3;
        let _e47 = kernel_1;
        let _e49 = offset;
        let _e51 = gabor_impl_windows(_e49.x);
        let _e52 = none;
        let _e53 = gabor_impl_axis(_e42.x, place.period.x, _e46, _e47.step_x, _e51, _e52);
        columns_3 = _e53;
        let _e55 = node;
        let _e59 = salt_3;
        let _e62 = kernel_1;
        let _e64 = offset;
        let _e66 = gabor_impl_windows(_e64.y);
        let _e67 = none;
        let _e68 = gabor_impl_axis(_e55.y, place.period.y, (_e59 ^ 1540483477u), _e62.step_y, _e66, _e67);
        rows_2 = _e68;
        let _e70 = kernel_1;
        let _e72 = offset;
        let _e79 = gabor_impl_wave(dot(_e70.wave, (_e72 * (vec2(1f) / place.radius))));
        base = _e79;
        let _e81 = columns_3;
        let _e82 = rows_2;
        let _e85 = gabor_impl_sum(_e81, _e82, place.animated, place.time);
        sum_2 = _e85;
        let _e87 = base;
        base = (_e87 * 0.00000000000000000000000000068495246f);
        let _e94 = sum_2;
        let _e97 = sum_2;
        let _e101 = base;
        let _e102 = gabor_impl_product(vec2<f32>(_e94.real.x, _e97.imaginary.x), _e101);
        value = _e102;
        let _e105 = value;
        let _e108 = value;
        turned = (6.2831855f * vec2<f32>(-(_e105.y), _e108.x));
        stretch = (place.radius / vec2(1f));
        let _e121 = value;
        let _e122 = stretch;
        let _e124 = sum_2;
        let _e127 = sum_2;
        let _e131 = base;
        let _e132 = gabor_impl_product(vec2<f32>(_e124.slope_real.x, _e127.slope_imaginary.x), _e131);
        let _e134 = kernel_1;
        let _e137 = turned;
        let _e140 = stretch;
        let _e142 = sum_2;
        let _e144 = base;
        let _e145 = gabor_impl_product(_e142.slope_y, _e144);
        let _e147 = kernel_1;
        let _e150 = turned;
        let _e153 = base;
        let _e155 = sum_2;
        let _e158 = base;
        let _e160 = sum_2;
        return GaborField(_e121, ((_e122.x * _e132) + (_e134.wave.x * _e137)), ((_e140.y * _e145) + (_e147.wave.y * _e150)), ((_e153.x * _e155.imaginary) + (_e158.y * _e160.real)));
    } else if GABOR_TAPS == 4 {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var local_2: f32;
        var offset: vec2<f32>;
        var node: vec2<i32>;
        var salt_3: u32;
        var none: GaborWindows = GaborWindows(vec4(0f), vec4(0f));
        var columns_3: GaborAxis;
        var rows_2: GaborAxis;
        var base: vec2<f32>;
        var sum_2: GaborSum;
        var value: vec2<f32>;
        var turned: vec2<f32>;
        var stretch: vec2<f32>;

        kernel_1 = kernel;
        first_1 = (floor((place.local - vec2(2f))) + vec2(1f));
        let _e17 = first_1;
        if false {
            local_2 = 0f;
        } else {
            local_2 = 1f;
        }
        let _e25 = local_2;
        offset = ((place.local - _e17) - vec2(_e25));
        let _e30 = first_1;
        node = (place.cell + vec2<i32>(_e30));
        let _e34 = gabor_impl_salt(seed);
        salt_3 = _e34;
        let _e42 = node;
        let _e46 = salt_3;
        let _e47 = kernel_1;
        let _e49 = offset;
        let _e51 = gabor_impl_windows(_e49.x);
        let _e52 = none;
        let _e53 = gabor_impl_axis(_e42.x, place.period.x, _e46, _e47.step_x, _e51, _e52);
        columns_3 = _e53;
        let _e55 = node;
        let _e59 = salt_3;
        let _e62 = kernel_1;
        let _e64 = offset;
        let _e66 = gabor_impl_windows(_e64.y);
        let _e67 = none;
        let _e68 = gabor_impl_axis(_e55.y, place.period.y, (_e59 ^ 1540483477u), _e62.step_y, _e66, _e67);
        rows_2 = _e68;
        let _e70 = kernel_1;
        let _e72 = offset;
        let _e79 = gabor_impl_wave(dot(_e70.wave, (_e72 * (vec2(1f) / place.radius))));
        base = _e79;
        let _e81 = columns_3;
        let _e82 = rows_2;
        let _e85 = gabor_impl_sum(_e81, _e82, place.animated, place.time);
        sum_2 = _e85;
        let _e87 = base;
        base = (_e87 * 0.000000000000000000000000000456635f);
        let _e94 = sum_2;
        let _e97 = sum_2;
        let _e101 = base;
        let _e102 = gabor_impl_product(vec2<f32>(_e94.real.x, _e97.imaginary.x), _e101);
        value = _e102;
        let _e105 = value;
        let _e108 = value;
        turned = (6.2831855f * vec2<f32>(-(_e105.y), _e108.x));
        stretch = (place.radius / vec2(2f));
        let _e121 = value;
        let _e122 = stretch;
        let _e124 = sum_2;
        let _e127 = sum_2;
        let _e131 = base;
        let _e132 = gabor_impl_product(vec2<f32>(_e124.slope_real.x, _e127.slope_imaginary.x), _e131);
        let _e134 = kernel_1;
        let _e137 = turned;
        let _e140 = stretch;
        let _e142 = sum_2;
        let _e144 = base;
        let _e145 = gabor_impl_product(_e142.slope_y, _e144);
        let _e147 = kernel_1;
        let _e150 = turned;
        let _e153 = base;
        let _e155 = sum_2;
        let _e158 = base;
        let _e160 = sum_2;
        return GaborField(_e121, ((_e122.x * _e132) + (_e134.wave.x * _e137)), ((_e140.y * _e145) + (_e147.wave.y * _e150)), ((_e153.x * _e155.imaginary) + (_e158.y * _e160.real)));
    } else {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var local_2: f32;
        var offset: vec2<f32>;
        var node: vec2<i32>;
        var salt_3: u32;
        var none: GaborWindows = GaborWindows(vec4(0f), vec4(0f));
        var columns_3: GaborAxis;
        var rows_2: GaborAxis;
        var base: vec2<f32>;
        var sum_2: GaborSum;
        var value: vec2<f32>;
        var turned: vec2<f32>;
        var stretch: vec2<f32>;

        kernel_1 = kernel;
        first_1 = (floor((place.local - vec2(1.5f))) + vec2(1f));
        let _e17 = first_1;
        if false {
            local_2 = 0f;
        } else {
            local_2 = 1f;
        }
        let _e25 = local_2;
        offset = ((place.local - _e17) - vec2(_e25));
        let _e30 = first_1;
        node = (place.cell + vec2<i32>(_e30));
        let _e34 = gabor_impl_salt(seed);
        salt_3 = _e34;
        let _e42 = node;
        let _e46 = salt_3;
        let _e47 = kernel_1;
        let _e49 = offset;
        let _e51 = gabor_impl_windows(_e49.x);
        let _e52 = none;
        let _e53 = gabor_impl_axis(_e42.x, place.period.x, _e46, _e47.step_x, _e51, _e52);
        columns_3 = _e53;
        let _e55 = node;
        let _e59 = salt_3;
        let _e62 = kernel_1;
        let _e64 = offset;
        let _e66 = gabor_impl_windows(_e64.y);
        let _e67 = none;
        let _e68 = gabor_impl_axis(_e55.y, place.period.y, (_e59 ^ 1540483477u), _e62.step_y, _e66, _e67);
        rows_2 = _e68;
        let _e70 = kernel_1;
        let _e72 = offset;
        let _e79 = gabor_impl_wave(dot(_e70.wave, (_e72 * (vec2(1f) / place.radius))));
        base = _e79;
        let _e81 = columns_3;
        let _e82 = rows_2;
        let _e85 = gabor_impl_sum(_e81, _e82, place.animated, place.time);
        sum_2 = _e85;
        let _e87 = base;
        base = (_e87 * 0.00000000000000000000000000060884664f);
        let _e94 = sum_2;
        let _e97 = sum_2;
        let _e101 = base;
        let _e102 = gabor_impl_product(vec2<f32>(_e94.real.x, _e97.imaginary.x), _e101);
        value = _e102;
        let _e105 = value;
        let _e108 = value;
        turned = (6.2831855f * vec2<f32>(-(_e105.y), _e108.x));
        stretch = (place.radius / vec2(1.5f));
        let _e121 = value;
        let _e122 = stretch;
        let _e124 = sum_2;
        let _e127 = sum_2;
        let _e131 = base;
        let _e132 = gabor_impl_product(vec2<f32>(_e124.slope_real.x, _e127.slope_imaginary.x), _e131);
        let _e134 = kernel_1;
        let _e137 = turned;
        let _e140 = stretch;
        let _e142 = sum_2;
        let _e144 = base;
        let _e145 = gabor_impl_product(_e142.slope_y, _e144);
        let _e147 = kernel_1;
        let _e150 = turned;
        let _e153 = base;
        let _e155 = sum_2;
        let _e158 = base;
        let _e160 = sum_2;
        return GaborField(_e121, ((_e122.x * _e132) + (_e134.wave.x * _e137)), ((_e140.y * _e145) + (_e147.wave.y * _e150)), ((_e153.x * _e155.imaginary) + (_e158.y * _e160.real)));
    }
}

// (cell + local) / GABOR_RADIUS kernel radii, without periods, precise everywhere in a world of 2^32 cells each way.
fn gabor_place(cell: vec2<i32>, local: vec2<f32>) -> GaborPlace {
    if GABOR_TAPS == 2 {
        return GaborPlace(cell, local, vec2(1f), vec2(0i), false, 0f);
    } else if GABOR_TAPS == 4 {
        return GaborPlace(cell, local, vec2(2f), vec2(0i), false, 0f);
    } else {
        return GaborPlace(cell, local, vec2(1.5f), vec2(0i), false, 0f);
    }
}

// p in a world that repeats after `period` kernel radii along each axis where that is positive, and is endless where it
// is 0: a whole number of nodes fits in a period, GABOR_TAPS at least.
fn gabor_place_tiled(p: vec2<f32>, period: vec2<f32>) -> GaborPlace {
    if GABOR_TAPS == 2 {
        var nodes: vec2<f32>;
        var place_1: GaborPlace;

        nodes = max(floor(((period * 1f) + vec2(0.5f))), vec2(2f));
        let _e20 = gabor_place(vec2(0i), vec2(0f));
        place_1 = _e20;
        if (period.x > 0f) {
            {
                let _e27 = nodes;
                place_1.period.x = i32(_e27.x);
                let _e32 = nodes;
                place_1.radius.x = (_e32.x / period.x);
            }
        }
        if (period.y > 0f) {
            {
                let _e41 = nodes;
                place_1.period.y = i32(_e41.y);
                let _e46 = nodes;
                place_1.radius.y = (_e46.y / period.y);
            }
        }
        let _e51 = place_1;
        place_1.local = (p * _e51.radius);
        let _e54 = place_1;
        return _e54;
    } else if GABOR_TAPS == 4 {
        var nodes: vec2<f32>;
        var place_1: GaborPlace;

        nodes = max(floor(((period * 2f) + vec2(0.5f))), vec2(4f));
        let _e20 = gabor_place(vec2(0i), vec2(0f));
        place_1 = _e20;
        if (period.x > 0f) {
            {
                let _e27 = nodes;
                place_1.period.x = i32(_e27.x);
                let _e32 = nodes;
                place_1.radius.x = (_e32.x / period.x);
            }
        }
        if (period.y > 0f) {
            {
                let _e41 = nodes;
                place_1.period.y = i32(_e41.y);
                let _e46 = nodes;
                place_1.radius.y = (_e46.y / period.y);
            }
        }
        let _e51 = place_1;
        place_1.local = (p * _e51.radius);
        let _e54 = place_1;
        return _e54;
    } else {
        var nodes: vec2<f32>;
        var place_1: GaborPlace;

        nodes = max(floor(((period * 1.5f) + vec2(0.5f))), vec2(3f));
        let _e20 = gabor_place(vec2(0i), vec2(0f));
        place_1 = _e20;
        if (period.x > 0f) {
            {
                let _e27 = nodes;
                place_1.period.x = i32(_e27.x);
                let _e32 = nodes;
                place_1.radius.x = (_e32.x / period.x);
            }
        }
        if (period.y > 0f) {
            {
                let _e41 = nodes;
                place_1.period.y = i32(_e41.y);
                let _e46 = nodes;
                place_1.radius.y = (_e46.y / period.y);
            }
        }
        let _e51 = place_1;
        place_1.local = (p * _e51.radius);
        let _e54 = place_1;
        return _e54;
    }
}

// A kernel's wave where there are other than GABOR_RADIUS nodes per kernel radius, to fit a period.
fn gabor_kernel_stretched(kernel: GaborKernel, radius: vec2<f32>) -> GaborKernel {
    var kernel_3: GaborKernel;
    var step_1: vec2<f32>;

    kernel_3 = kernel;
    let _e3 = kernel_3;
    step_1 = (_e3.wave / radius);
    let _e7 = kernel_3;
    let _e9 = step_1;
    let _e11 = gabor_impl_wave(_e9.x);
    let _e12 = step_1;
    let _e14 = gabor_impl_wave(_e12.y);
    return GaborKernel(_e7.wave, _e11, _e14);
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise.
fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel {
    if GABOR_TAPS == 2 {
        var wave: vec2<f32>;

        let _e7 = gabor_impl_wave((0.15915494f * orientation));
        wave = (min(abs(frequency), 1000000f) * _e7);
        let _e10 = wave;
        let _e21 = gabor_kernel_stretched(GaborKernel(_e10, vec2(0f), vec2(0f)), vec2(1f));
        return _e21;
    } else if GABOR_TAPS == 4 {
        var wave: vec2<f32>;

        let _e7 = gabor_impl_wave((0.15915494f * orientation));
        wave = (min(abs(frequency), 1000000f) * _e7);
        let _e10 = wave;
        let _e21 = gabor_kernel_stretched(GaborKernel(_e10, vec2(0f), vec2(0f)), vec2(2f));
        return _e21;
    } else {
        var wave: vec2<f32>;

        let _e7 = gabor_impl_wave((0.15915494f * orientation));
        wave = (min(abs(frequency), 1000000f) * _e7);
        let _e10 = wave;
        let _e21 = gabor_kernel_stretched(GaborKernel(_e10, vec2(0f), vec2(0f)), vec2(1.5f));
        return _e21;
    }
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere.
fn gabor_noise_at(cell: vec2<i32>, local: vec2<f32>, kernel: GaborKernel, seed: u32) -> f32 {
    var kernel_5: GaborKernel;

    kernel_5 = kernel;
    let _e5 = gabor_place(cell, local);
    let _e6 = kernel_5;
    let _e7 = gabor_field(_e5, _e6, seed);
    return _e7.value.y;
}

// Gabor noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p            position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float
//                steps by 0.008.
//   frequency    cycles per kernel radius; its magnitude is used, up to 10^6
//   orientation  direction of the wave vector in radians from +x towards +y, precise within +-400
//   seed         any; each seed is another instance, independent of the others
// Frequency and orientation may vary from place to place: where they are continuous so is the noise, for each wave
// turns about its own node. A slope of theirs adds to that of the noise.
fn gabor_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    if GABOR_TAPS == 2 {
        let _e11 = gabor_kernel(frequency, orientation);
        let _e12 = gabor_noise_at(vec2(0i), (p * 1f), _e11, seed);
        return _e12;
    } else if GABOR_TAPS == 4 {
        let _e11 = gabor_kernel(frequency, orientation);
        let _e12 = gabor_noise_at(vec2(0i), (p * 2f), _e11, seed);
        return _e12;
    } else {
        let _e11 = gabor_kernel(frequency, orientation);
        let _e12 = gabor_noise_at(vec2(0i), (p * 1.5f), _e11, seed);
        return _e12;
    }
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy), derivatives per kernel radius, continuous everywhere.
// Second derivatives jump on the lines where windows end, midway between nodes for 3 taps and at nodes for 4: by 0.16
// of their deviation at frequency 1, by 1.1 of it at 0.
fn gabor_noise_gradient(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    if GABOR_TAPS == 2 {
        var field: GaborField;

        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        field = _e13;
        let _e15 = field;
        let _e18 = field;
        let _e21 = field;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    } else if GABOR_TAPS == 4 {
        var field: GaborField;

        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        field = _e13;
        let _e15 = field;
        let _e18 = field;
        let _e21 = field;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    } else {
        var field: GaborField;

        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        field = _e13;
        let _e15 = field;
        let _e18 = field;
        let _e21 = field;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    }
}

// The noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has sines. Both
// have mean 0 and variance 1, and at one place are independent.
fn gabor_noise_complex(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    if GABOR_TAPS == 2 {
        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        return _e13.value;
    } else if GABOR_TAPS == 4 {
        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        return _e13.value;
    } else {
        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        return _e13.value;
    }
}

// Four noises at p, independent of each other, for colours or displacement along vectors; the first is gabor_noise.
fn gabor_noise_four(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec4<f32> {
    if GABOR_TAPS == 2 {
        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        return _e13.four;
    } else if GABOR_TAPS == 4 {
        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        return _e13.four;
    } else {
        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        return _e13.four;
    }
}

// Phase, in turns within [0, 1), and intensity of a complex value [Tricard et al., "Procedural phasor noise", 2019]:
// any profile of the phase is a pattern of even contrast, such as sin(6.2831853 * phase), 2 phase - 1, or a pulse
// step(phase, width). The phase of 0 is 0.
fn gabor_phasor(value: vec2<f32>) -> vec2<f32> {
    var intensity: f32;
    var local_5: f32;
    var phase: f32;
    var local_6: f32;

    intensity = length(value);
    let _e3 = intensity;
    if (_e3 > 0f) {
        local_5 = (atan2(value.y, value.x) * 0.15915494f);
    } else {
        local_5 = 0f;
    }
    let _e13 = local_5;
    phase = _e13;
    let _e15 = phase;
    if (_e15 < 0f) {
        let _e18 = phase;
        local_6 = min((_e18 + 1f), 0.99999994f);
    } else {
        let _e23 = phase;
        local_6 = _e23;
    }
    let _e25 = local_6;
    let _e26 = intensity;
    return vec2<f32>(_e25, _e26);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation,
// with the law of gabor_noise: windows become a little wider or narrower, so that a whole number of nodes fits.
// Each period is at least 1/1024; from 2 up windows change by a sixth at most, shorter ones make them as narrow.
fn gabor_noise_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place_2: GaborPlace;
    var kernel_6: GaborKernel;

    let _e8 = gabor_place_tiled(p, max(period, vec2(0.0009765625f)));
    place_2 = _e8;
    let _e10 = gabor_kernel(frequency, orientation);
    let _e11 = place_2;
    let _e13 = gabor_kernel_stretched(_e10, _e11.radius);
    kernel_6 = _e13;
    let _e15 = place_2;
    let _e16 = kernel_6;
    let _e17 = gabor_field(_e15, _e16, seed);
    return _e17.value.y;
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1; at time 0 it is
// gabor_noise. At every time it has the law of gabor_noise, and at all times and places together; its correlation with
// itself falls with the time between as cos^2(pi time): 1/2 after a quarter of the period, 0 after half of it.
fn gabor_noise_animated(p: vec2<f32>, time: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    if GABOR_TAPS == 2 {
        var place_3: GaborPlace;

        place_3 = GaborPlace(vec2(0i), (p * 1f), vec2(1f), vec2(0i), true, time);
        let _e22 = place_3;
        let _e23 = gabor_kernel(frequency, orientation);
        let _e24 = gabor_field(_e22, _e23, seed);
        return _e24.value.y;
    } else if GABOR_TAPS == 4 {
        var place_3: GaborPlace;

        place_3 = GaborPlace(vec2(0i), (p * 2f), vec2(2f), vec2(0i), true, time);
        let _e22 = place_3;
        let _e23 = gabor_kernel(frequency, orientation);
        let _e24 = gabor_field(_e22, _e23, seed);
        return _e24.value.y;
    } else {
        var place_3: GaborPlace;

        place_3 = GaborPlace(vec2(0i), (p * 1.5f), vec2(1.5f), vec2(0i), true, time);
        let _e22 = place_3;
        let _e23 = gabor_kernel(frequency, orientation);
        let _e24 = gabor_field(_e22, _e23, seed);
        return _e24.value.y;
    }
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
fn gabor_unorm(noise: f32) -> f32 {
    return clamp((0.5f + (0.25f * noise)), 0f, 1f);
}
