// Generated from gabor_noise.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 3bf5c866679b011a.
//
// gabor_noise.wgsl: Gabor noise in the plane, with mean 0, variance 1 and a normal distribution at every point.
//
//     f32 n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//
//     I want                                   call
//     noise                                    gabor_noise(p, frequency, orientation, seed)
//     its derivatives                          gabor_noise_gradient
//     a texture that repeats                   gabor_noise_tiled
//     noise that evolves in place              gabor_noise_animated
//     stripes along any directions             gabor_stripes
//     a phase, for patterns of my own          gabor_turns_intensity(gabor_noise_quadrature(...))
//     to display it                            gabor_unorm
//     a huge world, or any of these together   a place, then gabor_field
//
// Values are normal up to three standard deviations. Values beyond 3.5 are 13 % too rare overall, and 56 % too rare at
// the nodes of the lattice.
//
// Arguments of all functions:
//     p            position in kernel radii, |p| < 2^31 / GABOR_CELLS_PER_RADIUS. Float rounding shows earlier: at
//                  10^5, p has steps of 0.008. Each wave fades out within one kernel radius of its node.
//     frequency    cycles per kernel radius, up to 10^6; the sign is ignored
//     orientation  direction of the wave vector, in radians from +x towards +y. At frequency 4, rounding adds an error
//                  of up to 8e-6 to the noise for each radian.
//     wave         wave vector in cycles per kernel radius, up to 10^6 along each axis. It replaces frequency and
//                  orientation: gabor_wave_vector converts them. (0, 0) gives noise of frequency 0.
//     period       kernel radii along x and y after which the noise repeats exactly, 1/1024 to 10^9. Kernels shrink to
//                  fit a period below 2; to fit a longer one, their size changes by at most a sixth with GABOR_TAPS 3.
//     seed         any number; different seeds give independent noises
// Frequency, orientation and wave may vary with p; where they are continuous, so is the noise. If a direction map
// jumps, gabor_direction.wgsl keeps stripes unbroken. NaN gives an unspecified value.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

const GABOR_NOISE_VERSION: u32 = 30000u;

// f32 gabor_noise(vec2f p, f32 frequency, f32 orientation, u32 seed)
// f32 gabor_noise_tiled(vec2f p, vec2f period, f32 frequency, f32 orientation, u32 seed)
//     The noise, with continuous first derivatives.

// f32 gabor_noise_animated(vec2f p, f32 evolution, f32 frequency, f32 orientation, u32 seed)
//     Noise that evolves in place and repeats when `evolution` grows by 1; 0 gives gabor_noise. Values t apart have the
//     correlation cos^2(pi t). Costs about twice as much as gabor_noise. Pass the fraction of a large evolution: a
//     f32 has so few digits at 1000 that the noise errs by 4e-4.

// vec3f gabor_noise_gradient(vec2f p, f32 frequency, f32 orientation, u32 seed)
//     (noise, d/dx, d/dy). The derivatives are per kernel radius, for a constant wave vector.

// vec2f gabor_noise_quadrature(vec2f p, f32 frequency, f32 orientation, u32 seed)
//     (noise, quadrature). The quadrature is the same waves with cosines instead of sines: the two are the imaginary
//     and the real part of a complex noise. At each point they are independent and have variance 1.

// vec2f gabor_turns_intensity(vec2f noise_quadrature)
//     (phase in turns within [0, 1), intensity) of what gabor_noise_quadrature returns. A profile of the phase, such as
//     step(phase, width), is a pattern of even contrast [Tricard et al., "Procedural phasor noise", 2019].

// vec3f gabor_stripes(vec2f p, vec2f wave, f32 sharpness, u32 seed)
//     Stripes of even contrast, at right angles to the wave vector: (cosine, sine, intensity). Sharpness is 0 to 10^6;
//     2 is a good value. If z is the complex noise, the intensity is |z|, and (cosine, sine) is z / |z| where |z|
//     exceeds 1 / sharpness. Elsewhere it is sharpness times z, so stripes fade where they fork.

// f32 gabor_unorm(f32 noise)
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// u32 gabor_derived_seed(u32 seed, i32 index)
//     The seed of part `index` of anything made of independent noises, such as octaves, which need a seed each: with
//     one seed, frequencies 4 and 8 have a correlation of 0.86 at the nodes of the lattice.

// ---- Any position, wave vector, period and evolution ----------------------------------------------------------------

// A position in node spacings of the lattice, with a period and an evolution.
struct GaborPlace {
    cell: vec2<i32>, // any integers except the last few before 2^31, where the world wraps around
    local: vec2<f32>, // offset from that cell's corner in node spacings, most precise in [0, 1)^2
    cells_per_radius: vec2<f32>, // along each axis: GABOR_CELLS_PER_RADIUS, or slightly different to fit a period
    period: vec2<i32>, // period in nodes, 0 for none
    evolution: f32, // as in gabor_noise_animated, in turns. Set it after calling a constructor, which sets 0
}

// GaborPlace gabor_place_at(vec2f p)
//     The position p, in kernel radii.

// GaborPlace gabor_place(vec2i cell, vec2f local)
//     The position (cell + local) / GABOR_CELLS_PER_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells
//     along each axis.

// GaborPlace gabor_place_tiled(vec2f p, vec2f period)
//     The position p in noise that repeats after `period` kernel radii; an axis whose period is 0 is endless. A
//     period holds a whole number of nodes, from GABOR_TAPS to 2^31. Opposite edges differ by up to 1.5e-4 where a
//     compiler contracts multiplications and additions.

// vec2f gabor_wave_vector(f32 frequency, f32 orientation)
//     The wave vector with a frequency and orientation; their ranges are those of gabor_noise.

// A noise, its quadrature, and their gradients per kernel radius: see gabor_noise_quadrature. Unused members cost
// nothing.
struct GaborField {
    noise: f32,
    gradient: vec2<f32>,
    quadrature: f32,
    quadrature_gradient: vec2<f32>,
    removed: f32, // share of the variance that a filter removed, 0 without one: see gabor_filter.wgsl
}

// GaborField gabor_field(GaborPlace place, vec2f wave, u32 seed)
//     The noise at `place`. All other functions call it.

// vec3f gabor_stripes_of(GaborField field, f32 sharpness)
//     The stripes of any noise, like gabor_stripes. If a filter removed variance, each value is its mean over what was
//     removed, within 0.1: (cosine, sine) gets shorter, and its profiles fade to their mean.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// The nodes (x_k, y_j) of a square lattice with R = GABOR_CELLS_PER_RADIUS nodes per kernel radius have independent,
// normal, complex amplitudes A_kj. Each node emits a wave under a window that ends one kernel radius away along both
// axes:
//
//     n(p) = K Im sum_kj A_kj h(x - x_k) h(y - y_j) exp(2 pi i F.(p - (x_k, y_j))),   F = frequency (cos o, sin o).
//
// The window is Hann's, h(d) = (1 + cos pi d) / 2. GABOR_TAPS of its shifts overlap at every x. Three or more evenly
// spaced shifts of cos and of cos^2 over a period sum to a constant, so that
//
//     sum_k h(x - x_k)^2 = 3/8 GABOR_TAPS   at every x.
//
// The squares of the window's derivatives also sum to a constant. So the variances of the noise, its gradient and its
// second derivatives are the same at every point; that of the noise does not depend on the frequency either. The second
// derivatives jump where windows end, midway between nodes for 3 taps and at nodes for 4: by 0.16 of their standard
// deviation at frequency 1, and by 1.1 at frequency 0. The noise is normal because sums of independent normal variables
// are normal.
//
// Each wave's phase starts at its own node, so the wave vector F may vary with the position. From one node to the next,
// the phase turns by u = 2 pi F_x / R along x and v = 2 pi F_y / R along y. If node (0, 0) is next to p, the sum
// separates into one sum per axis:
//
//     n(p) = K Im e^(2 pi i F.(p - (x_0, y_0))) sum_j h(y - y_j) e^(-i v j) sum_k h(x - x_k) e^(-i u k) A_kj.
//
// After [TNVT19] Tavernier, Neyret, Vergne, Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019.

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Hashes a word; each salt gives a different sequence. The constants are from the hash-prospector project.
fn gabor_impl_mix(word: u32, salt: u32) -> u32 {
    var once: u32;
    var twice: u32;
    once = (((word ^ (word >> 16u)) * 569420461u) + salt);
    let _e9 = once;
    let _e10 = once;
    twice = ((_e9 ^ (_e10 >> 15u)) * 3545902487u);
    let _e17 = twice;
    let _e18 = twice;
    return (_e17 ^ (_e18 >> 15u));
}

fn gabor_derived_seed(seed: u32, index: i32) -> u32 {
    let _e7 = gabor_impl_mix((seed + (u32(index) * 2246822507u)), 2654435761u);
    return _e7;
}

// The salt of the columns; xor it with GABOR_IMPL_ROWS to get the salt of the rows. With equal salts, the word of node
// (k, k) would be a square.
fn gabor_impl_salt(seed: u32) -> u32 {
    let _e4 = gabor_impl_mix((seed * 2654435761u), 625341585u);
    return _e4;
}

// The word of a column or row of nodes; a node's word is the product of its column's and its row's. The words of
// columns and rows are odd and have 24 bits, because GPUs multiply such numbers at a quarter of the cost of 32-bit
// numbers. Their highest bit is set, so that products fill all 32 bits. The factor (word ^ (word >> 15)) mixes better
// than a constant: two indices, however far apart, have equal words with probability 2^-22.
fn gabor_impl_line_word(index: i32, salt: u32) -> u32 {
    var word_1: u32;
    word_1 = ((u32(index) * 2654435761u) + salt);
    let _e7 = word_1;
    let _e8 = word_1;
    let _e9 = word_1;
    return (((_e7 * (_e8 ^ (_e9 >> 15u))) >> 8u) | 8388609u);
}

// Computes an amplitude from a word: the real part from the whole word, the imaginary part from its low 20 bits. They
// are independent and nearly normal. For u uniform in [-1, 1], the quantiles of (u - 0.893 clamp(u, -0.937, 0.937))
// (1 + 0.623 u^2) are nearly proportional to those of a normal distribution. The noise's Cramer-von Mises index
// [TNVT19] is 0.001 on average. At the worst point, a node, it is 0.03, because 79 % of the power there comes from that
// node's amplitude.
fn gabor_impl_amplitude(word: u32) -> vec2<f32> {
    var u: vec2<f32>;
    u = vec2<f32>(f32(i32(word)), f32(i32((word << 12u))));
    let _e9 = u;
    let _e11 = u;
    let _e20 = u;
    let _e21 = u;
    return ((_e9 - (0.89289314f * clamp(_e11, vec2(-2011925800f), vec2(2011925800f)))) * ((_e20 * _e21) + vec2(7397391600000000000f)));
}

// Derives four more words from a row's word. Multiplied by a column's word, each is as random as a node's own word.
fn gabor_impl_row(word: u32) -> vec4<u32> {
    var first: u32;
    var second: u32;
    var third: u32;
    var fourth: u32;
    first = ((word ^ (word >> 15u)) * 3545902487u);
    let _e7 = first;
    let _e8 = first;
    second = ((_e7 ^ (_e8 >> 15u)) * 3545902487u);
    let _e15 = second;
    let _e16 = second;
    third = ((_e15 ^ (_e16 >> 15u)) * 3545902487u);
    let _e23 = third;
    let _e24 = third;
    fourth = ((_e23 ^ (_e24 >> 15u)) * 3545902487u);
    let _e31 = first;
    let _e36 = second;
    let _e41 = third;
    let _e46 = fourth;
    return vec4<u32>(((_e31 >> 8u) | 8388609u), ((_e36 >> 8u) | 8388609u), ((_e41 >> 8u) | 8388609u), ((_e46 >> 8u) | 8388609u));
}

// ---- Waves and windows ---------------------------------------------------------------------------------------------

// The product of two complex numbers.
fn gabor_impl_product(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return ((a.x * b) + (a.y * vec2<f32>(-(b.y), b.x)));
}

// Adds z times a pair of complex numbers to two sums.
fn gabor_impl_add_products(sums: ptr<function, vec4<f32>>, pair: vec4<f32>, z: vec2<f32>) {
    let _e3 = (*sums);
    (*sums) = ((_e3 + (z.x * pair)) + (z.y * vec4<f32>(-(pair.y), pair.x, -(pair.w), pair.z)));
    return;
}

// (cos, sin) of 2 pi t for |t| <= 1/4, by minimax polynomials, within 2e-7.
fn gabor_impl_half_turn(t: f32) -> vec2<f32> {
    var s: f32;
    var r: f32;
    s = (t * t);
    let _e3 = s;
    let _e4 = s;
    r = (_e3 * _e4);
    let _e9 = s;
    let _e12 = r;
    let _e15 = s;
    let _e19 = r;
    let _e26 = s;
    let _e29 = r;
    let _e32 = s;
    let _e36 = r;
    return vec2<f32>(((1f - (19.73917f * _e9)) + (_e12 * ((64.93459f - (85.24033f * _e15)) + (56.24243f * _e19)))), (t * ((6.283185f - (41.341656f * _e26)) + (_e29 * ((81.601006f - (76.54978f * _e32)) + (39.53671f * _e36))))));
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1]; beyond that, the rounding of t adds to the error. After t is
// reduced to [-1/2, 1/2], cos(2 pi t) = sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), where y = 1/4 - |t|.
fn gabor_impl_wave(t: f32) -> vec2<f32> {
    var within: f32;
    var turn: vec2<f32>;
    var local: f32;
    within = (t - floor((t + 0.5f)));
    let _e7 = within;
    let _e10 = gabor_impl_half_turn((0.25f - abs(_e7)));
    turn = _e10;
    let _e12 = turn;
    let _e14 = within;
    if (_e14 < 0f) {
        let _e17 = turn;
        local = -(_e17.x);
    } else {
        let _e20 = turn;
        local = _e20.x;
    }
    let _e23 = local;
    return vec2<f32>(_e12.y, _e23);
}

// Computes the windows of the nodes k = -1, 0, ... along an axis, h = 1/2 + cos(pi (x - k) / R) / 2, and their
// derivatives per kernel radius. x is in node spacings from node 0: in [-1/2, 1/2] for three taps, [0, 1] for four and
// [-1, 0] for two.
fn gabor_impl_windows(x: f32, value: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>) {
    var y: f32;
    var c: f32;
    var s_1: f32;
    var a_1: f32;
    var b_1: f32;
    y = (x * x);
    let _e6 = y;
    let _e8 = y;
    let _e10 = y;
    c = (0.5f - (_e6 * (1.09661f - (_e8 * (0.40054825f - (_e10 * 0.05644487f))))));
    let _e20 = y;
    let _e22 = y;
    let _e24 = y;
    s_1 = (x * (0.9068996f - (_e20 * (0.66301125f - (_e22 * (0.14532053f - (_e24 * 0.01467483f)))))));
    let _e36 = c;
    a_1 = (0.5f - (0.5f * _e36));
    let _e41 = s_1;
    b_1 = (1.8137994f * _e41);
    let _e44 = a_1;
    let _e45 = s_1;
    let _e48 = c;
    let _e50 = a_1;
    let _e51 = s_1;
    (*value) = vec4<f32>((_e44 - _e45), (0.5f + _e48), (_e50 + _e51), 0f);
    let _e55 = b_1;
    let _e57 = c;
    let _e62 = b_1;
    let _e64 = b_1;
    let _e66 = c;
    (*slope) = vec4<f32>((_e55 - (2.720699f * _e57)), (-2f * _e62), (_e64 + (2.720699f * _e66)), 0f);
    return;
}

// The power of a noise that replaces another as x goes from 0 to 1. If the power were x itself, the amplitudes would be
// square roots, with infinite slopes at the ends.
fn gabor_impl_takeover(x: f32) -> f32 {
    return ((x * x) / ((x * x) + ((1f - x) * (1f - x))));
}

// ---- The sum -------------------------------------------------------------------------------------------------------

// Wraps an index into a period.
fn gabor_impl_wrap(index: i32, period: i32) -> i32 {
    var index_3: i32;
    index_3 = index;
    if (period != 0i) {
        {
            let _e5 = index_3;
            let _e6 = index_3;
            index_3 = (_e5 - ((_e6 / max(period, 1i)) * period));
            let _e12 = index_3;
            if (_e12 < 0i) {
                let _e15 = index_3;
                index_3 = (_e15 + period);
            }
        }
    }
    let _e17 = index_3;
    return _e17;
}

// The next index, wrapped into a period without a division.
fn gabor_impl_next_node(index: i32, period: i32) -> i32 {
    var local_1: i32;
    if ((period == 0i) || ((index + 1i) < period)) {
        local_1 = (index + 1i);
    } else {
        local_1 = 0i;
    }
    let _e12 = local_1;
    return _e12;
}

// The nodes along an axis whose windows reach a point.
struct GaborAxis {
    offset: f32, // offset of the point from node 0, in node spacings
    turns: f32, // turns of the wave from one node to the next
    word: array<u32, 4>,
    node: array<vec4<f32>, 4>, // for node k, e^(-i u k) times the window, and times the window's derivative
}

// `wave` is in cycles per kernel radius, `radius` in nodes per kernel radius.
fn gabor_impl_axis(cell: i32, local: f32, period: i32, salt: u32, wave: f32, radius: f32) -> GaborAxis {
    var axis: GaborAxis;
    var zero: f32;
    var index_5: i32;
    var value_1: vec4<f32>;
    var slope_1: vec4<f32>;
    var turn_1: vec2<f32>;
    var back: vec2<f32>;
    var twice_1: vec2<f32>;
    zero = floor((local + 0.5f));
    let _e17 = zero;
    axis.offset = clamp((local - _e17), -0.5f, 0.5f);
    axis.turns = (wave / radius);
    let _e34 = zero;
    let _e39 = gabor_impl_wrap(((cell + i32(_e34)) - 1i), period);
    index_5 = _e39;
    let _e44 = index_5;
    let _e45 = gabor_impl_line_word(_e44, salt);
    axis.word[0i] = _e45;
    let _e46 = index_5;
    let _e47 = gabor_impl_next_node(_e46, period);
    index_5 = _e47;
    let _e51 = index_5;
    let _e52 = gabor_impl_line_word(_e51, salt);
    axis.word[1i] = _e52;
    let _e53 = index_5;
    let _e54 = gabor_impl_next_node(_e53, period);
    index_5 = _e54;
    let _e58 = index_5;
    let _e59 = gabor_impl_line_word(_e58, salt);
    axis.word[2i] = _e59;
    let _e63 = index_5;
    let _e64 = gabor_impl_next_node(_e63, period);
    let _e65 = gabor_impl_line_word(_e64, salt);
    axis.word[3i] = _e65;
    let _e68 = axis;
    gabor_impl_windows(_e68.offset, (&value_1), (&slope_1));
    let _e74 = axis;
    let _e76 = gabor_impl_wave(_e74.turns);
    turn_1 = _e76;
    let _e78 = turn_1;
    let _e80 = turn_1;
    back = vec2<f32>(_e78.x, -(_e80.y));
    let _e85 = back;
    let _e86 = back;
    let _e87 = gabor_impl_product(_e85, _e86);
    twice_1 = _e87;
    let _e92 = value_1;
    let _e94 = turn_1;
    let _e95 = (_e92.x * _e94);
    let _e96 = slope_1;
    let _e98 = turn_1;
    let _e99 = (_e96.x * _e98);
    axis.node[0i] = vec4<f32>(_e95.x, _e95.y, _e99.x, _e99.y);
    let _e108 = value_1;
    let _e111 = slope_1;
    axis.node[1i] = vec4<f32>(_e108.y, 0f, _e111.y, 0f);
    let _e118 = value_1;
    let _e120 = back;
    let _e121 = (_e118.z * _e120);
    let _e122 = slope_1;
    let _e124 = back;
    let _e125 = (_e122.z * _e124);
    axis.node[2i] = vec4<f32>(_e121.x, _e121.y, _e125.x, _e125.y);
    let _e134 = value_1;
    let _e136 = twice_1;
    let _e137 = (_e134.w * _e136);
    let _e138 = slope_1;
    let _e140 = twice_1;
    let _e141 = (_e138.w * _e140);
    axis.node[3i] = vec4<f32>(_e137.x, _e137.y, _e141.x, _e141.y);
    let _e147 = axis;
    return _e147;
}

// The amplitude of a node at an evolution. It is a weighted sum of three amplitudes, from the node's word and two words
// derived from it. The squared weights sum to 1; at evolution 0 the weights are 1, 0, 0. A return within the branch
// would take FXC four times as long through ANGLE.
fn gabor_impl_amplitude_at(word: u32, evolution: f32) -> vec2<f32> {
    var amplitude: vec2<f32>;
    var second_1: u32;
    var third_1: u32;
    var turn_2: vec2<f32>;
    let _e2 = gabor_impl_amplitude(word);
    amplitude = _e2;
    if (evolution != 0f) {
        {
            second_1 = ((word ^ (word >> 15u)) * 3545902487u);
            let _e12 = second_1;
            let _e13 = second_1;
            third_1 = ((_e12 ^ (_e13 >> 15u)) * 3545902487u);
            let _e20 = gabor_impl_wave(evolution);
            turn_2 = _e20;
            let _e24 = turn_2;
            let _e28 = amplitude;
            let _e32 = turn_2;
            let _e36 = second_1;
            let _e37 = gabor_impl_amplitude(_e36);
            let _e41 = turn_2;
            let _e44 = third_1;
            let _e45 = gabor_impl_amplitude(_e44);
            amplitude = ((((0.5f + (0.5f * _e24.x)) * _e28) + ((0.5f - (0.5f * _e32.x)) * _e37)) + ((0.70710677f * _e41.y) * _e45));
        }
    }
    let _e48 = amplitude;
    return _e48;
}

// Adds row j of nodes to `sum`, weighted by the windows along y, and to `slope`, weighted by the derivatives of these
// windows. In both, xy uses the windows along x, and zw their derivatives. Some compilers do not unroll or vectorize
// loops over nodes and rows, so each node and each row has its own line.
fn gabor_impl_add_node_row(sum: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>, x: GaborAxis, y: GaborAxis, j: i32, evolution: f32) {
    var row: vec4<f32> = vec4(0f);
    let _e19 = gabor_impl_amplitude_at((x.word[0] * y.word[j]), evolution);
    gabor_impl_add_products((&row), x.node[0], _e19);
    let _e31 = gabor_impl_amplitude_at((x.word[1] * y.word[j]), evolution);
    gabor_impl_add_products((&row), x.node[1], _e31);
    if true {
        let _e46 = gabor_impl_amplitude_at((x.word[2] * y.word[j]), evolution);
        gabor_impl_add_products((&row), x.node[2], _e46);
    }
    if false {
        let _e61 = gabor_impl_amplitude_at((x.word[3] * y.word[j]), evolution);
        gabor_impl_add_products((&row), x.node[3], _e61);
    }
    if ((true && (j != 1i)) || (x.offset < 8f)) {
        {
            let _e74 = row;
            gabor_impl_add_products(sum, _e74, y.node[j].xy);
            let _e80 = row;
            gabor_impl_add_products(slope, _e80, y.node[j].zw);
            return;
        }
    } else {
        return;
    }
}

fn gabor_impl_sum(x: GaborAxis, y: GaborAxis, evolution: f32, sum: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>) {
    let _e6 = vec4(0f);
    (*slope) = _e6;
    (*sum) = _e6;
    gabor_impl_add_node_row(sum, slope, x, y, 0i, evolution);
    gabor_impl_add_node_row(sum, slope, x, y, 1i, evolution);
    if true {
        gabor_impl_add_node_row(sum, slope, x, y, 2i, evolution);
    }
    if false {
        gabor_impl_add_node_row(sum, slope, x, y, 3i, evolution);
        return;
    } else {
        return;
    }
}

// Multiplies the sums by K and by the wave at the point, whose phase is 0 at node (0, 0). K makes E[n^2] = 1: E[n^2] is
// K^2 / 2 E|A|^2 times the sums of squared windows along x and y. A wave's derivative is the wave times 2 pi i F.
fn gabor_impl_field(sum: vec4<f32>, slope: vec4<f32>, turn: vec2<f32>, wave: vec2<f32>, stretch: vec2<f32>) -> GaborField {
    var turn_4: vec2<f32>;
    var local_3: f32;
    var value_2: vec2<f32>;
    var turned: vec2<f32>;
    var along_x: vec2<f32>;
    var along_y: vec2<f32>;
    turn_4 = turn;
    let _e6 = turn_4;
    if false {
        local_3 = 1f;
    } else {
        local_3 = 1.125f;
    }
    let _e18 = local_3;
    turn_4 = (_e6 * (1f / (1459955300000000000000000000f * _e18)));
    let _e23 = turn_4;
    let _e24 = gabor_impl_product(sum.xy, _e23);
    value_2 = _e24;
    let _e27 = value_2;
    let _e30 = value_2;
    turned = (6.2831855f * vec2<f32>(-(_e27.y), _e30.x));
    let _e37 = turn_4;
    let _e38 = gabor_impl_product(sum.zw, _e37);
    let _e41 = turned;
    along_x = ((stretch.x * _e38) + (wave.x * _e41));
    let _e47 = turn_4;
    let _e48 = gabor_impl_product(slope.xy, _e47);
    let _e51 = turned;
    along_y = ((stretch.y * _e48) + (wave.y * _e51));
    let _e55 = value_2;
    let _e57 = along_x;
    let _e59 = along_y;
    let _e62 = value_2;
    let _e64 = along_x;
    let _e66 = along_y;
    return GaborField(_e55.y, vec2<f32>(_e57.y, _e59.y), _e62.x, vec2<f32>(_e64.x, _e66.x), 0f);
}

fn gabor_field(place: GaborPlace, wave: vec2<f32>, seed: u32) -> GaborField {
    var wave_3: vec2<f32>;
    var salt_3: u32;
    var x_4: GaborAxis;
    var y_3: GaborAxis;
    var turn_5: vec2<f32>;
    var sum_3: vec4<f32>;
    var slope_5: vec4<f32>;
    wave_3 = wave;
    let _e4 = wave_3;
    wave_3 = clamp(_e4, vec2(-1000000f), vec2(1000000f));
    let _e11 = gabor_impl_salt(seed);
    salt_3 = _e11;
    let _e19 = salt_3;
    let _e20 = wave_3;
    let _e24 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e19, _e20.x, place.cells_per_radius.x);
    x_4 = _e24;
    let _e26 = salt_3;
    salt_3 = (_e26 ^ 1540483477u);
    let _e35 = salt_3;
    let _e36 = wave_3;
    let _e40 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, _e35, _e36.y, place.cells_per_radius.y);
    y_3 = _e40;
    let _e42 = x_4;
    let _e44 = x_4;
    let _e47 = y_3;
    let _e49 = y_3;
    let _e53 = gabor_impl_wave(((_e42.offset * _e44.turns) + (_e47.offset * _e49.turns)));
    turn_5 = _e53;
    let _e57 = x_4;
    let _e58 = y_3;
    gabor_impl_sum(_e57, _e58, place.evolution, (&sum_3), (&slope_5));
    let _e64 = sum_3;
    let _e65 = slope_5;
    let _e66 = turn_5;
    let _e67 = wave_3;
    let _e75 = gabor_impl_field(_e64, _e65, _e66, _e67, (place.cells_per_radius / vec2(1.5f)));
    return _e75;
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
fn gabor_impl_add_field(sum: ptr<function, GaborField>, field: GaborField, amplitude: f32, stretch: vec2<f32>) {
    let _e5 = (*sum);
    (*sum).noise = (_e5.noise + (amplitude * field.noise));
    let _e11 = (*sum);
    (*sum).gradient = (_e11.gradient + ((amplitude * stretch) * field.gradient));
    let _e18 = (*sum);
    (*sum).quadrature = (_e18.quadrature + (amplitude * field.quadrature));
    let _e24 = (*sum);
    (*sum).quadrature_gradient = (_e24.quadrature_gradient + ((amplitude * stretch) * field.quadrature_gradient));
    let _e31 = (*sum);
    (*sum).removed = (_e31.removed + ((amplitude * amplitude) * field.removed));
    return;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_place(cell: vec2<i32>, local: vec2<f32>) -> GaborPlace {
    return GaborPlace(cell, local, vec2(1.5f), vec2(0i), 0f);
}

fn gabor_place_at(p: vec2<f32>) -> GaborPlace {
    let _e8 = gabor_place(vec2(0i), (p * 1.5f));
    return _e8;
}

fn gabor_place_tiled(p: vec2<f32>, period: vec2<f32>) -> GaborPlace {
    var side: vec2<f32>;
    var nodes: vec2<f32>;
    var place_1: GaborPlace;
    var local_5: f32;
    var local_6: f32;
    var local_7: i32;
    var local_8: i32;
    side = clamp(period, vec2(0.0009765625f), vec2(1000000000f));
    let _e8 = side;
    nodes = max(floor(((_e8 * 1.5f) + vec2(0.5f))), vec2(3f));
    let _e27 = gabor_place(vec2(0i), vec2(0f));
    place_1 = _e27;
    if (period.x > 0f) {
        let _e33 = nodes;
        let _e35 = side;
        local_5 = (_e33.x / _e35.x);
    } else {
        local_5 = 1.5f;
    }
    let _e43 = local_5;
    if (period.y > 0f) {
        let _e47 = nodes;
        let _e49 = side;
        local_6 = (_e47.y / _e49.y);
    } else {
        local_6 = 1.5f;
    }
    let _e57 = local_6;
    place_1.cells_per_radius = vec2<f32>(_e43, _e57);
    if (period.x > 0f) {
        let _e63 = nodes;
        local_7 = i32(_e63.x);
    } else {
        local_7 = 0i;
    }
    let _e68 = local_7;
    if (period.y > 0f) {
        let _e72 = nodes;
        local_8 = i32(_e72.y);
    } else {
        local_8 = 0i;
    }
    let _e77 = local_8;
    place_1.period = vec2<i32>(_e68, _e77);
    let _e80 = place_1;
    place_1.local = (p * _e80.cells_per_radius);
    let _e83 = place_1;
    return _e83;
}

fn gabor_wave_vector(frequency: f32, orientation: f32) -> vec2<f32> {
    let _e11 = gabor_impl_wave((0.15915494f * clamp(orientation, -1000000f, 1000000f)));
    return (min(abs(frequency), 1000000f) * _e11);
}

fn gabor_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    let _e4 = gabor_place_at(p);
    let _e5 = gabor_wave_vector(frequency, orientation);
    let _e6 = gabor_field(_e4, _e5, seed);
    return _e6.noise;
}

fn gabor_noise_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    let _e5 = gabor_place_tiled(p, period);
    let _e6 = gabor_wave_vector(frequency, orientation);
    let _e7 = gabor_field(_e5, _e6, seed);
    return _e7.noise;
}

fn gabor_noise_animated(p: vec2<f32>, evolution: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place_2: GaborPlace;
    let _e5 = gabor_place_at(p);
    place_2 = _e5;
    place_2.evolution = evolution;
    let _e8 = place_2;
    let _e9 = gabor_wave_vector(frequency, orientation);
    let _e10 = gabor_field(_e8, _e9, seed);
    return _e10.noise;
}

fn gabor_noise_gradient(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    var field_1: GaborField;
    let _e4 = gabor_place_at(p);
    let _e5 = gabor_wave_vector(frequency, orientation);
    let _e6 = gabor_field(_e4, _e5, seed);
    field_1 = _e6;
    let _e8 = field_1;
    let _e10 = field_1;
    return vec3<f32>(_e8.noise, _e10.gradient.x, _e10.gradient.y);
}

fn gabor_noise_quadrature(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    var field_2: GaborField;
    let _e4 = gabor_place_at(p);
    let _e5 = gabor_wave_vector(frequency, orientation);
    let _e6 = gabor_field(_e4, _e5, seed);
    field_2 = _e6;
    let _e8 = field_2;
    let _e10 = field_2;
    return vec2<f32>(_e8.noise, _e10.quadrature);
}

fn gabor_turns_intensity(noise_quadrature: vec2<f32>) -> vec2<f32> {
    var intensity: f32;
    var local_9: f32;
    var phase: f32;
    var local_10: f32;
    intensity = length(noise_quadrature.yx);
    let _e4 = intensity;
    if (_e4 > 0f) {
        local_9 = (atan2(noise_quadrature.x, noise_quadrature.y) * 0.15915494f);
    } else {
        local_9 = 0f;
    }
    let _e14 = local_9;
    phase = _e14;
    let _e16 = phase;
    if (_e16 < 0f) {
        let _e19 = phase;
        local_10 = min((_e19 + 1f), 0.99999994f);
    } else {
        let _e24 = phase;
        local_10 = _e24;
    }
    let _e26 = local_10;
    let _e27 = intensity;
    return vec2<f32>(_e26, _e27);
}

// For z = v + sqrt(r) times a complex normal number with independent parts, the mean of z / |z| is about
// v / sqrt(|v|^2 + 8/pi r), and the mean of |z| about sqrt(|v|^2 + pi/2 r). Both are exact for small and for large |v|.
fn gabor_stripes_of(field: GaborField, sharpness: f32) -> vec3<f32> {
    var value_3: vec2<f32>;
    var power: f32;
    var removed: f32;
    var reach: f32;
    value_3 = vec2<f32>(field.quadrature, field.noise);
    let _e6 = value_3;
    let _e7 = value_3;
    power = dot(_e6, _e7);
    removed = max(field.removed, 0f);
    let _e14 = power;
    let _e16 = removed;
    reach = sqrt((_e14 + (2.546479f * _e16)));
    let _e21 = reach;
    let _e26 = value_3;
    let _e27 = ((sharpness / max((sharpness * _e21), 1f)) * _e26);
    let _e28 = power;
    let _e30 = removed;
    return vec3<f32>(_e27.x, _e27.y, sqrt((_e28 + (1.5707963f * _e30))));
}

fn gabor_stripes(p: vec2<f32>, wave: vec2<f32>, sharpness: f32, seed: u32) -> vec3<f32> {
    let _e4 = gabor_place_at(p);
    let _e5 = gabor_field(_e4, wave, seed);
    let _e6 = gabor_stripes_of(_e5, sharpness);
    return _e6;
}

fn gabor_unorm(noise: f32) -> f32 {
    return clamp((0.5f + (0.25f * noise)), 0f, 1f);
}

