// Generated from gabor_sparse.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 25e198bafac5a5a8.
//
// gabor_sparse.wgsl: the sparse Gabor noise of Tavernier et al. (2019) in the plane, with mean 0 and variance 1 at every
// point.
//
//     f32 n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//     f32 v = gabor_unorm(n);                    // in [0, 1], for display
//
// Use this file for the paper's own noise. The noise of gabor_noise.wgsl, which has the same functions, is faster and
// is normal at every point. Positions are in kernel radii: a kernel ends one radius from its impulse. Frequencies are
// in cycles per kernel radius.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

const GABOR_NOISE_VERSION: u32 = 30000u;

// ---- Macros: define them before the file. The defaults are the recipe `one`; docs/recipes.md lists others ----------

// ---- Functions -----------------------------------------------------------------------------------------------------

// f32 gabor_noise(vec2f p, f32 frequency, f32 orientation, u32 seed)
//     Gabor noise at p, with mean 0 and variance 1 at every point, and continuous first derivatives. Values pooled over
//     all points are nearly normal; those at a fixed position in the cells are less so: see docs/recipes.md.
//       p            position in kernel radii, |p| < 2^31 / GABOR_CELLS_PER_RADIUS. Float rounding shows earlier: at
//       10^5, p has
//                    steps of 0.008
//       frequency    cycles per kernel radius, 10^-6 to 10^6; the sign is ignored. Above 64, positions of impulses are
//                    too coarse for the exact variance
//       orientation  direction of the wave vector in radians from +x towards +y, precise from -400 to 400
//       seed         any; different seeds give independent noises
//     Frequency and orientation may vary with p; where they are continuous, so is the noise. NaN gives an unspecified
//     value. Cost: (ceil(2 GABOR_CELLS_PER_RADIUS) + 1)^2 GABOR_IMPULSES impulses, 9 by default.

// vec3f gabor_noise_gradient(vec2f p, f32 frequency, f32 orientation, u32 seed)
//     (noise, d/dx, d/dy), per kernel radius, for constant frequency and orientation.

// vec2f gabor_noise_quadrature(vec2f p, f32 frequency, f32 orientation, u32 seed)
//     (noise, quadrature). The quadrature is the same waves with cosines instead of sines: the two are the imaginary
//     and the real part of a complex noise. At each point they are uncorrelated and have variance 1; with
//     GABOR_PHASES 2, the quadrature has variance 1 only at frequencies of 1.5 or more.

// vec2f gabor_turns_intensity(vec2f noise_quadrature)
//     (phase in turns within [0, 1), intensity) of what gabor_noise_quadrature returns. A profile of the phase, such as
//     step(phase, width), is a pattern of even contrast [Tricard et al., "Procedural phasor noise", 2019].

// f32 gabor_noise_tiled(vec2f p, vec2f period, f32 frequency, f32 orientation, u32 seed)
//     Noise that repeats exactly after `period` kernel radii along x and y, at any frequency and orientation, with the
//     mean and variance of gabor_noise. If period * GABOR_CELLS_PER_RADIUS is an integer, the distribution is also the
//     same. Otherwise cells grow to fit, and values become less normal: with the recipe `one`, cvm (see
//     docs/recipes.md) is 1.1 for 5 % fewer cells per radius, 6.4 for 10 %, and 14 to 425 for square periods of 2.3 to
//     4.9. A period below 2, the diameter of a kernel, counts as 2.

// f32 gabor_noise_animated(vec2f p, f32 evolution, f32 frequency, f32 orientation, u32 seed)
//     Noise that evolves in place and repeats when `evolution` grows by 1. It always has the statistics of gabor_noise.
//     Its autocorrelation is the mean of cos(2 pi k lag) over k = 1 to 4: 0.87 at a lag of 0.03, 0 at 0.1, -0.38 at
//     0.16. At 3.5 % of all points, the noise hardly changes.

// f32 gabor_unorm(f32 noise)
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// ---- For large worlds, and for periods that evolve -----------------------------------------------------------------

// A wave and its normalization, returned by gabor_kernel.
struct GaborKernel {
    wave: vec2<f32>, // wave vector, cycles per kernel radius
    amplitude: f32, // K
    variance_factor: f32, // variance for K = 1, relative to that at high frequencies: 1 unless there are two phases
}

// A position in cells, with a period and an evolution.
struct GaborPlace {
    cell: vec2<i32>, // any integers except the last few before 2^31, where the world wraps around
    local: vec2<f32>, // offset from that cell's corner in cells, most precise in [0, 1)^2
    cells_per_radius: vec2<f32>, // along each axis: GABOR_CELLS_PER_RADIUS, or as little as half of it to fit a period
    period: vec2<i32>, // period in cells, 0 for none
    evolution: f32, // as in gabor_noise_animated, in turns: only its fraction counts
}

// A noise, its quadrature, and their gradients per kernel radius: see gabor_noise_quadrature. Unused members cost
// nothing.
struct GaborField {
    noise: f32,
    gradient: vec2<f32>,
    quadrature: f32,
    quadrature_gradient: vec2<f32>,
}

// GaborKernel gabor_kernel(f32 frequency, f32 orientation)
//     The kernel with a given frequency and orientation; ranges are those of gabor_noise. Compute it once for many
//     calls.

// GaborPlace gabor_place(vec2i cell, vec2f local)
//     The position (cell + local) / GABOR_CELLS_PER_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells
//     along each axis.

// GaborField gabor_field(GaborPlace place, GaborKernel kernel, u32 seed)
//     The noise, its quadrature, and their gradients at `place`. All noise functions call it.

// f32 gabor_noise_at(vec2i cell, vec2f local, GaborKernel kernel, u32 seed)
//     The noise at gabor_place(cell, local).

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// The noise is a sum of Gabor kernels, windowed waves, around random impulses x_i (sparse convolution):
//
//     n(p) = K sum_i w_i g_i(p - x_i),     g_i(d) = q(d.x) q(d.y) sin(2 pi (F d.omega + phase_i)),
//
// with a fixed number of impulses in each cell of a grid, and weights that vary little. The unit of length is the
// kernel radius, where q and its slope are 0. K makes the variance exactly 1 at every frequency and every point. Each
// wave's phase starts at its own impulse, so frequency and orientation may vary with the position.
//
// After Tavernier, Neyret, Vergne, Thollot, "Making Gabor Noise Fast and Normalized", Eurographics 2019.

fn gabor_impl_needs_int_float_float_int_vec3_macros(n: i32, r: f32, a: f32, phases: i32, window: vec3<f32>) -> f32 {
    return (((f32((n + phases)) + r) + a) + window.x);
}
fn gabor_impl_check_macros() -> f32 {
    let _e9 = gabor_impl_needs_int_float_float_int_vec3_macros(1i, 1f, 0.675f, 256i, vec3<f32>(3f, -4.5f, 2.5f));
    return _e9;
}

// Mixes a word in two rounds of shift and multiply, with constants from the hash-prospector project. The salt enters
// between the rounds, so that no salt's sequence is a shifted copy of another's.
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

// The word of a seed determines the words of the rows of cells, which determine the words of the impulses.
fn gabor_impl_seed_word(seed: u32) -> u32 {
    let _e4 = gabor_impl_mix((seed * 2654435761u), 625341585u);
    return _e4;
}

fn gabor_impl_row_word(row: i32, seed_word: u32) -> u32 {
    let _e6 = gabor_impl_mix(((u32(row) * 2654435761u) + seed_word), seed_word);
    return _e6;
}

// The word of impulse `index` in a cell. Its bits hold y in the cell (0 to 22), x (8 to 30), the phase (0 to 7), the
// phase rate (8 to 10) and the magnitude (31). x and y share bits 8 to 22, the leading bits of y and trailing bits of
// x: only offsets in x below 1/256 of a cell depend on y.
fn gabor_impl_impulse_word(column: i32, row_word: u32, index: i32) -> u32 {
    var salt_1: u32;
    salt_1 = (row_word + (u32(index) * 2246822507u));
    let _e11 = salt_1;
    let _e13 = salt_1;
    let _e14 = gabor_impl_mix(((u32(column) * 2654435761u) + _e11), _e13);
    return _e14;
}

// The parts of an impulse's word. Positions are offset by 1, to [1, 2)^2, which avoids a conversion from integers.
struct GaborImpulse {
    position_plus_one: vec2<f32>,
    phase: f32, // phase in turns
    phase_rate: f32, // turns per turn of the evolution: -4 to -1 or 1 to 4
    magnitude: f32, // magnitude of the weight
}

fn gabor_impl_impulse(word: u32) -> GaborImpulse {
    var position_plus_one: vec2<f32>;
    var rate: f32;
    var local: f32;
    var local_1: f32;
    position_plus_one = vec2<f32>(bitcast<f32>((1065353216u | ((word >> 8u) & 8388607u))), bitcast<f32>((1065353216u | (word & 8388607u))));
    rate = (f32(((word >> 8u) & 7u)) - 4f);
    let _e23 = position_plus_one;
    let _e24 = position_plus_one;
    let _e32 = rate;
    if (_e32 < 0f) {
        let _e35 = rate;
        local = _e35;
    } else {
        let _e36 = rate;
        local = (_e36 + 1f);
    }
    let _e40 = local;
    if (i32(word) < 0i) {
        local_1 = 1f;
    } else {
        local_1 = 0.675f;
    }
    let _e47 = local_1;
    return GaborImpulse(_e23, fract((_e24.y * 32768f)), _e40, _e47);
}

// sin(2 pi t), as t (1/4 - t^2) times a minimax polynomial in t^2. The error is at most 3e-7 in [-1, 1]; beyond that,
// the rounding of t adds to it.
fn gabor_impl_sine(t: f32) -> f32 {
    var t_1: f32;
    var s: f32;
    var p: f32;
    t_1 = t;
    let _e2 = t_1;
    t_1 = (fract(_e2) - 0.5f);
    let _e6 = t_1;
    let _e7 = t_1;
    s = (_e6 * _e7);
    let _e11 = s;
    p = ((12.233303f * _e11) - 38.123196f);
    let _e16 = p;
    let _e17 = s;
    p = ((_e16 * _e17) + 67.0439f);
    let _e21 = p;
    let _e22 = s;
    p = ((_e21 * _e22) - 64.83468f);
    let _e26 = p;
    let _e27 = s;
    p = ((_e26 * _e27) + 25.13273f);
    let _e31 = t_1;
    let _e32 = s;
    let _e36 = p;
    return ((_e31 * (_e32 - 0.25f)) * _e36);
}

// The unit vector at an angle in radians, within 1e-7. Multiples of pi/2 are subtracted in three steps, for precision;
// minimax polynomials give the sine and cosine of the rest.
fn gabor_impl_direction(angle: f32) -> vec2<f32> {
    var quarter: f32;
    var r_1: f32;
    var local_2: f32;
    var s_1: f32;
    var sine: f32;
    var cosine: f32;
    var local_3: vec2<f32>;
    var axis: vec2<f32>;
    var local_4: vec2<f32>;
    quarter = floor(((angle * 0.63661975f) + 0.5f));
    let _e7 = quarter;
    r_1 = (angle - (_e7 * 1.5703125f));
    let _e12 = r_1;
    let _e13 = quarter;
    r_1 = (_e12 - (_e13 * 0.0004837513f));
    let _e17 = r_1;
    let _e18 = quarter;
    r_1 = (_e17 - (_e18 * 0.0000000754979f));
    let _e22 = r_1;
    if (abs(_e22) < 1f) {
        let _e26 = r_1;
        local_2 = _e26;
    } else {
        local_2 = 0f;
    }
    let _e29 = local_2;
    r_1 = _e29;
    let _e30 = r_1;
    let _e31 = r_1;
    s_1 = (_e30 * _e31);
    let _e34 = r_1;
    let _e35 = r_1;
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
        local_3 = vec2<f32>(_e78, _e79);
    } else {
        let _e81 = sine;
        let _e83 = cosine;
        local_3 = vec2<f32>(-(_e81), _e83);
    }
    let _e86 = local_3;
    axis = _e86;
    let _e89 = quarter;
    if (fract((0.25f * _e89)) < 0.375f) {
        let _e94 = axis;
        local_4 = _e94;
    } else {
        let _e95 = axis;
        local_4 = -(_e95);
    }
    let _e98 = local_4;
    return _e98;
}

// ---- Normalization -------------------------------------------------------------------------------------------------
// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). GaborEnergy holds the five c_n I_n and their sum, the integral of
// q^2.
struct GaborEnergy {
    e4567_: vec4<f32>,
    e8_: f32,
    sum: f32,
}

fn gabor_impl_energy() -> GaborEnergy {
    var c: vec3<f32> = vec3<f32>(3f, -4.5f, 2.5f);
    var e4567_: vec4<f32>;
    var e8_: f32;
    let _e19 = c;
    let _e21 = c;
    let _e25 = c;
    let _e28 = c;
    let _e31 = c;
    let _e33 = c;
    let _e37 = c;
    let _e40 = c;
    let _e45 = c;
    let _e48 = c;
    e4567_ = (vec4<f32>(0.8126984f, 0.73881674f, 0.68198466f, 0.636519f) * vec4<f32>((_e19.x * _e21.x), ((2f * _e25.x) * _e28.y), ((_e31.y * _e33.y) + ((2f * _e37.x) * _e40.z)), ((2f * _e45.y) * _e48.z)));
    let _e54 = c;
    let _e56 = c;
    e8_ = ((_e54.z * _e56.z) * 0.59907675f);
    let _e64 = e4567_;
    let _e65 = e8_;
    let _e66 = e4567_;
    let _e70 = e8_;
    return GaborEnergy(_e64, _e65, (dot(_e66, vec4(1f)) + _e70));
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the energy along one axis of
// a sine kernel with k cycles per radius, relative to the energy at high frequency. For small a, it is computed from
// 1 - L_n, by the power series of L_7 and L_8 and downward recurrence; for large a, by upward recurrence from
// L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
fn gabor_impl_relative_energy(k: f32, energy: GaborEnergy) -> f32 {
    var a_1: f32;
    var z: f32;
    var d4567_: vec4<f32>;
    var d78_: vec2<f32> = vec2(0f);
    var term: vec2<f32> = vec2(1f);
    var i: i32 = 1i;
    var d6_: f32;
    var d5_: f32;
    var y: f32;
    var l0_: f32;
    var l1_: f32;
    var l2_: f32;
    var l3_: f32;
    var l: vec4<f32>;
    a_1 = (12.566371f * k);
    let _e5 = a_1;
    let _e6 = a_1;
    z = (_e5 * _e6);
    let _e13 = z;
    if (_e13 < 64f) {
        {
            loop {
                let _e21 = i;
                if !((_e21 <= 14i)) {
                    break;
                }
                {
                    let _e28 = term;
                    let _e31 = z;
                    let _e33 = i;
                    let _e35 = i;
                    term = (_e28 * (vec2((-0.25f * _e31)) / (f32(_e33) * (vec2(f32(_e35)) + vec2<f32>(7.5f, 8.5f)))));
                    let _e46 = d78_;
                    let _e47 = term;
                    d78_ = (_e46 - _e47);
                }
                continuing {
                    let _e25 = i;
                    i = (_e25 + 1i);
                }
            }
            let _e49 = d78_;
            let _e51 = z;
            let _e53 = d78_;
            d6_ = (_e49.x + ((_e51 * (1f - _e53.y)) * 0.003921569f));
            let _e63 = d6_;
            let _e64 = z;
            let _e66 = d78_;
            d5_ = (_e63 + ((_e64 * (1f - _e66.x)) * 0.0051282053f));
            let _e76 = d5_;
            let _e77 = z;
            let _e79 = d6_;
            let _e87 = d5_;
            let _e88 = d6_;
            let _e89 = d78_;
            d4567_ = vec4<f32>((_e76 + ((_e77 * (1f - _e79)) * 0.006993007f)), _e87, _e88, _e89.x);
        }
    } else {
        {
            let _e93 = z;
            y = (1f / _e93);
            let _e98 = gabor_impl_sine((2f * k));
            let _e99 = a_1;
            l0_ = (_e98 / _e99);
            let _e103 = y;
            let _e105 = l0_;
            let _e110 = gabor_impl_sine(((2f * k) + 0.25f));
            l1_ = ((3f * _e103) * (_e105 - _e110));
            let _e115 = y;
            let _e117 = l1_;
            let _e118 = l0_;
            l2_ = ((15f * _e115) * (_e117 - _e118));
            let _e123 = y;
            let _e125 = l2_;
            let _e126 = l1_;
            l3_ = ((35f * _e123) * (_e125 - _e126));
            let _e133 = y;
            let _e135 = l3_;
            let _e136 = l2_;
            l.x = ((63f * _e133) * (_e135 - _e136));
            let _e141 = y;
            let _e143 = l;
            let _e145 = l3_;
            l.y = ((99f * _e141) * (_e143.x - _e145));
            let _e150 = y;
            let _e152 = l;
            let _e154 = l;
            l.z = ((143f * _e150) * (_e152.y - _e154.x));
            let _e160 = y;
            let _e162 = l;
            let _e164 = l;
            l.w = ((195f * _e160) * (_e162.z - _e164.y));
            let _e171 = y;
            let _e173 = l;
            let _e175 = l;
            d78_.y = (1f - ((255f * _e171) * (_e173.w - _e175.z)));
            let _e181 = l;
            d4567_ = (vec4(1f) - _e181);
        }
    }
    let _e185 = d4567_;
    let _e188 = d78_;
    return ((dot(energy.e4567_, _e185) + (energy.e8_ * _e188.y)) / energy.sum);
}

// ---- Kernels -------------------------------------------------------------------------------------------------------
// The window q along one axis, which is 0 for |x| >= 1, and its derivative.
fn gabor_impl_window(x: f32) -> vec2<f32> {
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
    let _e32 = u;
    let _e35 = c_1;
    let _e38 = u;
    let _e40 = c_1;
    let _e43 = u;
    let _e45 = c_1;
    return vec2<f32>(((_e13 * _e14) * (_e16.x + (_e18 * (_e19.y + (_e21 * _e22.z))))), (((-2f * x) * _e32) * ((2f * _e35.x) + (_e38 * ((3f * _e40.y) + (_e43 * (4f * _e45.z)))))));
}

// Wraps a cell's coordinate into a period.
fn gabor_impl_wrap(cell: i32, period: i32) -> i32 {
    var cell_1: i32;
    cell_1 = cell;
    if (period != 0i) {
        {
            let _e5 = cell_1;
            let _e6 = cell_1;
            cell_1 = (_e5 - ((_e6 / max(period, 1i)) * period));
            let _e12 = cell_1;
            if (_e12 < 0i) {
                let _e15 = cell_1;
                cell_1 = (_e15 + period);
            }
        }
    }
    let _e17 = cell_1;
    return _e17;
}

// The gain that keeps the variance of sine kernels at 1 while their phases turn. An evolution t multiplies J(a.x)
// J(a.y) in gabor_kernel by 1 - u, the mean of cos(4 pi k t) = 1 - 2 sin^2(2 pi k t) over the phase rates k.
fn gabor_impl_phase_gain(kernel: GaborKernel, evolution: f32) -> f32 {
    var sines: vec4<f32>;
    var u_1: f32;
    if (true || (evolution == 0f)) {
        return 1f;
    }
    let _e9 = gabor_impl_sine(evolution);
    let _e12 = gabor_impl_sine((2f * evolution));
    let _e15 = gabor_impl_sine((3f * evolution));
    let _e18 = gabor_impl_sine((4f * evolution));
    sines = vec4<f32>(_e9, _e12, _e15, _e18);
    let _e22 = sines;
    let _e23 = sines;
    u_1 = (0.5f * dot(_e22, _e23));
    let _e28 = u_1;
    return inverseSqrt((1f + ((_e28 * (1f - kernel.variance_factor)) / kernel.variance_factor)));
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_place(cell: vec2<i32>, local: vec2<f32>) -> GaborPlace {
    return GaborPlace(cell, local, vec2(1f), vec2(0i), 0f);
}

// There are N R^2 impulses per unit area, so by Campbell's theorem
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] J(0)^2 / 2.
// With two phases, sin^2 does not average to 1/2: J(0)^2 - J(a.x) J(a.y) replaces J(0)^2, with a = 4 pi F omega.
fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel {
    var local_6: f32;
    var wave: vec2<f32>;
    var energy_1: GaborEnergy;
    var density: f32 = 1f;
    var power: f32 = 0.7278125f;
    var amplitude: f32;
    var x_1: f32;
    var y_1: f32;
    var variance_factor: f32;
    if (abs(frequency) > 0.000001f) {
        local_6 = abs(frequency);
    } else {
        local_6 = 0.000001f;
    }
    let _e8 = local_6;
    let _e11 = gabor_impl_direction(orientation);
    wave = (min(_e8, 1000000f) * _e11);
    let _e14 = gabor_impl_energy();
    energy_1 = _e14;
    let _e32 = density;
    let _e34 = power;
    let _e36 = energy_1;
    let _e39 = energy_1;
    amplitude = inverseSqrt(((((0.5f * _e32) * _e34) * _e36.sum) * _e39.sum));
    if true {
        let _e47 = wave;
        let _e48 = amplitude;
        return GaborKernel(_e47, _e48, 1f);
    }
    let _e51 = wave;
    let _e53 = energy_1;
    let _e54 = gabor_impl_relative_energy(_e51.x, _e53);
    x_1 = _e54;
    let _e56 = wave;
    let _e58 = energy_1;
    let _e59 = gabor_impl_relative_energy(_e56.y, _e58);
    y_1 = _e59;
    let _e61 = x_1;
    let _e62 = y_1;
    let _e64 = x_1;
    let _e65 = y_1;
    variance_factor = ((_e61 + _e62) - (_e64 * _e65));
    let _e69 = wave;
    let _e70 = amplitude;
    let _e71 = variance_factor;
    let _e74 = variance_factor;
    return GaborKernel(_e69, (_e70 * inverseSqrt(_e71)), _e74);
}

fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    var visited: i32 = 3i;
    var whole: vec2<f32>;
    var local_7: vec2<f32>;
    var first: vec2<f32>;
    var cell_3: vec2<i32>;
    var cell_side: vec2<f32>;
    var evolution_1: f32;
    var seed_word_1: u32;
    var sum: vec2<f32> = vec2(0f);
    var slope_x: vec2<f32> = vec2(0f);
    var slope_y: vec2<f32> = vec2(0f);
    var j: i32 = 0i;
    var row_word_1: u32;
    var i_1: i32;
    var column_1: i32;
    var k_1: i32;
    var word_3: u32;
    var impulse: GaborImpulse;
    var d: vec2<f32>;
    var turns: f32;
    var x_2: vec2<f32>;
    var y_2: vec2<f32>;
    var wave_1: vec2<f32>;
    var turned: vec2<f32>;
    var scale: f32;
    whole = floor(place.local);
    let _e15 = whole;
    local_7 = clamp((place.local - _e15), vec2(0f), vec2(1f));
    let _e23 = local_7;
    first = floor((_e23 - place.cells_per_radius));
    let _e29 = whole;
    let _e30 = first;
    cell_3 = (place.cell + vec2<i32>((_e29 + _e30)));
    let _e35 = first;
    first = (_e35 - vec2(1f));
    cell_side = (vec2(1f) / place.cells_per_radius);
    evolution_1 = fract(place.evolution);
    let _e47 = gabor_impl_seed_word(seed);
    seed_word_1 = _e47;
    loop {
        let _e60 = j;
        let _e61 = visited;
        if !((_e60 < _e61)) {
            break;
        }
        {
            let _e67 = cell_3;
            let _e69 = j;
            let _e73 = gabor_impl_wrap((_e67.y + _e69), place.period.y);
            let _e74 = seed_word_1;
            let _e75 = gabor_impl_row_word(_e73, _e74);
            row_word_1 = _e75;
            i_1 = 0i;
            loop {
                let _e79 = i_1;
                let _e80 = visited;
                if !((_e79 < _e80)) {
                    break;
                }
                {
                    let _e86 = cell_3;
                    let _e88 = i_1;
                    let _e92 = gabor_impl_wrap((_e86.x + _e88), place.period.x);
                    column_1 = _e92;
                    k_1 = 0i;
                    loop {
                        let _e96 = k_1;
                        if !((_e96 < 1i)) {
                            break;
                        }
                        {
                            let _e103 = column_1;
                            let _e104 = row_word_1;
                            let _e105 = k_1;
                            let _e106 = gabor_impl_impulse_word(_e103, _e104, _e105);
                            word_3 = _e106;
                            let _e108 = word_3;
                            let _e109 = gabor_impl_impulse(_e108);
                            impulse = _e109;
                            let _e111 = local_7;
                            let _e112 = impulse;
                            let _e114 = first;
                            let _e115 = i_1;
                            let _e117 = j;
                            let _e123 = cell_side;
                            d = ((_e111 - (_e112.position_plus_one + (_e114 + vec2<f32>(f32(_e115), f32(_e117))))) * _e123);
                            let _e126 = d;
                            let _e129 = d;
                            if (max(abs(_e126.x), abs(_e129.y)) < 1f) {
                                {
                                    let _e136 = d;
                                    let _e138 = impulse;
                                    let _e141 = impulse;
                                    let _e143 = evolution_1;
                                    turns = ((dot(kernel.wave, _e136) + _e138.phase) + (_e141.phase_rate * _e143));
                                    let _e147 = d;
                                    let _e149 = gabor_impl_window(_e147.x);
                                    x_2 = _e149;
                                    let _e151 = d;
                                    let _e153 = gabor_impl_window(_e151.y);
                                    y_2 = _e153;
                                    let _e155 = impulse;
                                    let _e157 = turns;
                                    let _e160 = gabor_impl_sine((_e157 + 0.25f));
                                    let _e161 = turns;
                                    let _e162 = gabor_impl_sine(_e161);
                                    wave_1 = (_e155.magnitude * vec2<f32>(_e160, _e162));
                                    let _e167 = x_2;
                                    let _e170 = y_2;
                                    let _e173 = wave_1;
                                    let _e176 = wave_1;
                                    turned = (((6.2831855f * _e167.x) * _e170.x) * vec2<f32>(-(_e173.y), _e176.x));
                                    let _e181 = sum;
                                    let _e182 = x_2;
                                    let _e184 = y_2;
                                    let _e187 = wave_1;
                                    sum = (_e181 + ((_e182.x * _e184.x) * _e187));
                                    let _e190 = slope_x;
                                    let _e191 = x_2;
                                    let _e193 = y_2;
                                    let _e196 = wave_1;
                                    let _e200 = turned;
                                    slope_x = (_e190 + (((_e191.y * _e193.x) * _e196) + (kernel.wave.x * _e200)));
                                    let _e204 = slope_y;
                                    let _e205 = y_2;
                                    let _e207 = x_2;
                                    let _e210 = wave_1;
                                    let _e214 = turned;
                                    slope_y = (_e204 + (((_e205.y * _e207.x) * _e210) + (kernel.wave.y * _e214)));
                                }
                            }
                        }
                        continuing {
                            let _e100 = k_1;
                            k_1 = (_e100 + 1i);
                        }
                    }
                }
                continuing {
                    let _e83 = i_1;
                    i_1 = (_e83 + 1i);
                }
            }
        }
        continuing {
            let _e64 = j;
            j = (_e64 + 1i);
        }
    }
    let _e228 = evolution_1;
    let _e229 = gabor_impl_phase_gain(kernel, _e228);
    scale = (((kernel.amplitude * 1f) * inverseSqrt((place.cells_per_radius.x * place.cells_per_radius.y))) * _e229);
    let _e232 = scale;
    let _e233 = sum;
    let _e236 = scale;
    let _e237 = slope_x;
    let _e239 = slope_y;
    let _e243 = scale;
    let _e244 = sum;
    let _e247 = scale;
    let _e248 = slope_x;
    let _e250 = slope_y;
    return GaborField((_e232 * _e233.y), (_e236 * vec2<f32>(_e237.y, _e239.y)), (_e243 * _e244.x), (_e247 * vec2<f32>(_e248.x, _e250.x)));
}

fn gabor_noise_at(cell: vec2<i32>, local: vec2<f32>, kernel: GaborKernel, seed: u32) -> f32 {
    let _e4 = gabor_place(cell, local);
    let _e5 = gabor_field(_e4, kernel, seed);
    return _e5.noise;
}

fn gabor_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    let _e8 = gabor_kernel(frequency, orientation);
    let _e9 = gabor_noise_at(vec2(0i), (p * 1f), _e8, seed);
    return _e9;
}

fn gabor_noise_gradient(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec3<f32> {
    var field: GaborField;
    let _e8 = gabor_place(vec2(0i), (p * 1f));
    let _e9 = gabor_kernel(frequency, orientation);
    let _e10 = gabor_field(_e8, _e9, seed);
    field = _e10;
    let _e12 = field;
    let _e14 = field;
    return vec3<f32>(_e12.noise, _e14.gradient.x, _e14.gradient.y);
}

fn gabor_noise_quadrature(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    var field_1: GaborField;
    let _e8 = gabor_place(vec2(0i), (p * 1f));
    let _e9 = gabor_kernel(frequency, orientation);
    let _e10 = gabor_field(_e8, _e9, seed);
    field_1 = _e10;
    let _e12 = field_1;
    let _e14 = field_1;
    return vec2<f32>(_e12.noise, _e14.quadrature);
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

fn gabor_noise_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var period_2: vec2<f32>;
    var cells: vec2<f32>;
    var density_1: vec2<f32>;
    var within: vec2<f32>;
    var place_1: GaborPlace;
    period_2 = period;
    let _e6 = period_2;
    period_2 = max(_e6, vec2(2f));
    let _e10 = period_2;
    cells = floor((_e10 * 1f));
    let _e15 = cells;
    let _e16 = period_2;
    density_1 = (_e15 / _e16);
    let _e19 = period_2;
    let _e22 = period_2;
    within = (p - (floor((p / _e19)) * _e22));
    let _e28 = within;
    let _e29 = density_1;
    let _e31 = density_1;
    let _e32 = cells;
    place_1 = GaborPlace(vec2(0i), (_e28 * _e29), _e31, vec2<i32>(_e32), 0f);
    let _e37 = place_1;
    let _e38 = gabor_kernel(frequency, orientation);
    let _e39 = gabor_field(_e37, _e38, seed);
    return _e39.noise;
}

fn gabor_noise_animated(p: vec2<f32>, evolution: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place_2: GaborPlace;
    let _e9 = gabor_place(vec2(0i), (p * 1f));
    place_2 = _e9;
    place_2.evolution = evolution;
    let _e12 = place_2;
    let _e13 = gabor_kernel(frequency, orientation);
    let _e14 = gabor_field(_e12, _e13, seed);
    return _e14.noise;
}

fn gabor_unorm(noise: f32) -> f32 {
    return clamp((0.5f + (0.25f * noise)), 0f, 1f);
}

