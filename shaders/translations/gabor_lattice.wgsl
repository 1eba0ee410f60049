// gabor_lattice.wgsl: exactly normalized Gabor noise in two dimensions, from random amplitudes on a lattice: for WGSL.
//
// Made from shaders/gabor_lattice.glsl by tools/translate and naga 30.0.1: change that file, not this one.
//
//     float n = gabor_noise(p, 4.0, 0.7854, 7u);   // mean 0, variance 1
//     float v = gabor_unorm(n);                    // in [0, 1], to show
//
// Functions to call, at the end of the file:
//     gabor_noise, gabor_unorm                 the noise, and to show it
//     gabor_noise_gradient                     with its analytic gradient, for bump and normal mapping
//     gabor_noise_complex, gabor_phasor        with its quadrature: phase and intensity
//     gabor_noise_four                         four independent ones at once
//     gabor_noise_tiled, gabor_noise_animated  with exact periods in space, and in time
//     gabor_noise_at, gabor_kernel             by integer cell and local offset, for large worlds
//
// The noise. The nodes c_ij of a square lattice, R to the unit of length, have random complex amplitudes A_ij,
// independent and normal, and each sends out a wave under a window that ends one unit from it along x and y:
//
//     n(p) = K Im sum_ij A_ij h(x - x_i) h(y - y_j) exp(2 pi i F.(p - c_ij)),   F = frequency (cos o, sin o)
//
// The unit of length is the kernel radius, where the window h ends. It is Hann's, h(x) = (1 + cos pi x) / 2. GABOR_TAPS
// nodes along each axis reach a point, R = GABOR_TAPS / 2, and as three or more evenly spaced shifts of cos and of
// cos^2 over their period sum to a constant,
//
//     sum_i h(x - x_i)^2 = 3/8 GABOR_TAPS   at every x,
//
// and likewise for the squares of the derivatives: the variances of the noise, of its gradient and of its second
// derivatives are the same at every place, at every frequency. The sum is normal where the amplitudes are. Each wave's
// phase counts from its own node, so frequency and orientation may vary from place to place. After Tavernier, Neyret,
// Vergne and Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019, whose last section asks for it.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// 3 or 2 or 4: change it here, or give it to the pipeline as a constant.
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

// The salt of an axis: x is 0, y is 1, z is 2. With one salt for all, nodes on the diagonal would have the same word.
fn gabor_impl_salt(seed: u32, axis: u32) -> u32 {
    let _e6 = gabor_impl_mix(((seed * 2654435761u) + axis), 625341585u);
    return _e6;
}

// The word of a column (axis 0) or a row (axis 1) of nodes.
fn gabor_impl_line_word(index: i32, salt: u32) -> u32 {
    let _e6 = gabor_impl_mix(((u32(index) * 2654435761u) + salt), salt);
    return _e6;
}

// The word of a node, from the xor of those of its column and its row. The 16 high bits are well mixed.
fn gabor_impl_node_word(lines: u32) -> u32 {
    return (lines * 2246822507u);
}

// Another word of the same node.
fn gabor_impl_next_word(word: u32) -> u32 {
    return ((word ^ (word >> 15u)) * 3545902487u);
}

fn gabor_impl_amplitude(word: u32) -> vec2<f32> {
    var u: vec2<f32>;
    var t: vec2<f32>;

    u = (vec2<f32>(f32((i32(word) >> 24u)), f32((i32((word << 8u)) >> 24u))) + vec2(0.5f));
    let _e18 = u;
    let _e19 = u;
    t = ((_e18 * _e19) - vec2(5713.298f));
    let _e25 = u;
    let _e26 = t;
    let _e27 = t;
    return (_e25 * ((_e26 * _e27) + vec2(118666190f)));
}

// (cos, sin) of 2 pi t for any t, within 2e-7: reduced to half a turn, then minimax polynomials that share the zeros.
fn gabor_impl_wave(t: f32) -> vec2<f32> {
    var t_2: f32;
    var s: f32;
    var cosine: f32;
    var sine: f32;

    t_2 = t;
    let _e2 = t_2;
    let _e3 = t_2;
    t_2 = (_e2 - floor((_e3 + 0.5f)));
    let _e8 = t_2;
    let _e9 = t_2;
    s = (_e8 * _e9);
    let _e13 = s;
    cosine = ((6.54002f * _e13) - 25.567099f);
    let _e18 = cosine;
    let _e19 = s;
    cosine = ((_e18 * _e19) + 58.571857f);
    let _e23 = cosine;
    let _e24 = s;
    cosine = ((_e23 * _e24) - 81.78964f);
    let _e28 = cosine;
    let _e29 = s;
    cosine = ((_e28 * _e29) + 59.827274f);
    let _e33 = cosine;
    let _e34 = s;
    cosine = ((_e33 * _e34) - 16f);
    let _e40 = s;
    sine = (38.123196f - (12.233302f * _e40));
    let _e44 = sine;
    let _e45 = s;
    sine = ((_e44 * _e45) - 67.0439f);
    let _e49 = sine;
    let _e50 = s;
    sine = ((_e49 * _e50) + 64.83468f);
    let _e54 = sine;
    let _e55 = s;
    sine = ((_e54 * _e55) - 25.13273f);
    let _e59 = s;
    let _e62 = cosine;
    let _e64 = t_2;
    let _e65 = s;
    let _e69 = sine;
    return vec2<f32>(((_e59 - 0.0625f) * _e62), ((_e64 * (_e65 - 0.25f)) * _e69));
}

// The unit vector at an angle in radians: reduced by pi/2 in three steps, then minimax polynomials. Its error stays
// near 1e-7, for a large frequency multiplies it.
fn gabor_impl_direction(angle: f32) -> vec2<f32> {
    var quarter: f32;
    var r: f32;
    var local: f32;
    var s_1: f32;
    var sine_1: f32;
    var cosine_1: f32;
    var local_1: vec2<f32>;
    var axis_1: vec2<f32>;
    var local_2: vec2<f32>;

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
        local = _e26;
    } else {
        local = 0f;
    }
    let _e29 = local;
    r = _e29;
    let _e30 = r;
    let _e31 = r;
    s_1 = (_e30 * _e31);
    let _e34 = r;
    let _e35 = r;
    let _e36 = s_1;
    let _e40 = s_1;
    let _e42 = s_1;
    sine_1 = (_e34 + ((_e35 * _e36) * (-0.16666654f + (_e40 * (0.008332161f - (_e42 * 0.00019515296f))))));
    let _e53 = s_1;
    let _e56 = s_1;
    let _e57 = s_1;
    let _e60 = s_1;
    let _e63 = s_1;
    cosine_1 = ((1f - (0.5f * _e53)) + ((_e56 * _e57) * (0.041666646f + (_e60 * (-0.0013887316f + (_e63 * 0.000024433157f))))));
    let _e73 = quarter;
    if (fract((0.5f * _e73)) < 0.25f) {
        let _e78 = cosine_1;
        let _e79 = sine_1;
        local_1 = vec2<f32>(_e78, _e79);
    } else {
        let _e81 = sine_1;
        let _e83 = cosine_1;
        local_1 = vec2<f32>(-(_e81), _e83);
    }
    let _e86 = local_1;
    axis_1 = _e86;
    let _e89 = quarter;
    if (fract((0.25f * _e89)) < 0.375f) {
        let _e94 = axis_1;
        local_2 = _e94;
    } else {
        let _e95 = axis_1;
        local_2 = -(_e95);
    }
    let _e98 = local_2;
    return _e98;
}

// Product of complex numbers.
fn gabor_impl_product(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(((a.x * b.x) - (a.y * b.y)), ((a.x * b.y) + (a.y * b.x)));
}

// The windows of one axis' GABOR_TAPS nodes, and their derivatives per kernel radius where nodes are 1/R apart.
struct GaborWindows {
    value: vec4<f32>,
    slope: vec4<f32>,
}

// Two shifts of Hann's window do not sum to a constant. Vorbis' window sin(pi/2 cos^2(pi x / 2)) does, for its two
// shifts are the sine and the cosine of one angle [Princen and Bradley 1986]; the derivatives' variances do vary.
//   x   offset from the first node, in [0, 1) node spacings
fn gabor_impl_windows(x: f32) -> GaborWindows {
    if GABOR_TAPS == 2 {
        var half_turn: vec2<f32>;
        var window: vec2<f32>;
        var slope: f32;

        let _e3 = gabor_impl_wave((0.5f * x));
        half_turn = _e3;
        let _e7 = half_turn;
        let _e11 = gabor_impl_wave((0.125f + (0.125f * _e7.x)));
        window = _e11;
        let _e14 = half_turn;
        slope = (2.467401f * _e14.y);
        let _e18 = window;
        let _e19 = _e18.yx;
        let _e25 = slope;
        let _e27 = window;
        let _e30 = slope;
        let _e31 = window;
        return GaborWindows(vec4<f32>(_e19.x, _e19.y, 0f, 0f), vec4<f32>((-(_e25) * _e27.x), (_e30 * _e31.y), 0f, 0f));
    } else if GABOR_TAPS == 4 {
        var x_1: f32;
        var s_2: f32;
        var cosine_2: f32;
        var sine_2: f32;
        var c: vec2<f32>;

        x_1 = x;
        let _e2 = x_1;
        x_1 = (_e2 - 1.5f);
        let _e5 = x_1;
        let _e6 = x_1;
        s_2 = (_e5 * _e6);
        let _e10 = s_2;
        let _e13 = s_2;
        let _e15 = s_2;
        let _e18 = s_2;
        cosine_2 = (1f + (_e10 * (-1.2337005f + (_e13 * (0.25366923f + (_e15 * (-0.020860288f + (_e18 * 0.00090402167f))))))));
        let _e29 = x_1;
        let _e31 = s_2;
        let _e34 = s_2;
        let _e36 = s_2;
        sine_2 = (_e29 * (1.5707963f + (_e31 * (-0.64596295f + (_e34 * (0.0796759f - (_e36 * 0.00459229f)))))));
        let _e47 = cosine_2;
        let _e48 = sine_2;
        let _e50 = cosine_2;
        let _e51 = sine_2;
        c = (0.35355338f * vec2<f32>((_e47 - _e48), (_e50 + _e51)));
        let _e57 = c;
        let _e60 = c;
        let _e62 = c;
        let _e64 = c;
        let _e71 = c;
        let _e74 = c;
        let _e77 = c;
        let _e79 = c;
        return GaborWindows((vec4(0.5f) + vec4<f32>(-(_e57.y), _e60.x, _e62.y, -(_e64.x))), (3.1415927f * vec4<f32>(-(_e71.x), -(_e74.y), _e77.x, _e79.y)));
    } else {
        var x_1: f32;
        var s_2: f32;
        var cosine_2: f32;
        var sine_2: f32;
        var c: vec3<f32>;
        var d: vec3<f32>;

        x_1 = x;
        let _e2 = x_1;
        x_1 = (_e2 - 1f);
        let _e5 = x_1;
        let _e6 = x_1;
        s_2 = (_e5 * _e6);
        let _e10 = s_2;
        let _e13 = s_2;
        let _e15 = s_2;
        let _e18 = s_2;
        cosine_2 = (1f + (_e10 * (-2.1932454f + (_e13 * (0.80171627f + (_e15 * (-0.11716848f + (_e18 * 0.00891324f))))))));
        let _e29 = x_1;
        let _e31 = s_2;
        let _e34 = s_2;
        let _e36 = s_2;
        sine_2 = (_e29 * (2.0943947f + (_e31 * (-1.5311589f + (_e34 * (0.3356034f - (_e36 * 0.03389007f)))))));
        let _e48 = cosine_2;
        let _e51 = sine_2;
        let _e54 = cosine_2;
        let _e57 = cosine_2;
        let _e60 = sine_2;
        c = vec3<f32>(((-0.5f * _e48) - (0.8660254f * _e51)), _e54, ((-0.5f * _e57) + (0.8660254f * _e60)));
        let _e67 = sine_2;
        let _e70 = cosine_2;
        let _e73 = sine_2;
        let _e76 = sine_2;
        let _e79 = cosine_2;
        d = vec3<f32>(((-0.5f * _e67) + (0.8660254f * _e70)), _e73, ((-0.5f * _e76) - (0.8660254f * _e79)));
        let _e86 = c;
        let _e89 = (vec3(0.5f) + (0.5f * _e86));
        let _e97 = d;
        let _e98 = (-1.5707963f * _e97);
        return GaborWindows(vec4<f32>(_e89.x, _e89.y, _e89.z, 0f), vec4<f32>(_e98.x, _e98.y, _e98.z, 0f));
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
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
struct GaborField {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
    four: vec4<f32>,
}

// The nodes of one axis that reach a point: their words, and the factors that their amplitudes meet along it, h e and
// h' e with e = exp(2 pi i F (x - x_i)) but for what is common to all.
struct GaborAxis {
    word: vec4<u32>,
    real: vec4<f32>,
    imaginary: vec4<f32>,
    slope_real: vec4<f32>,
    slope_imaginary: vec4<f32>,
}

// An index within a period.
fn gabor_impl_wrap(index: i32, period: i32) -> i32 {
    var within: i32;
    var local_3: i32;

    if (period == 0i) {
        return index;
    }
    within = (index - ((index / period) * period));
    let _e8 = within;
    if (_e8 < 0i) {
        let _e11 = within;
        local_3 = (_e11 + period);
    } else {
        let _e13 = within;
        local_3 = _e13;
    }
    let _e15 = local_3;
    return _e15;
}

//   first   index of the first node
//   x       offset from it, in node spacings
//   period  in nodes, 0 for none
//   step    e^(2 pi i F / R): what the wave turns from one node to the next
// The wave is taken relative to the second node, of the first for two taps.
fn gabor_impl_axis(first: i32, x: f32, period: i32, salt: u32, step: vec2<f32>) -> GaborAxis {
    if GABOR_TAPS == 2 {
        var axis_2: GaborAxis;
        var cosine_2: vec4<f32>;
        var sine_2: vec4<f32>;
        var window_1: GaborWindows;

        let _e7 = gabor_impl_wrap(first, period);
        let _e8 = gabor_impl_line_word(_e7, salt);
        let _e11 = gabor_impl_wrap((first + 1i), period);
        let _e12 = gabor_impl_line_word(_e11, salt);
        let _e15 = gabor_impl_wrap((first + 2i), period);
        let _e16 = gabor_impl_line_word(_e15, salt);
        let _e19 = gabor_impl_wrap((first + 3i), period);
        let _e20 = gabor_impl_line_word(_e19, salt);
        axis_2.word = vec4<u32>(_e8, _e12, _e16, _e20);
        cosine_2 = vec4<f32>(1f, step.x, 0f, 0f);
        sine_2 = vec4<f32>(0f, -(step.y), 0f, 0f);
        let _e35 = gabor_impl_windows(x);
        window_1 = _e35;
        let _e38 = window_1;
        let _e40 = cosine_2;
        axis_2.real = (_e38.value * _e40);
        let _e43 = window_1;
        let _e45 = sine_2;
        axis_2.imaginary = (_e43.value * _e45);
        let _e48 = window_1;
        let _e50 = cosine_2;
        axis_2.slope_real = (_e48.slope * _e50);
        let _e53 = window_1;
        let _e55 = sine_2;
        axis_2.slope_imaginary = (_e53.slope * _e55);
        let _e57 = axis_2;
        return _e57;
    } else if GABOR_TAPS == 4 {
        var axis_2: GaborAxis;
        var two: vec2<f32>;
        var cosine_3: vec4<f32>;
        var sine_3: vec4<f32>;
        var window: GaborWindows;

        let _e7 = gabor_impl_wrap(first, period);
        let _e8 = gabor_impl_line_word(_e7, salt);
        let _e11 = gabor_impl_wrap((first + 1i), period);
        let _e12 = gabor_impl_line_word(_e11, salt);
        let _e15 = gabor_impl_wrap((first + 2i), period);
        let _e16 = gabor_impl_line_word(_e15, salt);
        let _e19 = gabor_impl_wrap((first + 3i), period);
        let _e20 = gabor_impl_line_word(_e19, salt);
        axis_2.word = vec4<u32>(_e8, _e12, _e16, _e20);
        let _e22 = gabor_impl_product(step, step);
        two = _e22;
        let _e27 = two;
        cosine_3 = vec4<f32>(step.x, 1f, step.x, _e27.x);
        let _e35 = two;
        sine_3 = vec4<f32>(step.y, 0f, -(step.y), -(_e35.y));
        let _e40 = gabor_impl_windows(x);
        window = _e40;
        let _e43 = window;
        let _e45 = cosine_3;
        axis_2.real = (_e43.value * _e45);
        let _e48 = window;
        let _e50 = sine_3;
        axis_2.imaginary = (_e48.value * _e50);
        let _e53 = window;
        let _e55 = cosine_3;
        axis_2.slope_real = (_e53.slope * _e55);
        let _e58 = window;
        let _e60 = sine_3;
        axis_2.slope_imaginary = (_e58.slope * _e60);
        let _e62 = axis_2;
        return _e62;
    } else {
        var axis_2: GaborAxis;
        var two: vec2<f32>;
        var cosine_3: vec4<f32>;
        var sine_3: vec4<f32>;
        var window: GaborWindows;

        let _e7 = gabor_impl_wrap(first, period);
        let _e8 = gabor_impl_line_word(_e7, salt);
        let _e11 = gabor_impl_wrap((first + 1i), period);
        let _e12 = gabor_impl_line_word(_e11, salt);
        let _e15 = gabor_impl_wrap((first + 2i), period);
        let _e16 = gabor_impl_line_word(_e15, salt);
        let _e19 = gabor_impl_wrap((first + 3i), period);
        let _e20 = gabor_impl_line_word(_e19, salt);
        axis_2.word = vec4<u32>(_e8, _e12, _e16, _e20);
        let _e22 = gabor_impl_product(step, step);
        two = _e22;
        let _e27 = two;
        cosine_3 = vec4<f32>(step.x, 1f, step.x, _e27.x);
        let _e35 = two;
        sine_3 = vec4<f32>(step.y, 0f, -(step.y), -(_e35.y));
        let _e40 = gabor_impl_windows(x);
        window = _e40;
        let _e43 = window;
        let _e45 = cosine_3;
        axis_2.real = (_e43.value * _e45);
        let _e48 = window;
        let _e50 = sine_3;
        axis_2.imaginary = (_e48.value * _e50);
        let _e53 = window;
        let _e55 = cosine_3;
        axis_2.slope_real = (_e53.slope * _e55);
        let _e58 = window;
        let _e60 = sine_3;
        axis_2.slope_imaginary = (_e58.slope * _e60);
        let _e62 = axis_2;
        return _e62;
    }
}

// The amplitude of a node at a time, whose cosine and sine are given: (A0 + A1 cos + A2 sin) / sqrt(2), normal at every
// time; the correlation of two times is cos^2(pi lag).
fn gabor_impl_amplitude_at(word: u32, time: vec2<f32>) -> vec2<f32> {
    var second: u32;
    var moving: vec2<f32>;

    let _e2 = gabor_impl_next_word(word);
    second = _e2;
    let _e5 = second;
    let _e6 = gabor_impl_amplitude(_e5);
    let _e9 = second;
    let _e10 = gabor_impl_next_word(_e9);
    let _e11 = gabor_impl_amplitude(_e10);
    moving = ((time.x * _e6) + (time.y * _e11));
    let _e16 = gabor_impl_amplitude(word);
    let _e17 = moving;
    return (0.70710677f * (_e16 + _e17));
}

// Sums over the nodes of one row: what it gives to the field and, with the windows' derivatives, to its slope along x.
struct GaborRow {
    value: vec2<f32>,
    slope: vec2<f32>,
    four_real: vec4<f32>,
    four_imaginary: vec4<f32>,
}

fn gabor_impl_add_node(row: ptr<function, GaborRow>, word: u32, factor: vec2<f32>, slope: vec2<f32>, animated: bool, time: vec2<f32>) {
    if GABOR_TAPS == 2 {
        var amplitude: vec2<f32>;
        var second_1: u32;
        var third: u32;
        var b_1: vec2<f32>;
        var c: vec2<f32>;
        var d: vec2<f32>;
        var real: vec4<f32>;
        var imaginary: vec4<f32>;

        let _e6 = gabor_impl_amplitude(word);
        amplitude = _e6;
        if animated {
            let _e8 = gabor_impl_amplitude_at(word, time);
            amplitude = _e8;
        }
        let _e10 = (*row);
        let _e12 = amplitude;
        let _e13 = gabor_impl_product(_e12, factor);
        (*row).value = (_e10.value + _e13);
        let _e16 = (*row);
        let _e18 = amplitude;
        let _e19 = gabor_impl_product(_e18, slope);
        (*row).slope = (_e16.slope + _e19);
        let _e21 = gabor_impl_next_word(word);
        second_1 = _e21;
        let _e23 = second_1;
        let _e24 = gabor_impl_next_word(_e23);
        third = _e24;
        let _e26 = second_1;
        let _e27 = gabor_impl_amplitude(_e26);
        b_1 = _e27;
        let _e29 = third;
        let _e30 = gabor_impl_amplitude(_e29);
        c = _e30;
        let _e32 = third;
        let _e33 = gabor_impl_next_word(_e32);
        let _e34 = gabor_impl_amplitude(_e33);
        d = _e34;
        let _e36 = amplitude;
        let _e38 = b_1;
        let _e40 = c;
        let _e42 = d;
        real = vec4<f32>(_e36.x, _e38.x, _e40.x, _e42.x);
        let _e46 = amplitude;
        let _e48 = b_1;
        let _e50 = c;
        let _e52 = d;
        imaginary = vec4<f32>(_e46.y, _e48.y, _e50.y, _e52.y);
        let _e57 = (*row);
        let _e60 = real;
        let _e63 = imaginary;
        (*row).four_real = (_e57.four_real + ((factor.x * _e60) - (factor.y * _e63)));
        let _e68 = (*row);
        let _e71 = imaginary;
        let _e74 = real;
        (*row).four_imaginary = (_e68.four_imaginary + ((factor.x * _e71) + (factor.y * _e74)));
        return;
    } else if GABOR_TAPS == 4 {
        var amplitude: vec2<f32>;
        var second_1: u32;
        var third: u32;
        var b_1: vec2<f32>;
        var c_1: vec2<f32>;
        var d: vec2<f32>;
        var real: vec4<f32>;
        var imaginary: vec4<f32>;

        let _e6 = gabor_impl_amplitude(word);
        amplitude = _e6;
        if animated {
            let _e8 = gabor_impl_amplitude_at(word, time);
            amplitude = _e8;
        }
        let _e10 = (*row);
        let _e12 = amplitude;
        let _e13 = gabor_impl_product(_e12, factor);
        (*row).value = (_e10.value + _e13);
        let _e16 = (*row);
        let _e18 = amplitude;
        let _e19 = gabor_impl_product(_e18, slope);
        (*row).slope = (_e16.slope + _e19);
        let _e21 = gabor_impl_next_word(word);
        second_1 = _e21;
        let _e23 = second_1;
        let _e24 = gabor_impl_next_word(_e23);
        third = _e24;
        let _e26 = second_1;
        let _e27 = gabor_impl_amplitude(_e26);
        b_1 = _e27;
        let _e29 = third;
        let _e30 = gabor_impl_amplitude(_e29);
        c_1 = _e30;
        let _e32 = third;
        let _e33 = gabor_impl_next_word(_e32);
        let _e34 = gabor_impl_amplitude(_e33);
        d = _e34;
        let _e36 = amplitude;
        let _e38 = b_1;
        let _e40 = c_1;
        let _e42 = d;
        real = vec4<f32>(_e36.x, _e38.x, _e40.x, _e42.x);
        let _e46 = amplitude;
        let _e48 = b_1;
        let _e50 = c_1;
        let _e52 = d;
        imaginary = vec4<f32>(_e46.y, _e48.y, _e50.y, _e52.y);
        let _e57 = (*row);
        let _e60 = real;
        let _e63 = imaginary;
        (*row).four_real = (_e57.four_real + ((factor.x * _e60) - (factor.y * _e63)));
        let _e68 = (*row);
        let _e71 = imaginary;
        let _e74 = real;
        (*row).four_imaginary = (_e68.four_imaginary + ((factor.x * _e71) + (factor.y * _e74)));
        return;
    } else {
        var amplitude: vec2<f32>;
        var second_1: u32;
        var third: u32;
        var b_1: vec2<f32>;
        var c_1: vec2<f32>;
        var d_1: vec2<f32>;
        var real: vec4<f32>;
        var imaginary: vec4<f32>;

        let _e6 = gabor_impl_amplitude(word);
        amplitude = _e6;
        if animated {
            let _e8 = gabor_impl_amplitude_at(word, time);
            amplitude = _e8;
        }
        let _e10 = (*row);
        let _e12 = amplitude;
        let _e13 = gabor_impl_product(_e12, factor);
        (*row).value = (_e10.value + _e13);
        let _e16 = (*row);
        let _e18 = amplitude;
        let _e19 = gabor_impl_product(_e18, slope);
        (*row).slope = (_e16.slope + _e19);
        let _e21 = gabor_impl_next_word(word);
        second_1 = _e21;
        let _e23 = second_1;
        let _e24 = gabor_impl_next_word(_e23);
        third = _e24;
        let _e26 = second_1;
        let _e27 = gabor_impl_amplitude(_e26);
        b_1 = _e27;
        let _e29 = third;
        let _e30 = gabor_impl_amplitude(_e29);
        c_1 = _e30;
        let _e32 = third;
        let _e33 = gabor_impl_next_word(_e32);
        let _e34 = gabor_impl_amplitude(_e33);
        d_1 = _e34;
        let _e36 = amplitude;
        let _e38 = b_1;
        let _e40 = c_1;
        let _e42 = d_1;
        real = vec4<f32>(_e36.x, _e38.x, _e40.x, _e42.x);
        let _e46 = amplitude;
        let _e48 = b_1;
        let _e50 = c_1;
        let _e52 = d_1;
        imaginary = vec4<f32>(_e46.y, _e48.y, _e50.y, _e52.y);
        let _e57 = (*row);
        let _e60 = real;
        let _e63 = imaginary;
        (*row).four_real = (_e57.four_real + ((factor.x * _e60) - (factor.y * _e63)));
        let _e68 = (*row);
        let _e71 = imaginary;
        let _e74 = real;
        (*row).four_imaginary = (_e68.four_imaginary + ((factor.x * _e71) + (factor.y * _e74)));
        return;
    }
}

fn gabor_impl_row(axis: GaborAxis, word: u32, animated: bool, time: vec2<f32>) -> GaborRow {
    if GABOR_TAPS == 2 {
        var row_1: GaborRow = GaborRow(vec2(0f), vec2(0f), vec4(0f), vec4(0f));

        let _e18 = gabor_impl_node_word((axis.word.x ^ word));
        gabor_impl_add_node((&row_1), _e18, vec2<f32>(axis.real.x, axis.imaginary.x), vec2<f32>(axis.slope_real.x, axis.slope_imaginary.x), animated, time);
        let _e34 = gabor_impl_node_word((axis.word.y ^ word));
        gabor_impl_add_node((&row_1), _e34, vec2<f32>(axis.real.y, axis.imaginary.y), vec2<f32>(axis.slope_real.y, axis.slope_imaginary.y), animated, time);
        let _e46 = row_1;
        return _e46;
    } else if GABOR_TAPS == 4 {
        var row_1: GaborRow = GaborRow(vec2(0f), vec2(0f), vec4(0f), vec4(0f));

        let _e18 = gabor_impl_node_word((axis.word.x ^ word));
        gabor_impl_add_node((&row_1), _e18, vec2<f32>(axis.real.x, axis.imaginary.x), vec2<f32>(axis.slope_real.x, axis.slope_imaginary.x), animated, time);
        let _e34 = gabor_impl_node_word((axis.word.y ^ word));
        gabor_impl_add_node((&row_1), _e34, vec2<f32>(axis.real.y, axis.imaginary.y), vec2<f32>(axis.slope_real.y, axis.slope_imaginary.y), animated, time);
        let _e50 = gabor_impl_node_word((axis.word.z ^ word));
        gabor_impl_add_node((&row_1), _e50, vec2<f32>(axis.real.z, axis.imaginary.z), vec2<f32>(axis.slope_real.z, axis.slope_imaginary.z), animated, time);
        let _e66 = gabor_impl_node_word((axis.word.w ^ word));
        gabor_impl_add_node((&row_1), _e66, vec2<f32>(axis.real.w, axis.imaginary.w), vec2<f32>(axis.slope_real.w, axis.slope_imaginary.w), animated, time);
        let _e78 = row_1;
        return _e78;
    } else {
        var row_1: GaborRow = GaborRow(vec2(0f), vec2(0f), vec4(0f), vec4(0f));

        let _e18 = gabor_impl_node_word((axis.word.x ^ word));
        gabor_impl_add_node((&row_1), _e18, vec2<f32>(axis.real.x, axis.imaginary.x), vec2<f32>(axis.slope_real.x, axis.slope_imaginary.x), animated, time);
        let _e34 = gabor_impl_node_word((axis.word.y ^ word));
        gabor_impl_add_node((&row_1), _e34, vec2<f32>(axis.real.y, axis.imaginary.y), vec2<f32>(axis.slope_real.y, axis.slope_imaginary.y), animated, time);
        let _e50 = gabor_impl_node_word((axis.word.z ^ word));
        gabor_impl_add_node((&row_1), _e50, vec2<f32>(axis.real.z, axis.imaginary.z), vec2<f32>(axis.slope_real.z, axis.slope_imaginary.z), animated, time);
        let _e62 = row_1;
        return _e62;
    }
}

fn gabor_impl_add_row(sum: ptr<function, GaborField>, row: GaborRow, factor: vec2<f32>, slope: vec2<f32>, base: vec2<f32>) {
    var factor_2: vec2<f32>;

    factor_2 = factor;
    let _e6 = factor_2;
    let _e7 = gabor_impl_product(_e6, base);
    factor_2 = _e7;
    let _e9 = (*sum);
    let _e12 = factor_2;
    let _e13 = gabor_impl_product(row.value, _e12);
    (*sum).value = (_e9.value + _e13);
    let _e16 = (*sum);
    let _e19 = factor_2;
    let _e20 = gabor_impl_product(row.slope, _e19);
    (*sum).slope_x = (_e16.slope_x + _e20);
    let _e23 = (*sum);
    let _e26 = gabor_impl_product(slope, base);
    let _e27 = gabor_impl_product(row.value, _e26);
    (*sum).slope_y = (_e23.slope_y + _e27);
    let _e30 = (*sum);
    let _e32 = factor_2;
    let _e36 = factor_2;
    (*sum).four = (_e30.four + ((_e32.x * row.four_imaginary) + (_e36.y * row.four_real)));
    return;
}

// The noise at a place: what the functions below call.
fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    if GABOR_TAPS == 2 {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var x_2: vec2<f32>;
        var node: vec2<i32>;
        var columns: GaborAxis;
        var rows: GaborAxis;
        var cycles: vec2<f32>;
        var base_1: vec2<f32>;
        var time_3: vec2<f32>;
        var sum_1: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
        var scale: f32 = 0.00000000008578349f;
        var stretch: vec2<f32>;
        var turn: vec2<f32>;
        var field: GaborField;

        kernel_1 = kernel;
        first_1 = (floor((place.local - vec2(1f))) + vec2(1f));
        let _e17 = first_1;
        x_2 = (place.local - _e17);
        let _e21 = first_1;
        node = (place.cell + vec2<i32>(_e21));
        let _e25 = node;
        let _e27 = x_2;
        let _e32 = gabor_impl_salt(seed, 0u);
        let _e33 = kernel_1;
        let _e35 = gabor_impl_axis(_e25.x, _e27.x, place.period.x, _e32, _e33.step_x);
        columns = _e35;
        let _e37 = node;
        let _e39 = x_2;
        let _e44 = gabor_impl_salt(seed, 1u);
        let _e45 = kernel_1;
        let _e47 = gabor_impl_axis(_e37.y, _e39.y, place.period.y, _e44, _e45.step_y);
        rows = _e47;
        let _e49 = kernel_1;
        cycles = (_e49.wave / place.radius);
        let _e54 = cycles;
        let _e55 = x_2;
        let _e57 = gabor_impl_wave(dot(_e54, _e55));
        base_1 = _e57;
        let _e60 = gabor_impl_wave(place.time);
        time_3 = _e60;
        let _e73 = columns;
        let _e74 = rows;
        let _e78 = time_3;
        let _e79 = gabor_impl_row(_e73, _e74.word.x, place.animated, _e78);
        let _e80 = rows;
        let _e83 = rows;
        let _e87 = rows;
        let _e90 = rows;
        let _e94 = base_1;
        gabor_impl_add_row((&sum_1), _e79, vec2<f32>(_e80.real.x, _e83.imaginary.x), vec2<f32>(_e87.slope_real.x, _e90.slope_imaginary.x), _e94);
        let _e97 = columns;
        let _e98 = rows;
        let _e102 = time_3;
        let _e103 = gabor_impl_row(_e97, _e98.word.y, place.animated, _e102);
        let _e104 = rows;
        let _e107 = rows;
        let _e111 = rows;
        let _e114 = rows;
        let _e118 = base_1;
        gabor_impl_add_row((&sum_1), _e103, vec2<f32>(_e104.real.y, _e107.imaginary.y), vec2<f32>(_e111.slope_real.y, _e114.slope_imaginary.y), _e118);
        let _e126 = scale;
        stretch = ((_e126 / 1f) * place.radius);
        let _e136 = scale;
        let _e138 = kernel_1;
        turn = ((6.2831855f * _e136) * _e138.wave);
        let _e144 = scale;
        let _e145 = sum_1;
        field.value = (_e144 * _e145.value);
        let _e149 = stretch;
        let _e151 = sum_1;
        let _e154 = turn;
        let _e156 = sum_1;
        let _e160 = sum_1;
        field.slope_x = ((_e149.x * _e151.slope_x) + (_e154.x * vec2<f32>(-(_e156.value.y), _e160.value.x)));
        let _e167 = stretch;
        let _e169 = sum_1;
        let _e172 = turn;
        let _e174 = sum_1;
        let _e178 = sum_1;
        field.slope_y = ((_e167.y * _e169.slope_y) + (_e172.y * vec2<f32>(-(_e174.value.y), _e178.value.x)));
        let _e185 = scale;
        let _e186 = sum_1;
        field.four = (_e185 * _e186.four);
        let _e189 = field;
        return _e189;
    } else if GABOR_TAPS == 4 {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var x_3: vec2<f32>;
        var node: vec2<i32>;
        var columns: GaborAxis;
        var rows: GaborAxis;
        var cycles: vec2<f32>;
        var base_1: vec2<f32>;
        var time_3: vec2<f32>;
        var sum_1: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
        var scale: f32 = 0.000000000057188997f;
        var stretch: vec2<f32>;
        var turn: vec2<f32>;
        var field: GaborField;

        kernel_1 = kernel;
        first_1 = (floor((place.local - vec2(2f))) + vec2(1f));
        let _e17 = first_1;
        x_3 = (place.local - _e17);
        let _e21 = first_1;
        node = (place.cell + vec2<i32>(_e21));
        let _e25 = node;
        let _e27 = x_3;
        let _e32 = gabor_impl_salt(seed, 0u);
        let _e33 = kernel_1;
        let _e35 = gabor_impl_axis(_e25.x, _e27.x, place.period.x, _e32, _e33.step_x);
        columns = _e35;
        let _e37 = node;
        let _e39 = x_3;
        let _e44 = gabor_impl_salt(seed, 1u);
        let _e45 = kernel_1;
        let _e47 = gabor_impl_axis(_e37.y, _e39.y, place.period.y, _e44, _e45.step_y);
        rows = _e47;
        let _e49 = kernel_1;
        cycles = (_e49.wave / place.radius);
        let _e54 = x_3;
        x_3 = (_e54 - vec2(1f));
        let _e58 = cycles;
        let _e59 = x_3;
        let _e61 = gabor_impl_wave(dot(_e58, _e59));
        base_1 = _e61;
        let _e64 = gabor_impl_wave(place.time);
        time_3 = _e64;
        let _e77 = columns;
        let _e78 = rows;
        let _e82 = time_3;
        let _e83 = gabor_impl_row(_e77, _e78.word.x, place.animated, _e82);
        let _e84 = rows;
        let _e87 = rows;
        let _e91 = rows;
        let _e94 = rows;
        let _e98 = base_1;
        gabor_impl_add_row((&sum_1), _e83, vec2<f32>(_e84.real.x, _e87.imaginary.x), vec2<f32>(_e91.slope_real.x, _e94.slope_imaginary.x), _e98);
        let _e101 = columns;
        let _e102 = rows;
        let _e106 = time_3;
        let _e107 = gabor_impl_row(_e101, _e102.word.y, place.animated, _e106);
        let _e108 = rows;
        let _e111 = rows;
        let _e115 = rows;
        let _e118 = rows;
        let _e122 = base_1;
        gabor_impl_add_row((&sum_1), _e107, vec2<f32>(_e108.real.y, _e111.imaginary.y), vec2<f32>(_e115.slope_real.y, _e118.slope_imaginary.y), _e122);
        let _e125 = columns;
        let _e126 = rows;
        let _e130 = time_3;
        let _e131 = gabor_impl_row(_e125, _e126.word.z, place.animated, _e130);
        let _e132 = rows;
        let _e135 = rows;
        let _e139 = rows;
        let _e142 = rows;
        let _e146 = base_1;
        gabor_impl_add_row((&sum_1), _e131, vec2<f32>(_e132.real.z, _e135.imaginary.z), vec2<f32>(_e139.slope_real.z, _e142.slope_imaginary.z), _e146);
        let _e149 = columns;
        let _e150 = rows;
        let _e154 = time_3;
        let _e155 = gabor_impl_row(_e149, _e150.word.w, place.animated, _e154);
        let _e156 = rows;
        let _e159 = rows;
        let _e163 = rows;
        let _e166 = rows;
        let _e170 = base_1;
        gabor_impl_add_row((&sum_1), _e155, vec2<f32>(_e156.real.w, _e159.imaginary.w), vec2<f32>(_e163.slope_real.w, _e166.slope_imaginary.w), _e170);
        let _e181 = scale;
        stretch = ((_e181 / 2f) * place.radius);
        let _e191 = scale;
        let _e193 = kernel_1;
        turn = ((6.2831855f * _e191) * _e193.wave);
        let _e199 = scale;
        let _e200 = sum_1;
        field.value = (_e199 * _e200.value);
        let _e204 = stretch;
        let _e206 = sum_1;
        let _e209 = turn;
        let _e211 = sum_1;
        let _e215 = sum_1;
        field.slope_x = ((_e204.x * _e206.slope_x) + (_e209.x * vec2<f32>(-(_e211.value.y), _e215.value.x)));
        let _e222 = stretch;
        let _e224 = sum_1;
        let _e227 = turn;
        let _e229 = sum_1;
        let _e233 = sum_1;
        field.slope_y = ((_e222.y * _e224.slope_y) + (_e227.y * vec2<f32>(-(_e229.value.y), _e233.value.x)));
        let _e240 = scale;
        let _e241 = sum_1;
        field.four = (_e240 * _e241.four);
        let _e244 = field;
        return _e244;
    } else {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var x_3: vec2<f32>;
        var node: vec2<i32>;
        var columns: GaborAxis;
        var rows: GaborAxis;
        var cycles: vec2<f32>;
        var base_1: vec2<f32>;
        var time_3: vec2<f32>;
        var sum_1: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
        var scale: f32 = 0.00000000007625199f;
        var stretch: vec2<f32>;
        var turn: vec2<f32>;
        var field: GaborField;

        kernel_1 = kernel;
        first_1 = (floor((place.local - vec2(1.5f))) + vec2(1f));
        let _e17 = first_1;
        x_3 = (place.local - _e17);
        let _e21 = first_1;
        node = (place.cell + vec2<i32>(_e21));
        let _e25 = node;
        let _e27 = x_3;
        let _e32 = gabor_impl_salt(seed, 0u);
        let _e33 = kernel_1;
        let _e35 = gabor_impl_axis(_e25.x, _e27.x, place.period.x, _e32, _e33.step_x);
        columns = _e35;
        let _e37 = node;
        let _e39 = x_3;
        let _e44 = gabor_impl_salt(seed, 1u);
        let _e45 = kernel_1;
        let _e47 = gabor_impl_axis(_e37.y, _e39.y, place.period.y, _e44, _e45.step_y);
        rows = _e47;
        let _e49 = kernel_1;
        cycles = (_e49.wave / place.radius);
        let _e54 = x_3;
        x_3 = (_e54 - vec2(1f));
        let _e58 = cycles;
        let _e59 = x_3;
        let _e61 = gabor_impl_wave(dot(_e58, _e59));
        base_1 = _e61;
        let _e64 = gabor_impl_wave(place.time);
        time_3 = _e64;
        let _e77 = columns;
        let _e78 = rows;
        let _e82 = time_3;
        let _e83 = gabor_impl_row(_e77, _e78.word.x, place.animated, _e82);
        let _e84 = rows;
        let _e87 = rows;
        let _e91 = rows;
        let _e94 = rows;
        let _e98 = base_1;
        gabor_impl_add_row((&sum_1), _e83, vec2<f32>(_e84.real.x, _e87.imaginary.x), vec2<f32>(_e91.slope_real.x, _e94.slope_imaginary.x), _e98);
        let _e101 = columns;
        let _e102 = rows;
        let _e106 = time_3;
        let _e107 = gabor_impl_row(_e101, _e102.word.y, place.animated, _e106);
        let _e108 = rows;
        let _e111 = rows;
        let _e115 = rows;
        let _e118 = rows;
        let _e122 = base_1;
        gabor_impl_add_row((&sum_1), _e107, vec2<f32>(_e108.real.y, _e111.imaginary.y), vec2<f32>(_e115.slope_real.y, _e118.slope_imaginary.y), _e122);
        let _e125 = columns;
        let _e126 = rows;
        let _e130 = time_3;
        let _e131 = gabor_impl_row(_e125, _e126.word.z, place.animated, _e130);
        let _e132 = rows;
        let _e135 = rows;
        let _e139 = rows;
        let _e142 = rows;
        let _e146 = base_1;
        gabor_impl_add_row((&sum_1), _e131, vec2<f32>(_e132.real.z, _e135.imaginary.z), vec2<f32>(_e139.slope_real.z, _e142.slope_imaginary.z), _e146);
        let _e157 = scale;
        stretch = ((_e157 / 1.5f) * place.radius);
        let _e167 = scale;
        let _e169 = kernel_1;
        turn = ((6.2831855f * _e167) * _e169.wave);
        let _e175 = scale;
        let _e176 = sum_1;
        field.value = (_e175 * _e176.value);
        let _e180 = stretch;
        let _e182 = sum_1;
        let _e185 = turn;
        let _e187 = sum_1;
        let _e191 = sum_1;
        field.slope_x = ((_e180.x * _e182.slope_x) + (_e185.x * vec2<f32>(-(_e187.value.y), _e191.value.x)));
        let _e198 = stretch;
        let _e200 = sum_1;
        let _e203 = turn;
        let _e205 = sum_1;
        let _e209 = sum_1;
        field.slope_y = ((_e198.y * _e200.slope_y) + (_e203.y * vec2<f32>(-(_e205.value.y), _e209.value.x)));
        let _e216 = scale;
        let _e217 = sum_1;
        field.four = (_e216 * _e217.four);
        let _e220 = field;
        return _e220;
    }
}

// (cell + local) / GABOR_RADIUS kernel radii, without periods: full precision everywhere in a world of 2^32 cells each
// way, where it wraps around.
fn gabor_place(cell: vec2<i32>, local: vec2<f32>) -> GaborPlace {
    if GABOR_TAPS == 2 {
        return GaborPlace(cell, local, vec2(1f), vec2(0i), false, 0f);
    } else if GABOR_TAPS == 4 {
        return GaborPlace(cell, local, vec2(2f), vec2(0i), false, 0f);
    } else {
        return GaborPlace(cell, local, vec2(1.5f), vec2(0i), false, 0f);
    }
}

// The kernel of a frequency and an orientation, with the ranges of gabor_noise.
fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel {
    if GABOR_TAPS == 2 {
        var magnitude: f32;
        var wave: vec2<f32>;

        magnitude = min(abs(frequency), 1000000f);
        let _e6 = magnitude;
        let _e7 = gabor_impl_direction(orientation);
        wave = (_e6 * _e7);
        let _e10 = wave;
        let _e11 = wave;
        let _e18 = gabor_impl_wave((_e11.x / 1f));
        let _e19 = wave;
        let _e26 = gabor_impl_wave((_e19.y / 1f));
        return GaborKernel(_e10, _e18, _e26);
    } else if GABOR_TAPS == 4 {
        var magnitude: f32;
        var wave: vec2<f32>;

        magnitude = min(abs(frequency), 1000000f);
        let _e6 = magnitude;
        let _e7 = gabor_impl_direction(orientation);
        wave = (_e6 * _e7);
        let _e10 = wave;
        let _e11 = wave;
        let _e18 = gabor_impl_wave((_e11.x / 2f));
        let _e19 = wave;
        let _e26 = gabor_impl_wave((_e19.y / 2f));
        return GaborKernel(_e10, _e18, _e26);
    } else {
        var magnitude: f32;
        var wave: vec2<f32>;

        magnitude = min(abs(frequency), 1000000f);
        let _e6 = magnitude;
        let _e7 = gabor_impl_direction(orientation);
        wave = (_e6 * _e7);
        let _e10 = wave;
        let _e11 = wave;
        let _e18 = gabor_impl_wave((_e11.x / 1.5f));
        let _e19 = wave;
        let _e26 = gabor_impl_wave((_e19.y / 1.5f));
        return GaborKernel(_e10, _e18, _e26);
    }
}

// The noise at (cell + local) / GABOR_RADIUS kernel radii, in full precision everywhere.
fn gabor_noise_at(cell: vec2<i32>, local: vec2<f32>, kernel: GaborKernel, seed: u32) -> f32 {
    var kernel_3: GaborKernel;

    kernel_3 = kernel;
    let _e5 = gabor_place(cell, local);
    let _e6 = kernel_3;
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
fn gabor_noise_gradient(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    if GABOR_TAPS == 2 {
        var field_1: GaborField;

        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        field_1 = _e13;
        let _e15 = field_1;
        let _e18 = field_1;
        let _e21 = field_1;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    } else if GABOR_TAPS == 4 {
        var field_1: GaborField;

        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        field_1 = _e13;
        let _e15 = field_1;
        let _e18 = field_1;
        let _e21 = field_1;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    } else {
        var field_1: GaborField;

        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = gabor_kernel(frequency, orientation);
        let _e13 = gabor_field(_e11, _e12, seed);
        field_1 = _e13;
        let _e15 = field_1;
        let _e18 = field_1;
        let _e21 = field_1;
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

// Four noises at p, independent of each other, for colours and for displacement along vectors; the first is gabor_noise.
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
    var local_6: f32;
    var phase: f32;
    var local_7: f32;

    intensity = length(value);
    let _e3 = intensity;
    if (_e3 > 0f) {
        local_6 = (atan2(value.y, value.x) * 0.15915494f);
    } else {
        local_6 = 0f;
    }
    let _e13 = local_6;
    phase = _e13;
    let _e15 = phase;
    if (_e15 < 0f) {
        let _e18 = phase;
        local_7 = min((_e18 + 1f), 0.99999994f);
    } else {
        let _e23 = phase;
        local_7 = _e23;
    }
    let _e25 = local_7;
    let _e26 = intensity;
    return vec2<f32>(_e25, _e26);
}

// Gabor noise that repeats after `period` kernel radii along x and y, exactly, whatever the frequency and orientation,
// with the law of gabor_noise: windows become a little wider or narrower, so that a whole number of nodes fits.
// Each period is at least 1/1024; from 2 up windows change by a sixth at most, shorter ones make them as narrow.
fn gabor_noise_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    if GABOR_TAPS == 2 {
        var period_3: vec2<f32>;
        var nodes: vec2<f32>;
        var radius: vec2<f32>;
        var within_1: vec2<f32>;
        var kernel_4: GaborKernel;
        var place_1: GaborPlace;

        period_3 = period;
        let _e6 = period_3;
        period_3 = max(_e6, vec2(0.0009765625f));
        let _e10 = period_3;
        nodes = max(floor(((_e10 * 1f) + vec2(0.5f))), vec2(2f));
        let _e25 = nodes;
        let _e26 = period_3;
        radius = (_e25 / _e26);
        let _e29 = period_3;
        let _e32 = period_3;
        within_1 = (p - (floor((p / _e29)) * _e32));
        let _e36 = gabor_kernel(frequency, orientation);
        kernel_4 = _e36;
        let _e39 = kernel_4;
        let _e42 = radius;
        let _e45 = gabor_impl_wave((_e39.wave.x / _e42.x));
        kernel_4.step_x = _e45;
        let _e47 = kernel_4;
        let _e50 = radius;
        let _e53 = gabor_impl_wave((_e47.wave.y / _e50.y));
        kernel_4.step_y = _e53;
        let _e56 = within_1;
        let _e57 = radius;
        let _e59 = radius;
        let _e60 = nodes;
        place_1 = GaborPlace(vec2(0i), (_e56 * _e57), _e59, vec2<i32>(_e60), false, 0f);
        let _e66 = place_1;
        let _e67 = kernel_4;
        let _e68 = gabor_field(_e66, _e67, seed);
        return _e68.value.y;
    } else if GABOR_TAPS == 4 {
        var period_3: vec2<f32>;
        var nodes: vec2<f32>;
        var radius: vec2<f32>;
        var within_1: vec2<f32>;
        var kernel_4: GaborKernel;
        var place_1: GaborPlace;

        period_3 = period;
        let _e6 = period_3;
        period_3 = max(_e6, vec2(0.0009765625f));
        let _e10 = period_3;
        nodes = max(floor(((_e10 * 2f) + vec2(0.5f))), vec2(4f));
        let _e25 = nodes;
        let _e26 = period_3;
        radius = (_e25 / _e26);
        let _e29 = period_3;
        let _e32 = period_3;
        within_1 = (p - (floor((p / _e29)) * _e32));
        let _e36 = gabor_kernel(frequency, orientation);
        kernel_4 = _e36;
        let _e39 = kernel_4;
        let _e42 = radius;
        let _e45 = gabor_impl_wave((_e39.wave.x / _e42.x));
        kernel_4.step_x = _e45;
        let _e47 = kernel_4;
        let _e50 = radius;
        let _e53 = gabor_impl_wave((_e47.wave.y / _e50.y));
        kernel_4.step_y = _e53;
        let _e56 = within_1;
        let _e57 = radius;
        let _e59 = radius;
        let _e60 = nodes;
        place_1 = GaborPlace(vec2(0i), (_e56 * _e57), _e59, vec2<i32>(_e60), false, 0f);
        let _e66 = place_1;
        let _e67 = kernel_4;
        let _e68 = gabor_field(_e66, _e67, seed);
        return _e68.value.y;
    } else {
        var period_3: vec2<f32>;
        var nodes: vec2<f32>;
        var radius: vec2<f32>;
        var within_1: vec2<f32>;
        var kernel_4: GaborKernel;
        var place_1: GaborPlace;

        period_3 = period;
        let _e6 = period_3;
        period_3 = max(_e6, vec2(0.0009765625f));
        let _e10 = period_3;
        nodes = max(floor(((_e10 * 1.5f) + vec2(0.5f))), vec2(3f));
        let _e25 = nodes;
        let _e26 = period_3;
        radius = (_e25 / _e26);
        let _e29 = period_3;
        let _e32 = period_3;
        within_1 = (p - (floor((p / _e29)) * _e32));
        let _e36 = gabor_kernel(frequency, orientation);
        kernel_4 = _e36;
        let _e39 = kernel_4;
        let _e42 = radius;
        let _e45 = gabor_impl_wave((_e39.wave.x / _e42.x));
        kernel_4.step_x = _e45;
        let _e47 = kernel_4;
        let _e50 = radius;
        let _e53 = gabor_impl_wave((_e47.wave.y / _e50.y));
        kernel_4.step_y = _e53;
        let _e56 = within_1;
        let _e57 = radius;
        let _e59 = radius;
        let _e60 = nodes;
        place_1 = GaborPlace(vec2(0i), (_e56 * _e57), _e59, vec2<i32>(_e60), false, 0f);
        let _e66 = place_1;
        let _e67 = kernel_4;
        let _e68 = gabor_field(_e66, _e67, seed);
        return _e68.value.y;
    }
}

// Gabor noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At every time it
// has the law of gabor_noise, and at all times and places together; its correlation with itself falls with the time
// between as cos^2(pi time): 1/2 after a quarter of the period, 0 after half of it.
fn gabor_noise_animated(p: vec2<f32>, time: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    if GABOR_TAPS == 2 {
        var place_2: GaborPlace;

        let _e12 = gabor_place(vec2(0i), (p * 1f));
        place_2 = _e12;
        place_2.animated = true;
        place_2.time = time;
        let _e17 = place_2;
        let _e18 = gabor_kernel(frequency, orientation);
        let _e19 = gabor_field(_e17, _e18, seed);
        return _e19.value.y;
    } else if GABOR_TAPS == 4 {
        var place_2: GaborPlace;

        let _e12 = gabor_place(vec2(0i), (p * 2f));
        place_2 = _e12;
        place_2.animated = true;
        place_2.time = time;
        let _e17 = place_2;
        let _e18 = gabor_kernel(frequency, orientation);
        let _e19 = gabor_field(_e17, _e18, seed);
        return _e19.value.y;
    } else {
        var place_2: GaborPlace;

        let _e12 = gabor_place(vec2(0i), (p * 1.5f));
        place_2 = _e12;
        place_2.animated = true;
        place_2.time = time;
        let _e17 = place_2;
        let _e18 = gabor_kernel(frequency, orientation);
        let _e19 = gabor_field(_e17, _e18, seed);
        return _e19.value.y;
    }
}

// Maps noise of variance 1 to [0, 1] as the paper does: the mean to 0.5 and two standard deviations to the ends, which
// keeps 95 % of the histogram inside [TNVT19, figure 4]; the rest is clamped.
fn gabor_unorm(noise: f32) -> f32 {
    return clamp((0.5f + (0.25f * noise)), 0f, 1f);
}
