// Generated from gabor_sparse.glsl by tools/translate, for WGSL: change that file, not this one.
// Constants that you may edit: GABOR_IMPULSES, GABOR_CELLS_PER_RADIUS, GABOR_WEIGHT_FLOOR, GABOR_PHASES, GABOR_WINDOW.
//
// gabor_sparse.wgsl: the sparse Gabor noise of Tavernier et al. (2019) in the plane, with mean 0 and variance 1 at
// every point.
//
//     let n = gabor_noise(p, 4.0, 0.7854, 7u);   // 4 cycles per kernel radius, at 45 degrees, seed 7
//     let v = gabor_unorm(n);                    // in [0, 1], for display
//
// Use this file for the paper's own noise. The noise of gabor_noise.wgsl, which has the same functions, is faster and
// is normal at every point. Positions are in kernel radii: a kernel ends one radius from its impulse. Frequencies are
// in cycles per kernel radius.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// 10000 major + 100 minor + patch
const GABOR_NOISE_VERSION: i32 = 30000;

// ---- Macros: define them before the file. The defaults are the recipe `one`; docs/recipes.md lists others ----------

// N, the number of impulses per cell: an i32, at least 1.
const GABOR_IMPULSES: i32 = 1;
// R, cells per kernel radius: an f32, at least 1. Loops visit ceil(2 R) + 1 cells per axis.
const GABOR_CELLS_PER_RADIUS: f32 = 1.0;
// A, an f32 in [0, 1]: weights have magnitude A or 1, with equal probability.
const GABOR_WEIGHT_FLOOR: f32 = 0.675;
// Number of phases, evenly spaced over a turn: a power of two up to 256. 2 gives sine kernels, which integrate to 0.
const GABOR_PHASES: i32 = 256;
// c of the window q(x) = u^2 (c.x + c.y u + c.z u^2), u = 1 - x^2.
const GABOR_WINDOW: vec3f = vec3f(3.0, -4.5, 2.5);

// Define GABOR_UNCHECKED as 1 if the macros are constants that #if cannot evaluate.
const_assert GABOR_IMPULSES >= 1; // GABOR_IMPULSES must be an i32, at least 1
const_assert !(GABOR_PHASES < 2 || GABOR_PHASES > 256 || (GABOR_PHASES & (GABOR_PHASES - 1)) != 0); // GABOR_PHASES must be a power of two, from 2 to 256

// ---- Functions -----------------------------------------------------------------------------------------------------

// fn gabor_noise(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32
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

// fn gabor_noise_gradient(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec3f
//     (noise, d/dx, d/dy), per kernel radius, for constant frequency and orientation.

// fn gabor_noise_quadrature(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec2f
//     (noise, quadrature). The quadrature is the same waves with cosines instead of sines: the two are the imaginary
//     and the real part of a complex noise. At each point they are uncorrelated and have variance 1; with
//     GABOR_PHASES 2, the quadrature has variance 1 only at frequencies of 1.5 or more.

// fn gabor_turns_intensity(noise_quadrature: vec2f) -> vec2f
//     (phase in turns within [0, 1), intensity) of what gabor_noise_quadrature returns. A profile of the phase, such as
//     step(phase, width), is a pattern of even contrast [Tricard et al., Procedural phasor noise, 2019].

// fn gabor_noise_tiled(p: vec2f, period: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32
//     Noise that repeats exactly after `period` kernel radii along x and y, at any frequency and orientation, with the
//     mean and variance of gabor_noise. If period * GABOR_CELLS_PER_RADIUS is an integer, the distribution is also the
//     same. Otherwise cells grow to fit, and values become less normal: with the recipe `one`, cvm (see
//     docs/recipes.md) is 1.1 for 5 % fewer cells per radius, 6.4 for 10 %, and 14 to 425 for square periods of 2.3 to
//     4.9. A period below 2, the diameter of a kernel, counts as 2.

// fn gabor_noise_animated(p: vec2f, evolution: f32, frequency: f32, orientation: f32, seed: u32) -> f32
//     Noise that evolves in place and repeats when `evolution` grows by 1. It always has the statistics of gabor_noise.
//     Its autocorrelation is the mean of cos(2 pi k lag) over k = 1 to 4: 0.87 at a lag of 0.03, 0 at 0.1, -0.38 at
//     0.16. At 3.5 % of all points, the noise hardly changes.

// fn gabor_unorm(noise: f32) -> f32
//     Maps [-2, 2] to [0, 1], for display, and clamps the other 5 % of the values.

// ---- For large worlds, and for periods that evolve -----------------------------------------------------------------

// A wave and its normalization, returned by gabor_kernel.
struct GaborKernel {
    wave: vec2f,          // wave vector, cycles per kernel radius
    amplitude: f32,       // K
    variance_factor: f32, // variance for K = 1, relative to that at high frequencies: 1 unless there are two phases
}

// A position in cells, with a period and an evolution.
struct GaborPlace {
    cell: vec2i,             // any integers except the last few before 2^31, where the world wraps around
    local: vec2f,            // offset from that cell's corner in cells, most precise in [0, 1)^2
    cells_per_radius: vec2f, // along each axis: GABOR_CELLS_PER_RADIUS, or as little as half of it to fit a period
    period: vec2i,           // period in cells, 0 for none
    evolution: f32,          // as in gabor_noise_animated, in turns: only its fraction counts
}

// A noise, its quadrature, and their gradients per kernel radius: see gabor_noise_quadrature. Unused members cost
// nothing.
struct GaborField {
    noise: f32,
    gradient: vec2f,
    quadrature: f32,
    quadrature_gradient: vec2f,
}

// fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel
//     The kernel with a given frequency and orientation; ranges are those of gabor_noise. Compute it once for many
//     calls.

// fn gabor_place(cell: vec2i, local: vec2f) -> GaborPlace
//     The position (cell + local) / GABOR_CELLS_PER_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells
//     along each axis.

// fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField
//     The noise, its quadrature, and their gradients at `place`. All noise functions call it.

// fn gabor_noise_at(cell: vec2i, local: vec2f, kernel: GaborKernel, seed: u32) -> f32
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
// After Tavernier, Neyret, Vergne, Thollot: Making Gabor Noise Fast and Normalized, Eurographics 2019.

fn gabor_impl_needs_int_float_float_int_vec3_macros(n: i32, r: f32, a: f32, phases: i32, window: vec3f) -> f32 {
    return f32(n + phases) + r + a + window.x;
}
fn gabor_impl_check_macros() -> f32 { // a macro of the wrong type fails to compile here
    return gabor_impl_needs_int_float_float_int_vec3_macros(GABOR_IMPULSES, GABOR_CELLS_PER_RADIUS, GABOR_WEIGHT_FLOOR,
                                                            GABOR_PHASES, GABOR_WINDOW);
}

// ---- Randomness ----------------------------------------------------------------------------------------------------

// Odd, and spreads consecutive cells over all 32 bits.
const GABOR_IMPL_CELL_STRIDE: u32 = 0x9e3779b1u;

// Mixes a word in two rounds of shift and multiply, with constants from the hash-prospector project. The salt enters
// between the rounds, so that no salt's sequence is a shifted copy of another's.
fn gabor_impl_mix(word_in: u32, salt: u32) -> u32 {
    var word = word_in;
    word = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// The word of a seed determines the words of the rows of cells, which determine the words of the impulses.
fn gabor_impl_seed_word(seed: u32) -> u32 {
    return gabor_impl_mix(seed * GABOR_IMPL_CELL_STRIDE, 0x2545f491u);
}

fn gabor_impl_row_word(row: i32, seed_word: u32) -> u32 {
    return gabor_impl_mix(u32(row) * GABOR_IMPL_CELL_STRIDE + seed_word, seed_word);
}

// The word of impulse `index` in a cell. Its bits hold y in the cell (0 to 22), x (8 to 30), the phase (0 to 7), the
// phase rate (8 to 10) and the magnitude (31). x and y share bits 8 to 22, the leading bits of y and trailing bits of
// x: only offsets in x below 1/256 of a cell depend on y.
fn gabor_impl_impulse_word(column: i32, row_word: u32, index: i32) -> u32 {
    let salt = row_word + u32(index) * 0x85ebca6bu;
    return gabor_impl_mix(u32(column) * GABOR_IMPL_CELL_STRIDE + salt, salt);
}

// The parts of an impulse's word. Positions are offset by 1, to [1, 2)^2, which avoids a conversion from integers.
struct GaborImplImpulse {
    position_plus_one: vec2f,
    phase: f32,      // phase in turns
    phase_rate: f32, // turns per turn of the evolution: -4 to -1 or 1 to 4
    magnitude: f32,  // magnitude of the weight
}

fn gabor_impl_impulse(word: u32) -> GaborImplImpulse {
    let position_plus_one = vec2f(bitcast<f32>(0x3f800000u | ((word >> 8u) & 0x7fffffu)),
                                  bitcast<f32>(0x3f800000u | (word & 0x7fffffu)));
    let rate = f32((word >> 8u) & 7u) - 4.0;
    return GaborImplImpulse(position_plus_one, fract(position_plus_one.y * (8388608.0 / f32(GABOR_PHASES))),
                            select(rate + 1.0, rate, rate < 0.0), select(GABOR_WEIGHT_FLOOR, 1.0, i32(word) < 0));
}

// sin(2 pi t), as t (1/4 - t^2) times a minimax polynomial in t^2. The error is at most 3e-7 in [-1, 1]; beyond that,
// the rounding of t adds to it.
fn gabor_impl_sine(t_in: f32) -> f32 {
    var t = t_in;
    t = fract(t) - 0.5;
    let s = t * t;
    // fit: see tools/constants.py
    var p = 12.233303 * s - 38.123196;
    p = p * s + 67.0439;
    p = p * s - 64.83468;
    p = p * s + 25.13273;
    return t * (s - 0.25) * p;
}

// The unit vector at an angle in radians, within 1e-7. Multiples of pi/2 are subtracted in three steps, for precision;
// minimax polynomials give the sine and cosine of the rest.
fn gabor_impl_direction(angle: f32) -> vec2f {
    let quarter = floor(angle * 0.63661977 + 0.5); // 2/pi
    var r = angle - quarter * 1.5703125; // 201/128
    r -= quarter * 4.837512969970703e-4; // 4058/2^23
    r -= quarter * 7.549789948768648e-8; // pi/2 - 201/128 - 4058/2^23
    r = select(0.0, r, abs(r) < 1.0); // far outside the range, no digits are left and the direction is arbitrary
    let s = r * r;
    // fits: see tools/constants.py
    let sine = r + r * s * (-0.16666654 + s * (8.3321608e-3 - s * 1.9515295e-4));
    let cosine = 1.0 - 0.5 * s + s * s * (4.1666645e-2 + s * (-1.3887316e-3 + s * 2.4433157e-5));
    let axis = select(vec2f(-sine, cosine), vec2f(cosine, sine), fract(0.5 * quarter) < 0.25);
    return select(-axis, axis, fract(0.25 * quarter) < 0.375);
}

// ---- Normalization -------------------------------------------------------------------------------------------------
// With u = 1 - x^2, q^2 is a polynomial: the sum of c4 u^4 ... c8 u^8. The integral over [-1, 1] of u^n cos(a x) is
// I_n L_n(a), with I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, and L_n(a) = (2n+1)!! j_n(a) / a^n, j_n the spherical
// Bessel function (Poisson's integral, DLMF 10.54.1). GaborImplEnergy holds the five c_n I_n and their sum, the
// integral of q^2.
struct GaborImplEnergy {
    e4567: vec4f,
    e8: f32,
    sum: f32,
}

fn gabor_impl_energy() -> GaborImplEnergy {
    let c = GABOR_WINDOW;
    let e4567 = vec4f(256.0 / 315.0, 512.0 / 693.0, 2048.0 / 3003.0, 4096.0 / 6435.0)
               * vec4f(c.x * c.x, 2.0 * c.x * c.y, c.y * c.y + 2.0 * c.x * c.z, 2.0 * c.y * c.z);
    let e8 = c.z * c.z * (65536.0 / 109395.0);
    return GaborImplEnergy(e4567, e8, dot(e4567, vec4f(1.0)) + e8);
}

// 1 - J(a) / J(0), with J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx and a = 4 pi k: the energy along one axis of
// a sine kernel with k cycles per radius, relative to the energy at high frequency. For small a, it is computed from
// 1 - L_n, by the power series of L_7 and L_8 and downward recurrence; for large a, by upward recurrence from
// L_0 = sin(a) / a:
//     L_(n-1) = L_n - a^2 L_(n+1) / ((2n+1) (2n+3))          (DLMF 10.51.1)
fn gabor_impl_relative_energy(k: f32, energy: GaborImplEnergy) -> f32 {
    let a = 12.566371 * k;
    let z = a * a;
    var d4567: vec4f;
    var d78 = vec2f(0.0);
    if (z < 64.0) {
        var term = vec2f(1.0);
        for (var i = 1; i <= 14; i++) {
            term *= -0.25 * z / (f32(i) * (f32(i) + vec2f(7.5, 8.5)));
            d78 -= term;
        }
        let d6 = d78.x + z * (1.0 - d78.y) * (1.0 / 255.0);
        let d5 = d6 + z * (1.0 - d78.x) * (1.0 / 195.0);
        d4567 = vec4f(d5 + z * (1.0 - d6) * (1.0 / 143.0), d5, d6, d78.x);
    } else {
        let y = 1.0 / z;
        let l0 = gabor_impl_sine(2.0 * k) / a;
        let l1 = 3.0 * y * (l0 - gabor_impl_sine(2.0 * k + 0.25));
        let l2 = 15.0 * y * (l1 - l0);
        let l3 = 35.0 * y * (l2 - l1);
        var l: vec4f;
        l.x = 63.0 * y * (l3 - l2);
        l.y = 99.0 * y * (l.x - l3);
        l.z = 143.0 * y * (l.y - l.x);
        l.w = 195.0 * y * (l.z - l.y);
        d78.y = 1.0 - 255.0 * y * (l.w - l.z);
        d4567 = 1.0 - l;
    }
    return (dot(energy.e4567, d4567) + energy.e8 * d78.y) / energy.sum;
}

// ---- Kernels -------------------------------------------------------------------------------------------------------
// The window q along one axis, which is 0 for |x| >= 1, and its derivative.
fn gabor_impl_window(x: f32) -> vec2f {
    let c = GABOR_WINDOW;
    let u = max(1.0 - x * x, 0.0);
    return vec2f(u * u * (c.x + u * (c.y + u * c.z)), -2.0 * x * u * (2.0 * c.x + u * (3.0 * c.y + u * (4.0 * c.z))));
}

// Wraps a cell's coordinate into a period.
fn gabor_impl_wrap(cell_in: i32, period: i32) -> i32 {
    var cell = cell_in;
    if (period != 0) {
        cell -= cell / max(period, 1) * period; // FXC refuses a division by 0, even one that never runs
        if (cell < 0) { cell += period; }
    }
    return cell;
}

// The gain that keeps the variance of sine kernels at 1 while their phases turn. An evolution t multiplies J(a.x)
// J(a.y) in gabor_kernel by 1 - u, the mean of cos(4 pi k t) = 1 - 2 sin^2(2 pi k t) over the phase rates k.
fn gabor_impl_phase_gain(kernel: GaborKernel, evolution: f32) -> f32 {
    if (GABOR_PHASES != 2 || evolution == 0.0) {
        return 1.0;
    }
    let sines = vec4f(gabor_impl_sine(evolution), gabor_impl_sine(2.0 * evolution),
                      gabor_impl_sine(3.0 * evolution), gabor_impl_sine(4.0 * evolution));
    let u = 0.5 * dot(sines, sines);
    return inverseSqrt(1.0 + u * (1.0 - kernel.variance_factor) / kernel.variance_factor);
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_place(cell: vec2i, local: vec2f) -> GaborPlace {
    return GaborPlace(cell, local, vec2f(GABOR_CELLS_PER_RADIUS), vec2i(0), 0.0);
}

// There are N R^2 impulses per unit area, so by Campbell's theorem
//     1 / K^2 = N R^2 E[w^2] integral(q^2 q^2 sin^2) = N R^2 E[w^2] J(0)^2 / 2.
// With two phases, sin^2 does not average to 1/2: J(0)^2 - J(a.x) J(a.y) replaces J(0)^2, with a = 4 pi F omega.
fn gabor_kernel(frequency: f32, orientation: f32) -> GaborKernel {
    let wave = min(select(1.0e-6, abs(frequency), abs(frequency) > 1.0e-6), 1.0e6) * gabor_impl_direction(orientation);
    let energy = gabor_impl_energy();
    let density = f32(GABOR_IMPULSES) * GABOR_CELLS_PER_RADIUS * GABOR_CELLS_PER_RADIUS;
    let power = 0.5 + 0.5 * GABOR_WEIGHT_FLOOR * GABOR_WEIGHT_FLOOR; // E[w^2]
    let amplitude = inverseSqrt(0.5 * density * power * energy.sum * energy.sum);
    if (GABOR_PHASES != 2) {
        return GaborKernel(wave, amplitude, 1.0);
    }
    let x = gabor_impl_relative_energy(wave.x, energy);
    let y = gabor_impl_relative_energy(wave.y, energy);
    let variance_factor = x + y - x * y;
    return GaborKernel(wave, amplitude * inverseSqrt(variance_factor), variance_factor);
}

fn gabor_field(place: GaborPlace, kernel: GaborKernel, seed: u32) -> GaborField {
    let visited = i32(ceil(2.0 * GABOR_CELLS_PER_RADIUS)) + 1;
    let whole = floor(place.local);
    let local = clamp(place.local - whole, vec2f(0.0), vec2f(1.0)); // the clamp matters only if a compiler fuses this with a product
    var first = floor(local - place.cells_per_radius);
    let cell = place.cell + vec2i(whole + first);
    first -= 1.0; // undoes the 1 of position_plus_one
    let cell_side = 1.0 / place.cells_per_radius;
    let evolution = fract(place.evolution);
    let seed_word = gabor_impl_seed_word(seed);
    var sum = vec2f(0.0); var slope_x = vec2f(0.0); var slope_y = vec2f(0.0); // each (quadrature, noise)
    for (var j = 0; j < visited; j++) {
        let row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), seed_word);
        for (var i = 0; i < visited; i++) {
            let column = gabor_impl_wrap(cell.x + i, place.period.x);
            for (var k = 0; k < GABOR_IMPULSES; k++) {
                let word = gabor_impl_impulse_word(column, row_word, k);
                let impulse = gabor_impl_impulse(word);
                // The sum in the inner brackets is exact, so only one rounding remains.
                let d = (local - (impulse.position_plus_one + (first + vec2f(f32(i), f32(j))))) * cell_side;
                // Only about half of the impulses reach this point. The branch also keeps CPU compilers from spilling
                // registers.
                if (max(abs(d.x), abs(d.y)) < 1.0) {
                    let turns = dot(kernel.wave, d) + impulse.phase + impulse.phase_rate * evolution;
                    let x = gabor_impl_window(d.x);
                    let y = gabor_impl_window(d.y);
                    let wave = impulse.magnitude * vec2f(gabor_impl_sine(turns + 0.25), gabor_impl_sine(turns));
                    // The derivative of e^(2 pi i F x) is 2 pi i F e^(2 pi i F x).
                    let turned = (6.2831853 * x.x * y.x) * vec2f(-wave.y, wave.x);
                    sum += (x.x * y.x) * wave;
                    slope_x += (x.y * y.x) * wave + kernel.wave.x * turned;
                    slope_y += (y.y * x.x) * wave + kernel.wave.y * turned;
                }
            }
        }
    }
    // With fewer cells per radius, fewer impulses reach the point; the scale makes up for this.
    let scale = kernel.amplitude * GABOR_CELLS_PER_RADIUS
        * inverseSqrt(place.cells_per_radius.x * place.cells_per_radius.y)
                * gabor_impl_phase_gain(kernel, evolution);
    return GaborField(scale * sum.y, scale * vec2f(slope_x.y, slope_y.y), scale * sum.x,
                      scale * vec2f(slope_x.x, slope_y.x));
}

fn gabor_noise_at(cell: vec2i, local: vec2f, kernel: GaborKernel, seed: u32) -> f32 {
    return gabor_field(gabor_place(cell, local), kernel, seed).noise;
}

fn gabor_noise(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32 {
    return gabor_noise_at(vec2i(0), p * GABOR_CELLS_PER_RADIUS, gabor_kernel(frequency, orientation), seed);
}

fn gabor_noise_gradient(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec3f {
    let field = gabor_field(gabor_place(vec2i(0), p * GABOR_CELLS_PER_RADIUS),
                            gabor_kernel(frequency, orientation), seed);
    return vec3f(field.noise, field.gradient);
}

fn gabor_noise_quadrature(p: vec2f, frequency: f32, orientation: f32, seed: u32) -> vec2f {
    let field = gabor_field(gabor_place(vec2i(0), p * GABOR_CELLS_PER_RADIUS),
                            gabor_kernel(frequency, orientation), seed);
    return vec2f(field.noise, field.quadrature);
}

fn gabor_turns_intensity(noise_quadrature: vec2f) -> vec2f {
    let intensity = length(noise_quadrature.yx);
    let phase = select(0.0, atan2(noise_quadrature.x, noise_quadrature.y) * 0.15915494, intensity > 0.0); // 1/(2 pi)
    return vec2f(select(phase, min(phase + 1.0, 0.99999994), phase < 0.0), intensity); // 1 - 2^-24
}

fn gabor_noise_tiled(p: vec2f, period_in: vec2f, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var period = period_in;
    period = max(period, vec2f(2.0));
    let cells = floor(period * GABOR_CELLS_PER_RADIUS);
    let density = cells / period;
    let within = p - floor(p / period) * period;
    let place = GaborPlace(vec2i(0), within * density, density, vec2i(cells), 0.0);
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).noise;
}

fn gabor_noise_animated(p: vec2f, evolution: f32, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var place = gabor_place(vec2i(0), p * GABOR_CELLS_PER_RADIUS);
    place.evolution = evolution;
    return gabor_field(place, gabor_kernel(frequency, orientation), seed).noise;
}

fn gabor_unorm(noise: f32) -> f32 {
    return clamp(0.5 + 0.25 * noise, 0.0, 1.0);
}
