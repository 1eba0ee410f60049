// Generated from gabor_filter_3d.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl, gabor_spectrum.wgsl, gabor_filter.wgsl, gabor_noise_3d.wgsl.
//
// gabor_filter_3d.wgsl: the noises of gabor_noise_3d.wgsl, averaged over a pixel.
//
//     let f = gabor_field_3d_isotropic_filtered(gabor_place_3d_at(p), dpdx(p), dpdy(p), 2.0, 7u);
//
// dx and dy are the change of p, in kernel radii, from one pixel to the next along x and y; a field's `removed` is the
// share of the variance that averaging removed: see gabor_filter.wgsl.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// fn gabor_field_3d_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, wave: vec3f, seed: u32) -> GaborField3d
// fn gabor_field_surface_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, normal: vec3f, f32 frequency, -> GaborField3d
//                                           vec3f direction, u32 seed)
//     The filtered noise. The error is that of gabor_field_filtered: 1 % as long as the pixel's longest axis is at most
//     a third of a kernel radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a
//     call costs 1.4 times as much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2
//     (64 nodes), and at most 6.6 times (125 nodes).

// fn gabor_field_3d_isotropic_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, frequency: f32, seed: u32) -> GaborField3d
// fn gabor_field_surface_isotropic_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, vec3f normal, -> GaborField3d
//                                                     f32 frequency, u32 seed)
//     Filtered noise of waves in all directions. They cost less than twice as much as without the filter. The rms error
//     against exactly filtered noise is 2 % of a standard deviation as long as the pixel's longest axis is at most 0.3
//     kernel radii, and 3 % at 0.4. For larger pixels, only the variance is right.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// ---- The coupling of three axes ------------------------------------------------------------------------------------
//
// In addition to gabor_filter.wgsl: with M = S + v, a diagonal matrix D with D_ii^2 = M_ii / (M^-1)_ii, C = D^(-1/2) M
// D^(-1/2), B = (1 - C) (1 + C)^-1 and z = 2 pi D^(1/2) (q - c), the coupling of three axes is again a sum of products:
//     exp(-z.C z / 2) = sqrt(8 / |1 + C|) exp(-z.z / 2) (1 + 2 (B_yz z_y z_z + B_zx z_z z_x + B_xy z_x z_y) + ...).
// The right side is the series of exp(z.B z) with Hermite polynomials instead of powers of z, and without B's diagonal,
// which is at most 0.01. We use the terms up to the square of each factor.

// A symmetric 3 x 3 matrix.
struct GaborImplMatrix {
    diagonal: vec3f,
    mixed: vec3f, // yz, zx, xy
}

fn gabor_impl_symmetric_3d(m: GaborImplMatrix, v: vec3f) -> vec3f {
    return m.diagonal * v + m.mixed.zxy * v.yzx + m.mixed.yzx * v.zxy;
}

// The inverse times the determinant.
fn gabor_impl_adjugate(m: GaborImplMatrix, determinant: ptr<function, f32>) -> GaborImplMatrix {
    let a = GaborImplMatrix(m.diagonal.yzx * m.diagonal.zxy - m.mixed * m.mixed,
                            m.mixed.yzx * m.mixed.zxy - m.diagonal * m.mixed);
    *determinant = m.diagonal.x * a.diagonal.x + m.mixed.y * a.mixed.y + m.mixed.z * a.mixed.z;
    return a;
}

// The multiplier of each factor along z. y_0, y_1 and y_2 are the factors along y, and their components are the factors
// along x. `w` is the coupling of y and z, z and x, x and y.
fn gabor_impl_along_z(y_0: vec3f, y_1: vec3f, y_2: vec3f, w: vec3f) -> vec3f {
    return vec3f(y_0.x + w.z * (y_1.y + 0.5 * w.z * y_2.z),
                 w.y * (y_0.y + w.z * y_1.z) + w.x * (y_1.x + w.z * y_2.y),
                 0.5 * (w.y * w.y * y_0.z + w.x * w.x * y_2.x) + w.x * w.y * (y_1.y + w.z * y_2.z));
}

// The weighted sum of the products of three axes' factors.
fn gabor_impl_contracted_3d(y_0: GaborImplFactors, y_1: GaborImplFactors, y_2: GaborImplFactors, z: GaborImplFactors,
                            w: vec3f) -> vec2f {
    let slice = GaborImplFactors(gabor_impl_along_z(y_0.real, y_1.real, y_2.real, w),
                                 gabor_impl_along_z(y_0.imaginary, y_1.imaginary, y_2.imaginary, w));
    return gabor_impl_contracted(slice, z, vec3f(1.0));
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
fn gabor_impl_filtered_wide_3d(place: GaborPlace3d, wave: vec3f, s: GaborImplMatrix, wanted: bool, salt: u32) -> GaborField3d {
    var determinant: f32;
    // 0.13069097 is 1/3 - 2/pi^2
    let m = GaborImplMatrix(s.diagonal + 0.13069097, s.mixed); // S + v
    var adjugate = gabor_impl_adjugate(m, &determinant);
    let blurred = gabor_impl_symmetric_3d(s, wave);
    let c = gabor_impl_symmetric_3d(adjugate, blurred) / -determinant;
    let d = sqrt(m.diagonal * determinant / adjugate.diagonal);
    let pairs = sqrt(d.yzx * d.zxy);
    adjugate = gabor_impl_adjugate(GaborImplMatrix(1.0 + m.diagonal / d, s.mixed / pairs), &determinant); // of 1 + C
    // 157.91367 is 16 pi^2
    let w = 157.91367 / determinant * pairs * adjugate.mixed; // 8 pi^2 sqrt(D_yy D_zz) B_yz and so on
    let x = gabor_impl_filtered_axis(sqrt(s.diagonal.x), d.x, c.x, place.cell.x, place.local.x,
                                     place.period.x, salt,
                                         gabor_impl_wave(wave.x / GABOR_CELLS_PER_RADIUS));
    let y = gabor_impl_filtered_axis(sqrt(s.diagonal.y), d.y, c.y, place.cell.y, place.local.y,
                                     place.period.y, salt ^ GABOR_IMPL_ROWS,
                                     gabor_impl_wave(wave.y / GABOR_CELLS_PER_RADIUS));
    let z = gabor_impl_filtered_axis(sqrt(s.diagonal.z), d.z, c.z, place.cell.z, place.local.z,
                                     place.period.z, salt ^ GABOR_IMPL_SLICES,
                                     gabor_impl_wave(wave.z / GABOR_CELLS_PER_RADIUS));
    let columns = gabor_impl_columns(x);
    let first = gabor_impl_line_before(y, vec2f(y.back.x, -y.back.y));
    var slice = gabor_impl_line_before(
        z, gabor_impl_wave(dot(wave, vec3f(x.offset, y.offset, z.offset + 1.0)) / GABOR_CELLS_PER_RADIUS));
    let none = GaborImplFactors(vec3f(0.0), vec3f(0.0));
    let rows = select(0, y.count, wanted); let slices = select(0, z.count, wanted); // see gabor_impl_filtered_wide
    var value = vec2f(0.0); var next_x = vec2f(0.0); var next_y = vec2f(0.0); var next_z = vec2f(0.0);
    var k = 0;
    loop {
        slice = gabor_impl_next_line(slice, z, k, gabor_impl_fade(z, k));
        var y_0 = none; var y_1 = none; var y_2 = none;
        var row = first;
        var j = 0;
        loop {
            row = gabor_impl_next_line(row, y, j, gabor_impl_fade(y, j));
            let sum = gabor_impl_filtered_row(columns, gabor_impl_slice_word(row.word, slice.word), place.evolution);
            let window = gabor_impl_faded(row);
            y_0 = gabor_impl_plus_product(y_0, sum, window.real.x, window.imaginary.x);
            y_1 = gabor_impl_plus_product(y_1, sum, window.real.y, window.imaginary.y);
            y_2 = gabor_impl_plus_product(y_2, sum, window.real.z, window.imaginary.z);
            continuing { j++; break if j >= rows; }
        }
        let along_z = gabor_impl_faded(slice);
        value += gabor_impl_contracted_3d(y_0, y_1, y_2, along_z, w);
        next_x += gabor_impl_contracted_3d(gabor_impl_next(y_0), gabor_impl_next(y_1), gabor_impl_next(y_2),
                                           along_z, w);
        next_y += gabor_impl_contracted_3d(y_1, y_2, none, along_z, w);
        next_z += gabor_impl_contracted_3d(y_0, y_1, y_2, gabor_impl_next(along_z), w);
        continuing { k++; break if k >= slices; }
    }
    // The derivatives follow as in the plane. In the sum over the series, n / 4g times the previous factor becomes
    // w / 4g times the next factor of the other axes.
    var real = vec3f(next_x.x, next_y.x, next_z.x); var imaginary = vec3f(next_x.y, next_y.y, next_z.y);
    // 0.012665148 is 1/(8 pi^2)
    let quarter = 0.012665148 / d; // 1 / 4g, g = 2 pi^2 D
    real += (wave + c) * value.x + quarter * gabor_impl_symmetric_3d(GaborImplMatrix(vec3f(0.0), w), real);
    imaginary += (wave + c) * value.y + quarter * gabor_impl_symmetric_3d(GaborImplMatrix(vec3f(0.0), w), imaginary);
    let exponent = 19.739209 * (dot(wave + c, blurred) + dot(d, c * c));
    var scale = sqrt(8.0 / determinant / GABOR_IMPL_ENERGY) * exp(-exponent);
    scale /= GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY;
    // 6.2831853 is 2 pi
    return GaborField3d(scale * value.y, 6.2831853 * scale * real, scale * value.x, -6.2831853 * scale * imaginary,
                        0.0);
}
// ---- One wave vector -----------------------------------------------------------------------------------------------

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_CELLS_PER_RADIUS node spacings.
struct GaborImplPixelAxes {
    major: vec3f,
    minor: vec3f,
}

fn gabor_impl_pixel(dx_in: vec3f, dy_in: vec3f, stretch: vec3f) -> GaborImplPixelAxes {
    var dx = dx_in;
    var dy = dy_in;
    dx = clamp(dx, vec3f(-1.0e6), vec3f(1.0e6)) * stretch;
    dy = clamp(dy, vec3f(-1.0e6), vec3f(1.0e6)) * stretch;
    let twice = vec2f(dot(dx, dx) - dot(dy, dy), 2.0 * dot(dx, dy)); // at twice the angle of `turn`
    let cosine = twice.x / max(length(twice), 1.0e-30);
    var turn = sqrt(max(0.5 + vec2f(0.5, -0.5) * cosine, vec2f(0.0)));
    if (twice.y < 0.0) { turn.y = -turn.y; }
    return GaborImplPixelAxes(turn.x * dx + turn.y * dy, turn.x * dy - turn.y * dx);
}

// Limits the length of each axis to `most`.
fn gabor_impl_resolved(pixel: GaborImplPixelAxes, most: f32) -> GaborImplPixelAxes {
    return GaborImplPixelAxes(most * inverseSqrt(max(dot(pixel.major, pixel.major), most * most)) * pixel.major,
                              most * inverseSqrt(max(dot(pixel.minor, pixel.minor), most * most)) * pixel.minor);
}

fn gabor_impl_covariance(pixel: GaborImplPixelAxes) -> GaborImplMatrix {
    let major = 0.5 * pixel.major; let minor = 0.5 * pixel.minor;
    return GaborImplMatrix(major * major + minor * minor, major.yzx * major.zxy + minor.yzx * minor.zxy);
}

// 1 + 2/3 pi^2 S along each axis of a pixel, where S is the filter's variance: see gabor_impl_transmitted.
fn gabor_impl_spread(pixel: GaborImplPixelAxes) -> vec2f {
    return 1.0 + 1.6449341 * vec2f(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor)); // pi^2 / 6
}

// The share of a lobe's variance that a pixel's filter keeps.
fn gabor_impl_transmitted_3d(wave: vec3f, pixel: GaborImplPixelAxes) -> f32 {
    let d = gabor_impl_spread(pixel);
    let k = vec2f(dot(wave, pixel.major), dot(wave, pixel.minor));
    return exp(-min(9.8696044 * dot(k * k, 1.0 / d), 80.0)) * inverseSqrt(d.x * d.y); // pi^2
}

// Adds slice 0, as gabor_impl_add_slice does. The filter adds mixed derivatives, weighted by its covariances
// yz, zx and xy.
fn gabor_impl_add_filtered_slice(sum: ptr<function, vec4f>, slopes: ptr<function, vec4f>, x: GaborImplAxis,
                                 y: GaborImplAxis, z: GaborImplAxis, mixed: vec3f, evolution: f32) {
    var slice: vec4f; var slope: vec4f;
    gabor_impl_sum_slice(x, y, z, 0, evolution, &slice, &slope);
    gabor_impl_add_products(sum, slice, z.node[0].xy);
    *slopes += vec4f(gabor_impl_product(slope.xy, z.node[0].xy), gabor_impl_product(slice.xy, z.node[0].zw));
    *sum += vec4f(gabor_impl_product(mixed.x * slope.xy + mixed.y * slice.zw, z.node[0].zw)
                  + mixed.z * gabor_impl_product(slope.zw, z.node[0].xy), 0.0, 0.0);
}

// The filtered noise of 27 nodes, with three waves along each axis. If not `wanted`, computes none of them. FXC
// compiles a loop whose length it does not know much faster than three calls.
fn gabor_impl_filtered_narrow_3d(place: GaborPlace3d, wave: vec3f, pixel: GaborImplMatrix, wanted: bool, salt: u32) -> GaborField3d {
    var x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                            GABOR_CELLS_PER_RADIUS);
    var y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                            GABOR_CELLS_PER_RADIUS);
    var z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                            GABOR_CELLS_PER_RADIUS);
    let turn = gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    let blurred = gabor_impl_symmetric_3d(pixel, wave);
    var unused = x;
    gabor_impl_filter(&x, pixel.diagonal.x, blurred.x, &unused);
    gabor_impl_filter(&y, pixel.diagonal.y, blurred.y, &unused);
    gabor_impl_filter(&z, pixel.diagonal.z, blurred.z, &unused);
    var sum = vec4f(0.0); var slopes = vec4f(0.0);
    let slices = select(0, 3, wanted);
    for (var k = 0; k < slices; k++) {
        gabor_impl_add_filtered_slice(&sum, &slopes, x, y, z, pixel.mixed, place.evolution);
        z.node[0] = z.node[1];
        z.node[1] = z.node[2];
        z.word[0] = z.word[1];
        z.word[1] = z.word[2];
    }
    return gabor_impl_field_3d(sum, slopes, exp(-19.739209 * max(dot(wave, blurred), 0.0)) * turn, wave); // 2 pi^2
}

fn gabor_field_3d_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, wave_in: vec3f, seed: u32) -> GaborField3d {
    var wave = wave_in;
    let stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    wave = clamp(wave, vec3f(-1.0e6), vec3f(1.0e6)) / stretch;
    let salt = gabor_impl_salt(seed);
    let whole = gabor_impl_pixel(dx, dy, stretch); let resolved = gabor_impl_resolved(whole, 1.0);
    var transmitted = gabor_impl_transmitted_3d(wave, whole);
    let amplitude = sqrt(transmitted / gabor_impl_transmitted_3d(wave, resolved));
    if (!(transmitted > 1.0e-10)) { transmitted = 0.0; } // also if it is NaN
    let pixel = gabor_impl_covariance(resolved);
    let variance = pixel.diagonal;
    let wide = clamp(100.0 * sqrt(max(max(variance.x, variance.y), variance.z)) - 9.0, 0.0, 1.0);
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 1.0 - transmitted);
    let kept = transmitted > 0.0; // a return would take FXC longer
    if (kept && wide < 1.0) {
        gabor_impl_add_field_3d(&sum, gabor_impl_filtered_narrow_3d(place, wave, pixel, wide < 1.0, salt),
                                (1.0 - wide) * amplitude, stretch);
    }
    if (kept && wide > 0.0) {
        gabor_impl_add_field_3d(&sum, gabor_impl_filtered_wide_3d(place, wave, pixel, wide > 0.0, salt),
                                wide * amplitude, stretch);
    }
    return sum;
}

fn gabor_field_surface_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, normal: vec3f, frequency: f32,
                                direction: vec3f, seed: u32) -> GaborField3d {
    let surface = gabor_impl_surface(normal, direction);
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    for (var i = select(1, 0, surface.second < 1.0); i < select(1, 2, surface.second > 0.0); i++) {
        let wave = abs(frequency) * select(surface.other, surface.direction, i == 0);
        let power = gabor_impl_takeover(select(surface.second, 1.0 - surface.second, i == 0));
        gabor_impl_add_field_3d(&sum, gabor_field_3d_filtered(place, dx, dy, wave, gabor_derived_seed(seed, i)),
                                sqrt(power), vec3f(1.0));
    }
    return sum;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------

// A node's filtered window along an axis: its value is middle + cosine, its derivative sine. The window fades out
// within half a standard deviation of its ends.
struct GaborImplFilteredNode {
    offset: f32, // offset of the point from the node
    middle: f32,
    cosine: f32,
    sine: f32,
}

fn gabor_impl_filtered_node_3d(node: GaborImplNode, variance: f32) -> GaborImplFilteredNode {
    let width = clamp(0.5 * sqrt(variance), 0.001, 0.05);
    let t = clamp((1.0 - abs(node.offset)) / width, 0.0, 1.0); let fade = t * t * (3.0 - 2.0 * t);
    let fall = fade * exp(-4.934802 * variance); // pi^2 / 2
    return GaborImplFilteredNode(node.offset, 0.5 * fade, fall * (node.value - 0.5), fall * node.slope);
}

// Adds a wave of a node: see gabor_impl_add_wave_3d. The filter multiplies the wave by exp(-2 pi^2 F.S F). With
// s = 2 pi^2 S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
fn gabor_impl_add_filtered_wave_3d(sum: ptr<function, GaborField3d>, x: GaborImplFilteredNode,
                                   y: GaborImplFilteredNode, z: GaborImplFilteredNode, wave: vec4f, evolution: f32,
                                   pixel: GaborImplMatrix, word: u32) {
    var a = gabor_impl_product(gabor_impl_amplitude_at(word, evolution), gabor_impl_wave(wave.w));
    let middle = vec3f(x.middle, y.middle, z.middle); let cosine = vec3f(x.cosine, y.cosine, z.cosine);
    let sine = vec3f(x.sine, y.sine, z.sine); var s = 19.739209 * gabor_impl_symmetric_3d(pixel, wave.xyz);
    a *= exp(-max(dot(wave.xyz, s), 0.0));
    s = clamp(s, vec3f(-3.0), vec3f(3.0)); // changes no wave that the filter keeps
    let r = s * s; let even = 1.0 + r * (0.5 + 0.041666667 * r); // 1/24
    let odd = s * (1.0 + r * (0.16666667 + 0.0083333333 * r)); var h = middle + cosine; // 1/6, 1/120
    let mixed = dot(pixel.mixed, sine.yzx * sine.zxy * h);
    h = middle + even * cosine;
    let i_h = 0.31830989 * odd * sine; let i_slope = -3.1415927 * odd * cosine; // 1/pi, pi
    let real = h.yzx * h.zxy - i_h.yzx * i_h.zxy; let imaginary = h.yzx * i_h.zxy + i_h.yzx * h.zxy;
    let value = gabor_impl_product(vec2f(h.x * real.x - i_h.x * imaginary.x + mixed, h.x * imaginary.x + i_h.x * real.x), a);
    let slope = even * sine * real - i_slope * imaginary; let turned = even * sine * imaginary + i_slope * real;
    (*sum).noise += value.y;
    (*sum).gradient += slope * a.y + turned * a.x + 6.2831853 * value.x * wave.xyz; // 2 pi
    (*sum).quadrature += value.x;
    (*sum).quadrature_gradient += slope * a.x - turned * a.y - 6.2831853 * value.y * wave.xyz;
}

fn gabor_impl_add_filtered_waves_3d(sum: ptr<function, GaborField3d>, x: GaborImplFilteredNode,
                                    y: GaborImplFilteredNode, z: GaborImplFilteredNode, scale: vec3f, evolution: f32,
                                    pixel: GaborImplMatrix, tangents: GaborImplTangents, column: u32, row: vec4u) {
    let d = scale * vec3f(x.offset, y.offset, z.offset);
    let star = gabor_impl_star_3d(tangents, d, column * row.w);
    let unit = vec4f(scale, 1.0);
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.first, evolution, pixel, column * row.x);
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.second, evolution, pixel, column * row.y);
    if (!tangents.only) {
        gabor_impl_add_filtered_wave_3d(sum, x, y, z, unit * star.third, evolution, pixel, column * row.z);
    }
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
fn gabor_impl_transmitted_isotropic(frequency: f32, pixel: GaborImplPixelAxes, tangents: GaborImplTangents) -> f32 {
    let d = gabor_impl_spread(pixel);
    let unit = min(9.8696044 * frequency * frequency, 1.0e6) / d; // pi^2
    var mean: f32;
    if (tangents.only) {
        let a = vec2f(dot(tangents.along, pixel.major), dot(tangents.along, pixel.minor));
        let b = vec2f(dot(tangents.across, pixel.major), dot(tangents.across, pixel.minor));
        let sum = dot(unit, a * a + b * b); let apart = length(vec2f(dot(unit, a * a - b * b), 2.0 * dot(unit, a * b)));
        mean = exp(min(0.5 * (apart - sum), 0.0)) * gabor_impl_mean_angle(apart);
    } else {
        let q = unit * vec2f(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor));
        let larger = max(q.x, q.y); let smaller = min(q.x, q.y);
        // fit: see tools/constants.py
        mean = sqrt((1.0 + larger * (0.31500545 + 0.08868891 * larger))
                    / (1.0 + larger * (0.98167212 + larger * (0.42128292 + 0.11292425 * larger))));
        mean *= gabor_impl_mean_angle(smaller * (1.0 - 1.0 / (3.0 + 0.8 * larger)));
    }
    return mean * inverseSqrt(d.x * d.y);
}

fn gabor_impl_isotropic_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, frequency_in: f32,
                                 tangents: GaborImplTangents, seed: u32) -> GaborField3d {
    var frequency = frequency_in;
    let stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    frequency = min(abs(frequency), 1.0e6);
    let whole = gabor_impl_pixel(dx, dy, vec3f(1.0)); let resolved = gabor_impl_resolved(whole, 0.5);
    var transmitted = gabor_impl_transmitted_isotropic(frequency, whole, tangents);
    var amplitude = sqrt(transmitted / gabor_impl_transmitted_isotropic(frequency, resolved, tangents));
    if (!(transmitted > 1.0e-10)) { transmitted = 0.0; } // also if it is NaN
    var field = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 1.0 - transmitted);
    if (transmitted == 0.0) {
        return field;
    }
    let pixel = gabor_impl_covariance(GaborImplPixelAxes(resolved.major * stretch, resolved.minor * stretch));
    let s = pixel.diagonal; let scale = frequency / stretch;
    let salt = gabor_impl_salt(seed);
    let x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, GABOR_CELLS_PER_RADIUS);
    let y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                            GABOR_CELLS_PER_RADIUS);
    let z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, 0.0,
                            GABOR_CELLS_PER_RADIUS);
    let x_0 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 0), s.x);
    let x_1 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 1), s.x);
    let x_2 = gabor_impl_filtered_node_3d(gabor_impl_node(x, 2), s.x);
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    for (var i = 0; i < 9; i++) {
        let y_j = gabor_impl_filtered_node_3d(gabor_impl_node(y, i % 3), s.y);
        let z_k = gabor_impl_filtered_node_3d(gabor_impl_node(z, i / 3), s.z);
        let row = gabor_impl_row(gabor_impl_node_word(y, i % 3) * gabor_impl_node_word(z, i / 3));
        gabor_impl_add_filtered_waves_3d(&sum, x_0, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[0], row);
        gabor_impl_add_filtered_waves_3d(&sum, x_1, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[1], row);
        gabor_impl_add_filtered_waves_3d(&sum, x_2, y_j, z_k, scale, place.evolution, pixel, tangents, x.word[2], row);
    }
    amplitude *= inverseSqrt(select(3.0, 2.0, tangents.only) * GABOR_IMPL_ENERGY)
               / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    gabor_impl_add_field_3d(&field, sum, amplitude, stretch);
    return field;
}

fn gabor_field_3d_isotropic_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, frequency: f32, seed: u32) -> GaborField3d {
    return gabor_impl_isotropic_filtered(place, dx, dy, frequency, gabor_impl_all_directions(), seed);
}

fn gabor_field_surface_isotropic_filtered(place: GaborPlace3d, dx: vec3f, dy: vec3f, normal_in: vec3f, frequency: f32,
                                          seed: u32) -> GaborField3d {
    var normal = normal_in;
    normal = gabor_impl_unit(normal);
    let aside = dot(normal.xy, normal.xy); // see gabor_field_surface_isotropic
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    for (var i = select(1, 0, aside > 0.25); i < select(1, 2, aside < 0.5); i++) {
        let power = gabor_impl_takeover(select(1.0 - smoothstep(0.25, 0.5, aside), smoothstep(0.25, 0.5, aside), i == 0));
        let field = gabor_impl_isotropic_filtered(place, dx, dy, frequency, gabor_impl_tangents(normal, i),
                                                  gabor_derived_seed(seed, i));
        gabor_impl_add_field_3d(&sum, field, sqrt(power), vec3f(1.0));
    }
    return sum;
}
