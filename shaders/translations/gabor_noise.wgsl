// Generated from gabor_noise.glsl by tools/translate, for WGSL: change that file, not this one.
// For another GABOR_TAPS: tools/translate wgsl shaders/gabor_noise.glsl -DGABOR_TAPS=NUMBER -o FOLDER
//
// gabor_noise.wgsl: Gabor noise in the plane, with mean 0, variance 1 and a normal distribution at every point.
//
//     let n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//
//     I want                                   call
//     noise                                    gabor_noise(p, frequency, orientation, seed)
//     its derivatives                          gabor_noise_gradient
//     a texture that repeats                   gabor_noise_tiled
//     noise that evolves in place              gabor_noise_animated
//     stripes along any directions             gabor_stripes
//     a phase, for patterns of my own          gabor_turns_intensity(gabor_noise_quadrature(...))
//     a value in [0, 1], or a share of area    gabor_uniform
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
//                  of up to 2.4e-6 to the noise for each radian.
//     wave         wave vector in cycles per kernel radius, up to 10^6 along each axis. It replaces frequency and
//                  orientation: gabor_wave_vector converts them. (0, 0) gives noise of frequency 0.
//     period       kernel radii along x and y after which the noise repeats exactly, 1/1024 to 10^9. Kernels shrink to
//                  fit a period below 2; to fit a longer one, their size changes by at most a sixth with GABOR_TAPS 3.
//     seed         any number; different seeds give independent noises
// Frequency, orientation and wave may vary with p; where they are continuous, so is the noise. If a direction map
// jumps, gabor_direction.wgsl keeps stripes unbroken. NaN gives an unspecified value.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// 10000 major + 100 minor + patch
const GABOR_NOISE_VERSION: i32 = 30000;

// Quality: each point sums GABOR_TAPS^2 waves. To change GABOR_TAPS, define it before this file. 2 is fastest, but
// shows columns and rows at high frequencies, and at nodes its values end at 2.89, with a Cramer-von Mises index of
// 6.1. The covariance of two points deviates from its mean over positions by up to 5.6 % of the variance with 3 taps,
// and by 1.5 % with 4; positions differ by up to twice as much.
const GABOR_TAPS: i32 = 3;
const_assert !(GABOR_TAPS < 2 || GABOR_TAPS > 4); // GABOR_TAPS must be 2, 3 or 4

// fn gabor_noise(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32
// fn gabor_noise_tiled(p: vec2f, period: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32
//     The noise, with continuous first derivatives.

// fn gabor_noise_animated(p: vec2f, evolution: f32, frequency: f32, orientation: f32, seed: u32) -> f32
//     Noise that evolves in place and repeats when `evolution` grows by 1; 0 gives gabor_noise. Values t apart have the
//     correlation cos^2(pi t). Costs about twice as much as gabor_noise. Pass the fraction of a large evolution: a
//     f32 has so few digits at 1000 that the noise errs by 4e-4.

// fn gabor_noise_gradient(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec3f
//     (noise, d/dx, d/dy). The derivatives are per kernel radius, for a constant wave vector.

// fn gabor_noise_quadrature(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec2f
//     (noise, quadrature). The quadrature is the same waves with cosines instead of sines: the two are the imaginary
//     and the real part of a complex noise. At each point they are independent and have variance 1.

// fn gabor_turns_intensity(noise_quadrature: vec2f) -> vec2f
//     (phase in turns within [0, 1), intensity) of what gabor_noise_quadrature returns. A profile of the phase, such as
//     step(phase, width), is a pattern of even contrast [Tricard et al., Procedural phasor noise, 2019].

// fn gabor_stripes(p: vec2f, wave: vec2f, sharpness: f32, seed: u32) -> vec3f
//     Stripes of even contrast, at right angles to the wave vector: (cosine, sine, intensity). Sharpness is 0 to 10^6;
//     2 is a good value. If z is the complex noise, the intensity is |z|, and (cosine, sine) is z / |z| where |z|
//     exceeds 1 / sharpness. Elsewhere it is sharpness times z, so stripes fade where they fork.

// fn gabor_unorm(noise: f32) -> f32
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// fn gabor_uniform(noise: f32) -> f32
// fn gabor_uniform_slope(noise: f32) -> f32
//     The noise's rank among all values, uniform in [0, 1], within 2e-5: gabor_uniform(n) < 0.3 is 30 % of the area.
//     And the derivative of the rank by the noise, the density of the normal distribution.

// fn gabor_derived_seed(seed: u32, index: i32) -> u32
//     The seed of part `index` of anything made of independent noises, such as octaves, which need a seed each: with
//     one seed, frequencies 4 and 8 have a correlation of 0.63 to 0.95 at nodes of the lattice.

// ---- Any position, wave vector, period and evolution ----------------------------------------------------------------

// Cells of the lattice, from node to node, per kernel radius.
const GABOR_CELLS_PER_RADIUS: f32 = (0.5 * f32(GABOR_TAPS));

// A position in node spacings of the lattice, with a period and an evolution.
struct GaborPlace {
    cell: vec2i,             // any integers except the last few before 2^31, where the world wraps around
    local: vec2f,            // offset from that cell's corner in node spacings, most precise in [0, 1)^2
    cells_per_radius: vec2f, // along each axis: GABOR_CELLS_PER_RADIUS, or slightly different to fit a period
    period: vec2i,           // period in nodes, 0 for none
    evolution: f32,          // as in gabor_noise_animated, in turns. Set it after calling a constructor, which sets 0
}

// fn gabor_place_at(p: vec2f) -> GaborPlace
//     The position p, in kernel radii.

// fn gabor_place(cell: vec2i, local: vec2f) -> GaborPlace
//     The position (cell + local) / GABOR_CELLS_PER_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells
//     along each axis.

// fn gabor_place_tiled(p: vec2f, period: vec2f) -> GaborPlace
//     The position p in noise that repeats after `period` kernel radii; an axis whose period is 0 is endless. A
//     period holds a whole number of nodes, from GABOR_TAPS to 2^31. Opposite edges differ by up to 1.5e-4 where a
//     compiler contracts multiplications and additions.

// A position in node spacings of the lattice, with a period and an evolution: see GaborPlace.
struct GaborPlace3d {
    cell: vec3i,
    local: vec3f,
    cells_per_radius: vec3f,
    period: vec3i,
    evolution: f32,
}

// fn gabor_place_3d_at(p: vec3f) -> GaborPlace3d
// fn gabor_place_3d(cell: vec3i, local: vec3f) -> GaborPlace3d
// fn gabor_place_3d_tiled(p: vec3f, period: vec3f) -> GaborPlace3d
//     Like gabor_place_at, gabor_place and gabor_place_tiled.

// fn gabor_wave_vector(frequency: f32, orientation: f32) -> vec2f
//     The wave vector with a frequency and orientation; their ranges are those of gabor_noise.

// A noise, its quadrature, and their gradients per kernel radius: see gabor_noise_quadrature. Unused members cost
// nothing.
struct GaborField {
    noise: f32,
    gradient: vec2f,
    quadrature: f32,
    quadrature_gradient: vec2f,
    removed: f32, // share of the variance that a filter removed, 0 without one: see gabor_filter.wgsl
}

// fn gabor_field(place: GaborPlace, wave: vec2f, seed: u32) -> GaborField
//     The noise at `place`. All other functions call it.

// fn gabor_stripes_of(field: GaborField, sharpness: f32) -> vec3f
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
// derivatives jump where windows end, midway between nodes for 3 taps and at nodes for 4: along the wave by 0.14 of
// their standard deviation at frequency 1, across it and at frequency 0 by 1.15. The noise is normal because sums of
// independent normal variables are normal.
//
// Each wave's phase starts at its own node, so the wave vector F may vary with the position. From one node to the next,
// the phase turns by u = 2 pi F_x / R along x and v = 2 pi F_y / R along y. If node (0, 0) is next to p, the sum
// separates into one sum per axis:
//
//     n(p) = K Im e^(2 pi i F.(p - (x_0, y_0))) sum_j h(y - y_j) e^(-i v j) sum_k h(x - x_k) e^(-i u k) A_kj.
//
// After [TNVT19] Tavernier, Neyret, Vergne, Thollot: Making Gabor Noise Fast and Normalized, Eurographics 2019.

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Hashes a word; each salt gives a different sequence. The constants are from the hash-prospector project.
fn gabor_impl_mix(word: u32, salt: u32) -> u32 {
    let once = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    let twice = (once ^ (once >> 15u)) * 0xd35a2d97u;
    return twice ^ (twice >> 15u);
}

fn gabor_derived_seed(seed: u32, index: i32) -> u32 {
    return gabor_impl_mix(seed + u32(index) * 0x85ebca6bu, 0x9e3779b1u);
}

const GABOR_IMPL_ROWS: u32 = 0x5bd1e995u;
// The salt of the columns; xor it with GABOR_IMPL_ROWS to get the salt of the rows. With equal salts, the word of node
// (k, k) would be a square.
fn gabor_impl_salt(seed: u32) -> u32 {
    return gabor_impl_mix(seed * 0x9e3779b1u, 0x2545f491u);
}

// The word of a column or row of nodes; a node's word is the product of its column's and its row's. The words of
// columns and rows are odd and have 24 bits, because GPUs multiply such numbers at a quarter of the cost of 32-bit
// numbers. Their highest bit is set, so that products fill all 32 bits. The factor (word ^ (word >> 15)) mixes better
// than a constant: two indices, however far apart, have equal words with probability 2^-22.
fn gabor_impl_line_word(index: i32, salt: u32) -> u32 {
    let word = u32(index) * 0x9e3779b1u + salt;
    return ((word * (word ^ (word >> 15u))) >> 8u) | 0x800001u;
}

// Like GABOR_IMPL_ROWS, for slices.
const GABOR_IMPL_SLICES: u32 = 0x27d4eb2fu;

// The word of a row in a slice of nodes: odd with 24 bits, like the words of lines.
fn gabor_impl_slice_word(row: u32, slice: u32) -> u32 {
    return ((row * slice) >> 8u) | 0x800001u;
}

// The standard deviation of each part of an amplitude.
const GABOR_IMPL_DEVIATION: f32 = 1.4599553e27;

// Computes an amplitude from a word: the real part from the whole word, the imaginary part from its low 20 bits. They
// are independent and nearly normal. For u uniform in [-1, 1], the quantiles of (u - 0.893 clamp(u, -0.937, 0.937))
// (1 + 0.623 u^2) are nearly proportional to those of a normal distribution. The noise's Cramer-von Mises index
// [TNVT19] is 0.002 on average. At the worst point, a node, it is 0.03, because 79 % of the power there comes from that
// node's amplitude.
fn gabor_impl_amplitude(word: u32) -> vec2f {
    let u = vec2f(f32(i32(word)), f32(i32(word << 12u)));
    // fit: see tools/constants.py
    return (u - 0.89289313 * clamp(u, vec2f(-2.0119258e9), vec2f(2.0119258e9))) * (u * u + 7.3973916e18);
}

// Derives four more words from a row's word. Multiplied by a column's word, each is as random as a node's own word.
fn gabor_impl_row(word: u32) -> vec4u {
    let first = (word ^ (word >> 15u)) * 0xd35a2d97u;
    let second = (first ^ (first >> 15u)) * 0xd35a2d97u;
    let third = (second ^ (second >> 15u)) * 0xd35a2d97u;
    let fourth = (third ^ (third >> 15u)) * 0xd35a2d97u;
    return vec4u((first >> 8u) | 0x800001u, (second >> 8u) | 0x800001u, (third >> 8u) | 0x800001u,
                 (fourth >> 8u) | 0x800001u);
}

// ---- Waves and windows ---------------------------------------------------------------------------------------------

// The product of two complex numbers.
fn gabor_impl_product(a: vec2f, b: vec2f) -> vec2f {
    return a.x * b + a.y * vec2f(-b.y, b.x);
}

// Adds z times a pair of complex numbers to two sums.
fn gabor_impl_add_products(sums: ptr<function, vec4f>, pair: vec4f, z: vec2f) {
    *sums = (*sums) + z.x * pair + z.y * vec4f(-pair.y, pair.x, -pair.w, pair.z);
}

// (cos, sin) of 2 pi t for |t| <= 1/4, by minimax polynomials, within 2e-7.
fn gabor_impl_half_turn(t: f32) -> vec2f {
    let s = t * t; let r = s * s;
    // fits: see tools/constants.py
    return vec2f((1.0 - 19.739171 * s) + r * ((64.934591 - 85.240337 * s) + 56.24243 * r),
                 t * ((6.2831852 - 41.341655 * s) + r * ((81.601004 - 76.549782 * s) + 39.536707 * r)));
}

// (cos, sin) of 2 pi t for any t, within 2e-7 in [-1, 1]; beyond that, the rounding of t adds to the error. After t is
// reduced to [-1/2, 1/2], cos(2 pi t) = sin(2 pi y) and sin(2 pi t) = +-cos(2 pi y), where y = 1/4 - |t|.
fn gabor_impl_wave(t: f32) -> vec2f {
    let within = t - floor(t + 0.5);
    let turn = gabor_impl_half_turn(0.25 - abs(within));
    return vec2f(turn.y, select(turn.x, -turn.x, within < 0.0));
}

// The sum of the squared windows.
const GABOR_IMPL_ENERGY: f32 = select(0.375 * f32(GABOR_TAPS), 1.0, GABOR_TAPS == 2);

// Computes the windows of the nodes k = -1, 0, ... along an axis, h = 1/2 + cos(pi (x - k) / R) / 2, and their
// derivatives per kernel radius. x is in node spacings from node 0: in [-1/2, 1/2] for three taps, [0, 1] for four and
// [-1, 0] for two.
const_assert GABOR_TAPS == 3;
fn gabor_impl_windows(x: f32, value: ptr<function, vec4f>, slope: ptr<function, vec4f>) {
    let y = x * x;
    // fits: see tools/constants.py
    let c = 0.5 - y * (1.0966099 - y * (0.40054826 - y * 0.05644487)); // cos(2/3 pi x) / 2
    let s = x * (0.90689956 - y * (0.66301124 - y * (0.14532053 - y * 0.01467483))); // sqrt(3)/4 sin(2/3 pi x)
    let a = 0.5 - 0.5 * c;
    let b = 1.8137994 * s; // pi/sqrt(3)
    *value = vec4f(a - s, 0.5 + c, a + s, 0.0);
    *slope = vec4f(b - 2.7206991 * c, -2.0 * b, b + 2.7206991 * c, 0.0); // sqrt(3)/2 pi
}

// The power of a noise that replaces another as x goes from 0 to 1. If the power were x itself, the amplitudes would be
// square roots, with infinite slopes at the ends.
fn gabor_impl_takeover(x: f32) -> f32 {
    return x * x / (x * x + (1.0 - x) * (1.0 - x));
}

// ---- The sum -------------------------------------------------------------------------------------------------------

// Wraps an index into a period.
fn gabor_impl_wrap(index_in: i32, period: i32) -> i32 {
    var index = index_in;
    if (period != 0) {
        index -= index / max(period, 1) * period; // FXC refuses a division by 0, even one that never runs
        if (index < 0) { index += period; }
    }
    return index;
}

// The next index, wrapped into a period without a division.
fn gabor_impl_next_node(index: i32, period: i32) -> i32 {
    return select(0, index + 1, period == 0 || index + 1 < period);
}

// The words of four nodes along an axis; the second has the index.
fn gabor_impl_four_line_words(index: i32, period: i32, salt: u32) -> vec4u {
    let first = gabor_impl_wrap(index - 1, period);
    let second = gabor_impl_next_node(first, period);
    let third = gabor_impl_next_node(second, period);
    return vec4u(gabor_impl_line_word(first, salt), gabor_impl_line_word(second, salt),
                 gabor_impl_line_word(third, salt), gabor_impl_line_word(gabor_impl_next_node(third, period), salt));
}

// The nodes along an axis whose windows reach a point.
struct GaborImplAxis {
    offset: f32,           // offset of the point from node 0, in node spacings
    turns: f32,            // turns of the wave from one node to the next
    word: array<u32, 4>,
    node: array<vec4f, 4>, // for node k, e^(-i u k) times the window, and times the window's derivative
}

// `wave` is in cycles per kernel radius, `radius` in nodes per kernel radius.
fn gabor_impl_axis(cell: i32, local: f32, period: i32, salt: u32, wave: f32, radius: f32) -> GaborImplAxis {
    var axis: GaborImplAxis;
    let zero = floor(local + (2.0 - GABOR_CELLS_PER_RADIUS));
    // The clamp matters only if a compiler fuses the product in `local` with this subtraction.
    axis.offset = clamp(local - zero, GABOR_CELLS_PER_RADIUS - 2.0, GABOR_CELLS_PER_RADIUS - 1.0);
    axis.turns = wave / radius;
    var index = gabor_impl_wrap(cell + i32(zero) - 1, period);
    axis.word[0] = gabor_impl_line_word(index, salt);
    index = gabor_impl_next_node(index, period);
    axis.word[1] = gabor_impl_line_word(index, salt);
    index = gabor_impl_next_node(index, period);
    axis.word[2] = gabor_impl_line_word(index, salt);
    axis.word[3] = gabor_impl_line_word(gabor_impl_next_node(index, period), salt);
    var value: vec4f; var slope: vec4f;
    gabor_impl_windows(axis.offset, &value, &slope);
    let turn = gabor_impl_wave(axis.turns);
    let back = vec2f(turn.x, -turn.y);
    let twice = gabor_impl_product(back, back);
    axis.node[0] = vec4f(value.x * turn, slope.x * turn);
    axis.node[1] = vec4f(value.y, 0.0, slope.y, 0.0);
    axis.node[2] = vec4f(value.z * back, slope.z * back);
    axis.node[3] = vec4f(value.w * twice, slope.w * twice);
    return axis;
}

// The amplitude of a node at an evolution. It is a weighted sum of three amplitudes, from the node's word and two words
// derived from it. The squared weights sum to 1; at evolution 0 the weights are 1, 0, 0. A return within the branch
// would take FXC four times as long through ANGLE.
fn gabor_impl_amplitude_at(word: u32, evolution: f32) -> vec2f {
    var amplitude = gabor_impl_amplitude(word);
    if (evolution != 0.0) {
        let second = (word ^ (word >> 15u)) * 0xd35a2d97u;
        let third = (second ^ (second >> 15u)) * 0xd35a2d97u;
        let turn = gabor_impl_wave(evolution);
        // 0.70710678 is 1/sqrt(2)
        amplitude = (0.5 + 0.5 * turn.x) * amplitude + (0.5 - 0.5 * turn.x) * gabor_impl_amplitude(second)
                  + 0.70710678 * turn.y * gabor_impl_amplitude(third);
    }
    return amplitude;
}

// The row of nodes whose sums stand behind a test that is always true. The test keeps drivers for CPUs from spilling
// registers, but it would keep C++ from vectorizing: there, no row has it.
const GABOR_IMPL_TESTED_ROW: i32 = 1;

// Adds row j of nodes to `sum`, weighted by the windows along y, and to `slope`, weighted by the derivatives of these
// windows. In both, xy uses the windows along x, and zw their derivatives. Some compilers do not unroll or vectorize
// loops over nodes and rows, so each node and each row has its own line.
fn gabor_impl_add_node_row(sum: ptr<function, vec4f>, slope: ptr<function, vec4f>, x: GaborImplAxis,
                           y_in: GaborImplAxis, j: i32, evolution: f32) {
    var y = y_in;
    var row = vec4f(0.0);
    gabor_impl_add_products(&row, x.node[0], gabor_impl_amplitude_at(x.word[0] * y.word[j], evolution));
    gabor_impl_add_products(&row, x.node[1], gabor_impl_amplitude_at(x.word[1] * y.word[j], evolution));
    if (GABOR_TAPS > 2) {
        gabor_impl_add_products(&row, x.node[2], gabor_impl_amplitude_at(x.word[2] * y.word[j], evolution));
    }
    if (GABOR_TAPS > 3) {
        gabor_impl_add_products(&row, x.node[3], gabor_impl_amplitude_at(x.word[3] * y.word[j], evolution));
    }
    if (j != GABOR_IMPL_TESTED_ROW || x.offset < 8.0) {
        gabor_impl_add_products(sum, row, y.node[j].xy);
        gabor_impl_add_products(slope, row, y.node[j].zw);
    }
}

fn gabor_impl_sum(x: GaborImplAxis, y: GaborImplAxis, evolution: f32, sum: ptr<function, vec4f>,
                  slope: ptr<function, vec4f>) {
    *slope = vec4f(0.0); *sum = (*slope);
    gabor_impl_add_node_row(sum, slope, x, y, 0, evolution);
    gabor_impl_add_node_row(sum, slope, x, y, 1, evolution);
    if (GABOR_TAPS > 2) { gabor_impl_add_node_row(sum, slope, x, y, 2, evolution); }
    if (GABOR_TAPS > 3) { gabor_impl_add_node_row(sum, slope, x, y, 3, evolution); }
}

// Multiplies the sums by K and by the wave at the point, whose phase is 0 at node (0, 0). K makes E[n^2] = 1: E[n^2] is
// K^2 / 2 E|A|^2 times the sums of squared windows along x and y. A wave's derivative is the wave times 2 pi i F.
fn gabor_impl_field(sum: vec4f, slope: vec4f, turn_in: vec2f, wave: vec2f, stretch: vec2f) -> GaborField {
    var turn = turn_in;
    turn *= 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    let value = gabor_impl_product(sum.xy, turn);
    let turned = 6.2831853 * vec2f(-value.y, value.x);
    let along_x = stretch.x * gabor_impl_product(sum.zw, turn) + wave.x * turned;
    let along_y = stretch.y * gabor_impl_product(slope.xy, turn) + wave.y * turned;
    return GaborField(value.y, vec2f(along_x.y, along_y.y), value.x, vec2f(along_x.x, along_y.x), 0.0);
}

fn gabor_field(place: GaborPlace, wave_in: vec2f, seed: u32) -> GaborField {
    var wave = wave_in;
    wave = clamp(wave, vec2f(-1.0e6), vec2f(1.0e6));
    var salt = gabor_impl_salt(seed);
    let x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                            place.cells_per_radius.x);
    salt ^= GABOR_IMPL_ROWS;
    let y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, wave.y,
                            place.cells_per_radius.y);
    let turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    var sum: vec4f; var slope: vec4f;
    gabor_impl_sum(x, y, place.evolution, &sum, &slope);
    return gabor_impl_field(sum, slope, turn, wave, place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
fn gabor_impl_add_field(sum: ptr<function, GaborField>, field: GaborField, amplitude: f32, stretch: vec2f) {
    (*sum).noise += amplitude * field.noise;
    (*sum).gradient += amplitude * stretch * field.gradient;
    (*sum).quadrature += amplitude * field.quadrature;
    (*sum).quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
    (*sum).removed += amplitude * amplitude * field.removed;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_place(cell: vec2i, local: vec2f) -> GaborPlace {
    return GaborPlace(cell, local, vec2f(GABOR_CELLS_PER_RADIUS), vec2i(0), 0.0);
}

fn gabor_place_at(p: vec2f) -> GaborPlace {
    return gabor_place(vec2i(0), p * GABOR_CELLS_PER_RADIUS);
}

fn gabor_place_tiled(p: vec2f, period: vec2f) -> GaborPlace {
    let side = clamp(period, vec2f(0.0009765625), vec2f(1.0e9)); // 2^-10
    let nodes = max(floor(side * GABOR_CELLS_PER_RADIUS + 0.5), vec2f(f32(GABOR_TAPS)));
    var place = gabor_place(vec2i(0), vec2f(0.0));
    place.cells_per_radius = vec2f(select(GABOR_CELLS_PER_RADIUS, nodes.x / side.x, period.x > 0.0),
                        select(GABOR_CELLS_PER_RADIUS, nodes.y / side.y, period.y > 0.0));
    place.period = vec2i(select(0, i32(nodes.x), period.x > 0.0), select(0, i32(nodes.y), period.y > 0.0));
    place.local = p * place.cells_per_radius;
    return place;
}

fn gabor_place_3d(cell: vec3i, local: vec3f) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3f(GABOR_CELLS_PER_RADIUS), vec3i(0), 0.0);
}

fn gabor_place_3d_at(p: vec3f) -> GaborPlace3d {
    return gabor_place_3d(vec3i(0), p * GABOR_CELLS_PER_RADIUS);
}

fn gabor_place_3d_tiled(p: vec3f, period: vec3f) -> GaborPlace3d {
    let xy = gabor_place_tiled(p.xy, period.xy); let z = gabor_place_tiled(p.zz, period.zz);
    return GaborPlace3d(vec3i(0), vec3f(xy.local, z.local.x), vec3f(xy.cells_per_radius, z.cells_per_radius.x),
                        vec3i(xy.period, z.period.x), 0.0);
}

fn gabor_wave_vector(frequency: f32, orientation: f32) -> vec2f {
    return min(abs(frequency), 1.0e6) * gabor_impl_wave(0.15915494 * clamp(orientation, -1.0e6, 1.0e6)); // 1/(2 pi)
}

fn gabor_noise(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32 {
    return gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed).noise;
}

fn gabor_noise_tiled(p: vec2f, period: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32 {
    return gabor_field(gabor_place_tiled(p, period), gabor_wave_vector(frequency, orientation), seed).noise;
}

fn gabor_noise_animated(p: vec2f, evolution: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place = gabor_place_at(p);
    place.evolution = evolution;
    return gabor_field(place, gabor_wave_vector(frequency, orientation), seed).noise;
}

fn gabor_noise_gradient(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec3f {
    let field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return vec3f(field.noise, field.gradient);
}

fn gabor_noise_quadrature(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec2f {
    let field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return vec2f(field.noise, field.quadrature);
}

fn gabor_turns_intensity(noise_quadrature: vec2f) -> vec2f {
    let intensity = length(noise_quadrature.yx);
    let phase = select(0.0, atan2(noise_quadrature.x, noise_quadrature.y) * 0.15915494, intensity > 0.0); // 1/(2 pi)
    return vec2f(select(phase, min(phase + 1.0, 0.99999994), phase < 0.0), intensity); // 1 - 2^-24
}

// For z = v + sqrt(r) times a complex normal number with independent parts, the mean of z / |z| is about
// v / sqrt(|v|^2 + 8/pi r), and the mean of |z| about sqrt(|v|^2 + pi/2 r). Both are exact for small and for large |v|.
fn gabor_stripes_of(field: GaborField, sharpness: f32) -> vec3f {
    let value = vec2f(field.quadrature, field.noise);
    let power = dot(value, value); let removed = max(field.removed, 0.0);
    let reach = sqrt(power + 2.5464791 * removed); // 8/pi
    return vec3f(sharpness / max(sharpness * reach, 1.0) * value, sqrt(power + 1.5707963 * removed)); // pi/2
}

fn gabor_stripes(p: vec2f, wave: vec2f, sharpness: f32, seed: u32) -> vec3f {
    return gabor_stripes_of(gabor_field(gabor_place_at(p), wave, seed), sharpness);
}

fn gabor_unorm(noise: f32) -> f32 {
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}

fn gabor_uniform(noise: f32) -> f32 {
    let x = clamp(noise, -8.0, 8.0); let y = x * x;
    return 1.0 / (1.0 + exp(-x * (1.5954352 + y * (0.073597476 - y * 0.00063190124)))); // fit: see tools/constants.py
}

fn gabor_uniform_slope(noise: f32) -> f32 {
    return 0.39894228 * exp(-0.5 * min(noise * noise, 150.0)); // 1/sqrt(2 pi)
}
