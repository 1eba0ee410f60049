// Generated from gabor_fractal.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl.
//
// gabor_fractal.wgsl: fBm, billows, ridges and warps of smooth or Perlin-like noise, each with mean 0 and variance 1.
//
//     let clouds = gabor_fbm(p, 5.0, 0.5, 7u);                 // 5 octaves, each half as strong, seed 7
//     let sky = gabor_uniform(clouds) < 0.3 ? 1.0 : 0.0;       // covers 30 % of the area
//
//     I want                                   call
//     fBm, billows, ridges                     gabor_fbm, gabor_billow, gabor_ridged
//     the same in a volume                     gabor_fbm_3d, or a place, then gabor_fractal_noise_3d
//     one octave                               gabor_smooth, or gabor_perlin, which replaces Perlin and simplex noise
//     derivatives, periods, other octaves      a place and a GaborFractal, then gabor_fractal_noise
//     no flicker in the distance               gabor_fractal_noise_filtered
//     marble, smoke, swirls                    gabor_warp, then any noise at the place that it returns
//     a flow without sources                   vec2f(-g.y, g.x), where g is the gradient of any noise
//
// All noises have mean 0 and variance 1 at every point, for any number of octaves, gain, period and evolution. One
// octave and fBm are normal; so gabor_uniform gives their rank among all values. Octaves are independent, and each is
// turned against the previous one.
//
// Arguments of all functions, besides those of gabor_noise.wgsl:
//     octaves  1 to 16. The last octave fades in with the fraction: at 4.3, the fifth has 0.3 of its amplitude. Keep
//              |p| lacunarity^octaves below 2^30.
//     gain     amplitude of an octave relative to the previous one, 0 to 4
//     dx, dy   the pixel: see gabor_filter.wgsl
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

const_assert GABOR_TAPS == 3; // gabor_fractal.wgsl needs GABOR_TAPS 3

// The noise of an octave. Smooth noise has most power at low frequencies: within 0.5 cycles per kernel radius. Perlin
// noise has little there: the centroid of its spectrum is 0.52 cycles per kernel radius. Along the axes of their
// lattice, they have 0.97 and 0.92 of the power along the diagonals.
const GABOR_SMOOTH: i32 = 0;
const GABOR_PERLIN: i32 = 1;

// What the octaves n become before they are summed: n; |n|, minus its mean and over its deviation; or minus that.
const GABOR_FBM: i32 = 0;
const GABOR_BILLOW: i32 = 1;
const GABOR_RIDGED: i32 = 2;

struct GaborFractal {
    octaves: f32,
    gain: f32,
    lacunarity: f32, // frequency of an octave relative to the previous one, 1 to 4, rounded to a multiple of 1/4096
    turn: f32,       // angle in radians by which an octave is turned against the previous one, unused with a period
    basis: i32,      // GABOR_SMOOTH or GABOR_PERLIN
    shape: i32,      // GABOR_FBM, GABOR_BILLOW or GABOR_RIDGED
}

// fn gabor_fractal(octaves: f32, gain: f32) -> GaborFractal
//     fBm of smooth noise, with lacunarity 2 and turns of 0.6435 radians.

struct GaborFractalNoise {
    noise: f32,
    gradient: vec2f, // per kernel radius of the first octave, with a filter at a fixed footprint
    removed: f32,    // share of the variance that a filter removed
    lost: vec3f,     // covariance xx, yy, xy of the slopes that a filter removed, such as materials add to roughness
}

struct GaborFractalNoise3d {
    noise: f32,
    gradient: vec3f,
    removed: f32,
    lost: vec3f,       // covariance xx, yy, zz
    lost_mixed: vec3f, // covariance xy, xz, yz
}

// fn gabor_smooth(p: vec2f, seed: u32) -> f32
// fn gabor_perlin(p: vec2f, seed: u32) -> f32
// fn gabor_perlin_3d(p: vec3f, seed: u32) -> f32
//     One octave. gabor_perlin's p is in the cells of Perlin noise, so both have the same size; to match its contrast,
//     multiply by its deviation, 0.25 to 0.3: see docs/other-noises.md.

// fn gabor_fbm(p: vec2f, octaves: f32, gain: f32, seed: u32) -> f32
// fn gabor_fbm_3d(p: vec3f, octaves: f32, gain: f32, seed: u32) -> f32
// fn gabor_billow(p: vec2f, octaves: f32, gain: f32, seed: u32) -> f32
// fn gabor_ridged(p: vec2f, octaves: f32, gain: f32, seed: u32) -> f32
//     Sums of smooth octaves. Ridges are billows upside down: at most 1.32 for one octave.

// fn gabor_fractal_noise(place: GaborPlace, fractal: GaborFractal, seed: u32) -> GaborFractalNoise
// fn gabor_fractal_noise_3d(place: GaborPlace3d, fractal: GaborFractal, seed: u32) -> GaborFractalNoise3d
//     Any sum of octaves at a place. Its evolution changes all octaves in place, and repeats when it grows by 1. With a
//     period of at least 8/3 kernel radii, every octave has a whole number of nodes along it, and none is turned.
//     Gradients of fBm are continuous. The variance of a smooth octave's is the same everywhere; a Perlin octave's is
//     0.6 to 1.5 of the mean, largest at nodes. Lit alone, a smooth octave shows where its second derivatives jump.

// fn gabor_fractal_noise_filtered(place: GaborPlace, dx: vec2f, dy: vec2f, fractal: GaborFractal, seed: u32) -> GaborFractalNoise
// fn gabor_fractal_noise_3d_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, GaborFractal fractal, -> GaborFractalNoise3d
//                                                     u32 seed)
//     The sum averaged over a pixel. |n| becomes its mean over what was removed, so billows and ridges keep their
//     brightness. The noise's rms error is 0.02 of a deviation for one smooth octave whose pixel has a standard
//     deviation of 0.1 kernel radii, and 0.23 for 1. Octaves that keep less than 1/1000 of their variance are left out.

// A warp moves a place along two noises, or three in a volume, whose deviation is its strength in kernel radii.
struct GaborWarp {
    place: GaborPlace, // moved
    dx: vec2f,         // the moved position's derivative along x: a gradient g there becomes (dot(g, dx), dot(g, dy)),
    dy: vec2f,         // and a pixel (a, b) becomes a dx + b dy
    lost: vec3f,       // what a filter removed of it adds dot(g, g) times this to the lost slopes of a noise there
}

struct GaborWarp3d {
    place: GaborPlace3d,
    dx: vec3f,
    dy: vec3f,
    dz: vec3f,
    lost: vec3f,       // xx, yy, zz
    lost_mixed: vec3f, // xy, xz, yz
}

// fn gabor_warp(place: GaborPlace, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp
// fn gabor_warp_filtered(place: GaborPlace, dx: vec2f, dy: vec2f, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp
// fn gabor_warp_3d(place: GaborPlace3d, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp3d
// fn gabor_warp_3d_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, strength: f32, GaborFractal fractal, -> GaborWarp3d
//                                    u32 seed)
//     The place moved by a warp, plain or filtered.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// An octave is noise on the lattice of gabor_noise.wgsl, with node spacings as unit of length. Smooth noise has real
// amplitudes A, Perlin noise gradients (A, B) at its nodes c:
//
//     smooth = sum A_c u(x) u(y),   Perlin = 1/sqrt(2) sum A_c v(x) u(y) + B_c u(x) v(y).
//
// u is a window h, and v its derivative h', of p - c. Each is divided by the root of the sum of its squares over the
// nodes that reach the point, so that the variance is 1 at every point. Smooth noise has Hann's window over three
// nodes. For Perlin noise, h = c^2 over four nodes, where c = (1 + cos(pi d / 2)) / 2: h'' is continuous, and so is the
// gradient.
//
// A filter widens the windows: with the pixel's deviation s along the axis, Hann's to a half-width of
// 3/2 sqrt(1 + s^2 / 0.294), at most 2; and Perlin noise's to c^2 (1 + t (1 - c)), where t = 5.5 s^2, at most 2. Each
// window is then multiplied by its correlation with the exactly filtered one, averaged over places: see
// gabor_impl_kept_even and gabor_impl_kept_odd. A pixel that is oblique to the axes keeps more: its covariance
// multiplies smooth noise by 1 / (1 - k^2 / 2), where k = 2.9 s_xy / sqrt((1 + 2.9 s_x^2) (1 + 2.9 s_y^2)), and Perlin
// noise by the cube of that.

// The windows of four nodes along an axis, from the one at or before node -1, and their derivatives.
struct GaborImplLine {
    word: vec4u,
    even: vec4f, // u, for three nodes with w = 0
    even_slope: vec4f,
    odd: vec4f,  // v
    odd_slope: vec4f,
}

// The squared correlations of filtered windows u and v with the exactly filtered ones: their roots are within 0.006.
fn gabor_impl_kept_even(variance: f32) -> f32 {
    return inverseSqrt(1.0 + variance * (2.888 + 1.52 * variance * variance / (variance + 0.5855)));
}

fn gabor_impl_kept_odd(variance: f32) -> f32 {
    let y = inverseSqrt(1.0 + variance * (2.704 + 1.173 * variance * variance / (variance + 0.149)));
    return y * y * y;
}

// Hann's windows as gabor_impl_windows returns them: the sum must be divided by the root of GABOR_IMPL_ENERGY, and its
// derivatives by GABOR_CELLS_PER_RADIUS as well.
fn gabor_impl_smooth_line(cell: i32, local: f32, period: i32, salt: u32) -> GaborImplLine {
    let zero = floor(local + 0.5);
    var value: vec4f; var slope: vec4f;
    gabor_impl_windows(clamp(local - zero, -0.5, 0.5), &value, &slope);
    return GaborImplLine(gabor_impl_four_line_words(cell + i32(zero), period, salt), value, slope, vec4f(0.0),
                         vec4f(0.0));
}

// Divides a window and its derivative by the root of the sum of the squared windows, and multiplies both by `kept`.
fn gabor_impl_normalize_windows(value: ptr<function, vec4f>, slope: ptr<function, vec4f>, kept: f32) {
    let scale = inverseSqrt(dot((*value), (*value)));
    *value *= scale;
    *slope = kept * scale * ((*slope) - dot((*value), (*slope)) * (*value));
    *value *= kept;
}

// One over the half-width of Hann's windows, in node spacings, for a filter.
fn gabor_impl_inverse_width(variance: f32) -> f32 {
    return inverseSqrt(min(2.25 + 7.6530612 * variance, 4.0)); // 2.25 / 0.294
}

// Those windows, not normalized: the sum of their squares is within 1 % of 3/4 of the half-width. The nodes are at
// -3/2, -1/2, 1/2 and 3/2 times an angle from the middle, which is at the angle of `a`.
fn gabor_impl_smooth_line_filtered(cell: i32, local: f32, period: i32, salt: u32, inverse_width: f32) -> GaborImplLine {
    let zero = floor(local); let d = clamp(local - zero, 0.0, 1.0);
    let a = 0.5 * gabor_impl_half_turn(0.5 * inverse_width * (d - 0.5));
    let inner = gabor_impl_half_turn(0.25 * inverse_width);
    let square = 4.0 * inner.x * inner.x;
    let outer = inner * vec2f(square - 3.0, square - 1.0); // the cosine and sine of thrice the angle
    let cosine = a.x * vec4f(outer.x, inner.x, inner.x, outer.x) - a.y * vec4f(outer.y, inner.y, -inner.y, -outer.y);
    let sine = a.y * vec4f(outer.x, inner.x, inner.x, outer.x) + a.x * vec4f(outer.y, inner.y, -inner.y, -outer.y);
    var value = 0.5 + cosine; var slope = -3.1415927 * inverse_width * sine; // pi
    let first = (d + 1.0) * inverse_width < 1.0; let last = (2.0 - d) * inverse_width < 1.0;
    value = vec4f(select(0.0, value.x, first), value.yz, select(0.0, value.w, last));
    slope = vec4f(select(0.0, slope.x, first), slope.yz, select(0.0, slope.w, last));
    return GaborImplLine(gabor_impl_four_line_words(cell + i32(zero), period, salt), value, slope, vec4f(0.0),
                         vec4f(0.0));
}

// How much a filter widens Perlin noise's windows: t in the comment above.
fn gabor_impl_widening(variance: f32) -> f32 {
    return min(5.5 * variance, 2.0);
}

// A variance of 0 is no filter.
fn gabor_impl_perlin_line(cell: i32, local: f32, period: i32, salt: u32, variance: f32) -> GaborImplLine {
    let zero = floor(local); let t = gabor_impl_widening(variance);
    let turn = gabor_impl_half_turn(0.25 * clamp(local - zero, 0.0, 1.0));
    let cosine = vec4f(-turn.y, turn.x, turn.y, -turn.x); // of pi d / 2
    let hann = 0.5 + 0.5 * cosine; let hann_slope = 0.78539816 * vec4f(-turn.x, -turn.y, turn.x, turn.y); // pi/4
    let share = 2.0 + 2.0 * t - 3.0 * t * hann;
    var even = hann * hann * (1.0 + t - t * hann); var even_slope = hann_slope * hann * share; var odd = even_slope;
    var odd_slope = -1.2337006 * cosine * hann * share + hann_slope * hann_slope * (share - 3.0 * t * hann); // pi^2/8
    gabor_impl_normalize_windows(&even, &even_slope, sqrt(gabor_impl_kept_even(variance)));
    gabor_impl_normalize_windows(&odd, &odd_slope, sqrt(gabor_impl_kept_odd(variance)));
    return GaborImplLine(gabor_impl_four_line_words(cell + i32(zero), period, salt), even, even_slope, odd, odd_slope);
}

// Adds a row of nodes of smooth noise to (value, d/dx, d/dy). `even` is the row's window and its derivative.
fn gabor_impl_add_smooth_row(sum: ptr<function, vec3f>, x: GaborImplLine, word: u32, even: vec2f, four: bool,
                             evolution: f32) {
    let words = x.word * word;
    var a = vec4f(gabor_impl_amplitude_at(words.x, evolution).x, gabor_impl_amplitude_at(words.y, evolution).x,
                  gabor_impl_amplitude_at(words.z, evolution).x, 0.0);
    if (four) { a.w = gabor_impl_amplitude_at(words.w, evolution).x; }
    var row = dot(x.even.xyz, a.xyz); var side = dot(x.even_slope.xyz, a.xyz);
    if (four) {
        row += x.even.w * a.w;
        side += x.even_slope.w * a.w;
    }
    *sum += vec3f(even.x * row, even.x * side, even.y * row);
}

// A smooth noise and its gradient. `four` is whether the windows of four nodes reach a point, not three.
fn gabor_impl_smooth_sum(x: GaborImplLine, y: GaborImplLine, four: bool, evolution: f32) -> vec3f {
    var sum = vec3f(0.0);
    gabor_impl_add_smooth_row(&sum, x, y.word.x, vec2f(y.even.x, y.even_slope.x), four, evolution);
    gabor_impl_add_smooth_row(&sum, x, y.word.y, vec2f(y.even.y, y.even_slope.y), four, evolution);
    gabor_impl_add_smooth_row(&sum, x, y.word.z, vec2f(y.even.z, y.even_slope.z), four, evolution);
    if (four) { gabor_impl_add_smooth_row(&sum, x, y.word.w, vec2f(y.even.w, y.even_slope.w), four, evolution); }
    return sum / GABOR_IMPL_DEVIATION;
}

// The same for Perlin noise. `even` and `odd` are the row's windows and their derivatives.
fn gabor_impl_add_perlin_row(sum: ptr<function, vec3f>, x: GaborImplLine, word: u32, even: vec2f, odd: vec2f,
                             evolution: f32) {
    let words = x.word * word;
    let g0 = gabor_impl_amplitude_at(words.x, evolution); let g1 = gabor_impl_amplitude_at(words.y, evolution);
    let g2 = gabor_impl_amplitude_at(words.z, evolution); let g3 = gabor_impl_amplitude_at(words.w, evolution);
    let a = vec4f(g0.x, g1.x, g2.x, g3.x); let b = vec4f(g0.y, g1.y, g2.y, g3.y);
    let odd_row = dot(x.odd, a); let even_row = dot(x.even, b);
    *sum += vec3f(even.x * odd_row + odd.x * even_row, even.x * dot(x.odd_slope, a) + odd.x * dot(x.even_slope, b),
                  even.y * odd_row + odd.y * even_row);
}

// The sum of two of a Perlin noise's terms, with variance 2.
fn gabor_impl_perlin_sum(x: GaborImplLine, y: GaborImplLine, evolution: f32) -> vec3f {
    var sum = vec3f(0.0);
    gabor_impl_add_perlin_row(&sum, x, y.word.x, vec2f(y.even.x, y.even_slope.x), vec2f(y.odd.x, y.odd_slope.x),
                              evolution);
    gabor_impl_add_perlin_row(&sum, x, y.word.y, vec2f(y.even.y, y.even_slope.y), vec2f(y.odd.y, y.odd_slope.y),
                              evolution);
    gabor_impl_add_perlin_row(&sum, x, y.word.z, vec2f(y.even.z, y.even_slope.z), vec2f(y.odd.z, y.odd_slope.z),
                              evolution);
    gabor_impl_add_perlin_row(&sum, x, y.word.w, vec2f(y.even.w, y.even_slope.w), vec2f(y.odd.w, y.odd_slope.w),
                              evolution);
    return sum / GABOR_IMPL_DEVIATION;
}

fn gabor_impl_nodes(cell: i32, local: f32, period: i32, salt: u32, variance: f32, basis: i32, filtered: bool) -> GaborImplLine {
    var line: GaborImplLine;
    if (basis == GABOR_PERLIN) { line = gabor_impl_perlin_line(cell, local, period, salt, variance); }
    else if (filtered) {
        line = gabor_impl_smooth_line_filtered(cell, local, period, salt, gabor_impl_inverse_width(variance));
        var even = line.even; var slope = line.even_slope;
        gabor_impl_normalize_windows(&even, &slope, sqrt(gabor_impl_kept_even(variance)));
        line.even = even;
        line.even_slope = slope;
    }
    else { line = gabor_impl_smooth_line(cell, local, period, salt); }
    return line;
}

// The variances of the derivatives of u and v per node spacing, averaged over places. Hann's window of half-width w has
// pi^2/3 w^-2. Perlin noise's window is a sum of cosines of multiples of pi d / 2.
fn gabor_impl_slope_powers(variance: f32, perlin: bool) -> vec2f {
    if (!perlin) {
        let inverse_width = gabor_impl_inverse_width(variance);
        return vec2f(3.2898681 * inverse_width * inverse_width, 0.0); // pi^2/3
    }
    let t = gabor_impl_widening(variance); let mean = 0.375 + 0.0625 * t;
    var power = vec3f(0.5 + 0.03125 * t, 0.125 - 0.0625 * t, 0.03125 * t);
    power *= power;
    let slope = dot(power, vec3f(1.0, 4.0, 9.0));
    return 2.4674011 * vec2f(slope / (2.0 * mean * mean + dot(power, vec3f(1.0))),
                             dot(power, vec3f(1.0, 16.0, 81.0)) / slope); // pi^2/4
}

fn gabor_impl_octave_salt(seed: u32, octave: i32) -> u32 {
    return gabor_impl_mix(seed * 0x9e3779b1u + u32(octave) * 0x85ebca6bu, 0xc2b2ae35u);
}

// By how much an oblique pixel keeps more of two axes' windows.
fn gabor_impl_oblique(covariance: f32, variance_x: f32, variance_y: f32) -> f32 {
    // 4.205 is 2.9^2 / 2
    return 1.0 / (1.0 - 4.205 * covariance * covariance / ((1.0 + 2.9 * variance_x) * (1.0 + 2.9 * variance_y)));
}

// 1, but 0 for what keeps less than 1/1000 of its variance.
fn gabor_impl_visible(kept: f32) -> f32 {
    return clamp(1000.0 * kept - 1.0, 0.0, 1.0);
}

// The mean of |n + sqrt(1 - kept) z| over a normal z of variance 1, and its derivative by n. 0.79788456 is sqrt(2/pi).
fn gabor_impl_mean_magnitude(n: f32, kept: f32) -> vec2f {
    let deviation = sqrt(max(1.0 - kept, 1.0e-8));
    let t = clamp(n / deviation, -9.0, 9.0); let slope = 2.0 * gabor_uniform(t) - 1.0;
    return select(vec2f(abs(n), sign(n)), vec2f(0.79788456 * deviation * exp(-0.5 * t * t) + n * slope, slope), kept < 1.0);
}

// The variance of |n| that is left where a filter leaves n the share `kept`, within 8e-6. With correlation r, two
// normal values have E|a b| = 2/pi (sqrt(1 - r^2) + r asin(r)), but some drivers' asin errs by 4e-4.
fn gabor_impl_kept_magnitude(kept: f32) -> f32 {
    let square = min(kept * kept, 1.0); let rest = 1.0 - square;
    // fit: see tools/constants.py
    return square * (0.65746669 - 0.07981755 * square) + rest * sqrt(rest) * (0.19638946 + 0.01788676 * rest)
         - 0.21427622;
}

fn gabor_fractal(octaves: f32, gain: f32) -> GaborFractal {
    // 0.64350111, atan(3/4), was chosen because five such turns spread evenly over a right angle
    return GaborFractal(octaves, gain, 2.0, 0.64350111, GABOR_SMOOTH, GABOR_FBM);
}

// ---- In the plane --------------------------------------------------------------------------------------------------

// A place on the lattice of an octave. A unit of x or y in kernel radii of the first octave is along_x or along_y.
struct GaborImplOctave {
    cell: vec2i,
    local: vec2f,
    period: vec2i,
    along_x: vec2f,
    along_y: vec2f,
}

// A multiple of 1/4096, so that its product with a cell splits exactly into integer and fraction.
fn gabor_impl_octave_step(fractal: GaborFractal) -> vec2f {
    let turn = gabor_impl_wave(0.15915494 * clamp(fractal.turn, -1.0e6, 1.0e6)); // 1/(2 pi)
    return floor(4096.0 * clamp(fractal.lacunarity, 1.0, 4.0) * turn + 0.5) / 4096.0;
}

// How many nodes octave i has along a period of `nodes`, and a factor for an axis without a period.
fn gabor_impl_octave_nodes(nodes: f32, scale: f32) -> f32 {
    return select(scale, min(floor(nodes * scale + 0.5), 1.0e9), nodes > 0.0);
}

// Goes to octave i from the previous one, or with a period from the first one. Its lattice is moved, so that its nodes
// are not those of the previous one.
fn gabor_impl_next_octave(octave: ptr<function, GaborImplOctave>, place: GaborPlace, by: vec2f, lacunarity: f32,
                          i: i32) {
    let moved = vec2f(0.382, 0.731);
    if (place.period.x == 0 && place.period.y == 0) {
        (*octave).local = gabor_impl_product(by, (*octave).local) + moved;
        if (place.cell.x != 0 || place.cell.y != 0) {
            let m = vec2i(by * 4096.0); let low = (*octave).cell & vec2i(4095);
            let high = vec2u((*octave).cell >> vec2u(vec2i(12))); let n = vec2u(m);
            let part = m.x * low + m.y * vec2i(-low.y, low.x);
            (*octave).cell = vec2i(n.x * high + n.y * vec2u(0u - high.y, high.x)) + (part >> vec2u(vec2i(12)));
            (*octave).local += vec2f(part & vec2i(4095)) / 4096.0;
        }
        (*octave).along_x = gabor_impl_product(by, (*octave).along_x);
        (*octave).along_y = gabor_impl_product(by, (*octave).along_y);
    } else {
        let scale = pow(clamp(lacunarity, 1.0, 4.0), f32(i));
        let first = vec2f(place.period);
        let within = vec2f(f32(gabor_impl_wrap(place.cell.x, place.period.x)),
                           f32(gabor_impl_wrap(place.cell.y, place.period.y))) + place.local;
        let nodes = vec2f(gabor_impl_octave_nodes(first.x, scale), gabor_impl_octave_nodes(first.y, scale));
        let growth = nodes / max(first, vec2f(1.0));
        (*octave).cell = vec2i(0);
        (*octave).local = growth * (within - first * floor(within / max(first, vec2f(1.0)))) + f32(i) * moved;
        (*octave).period = vec2i(select(i32(nodes.x), 0, place.period.x == 0), select(i32(nodes.y), 0, place.period.y == 0));
        (*octave).along_x = vec2f(growth.x * place.cells_per_radius.x, 0.0);
        (*octave).along_y = vec2f(0.0, growth.y * place.cells_per_radius.y);
    }
}

// The noise of an octave, and its gradient per node spacing.
fn gabor_impl_octave_noise(octave: GaborImplOctave, salt: u32, variance: vec2f, basis: i32, filtered: bool,
                           evolution: f32) -> vec3f {
    let x = gabor_impl_nodes(octave.cell.x, octave.local.x, octave.period.x, salt, variance.x, basis,
                            filtered);
    let y = gabor_impl_nodes(octave.cell.y, octave.local.y, octave.period.y, salt ^ GABOR_IMPL_ROWS,
                            variance.y, basis, filtered);
    var noise: vec3f;
    if (basis == GABOR_PERLIN) { noise = 0.70710678 * gabor_impl_perlin_sum(x, y, evolution); } // 1/sqrt(2)
    else { noise = gabor_impl_smooth_sum(x, y, filtered, evolution); }
    if (basis != GABOR_PERLIN && !filtered) {
        noise *= vec3f(1.0, vec2f(1.0 / GABOR_CELLS_PER_RADIUS)) / GABOR_IMPL_ENERGY;
    }
    return noise;
}

// Adds an octave (value, d/dx, d/dy per node spacing) to the sum, of which `kept` of the variance is left, with an
// amplitude. `lost` is the variance of its lost slopes along the lattice's axes.
fn gabor_impl_add_octave(sum: ptr<function, GaborFractalNoise>, octave: GaborImplOctave, shape: i32, amplitude_in: f32,
                         noise: vec3f, kept_in: f32, lost: vec2f) {
    var amplitude = amplitude_in;
    var kept = kept_in;
    var gradient = vec2f(dot(noise.yz, octave.along_x), dot(noise.yz, octave.along_y));
    var covariance = vec3f(dot(lost, octave.along_x * octave.along_x), dot(lost, octave.along_y * octave.along_y),
                           dot(lost, octave.along_x * octave.along_y));
    var value = noise.x;
    if (shape != GABOR_FBM) {
        let mean = gabor_impl_mean_magnitude(value, kept);
        value = mean.x - 0.79788456; // sqrt(2/pi)
        covariance += (1.0 - mean.y * mean.y) * vec3f(gradient * gradient, gradient.x * gradient.y);
        gradient *= mean.y;
        kept = gabor_impl_kept_magnitude(kept);
        amplitude *= select(1.6588967, -1.6588967, shape == GABOR_RIDGED); // 1/sqrt(1 - 2/pi)
    }
    (*sum).noise += amplitude * value;
    (*sum).gradient += amplitude * gradient;
    (*sum).removed += amplitude * amplitude * kept;
    (*sum).lost += amplitude * amplitude * covariance;
}

fn gabor_impl_fractal(place: GaborPlace, filtered: bool, dx_in: vec2f, dy_in: vec2f, fractal: GaborFractal, seed: u32) -> GaborFractalNoise {
    var dx = dx_in;
    var dy = dy_in;
    var sum = GaborFractalNoise(0.0, vec2f(0.0), 0.0, vec3f(0.0));
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: nothing is left
        dx = vec2f(1.0e3, 0.0);
        dy = vec2f(0.0, 1.0e3);
    }
    var octave = GaborImplOctave(place.cell, place.local, place.period, vec2f(place.cells_per_radius.x, 0.0),
                                 vec2f(0.0, place.cells_per_radius.y));
    let by = gabor_impl_octave_step(fractal);
    let octaves = clamp(fractal.octaves, 1.0, 16.0); var amplitude = 1.0; var power = 0.0;
    let perlin = fractal.basis == GABOR_PERLIN;
    let count = i32(ceil(octaves));
    for (var i = 0; i < count; i++) {
        let weight = amplitude * min(octaves - f32(i), 1.0);
        power += weight * weight;
        amplitude *= fractal.gain;
        let salt = gabor_impl_octave_salt(seed, i);
        var variance = vec2f(0.0); var lost = vec2f(0.0);
        var oblique = 1.0; var kept = 1.0;
        if (filtered) {
            let a = clamp(0.5 * (dx.x * octave.along_x + dx.y * octave.along_y), vec2f(-1.0e3), vec2f(1.0e3));
            let b = clamp(0.5 * (dy.x * octave.along_x + dy.y * octave.along_y), vec2f(-1.0e3), vec2f(1.0e3));
            variance = a * a + b * b;
            oblique = gabor_impl_oblique(a.x * a.y + b.x * b.y, variance.x, variance.y);
            let even = vec2f(gabor_impl_kept_even(variance.x), gabor_impl_kept_even(variance.y));
            kept = even.x * even.y;
            let x = gabor_impl_slope_powers(variance.x, perlin); let y = gabor_impl_slope_powers(variance.y, perlin);
            var slopes = kept * vec2f(x.x, y.x); // of u(x) u(y), or the terms of v(x) u(y) and u(x) v(y)
            if (perlin) {
                var odd = vec2f(gabor_impl_kept_odd(variance.x), gabor_impl_kept_odd(variance.y));
                odd = 0.5 * kept * odd / even;
                slopes = vec2f(odd.x * x.y + odd.y * x.x, odd.x * y.x + odd.y * y.y);
                kept = odd.x + odd.y;
                oblique *= oblique * oblique;
            }
            oblique = min(oblique, inverseSqrt(kept)) * gabor_impl_visible(kept * oblique * oblique);
            kept *= oblique * oblique;
            lost = max(select(1.4621636, 2.6788926, perlin) - oblique * oblique * slopes, vec2f(0.0)); // 19/70 pi^2, 4/27 pi^2
        }
        var noise = vec3f(0.0);
        if (kept > 0.0) {
            noise = gabor_impl_octave_noise(octave, salt, variance, fractal.basis, filtered, place.evolution);
            if (filtered) { noise *= oblique; }
        }
        gabor_impl_add_octave(&sum, octave, fractal.shape, weight, noise, kept, lost);
        gabor_impl_next_octave(&octave, place, by, fractal.lacunarity, i + 1);
    }
    let scale = inverseSqrt(max(power, 1.0e-30));
    sum.noise *= scale;
    sum.gradient *= scale;
    sum.lost *= scale * scale;
    sum.removed = select(0.0, clamp(1.0 - scale * scale * sum.removed, 0.0, 1.0), filtered);
    return sum;
}

fn gabor_fractal_noise(place: GaborPlace, fractal: GaborFractal, seed: u32) -> GaborFractalNoise {
    return gabor_impl_fractal(place, false, vec2f(0.0), vec2f(0.0), fractal, seed);
}

fn gabor_fractal_noise_filtered(place: GaborPlace, dx: vec2f, dy: vec2f, fractal: GaborFractal, seed: u32) -> GaborFractalNoise {
    return gabor_impl_fractal(place, true, dx, dy, fractal, seed);
}

fn gabor_smooth(p: vec2f, seed: u32) -> f32 {
    return gabor_fractal_noise(gabor_place_at(p), gabor_fractal(1.0, 0.0), seed).noise;
}

fn gabor_perlin(p: vec2f, seed: u32) -> f32 {
    var fractal = gabor_fractal(1.0, 0.0);
    fractal.basis = GABOR_PERLIN;
    // the centroids of the spectra are 0.62 cycles per cell of Perlin noise and 0.5227 per kernel radius
    return gabor_fractal_noise(gabor_place_at(1.186 * p), fractal, seed).noise;
}

fn gabor_fbm(p: vec2f, octaves: f32, gain: f32, seed: u32) -> f32 {
    return gabor_fractal_noise(gabor_place_at(p), gabor_fractal(octaves, gain), seed).noise;
}

fn gabor_billow(p: vec2f, octaves: f32, gain: f32, seed: u32) -> f32 {
    var fractal = gabor_fractal(octaves, gain);
    fractal.shape = GABOR_BILLOW;
    return gabor_fractal_noise(gabor_place_at(p), fractal, seed).noise;
}

fn gabor_ridged(p: vec2f, octaves: f32, gain: f32, seed: u32) -> f32 {
    return -gabor_billow(p, octaves, gain, seed);
}

fn gabor_impl_moved(place_in: GaborPlace, filtered: bool, dx: vec2f, dy: vec2f, strength: f32, fractal: GaborFractal,
                    seed: u32) -> GaborWarp {
    var place = place_in;
    let x = gabor_impl_fractal(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 0));
    let y = gabor_impl_fractal(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 1));
    place.local += strength * vec2f(x.noise, y.noise) * place.cells_per_radius;
    return GaborWarp(place, strength * vec2f(x.gradient.x, y.gradient.x) + vec2f(1.0, 0.0),
                     strength * vec2f(x.gradient.y, y.gradient.y) + vec2f(0.0, 1.0),
                     0.5 * strength * strength * (x.lost + y.lost));
}

fn gabor_warp(place: GaborPlace, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp {
    return gabor_impl_moved(place, false, vec2f(0.0), vec2f(0.0), strength, fractal, seed);
}

fn gabor_warp_filtered(place: GaborPlace, dx: vec2f, dy: vec2f, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp {
    return gabor_impl_moved(place, true, dx, dy, strength, fractal, seed);
}

// ---- In a volume ---------------------------------------------------------------------------------------------------

// A place on the lattice of an octave: see GaborImplOctave.
struct GaborImplOctave3d {
    cell: vec3i,
    local: vec3f,
    period: vec3i,
    along_x: vec3f,
    along_y: vec3f,
    along_z: vec3f,
}

// A step to the next octave: lacunarity times a rotation about (1, 1, 1), v.x times the vector, v.y times its yzx and
// v.z times its zxy.
fn gabor_impl_octave_step_3d(fractal: GaborFractal) -> vec3f {
    let turn = gabor_impl_wave(0.15915494 * clamp(fractal.turn, -1.0e6, 1.0e6)); // 1/(2 pi)
    let rest = (1.0 - turn.x) / 3.0; let side = 0.57735027 * turn.y; // 1/sqrt(3)
    return floor(4096.0 * clamp(fractal.lacunarity, 1.0, 4.0) * vec3f(turn.x + rest, rest - side, rest + side) + 0.5)
         / 4096.0;
}

fn gabor_impl_step_3d(by: vec3f, v: vec3f) -> vec3f {
    return by.x * v + by.y * v.yzx + by.z * v.zxy;
}

fn gabor_impl_next_octave_3d(octave: ptr<function, GaborImplOctave3d>, place: GaborPlace3d, by: vec3f, lacunarity: f32,
                             i: i32) {
    let moved = vec3f(0.382, 0.731, 0.545);
    if (place.period.x == 0 && place.period.y == 0 && place.period.z == 0) {
        (*octave).local = gabor_impl_step_3d(by, (*octave).local) + moved;
        if (place.cell.x != 0 || place.cell.y != 0 || place.cell.z != 0) {
            let m = vec3i(by * 4096.0); let low = (*octave).cell & vec3i(4095);
            let high = vec3u((*octave).cell >> vec3u(vec3i(12))); let n = vec3u(m);
            let part = m.x * low + m.y * low.yzx + m.z * low.zxy;
            (*octave).cell = vec3i(n.x * high + n.y * high.yzx + n.z * high.zxy) + (part >> vec3u(vec3i(12)));
            (*octave).local += vec3f(part & vec3i(4095)) / 4096.0;
        }
        (*octave).along_x = gabor_impl_step_3d(by, (*octave).along_x);
        (*octave).along_y = gabor_impl_step_3d(by, (*octave).along_y);
        (*octave).along_z = gabor_impl_step_3d(by, (*octave).along_z);
    } else {
        let scale = pow(clamp(lacunarity, 1.0, 4.0), f32(i));
        let first = vec3f(place.period);
        let within = vec3f(f32(gabor_impl_wrap(place.cell.x, place.period.x)),
                           f32(gabor_impl_wrap(place.cell.y, place.period.y)),
                           f32(gabor_impl_wrap(place.cell.z, place.period.z))) + place.local;
        let nodes = vec3f(gabor_impl_octave_nodes(first.x, scale), gabor_impl_octave_nodes(first.y, scale),
                          gabor_impl_octave_nodes(first.z, scale));
        let growth = nodes / max(first, vec3f(1.0));
        (*octave).cell = vec3i(0);
        (*octave).local = growth * (within - first * floor(within / max(first, vec3f(1.0)))) + f32(i) * moved;
        (*octave).period = vec3i(select(i32(nodes.x), 0, place.period.x == 0), select(i32(nodes.y), 0, place.period.y == 0),
                                 select(i32(nodes.z), 0, place.period.z == 0));
        (*octave).along_x = vec3f(growth.x * place.cells_per_radius.x, 0.0, 0.0);
        (*octave).along_y = vec3f(0.0, growth.y * place.cells_per_radius.y, 0.0);
        (*octave).along_z = vec3f(0.0, 0.0, growth.z * place.cells_per_radius.z);
    }
}

fn gabor_impl_add_octave_3d(sum: ptr<function, GaborFractalNoise3d>, octave: GaborImplOctave3d, shape: i32,
                            amplitude_in: f32, noise: vec4f, kept_in: f32, lost: vec3f) {
    var amplitude = amplitude_in;
    var kept = kept_in;
    var gradient = vec3f(dot(noise.yzw, octave.along_x), dot(noise.yzw, octave.along_y),
                         dot(noise.yzw, octave.along_z));
    var covariance = vec3f(dot(lost, octave.along_x * octave.along_x), dot(lost, octave.along_y * octave.along_y),
                           dot(lost, octave.along_z * octave.along_z));
    var mixed = vec3f(dot(lost, octave.along_x * octave.along_y), dot(lost, octave.along_x * octave.along_z),
                      dot(lost, octave.along_y * octave.along_z));
    var value = noise.x;
    if (shape != GABOR_FBM) {
        let mean = gabor_impl_mean_magnitude(value, kept);
        value = mean.x - 0.79788456; // sqrt(2/pi)
        covariance += (1.0 - mean.y * mean.y) * gradient * gradient;
        mixed += (1.0 - mean.y * mean.y) * vec3f(gradient.x * gradient.yz, gradient.y * gradient.z);
        gradient *= mean.y;
        kept = gabor_impl_kept_magnitude(kept);
        amplitude *= select(1.6588967, -1.6588967, shape == GABOR_RIDGED); // 1/sqrt(1 - 2/pi)
    }
    (*sum).noise += amplitude * value;
    (*sum).gradient += amplitude * gradient;
    (*sum).removed += amplitude * amplitude * kept;
    (*sum).lost += amplitude * amplitude * covariance;
    (*sum).lost_mixed += amplitude * amplitude * mixed;
}

// The words of the lattice's rows in slice k, given those of rows in any slice, and as many words independent of them.
fn gabor_impl_slice_words(rows: vec4u, slice: u32) -> vec4u {
    return vec4u(gabor_impl_slice_word(rows.x, slice), gabor_impl_slice_word(rows.y, slice),
                 gabor_impl_slice_word(rows.z, slice), gabor_impl_slice_word(rows.w, slice));
}

fn gabor_impl_other_words(words: vec4u) -> vec4u {
    return (((words ^ (words >> vec4u(15u))) * 0xd35a2d97u) >> vec4u(8u)) | vec4u(0x800001u);
}

// Adds a slice of smooth noise to (value, d/dx, d/dy, d/dz).
fn gabor_impl_add_smooth_slice(sum: ptr<function, vec4f>, x: GaborImplLine, y_in: GaborImplLine, slice: u32,
                               even: vec2f, four: bool, evolution: f32) {
    var y = y_in;
    y.word = gabor_impl_slice_words(y.word, slice);
    let noise = gabor_impl_smooth_sum(x, y, four, evolution);
    *sum += vec4f(even.x * noise, even.y * noise.x);
}

fn gabor_impl_smooth_sum_3d(x: GaborImplLine, y: GaborImplLine, z: GaborImplLine, four: bool, evolution: f32) -> vec4f {
    var sum = vec4f(0.0);
    gabor_impl_add_smooth_slice(&sum, x, y, z.word.x, vec2f(z.even.x, z.even_slope.x), four, evolution);
    gabor_impl_add_smooth_slice(&sum, x, y, z.word.y, vec2f(z.even.y, z.even_slope.y), four, evolution);
    gabor_impl_add_smooth_slice(&sum, x, y, z.word.z, vec2f(z.even.z, z.even_slope.z), four, evolution);
    if (four) { gabor_impl_add_smooth_slice(&sum, x, y, z.word.w, vec2f(z.even.w, z.even_slope.w), four, evolution); }
    return sum;
}

// Adds a slice of Perlin noise: v(x) u(y) and u(x) v(y) times u(z), and u(x) u(y) times v(z).
fn gabor_impl_add_perlin_slice(sum: ptr<function, vec4f>, x: GaborImplLine, y_in: GaborImplLine, slice: u32,
                               even: vec2f, odd: vec2f, evolution: f32) {
    var y = y_in;
    y.word = gabor_impl_slice_words(y.word, slice);
    let noise = gabor_impl_perlin_sum(x, y, evolution);
    y.word = gabor_impl_other_words(y.word);
    let third = gabor_impl_smooth_sum(x, y, true, evolution);
    *sum += vec4f(even.x * noise + odd.x * third, even.y * noise.x + odd.y * third.x);
}

// Three terms, with variance 3.
fn gabor_impl_perlin_sum_3d(x: GaborImplLine, y: GaborImplLine, z: GaborImplLine, evolution: f32) -> vec4f {
    var sum = vec4f(0.0);
    gabor_impl_add_perlin_slice(&sum, x, y, z.word.x, vec2f(z.even.x, z.even_slope.x), vec2f(z.odd.x, z.odd_slope.x),
                                evolution);
    gabor_impl_add_perlin_slice(&sum, x, y, z.word.y, vec2f(z.even.y, z.even_slope.y), vec2f(z.odd.y, z.odd_slope.y),
                                evolution);
    gabor_impl_add_perlin_slice(&sum, x, y, z.word.z, vec2f(z.even.z, z.even_slope.z), vec2f(z.odd.z, z.odd_slope.z),
                                evolution);
    gabor_impl_add_perlin_slice(&sum, x, y, z.word.w, vec2f(z.even.w, z.even_slope.w), vec2f(z.odd.w, z.odd_slope.w),
                                evolution);
    return sum;
}

fn gabor_impl_octave_noise_3d(octave: GaborImplOctave3d, salt: u32, variance: vec3f, basis: i32, filtered: bool,
                              evolution: f32) -> vec4f {
    let x = gabor_impl_nodes(octave.cell.x, octave.local.x, octave.period.x, salt, variance.x, basis,
                            filtered);
    let y = gabor_impl_nodes(octave.cell.y, octave.local.y, octave.period.y, salt ^ GABOR_IMPL_ROWS,
                            variance.y, basis, filtered);
    let z = gabor_impl_nodes(octave.cell.z, octave.local.z, octave.period.z, salt ^ GABOR_IMPL_SLICES,
                            variance.z, basis, filtered);
    var noise: vec4f;
    if (basis == GABOR_PERLIN) { noise = 0.57735027 * gabor_impl_perlin_sum_3d(x, y, z, evolution); } // 1/sqrt(3)
    else { noise = gabor_impl_smooth_sum_3d(x, y, z, filtered, evolution); }
    if (basis != GABOR_PERLIN && !filtered) {
        noise *= vec4f(1.0, vec3f(1.0 / GABOR_CELLS_PER_RADIUS)) * (inverseSqrt(GABOR_IMPL_ENERGY) / GABOR_IMPL_ENERGY);
    }
    return noise;
}

fn gabor_impl_fractal_3d(place: GaborPlace3d, filtered: bool, dx_in: vec3f, dy_in: vec3f, fractal: GaborFractal,
                         seed: u32) -> GaborFractalNoise3d {
    var dx = dx_in;
    var dy = dy_in;
    var sum = GaborFractalNoise3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), vec3f(0.0));
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: nothing is left
        dx = vec3f(1.0e3, 0.0, 0.0);
        dy = vec3f(0.0, 1.0e3, 1.0e3);
    }
    var octave = GaborImplOctave3d(place.cell, place.local, place.period,
                                   vec3f(place.cells_per_radius.x, 0.0, 0.0),
                                   vec3f(0.0, place.cells_per_radius.y, 0.0),
                                   vec3f(0.0, 0.0, place.cells_per_radius.z));
    let by = gabor_impl_octave_step_3d(fractal);
    let octaves = clamp(fractal.octaves, 1.0, 16.0); var amplitude = 1.0; var power = 0.0;
    let perlin = fractal.basis == GABOR_PERLIN;
    let count = i32(ceil(octaves));
    for (var i = 0; i < count; i++) {
        let weight = amplitude * min(octaves - f32(i), 1.0);
        power += weight * weight;
        amplitude *= fractal.gain;
        let salt = gabor_impl_octave_salt(seed, i);
        var variance = vec3f(0.0); var lost = vec3f(0.0);
        var oblique = 1.0; var kept = 1.0;
        if (filtered) {
            var a = 0.5 * (dx.x * octave.along_x + dx.y * octave.along_y + dx.z * octave.along_z);
            var b = 0.5 * (dy.x * octave.along_x + dy.y * octave.along_y + dy.z * octave.along_z);
            a = clamp(a, vec3f(-1.0e3), vec3f(1.0e3));
            b = clamp(b, vec3f(-1.0e3), vec3f(1.0e3));
            variance = a * a + b * b;
            oblique = gabor_impl_oblique(a.x * a.y + b.x * b.y, variance.x, variance.y)
                    * gabor_impl_oblique(a.x * a.z + b.x * b.z, variance.x, variance.z)
                    * gabor_impl_oblique(a.y * a.z + b.y * b.z, variance.y, variance.z);
            let even = vec3f(gabor_impl_kept_even(variance.x), gabor_impl_kept_even(variance.y),
                             gabor_impl_kept_even(variance.z));
            kept = even.x * even.y * even.z;
            let x = gabor_impl_slope_powers(variance.x, perlin); let y = gabor_impl_slope_powers(variance.y, perlin);
            let z = gabor_impl_slope_powers(variance.z, perlin);
            var slopes = kept * vec3f(x.x, y.x, z.x);
            if (perlin) {
                var odd = vec3f(gabor_impl_kept_odd(variance.x), gabor_impl_kept_odd(variance.y),
                                gabor_impl_kept_odd(variance.z));
                odd = 0.33333333 * kept * odd / even; // 1/3
                slopes = vec3f(odd.x * x.y + (odd.y + odd.z) * x.x, odd.y * y.y + (odd.x + odd.z) * y.x,
                               odd.z * z.y + (odd.x + odd.y) * z.x);
                kept = odd.x + odd.y + odd.z;
                oblique *= oblique * oblique;
            }
            oblique = min(oblique, inverseSqrt(kept)) * gabor_impl_visible(kept * oblique * oblique);
            kept *= oblique * oblique;
            lost = max(select(1.4621636, 2.2559096, perlin) - oblique * oblique * slopes, vec3f(0.0)); // 8/35 pi^2, 4/27 pi^2
        }
        var noise = vec4f(0.0);
        if (kept > 0.0) {
            noise = gabor_impl_octave_noise_3d(octave, salt, variance, fractal.basis, filtered, place.evolution);
            if (filtered) { noise *= oblique; }
        }
        gabor_impl_add_octave_3d(&sum, octave, fractal.shape, weight, noise, kept, lost);
        gabor_impl_next_octave_3d(&octave, place, by, fractal.lacunarity, i + 1);
    }
    let scale = inverseSqrt(max(power, 1.0e-30));
    sum.noise *= scale;
    sum.gradient *= scale;
    sum.lost *= scale * scale;
    sum.lost_mixed *= scale * scale;
    sum.removed = select(0.0, clamp(1.0 - scale * scale * sum.removed, 0.0, 1.0), filtered);
    return sum;
}

fn gabor_fractal_noise_3d(place: GaborPlace3d, fractal: GaborFractal, seed: u32) -> GaborFractalNoise3d {
    return gabor_impl_fractal_3d(place, false, vec3f(0.0), vec3f(0.0), fractal, seed);
}

fn gabor_fractal_noise_3d_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, fractal: GaborFractal, seed: u32) -> GaborFractalNoise3d {
    return gabor_impl_fractal_3d(place, true, dx, dy, fractal, seed);
}

fn gabor_perlin_3d(p: vec3f, seed: u32) -> f32 {
    var fractal = gabor_fractal(1.0, 0.0);
    fractal.basis = GABOR_PERLIN;
    return gabor_fractal_noise_3d(gabor_place_3d_at(1.186 * p), fractal, seed).noise; // as in gabor_perlin
}

fn gabor_fbm_3d(p: vec3f, octaves: f32, gain: f32, seed: u32) -> f32 {
    return gabor_fractal_noise_3d(gabor_place_3d_at(p), gabor_fractal(octaves, gain), seed).noise;
}

fn gabor_impl_moved_3d(place_in: GaborPlace3d, filtered: bool, dx: vec3f, dy: vec3f, strength: f32,
                       fractal: GaborFractal, seed: u32) -> GaborWarp3d {
    var place = place_in;
    let x = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 0));
    let y = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 1));
    let z = gabor_impl_fractal_3d(place, filtered, dx, dy, fractal, gabor_derived_seed(seed, 2));
    place.local += strength * vec3f(x.noise, y.noise, z.noise) * place.cells_per_radius;
    let power = strength * strength / 3.0;
    return GaborWarp3d(place, strength * vec3f(x.gradient.x, y.gradient.x, z.gradient.x) + vec3f(1.0, 0.0, 0.0),
                       strength * vec3f(x.gradient.y, y.gradient.y, z.gradient.y) + vec3f(0.0, 1.0, 0.0),
                       strength * vec3f(x.gradient.z, y.gradient.z, z.gradient.z) + vec3f(0.0, 0.0, 1.0),
                       power * (x.lost + y.lost + z.lost), power * (x.lost_mixed + y.lost_mixed + z.lost_mixed));
}

fn gabor_warp_3d(place: GaborPlace3d, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp3d {
    return gabor_impl_moved_3d(place, false, vec3f(0.0), vec3f(0.0), strength, fractal, seed);
}

fn gabor_warp_3d_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, strength: f32, fractal: GaborFractal, seed: u32) -> GaborWarp3d {
    return gabor_impl_moved_3d(place, true, dx, dy, strength, fractal, seed);
}
