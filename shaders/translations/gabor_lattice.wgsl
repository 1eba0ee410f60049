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

fn gabor_impl_salt(seed: u32) -> u32 {
    let _e4 = gabor_impl_mix((seed * 2654435761u), 625341585u);
    return _e4;
}

// The word of a column or a row of nodes: odd and of 24 bits, the highest set, so that it takes all products all over
// 32 bits; GPUs multiply 24 bits at a quarter of the cost.
fn gabor_impl_line_word(index: i32, salt: u32) -> u32 {
    var word_2: u32;

    word_2 = ((u32(index) * 2654435761u) + salt);
    let _e7 = word_2;
    let _e8 = word_2;
    word_2 = ((_e7 ^ (_e8 >> 15u)) * 3545902487u);
    let _e14 = word_2;
    return ((_e14 >> 8u) | 8388609u);
}

// The word of a node. Its high bits are the best.
fn gabor_impl_node_word(column: u32, row: u32) -> u32 {
    return (column * row);
}

// Another word of the same node.
fn gabor_impl_next_word(word: u32) -> u32 {
    return ((word ^ (word >> 15u)) * 3545902487u);
}

fn gabor_impl_amplitude(word: u32) -> vec2<f32> {
    var u: vec2<f32>;

    u = vec2<f32>(f32(i32(((word & 4278190080u) | 8388608u))), f32(i32((word << 8u))));
    let _e13 = u;
    let _e15 = u;
    return (_e13 - (0.79794586f * clamp(_e15, vec2(-1731797900f), vec2(1731797900f))));
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1] and as t is rounded beyond. With y = |t| - 1/4 and t reduced to
// half a turn, cos(2 pi t) = -sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), |2 pi y| <= pi/2: minimax polynomials.
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
        var c: vec2<f32>;

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
        c = vec2<f32>((_e41 - _e42), (_e44 + _e45));
        let _e50 = c;
        let _e53 = c;
        let _e55 = c;
        let _e57 = c;
        let _e64 = c;
        let _e67 = c;
        let _e70 = c;
        let _e72 = c;
        return GaborWindows((vec4(0.5f) + vec4<f32>(-(_e50.y), _e53.x, _e55.y, -(_e57.x))), (3.1415927f * vec4<f32>(-(_e64.x), -(_e67.y), _e70.x, _e72.y)));
    } else {
        var s_1: f32;
        var c: f32;
        var b_1: f32;
        var a_1: f32;
        var slope: f32;

        s_1 = (x * x);
        let _e4 = s_1;
        let _e7 = s_1;
        let _e9 = s_1;
        c = (0.5f + (_e4 * (-1.09661f + (_e7 * (0.40054825f - (_e9 * 0.05644487f))))));
        let _e19 = s_1;
        let _e22 = s_1;
        let _e24 = s_1;
        b_1 = (x * (0.9068996f + (_e19 * (-0.66301125f + (_e22 * (0.14532053f - (_e24 * 0.01467483f)))))));
        let _e36 = c;
        a_1 = (0.5f - (0.5f * _e36));
        let _e41 = b_1;
        slope = (1.8137994f * _e41);
        let _e44 = a_1;
        let _e45 = b_1;
        let _e48 = c;
        let _e50 = a_1;
        let _e51 = b_1;
        let _e55 = slope;
        let _e57 = c;
        let _e62 = slope;
        let _e64 = slope;
        let _e66 = c;
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
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
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

fn gabor_impl_line_words(first: i32, period: i32, salt: u32) -> vec4<u32> {
    let _e3 = gabor_impl_wrap(first, period);
    let _e4 = gabor_impl_line_word(_e3, salt);
    let _e7 = gabor_impl_wrap((first + 1i), period);
    let _e8 = gabor_impl_line_word(_e7, salt);
    let _e11 = gabor_impl_wrap((first + 2i), period);
    let _e12 = gabor_impl_line_word(_e11, salt);
    let _e15 = gabor_impl_wrap((first + 3i), period);
    let _e16 = gabor_impl_line_word(_e15, salt);
    return vec4<u32>(_e4, _e8, _e12, _e16);
}

// The waves of an axis' nodes as (cosines, sines), relative to that of the second (for two taps, of the first).
//   step  e^(2 pi i F / R)
fn gabor_impl_node_waves(step: vec2<f32>, cosines: ptr<function, vec4<f32>>, sines: ptr<function, vec4<f32>>) {
    if GABOR_TAPS == 2 {
        (*cosines) = vec4<f32>(1f, step.x, 0f, 0f);
        (*sines) = vec4<f32>(0f, -(step.y), 0f, 0f);
        return;
    } else if GABOR_TAPS == 4 {
        var two: vec2<f32>;

        let _e3 = gabor_impl_product(step, step);
        two = _e3;
        let _e8 = two;
        (*cosines) = vec4<f32>(step.x, 1f, step.x, _e8.x);
        let _e15 = two;
        (*sines) = vec4<f32>(step.y, 0f, -(step.y), -(_e15.y));
        return;
    } else {
        var two: vec2<f32>;

        let _e3 = gabor_impl_product(step, step);
        two = _e3;
        let _e8 = two;
        (*cosines) = vec4<f32>(step.x, 1f, step.x, _e8.x);
        let _e15 = two;
        (*sines) = vec4<f32>(step.y, 0f, -(step.y), -(_e15.y));
        return;
    }
}

// A sum of amplitudes times windows and waves; the same with the windows' derivatives; and that of four fields.
struct GaborSum {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
    real: vec4<f32>,
    imaginary: vec4<f32>,
}

// Adds a node to the sum over its row.
//   time  cosine and sine of time: the amplitude is (A0 + A1 cos + A2 sin) / sqrt(2), normal at every time
fn gabor_impl_add_node(row: ptr<function, GaborSum>, word: u32, window: f32, factor: vec2<f32>, slope: vec2<f32>, animated: bool, time: vec2<f32>) {
    if GABOR_TAPS == 2 {
        var a_1: vec2<f32>;
        var second: u32;
        var third: u32;
        var b_1: vec2<f32>;
        var c: vec2<f32>;
        var d: vec2<f32>;
        var real: vec4<f32>;
        var imaginary: vec4<f32>;

        if (window > -1f) {
            {
                let _e10 = gabor_impl_amplitude(word);
                a_1 = _e10;
                let _e12 = gabor_impl_next_word(word);
                second = _e12;
                let _e14 = second;
                let _e15 = gabor_impl_next_word(_e14);
                third = _e15;
                let _e17 = second;
                let _e18 = gabor_impl_amplitude(_e17);
                b_1 = _e18;
                let _e20 = third;
                let _e21 = gabor_impl_amplitude(_e20);
                c = _e21;
                let _e23 = third;
                let _e24 = gabor_impl_next_word(_e23);
                let _e25 = gabor_impl_amplitude(_e24);
                d = _e25;
                if animated {
                    let _e28 = a_1;
                    let _e30 = b_1;
                    let _e34 = c;
                    a_1 = (0.70710677f * ((_e28 + (time.x * _e30)) + (time.y * _e34)));
                }
                let _e39 = (*row);
                let _e41 = a_1;
                let _e42 = gabor_impl_product(_e41, factor);
                (*row).value = (_e39.value + _e42);
                let _e45 = (*row);
                let _e47 = a_1;
                let _e48 = gabor_impl_product(_e47, slope);
                (*row).slope_x = (_e45.slope_x + _e48);
                let _e50 = a_1;
                let _e52 = b_1;
                let _e54 = c;
                let _e56 = d;
                real = vec4<f32>(_e50.x, _e52.x, _e54.x, _e56.x);
                let _e60 = a_1;
                let _e62 = b_1;
                let _e64 = c;
                let _e66 = d;
                imaginary = vec4<f32>(_e60.y, _e62.y, _e64.y, _e66.y);
                let _e71 = (*row);
                let _e74 = real;
                let _e77 = imaginary;
                (*row).real = (_e71.real + ((factor.x * _e74) - (factor.y * _e77)));
                let _e82 = (*row);
                let _e85 = imaginary;
                let _e88 = real;
                (*row).imaginary = (_e82.imaginary + ((factor.x * _e85) + (factor.y * _e88)));
                return;
            }
        } else {
            return;
        }
    } else if GABOR_TAPS == 4 {
        var a_1: vec2<f32>;
        var second: u32;
        var third: u32;
        var b_1: vec2<f32>;
        var c_1: vec2<f32>;
        var d: vec2<f32>;
        var real: vec4<f32>;
        var imaginary: vec4<f32>;

        if (window > -1f) {
            {
                let _e10 = gabor_impl_amplitude(word);
                a_1 = _e10;
                let _e12 = gabor_impl_next_word(word);
                second = _e12;
                let _e14 = second;
                let _e15 = gabor_impl_next_word(_e14);
                third = _e15;
                let _e17 = second;
                let _e18 = gabor_impl_amplitude(_e17);
                b_1 = _e18;
                let _e20 = third;
                let _e21 = gabor_impl_amplitude(_e20);
                c_1 = _e21;
                let _e23 = third;
                let _e24 = gabor_impl_next_word(_e23);
                let _e25 = gabor_impl_amplitude(_e24);
                d = _e25;
                if animated {
                    let _e28 = a_1;
                    let _e30 = b_1;
                    let _e34 = c_1;
                    a_1 = (0.70710677f * ((_e28 + (time.x * _e30)) + (time.y * _e34)));
                }
                let _e39 = (*row);
                let _e41 = a_1;
                let _e42 = gabor_impl_product(_e41, factor);
                (*row).value = (_e39.value + _e42);
                let _e45 = (*row);
                let _e47 = a_1;
                let _e48 = gabor_impl_product(_e47, slope);
                (*row).slope_x = (_e45.slope_x + _e48);
                let _e50 = a_1;
                let _e52 = b_1;
                let _e54 = c_1;
                let _e56 = d;
                real = vec4<f32>(_e50.x, _e52.x, _e54.x, _e56.x);
                let _e60 = a_1;
                let _e62 = b_1;
                let _e64 = c_1;
                let _e66 = d;
                imaginary = vec4<f32>(_e60.y, _e62.y, _e64.y, _e66.y);
                let _e71 = (*row);
                let _e74 = real;
                let _e77 = imaginary;
                (*row).real = (_e71.real + ((factor.x * _e74) - (factor.y * _e77)));
                let _e82 = (*row);
                let _e85 = imaginary;
                let _e88 = real;
                (*row).imaginary = (_e82.imaginary + ((factor.x * _e85) + (factor.y * _e88)));
                return;
            }
        } else {
            return;
        }
    } else {
        var a_2: vec2<f32>;
        var second: u32;
        var third: u32;
        var b_2: vec2<f32>;
        var c_1: vec2<f32>;
        var d: vec2<f32>;
        var real: vec4<f32>;
        var imaginary: vec4<f32>;

        if (window > -1f) {
            {
                let _e10 = gabor_impl_amplitude(word);
                a_2 = _e10;
                let _e12 = gabor_impl_next_word(word);
                second = _e12;
                let _e14 = second;
                let _e15 = gabor_impl_next_word(_e14);
                third = _e15;
                let _e17 = second;
                let _e18 = gabor_impl_amplitude(_e17);
                b_2 = _e18;
                let _e20 = third;
                let _e21 = gabor_impl_amplitude(_e20);
                c_1 = _e21;
                let _e23 = third;
                let _e24 = gabor_impl_next_word(_e23);
                let _e25 = gabor_impl_amplitude(_e24);
                d = _e25;
                if animated {
                    let _e28 = a_2;
                    let _e30 = b_2;
                    let _e34 = c_1;
                    a_2 = (0.70710677f * ((_e28 + (time.x * _e30)) + (time.y * _e34)));
                }
                let _e39 = (*row);
                let _e41 = a_2;
                let _e42 = gabor_impl_product(_e41, factor);
                (*row).value = (_e39.value + _e42);
                let _e45 = (*row);
                let _e47 = a_2;
                let _e48 = gabor_impl_product(_e47, slope);
                (*row).slope_x = (_e45.slope_x + _e48);
                let _e50 = a_2;
                let _e52 = b_2;
                let _e54 = c_1;
                let _e56 = d;
                real = vec4<f32>(_e50.x, _e52.x, _e54.x, _e56.x);
                let _e60 = a_2;
                let _e62 = b_2;
                let _e64 = c_1;
                let _e66 = d;
                imaginary = vec4<f32>(_e60.y, _e62.y, _e64.y, _e66.y);
                let _e71 = (*row);
                let _e74 = real;
                let _e77 = imaginary;
                (*row).real = (_e71.real + ((factor.x * _e74) - (factor.y * _e77)));
                let _e82 = (*row);
                let _e85 = imaginary;
                let _e88 = real;
                (*row).imaginary = (_e82.imaginary + ((factor.x * _e85) + (factor.y * _e88)));
                return;
            }
        } else {
            return;
        }
    }
}

// Adds a row to the whole.
fn gabor_impl_add_row(sum: ptr<function, GaborSum>, row: GaborSum, factor: vec2<f32>, slope: vec2<f32>) {
    let _e5 = (*sum);
    let _e8 = gabor_impl_product(row.value, factor);
    (*sum).value = (_e5.value + _e8);
    let _e11 = (*sum);
    let _e14 = gabor_impl_product(row.slope_x, factor);
    (*sum).slope_x = (_e11.slope_x + _e14);
    let _e17 = (*sum);
    let _e20 = gabor_impl_product(row.value, slope);
    (*sum).slope_y = (_e17.slope_y + _e20);
    let _e23 = (*sum);
    (*sum).real = (_e23.real + ((factor.x * row.real) - (factor.y * row.imaginary)));
    let _e34 = (*sum);
    (*sum).imaginary = (_e34.imaginary + ((factor.x * row.imaginary) + (factor.y * row.real)));
    return;
}

// The noise at a place: what the functions below call. Cost: GABOR_TAPS^2 amplitudes.
fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    if GABOR_TAPS == 2 {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var local_2: f32;
        var offset: vec2<f32>;
        var node: vec2<i32>;
        var salt_3: u32;
        var columns: vec4<u32>;
        var rows: vec4<u32>;
        var base: vec2<f32>;
        var time_1: vec2<f32>;
        var x_1: GaborWindows;
        var y_1: GaborWindows;
        var cosines_1: vec4<f32>;
        var sines_1: vec4<f32>;
        var real_1: vec4<f32>;
        var imaginary_1: vec4<f32>;
        var slope_real: vec4<f32>;
        var slope_imaginary: vec4<f32>;
        var none: GaborSum = GaborSum(vec2(0f), vec2(0f), vec2(0f), vec4(0f), vec4(0f));
        var sum_1: GaborSum;
        var row_word: u32;
        var row_3: GaborSum;
        var row_word_1: u32;
        var row_4: GaborSum;
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
        let _e36 = node;
        let _e40 = salt_3;
        let _e41 = gabor_impl_line_words(_e36.x, place.period.x, _e40);
        columns = _e41;
        let _e43 = node;
        let _e47 = salt_3;
        let _e50 = gabor_impl_line_words(_e43.y, place.period.y, (_e47 ^ 1540483477u));
        rows = _e50;
        let _e52 = kernel_1;
        let _e54 = offset;
        let _e61 = gabor_impl_wave(dot(_e52.wave, (_e54 * (vec2(1f) / place.radius))));
        base = _e61;
        let _e64 = gabor_impl_wave(place.time);
        time_1 = _e64;
        let _e66 = offset;
        let _e68 = gabor_impl_windows(_e66.x);
        x_1 = _e68;
        let _e70 = offset;
        let _e72 = gabor_impl_windows(_e70.y);
        y_1 = _e72;
        let _e76 = kernel_1;
        gabor_impl_node_waves(_e76.step_x, (&cosines_1), (&sines_1));
        let _e82 = x_1;
        let _e84 = cosines_1;
        real_1 = (_e82.value * _e84);
        let _e87 = x_1;
        let _e89 = sines_1;
        imaginary_1 = (_e87.value * _e89);
        let _e92 = x_1;
        let _e94 = cosines_1;
        slope_real = (_e92.slope * _e94);
        let _e97 = x_1;
        let _e99 = sines_1;
        slope_imaginary = (_e97.slope * _e99);
        let _e102 = kernel_1;
        gabor_impl_node_waves(_e102.step_y, (&cosines_1), (&sines_1));
        let _e120 = none;
        sum_1 = _e120;
        {
            let _e122 = rows;
            row_word = _e122.x;
            let _e125 = none;
            row_3 = _e125;
            let _e128 = columns;
            let _e130 = row_word;
            let _e131 = gabor_impl_node_word(_e128.x, _e130);
            let _e132 = x_1;
            let _e135 = real_1;
            let _e137 = imaginary_1;
            let _e140 = slope_real;
            let _e142 = slope_imaginary;
            let _e146 = time_1;
            gabor_impl_add_node((&row_3), _e131, _e132.value.x, vec2<f32>(_e135.x, _e137.x), vec2<f32>(_e140.x, _e142.x), place.animated, _e146);
            let _e149 = columns;
            let _e151 = row_word;
            let _e152 = gabor_impl_node_word(_e149.y, _e151);
            let _e153 = x_1;
            let _e156 = real_1;
            let _e158 = imaginary_1;
            let _e161 = slope_real;
            let _e163 = slope_imaginary;
            let _e167 = time_1;
            gabor_impl_add_node((&row_3), _e152, _e153.value.y, vec2<f32>(_e156.y, _e158.y), vec2<f32>(_e161.y, _e163.y), place.animated, _e167);
            let _e170 = row_3;
            let _e171 = y_1;
            let _e174 = cosines_1;
            let _e176 = sines_1;
            let _e180 = y_1;
            let _e183 = cosines_1;
            let _e185 = sines_1;
            gabor_impl_add_row((&sum_1), _e170, (_e171.value.x * vec2<f32>(_e174.x, _e176.x)), (_e180.slope.x * vec2<f32>(_e183.x, _e185.x)));
        }
        {
            let _e190 = rows;
            row_word_1 = _e190.y;
            let _e193 = none;
            row_4 = _e193;
            let _e196 = columns;
            let _e198 = row_word_1;
            let _e199 = gabor_impl_node_word(_e196.x, _e198);
            let _e200 = x_1;
            let _e203 = real_1;
            let _e205 = imaginary_1;
            let _e208 = slope_real;
            let _e210 = slope_imaginary;
            let _e214 = time_1;
            gabor_impl_add_node((&row_4), _e199, _e200.value.x, vec2<f32>(_e203.x, _e205.x), vec2<f32>(_e208.x, _e210.x), place.animated, _e214);
            let _e217 = columns;
            let _e219 = row_word_1;
            let _e220 = gabor_impl_node_word(_e217.y, _e219);
            let _e221 = x_1;
            let _e224 = real_1;
            let _e226 = imaginary_1;
            let _e229 = slope_real;
            let _e231 = slope_imaginary;
            let _e235 = time_1;
            gabor_impl_add_node((&row_4), _e220, _e221.value.y, vec2<f32>(_e224.y, _e226.y), vec2<f32>(_e229.y, _e231.y), place.animated, _e235);
            let _e238 = row_4;
            let _e239 = y_1;
            let _e242 = cosines_1;
            let _e244 = sines_1;
            let _e248 = y_1;
            let _e251 = cosines_1;
            let _e253 = sines_1;
            gabor_impl_add_row((&sum_1), _e238, (_e239.value.y * vec2<f32>(_e242.y, _e244.y)), (_e248.slope.y * vec2<f32>(_e251.y, _e253.y)));
        }
        let _e258 = base;
        base = (_e258 * 0.0000000032289018f);
        let _e265 = sum_1;
        let _e267 = base;
        let _e268 = gabor_impl_product(_e265.value, _e267);
        value = _e268;
        let _e271 = value;
        let _e274 = value;
        turned = (6.2831855f * vec2<f32>(-(_e271.y), _e274.x));
        stretch = (place.radius / vec2(1f));
        let _e287 = value;
        let _e288 = stretch;
        let _e290 = sum_1;
        let _e292 = base;
        let _e293 = gabor_impl_product(_e290.slope_x, _e292);
        let _e295 = kernel_1;
        let _e298 = turned;
        let _e301 = stretch;
        let _e303 = sum_1;
        let _e305 = base;
        let _e306 = gabor_impl_product(_e303.slope_y, _e305);
        let _e308 = kernel_1;
        let _e311 = turned;
        let _e314 = base;
        let _e316 = sum_1;
        let _e319 = base;
        let _e321 = sum_1;
        return GaborField(_e287, ((_e288.x * _e293) + (_e295.wave.x * _e298)), ((_e301.y * _e306) + (_e308.wave.y * _e311)), ((_e314.x * _e316.imaginary) + (_e319.y * _e321.real)));
    } else if GABOR_TAPS == 4 {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var local_2: f32;
        var offset: vec2<f32>;
        var node: vec2<i32>;
        var salt_3: u32;
        var columns: vec4<u32>;
        var rows: vec4<u32>;
        var base: vec2<f32>;
        var time_1: vec2<f32>;
        var x_2: GaborWindows;
        var y_1: GaborWindows;
        var cosines_1: vec4<f32>;
        var sines_1: vec4<f32>;
        var real_1: vec4<f32>;
        var imaginary_1: vec4<f32>;
        var slope_real: vec4<f32>;
        var slope_imaginary: vec4<f32>;
        var none: GaborSum = GaborSum(vec2(0f), vec2(0f), vec2(0f), vec4(0f), vec4(0f));
        var sum_1: GaborSum;
        var row_word: u32;
        var row_3: GaborSum;
        var row_word_1: u32;
        var row_4: GaborSum;
        var row_word_2: u32;
        var row_5: GaborSum;
        var row_word_3: u32;
        var row_6: GaborSum;
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
        let _e36 = node;
        let _e40 = salt_3;
        let _e41 = gabor_impl_line_words(_e36.x, place.period.x, _e40);
        columns = _e41;
        let _e43 = node;
        let _e47 = salt_3;
        let _e50 = gabor_impl_line_words(_e43.y, place.period.y, (_e47 ^ 1540483477u));
        rows = _e50;
        let _e52 = kernel_1;
        let _e54 = offset;
        let _e61 = gabor_impl_wave(dot(_e52.wave, (_e54 * (vec2(1f) / place.radius))));
        base = _e61;
        let _e64 = gabor_impl_wave(place.time);
        time_1 = _e64;
        let _e66 = offset;
        let _e68 = gabor_impl_windows(_e66.x);
        x_2 = _e68;
        let _e70 = offset;
        let _e72 = gabor_impl_windows(_e70.y);
        y_1 = _e72;
        let _e76 = kernel_1;
        gabor_impl_node_waves(_e76.step_x, (&cosines_1), (&sines_1));
        let _e82 = x_2;
        let _e84 = cosines_1;
        real_1 = (_e82.value * _e84);
        let _e87 = x_2;
        let _e89 = sines_1;
        imaginary_1 = (_e87.value * _e89);
        let _e92 = x_2;
        let _e94 = cosines_1;
        slope_real = (_e92.slope * _e94);
        let _e97 = x_2;
        let _e99 = sines_1;
        slope_imaginary = (_e97.slope * _e99);
        let _e102 = kernel_1;
        gabor_impl_node_waves(_e102.step_y, (&cosines_1), (&sines_1));
        let _e120 = none;
        sum_1 = _e120;
        {
            let _e122 = rows;
            row_word = _e122.x;
            let _e125 = none;
            row_3 = _e125;
            let _e128 = columns;
            let _e130 = row_word;
            let _e131 = gabor_impl_node_word(_e128.x, _e130);
            let _e132 = x_2;
            let _e135 = real_1;
            let _e137 = imaginary_1;
            let _e140 = slope_real;
            let _e142 = slope_imaginary;
            let _e146 = time_1;
            gabor_impl_add_node((&row_3), _e131, _e132.value.x, vec2<f32>(_e135.x, _e137.x), vec2<f32>(_e140.x, _e142.x), place.animated, _e146);
            let _e149 = columns;
            let _e151 = row_word;
            let _e152 = gabor_impl_node_word(_e149.y, _e151);
            let _e153 = x_2;
            let _e156 = real_1;
            let _e158 = imaginary_1;
            let _e161 = slope_real;
            let _e163 = slope_imaginary;
            let _e167 = time_1;
            gabor_impl_add_node((&row_3), _e152, _e153.value.y, vec2<f32>(_e156.y, _e158.y), vec2<f32>(_e161.y, _e163.y), place.animated, _e167);
            let _e170 = columns;
            let _e172 = row_word;
            let _e173 = gabor_impl_node_word(_e170.z, _e172);
            let _e174 = x_2;
            let _e177 = real_1;
            let _e179 = imaginary_1;
            let _e182 = slope_real;
            let _e184 = slope_imaginary;
            let _e188 = time_1;
            gabor_impl_add_node((&row_3), _e173, _e174.value.z, vec2<f32>(_e177.z, _e179.z), vec2<f32>(_e182.z, _e184.z), place.animated, _e188);
            let _e191 = columns;
            let _e193 = row_word;
            let _e194 = gabor_impl_node_word(_e191.w, _e193);
            let _e195 = x_2;
            let _e198 = real_1;
            let _e200 = imaginary_1;
            let _e203 = slope_real;
            let _e205 = slope_imaginary;
            let _e209 = time_1;
            gabor_impl_add_node((&row_3), _e194, _e195.value.w, vec2<f32>(_e198.w, _e200.w), vec2<f32>(_e203.w, _e205.w), place.animated, _e209);
            let _e212 = row_3;
            let _e213 = y_1;
            let _e216 = cosines_1;
            let _e218 = sines_1;
            let _e222 = y_1;
            let _e225 = cosines_1;
            let _e227 = sines_1;
            gabor_impl_add_row((&sum_1), _e212, (_e213.value.x * vec2<f32>(_e216.x, _e218.x)), (_e222.slope.x * vec2<f32>(_e225.x, _e227.x)));
        }
        {
            let _e232 = rows;
            row_word_1 = _e232.y;
            let _e235 = none;
            row_4 = _e235;
            let _e238 = columns;
            let _e240 = row_word_1;
            let _e241 = gabor_impl_node_word(_e238.x, _e240);
            let _e242 = x_2;
            let _e245 = real_1;
            let _e247 = imaginary_1;
            let _e250 = slope_real;
            let _e252 = slope_imaginary;
            let _e256 = time_1;
            gabor_impl_add_node((&row_4), _e241, _e242.value.x, vec2<f32>(_e245.x, _e247.x), vec2<f32>(_e250.x, _e252.x), place.animated, _e256);
            let _e259 = columns;
            let _e261 = row_word_1;
            let _e262 = gabor_impl_node_word(_e259.y, _e261);
            let _e263 = x_2;
            let _e266 = real_1;
            let _e268 = imaginary_1;
            let _e271 = slope_real;
            let _e273 = slope_imaginary;
            let _e277 = time_1;
            gabor_impl_add_node((&row_4), _e262, _e263.value.y, vec2<f32>(_e266.y, _e268.y), vec2<f32>(_e271.y, _e273.y), place.animated, _e277);
            let _e280 = columns;
            let _e282 = row_word_1;
            let _e283 = gabor_impl_node_word(_e280.z, _e282);
            let _e284 = x_2;
            let _e287 = real_1;
            let _e289 = imaginary_1;
            let _e292 = slope_real;
            let _e294 = slope_imaginary;
            let _e298 = time_1;
            gabor_impl_add_node((&row_4), _e283, _e284.value.z, vec2<f32>(_e287.z, _e289.z), vec2<f32>(_e292.z, _e294.z), place.animated, _e298);
            let _e301 = columns;
            let _e303 = row_word_1;
            let _e304 = gabor_impl_node_word(_e301.w, _e303);
            let _e305 = x_2;
            let _e308 = real_1;
            let _e310 = imaginary_1;
            let _e313 = slope_real;
            let _e315 = slope_imaginary;
            let _e319 = time_1;
            gabor_impl_add_node((&row_4), _e304, _e305.value.w, vec2<f32>(_e308.w, _e310.w), vec2<f32>(_e313.w, _e315.w), place.animated, _e319);
            let _e322 = row_4;
            let _e323 = y_1;
            let _e326 = cosines_1;
            let _e328 = sines_1;
            let _e332 = y_1;
            let _e335 = cosines_1;
            let _e337 = sines_1;
            gabor_impl_add_row((&sum_1), _e322, (_e323.value.y * vec2<f32>(_e326.y, _e328.y)), (_e332.slope.y * vec2<f32>(_e335.y, _e337.y)));
        }
        {
            let _e342 = rows;
            row_word_2 = _e342.z;
            let _e345 = none;
            row_5 = _e345;
            let _e348 = columns;
            let _e350 = row_word_2;
            let _e351 = gabor_impl_node_word(_e348.x, _e350);
            let _e352 = x_2;
            let _e355 = real_1;
            let _e357 = imaginary_1;
            let _e360 = slope_real;
            let _e362 = slope_imaginary;
            let _e366 = time_1;
            gabor_impl_add_node((&row_5), _e351, _e352.value.x, vec2<f32>(_e355.x, _e357.x), vec2<f32>(_e360.x, _e362.x), place.animated, _e366);
            let _e369 = columns;
            let _e371 = row_word_2;
            let _e372 = gabor_impl_node_word(_e369.y, _e371);
            let _e373 = x_2;
            let _e376 = real_1;
            let _e378 = imaginary_1;
            let _e381 = slope_real;
            let _e383 = slope_imaginary;
            let _e387 = time_1;
            gabor_impl_add_node((&row_5), _e372, _e373.value.y, vec2<f32>(_e376.y, _e378.y), vec2<f32>(_e381.y, _e383.y), place.animated, _e387);
            let _e390 = columns;
            let _e392 = row_word_2;
            let _e393 = gabor_impl_node_word(_e390.z, _e392);
            let _e394 = x_2;
            let _e397 = real_1;
            let _e399 = imaginary_1;
            let _e402 = slope_real;
            let _e404 = slope_imaginary;
            let _e408 = time_1;
            gabor_impl_add_node((&row_5), _e393, _e394.value.z, vec2<f32>(_e397.z, _e399.z), vec2<f32>(_e402.z, _e404.z), place.animated, _e408);
            let _e411 = columns;
            let _e413 = row_word_2;
            let _e414 = gabor_impl_node_word(_e411.w, _e413);
            let _e415 = x_2;
            let _e418 = real_1;
            let _e420 = imaginary_1;
            let _e423 = slope_real;
            let _e425 = slope_imaginary;
            let _e429 = time_1;
            gabor_impl_add_node((&row_5), _e414, _e415.value.w, vec2<f32>(_e418.w, _e420.w), vec2<f32>(_e423.w, _e425.w), place.animated, _e429);
            let _e432 = row_5;
            let _e433 = y_1;
            let _e436 = cosines_1;
            let _e438 = sines_1;
            let _e442 = y_1;
            let _e445 = cosines_1;
            let _e447 = sines_1;
            gabor_impl_add_row((&sum_1), _e432, (_e433.value.z * vec2<f32>(_e436.z, _e438.z)), (_e442.slope.z * vec2<f32>(_e445.z, _e447.z)));
        }
        {
            let _e452 = rows;
            row_word_3 = _e452.w;
            let _e455 = none;
            row_6 = _e455;
            let _e458 = columns;
            let _e460 = row_word_3;
            let _e461 = gabor_impl_node_word(_e458.x, _e460);
            let _e462 = x_2;
            let _e465 = real_1;
            let _e467 = imaginary_1;
            let _e470 = slope_real;
            let _e472 = slope_imaginary;
            let _e476 = time_1;
            gabor_impl_add_node((&row_6), _e461, _e462.value.x, vec2<f32>(_e465.x, _e467.x), vec2<f32>(_e470.x, _e472.x), place.animated, _e476);
            let _e479 = columns;
            let _e481 = row_word_3;
            let _e482 = gabor_impl_node_word(_e479.y, _e481);
            let _e483 = x_2;
            let _e486 = real_1;
            let _e488 = imaginary_1;
            let _e491 = slope_real;
            let _e493 = slope_imaginary;
            let _e497 = time_1;
            gabor_impl_add_node((&row_6), _e482, _e483.value.y, vec2<f32>(_e486.y, _e488.y), vec2<f32>(_e491.y, _e493.y), place.animated, _e497);
            let _e500 = columns;
            let _e502 = row_word_3;
            let _e503 = gabor_impl_node_word(_e500.z, _e502);
            let _e504 = x_2;
            let _e507 = real_1;
            let _e509 = imaginary_1;
            let _e512 = slope_real;
            let _e514 = slope_imaginary;
            let _e518 = time_1;
            gabor_impl_add_node((&row_6), _e503, _e504.value.z, vec2<f32>(_e507.z, _e509.z), vec2<f32>(_e512.z, _e514.z), place.animated, _e518);
            let _e521 = columns;
            let _e523 = row_word_3;
            let _e524 = gabor_impl_node_word(_e521.w, _e523);
            let _e525 = x_2;
            let _e528 = real_1;
            let _e530 = imaginary_1;
            let _e533 = slope_real;
            let _e535 = slope_imaginary;
            let _e539 = time_1;
            gabor_impl_add_node((&row_6), _e524, _e525.value.w, vec2<f32>(_e528.w, _e530.w), vec2<f32>(_e533.w, _e535.w), place.animated, _e539);
            let _e542 = row_6;
            let _e543 = y_1;
            let _e546 = cosines_1;
            let _e548 = sines_1;
            let _e552 = y_1;
            let _e555 = cosines_1;
            let _e557 = sines_1;
            gabor_impl_add_row((&sum_1), _e542, (_e543.value.w * vec2<f32>(_e546.w, _e548.w)), (_e552.slope.w * vec2<f32>(_e555.w, _e557.w)));
        }
        let _e562 = base;
        base = (_e562 * 0.0000000021526012f);
        let _e569 = sum_1;
        let _e571 = base;
        let _e572 = gabor_impl_product(_e569.value, _e571);
        value = _e572;
        let _e575 = value;
        let _e578 = value;
        turned = (6.2831855f * vec2<f32>(-(_e575.y), _e578.x));
        stretch = (place.radius / vec2(2f));
        let _e591 = value;
        let _e592 = stretch;
        let _e594 = sum_1;
        let _e596 = base;
        let _e597 = gabor_impl_product(_e594.slope_x, _e596);
        let _e599 = kernel_1;
        let _e602 = turned;
        let _e605 = stretch;
        let _e607 = sum_1;
        let _e609 = base;
        let _e610 = gabor_impl_product(_e607.slope_y, _e609);
        let _e612 = kernel_1;
        let _e615 = turned;
        let _e618 = base;
        let _e620 = sum_1;
        let _e623 = base;
        let _e625 = sum_1;
        return GaborField(_e591, ((_e592.x * _e597) + (_e599.wave.x * _e602)), ((_e605.y * _e610) + (_e612.wave.y * _e615)), ((_e618.x * _e620.imaginary) + (_e623.y * _e625.real)));
    } else {
        var kernel_1: GaborKernel;
        var first_1: vec2<f32>;
        var local_2: f32;
        var offset: vec2<f32>;
        var node: vec2<i32>;
        var salt_3: u32;
        var columns: vec4<u32>;
        var rows: vec4<u32>;
        var base: vec2<f32>;
        var time_1: vec2<f32>;
        var x_1: GaborWindows;
        var y_1: GaborWindows;
        var cosines_1: vec4<f32>;
        var sines_1: vec4<f32>;
        var real_1: vec4<f32>;
        var imaginary_1: vec4<f32>;
        var slope_real: vec4<f32>;
        var slope_imaginary: vec4<f32>;
        var none: GaborSum = GaborSum(vec2(0f), vec2(0f), vec2(0f), vec4(0f), vec4(0f));
        var sum_1: GaborSum;
        var row_word: u32;
        var row_3: GaborSum;
        var row_word_1: u32;
        var row_4: GaborSum;
        var row_word_2: u32;
        var row_5: GaborSum;
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
        let _e36 = node;
        let _e40 = salt_3;
        let _e41 = gabor_impl_line_words(_e36.x, place.period.x, _e40);
        columns = _e41;
        let _e43 = node;
        let _e47 = salt_3;
        let _e50 = gabor_impl_line_words(_e43.y, place.period.y, (_e47 ^ 1540483477u));
        rows = _e50;
        let _e52 = kernel_1;
        let _e54 = offset;
        let _e61 = gabor_impl_wave(dot(_e52.wave, (_e54 * (vec2(1f) / place.radius))));
        base = _e61;
        let _e64 = gabor_impl_wave(place.time);
        time_1 = _e64;
        let _e66 = offset;
        let _e68 = gabor_impl_windows(_e66.x);
        x_1 = _e68;
        let _e70 = offset;
        let _e72 = gabor_impl_windows(_e70.y);
        y_1 = _e72;
        let _e76 = kernel_1;
        gabor_impl_node_waves(_e76.step_x, (&cosines_1), (&sines_1));
        let _e82 = x_1;
        let _e84 = cosines_1;
        real_1 = (_e82.value * _e84);
        let _e87 = x_1;
        let _e89 = sines_1;
        imaginary_1 = (_e87.value * _e89);
        let _e92 = x_1;
        let _e94 = cosines_1;
        slope_real = (_e92.slope * _e94);
        let _e97 = x_1;
        let _e99 = sines_1;
        slope_imaginary = (_e97.slope * _e99);
        let _e102 = kernel_1;
        gabor_impl_node_waves(_e102.step_y, (&cosines_1), (&sines_1));
        let _e120 = none;
        sum_1 = _e120;
        {
            let _e122 = rows;
            row_word = _e122.x;
            let _e125 = none;
            row_3 = _e125;
            let _e128 = columns;
            let _e130 = row_word;
            let _e131 = gabor_impl_node_word(_e128.x, _e130);
            let _e132 = x_1;
            let _e135 = real_1;
            let _e137 = imaginary_1;
            let _e140 = slope_real;
            let _e142 = slope_imaginary;
            let _e146 = time_1;
            gabor_impl_add_node((&row_3), _e131, _e132.value.x, vec2<f32>(_e135.x, _e137.x), vec2<f32>(_e140.x, _e142.x), place.animated, _e146);
            let _e149 = columns;
            let _e151 = row_word;
            let _e152 = gabor_impl_node_word(_e149.y, _e151);
            let _e153 = x_1;
            let _e156 = real_1;
            let _e158 = imaginary_1;
            let _e161 = slope_real;
            let _e163 = slope_imaginary;
            let _e167 = time_1;
            gabor_impl_add_node((&row_3), _e152, _e153.value.y, vec2<f32>(_e156.y, _e158.y), vec2<f32>(_e161.y, _e163.y), place.animated, _e167);
            let _e170 = columns;
            let _e172 = row_word;
            let _e173 = gabor_impl_node_word(_e170.z, _e172);
            let _e174 = x_1;
            let _e177 = real_1;
            let _e179 = imaginary_1;
            let _e182 = slope_real;
            let _e184 = slope_imaginary;
            let _e188 = time_1;
            gabor_impl_add_node((&row_3), _e173, _e174.value.z, vec2<f32>(_e177.z, _e179.z), vec2<f32>(_e182.z, _e184.z), place.animated, _e188);
            let _e191 = row_3;
            let _e192 = y_1;
            let _e195 = cosines_1;
            let _e197 = sines_1;
            let _e201 = y_1;
            let _e204 = cosines_1;
            let _e206 = sines_1;
            gabor_impl_add_row((&sum_1), _e191, (_e192.value.x * vec2<f32>(_e195.x, _e197.x)), (_e201.slope.x * vec2<f32>(_e204.x, _e206.x)));
        }
        {
            let _e211 = rows;
            row_word_1 = _e211.y;
            let _e214 = none;
            row_4 = _e214;
            let _e217 = columns;
            let _e219 = row_word_1;
            let _e220 = gabor_impl_node_word(_e217.x, _e219);
            let _e221 = x_1;
            let _e224 = real_1;
            let _e226 = imaginary_1;
            let _e229 = slope_real;
            let _e231 = slope_imaginary;
            let _e235 = time_1;
            gabor_impl_add_node((&row_4), _e220, _e221.value.x, vec2<f32>(_e224.x, _e226.x), vec2<f32>(_e229.x, _e231.x), place.animated, _e235);
            let _e238 = columns;
            let _e240 = row_word_1;
            let _e241 = gabor_impl_node_word(_e238.y, _e240);
            let _e242 = x_1;
            let _e245 = real_1;
            let _e247 = imaginary_1;
            let _e250 = slope_real;
            let _e252 = slope_imaginary;
            let _e256 = time_1;
            gabor_impl_add_node((&row_4), _e241, _e242.value.y, vec2<f32>(_e245.y, _e247.y), vec2<f32>(_e250.y, _e252.y), place.animated, _e256);
            let _e259 = columns;
            let _e261 = row_word_1;
            let _e262 = gabor_impl_node_word(_e259.z, _e261);
            let _e263 = x_1;
            let _e266 = real_1;
            let _e268 = imaginary_1;
            let _e271 = slope_real;
            let _e273 = slope_imaginary;
            let _e277 = time_1;
            gabor_impl_add_node((&row_4), _e262, _e263.value.z, vec2<f32>(_e266.z, _e268.z), vec2<f32>(_e271.z, _e273.z), place.animated, _e277);
            let _e280 = row_4;
            let _e281 = y_1;
            let _e284 = cosines_1;
            let _e286 = sines_1;
            let _e290 = y_1;
            let _e293 = cosines_1;
            let _e295 = sines_1;
            gabor_impl_add_row((&sum_1), _e280, (_e281.value.y * vec2<f32>(_e284.y, _e286.y)), (_e290.slope.y * vec2<f32>(_e293.y, _e295.y)));
        }
        {
            let _e300 = rows;
            row_word_2 = _e300.z;
            let _e303 = none;
            row_5 = _e303;
            let _e306 = columns;
            let _e308 = row_word_2;
            let _e309 = gabor_impl_node_word(_e306.x, _e308);
            let _e310 = x_1;
            let _e313 = real_1;
            let _e315 = imaginary_1;
            let _e318 = slope_real;
            let _e320 = slope_imaginary;
            let _e324 = time_1;
            gabor_impl_add_node((&row_5), _e309, _e310.value.x, vec2<f32>(_e313.x, _e315.x), vec2<f32>(_e318.x, _e320.x), place.animated, _e324);
            let _e327 = columns;
            let _e329 = row_word_2;
            let _e330 = gabor_impl_node_word(_e327.y, _e329);
            let _e331 = x_1;
            let _e334 = real_1;
            let _e336 = imaginary_1;
            let _e339 = slope_real;
            let _e341 = slope_imaginary;
            let _e345 = time_1;
            gabor_impl_add_node((&row_5), _e330, _e331.value.y, vec2<f32>(_e334.y, _e336.y), vec2<f32>(_e339.y, _e341.y), place.animated, _e345);
            let _e348 = columns;
            let _e350 = row_word_2;
            let _e351 = gabor_impl_node_word(_e348.z, _e350);
            let _e352 = x_1;
            let _e355 = real_1;
            let _e357 = imaginary_1;
            let _e360 = slope_real;
            let _e362 = slope_imaginary;
            let _e366 = time_1;
            gabor_impl_add_node((&row_5), _e351, _e352.value.z, vec2<f32>(_e355.z, _e357.z), vec2<f32>(_e360.z, _e362.z), place.animated, _e366);
            let _e369 = row_5;
            let _e370 = y_1;
            let _e373 = cosines_1;
            let _e375 = sines_1;
            let _e379 = y_1;
            let _e382 = cosines_1;
            let _e384 = sines_1;
            gabor_impl_add_row((&sum_1), _e369, (_e370.value.z * vec2<f32>(_e373.z, _e375.z)), (_e379.slope.z * vec2<f32>(_e382.z, _e384.z)));
        }
        let _e389 = base;
        base = (_e389 * 0.0000000028701348f);
        let _e396 = sum_1;
        let _e398 = base;
        let _e399 = gabor_impl_product(_e396.value, _e398);
        value = _e399;
        let _e402 = value;
        let _e405 = value;
        turned = (6.2831855f * vec2<f32>(-(_e402.y), _e405.x));
        stretch = (place.radius / vec2(1.5f));
        let _e418 = value;
        let _e419 = stretch;
        let _e421 = sum_1;
        let _e423 = base;
        let _e424 = gabor_impl_product(_e421.slope_x, _e423);
        let _e426 = kernel_1;
        let _e429 = turned;
        let _e432 = stretch;
        let _e434 = sum_1;
        let _e436 = base;
        let _e437 = gabor_impl_product(_e434.slope_y, _e436);
        let _e439 = kernel_1;
        let _e442 = turned;
        let _e445 = base;
        let _e447 = sum_1;
        let _e450 = base;
        let _e452 = sum_1;
        return GaborField(_e418, ((_e419.x * _e424) + (_e426.wave.x * _e429)), ((_e432.y * _e437) + (_e439.wave.y * _e442)), ((_e445.x * _e447.imaginary) + (_e450.y * _e452.real)));
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
        var wave: vec2<f32>;
        var step_1: vec2<f32>;

        let _e7 = gabor_impl_wave((0.15915494f * orientation));
        wave = (min(abs(frequency), 1000000f) * _e7);
        let _e10 = wave;
        step_1 = (_e10 * 1f);
        let _e19 = wave;
        let _e20 = step_1;
        let _e22 = gabor_impl_wave(_e20.x);
        let _e23 = step_1;
        let _e25 = gabor_impl_wave(_e23.y);
        return GaborKernel(_e19, _e22, _e25);
    } else if GABOR_TAPS == 4 {
        var wave: vec2<f32>;
        var step_1: vec2<f32>;

        let _e7 = gabor_impl_wave((0.15915494f * orientation));
        wave = (min(abs(frequency), 1000000f) * _e7);
        let _e10 = wave;
        step_1 = (_e10 * 0.5f);
        let _e19 = wave;
        let _e20 = step_1;
        let _e22 = gabor_impl_wave(_e20.x);
        let _e23 = step_1;
        let _e25 = gabor_impl_wave(_e23.y);
        return GaborKernel(_e19, _e22, _e25);
    } else {
        var wave: vec2<f32>;
        var step_1: vec2<f32>;

        let _e7 = gabor_impl_wave((0.15915494f * orientation));
        wave = (min(abs(frequency), 1000000f) * _e7);
        let _e10 = wave;
        step_1 = (_e10 * 0.6666667f);
        let _e19 = wave;
        let _e20 = step_1;
        let _e22 = gabor_impl_wave(_e20.x);
        let _e23 = step_1;
        let _e25 = gabor_impl_wave(_e23.y);
        return GaborKernel(_e19, _e22, _e25);
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
    if GABOR_TAPS == 2 {
        var period_3: vec2<f32>;
        var nodes: vec2<f32>;
        var radius: vec2<f32>;
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
        let _e29 = gabor_kernel(frequency, orientation);
        kernel_4 = _e29;
        let _e32 = kernel_4;
        let _e35 = radius;
        let _e38 = gabor_impl_wave((_e32.wave.x / _e35.x));
        kernel_4.step_x = _e38;
        let _e40 = kernel_4;
        let _e43 = radius;
        let _e46 = gabor_impl_wave((_e40.wave.y / _e43.y));
        kernel_4.step_y = _e46;
        let _e49 = radius;
        let _e51 = radius;
        let _e52 = nodes;
        place_1 = GaborPlace(vec2(0i), (p * _e49), _e51, vec2<i32>(_e52), false, 0f);
        let _e58 = place_1;
        let _e59 = kernel_4;
        let _e60 = gabor_field(_e58, _e59, seed);
        return _e60.value.y;
    } else if GABOR_TAPS == 4 {
        var period_3: vec2<f32>;
        var nodes: vec2<f32>;
        var radius: vec2<f32>;
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
        let _e29 = gabor_kernel(frequency, orientation);
        kernel_4 = _e29;
        let _e32 = kernel_4;
        let _e35 = radius;
        let _e38 = gabor_impl_wave((_e32.wave.x / _e35.x));
        kernel_4.step_x = _e38;
        let _e40 = kernel_4;
        let _e43 = radius;
        let _e46 = gabor_impl_wave((_e40.wave.y / _e43.y));
        kernel_4.step_y = _e46;
        let _e49 = radius;
        let _e51 = radius;
        let _e52 = nodes;
        place_1 = GaborPlace(vec2(0i), (p * _e49), _e51, vec2<i32>(_e52), false, 0f);
        let _e58 = place_1;
        let _e59 = kernel_4;
        let _e60 = gabor_field(_e58, _e59, seed);
        return _e60.value.y;
    } else {
        var period_3: vec2<f32>;
        var nodes: vec2<f32>;
        var radius: vec2<f32>;
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
        let _e29 = gabor_kernel(frequency, orientation);
        kernel_4 = _e29;
        let _e32 = kernel_4;
        let _e35 = radius;
        let _e38 = gabor_impl_wave((_e32.wave.x / _e35.x));
        kernel_4.step_x = _e38;
        let _e40 = kernel_4;
        let _e43 = radius;
        let _e46 = gabor_impl_wave((_e40.wave.y / _e43.y));
        kernel_4.step_y = _e46;
        let _e49 = radius;
        let _e51 = radius;
        let _e52 = nodes;
        place_1 = GaborPlace(vec2(0i), (p * _e49), _e51, vec2<i32>(_e52), false, 0f);
        let _e58 = place_1;
        let _e59 = kernel_4;
        let _e60 = gabor_field(_e58, _e59, seed);
        return _e60.value.y;
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
