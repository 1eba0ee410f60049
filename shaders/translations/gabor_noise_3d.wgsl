// Generated from gabor_noise_3d.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl.
//
// gabor_noise_3d.wgsl: Gabor noise in 3D, and on surfaces without texture coordinates, with mean 0, variance 1 and a
// normal distribution at every point.
//
//     let n = gabor_noise_3d_isotropic(p, 2.0, 7u);   // 2 cycles per kernel radius, seed 7
//
//     I want                                   call
//     noise in a volume                        gabor_noise_3d
//     the same without a direction             gabor_noise_3d_isotropic
//     noise along a direction on any mesh      gabor_noise_surface
//     the same without a direction             gabor_field_surface_isotropic
//     derivatives, periods, an evolution       a place, then gabor_field_3d and so on
//     noise averaged over a pixel              gabor_filter_3d.wgsl
//
// Arguments of all functions, besides those of gabor_noise.wgsl:
//     direction  a vector along the wave vector, of any length from 10^-15 to 10^15; (0, 0, 0) gives noise of
//                frequency 0
//     normal     normal of the surface, of any length from 10^-15 to 10^15
// All may vary with p; where they are continuous, so is the noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

const_assert GABOR_TAPS == 3; // gabor_noise_3d.wgsl needs GABOR_TAPS 3

// A noise, its quadrature, and their gradients per kernel radius: see GaborField. For a bump map, subtract the
// gradient's component along the normal.
struct GaborField3d {
    noise: f32,
    gradient: vec3f,
    quadrature: f32,
    quadrature_gradient: vec3f,
    removed: f32,
}

// fn gabor_noise_3d(p: vec3f, frequency: f32, direction: vec3f, seed: u32) -> f32
// fn gabor_field_3d(place: GaborPlace3d, wave: vec3f, seed: u32) -> GaborField3d
//     Noise with one wave vector, and continuous first derivatives.

// fn gabor_noise_3d_isotropic(p: vec3f, frequency: f32, seed: u32) -> f32
// fn gabor_field_3d_isotropic(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d
//     Noise of waves in all directions, at the same cost for every frequency: about seven times that of gabor_noise_3d.
//     Value and gradient are normal, with the same variance at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Second derivatives, and values at several points
//     together, follow mixtures of normal distributions. At each point the quadrature is independent of the noise, but
//     not of the noise's gradient.

// fn gabor_noise_surface(p: vec3f, normal: vec3f, frequency: f32, direction: vec3f, seed: u32) -> f32
// fn gabor_field_surface(place: GaborPlace3d, normal: vec3f, frequency: f32, direction: vec3f, seed: u32) -> GaborField3d
//     Noise at a point of a surface, with waves along the projection of a direction onto the tangent plane. As the
//     angle between direction and normal falls from 30 to 14 degrees, a second noise, whose direction is perpendicular
//     to the given one, takes over; in between, both are computed. On a curved surface, waves bend within each kernel.

// fn gabor_field_surface_isotropic(place: GaborPlace3d, normal: vec3f, frequency: f32, seed: u32) -> GaborField3d
//     Noise of waves along all tangents, at the same cost for every frequency: about five times that of gabor_noise_3d,
//     and about ten times where the normal is 30 to 45 degrees from the z axis. Value and derivatives along the surface
//     have the distributions of gabor_noise_3d_isotropic.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// Scales a vector to length 1 if its length is 10^-15 to 10^15; shorter vectors approach 0.
fn gabor_impl_unit(v_in: vec3f) -> vec3f {
    var v = v_in;
    v = clamp(v, vec3f(-1.0e15), vec3f(1.0e15));
    return v * inverseSqrt(max(dot(v, v), 1.0e-30));
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
fn gabor_impl_add_field_3d(sum: ptr<function, GaborField3d>, field: GaborField3d, amplitude: f32, stretch: vec3f) {
    (*sum).noise += amplitude * field.noise;
    (*sum).gradient += amplitude * stretch * field.gradient;
    (*sum).quadrature += amplitude * field.quadrature;
    (*sum).quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
    (*sum).removed += amplitude * amplitude * field.removed;
}

// ---- One wave vector -----------------------------------------------------------------------------------------------
//
// As in the plane, the nodes c of a lattice with R = 3/2 nodes per kernel radius emit waves under Hann's windows h,
// with independent normal amplitudes A. The windows of the nearest node and its 26 neighbours reach a point:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// The variance is 1 at every point for any wave vector F. So F may follow a surface, which then shows the requested
// frequency and no trace of the lattice.

// Sums slice k of nodes, as gabor_impl_sum does.
fn gabor_impl_sum_slice(x: GaborImplAxis, y_in: GaborImplAxis, z_in: GaborImplAxis, k: i32, evolution: f32,
                        sum: ptr<function, vec4f>, slope: ptr<function, vec4f>) {
    var y = y_in;
    var z = z_in;
    for (var j = 0; j < 3; j++) {
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    }
    gabor_impl_sum(x, y, evolution, sum, slope);
}

// Adds slice k. `sum` receives the noise and, in zw, the part of its derivative along x that comes from the window;
// `slopes` receives the same part of its derivatives along y and z.
fn gabor_impl_add_slice(sum: ptr<function, vec4f>, slopes: ptr<function, vec4f>, x: GaborImplAxis, y: GaborImplAxis,
                        z_in: GaborImplAxis, k: i32, evolution: f32) {
    var z = z_in;
    var slice: vec4f; var slope: vec4f;
    gabor_impl_sum_slice(x, y, z, k, evolution, &slice, &slope);
    gabor_impl_add_products(sum, slice, z.node[k].xy);
    *slopes += vec4f(gabor_impl_product(slope.xy, z.node[k].xy), gabor_impl_product(slice.xy, z.node[k].zw));
}

// Multiplies the sums by K and by the wave at the point, as gabor_impl_field does: K makes E[n^2] = K^2 E[|A|^2] / 2
// (sum h^2)^3 = 1.
fn gabor_impl_field_3d(sum_in: vec4f, slopes_in: vec4f, turn_in: vec2f, wave: vec3f) -> GaborField3d {
    var sum = sum_in;
    var slopes = slopes_in;
    var turn = turn_in;
    turn *= inverseSqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    sum = vec4f(gabor_impl_product(sum.xy, turn), gabor_impl_product(sum.zw, turn));
    slopes = vec4f(gabor_impl_product(slopes.xy, turn), gabor_impl_product(slopes.zw, turn));
    // 6.2831853 is 2 pi
    return GaborField3d(sum.y, vec3f(sum.w, slopes.y, slopes.w) + 6.2831853 * sum.x * wave,
                        sum.x, vec3f(sum.z, slopes.x, slopes.z) - 6.2831853 * sum.y * wave, 0.0);
}

// With periods, nodes are not 1 / GABOR_CELLS_PER_RADIUS kernel radii apart, so all lengths here are in units of
// GABOR_CELLS_PER_RADIUS node spacings.
fn gabor_field_3d(place: GaborPlace3d, wave_in: vec3f, seed: u32) -> GaborField3d {
    var wave = wave_in;
    let stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    wave = clamp(wave, vec3f(-1.0e6), vec3f(1.0e6)) / stretch;
    let salt = gabor_impl_salt(seed);
    let x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                            GABOR_CELLS_PER_RADIUS);
    let y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                            GABOR_CELLS_PER_RADIUS);
    let z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                            GABOR_CELLS_PER_RADIUS);
    let turn = gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    var sum = vec4f(0.0); var slopes = vec4f(0.0);
    gabor_impl_add_slice(&sum, &slopes, x, y, z, 0, place.evolution);
    gabor_impl_add_slice(&sum, &slopes, x, y, z, 1, place.evolution);
    gabor_impl_add_slice(&sum, &slopes, x, y, z, 2, place.evolution);
    var field = gabor_impl_field_3d(sum, slopes, turn, wave);
    field.gradient *= stretch;
    field.quadrature_gradient *= stretch;
    return field;
}

fn gabor_noise_3d(p: vec3f, frequency: f32, direction: vec3f, seed: u32) -> f32 {
    return gabor_field_3d(gabor_place_3d_at(p), abs(frequency) * gabor_impl_unit(direction), seed).noise;
}

// The two directions that share a surface's noise: the projections of a direction, and of one perpendicular to it, onto
// the tangent plane. `second` is 0 where the first has all the power, and 1 where the other has.
struct GaborImplSurface {
    direction: vec3f,
    other: vec3f,
    second: f32,
}

fn gabor_impl_surface(normal_in: vec3f, direction_in: vec3f) -> GaborImplSurface {
    var normal = normal_in;
    var direction = direction_in;
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    var other = cross(direction, select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(direction.z) < 0.7));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    let second = 1.0 - smoothstep(0.0625, 0.25, dot(direction, direction));
    return GaborImplSurface(gabor_impl_unit(direction), gabor_impl_unit(other), second);
}

fn gabor_field_surface(place: GaborPlace3d, normal: vec3f, frequency: f32, direction: vec3f, seed: u32) -> GaborField3d {
    let surface = gabor_impl_surface(normal, direction);
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    for (var i = select(1, 0, surface.second < 1.0); i < select(1, 2, surface.second > 0.0); i++) {
        let wave = abs(frequency) * select(surface.other, surface.direction, i == 0);
        let power = gabor_impl_takeover(select(surface.second, 1.0 - surface.second, i == 0));
        gabor_impl_add_field_3d(&sum, gabor_field_3d(place, wave, gabor_derived_seed(seed, i)), sqrt(power), vec3f(1.0));
    }
    return sum;
}

fn gabor_noise_surface(p: vec3f, normal: vec3f, frequency: f32, direction: vec3f, seed: u32) -> f32 {
    return gabor_field_surface(gabor_place_3d_at(p), normal, frequency, direction, seed).noise;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three perpendicular unit vectors u_cm, turned at random, each with its own amplitude:
//     n(p) = K Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with the constant variance K^2 E[|A|^2] / 2 sum_c 3 h_c^2. The gradient is
// independent of the value and has the constant covariance K^2 E[|A|^2] / 2 sum_c (3 grad h grad h^T + 4 pi^2 F^2 h^2
// I), because sum_m u_cm u_cm^T is the identity I. Since none of this depends on the directions, both are also normal
// over random directions. On a surface there are two tangent vectors, and the same holds for the value and its
// derivatives along the surface.

// The directions of isotropic noise: all or, if `only`, those in the tangent plane that two perpendicular unit vectors
// span.
struct GaborImplTangents {
    only: bool,
    along: vec3f,
    across: vec3f,
}

fn gabor_impl_all_directions() -> GaborImplTangents {
    return GaborImplTangents(false, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0));
}

// Directions in the tangent plane are measured from the circle of latitude around the z axis or, where the normal is
// near that axis, around the x axis.
fn gabor_impl_tangents(normal: vec3f, axis: i32) -> GaborImplTangents {
    let along = gabor_impl_unit(cross(select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), axis == 0), normal));
    return GaborImplTangents(true, along, cross(normal, along));
}

// The waves of a node: unit wave vectors and, in w, the point's offset from the node along them.
struct GaborImplStar3d {
    first: vec4f,
    second: vec4f,
    third: vec4f,
}

// A node's word gives the directions. A wave along -u is also a wave along u, so turning the first vector within half a
// circle reaches every direction of a surface. In 3D, the first vector also tilts along z, and the other two turn
// around it within a quarter circle.
fn gabor_impl_star_3d(tangents: GaborImplTangents, d: vec3f, word: u32) -> GaborImplStar3d {
    let turn = gabor_impl_half_turn(1.1641532e-10 * f32(i32(word))); // 2^-33
    let first = turn.x * tangents.along + turn.y * tangents.across;
    let second = turn.x * tangents.across - turn.y * tangents.along;
    var u = vec4f(first, dot(first, d)); var v = vec4f(second, dot(second, d)); var w = vec4f(0.0, 0.0, 1.0, d.z);
    if (!tangents.only) {
        let rise = 4.6566129e-10 * f32(i32(word << 12u)); let level = sqrt(max(1.0 - rise * rise, 0.0)); // 2^-31
        let spin = gabor_impl_half_turn(5.8207661e-11 * f32(i32(word << 20u))); // 2^-34
        let across = v; let lifted = level * w - rise * u;
        u = level * u + rise * w;
        v = spin.x * across + spin.y * lifted;
        w = spin.x * lifted - spin.y * across;
    }
    return GaborImplStar3d(u, v, w);
}

// Adds a wave of a node with this window: (derivatives, value). `wave` is the wave vector and, in w, the turns from the
// node to the point.
fn gabor_impl_add_wave_3d(sum: ptr<function, GaborField3d>, window: vec4f, wave: vec4f, evolution: f32, word: u32) {
    let a = gabor_impl_product(gabor_impl_amplitude_at(word, evolution), gabor_impl_wave(wave.w));
    let value = window.w * a;
    (*sum).noise += value.y;
    (*sum).gradient += a.y * window.xyz + 6.2831853 * value.x * wave.xyz; // 2 pi
    (*sum).quadrature += value.x;
    (*sum).quadrature_gradient += a.x * window.xyz - 6.2831853 * value.y * wave.xyz;
}

// A node on an axis, with its window and the window's derivative.
struct GaborImplNode {
    offset: f32, // offset of the point from the node
    value: f32,
    slope: f32,
}

fn gabor_impl_node(axis: GaborImplAxis, i: i32) -> GaborImplNode {
    let node = select(select(axis.node[2], axis.node[1], i == 1), axis.node[0], i == 0);
    return GaborImplNode((axis.offset + 1.0 - f32(i)) / GABOR_CELLS_PER_RADIUS, node.x, node.z);
}

fn gabor_impl_node_word(axis: GaborImplAxis, i: i32) -> u32 {
    return select(select(axis.word[2], axis.word[1], i == 1), axis.word[0], i == 0);
}

// Adds a node's waves. The words of its row times the word of its column give the amplitudes and the directions.
// `scale`: the frequency along each axis.
fn gabor_impl_add_node_waves_3d(sum: ptr<function, GaborField3d>, x: GaborImplNode, y: GaborImplNode, z: GaborImplNode,
                                scale: vec3f, evolution: f32, tangents: GaborImplTangents, column: u32, row: vec4u) {
    let d = scale * vec3f(x.offset, y.offset, z.offset);
    let star = gabor_impl_star_3d(tangents, d, column * row.w);
    let window = vec4f(x.slope * (y.value * z.value), x.value * (y.slope * z.value), x.value * (y.value * z.slope),
                       x.value * (y.value * z.value));
    let unit = vec4f(scale, 1.0);
    gabor_impl_add_wave_3d(sum, window, unit * star.first, evolution, column * row.x);
    gabor_impl_add_wave_3d(sum, window, unit * star.second, evolution, column * row.y);
    if (!tangents.only) { gabor_impl_add_wave_3d(sum, window, unit * star.third, evolution, column * row.z); }
}

// The sum over 27 nodes. Lengths are in units of GABOR_CELLS_PER_RADIUS node spacings.
fn gabor_impl_isotropic(place: GaborPlace3d, frequency: f32, tangents: GaborImplTangents, seed: u32) -> GaborField3d {
    let salt = gabor_impl_salt(seed);
    let x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, GABOR_CELLS_PER_RADIUS);
    let y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                            GABOR_CELLS_PER_RADIUS);
    let z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, 0.0,
                            GABOR_CELLS_PER_RADIUS);
    let stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS; let scale = min(abs(frequency), 1.0e6) / stretch;
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    for (var i = 0; i < 9; i++) {
        let y_j = gabor_impl_node(y, i % 3); let z_k = gabor_impl_node(z, i / 3);
        let row = gabor_impl_row(gabor_impl_node_word(y, i % 3) * gabor_impl_node_word(z, i / 3));
        gabor_impl_add_node_waves_3d(&sum, gabor_impl_node(x, 0), y_j, z_k, scale, place.evolution, tangents, x.word[0],
                                     row);
        gabor_impl_add_node_waves_3d(&sum, gabor_impl_node(x, 1), y_j, z_k, scale, place.evolution, tangents, x.word[1],
                                     row);
        gabor_impl_add_node_waves_3d(&sum, gabor_impl_node(x, 2), y_j, z_k, scale, place.evolution, tangents, x.word[2],
                                     row);
    }
    var field = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    let amplitude = inverseSqrt(select(3.0, 2.0, tangents.only) * GABOR_IMPL_ENERGY)
                    / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    gabor_impl_add_field_3d(&field, sum, amplitude, stretch);
    return field;
}

fn gabor_field_3d_isotropic(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d {
    return gabor_impl_isotropic(place, frequency, gabor_impl_all_directions(), seed);
}

fn gabor_noise_3d_isotropic(p: vec3f, frequency: f32, seed: u32) -> f32 {
    return gabor_field_3d_isotropic(gabor_place_3d_at(p), frequency, seed).noise;
}

fn gabor_field_surface_isotropic(place: GaborPlace3d, normal_in: vec3f, frequency: f32, seed: u32) -> GaborField3d {
    var normal = normal_in;
    normal = gabor_impl_unit(normal);
    let aside = dot(normal.xy, normal.xy); // squared sine of the normal's angle to the z axis
    var sum = GaborField3d(0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0);
    for (var i = select(1, 0, aside > 0.25); i < select(1, 2, aside < 0.5); i++) {
        let power = gabor_impl_takeover(select(1.0 - smoothstep(0.25, 0.5, aside), smoothstep(0.25, 0.5, aside), i == 0));
        gabor_impl_add_field_3d(&sum, gabor_impl_isotropic(place, frequency, gabor_impl_tangents(normal, i),
                                                          gabor_derived_seed(seed, i)), sqrt(power), vec3f(1.0));
    }
    return sum;
}
