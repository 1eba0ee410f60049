// Generated from gabor_noise_3d.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest e2cde48ac594c1bf.
// Paste it after gabor_noise.wgsl.
//
// gabor_noise_3d.wgsl: Gabor noise in 3D, and on surfaces without texture coordinates, with mean 0, variance 1 and a normal
// distribution at every point.
//
// Paste or include this file after gabor_noise.wgsl, with GABOR_TAPS 3, the default.
//
//     f32 n = gabor_noise_3d_isotropic(p, 2.0, 7u);   // 2 cycles per kernel radius, seed 7
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

// A position in node spacings of the lattice, with a period and an evolution: see GaborPlace.
struct GaborPlace3d {
    cell: vec3<i32>,
    local: vec3<f32>,
    cells_per_radius: vec3<f32>,
    period: vec3<i32>,
    evolution: f32,
}

// GaborPlace3d gabor_place_3d_at(vec3f p)
// GaborPlace3d gabor_place_3d(vec3i cell, vec3f local)
// GaborPlace3d gabor_place_3d_tiled(vec3f p, vec3f period)
//     Like gabor_place_at, gabor_place and gabor_place_tiled.

// A noise, its quadrature, and their gradients per kernel radius: see GaborField. For a bump map, subtract the gradient's
// component along the normal.
struct GaborField3d {
    noise: f32,
    gradient: vec3<f32>,
    quadrature: f32,
    quadrature_gradient: vec3<f32>,
    removed: f32,
}

// f32 gabor_noise_3d(vec3f p, f32 frequency, vec3f direction, u32 seed)
// GaborField3d gabor_field_3d(GaborPlace3d place, vec3f wave, u32 seed)
//     Noise with one wave vector, and continuous first derivatives.

// f32 gabor_noise_3d_isotropic(vec3f p, f32 frequency, u32 seed)
// GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, f32 frequency, u32 seed)
//     Noise of waves in all directions, at the same cost for every frequency: about seven times that of gabor_noise_3d.
//     Value and gradient are normal, with the same variance at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Second derivatives, and values at several points
//     together, follow mixtures of normal distributions. At each point the quadrature is independent of the noise, but
//     not of the noise's gradient.

// f32 gabor_noise_surface(vec3f p, vec3f normal, f32 frequency, vec3f direction, u32 seed)
// GaborField3d gabor_field_surface(GaborPlace3d place, vec3f normal, f32 frequency, vec3f direction, u32 seed)
//     Noise at a point of a surface, with waves along the projection of a direction onto the tangent plane. As the
//     angle between direction and normal falls from 30 to 14 degrees, a second noise, whose direction is perpendicular
//     to the given one, takes over; in between, both are computed. On a curved surface, waves bend within each kernel.

// GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, vec3f normal, f32 frequency, u32 seed)
//     Noise of waves along all tangents, at the same cost for every frequency: about five times that of gabor_noise_3d,
//     and about ten times where the normal is 30 to 45 degrees from the z axis. Value and derivatives along the surface
//     have the distributions of gabor_noise_3d_isotropic.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

fn gabor_place_3d(cell: vec3<i32>, local: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3(1.5f), vec3(0i), 0f);
}

fn gabor_place_3d_at(p: vec3<f32>) -> GaborPlace3d {
    let _e8 = gabor_place_3d(vec3(0i), (p * 1.5f));
    return _e8;
}

fn gabor_place_3d_tiled(p: vec3<f32>, period: vec3<f32>) -> GaborPlace3d {
    var xy: GaborPlace;
    var z_1: GaborPlace;
    let _e4 = gabor_place_tiled(p.xy, period.xy);
    xy = _e4;
    let _e8 = gabor_place_tiled(p.zz, period.zz);
    z_1 = _e8;
    let _e12 = xy;
    let _e14 = z_1;
    let _e20 = xy;
    let _e22 = z_1;
    let _e28 = xy;
    let _e30 = z_1;
    return GaborPlace3d(vec3(0i), vec3<f32>(_e12.local.x, _e12.local.y, _e14.local.x), vec3<f32>(_e20.cells_per_radius.x, _e20.cells_per_radius.y, _e22.cells_per_radius.x), vec3<i32>(_e28.period.x, _e28.period.y, _e30.period.x), 0f);
}

// Scales a vector to length 1 if its length is 10^-15 to 10^15; shorter vectors approach 0.
fn gabor_impl_unit(v: vec3<f32>) -> vec3<f32> {
    var v_1: vec3<f32>;
    v_1 = v;
    let _e2 = v_1;
    v_1 = clamp(_e2, vec3(-1000000000000000f), vec3(1000000000000000f));
    let _e9 = v_1;
    let _e10 = v_1;
    let _e11 = v_1;
    return (_e9 * inverseSqrt(max(dot(_e10, _e11), 0.000000000000000000000000000001f)));
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
fn gabor_impl_add_field_3d(sum: ptr<function, GaborField3d>, field: GaborField3d, amplitude: f32, stretch: vec3<f32>) {
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

// ---- One wave vector -----------------------------------------------------------------------------------------------
//
// As in the plane, the nodes c of a lattice with R = 3/2 nodes per kernel radius emit waves under Hann's windows h,
// with independent normal amplitudes A. The windows of the nearest node and its 26 neighbours reach a point:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// The variance is 1 at every point for any wave vector F. So F may follow a surface, which then shows the requested
// frequency and no trace of the lattice.

// The word of a row in a slice of nodes: odd with 24 bits, like the words of lines.
fn gabor_impl_slice_word(row: u32, slice: u32) -> u32 {
    return (((row * slice) >> 8u) | 8388609u);
}

// Sums slice k of nodes, as gabor_impl_sum does.
fn gabor_impl_sum_slice(x: GaborAxis, y: GaborAxis, z: GaborAxis, k: i32, evolution: f32, sum: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>) {
    var y_5: GaborAxis;
    var j_1: i32 = 0i;
    y_5 = y;
    loop {
        let _e10 = j_1;
        if !((_e10 < 3i)) {
            break;
        }
        let _e17 = j_1;
        let _e20 = j_1;
        let _e23 = y_5.word[_e20];
        let _e26 = gabor_impl_slice_word(_e23, z.word[k]);
        y_5.word[_e17] = _e26;
        continuing {
            let _e14 = j_1;
            j_1 = (_e14 + 1i);
        }
    }
    let _e27 = y_5;
    gabor_impl_sum(x, _e27, evolution, sum, slope);
    return;
}

// Adds slice k. `sum` receives the noise and, in zw, the part of its derivative along x that comes from the window;
// `slopes` receives the same part of its derivatives along y and z.
fn gabor_impl_add_slice(sum: ptr<function, vec4<f32>>, slopes: ptr<function, vec4<f32>>, x: GaborAxis, y: GaborAxis, z: GaborAxis, k: i32, evolution: f32) {
    var slice_1: vec4<f32>;
    var slope_7: vec4<f32>;
    gabor_impl_sum_slice(x, y, z, k, evolution, (&slice_1), (&slope_7));
    let _e14 = slice_1;
    gabor_impl_add_products(sum, _e14, z.node[k].xy);
    let _e19 = (*slopes);
    let _e20 = slope_7;
    let _e25 = gabor_impl_product(_e20.xy, z.node[k].xy);
    let _e26 = slice_1;
    let _e31 = gabor_impl_product(_e26.xy, z.node[k].zw);
    (*slopes) = (_e19 + vec4<f32>(_e25.x, _e25.y, _e31.x, _e31.y));
    return;
}

// Multiplies the sums by K and by the wave at the point, as gabor_impl_field does: K makes E[n^2] = K^2 E[|A|^2] / 2
// (sum h^2)^3 = 1.
fn gabor_impl_field_3d(sum: vec4<f32>, slopes: vec4<f32>, turn: vec2<f32>, wave: vec3<f32>) -> GaborField3d {
    var sum_9: vec4<f32>;
    var slopes_2: vec4<f32>;
    var turn_7: vec2<f32>;
    var local_12: f32;
    var local_13: f32;
    sum_9 = sum;
    slopes_2 = slopes;
    turn_7 = turn;
    let _e7 = turn_7;
    if false {
        local_12 = 1f;
    } else {
        local_12 = 1.125f;
    }
    let _e17 = local_12;
    if false {
        local_13 = 1f;
    } else {
        local_13 = 1.125f;
    }
    let _e29 = local_13;
    turn_7 = (_e7 * (inverseSqrt(_e17) / (1459955300000000000000000000f * _e29)));
    let _e33 = sum_9;
    let _e35 = turn_7;
    let _e36 = gabor_impl_product(_e33.xy, _e35);
    let _e37 = sum_9;
    let _e39 = turn_7;
    let _e40 = gabor_impl_product(_e37.zw, _e39);
    sum_9 = vec4<f32>(_e36.x, _e36.y, _e40.x, _e40.y);
    let _e46 = slopes_2;
    let _e48 = turn_7;
    let _e49 = gabor_impl_product(_e46.xy, _e48);
    let _e50 = slopes_2;
    let _e52 = turn_7;
    let _e53 = gabor_impl_product(_e50.zw, _e52);
    slopes_2 = vec4<f32>(_e49.x, _e49.y, _e53.x, _e53.y);
    let _e59 = sum_9;
    let _e61 = sum_9;
    let _e63 = slopes_2;
    let _e65 = slopes_2;
    let _e69 = sum_9;
    let _e74 = sum_9;
    let _e76 = sum_9;
    let _e78 = slopes_2;
    let _e80 = slopes_2;
    let _e84 = sum_9;
    return GaborField3d(_e59.y, (vec3<f32>(_e61.w, _e63.y, _e65.w) + ((6.2831855f * _e69.x) * wave)), _e74.x, (vec3<f32>(_e76.z, _e78.x, _e80.z) - ((6.2831855f * _e84.y) * wave)), 0f);
}

// With periods, nodes are not 1 / GABOR_CELLS_PER_RADIUS kernel radii apart, so all lengths here are in units of
// GABOR_CELLS_PER_RADIUS node spacings.
fn gabor_field_3d(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborField3d {
    var wave_7: vec3<f32>;
    var stretch_3: vec3<f32>;
    var salt_4: u32;
    var x_7: GaborAxis;
    var y_7: GaborAxis;
    var z_4: GaborAxis;
    var turn_8: vec2<f32>;
    var sum_10: vec4<f32> = vec4(0f);
    var slopes_3: vec4<f32> = vec4(0f);
    var field_5: GaborField3d;
    wave_7 = wave;
    stretch_3 = (place.cells_per_radius / vec3(1.5f));
    let _e12 = wave_7;
    let _e19 = stretch_3;
    wave_7 = (clamp(_e12, vec3(-1000000f), vec3(1000000f)) / _e19);
    let _e21 = gabor_impl_salt(seed);
    salt_4 = _e21;
    let _e29 = salt_4;
    let _e30 = wave_7;
    let _e36 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e29, _e30.x, 1.5f);
    x_7 = _e36;
    let _e44 = salt_4;
    let _e47 = wave_7;
    let _e53 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e44 ^ 1540483477u), _e47.y, 1.5f);
    y_7 = _e53;
    let _e61 = salt_4;
    let _e64 = wave_7;
    let _e70 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (_e61 ^ 668265263u), _e64.z, 1.5f);
    z_4 = _e70;
    let _e72 = x_7;
    let _e74 = x_7;
    let _e77 = y_7;
    let _e79 = y_7;
    let _e83 = z_4;
    let _e85 = z_4;
    let _e89 = gabor_impl_wave((((_e72.turns * _e74.offset) + (_e77.turns * _e79.offset)) + (_e83.turns * _e85.offset)));
    turn_8 = _e89;
    let _e99 = x_7;
    let _e100 = y_7;
    let _e101 = z_4;
    gabor_impl_add_slice((&sum_10), (&slopes_3), _e99, _e100, _e101, 0i, place.evolution);
    let _e108 = x_7;
    let _e109 = y_7;
    let _e110 = z_4;
    gabor_impl_add_slice((&sum_10), (&slopes_3), _e108, _e109, _e110, 1i, place.evolution);
    let _e117 = x_7;
    let _e118 = y_7;
    let _e119 = z_4;
    gabor_impl_add_slice((&sum_10), (&slopes_3), _e117, _e118, _e119, 2i, place.evolution);
    let _e124 = sum_10;
    let _e125 = slopes_3;
    let _e126 = turn_8;
    let _e127 = wave_7;
    let _e128 = gabor_impl_field_3d(_e124, _e125, _e126, _e127);
    field_5 = _e128;
    let _e131 = field_5;
    let _e133 = stretch_3;
    field_5.gradient = (_e131.gradient * _e133);
    let _e136 = field_5;
    let _e138 = stretch_3;
    field_5.quadrature_gradient = (_e136.quadrature_gradient * _e138);
    let _e140 = field_5;
    return _e140;
}

fn gabor_noise_3d(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e4 = gabor_place_3d_at(p);
    let _e6 = gabor_impl_unit(direction);
    let _e8 = gabor_field_3d(_e4, (abs(frequency) * _e6), seed);
    return _e8.noise;
}

// The two directions that share a surface's noise: the projections of a direction, and of one perpendicular to it, onto the
// tangent plane. `second` is 0 where the first has all the power, and 1 where the other has.
struct GaborSurface {
    direction: vec3<f32>,
    other: vec3<f32>,
    second: f32,
}

fn gabor_impl_surface(normal: vec3<f32>, direction: vec3<f32>) -> GaborSurface {
    var normal_1: vec3<f32>;
    var direction_2: vec3<f32>;
    var local_14: vec3<f32>;
    var other: vec3<f32>;
    var second_2: f32;
    normal_1 = normal;
    direction_2 = direction;
    let _e4 = normal_1;
    let _e5 = gabor_impl_unit(_e4);
    normal_1 = _e5;
    let _e6 = direction_2;
    let _e7 = gabor_impl_unit(_e6);
    direction_2 = _e7;
    let _e8 = direction_2;
    let _e9 = direction_2;
    if (abs(_e9.z) < 0.7f) {
        local_14 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_14 = vec3<f32>(1f, 0f, 0f);
    }
    let _e23 = local_14;
    other = cross(_e8, _e23);
    let _e26 = direction_2;
    let _e27 = direction_2;
    let _e28 = normal_1;
    let _e30 = normal_1;
    direction_2 = (_e26 - (dot(_e27, _e28) * _e30));
    let _e33 = other;
    let _e34 = other;
    let _e35 = normal_1;
    let _e37 = normal_1;
    other = (_e33 - (dot(_e34, _e35) * _e37));
    let _e43 = direction_2;
    let _e44 = direction_2;
    second_2 = (1f - smoothstep(0.0625f, 0.25f, dot(_e43, _e44)));
    let _e49 = direction_2;
    let _e50 = gabor_impl_unit(_e49);
    let _e51 = other;
    let _e52 = gabor_impl_unit(_e51);
    let _e53 = second_2;
    return GaborSurface(_e50, _e52, _e53);
}

fn gabor_field_surface(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var surface: GaborSurface;
    var sum_11: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_15: i32;
    var i: i32;
    var local_16: i32;
    var local_17: vec3<f32>;
    var wave_8: vec3<f32>;
    var local_18: f32;
    var power_1: f32;
    let _e5 = gabor_impl_surface(normal, direction);
    surface = _e5;
    let _e16 = surface;
    if (_e16.second < 1f) {
        local_15 = 0i;
    } else {
        local_15 = 1i;
    }
    let _e23 = local_15;
    i = _e23;
    loop {
        let _e25 = i;
        let _e26 = surface;
        if (_e26.second > 0f) {
            local_16 = 2i;
        } else {
            local_16 = 1i;
        }
        let _e33 = local_16;
        if !((_e25 < _e33)) {
            break;
        }
        {
            let _e40 = i;
            if (_e40 == 0i) {
                let _e43 = surface;
                local_17 = _e43.direction;
            } else {
                let _e45 = surface;
                local_17 = _e45.other;
            }
            let _e48 = local_17;
            wave_8 = (abs(frequency) * _e48);
            let _e51 = i;
            if (_e51 == 0i) {
                let _e55 = surface;
                local_18 = (1f - _e55.second);
            } else {
                let _e58 = surface;
                local_18 = _e58.second;
            }
            let _e61 = local_18;
            let _e62 = gabor_impl_takeover(_e61);
            power_1 = _e62;
            let _e65 = wave_8;
            let _e66 = i;
            let _e67 = gabor_derived_seed(seed, _e66);
            let _e68 = gabor_field_3d(place, _e65, _e67);
            let _e69 = power_1;
            gabor_impl_add_field_3d((&sum_11), _e68, sqrt(_e69), vec3(1f));
        }
        continuing {
            let _e36 = i;
            i = (_e36 + 1i);
        }
    }
    let _e74 = sum_11;
    return _e74;
}

fn gabor_noise_surface(p: vec3<f32>, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e5 = gabor_place_3d_at(p);
    let _e6 = gabor_field_surface(_e5, normal, frequency, direction, seed);
    return _e6.noise;
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
struct GaborTangents {
    only: bool,
    along: vec3<f32>,
    across: vec3<f32>,
}

fn gabor_impl_all_directions() -> GaborTangents {
    return GaborTangents(false, vec3<f32>(1f, 0f, 0f), vec3<f32>(0f, 1f, 0f));
}

// Directions in the tangent plane are measured from the circle of latitude around the z axis or, where the normal is
// near that axis, around the x axis.
fn gabor_impl_tangents(normal: vec3<f32>, axis: i32) -> GaborTangents {
    var local_19: vec3<f32>;
    var along: vec3<f32>;
    if (axis == 0i) {
        local_19 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_19 = vec3<f32>(1f, 0f, 0f);
    }
    let _e13 = local_19;
    let _e15 = gabor_impl_unit(cross(_e13, normal));
    along = _e15;
    let _e18 = along;
    let _e19 = along;
    return GaborTangents(true, _e18, cross(normal, _e19));
}

// The waves of a node: unit wave vectors and, in w, the point's offset from the node along them.
struct GaborStar3d {
    u: vec4<f32>,
    v: vec4<f32>,
    w: vec4<f32>,
}

// A node's word gives the directions. A wave along -u is also a wave along u, so turning the first vector within half a
// circle reaches every direction of a surface. In 3D, the first vector also tilts along z, and the other two turn around
// it within a quarter circle.
fn gabor_impl_star_3d(tangents: GaborTangents, d: vec3<f32>, word: u32) -> GaborStar3d {
    var turn_9: vec2<f32>;
    var first_1: vec3<f32>;
    var second_3: vec3<f32>;
    var u_1: vec4<f32>;
    var v_2: vec4<f32>;
    var w: vec4<f32>;
    var rise: f32;
    var level: f32;
    var spin: vec2<f32>;
    var across: vec4<f32>;
    var lifted: vec4<f32>;
    let _e7 = gabor_impl_half_turn((0.00000000011641532f * f32(i32(word))));
    turn_9 = _e7;
    let _e9 = turn_9;
    let _e13 = turn_9;
    first_1 = ((_e9.x * tangents.along) + (_e13.y * tangents.across));
    let _e19 = turn_9;
    let _e23 = turn_9;
    second_3 = ((_e19.x * tangents.across) - (_e23.y * tangents.along));
    let _e29 = first_1;
    let _e30 = first_1;
    u_1 = vec4<f32>(_e29.x, _e29.y, _e29.z, dot(_e30, d));
    let _e37 = second_3;
    let _e38 = second_3;
    v_2 = vec4<f32>(_e37.x, _e37.y, _e37.z, dot(_e38, d));
    w = vec4<f32>(0f, 0f, 1f, d.z);
    if !(tangents.only) {
        {
            rise = (0.0000000004656613f * f32(i32((word << 12u))));
            let _e61 = rise;
            let _e62 = rise;
            level = sqrt(max((1f - (_e61 * _e62)), 0f));
            let _e75 = gabor_impl_half_turn((0.00000000005820766f * f32(i32((word << 20u)))));
            spin = _e75;
            let _e77 = v_2;
            across = _e77;
            let _e79 = level;
            let _e80 = w;
            let _e82 = rise;
            let _e83 = u_1;
            lifted = ((_e79 * _e80) - (_e82 * _e83));
            let _e87 = level;
            let _e88 = u_1;
            let _e90 = rise;
            let _e91 = w;
            u_1 = ((_e87 * _e88) + (_e90 * _e91));
            let _e94 = spin;
            let _e96 = across;
            let _e98 = spin;
            let _e100 = lifted;
            v_2 = ((_e94.x * _e96) + (_e98.y * _e100));
            let _e103 = spin;
            let _e105 = lifted;
            let _e107 = spin;
            let _e109 = across;
            w = ((_e103.x * _e105) - (_e107.y * _e109));
        }
    }
    let _e112 = u_1;
    let _e113 = v_2;
    let _e114 = w;
    return GaborStar3d(_e112, _e113, _e114);
}

// Adds a wave of a node with this window: (derivatives, value). `wave` is the wave vector and, in w, the turns from the node
// to the point.
fn gabor_impl_add_wave_3d(sum: ptr<function, GaborField3d>, window: vec4<f32>, wave: vec4<f32>, evolution: f32, word: u32) {
    var a_2: vec2<f32>;
    var value_4: vec2<f32>;
    let _e5 = gabor_impl_amplitude_at(word, evolution);
    let _e7 = gabor_impl_wave(wave.w);
    let _e8 = gabor_impl_product(_e5, _e7);
    a_2 = _e8;
    let _e11 = a_2;
    value_4 = (window.w * _e11);
    let _e15 = (*sum);
    let _e17 = value_4;
    (*sum).noise = (_e15.noise + _e17.y);
    let _e21 = (*sum);
    let _e23 = a_2;
    let _e28 = value_4;
    (*sum).gradient = (_e21.gradient + ((_e23.y * window.xyz) + ((6.2831855f * _e28.x) * wave.xyz)));
    let _e36 = (*sum);
    let _e38 = value_4;
    (*sum).quadrature = (_e36.quadrature + _e38.x);
    let _e42 = (*sum);
    let _e44 = a_2;
    let _e49 = value_4;
    (*sum).quadrature_gradient = (_e42.quadrature_gradient + ((_e44.x * window.xyz) - ((6.2831855f * _e49.y) * wave.xyz)));
    return;
}

// A node on an axis, with its window and the window's derivative.
struct GaborNode {
    offset: f32, // offset of the point from the node
    value: f32,
    slope: f32,
}

fn gabor_impl_node(axis: GaborAxis, i: i32) -> GaborNode {
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var node: vec4<f32>;
    if (i == 0i) {
        local_21 = axis.node[0];
    } else {
        if (i == 1i) {
            local_20 = axis.node[1];
        } else {
            local_20 = axis.node[2];
        }
        let _e16 = local_20;
        local_21 = _e16;
    }
    let _e18 = local_21;
    node = _e18;
    let _e30 = node;
    let _e32 = node;
    return GaborNode((((axis.offset + 1f) - f32(i)) / 1.5f), _e30.x, _e32.z);
}

fn gabor_impl_node_word(axis: GaborAxis, i: i32) -> u32 {
    var local_22: u32;
    var local_23: u32;
    if (i == 0i) {
        local_23 = axis.word[0];
    } else {
        if (i == 1i) {
            local_22 = axis.word[1];
        } else {
            local_22 = axis.word[2];
        }
        let _e16 = local_22;
        local_23 = _e16;
    }
    let _e18 = local_23;
    return _e18;
}

// Adds a node's waves. The words of its row times the word of its column give the amplitudes and the directions. `scale`: the
// frequency along each axis.
fn gabor_impl_add_node_waves_3d(sum: ptr<function, GaborField3d>, x: GaborNode, y: GaborNode, z: GaborNode, scale: vec3<f32>, evolution: f32, tangents: GaborTangents, column: u32, row: vec4<u32>) {
    var d_1: vec3<f32>;
    var star: GaborStar3d;
    var window_1: vec4<f32>;
    var unit: vec4<f32>;
    d_1 = (scale * vec3<f32>(x.offset, y.offset, z.offset));
    let _e15 = d_1;
    let _e18 = gabor_impl_star_3d(tangents, _e15, (column * row.w));
    star = _e18;
    window_1 = vec4<f32>((x.slope * (y.value * z.value)), (x.value * (y.slope * z.value)), (x.value * (y.value * z.slope)), (x.value * (y.value * z.value)));
    unit = vec4<f32>(scale.x, scale.y, scale.z, 1f);
    let _e49 = window_1;
    let _e50 = unit;
    let _e51 = star;
    gabor_impl_add_wave_3d(sum, _e49, (_e50 * _e51.u), evolution, (column * row.x));
    let _e58 = window_1;
    let _e59 = unit;
    let _e60 = star;
    gabor_impl_add_wave_3d(sum, _e58, (_e59 * _e60.v), evolution, (column * row.y));
    if !(tangents.only) {
        let _e69 = window_1;
        let _e70 = unit;
        let _e71 = star;
        gabor_impl_add_wave_3d(sum, _e69, (_e70 * _e71.w), evolution, (column * row.z));
        return;
    } else {
        return;
    }
}

// The sum over 27 nodes. Lengths are in units of GABOR_CELLS_PER_RADIUS node spacings.
fn gabor_impl_isotropic(place: GaborPlace3d, frequency: f32, tangents: GaborTangents, seed: u32) -> GaborField3d {
    var salt_5: u32;
    var x_9: GaborAxis;
    var y_9: GaborAxis;
    var z_6: GaborAxis;
    var stretch_4: vec3<f32>;
    var scale_1: vec3<f32>;
    var sum_14: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var i_3: i32 = 0i;
    var y_j: GaborNode;
    var z_k: GaborNode;
    var row_3: vec4<u32>;
    var field_6: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_24: f32;
    var local_25: f32;
    var local_26: f32;
    var amplitude_3: f32;
    let _e4 = gabor_impl_salt(seed);
    salt_5 = _e4;
    let _e12 = salt_5;
    let _e18 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e12, 0f, 1.5f);
    x_9 = _e18;
    let _e26 = salt_5;
    let _e34 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e26 ^ 1540483477u), 0f, 1.5f);
    y_9 = _e34;
    let _e42 = salt_5;
    let _e50 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (_e42 ^ 668265263u), 0f, 1.5f);
    z_6 = _e50;
    stretch_4 = (place.cells_per_radius / vec3(1.5f));
    let _e63 = stretch_4;
    scale_1 = (vec3(min(abs(frequency), 1000000f)) / _e63);
    loop {
        let _e78 = i_3;
        if !((_e78 < 9i)) {
            break;
        }
        {
            let _e85 = y_9;
            let _e86 = i_3;
            let _e89 = gabor_impl_node(_e85, (_e86 % 3i));
            y_j = _e89;
            let _e91 = z_6;
            let _e92 = i_3;
            let _e95 = gabor_impl_node(_e91, (_e92 / 3i));
            z_k = _e95;
            let _e97 = y_9;
            let _e98 = i_3;
            let _e101 = gabor_impl_node_word(_e97, (_e98 % 3i));
            let _e102 = z_6;
            let _e103 = i_3;
            let _e106 = gabor_impl_node_word(_e102, (_e103 / 3i));
            let _e108 = gabor_impl_row((_e101 * _e106));
            row_3 = _e108;
            let _e111 = x_9;
            let _e113 = gabor_impl_node(_e111, 0i);
            let _e114 = y_j;
            let _e115 = z_k;
            let _e116 = scale_1;
            let _e121 = x_9.word[0];
            let _e122 = row_3;
            gabor_impl_add_node_waves_3d((&sum_14), _e113, _e114, _e115, _e116, place.evolution, tangents, _e121, _e122);
            let _e125 = x_9;
            let _e127 = gabor_impl_node(_e125, 1i);
            let _e128 = y_j;
            let _e129 = z_k;
            let _e130 = scale_1;
            let _e135 = x_9.word[1];
            let _e136 = row_3;
            gabor_impl_add_node_waves_3d((&sum_14), _e127, _e128, _e129, _e130, place.evolution, tangents, _e135, _e136);
            let _e139 = x_9;
            let _e141 = gabor_impl_node(_e139, 2i);
            let _e142 = y_j;
            let _e143 = z_k;
            let _e144 = scale_1;
            let _e149 = x_9.word[2];
            let _e150 = row_3;
            gabor_impl_add_node_waves_3d((&sum_14), _e141, _e142, _e143, _e144, place.evolution, tangents, _e149, _e150);
        }
        continuing {
            let _e82 = i_3;
            i_3 = (_e82 + 1i);
        }
    }
    if tangents.only {
        local_24 = 2f;
    } else {
        local_24 = 3f;
    }
    let _e165 = local_24;
    if false {
        local_25 = 1f;
    } else {
        local_25 = 1.125f;
    }
    let _e175 = local_25;
    if false {
        local_26 = 1f;
    } else {
        local_26 = 1.125f;
    }
    let _e188 = local_26;
    amplitude_3 = (inverseSqrt((_e165 * _e175)) / (1459955300000000000000000000f * _e188));
    let _e193 = sum_14;
    let _e194 = amplitude_3;
    let _e195 = stretch_4;
    gabor_impl_add_field_3d((&field_6), _e193, _e194, _e195);
    let _e197 = field_6;
    return _e197;
}

fn gabor_field_3d_isotropic(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d {
    let _e3 = gabor_impl_all_directions();
    let _e4 = gabor_impl_isotropic(place, frequency, _e3, seed);
    return _e4;
}

fn gabor_noise_3d_isotropic(p: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e3 = gabor_place_3d_at(p);
    let _e4 = gabor_field_3d_isotropic(_e3, frequency, seed);
    return _e4.noise;
}

fn gabor_field_surface_isotropic(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_6: vec3<f32>;
    var aside: f32;
    var sum_15: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_27: i32;
    var i_4: i32;
    var local_28: i32;
    var local_29: f32;
    var power_2: f32;
    normal_6 = normal;
    let _e5 = normal_6;
    let _e6 = gabor_impl_unit(_e5);
    normal_6 = _e6;
    let _e7 = normal_6;
    let _e9 = normal_6;
    aside = dot(_e7.xy, _e9.xy);
    let _e22 = aside;
    if (_e22 > 0.25f) {
        local_27 = 0i;
    } else {
        local_27 = 1i;
    }
    let _e28 = local_27;
    i_4 = _e28;
    loop {
        let _e30 = i_4;
        let _e31 = aside;
        if (_e31 < 0.5f) {
            local_28 = 2i;
        } else {
            local_28 = 1i;
        }
        let _e37 = local_28;
        if !((_e30 < _e37)) {
            break;
        }
        {
            let _e43 = i_4;
            if (_e43 == 0i) {
                let _e48 = aside;
                local_29 = smoothstep(0.25f, 0.5f, _e48);
            } else {
                let _e53 = aside;
                local_29 = (1f - smoothstep(0.25f, 0.5f, _e53));
            }
            let _e57 = local_29;
            let _e58 = gabor_impl_takeover(_e57);
            power_2 = _e58;
            let _e61 = normal_6;
            let _e62 = i_4;
            let _e63 = gabor_impl_tangents(_e61, _e62);
            let _e64 = i_4;
            let _e65 = gabor_derived_seed(seed, _e64);
            let _e66 = gabor_impl_isotropic(place, frequency, _e63, _e65);
            let _e67 = power_2;
            gabor_impl_add_field_3d((&sum_15), _e66, sqrt(_e67), vec3(1f));
        }
        continuing {
            let _e40 = i_4;
            i_4 = (_e40 + 1i);
        }
    }
    let _e72 = sum_15;
    return _e72;
}

