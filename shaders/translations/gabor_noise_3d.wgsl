// Generated from gabor_noise_3d.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 2443d13bc3b47ae5.
//
// gabor_noise_3d.wgsl: Gabor noise in space, and on surfaces without texture coordinates, with mean 0, variance 1 and
// a normal distribution at every point.
//
// Paste or include this file after gabor_noise.wgsl and gabor_spectrum.wgsl, with GABOR_TAPS 3, the default.
//
//     f32 n = gabor_noise_3d_isotropic(p, 2.0, 7u);                   // 2 cycles per kernel radius, seed 7
//     f32 s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
//
// Arguments of all functions, besides those of gabor_noise.wgsl:
//     direction  a vector along the wave vector, of any length from 10^-15 to 10^15; (0, 0, 0) gives noise of
//                frequency 0
//     normal     normal of the surface, of any length from 10^-15 to 10^15
//     dx, dy     change of p, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// All may vary with p; where they are continuous, so is the noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// ---- Solid noise with one wave vector ------------------------------------------------------------------------------

// f32 gabor_noise_3d(vec3f p, f32 frequency, vec3f direction, u32 seed)
// f32 gabor_noise_3d_tiled(vec3f p, vec3f period, f32 frequency, vec3f direction, u32 seed)
//     The noise, with continuous first derivatives.

// f32 gabor_noise_3d_animated(vec3f p, f32 moment, f32 frequency, vec3f direction, u32 seed)
// vec4f gabor_noise_3d_four(vec3f p, f32 frequency, vec3f direction, u32 seed)
// vec2f gabor_noise_3d_complex(vec3f p, f32 frequency, vec3f direction, u32 seed)
//     Like gabor_noise_animated, gabor_noise_four and gabor_noise_complex.

// vec4f gabor_noise_3d_gradient(vec3f p, f32 frequency, vec3f direction, u32 seed)
//     (noise, d/dx, d/dy, d/dz). The derivatives are per kernel radius, for a constant wave vector. For a bump map,
//     subtract the gradient's component along the normal.

// vec2f gabor_noise_3d_filtered(vec3f p, vec3f dx, vec3f dy, f32 frequency, vec3f direction, u32 seed)
//     (noise, removed): the noise averaged over a pixel, and the share of its variance that averaging removed. The
//     error is that of gabor_noise_filtered: 1 % as long as the pixel's longest axis is at most a third of a kernel
//     radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a call costs 1.4 times
//     as much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2 (64 nodes), and at
//     most 6.6 times (125 nodes).

// ---- Isotropic solid noise -----------------------------------------------------------------------------------------

// f32 gabor_noise_3d_isotropic(vec3f p, f32 frequency, u32 seed)
//     Noise of waves in all directions, at the same cost for every frequency: about seven times that of gabor_noise_3d.
//     Value and gradient are normal, with the same variance at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Second derivatives, and values at several points
//     together, follow mixtures of normal distributions.

// vec4f gabor_noise_3d_isotropic_gradient(vec3f p, f32 frequency, u32 seed)
//     (noise, d/dx, d/dy, d/dz), per kernel radius.

// vec2f gabor_noise_3d_isotropic_filtered(vec3f p, vec3f dx, vec3f dy, f32 frequency, u32 seed)
//     Like gabor_noise_3d_filtered, at less than twice the cost of gabor_noise_3d_isotropic. The rms error against
//     exactly filtered noise is 2 % of a standard deviation as long as the pixel's longest axis is at most 0.3 kernel
//     radii, and 3 % at 0.4. For larger pixels, only the variance is right.

// ---- Noise on a surface --------------------------------------------------------------------------------------------

// f32 gabor_noise_surface(vec3f p, vec3f normal, f32 frequency, vec3f direction, u32 seed)
//     Noise at point p on a surface, with waves along the projection of a direction onto the tangent plane. As the
//     angle between direction and normal falls from 30 to 14 degrees, a second noise, whose direction is perpendicular
//     to the given one, takes over; in between, both are computed. On a curved surface, waves bend within each kernel.

// f32 gabor_noise_surface_isotropic(vec3f p, vec3f normal, f32 frequency, u32 seed)
//     Noise of waves along all tangents, at the same cost for every frequency: about five times that of gabor_noise_3d,
//     and about ten times where the normal is 30 to 45 degrees from the z axis. Value and derivatives along the surface
//     have the distributions of gabor_noise_3d_isotropic.

// ---- For large worlds, and for periods, time and filters combined --------------------------------------------------

// A position in node spacings of the lattice, with a period, a time and a pixel: see GaborPlace.
struct GaborPlace3d {
    cell: vec3<i32>,
    local: vec3<f32>,
    radius: vec3<f32>,
    period: vec3<i32>,
    animated: bool,
    moment: f32,
    filtered: bool,
    dx: vec3<f32>,
    dy: vec3<f32>,
}

// Noise and quadrature, with their gradients per kernel radius. Unused parts cost nothing.
struct GaborField3d {
    noise: f32,
    gradient: vec3<f32>,
    quadrature: f32,
    quadrature_gradient: vec3<f32>,
    removed: f32,
}

// GaborPlace3d gabor_place_3d(vec3i cell, vec3f local)
//     The position (cell + local) / GABOR_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells along each
//     axis.

// GaborField3d gabor_field_3d(GaborPlace3d place, f32 frequency, vec3f direction, u32 seed)
// GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, f32 frequency, u32 seed)
// GaborField3d gabor_field_surface(GaborPlace3d place, vec3f normal, f32 frequency, vec3f direction, u32 seed)
// GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, vec3f normal, f32 frequency, u32 seed)
//     The noises above, for a GaborPlace3d. All noise functions call these four.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

fn gabor_place_3d(cell: vec3<i32>, local: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3(1.5f), vec3(0i), false, 0f, false, vec3(0f), vec3(0f));
}

// Scales a vector to length 1 if its length is 10^-15 to 10^15; shorter vectors approach 0.
fn gabor_impl_unit(v: vec3<f32>) -> vec3<f32> {
    var v_4: vec3<f32>;
    v_4 = v;
    let _e2 = v_4;
    v_4 = clamp(_e2, vec3(-1000000000000000f), vec3(1000000000000000f));
    let _e9 = v_4;
    let _e10 = v_4;
    let _e11 = v_4;
    return (_e9 * inverseSqrt(max(dot(_e10, _e11), 0.000000000000000000000000000001f)));
}

// ---- One wave vector -----------------------------------------------------------------------------------------------
//
// As in the plane, the nodes c of a lattice with R = 3/2 nodes per kernel radius emit waves under Hann's windows h,
// with independent normal amplitudes A. The windows of the nearest node and its 26 neighbours reach a point:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// The variance is 1 at every point for any wave vector F. So F may follow a surface, which then shows the requested
// frequency and no trace of the lattice.

// Adds slice k of nodes. `sum` receives the noise and, in zw, the part of its derivative along x that comes from the
// window; `slopes` receives the same part of its derivatives along y and z. The filter adds mixed derivatives, weighted
// by its covariances yz, zx, xy.
fn gabor_impl_add_node_slice(sum: ptr<function, vec4<f32>>, slopes: ptr<function, vec4<f32>>, place: GaborPlace3d, x: GaborAxis, y: GaborAxis, z: GaborAxis, k: i32, mixed: vec3<f32>) {
    var y_10: GaborAxis;
    var j_5: i32 = 0i;
    var slice_3: vec4<f32>;
    var slope_9: vec4<f32>;
    y_10 = y;
    loop {
        let _e11 = j_5;
        if !((_e11 < 3i)) {
            break;
        }
        let _e18 = j_5;
        let _e21 = j_5;
        let _e24 = y_10.word[_e21];
        let _e27 = gabor_impl_slice_word(_e24, z.word[k]);
        y_10.word[_e18] = _e27;
        continuing {
            let _e15 = j_5;
            j_5 = (_e15 + 1i);
        }
    }
    let _e30 = y_10;
    gabor_impl_sum(x, _e30, place.animated, place.moment, (&slice_3), (&slope_9));
    let _e38 = slice_3;
    gabor_impl_add_products(sum, _e38, z.node[k].xy);
    let _e43 = (*slopes);
    let _e44 = slope_9;
    let _e49 = gabor_impl_product(_e44.xy, z.node[k].xy);
    let _e50 = slice_3;
    let _e55 = gabor_impl_product(_e50.xy, z.node[k].zw);
    (*slopes) = (_e43 + vec4<f32>(_e49.x, _e49.y, _e55.x, _e55.y));
    if place.filtered {
        let _e63 = (*sum);
        let _e65 = slope_9;
        let _e69 = slice_3;
        let _e76 = gabor_impl_product(((mixed.x * _e65.xy) + (mixed.y * _e69.zw)), z.node[k].zw);
        let _e78 = slope_9;
        let _e83 = gabor_impl_product(_e78.zw, z.node[k].xy);
        let _e85 = (_e76 + (mixed.z * _e83));
        (*sum) = (_e63 + vec4<f32>(_e85.x, _e85.y, 0f, 0f));
        return;
    } else {
        return;
    }
}

// The noise of 27 nodes. If the place is filtered, the filter uses three waves along each axis: see
// gabor_spectrum.wgsl. K makes E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1. A wave's derivative is the wave times
// 2 pi i F.
fn gabor_impl_sum_3d(place: GaborPlace3d, wave: vec3<f32>, pixel: GaborMatrix, salt: u32) -> GaborField3d {
    var x_15: GaborAxis;
    var y_11: GaborAxis;
    var z_4: GaborAxis;
    var local_32: f32;
    var local_33: f32;
    var turn_10: vec2<f32>;
    var blurred_4: vec3<f32>;
    var sum_16: vec4<f32> = vec4(0f);
    var slopes_1: vec4<f32> = vec4(0f);
    let _e15 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, 1.5f);
    x_15 = _e15;
    let _e30 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), wave.y, 1.5f);
    y_11 = _e30;
    let _e45 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (salt ^ 668265263u), wave.z, 1.5f);
    z_4 = _e45;
    if false {
        local_32 = 1f;
    } else {
        local_32 = 1.125f;
    }
    let _e56 = local_32;
    if false {
        local_33 = 1f;
    } else {
        local_33 = 1.125f;
    }
    let _e68 = local_33;
    let _e71 = x_15;
    let _e73 = x_15;
    let _e76 = y_11;
    let _e78 = y_11;
    let _e82 = z_4;
    let _e84 = z_4;
    let _e88 = gabor_impl_wave((((_e71.turns * _e73.offset) + (_e76.turns * _e78.offset)) + (_e82.turns * _e84.offset)));
    turn_10 = ((inverseSqrt(_e56) / (1459955300000000000000000000f * _e68)) * _e88);
    if place.filtered {
        {
            let _e92 = gabor_impl_symmetric_3d(pixel, wave);
            blurred_4 = _e92;
            let _e97 = blurred_4;
            gabor_impl_filter((&x_15), pixel.diagonal.x, _e97.x);
            let _e103 = blurred_4;
            gabor_impl_filter((&y_11), pixel.diagonal.y, _e103.y);
            let _e109 = blurred_4;
            gabor_impl_filter((&z_4), pixel.diagonal.z, _e109.z);
            let _e112 = turn_10;
            let _e115 = blurred_4;
            turn_10 = (_e112 * exp((-19.739208f * max(dot(wave, _e115), 0f))));
        }
    }
    let _e130 = x_15;
    let _e131 = y_11;
    let _e132 = z_4;
    gabor_impl_add_node_slice((&sum_16), (&slopes_1), place, _e130, _e131, _e132, 0i, pixel.mixed);
    let _e139 = x_15;
    let _e140 = y_11;
    let _e141 = z_4;
    gabor_impl_add_node_slice((&sum_16), (&slopes_1), place, _e139, _e140, _e141, 1i, pixel.mixed);
    let _e148 = x_15;
    let _e149 = y_11;
    let _e150 = z_4;
    gabor_impl_add_node_slice((&sum_16), (&slopes_1), place, _e148, _e149, _e150, 2i, pixel.mixed);
    let _e155 = sum_16;
    let _e157 = turn_10;
    let _e158 = gabor_impl_product(_e155.xy, _e157);
    let _e159 = sum_16;
    let _e161 = turn_10;
    let _e162 = gabor_impl_product(_e159.zw, _e161);
    sum_16 = vec4<f32>(_e158.x, _e158.y, _e162.x, _e162.y);
    let _e168 = slopes_1;
    let _e170 = turn_10;
    let _e171 = gabor_impl_product(_e168.xy, _e170);
    let _e172 = slopes_1;
    let _e174 = turn_10;
    let _e175 = gabor_impl_product(_e172.zw, _e174);
    slopes_1 = vec4<f32>(_e171.x, _e171.y, _e175.x, _e175.y);
    let _e181 = sum_16;
    let _e183 = sum_16;
    let _e185 = slopes_1;
    let _e187 = slopes_1;
    let _e191 = sum_16;
    let _e196 = sum_16;
    let _e198 = sum_16;
    let _e200 = slopes_1;
    let _e202 = slopes_1;
    let _e206 = sum_16;
    return GaborField3d(_e181.y, (vec3<f32>(_e183.w, _e185.y, _e187.w) + ((6.2831855f * _e191.x) * wave)), _e196.x, (vec3<f32>(_e198.z, _e200.x, _e202.z) - ((6.2831855f * _e206.y) * wave)), 0f);
}

// Adds a field times an amplitude. A kernel radius is `stretch` times the field's unit of length.
fn gabor_impl_add_field_3d(sum: ptr<function, GaborField3d>, field: GaborField3d, amplitude: f32, stretch: vec3<f32>) {
    let _e5 = (*sum);
    (*sum).noise = (_e5.noise + (amplitude * field.noise));
    let _e11 = (*sum);
    (*sum).gradient = (_e11.gradient + ((amplitude * stretch) * field.gradient));
    let _e18 = (*sum);
    (*sum).quadrature = (_e18.quadrature + (amplitude * field.quadrature));
    let _e24 = (*sum);
    (*sum).quadrature_gradient = (_e24.quadrature_gradient + ((amplitude * stretch) * field.quadrature_gradient));
    return;
}

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_RADIUS node spacings.
struct GaborPixelAxes {
    major: vec3<f32>,
    minor: vec3<f32>,
}

fn gabor_impl_pixel(place: GaborPlace3d, stretch: vec3<f32>) -> GaborPixelAxes {
    var dx_9: vec3<f32>;
    var dy_9: vec3<f32>;
    var twice_2: vec2<f32>;
    var cosine: f32;
    var turn_11: vec2<f32>;
    dx_9 = (clamp(place.dx, vec3(-1000000f), vec3(1000000f)) * stretch);
    dy_9 = (clamp(place.dy, vec3(-1000000f), vec3(1000000f)) * stretch);
    let _e20 = dx_9;
    let _e21 = dx_9;
    let _e23 = dy_9;
    let _e24 = dy_9;
    let _e28 = dx_9;
    let _e29 = dy_9;
    twice_2 = vec2<f32>((dot(_e20, _e21) - dot(_e23, _e24)), (2f * dot(_e28, _e29)));
    let _e34 = twice_2;
    let _e36 = twice_2;
    cosine = (_e34.x / max(length(_e36), 0.000000000000000000000000000001f));
    let _e47 = cosine;
    turn_11 = sqrt(max((vec2(0.5f) + (vec2<f32>(0.5f, -0.5f) * _e47)), vec2(0f)));
    let _e56 = twice_2;
    if (_e56.y < 0f) {
        let _e61 = turn_11;
        turn_11.y = -(_e61.y);
    }
    let _e64 = turn_11;
    let _e66 = dx_9;
    let _e68 = turn_11;
    let _e70 = dy_9;
    let _e73 = turn_11;
    let _e75 = dy_9;
    let _e77 = turn_11;
    let _e79 = dx_9;
    return GaborPixelAxes(((_e64.x * _e66) + (_e68.y * _e70)), ((_e73.x * _e75) - (_e77.y * _e79)));
}

// Limits the length of each axis to `most`.
fn gabor_impl_resolved(pixel: GaborPixelAxes, most: f32) -> GaborPixelAxes {
    return GaborPixelAxes(((most * inverseSqrt(max(dot(pixel.major, pixel.major), (most * most)))) * pixel.major), ((most * inverseSqrt(max(dot(pixel.minor, pixel.minor), (most * most)))) * pixel.minor));
}

fn gabor_impl_covariance(pixel: GaborPixelAxes) -> GaborMatrix {
    var major: vec3<f32>;
    var minor: vec3<f32>;
    major = (0.5f * pixel.major);
    minor = (0.5f * pixel.minor);
    let _e9 = major;
    let _e10 = major;
    let _e12 = minor;
    let _e13 = minor;
    let _e16 = major;
    let _e18 = major;
    let _e21 = minor;
    let _e23 = minor;
    return GaborMatrix(((_e9 * _e10) + (_e12 * _e13)), ((_e16.yzx * _e18.zxy) + (_e21.yzx * _e23.zxy)));
}

// 1 + 2/3 pi^2 S along each axis of a pixel, where S is the filter's variance: see gabor_impl_transmitted.
fn gabor_impl_spread(pixel: GaborPixelAxes) -> vec2<f32> {
    return (vec2(1f) + (1.644934f * vec2<f32>(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor))));
}

// The share of a lobe's variance that a pixel's filter keeps.
fn gabor_impl_transmitted_3d(wave: vec3<f32>, pixel: GaborPixelAxes) -> f32 {
    var d_6: vec2<f32>;
    var k_2: vec2<f32>;
    let _e2 = gabor_impl_spread(pixel);
    d_6 = _e2;
    k_2 = vec2<f32>(dot(wave, pixel.major), dot(wave, pixel.minor));
    let _e11 = k_2;
    let _e12 = k_2;
    let _e15 = d_6;
    let _e24 = d_6;
    let _e26 = d_6;
    return (exp(-(min((9.869604f * dot((_e11 * _e12), (vec2(1f) / _e15))), 80f))) * inverseSqrt((_e24.x * _e26.y)));
}

// With periods, nodes are not 1 / GABOR_RADIUS kernel radii apart, so all lengths here are in units of GABOR_RADIUS
// node spacings.
fn gabor_field_3d(place: GaborPlace3d, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var stretch_5: vec3<f32>;
    var wave_22: vec3<f32>;
    var salt_11: u32;
    var amplitude_5: f32 = 1f;
    var transmitted_1: f32 = 1f;
    var wide_1: f32 = 0f;
    var pixel_9: GaborMatrix = GaborMatrix(vec3(0f), vec3(0f));
    var whole: GaborPixelAxes;
    var resolved: GaborPixelAxes;
    var variance_1: vec3<f32>;
    var sum_18: GaborField3d;
    var noise_4: vec4<f32>;
    var quadrature_1: vec4<f32>;
    stretch_5 = (place.radius / vec3(1.5f));
    let _e15 = gabor_impl_unit(direction);
    let _e17 = stretch_5;
    wave_22 = ((min(abs(frequency), 1000000f) * _e15) / _e17);
    let _e20 = gabor_impl_salt(seed);
    salt_11 = _e20;
    if place.filtered {
        {
            let _e35 = stretch_5;
            let _e36 = gabor_impl_pixel(place, _e35);
            whole = _e36;
            let _e38 = whole;
            let _e40 = gabor_impl_resolved(_e38, 1f);
            resolved = _e40;
            let _e42 = wave_22;
            let _e43 = whole;
            let _e44 = gabor_impl_transmitted_3d(_e42, _e43);
            transmitted_1 = _e44;
            let _e45 = transmitted_1;
            let _e46 = wave_22;
            let _e47 = resolved;
            let _e48 = gabor_impl_transmitted_3d(_e46, _e47);
            amplitude_5 = sqrt((_e45 / _e48));
            let _e51 = transmitted_1;
            if !((_e51 > 0.0000000001f)) {
                transmitted_1 = 0f;
            }
            let _e56 = resolved;
            let _e57 = gabor_impl_covariance(_e56);
            pixel_9 = _e57;
            let _e58 = pixel_9;
            variance_1 = _e58.diagonal;
            let _e62 = variance_1;
            let _e64 = variance_1;
            let _e67 = variance_1;
            wide_1 = clamp(((100f * sqrt(max(max(_e62.x, _e64.y), _e67.z))) - 9f), 0f, 1f);
        }
    }
    let _e84 = transmitted_1;
    sum_18 = GaborField3d(0f, vec3(0f), 0f, vec3(0f), (1f - _e84));
    let _e88 = transmitted_1;
    if (_e88 == 0f) {
        let _e91 = sum_18;
        return _e91;
    }
    let _e92 = wide_1;
    if (_e92 < 1f) {
        let _e96 = wave_22;
        let _e97 = pixel_9;
        let _e98 = salt_11;
        let _e99 = gabor_impl_sum_3d(place, _e96, _e97, _e98);
        let _e101 = wide_1;
        let _e103 = amplitude_5;
        let _e105 = stretch_5;
        gabor_impl_add_field_3d((&sum_18), _e99, ((1f - _e101) * _e103), _e105);
    }
    let _e107 = wide_1;
    if (_e107 > 0f) {
        {
            let _e117 = wave_22;
            let _e118 = pixel_9;
            let _e119 = wide_1;
            let _e122 = salt_11;
            gabor_impl_filtered_space(place.cell, place.local, place.period, place.animated, place.moment, _e117, _e118, (_e119 > 0f), _e122, (&noise_4), (&quadrature_1));
            let _e128 = noise_4;
            let _e130 = noise_4;
            let _e132 = quadrature_1;
            let _e134 = quadrature_1;
            let _e138 = wide_1;
            let _e139 = amplitude_5;
            let _e141 = stretch_5;
            gabor_impl_add_field_3d((&sum_18), GaborField3d(_e128.x, _e130.yzw, _e132.x, _e134.yzw, 0f), (_e138 * _e139), _e141);
        }
    }
    let _e143 = sum_18;
    return _e143;
}

// Adds one of two independent noises, which replaces the other as x goes from 0 to 1.
fn gabor_impl_add_share_3d(sum: ptr<function, GaborField3d>, term: GaborField3d, x: f32) {
    var power_5: f32;
    let _e3 = gabor_impl_takeover(x);
    power_5 = _e3;
    let _e6 = power_5;
    gabor_impl_add_field_3d(sum, term, sqrt(_e6), vec3(1f));
    let _e12 = (*sum);
    let _e14 = power_5;
    (*sum).removed = (_e12.removed + (_e14 * term.removed));
    return;
}

fn gabor_field_surface(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var normal_1: vec3<f32>;
    var direction_3: vec3<f32>;
    var local_34: vec3<f32>;
    var other: vec3<f32>;
    var flat_length: f32;
    var sum_20: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_35: i32;
    var i_7: i32;
    var local_36: i32;
    var local_37: vec3<f32>;
    var local_38: f32;
    normal_1 = normal;
    direction_3 = direction;
    let _e7 = normal_1;
    let _e8 = gabor_impl_unit(_e7);
    normal_1 = _e8;
    let _e9 = direction_3;
    let _e10 = gabor_impl_unit(_e9);
    direction_3 = _e10;
    let _e11 = direction_3;
    let _e12 = direction_3;
    if (abs(_e12.z) < 0.7f) {
        local_34 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_34 = vec3<f32>(1f, 0f, 0f);
    }
    let _e26 = local_34;
    other = cross(_e11, _e26);
    let _e29 = direction_3;
    let _e30 = direction_3;
    let _e31 = normal_1;
    let _e33 = normal_1;
    direction_3 = (_e29 - (dot(_e30, _e31) * _e33));
    let _e36 = other;
    let _e37 = other;
    let _e38 = normal_1;
    let _e40 = normal_1;
    other = (_e36 - (dot(_e37, _e38) * _e40));
    let _e43 = direction_3;
    let _e44 = direction_3;
    flat_length = dot(_e43, _e44);
    let _e56 = flat_length;
    if (_e56 > 0.0625f) {
        local_35 = 0i;
    } else {
        local_35 = 1i;
    }
    let _e62 = local_35;
    i_7 = _e62;
    loop {
        let _e64 = i_7;
        let _e65 = flat_length;
        if (_e65 < 0.25f) {
            local_36 = 2i;
        } else {
            local_36 = 1i;
        }
        let _e71 = local_36;
        if !((_e64 < _e71)) {
            break;
        }
        let _e78 = i_7;
        if (_e78 == 0i) {
            let _e81 = direction_3;
            local_37 = _e81;
        } else {
            let _e82 = other;
            local_37 = _e82;
        }
        let _e84 = local_37;
        let _e85 = i_7;
        let _e86 = gabor_lobe_seed(seed, _e85);
        let _e87 = gabor_field_3d(place, frequency, _e84, _e86);
        let _e88 = i_7;
        if (_e88 == 0i) {
            let _e93 = flat_length;
            local_38 = smoothstep(0.0625f, 0.25f, _e93);
        } else {
            let _e99 = flat_length;
            local_38 = smoothstep(-0.25f, -0.0625f, -(_e99));
        }
        let _e103 = local_38;
        gabor_impl_add_share_3d((&sum_20), _e87, _e103);
        continuing {
            let _e74 = i_7;
            i_7 = (_e74 + 1i);
        }
    }
    let _e105 = sum_20;
    return _e105;
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

// Adds a wave of a node; x, y and z come from gabor_impl_node. `wave` is the wave vector and, in w, the turns from the
// node to the point. The filter (see gabor_spectrum.wgsl) multiplies the wave by exp(-2 pi^2 F.S F). With s = 2 pi^2
// S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
fn gabor_impl_add_node_wave_3d(sum: ptr<function, GaborField3d>, x: vec4<f32>, y: vec4<f32>, z: vec4<f32>, wave: vec4<f32>, place: GaborPlace3d, pixel: GaborMatrix, word: u32) {
    var a_7: vec2<f32>;
    var middle: vec3<f32>;
    var cosine_1: vec3<f32>;
    var sine: vec3<f32>;
    var h: vec3<f32>;
    var slope_10: vec3<f32>;
    var turned_2: vec3<f32> = vec3(0f);
    var value_11: vec2<f32>;
    var s_7: vec3<f32>;
    var r_2: vec3<f32>;
    var even_3: vec3<f32>;
    var odd_3: vec3<f32>;
    var mixed_2: f32;
    var i_h: vec3<f32>;
    var i_slope: vec3<f32>;
    var real_4: vec3<f32>;
    var imaginary_4: vec3<f32>;
    let _e10 = gabor_impl_amplitude_at(word, place.animated, place.moment);
    let _e12 = gabor_impl_wave(wave.w);
    let _e13 = gabor_impl_product(_e10, _e12);
    a_7 = _e13;
    middle = vec3<f32>(x.y, y.y, z.y);
    cosine_1 = vec3<f32>(x.z, y.z, z.z);
    sine = vec3<f32>(x.w, y.w, z.w);
    let _e30 = middle;
    let _e31 = cosine_1;
    h = (_e30 + _e31);
    let _e34 = sine;
    let _e35 = h;
    let _e37 = h;
    slope_10 = (_e34 * (_e35.yzx * _e37.zxy));
    let _e45 = h;
    let _e47 = h;
    let _e49 = h;
    let _e53 = a_7;
    value_11 = ((_e45.x * (_e47.y * _e49.z)) * _e53);
    if place.filtered {
        {
            let _e59 = gabor_impl_symmetric_3d(pixel, wave.xyz);
            s_7 = (19.739208f * _e59);
            let _e62 = a_7;
            let _e64 = s_7;
            a_7 = (_e62 * exp(-(max(dot(wave.xyz, _e64), 0f))));
            let _e71 = s_7;
            s_7 = clamp(_e71, vec3(-3f), vec3(3f));
            let _e78 = s_7;
            let _e79 = s_7;
            r_2 = (_e78 * _e79);
            let _e83 = r_2;
            let _e86 = r_2;
            even_3 = (vec3(1f) + (_e83 * (vec3(0.5f) + (0.041666668f * _e86))));
            let _e94 = s_7;
            let _e96 = r_2;
            let _e99 = r_2;
            odd_3 = (_e94 * (vec3(1f) + (_e96 * (vec3(0.16666667f) + (0.008333333f * _e99)))));
            let _e109 = sine;
            let _e111 = sine;
            let _e114 = h;
            mixed_2 = dot(pixel.mixed, ((_e109.yzx * _e111.zxy) * _e114));
            let _e118 = middle;
            let _e119 = even_3;
            let _e120 = cosine_1;
            h = (_e118 + (_e119 * _e120));
            let _e124 = odd_3;
            let _e126 = sine;
            i_h = ((0.3183099f * _e124) * _e126);
            let _e131 = odd_3;
            let _e133 = cosine_1;
            i_slope = ((-3.1415927f * _e131) * _e133);
            let _e136 = h;
            let _e138 = h;
            let _e141 = i_h;
            let _e143 = i_h;
            real_4 = ((_e136.yzx * _e138.zxy) - (_e141.yzx * _e143.zxy));
            let _e148 = h;
            let _e150 = i_h;
            let _e153 = i_h;
            let _e155 = h;
            imaginary_4 = ((_e148.yzx * _e150.zxy) + (_e153.yzx * _e155.zxy));
            let _e160 = h;
            let _e162 = real_4;
            let _e165 = i_h;
            let _e167 = imaginary_4;
            let _e171 = mixed_2;
            let _e173 = h;
            let _e175 = imaginary_4;
            let _e178 = i_h;
            let _e180 = real_4;
            value_11 = vec2<f32>((((_e160.x * _e162.x) - (_e165.x * _e167.x)) + _e171), ((_e173.x * _e175.x) + (_e178.x * _e180.x)));
            let _e185 = value_11;
            let _e186 = a_7;
            let _e187 = gabor_impl_product(_e185, _e186);
            value_11 = _e187;
            let _e188 = even_3;
            let _e189 = sine;
            let _e191 = real_4;
            let _e193 = i_slope;
            let _e194 = imaginary_4;
            slope_10 = (((_e188 * _e189) * _e191) - (_e193 * _e194));
            let _e197 = even_3;
            let _e198 = sine;
            let _e200 = imaginary_4;
            let _e202 = i_slope;
            let _e203 = real_4;
            turned_2 = (((_e197 * _e198) * _e200) + (_e202 * _e203));
        }
    }
    let _e207 = (*sum);
    let _e209 = value_11;
    (*sum).noise = (_e207.noise + _e209.y);
    let _e213 = (*sum);
    let _e215 = slope_10;
    let _e216 = a_7;
    let _e219 = turned_2;
    let _e220 = a_7;
    let _e225 = value_11;
    (*sum).gradient = (_e213.gradient + (((_e215 * _e216.y) + (_e219 * _e220.x)) + ((6.2831855f * _e225.x) * wave.xyz)));
    let _e233 = (*sum);
    let _e235 = value_11;
    (*sum).quadrature = (_e233.quadrature + _e235.x);
    let _e239 = (*sum);
    let _e241 = slope_10;
    let _e242 = a_7;
    let _e245 = turned_2;
    let _e246 = a_7;
    let _e251 = value_11;
    (*sum).quadrature_gradient = (_e239.quadrature_gradient + (((_e241 * _e242.x) - (_e245 * _e246.y)) - ((6.2831855f * _e251.y) * wave.xyz)));
    return;
}

// The directions of isotropic noise: all or, if `only`, those in the tangent plane that two perpendicular unit vectors
// span.
struct GaborTangents {
    only: bool,
    along: vec3<f32>,
    across: vec3<f32>,
}

// Adds a node's waves. The words of its row times the word of its column give the amplitudes and the directions. A wave
// along -u is also a wave along u, so turning the first vector within half a circle reaches every direction of a
// surface. In space, the first vector also tilts along z, and the other two turn around it within a quarter circle.
fn gabor_impl_add_node_waves_3d(sum: ptr<function, GaborField3d>, x: vec4<f32>, y: vec4<f32>, z: vec4<f32>, place: GaborPlace3d, pixel: GaborMatrix, scale: vec3<f32>, tangents: GaborTangents, column: u32, row: vec4<u32>) {
    var word_6: u32;
    var turn_12: vec2<f32>;
    var first_3: vec3<f32>;
    var second_3: vec3<f32>;
    var d_7: vec3<f32>;
    var u_2: vec4<f32>;
    var v_5: vec4<f32>;
    var w_3: vec4<f32>;
    var rise_2: f32;
    var level: f32;
    var spin: vec2<f32>;
    var across_1: vec4<f32>;
    var lifted: vec4<f32>;
    var unit_4: vec4<f32>;
    word_6 = (column * row.w);
    let _e14 = word_6;
    let _e18 = gabor_impl_half_turn((0.00000000011641532f * f32(i32(_e14))));
    turn_12 = _e18;
    let _e20 = turn_12;
    let _e24 = turn_12;
    first_3 = ((_e20.x * tangents.along) + (_e24.y * tangents.across));
    let _e30 = turn_12;
    let _e34 = turn_12;
    second_3 = ((_e30.x * tangents.across) - (_e34.y * tangents.along));
    d_7 = (scale * vec3<f32>(x.x, y.x, z.x));
    let _e46 = first_3;
    let _e47 = first_3;
    let _e48 = d_7;
    u_2 = vec4<f32>(_e46.x, _e46.y, _e46.z, dot(_e47, _e48));
    let _e55 = second_3;
    let _e56 = second_3;
    let _e57 = d_7;
    v_5 = vec4<f32>(_e55.x, _e55.y, _e55.z, dot(_e56, _e57));
    let _e67 = d_7;
    w_3 = vec4<f32>(0f, 0f, 1f, _e67.z);
    if !(tangents.only) {
        {
            let _e74 = word_6;
            rise_2 = (0.0000000004656613f * f32(i32((_e74 << 12u))));
            let _e82 = rise_2;
            let _e83 = rise_2;
            level = sqrt(max((1f - (_e82 * _e83)), 0f));
            let _e91 = word_6;
            let _e97 = gabor_impl_half_turn((0.00000000005820766f * f32(i32((_e91 << 20u)))));
            spin = _e97;
            let _e99 = v_5;
            across_1 = _e99;
            let _e101 = level;
            let _e102 = w_3;
            let _e104 = rise_2;
            let _e105 = u_2;
            lifted = ((_e101 * _e102) - (_e104 * _e105));
            let _e109 = level;
            let _e110 = u_2;
            let _e112 = rise_2;
            let _e113 = w_3;
            u_2 = ((_e109 * _e110) + (_e112 * _e113));
            let _e116 = spin;
            let _e118 = across_1;
            let _e120 = spin;
            let _e122 = lifted;
            v_5 = ((_e116.x * _e118) + (_e120.y * _e122));
            let _e125 = spin;
            let _e127 = lifted;
            let _e129 = spin;
            let _e131 = across_1;
            w_3 = ((_e125.x * _e127) - (_e129.y * _e131));
        }
    }
    unit_4 = vec4<f32>(scale.x, scale.y, scale.z, 1f);
    let _e141 = unit_4;
    let _e142 = u_2;
    gabor_impl_add_node_wave_3d(sum, x, y, z, (_e141 * _e142), place, pixel, (column * row.x));
    let _e148 = unit_4;
    let _e149 = v_5;
    gabor_impl_add_node_wave_3d(sum, x, y, z, (_e148 * _e149), place, pixel, (column * row.y));
    if !(tangents.only) {
        let _e157 = unit_4;
        let _e158 = w_3;
        gabor_impl_add_node_wave_3d(sum, x, y, z, (_e157 * _e158), place, pixel, (column * row.z));
        return;
    } else {
        return;
    }
}

// (d, middle, cosine, sine) of a node on an axis: the point's offset d from the node; the parts of the window,
// middle = 1/2 and cosine = cos(pi d) / 2; and the window's derivative, sine = -pi / 2 sin(pi d). Filtered windows fade
// out within half a standard deviation of their ends.
fn gabor_impl_node(offset: f32, node: vec4<f32>, variance: f32) -> vec4<f32> {
    var offset_1: f32;
    var fade_5: f32 = 1f;
    var fall_1: f32 = 1f;
    offset_1 = offset;
    let _e4 = offset_1;
    offset_1 = (_e4 / 1.5f);
    if (variance > 0f) {
        {
            let _e17 = offset_1;
            fade_5 = clamp(((1f - abs(_e17)) / clamp((0.5f * sqrt(variance)), 0.001f, 0.05f)), 0f, 1f);
            let _e30 = fade_5;
            let _e31 = fade_5;
            let _e34 = fade_5;
            fade_5 = (_e30 * (_e31 * (3f - (2f * _e34))));
            let _e39 = fade_5;
            fall_1 = (_e39 * exp((-4.934802f * variance)));
        }
    }
    let _e45 = offset_1;
    let _e47 = fade_5;
    let _e49 = fall_1;
    let _e54 = fall_1;
    return vec4<f32>(_e45, (0.5f * _e47), (_e49 * (node.x - 0.5f)), (_e54 * node.z));
}

fn gabor_impl_nodes(cell: i32, local: f32, period: i32, salt: u32, variance: f32) -> GaborAxis {
    var axis_3: GaborAxis;
    let _e10 = gabor_impl_axis(cell, local, period, salt, 0f, 1.5f);
    axis_3 = _e10;
    let _e15 = axis_3;
    let _e22 = axis_3.node[0];
    let _e23 = gabor_impl_node((_e15.offset + 1f), _e22, variance);
    axis_3.node[0i] = _e23;
    let _e27 = axis_3;
    let _e32 = axis_3.node[1];
    let _e33 = gabor_impl_node(_e27.offset, _e32, variance);
    axis_3.node[1i] = _e33;
    let _e37 = axis_3;
    let _e44 = axis_3.node[2];
    let _e45 = gabor_impl_node((_e37.offset - 1f), _e44, variance);
    axis_3.node[2i] = _e45;
    let _e46 = axis_3;
    return _e46;
}

// The sum over 27 nodes, without the factor K.
fn gabor_impl_sum_isotropic(place: GaborPlace3d, pixel: GaborMatrix, scale: vec3<f32>, tangents: GaborTangents, salt: u32) -> GaborField3d {
    var s_8: vec3<f32>;
    var x_19: GaborAxis;
    var y_14: GaborAxis;
    var z_7: GaborAxis;
    var sum_23: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var i_8: i32 = 0i;
    var j_6: i32;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var y_j: vec4<f32>;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var z_k: vec4<f32>;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var word_7: u32;
    var row_8: vec4<u32>;
    s_8 = pixel.diagonal;
    let _e13 = s_8;
    let _e15 = gabor_impl_nodes(place.cell.x, place.local.x, place.period.x, salt, _e13.x);
    x_19 = _e15;
    let _e25 = s_8;
    let _e27 = gabor_impl_nodes(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), _e25.y);
    y_14 = _e27;
    let _e37 = s_8;
    let _e39 = gabor_impl_nodes(place.cell.z, place.local.z, place.period.z, (salt ^ 668265263u), _e37.z);
    z_7 = _e39;
    loop {
        let _e52 = i_8;
        if !((_e52 < 9i)) {
            break;
        }
        {
            let _e59 = i_8;
            j_6 = (_e59 % 3i);
            let _e63 = j_6;
            if (_e63 == 0i) {
                let _e69 = y_14.node[0];
                local_41 = _e69;
            } else {
                let _e70 = j_6;
                if (_e70 == 1i) {
                    let _e76 = y_14.node[1];
                    local_40 = _e76;
                } else {
                    let _e80 = y_14.node[2];
                    local_40 = _e80;
                }
                let _e82 = local_40;
                local_41 = _e82;
            }
            let _e84 = local_41;
            y_j = _e84;
            let _e86 = i_8;
            if (_e86 < 3i) {
                let _e92 = z_7.node[0];
                local_43 = _e92;
            } else {
                let _e93 = i_8;
                if (_e93 < 6i) {
                    let _e99 = z_7.node[1];
                    local_42 = _e99;
                } else {
                    let _e103 = z_7.node[2];
                    local_42 = _e103;
                }
                let _e105 = local_42;
                local_43 = _e105;
            }
            let _e107 = local_43;
            z_k = _e107;
            let _e109 = j_6;
            if (_e109 == 0i) {
                let _e115 = y_14.word[0];
                local_45 = _e115;
            } else {
                let _e116 = j_6;
                if (_e116 == 1i) {
                    let _e122 = y_14.word[1];
                    local_44 = _e122;
                } else {
                    let _e126 = y_14.word[2];
                    local_44 = _e126;
                }
                let _e128 = local_44;
                local_45 = _e128;
            }
            let _e130 = local_45;
            let _e131 = i_8;
            if (_e131 < 3i) {
                let _e137 = z_7.word[0];
                local_47 = _e137;
            } else {
                let _e138 = i_8;
                if (_e138 < 6i) {
                    let _e144 = z_7.word[1];
                    local_46 = _e144;
                } else {
                    let _e148 = z_7.word[2];
                    local_46 = _e148;
                }
                let _e150 = local_46;
                local_47 = _e150;
            }
            let _e152 = local_47;
            word_7 = (_e130 * _e152);
            let _e155 = word_7;
            let _e156 = gabor_impl_row(_e155);
            row_8 = _e156;
            let _e162 = x_19.node[0];
            let _e163 = y_j;
            let _e164 = z_k;
            let _e168 = x_19.word[0];
            let _e169 = row_8;
            gabor_impl_add_node_waves_3d((&sum_23), _e162, _e163, _e164, place, pixel, scale, tangents, _e168, _e169);
            let _e175 = x_19.node[1];
            let _e176 = y_j;
            let _e177 = z_k;
            let _e181 = x_19.word[1];
            let _e182 = row_8;
            gabor_impl_add_node_waves_3d((&sum_23), _e175, _e176, _e177, place, pixel, scale, tangents, _e181, _e182);
            let _e188 = x_19.node[2];
            let _e189 = y_j;
            let _e190 = z_k;
            let _e194 = x_19.word[2];
            let _e195 = row_8;
            gabor_impl_add_node_waves_3d((&sum_23), _e188, _e189, _e190, place, pixel, scale, tangents, _e194, _e195);
        }
        continuing {
            let _e56 = i_8;
            i_8 = (_e56 + 1i);
        }
    }
    let _e197 = sum_23;
    return _e197;
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
fn gabor_impl_transmitted_isotropic(frequency: f32, pixel: GaborPixelAxes, tangents: GaborTangents) -> f32 {
    var d_8: vec2<f32>;
    var unit_5: vec2<f32>;
    var mean_2: f32;
    var a_8: vec2<f32>;
    var b_9: vec2<f32>;
    var sum_24: f32;
    var apart_2: f32;
    var q_2: vec2<f32>;
    var larger_1: f32;
    var smaller_2: f32;
    let _e3 = gabor_impl_spread(pixel);
    d_8 = _e3;
    let _e10 = d_8;
    unit_5 = (vec2(min(((9.869604f * frequency) * frequency), 1000000f)) / _e10);
    if tangents.only {
        {
            a_8 = vec2<f32>(dot(tangents.along, pixel.major), dot(tangents.along, pixel.minor));
            b_9 = vec2<f32>(dot(tangents.across, pixel.major), dot(tangents.across, pixel.minor));
            let _e32 = unit_5;
            let _e33 = a_8;
            let _e34 = a_8;
            let _e36 = b_9;
            let _e37 = b_9;
            sum_24 = dot(_e32, ((_e33 * _e34) + (_e36 * _e37)));
            let _e42 = unit_5;
            let _e43 = a_8;
            let _e44 = a_8;
            let _e46 = b_9;
            let _e47 = b_9;
            let _e52 = unit_5;
            let _e53 = a_8;
            let _e54 = b_9;
            apart_2 = length(vec2<f32>(dot(_e42, ((_e43 * _e44) - (_e46 * _e47))), (2f * dot(_e52, (_e53 * _e54)))));
            let _e62 = apart_2;
            let _e63 = sum_24;
            let _e69 = apart_2;
            let _e70 = gabor_impl_mean_angle(_e69);
            mean_2 = (exp(min((0.5f * (_e62 - _e63)), 0f)) * _e70);
        }
    } else {
        {
            let _e72 = unit_5;
            q_2 = (_e72 * vec2<f32>(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor)));
            let _e82 = q_2;
            let _e84 = q_2;
            larger_1 = max(_e82.x, _e84.y);
            let _e88 = q_2;
            let _e90 = q_2;
            smaller_2 = min(_e88.x, _e90.y);
            let _e95 = larger_1;
            let _e98 = larger_1;
            let _e104 = larger_1;
            let _e106 = larger_1;
            let _e109 = larger_1;
            mean_2 = sqrt(((1f + (_e95 * (0.31500545f + (0.08868891f * _e98)))) / (1f + (_e104 * (0.9816721f + (_e106 * (0.42128292f + (0.11292425f * _e109))))))));
            let _e118 = mean_2;
            let _e119 = smaller_2;
            let _e124 = larger_1;
            let _e130 = gabor_impl_mean_angle((_e119 * (1f - (1f / (3f + (0.8f * _e124))))));
            mean_2 = (_e118 * _e130);
        }
    }
    let _e132 = mean_2;
    let _e133 = d_8;
    let _e135 = d_8;
    return (_e132 * inverseSqrt((_e133.x * _e135.y)));
}

fn gabor_impl_isotropic(place: GaborPlace3d, frequency: f32, tangents: GaborTangents, seed: u32) -> GaborField3d {
    var frequency_31: f32;
    var stretch_6: vec3<f32>;
    var local_48: f32;
    var local_49: f32;
    var local_50: f32;
    var amplitude_6: f32;
    var transmitted_2: f32 = 1f;
    var pixel_14: GaborMatrix = GaborMatrix(vec3(0f), vec3(0f));
    var whole_1: GaborPixelAxes;
    var resolved_1: GaborPixelAxes;
    var sum_25: GaborField3d;
    frequency_31 = frequency;
    stretch_6 = (place.radius / vec3(1.5f));
    let _e13 = frequency_31;
    frequency_31 = min(abs(_e13), 1000000f);
    if tangents.only {
        local_48 = 2f;
    } else {
        local_48 = 3f;
    }
    let _e21 = local_48;
    if false {
        local_49 = 1f;
    } else {
        local_49 = 1.125f;
    }
    let _e31 = local_49;
    if false {
        local_50 = 1f;
    } else {
        local_50 = 1.125f;
    }
    let _e44 = local_50;
    amplitude_6 = (inverseSqrt((_e21 * _e31)) / (1459955300000000000000000000f * _e44));
    if place.filtered {
        {
            let _e59 = gabor_impl_pixel(place, vec3(1f));
            whole_1 = _e59;
            let _e61 = whole_1;
            let _e63 = gabor_impl_resolved(_e61, 0.5f);
            resolved_1 = _e63;
            let _e65 = frequency_31;
            let _e66 = whole_1;
            let _e67 = gabor_impl_transmitted_isotropic(_e65, _e66, tangents);
            transmitted_2 = _e67;
            let _e68 = amplitude_6;
            let _e69 = transmitted_2;
            let _e70 = frequency_31;
            let _e71 = resolved_1;
            let _e72 = gabor_impl_transmitted_isotropic(_e70, _e71, tangents);
            amplitude_6 = (_e68 * sqrt((_e69 / _e72)));
            let _e76 = resolved_1;
            let _e78 = stretch_6;
            let _e80 = resolved_1;
            let _e82 = stretch_6;
            let _e85 = gabor_impl_covariance(GaborPixelAxes((_e76.major * _e78), (_e80.minor * _e82)));
            pixel_14 = _e85;
            let _e86 = transmitted_2;
            if !((_e86 > 0.0000000001f)) {
                transmitted_2 = 0f;
            }
        }
    }
    let _e98 = transmitted_2;
    sum_25 = GaborField3d(0f, vec3(0f), 0f, vec3(0f), (1f - _e98));
    let _e102 = transmitted_2;
    if (_e102 > 0f) {
        let _e106 = pixel_14;
        let _e107 = frequency_31;
        let _e108 = stretch_6;
        let _e111 = gabor_impl_salt(seed);
        let _e112 = gabor_impl_sum_isotropic(place, _e106, (vec3(_e107) / _e108), tangents, _e111);
        let _e113 = amplitude_6;
        let _e114 = stretch_6;
        gabor_impl_add_field_3d((&sum_25), _e112, _e113, _e114);
    }
    let _e116 = sum_25;
    return _e116;
}

fn gabor_field_3d_isotropic(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d {
    let _e13 = gabor_impl_isotropic(place, frequency, GaborTangents(false, vec3<f32>(1f, 0f, 0f), vec3<f32>(0f, 1f, 0f)), seed);
    return _e13;
}

// Directions in the tangent plane are measured from the circle of latitude around the z axis or, where the normal is
// near that axis, around the x axis.
fn gabor_field_surface_isotropic(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_3: vec3<f32>;
    var aside: f32;
    var sum_26: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_51: i32;
    var i_9: i32;
    var local_52: i32;
    var local_53: vec3<f32>;
    var along_1: vec3<f32>;
    var term_1: GaborField3d;
    var local_54: f32;
    normal_3 = normal;
    let _e5 = normal_3;
    let _e6 = gabor_impl_unit(_e5);
    normal_3 = _e6;
    let _e7 = normal_3;
    let _e9 = normal_3;
    aside = dot(_e7.xy, _e9.xy);
    let _e22 = aside;
    if (_e22 > 0.25f) {
        local_51 = 0i;
    } else {
        local_51 = 1i;
    }
    let _e28 = local_51;
    i_9 = _e28;
    loop {
        let _e30 = i_9;
        let _e31 = aside;
        if (_e31 < 0.5f) {
            local_52 = 2i;
        } else {
            local_52 = 1i;
        }
        let _e37 = local_52;
        if !((_e30 < _e37)) {
            break;
        }
        {
            let _e43 = i_9;
            if (_e43 == 0i) {
                local_53 = vec3<f32>(0f, 0f, 1f);
            } else {
                local_53 = vec3<f32>(1f, 0f, 0f);
            }
            let _e55 = local_53;
            let _e56 = normal_3;
            let _e58 = gabor_impl_unit(cross(_e55, _e56));
            along_1 = _e58;
            let _e61 = along_1;
            let _e62 = normal_3;
            let _e63 = along_1;
            let _e66 = i_9;
            let _e67 = gabor_lobe_seed(seed, _e66);
            let _e68 = gabor_impl_isotropic(place, frequency, GaborTangents(true, _e61, cross(_e62, _e63)), _e67);
            term_1 = _e68;
            let _e71 = term_1;
            let _e72 = i_9;
            if (_e72 == 0i) {
                let _e77 = aside;
                local_54 = smoothstep(0.25f, 0.5f, _e77);
            } else {
                let _e83 = aside;
                local_54 = smoothstep(-0.5f, -0.25f, -(_e83));
            }
            let _e87 = local_54;
            gabor_impl_add_share_3d((&sum_26), _e71, _e87);
        }
        continuing {
            let _e40 = i_9;
            i_9 = (_e40 + 1i);
        }
    }
    let _e89 = sum_26;
    return _e89;
}

// ---- Functions of a position ---------------------------------------------------------------------------------------

fn gabor_noise_3d(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    return _e12.noise;
}

fn gabor_noise_3d_gradient(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec4<f32> {
    var field_15: GaborField3d;
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    field_15 = _e12;
    let _e14 = field_15;
    let _e16 = field_15;
    return vec4<f32>(_e14.noise, _e16.gradient.x, _e16.gradient.y, _e16.gradient.z);
}

fn gabor_noise_3d_complex(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var field_16: GaborField3d;
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    field_16 = _e12;
    let _e14 = field_16;
    let _e16 = field_16;
    return vec2<f32>(_e14.quadrature, _e16.noise);
}

fn gabor_noise_3d_four(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec4<f32> {
    let _e4 = gabor_noise_3d(p, frequency, direction, seed);
    let _e7 = gabor_lobe_seed(seed, -1i);
    let _e8 = gabor_noise_3d(p, frequency, direction, _e7);
    let _e11 = gabor_lobe_seed(seed, -2i);
    let _e12 = gabor_noise_3d(p, frequency, direction, _e11);
    let _e15 = gabor_lobe_seed(seed, -3i);
    let _e16 = gabor_noise_3d(p, frequency, direction, _e15);
    return vec4<f32>(_e4, _e8, _e12, _e16);
}

fn gabor_noise_3d_tiled(p: vec3<f32>, period: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var period_12: vec3<f32>;
    var nodes_1: vec3<f32>;
    var place_35: GaborPlace3d;
    period_12 = period;
    let _e6 = period_12;
    period_12 = clamp(_e6, vec3(0.0009765625f), vec3(1000000000f));
    let _e12 = period_12;
    nodes_1 = max(floor(((_e12 * 1.5f) + vec3(0.5f))), vec3(3f));
    let _e28 = period_12;
    let _e31 = period_12;
    let _e34 = nodes_1;
    let _e35 = period_12;
    let _e38 = gabor_place_3d(vec3(0i), ((p - (floor((p / _e28)) * _e31)) * (_e34 / _e35)));
    place_35 = _e38;
    let _e41 = nodes_1;
    let _e42 = period_12;
    place_35.radius = (_e41 / _e42);
    let _e45 = nodes_1;
    place_35.period = vec3<i32>(_e45);
    let _e47 = place_35;
    let _e48 = gabor_field_3d(_e47, frequency, direction, seed);
    return _e48.noise;
}

fn gabor_noise_3d_animated(p: vec3<f32>, moment: f32, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var place_36: GaborPlace3d;
    let _e12 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_36 = _e12;
    place_36.animated = true;
    place_36.moment = moment;
    let _e17 = place_36;
    let _e18 = gabor_field_3d(_e17, frequency, direction, seed);
    return _e18.noise;
}

fn gabor_impl_place_of_pixel(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(vec3(0i), (p * 1.5f), vec3(1.5f), vec3(0i), false, 0f, true, dx, dy);
}

fn gabor_noise_3d_filtered(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var field_17: GaborField3d;
    let _e6 = gabor_impl_place_of_pixel(p, dx, dy);
    let _e7 = gabor_field_3d(_e6, frequency, direction, seed);
    field_17 = _e7;
    let _e9 = field_17;
    let _e11 = field_17;
    return vec2<f32>(_e9.noise, _e11.removed);
}

fn gabor_noise_3d_isotropic(p: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e10 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e11 = gabor_field_3d_isotropic(_e10, frequency, seed);
    return _e11.noise;
}

fn gabor_noise_3d_isotropic_gradient(p: vec3<f32>, frequency: f32, seed: u32) -> vec4<f32> {
    var field_18: GaborField3d;
    let _e10 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e11 = gabor_field_3d_isotropic(_e10, frequency, seed);
    field_18 = _e11;
    let _e13 = field_18;
    let _e15 = field_18;
    return vec4<f32>(_e13.noise, _e15.gradient.x, _e15.gradient.y, _e15.gradient.z);
}

fn gabor_noise_3d_isotropic_filtered(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, seed: u32) -> vec2<f32> {
    var field_19: GaborField3d;
    let _e5 = gabor_impl_place_of_pixel(p, dx, dy);
    let _e6 = gabor_field_3d_isotropic(_e5, frequency, seed);
    field_19 = _e6;
    let _e8 = field_19;
    let _e10 = field_19;
    return vec2<f32>(_e8.noise, _e10.removed);
}

fn gabor_noise_surface(p: vec3<f32>, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e12 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e13 = gabor_field_surface(_e12, normal, frequency, direction, seed);
    return _e13.noise;
}

fn gabor_noise_surface_isotropic(p: vec3<f32>, normal: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_surface_isotropic(_e11, normal, frequency, seed);
    return _e12.noise;
}

