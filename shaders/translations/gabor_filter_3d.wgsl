// Generated from gabor_filter_3d.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 5f76e4b92d577ab5.
// Paste it after gabor_noise.wgsl, gabor_spectrum.wgsl, gabor_filter.wgsl, gabor_noise_3d.wgsl.
//
// gabor_filter_3d.wgsl: the noises of gabor_noise_3d.wgsl, averaged over a pixel.
//
// Paste or include this file after gabor_noise.wgsl, gabor_filter.wgsl and gabor_noise_3d.wgsl.
//
//     GaborField3d f = gabor_field_3d_isotropic_filtered(gabor_place_3d_at(p), dpdx(p), dpdy(p), 2.0, 7u);
//
// dx and dy are the change of p, in kernel radii, from one pixel to the next along x and y; a field's `removed` is the
// share of the variance that averaging removed: see gabor_filter.wgsl.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// GaborField3d gabor_field_3d_filtered(GaborPlace3d place, vec3f dx, vec3f dy, vec3f wave, u32 seed)
// GaborField3d gabor_field_surface_filtered(GaborPlace3d place, vec3f dx, vec3f dy, vec3f normal, f32 frequency,
//                                           vec3f direction, u32 seed)
//     The error is that of gabor_field_filtered: 1 % as long as the pixel's longest axis is at most a third of a kernel
//     radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a call costs 1.4 times as
//     much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2 (64 nodes), and at most
//     6.6 times (125 nodes).

// GaborField3d gabor_field_3d_isotropic_filtered(GaborPlace3d place, vec3f dx, vec3f dy, f32 frequency, u32 seed)
// GaborField3d gabor_field_surface_isotropic_filtered(GaborPlace3d place, vec3f dx, vec3f dy, vec3f normal, f32 frequency,
//                                                     u32 seed)
//     They cost less than twice as much as without the filter. The rms error against exactly filtered noise is 2 % of a
//     standard deviation as long as the pixel's longest axis is at most 0.3 kernel radii, and 3 % at 0.4. For larger
//     pixels, only the variance is right.

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
struct GaborMatrix {
    diagonal: vec3<f32>,
    mixed: vec3<f32>, // yz, zx, xy
}

fn gabor_impl_symmetric_3d(m: GaborMatrix, v: vec3<f32>) -> vec3<f32> {
    return (((m.diagonal * v) + (m.mixed.zxy * v.yzx)) + (m.mixed.yzx * v.zxy));
}

// The inverse times the determinant.
fn gabor_impl_adjugate(m: GaborMatrix, determinant_: ptr<function, f32>) -> GaborMatrix {
    var a_8: GaborMatrix;
    a_8 = GaborMatrix(((m.diagonal.yzx * m.diagonal.zxy) - (m.mixed * m.mixed)), ((m.mixed.yzx * m.mixed.zxy) - (m.diagonal * m.mixed)));
    let _e24 = a_8;
    let _e30 = a_8;
    let _e37 = a_8;
    (*determinant_) = (((m.diagonal.x * _e24.diagonal.x) + (m.mixed.y * _e30.mixed.y)) + (m.mixed.z * _e37.mixed.z));
    let _e42 = a_8;
    return _e42;
}

// The multiplier of each factor along z. y_0, y_1 and y_2 are the factors along y, and their components are the factors
// along x. `w` is the coupling of y and z, z and x, x and y.
fn gabor_impl_along_z(y_0: vec3<f32>, y_1: vec3<f32>, y_2: vec3<f32>, w: vec3<f32>) -> vec3<f32> {
    return vec3<f32>((y_0.x + (w.z * (y_1.y + ((0.5f * w.z) * y_2.z)))), ((w.y * (y_0.y + (w.z * y_1.z))) + (w.x * (y_1.x + (w.z * y_2.y)))), ((0.5f * (((w.y * w.y) * y_0.z) + ((w.x * w.x) * y_2.x))) + ((w.x * w.y) * (y_1.y + (w.z * y_2.z)))));
}

// The weighted sum of the products of three axes' factors.
fn gabor_impl_contracted_3d(y_0: GaborFactors, y_1: GaborFactors, y_2: GaborFactors, z: GaborFactors, w: vec3<f32>) -> vec2<f32> {
    var slice_2: GaborFactors;
    let _e8 = gabor_impl_along_z(y_0.real, y_1.real, y_2.real, w);
    let _e12 = gabor_impl_along_z(y_0.imaginary, y_1.imaginary, y_2.imaginary, w);
    slice_2 = GaborFactors(_e8, _e12);
    let _e15 = slice_2;
    let _e18 = gabor_impl_contracted(_e15, z, vec3(1f));
    return _e18;
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
fn gabor_impl_filtered_wide_3d(place: GaborPlace3d, wave: vec3<f32>, s: GaborMatrix, wanted: bool, salt: u32) -> GaborField3d {
    var determinant_1: f32;
    var m_4: GaborMatrix;
    var adjugate: GaborMatrix;
    var blurred_3: vec3<f32>;
    var c_6: vec3<f32>;
    var d_8: vec3<f32>;
    var pairs: vec3<f32>;
    var w_3: vec3<f32>;
    var x_17: GaborFilteredAxis;
    var y_15: GaborFilteredAxis;
    var z_8: GaborFilteredAxis;
    var columns_5: GaborColumns;
    var first_3: GaborFilteredLine;
    var slice_3: GaborFilteredLine;
    var none_1: GaborFactors = GaborFactors(vec3(0f), vec3(0f));
    var local_43: i32;
    var rows_3: i32;
    var local_44: i32;
    var slices: i32;
    var value_11: vec2<f32> = vec2(0f);
    var next_x_1: vec2<f32> = vec2(0f);
    var next_y_1: vec2<f32> = vec2(0f);
    var next_z: vec2<f32> = vec2(0f);
    var k_2: i32 = 0i;
    var y_0_2: GaborFactors;
    var y_1_2: GaborFactors;
    var y_2_2: GaborFactors;
    var row_9: GaborFilteredLine;
    var j_6: i32;
    var edge_3: GaborFactors;
    var sum_26: GaborFactors;
    var window_5: GaborFactors;
    var along_z: GaborFactors;
    var real_3: vec3<f32>;
    var imaginary_3: vec3<f32>;
    var quarter_1: vec3<f32>;
    var exponent_2: f32;
    var local_45: f32;
    var scale_3: f32;
    var local_46: f32;
    m_4 = GaborMatrix((s.diagonal + vec3(0.13069098f)), s.mixed);
    let _e13 = m_4;
    let _e16 = gabor_impl_adjugate(_e13, (&determinant_1));
    adjugate = _e16;
    let _e18 = gabor_impl_symmetric_3d(s, wave);
    blurred_3 = _e18;
    let _e20 = adjugate;
    let _e21 = blurred_3;
    let _e22 = gabor_impl_symmetric_3d(_e20, _e21);
    let _e23 = determinant_1;
    c_6 = (_e22 / vec3(-(_e23)));
    let _e28 = m_4;
    let _e30 = determinant_1;
    let _e32 = adjugate;
    d_8 = sqrt(((_e28.diagonal * _e30) / _e32.diagonal));
    let _e37 = d_8;
    let _e39 = d_8;
    pairs = sqrt((_e37.yzx * _e39.zxy));
    let _e45 = m_4;
    let _e47 = d_8;
    let _e52 = pairs;
    let _e57 = gabor_impl_adjugate(GaborMatrix((vec3(1f) + (_e45.diagonal / _e47)), (s.mixed / _e52)), (&determinant_1));
    adjugate = _e57;
    let _e59 = determinant_1;
    let _e61 = pairs;
    let _e63 = adjugate;
    w_3 = (((157.91367f / _e59) * _e61) * _e63.mixed);
    let _e70 = d_8;
    let _e72 = c_6;
    let _e86 = gabor_impl_wave((wave.x / 1.5f));
    let _e87 = gabor_impl_filtered_axis(sqrt(s.diagonal.x), _e70.x, _e72.x, place.cell.x, place.local.x, place.period.x, salt, _e86);
    x_17 = _e87;
    let _e92 = d_8;
    let _e94 = c_6;
    let _e110 = gabor_impl_wave((wave.y / 1.5f));
    let _e111 = gabor_impl_filtered_axis(sqrt(s.diagonal.y), _e92.y, _e94.y, place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), _e110);
    y_15 = _e111;
    let _e116 = d_8;
    let _e118 = c_6;
    let _e134 = gabor_impl_wave((wave.z / 1.5f));
    let _e135 = gabor_impl_filtered_axis(sqrt(s.diagonal.z), _e116.z, _e118.z, place.cell.z, place.local.z, place.period.z, (salt ^ 668265263u), _e134);
    z_8 = _e135;
    let _e137 = x_17;
    let _e138 = gabor_impl_columns(_e137);
    columns_5 = _e138;
    let _e140 = y_15;
    let _e141 = y_15;
    let _e144 = y_15;
    let _e149 = gabor_impl_line_before(_e140, vec2<f32>(_e141.back.x, -(_e144.back.y)));
    first_3 = _e149;
    let _e151 = z_8;
    let _e152 = x_17;
    let _e154 = y_15;
    let _e156 = z_8;
    let _e167 = gabor_impl_wave((dot(wave, vec3<f32>(_e152.offset, _e154.offset, (_e156.offset + 1f))) / 1.5f));
    let _e168 = gabor_impl_line_before(_e151, _e167);
    slice_3 = _e168;
    if wanted {
        let _e176 = y_15;
        local_43 = _e176.count;
    } else {
        local_43 = 0i;
    }
    let _e180 = local_43;
    rows_3 = _e180;
    if wanted {
        let _e182 = z_8;
        local_44 = _e182.count;
    } else {
        local_44 = 0i;
    }
    let _e186 = local_44;
    slices = _e186;
    loop {
        {
            let _e202 = slice_3;
            let _e203 = z_8;
            let _e204 = k_2;
            let _e205 = z_8;
            let _e206 = k_2;
            let _e207 = gabor_impl_fade(_e205, _e206);
            let _e208 = gabor_impl_next_line(_e202, _e203, _e204, _e207);
            slice_3 = _e208;
            let _e209 = none_1;
            y_0_2 = _e209;
            let _e211 = none_1;
            y_1_2 = _e211;
            let _e213 = none_1;
            y_2_2 = _e213;
            let _e215 = first_3;
            row_9 = _e215;
            j_6 = 0i;
            loop {
                {
                    let _e219 = row_9;
                    let _e220 = y_15;
                    let _e221 = j_6;
                    let _e222 = y_15;
                    let _e223 = j_6;
                    let _e224 = gabor_impl_fade(_e222, _e223);
                    let _e225 = gabor_impl_next_line(_e219, _e220, _e221, _e224);
                    row_9 = _e225;
                    edge_3 = GaborFactors(vec3(0f), vec3(0f));
                    let _e232 = columns_5;
                    let _e233 = row_9;
                    let _e235 = slice_3;
                    let _e237 = gabor_impl_slice_word(_e233.word, _e235.word);
                    let _e241 = gabor_impl_filtered_row(_e232, _e237, place.evolution, (&edge_3));
                    sum_26 = _e241;
                    let _e243 = row_9;
                    let _e244 = gabor_impl_faded(_e243);
                    window_5 = _e244;
                    let _e246 = y_0_2;
                    let _e247 = sum_26;
                    let _e248 = window_5;
                    let _e251 = window_5;
                    let _e254 = gabor_impl_plus_product(_e246, _e247, _e248.real.x, _e251.imaginary.x);
                    y_0_2 = _e254;
                    let _e255 = y_1_2;
                    let _e256 = sum_26;
                    let _e257 = window_5;
                    let _e260 = window_5;
                    let _e263 = gabor_impl_plus_product(_e255, _e256, _e257.real.y, _e260.imaginary.y);
                    y_1_2 = _e263;
                    let _e264 = y_2_2;
                    let _e265 = sum_26;
                    let _e266 = window_5;
                    let _e269 = window_5;
                    let _e272 = gabor_impl_plus_product(_e264, _e265, _e266.real.z, _e269.imaginary.z);
                    y_2_2 = _e272;
                }
                let _e273 = j_6;
                let _e275 = (_e273 + 1i);
                j_6 = _e275;
                let _e276 = rows_3;
                if !((_e275 < _e276)) {
                    break;
                }
            }
            let _e279 = slice_3;
            let _e280 = gabor_impl_faded(_e279);
            along_z = _e280;
            let _e282 = value_11;
            let _e283 = y_0_2;
            let _e284 = y_1_2;
            let _e285 = y_2_2;
            let _e286 = along_z;
            let _e287 = w_3;
            let _e288 = gabor_impl_contracted_3d(_e283, _e284, _e285, _e286, _e287);
            value_11 = (_e282 + _e288);
            let _e290 = next_x_1;
            let _e291 = y_0_2;
            let _e292 = gabor_impl_next(_e291);
            let _e293 = y_1_2;
            let _e294 = gabor_impl_next(_e293);
            let _e295 = y_2_2;
            let _e296 = gabor_impl_next(_e295);
            let _e297 = along_z;
            let _e298 = w_3;
            let _e299 = gabor_impl_contracted_3d(_e292, _e294, _e296, _e297, _e298);
            next_x_1 = (_e290 + _e299);
            let _e301 = next_y_1;
            let _e302 = y_1_2;
            let _e303 = y_2_2;
            let _e304 = none_1;
            let _e305 = along_z;
            let _e306 = w_3;
            let _e307 = gabor_impl_contracted_3d(_e302, _e303, _e304, _e305, _e306);
            next_y_1 = (_e301 + _e307);
            let _e309 = next_z;
            let _e310 = y_0_2;
            let _e311 = y_1_2;
            let _e312 = y_2_2;
            let _e313 = along_z;
            let _e314 = gabor_impl_next(_e313);
            let _e315 = w_3;
            let _e316 = gabor_impl_contracted_3d(_e310, _e311, _e312, _e314, _e315);
            next_z = (_e309 + _e316);
        }
        let _e318 = k_2;
        let _e320 = (_e318 + 1i);
        k_2 = _e320;
        let _e321 = slices;
        if !((_e320 < _e321)) {
            break;
        }
    }
    let _e324 = next_x_1;
    let _e326 = next_y_1;
    let _e328 = next_z;
    real_3 = vec3<f32>(_e324.x, _e326.x, _e328.x);
    let _e332 = next_x_1;
    let _e334 = next_y_1;
    let _e336 = next_z;
    imaginary_3 = vec3<f32>(_e332.y, _e334.y, _e336.y);
    let _e341 = d_8;
    quarter_1 = (vec3(0.012665148f) / _e341);
    let _e345 = real_3;
    let _e346 = c_6;
    let _e348 = value_11;
    let _e351 = quarter_1;
    let _e354 = w_3;
    let _e356 = real_3;
    let _e357 = gabor_impl_symmetric_3d(GaborMatrix(vec3(0f), _e354), _e356);
    real_3 = (_e345 + (((wave + _e346) * _e348.x) + (_e351 * _e357)));
    let _e361 = imaginary_3;
    let _e362 = c_6;
    let _e364 = value_11;
    let _e367 = quarter_1;
    let _e370 = w_3;
    let _e372 = imaginary_3;
    let _e373 = gabor_impl_symmetric_3d(GaborMatrix(vec3(0f), _e370), _e372);
    imaginary_3 = (_e361 + (((wave + _e362) * _e364.y) + (_e367 * _e373)));
    let _e378 = c_6;
    let _e380 = blurred_3;
    let _e382 = d_8;
    let _e383 = c_6;
    let _e384 = c_6;
    exponent_2 = (19.739208f * (dot((wave + _e378), _e380) + dot(_e382, (_e383 * _e384))));
    let _e391 = determinant_1;
    if false {
        local_45 = 1f;
    } else {
        local_45 = 1.125f;
    }
    let _e402 = local_45;
    let _e405 = exponent_2;
    scale_3 = (sqrt(((8f / _e391) / _e402)) * exp(-(_e405)));
    let _e410 = scale_3;
    if false {
        local_46 = 1f;
    } else {
        local_46 = 1.125f;
    }
    let _e421 = local_46;
    scale_3 = (_e410 / (1459955300000000000000000000f * _e421));
    let _e424 = scale_3;
    let _e425 = value_11;
    let _e429 = scale_3;
    let _e431 = real_3;
    let _e433 = scale_3;
    let _e434 = value_11;
    let _e439 = scale_3;
    let _e441 = imaginary_3;
    return GaborField3d((_e424 * _e425.y), ((6.2831855f * _e429) * _e431), (_e433 * _e434.x), ((-6.2831855f * _e439) * _e441), 0f);
}
// ---- One wave vector -----------------------------------------------------------------------------------------------

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_CELLS_PER_RADIUS node spacings.
struct GaborPixelAxes {
    major: vec3<f32>,
    minor: vec3<f32>,
}

fn gabor_impl_pixel(dx: vec3<f32>, dy: vec3<f32>, stretch: vec3<f32>) -> GaborPixelAxes {
    var dx_7: vec3<f32>;
    var dy_7: vec3<f32>;
    var twice_2: vec2<f32>;
    var cosine_1: f32;
    var turn_14: vec2<f32>;
    dx_7 = dx;
    dy_7 = dy;
    let _e5 = dx_7;
    dx_7 = (clamp(_e5, vec3(-1000000f), vec3(1000000f)) * stretch);
    let _e13 = dy_7;
    dy_7 = (clamp(_e13, vec3(-1000000f), vec3(1000000f)) * stretch);
    let _e21 = dx_7;
    let _e22 = dx_7;
    let _e24 = dy_7;
    let _e25 = dy_7;
    let _e29 = dx_7;
    let _e30 = dy_7;
    twice_2 = vec2<f32>((dot(_e21, _e22) - dot(_e24, _e25)), (2f * dot(_e29, _e30)));
    let _e35 = twice_2;
    let _e37 = twice_2;
    cosine_1 = (_e35.x / max(length(_e37), 0.000000000000000000000000000001f));
    let _e48 = cosine_1;
    turn_14 = sqrt(max((vec2(0.5f) + (vec2<f32>(0.5f, -0.5f) * _e48)), vec2(0f)));
    let _e57 = twice_2;
    if (_e57.y < 0f) {
        let _e62 = turn_14;
        turn_14.y = -(_e62.y);
    }
    let _e65 = turn_14;
    let _e67 = dx_7;
    let _e69 = turn_14;
    let _e71 = dy_7;
    let _e74 = turn_14;
    let _e76 = dy_7;
    let _e78 = turn_14;
    let _e80 = dx_7;
    return GaborPixelAxes(((_e65.x * _e67) + (_e69.y * _e71)), ((_e74.x * _e76) - (_e78.y * _e80)));
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
    var d_9: vec2<f32>;
    var k_3: vec2<f32>;
    let _e2 = gabor_impl_spread(pixel);
    d_9 = _e2;
    k_3 = vec2<f32>(dot(wave, pixel.major), dot(wave, pixel.minor));
    let _e11 = k_3;
    let _e12 = k_3;
    let _e15 = d_9;
    let _e24 = d_9;
    let _e26 = d_9;
    return (exp(-(min((9.869604f * dot((_e11 * _e12), (vec2(1f) / _e15))), 80f))) * inverseSqrt((_e24.x * _e26.y)));
}

// Adds slice 0, as gabor_impl_add_slice does. The filter adds mixed derivatives, weighted by its covariances yz, zx, xy.
fn gabor_impl_add_filtered_slice(sum: ptr<function, vec4<f32>>, slopes: ptr<function, vec4<f32>>, x: GaborAxis, y: GaborAxis, z: GaborAxis, mixed: vec3<f32>, evolution: f32) {
    var slice_4: vec4<f32>;
    var slope_11: vec4<f32>;
    gabor_impl_sum_slice(x, y, z, 0i, evolution, (&slice_4), (&slope_11));
    let _e15 = slice_4;
    gabor_impl_add_products(sum, _e15, z.node[0].xy);
    let _e21 = (*slopes);
    let _e22 = slope_11;
    let _e28 = gabor_impl_product(_e22.xy, z.node[0].xy);
    let _e29 = slice_4;
    let _e35 = gabor_impl_product(_e29.xy, z.node[0].zw);
    (*slopes) = (_e21 + vec4<f32>(_e28.x, _e28.y, _e35.x, _e35.y));
    let _e42 = (*sum);
    let _e44 = slope_11;
    let _e48 = slice_4;
    let _e56 = gabor_impl_product(((mixed.x * _e44.xy) + (mixed.y * _e48.zw)), z.node[0].zw);
    let _e58 = slope_11;
    let _e64 = gabor_impl_product(_e58.zw, z.node[0].xy);
    let _e66 = (_e56 + (mixed.z * _e64));
    (*sum) = (_e42 + vec4<f32>(_e66.x, _e66.y, 0f, 0f));
    return;
}

// The filtered noise of 27 nodes, with three waves along each axis. If not `wanted`, computes none of them. FXC compiles a
// loop whose length it does not know much faster than three calls.
fn gabor_impl_filtered_narrow_3d(place: GaborPlace3d, wave: vec3<f32>, pixel: GaborMatrix, wanted: bool, salt: u32) -> GaborField3d {
    var x_19: GaborAxis;
    var y_17: GaborAxis;
    var z_10: GaborAxis;
    var turn_15: vec2<f32>;
    var blurred_4: vec3<f32>;
    var unused: GaborAxis;
    var sum_28: vec4<f32> = vec4(0f);
    var slopes_5: vec4<f32> = vec4(0f);
    var local_47: i32;
    var slices_1: i32;
    var k_4: i32 = 0i;
    let _e16 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, 1.5f);
    x_19 = _e16;
    let _e31 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), wave.y, 1.5f);
    y_17 = _e31;
    let _e46 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (salt ^ 668265263u), wave.z, 1.5f);
    z_10 = _e46;
    let _e48 = x_19;
    let _e50 = x_19;
    let _e53 = y_17;
    let _e55 = y_17;
    let _e59 = z_10;
    let _e61 = z_10;
    let _e65 = gabor_impl_wave((((_e48.turns * _e50.offset) + (_e53.turns * _e55.offset)) + (_e59.turns * _e61.offset)));
    turn_15 = _e65;
    let _e67 = gabor_impl_symmetric_3d(pixel, wave);
    blurred_4 = _e67;
    let _e69 = x_19;
    unused = _e69;
    let _e74 = blurred_4;
    gabor_impl_filter((&x_19), pixel.diagonal.x, _e74.x, (&unused));
    let _e82 = blurred_4;
    gabor_impl_filter((&y_17), pixel.diagonal.y, _e82.y, (&unused));
    let _e90 = blurred_4;
    gabor_impl_filter((&z_10), pixel.diagonal.z, _e90.z, (&unused));
    if wanted {
        local_47 = 3i;
    } else {
        local_47 = 0i;
    }
    let _e104 = local_47;
    slices_1 = _e104;
    loop {
        let _e108 = k_4;
        let _e109 = slices_1;
        if !((_e108 < _e109)) {
            break;
        }
        {
            let _e117 = x_19;
            let _e118 = y_17;
            let _e119 = z_10;
            gabor_impl_add_filtered_slice((&sum_28), (&slopes_5), _e117, _e118, _e119, pixel.mixed, place.evolution);
            let _e130 = z_10.node[1];
            z_10.node[0i] = _e130;
            let _e137 = z_10.node[2];
            z_10.node[1i] = _e137;
            let _e144 = z_10.word[1];
            z_10.word[0i] = _e144;
            let _e151 = z_10.word[2];
            z_10.word[1i] = _e151;
        }
        continuing {
            let _e112 = k_4;
            k_4 = (_e112 + 1i);
        }
    }
    let _e152 = sum_28;
    let _e153 = slopes_5;
    let _e156 = blurred_4;
    let _e162 = turn_15;
    let _e164 = gabor_impl_field_3d(_e152, _e153, (exp((-19.739208f * max(dot(wave, _e156), 0f))) * _e162), wave);
    return _e164;
}

fn gabor_field_3d_filtered(place: GaborPlace3d, dx: vec3<f32>, dy: vec3<f32>, wave: vec3<f32>, seed: u32) -> GaborField3d {
    var wave_26: vec3<f32>;
    var stretch_10: vec3<f32>;
    var salt_14: u32;
    var whole: GaborPixelAxes;
    var resolved: GaborPixelAxes;
    var transmitted_1: f32;
    var amplitude_6: f32;
    var pixel_5: GaborMatrix;
    var variance_1: vec3<f32>;
    var wide_1: f32;
    var sum_29: GaborField3d;
    var kept_1: bool;
    wave_26 = wave;
    stretch_10 = (place.cells_per_radius / vec3(1.5f));
    let _e14 = wave_26;
    let _e21 = stretch_10;
    wave_26 = (clamp(_e14, vec3(-1000000f), vec3(1000000f)) / _e21);
    let _e23 = gabor_impl_salt(seed);
    salt_14 = _e23;
    let _e25 = stretch_10;
    let _e26 = gabor_impl_pixel(dx, dy, _e25);
    whole = _e26;
    let _e28 = whole;
    let _e30 = gabor_impl_resolved(_e28, 1f);
    resolved = _e30;
    let _e32 = wave_26;
    let _e33 = whole;
    let _e34 = gabor_impl_transmitted_3d(_e32, _e33);
    transmitted_1 = _e34;
    let _e36 = transmitted_1;
    let _e37 = wave_26;
    let _e38 = resolved;
    let _e39 = gabor_impl_transmitted_3d(_e37, _e38);
    amplitude_6 = sqrt((_e36 / _e39));
    let _e43 = transmitted_1;
    if !((_e43 > 0.0000000001f)) {
        transmitted_1 = 0f;
    }
    let _e48 = resolved;
    let _e49 = gabor_impl_covariance(_e48);
    pixel_5 = _e49;
    let _e51 = pixel_5;
    variance_1 = _e51.diagonal;
    let _e55 = variance_1;
    let _e57 = variance_1;
    let _e60 = variance_1;
    wide_1 = clamp(((100f * sqrt(max(max(_e55.x, _e57.y), _e60.z))) - 9f), 0f, 1f);
    let _e78 = transmitted_1;
    sum_29 = GaborField3d(0f, vec3(0f), 0f, vec3(0f), (1f - _e78));
    let _e82 = transmitted_1;
    kept_1 = (_e82 > 0f);
    let _e86 = kept_1;
    let _e87 = wide_1;
    if (_e86 && (_e87 < 1f)) {
        let _e92 = wave_26;
        let _e93 = pixel_5;
        let _e94 = wide_1;
        let _e97 = salt_14;
        let _e98 = gabor_impl_filtered_narrow_3d(place, _e92, _e93, (_e94 < 1f), _e97);
        let _e100 = wide_1;
        let _e102 = amplitude_6;
        let _e104 = stretch_10;
        gabor_impl_add_field_3d((&sum_29), _e98, ((1f - _e100) * _e102), _e104);
    }
    let _e106 = kept_1;
    let _e107 = wide_1;
    if (_e106 && (_e107 > 0f)) {
        let _e112 = wave_26;
        let _e113 = pixel_5;
        let _e114 = wide_1;
        let _e117 = salt_14;
        let _e118 = gabor_impl_filtered_wide_3d(place, _e112, _e113, (_e114 > 0f), _e117);
        let _e119 = wide_1;
        let _e120 = amplitude_6;
        let _e122 = stretch_10;
        gabor_impl_add_field_3d((&sum_29), _e118, (_e119 * _e120), _e122);
    }
    let _e124 = sum_29;
    return _e124;
}

fn gabor_field_surface_filtered(place: GaborPlace3d, dx: vec3<f32>, dy: vec3<f32>, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var surface_1: GaborSurface;
    var sum_30: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_48: i32;
    var i_13: i32;
    var local_49: i32;
    var local_50: vec3<f32>;
    var wave_27: vec3<f32>;
    var local_51: f32;
    var power_7: f32;
    let _e7 = gabor_impl_surface(normal, direction);
    surface_1 = _e7;
    let _e18 = surface_1;
    if (_e18.second < 1f) {
        local_48 = 0i;
    } else {
        local_48 = 1i;
    }
    let _e25 = local_48;
    i_13 = _e25;
    loop {
        let _e27 = i_13;
        let _e28 = surface_1;
        if (_e28.second > 0f) {
            local_49 = 2i;
        } else {
            local_49 = 1i;
        }
        let _e35 = local_49;
        if !((_e27 < _e35)) {
            break;
        }
        {
            let _e42 = i_13;
            if (_e42 == 0i) {
                let _e45 = surface_1;
                local_50 = _e45.direction;
            } else {
                let _e47 = surface_1;
                local_50 = _e47.other;
            }
            let _e50 = local_50;
            wave_27 = (abs(frequency) * _e50);
            let _e53 = i_13;
            if (_e53 == 0i) {
                let _e57 = surface_1;
                local_51 = (1f - _e57.second);
            } else {
                let _e60 = surface_1;
                local_51 = _e60.second;
            }
            let _e63 = local_51;
            let _e64 = gabor_impl_takeover(_e63);
            power_7 = _e64;
            let _e67 = wave_27;
            let _e68 = i_13;
            let _e69 = gabor_derived_seed(seed, _e68);
            let _e70 = gabor_field_3d_filtered(place, dx, dy, _e67, _e69);
            let _e71 = power_7;
            gabor_impl_add_field_3d((&sum_30), _e70, sqrt(_e71), vec3(1f));
        }
        continuing {
            let _e38 = i_13;
            i_13 = (_e38 + 1i);
        }
    }
    let _e76 = sum_30;
    return _e76;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------

// A node's window along an axis, filtered: middle + cosine, and its derivative, sine. It fades out within half a standard
// deviation of its ends.
struct GaborFilteredNode {
    offset: f32, // offset of the point from the node
    middle: f32,
    cosine: f32,
    sine: f32,
    faded: f32, // derivative of the logarithm of the fade
}

fn gabor_impl_filtered_node_3d(node: GaborNode, variance: f32) -> GaborFilteredNode {
    var width_4: f32;
    var t_8: f32;
    var fade_4: f32;
    var fall_2: f32;
    var faded_4: f32;
    width_4 = clamp((0.5f * sqrt(variance)), 0.001f, 0.05f);
    let _e13 = width_4;
    t_8 = clamp(((1f - abs(node.offset)) / _e13), 0f, 1f);
    let _e19 = t_8;
    let _e20 = t_8;
    let _e24 = t_8;
    fade_4 = ((_e19 * _e20) * (3f - (2f * _e24)));
    let _e29 = fade_4;
    fall_2 = (_e29 * exp((-4.934802f * variance)));
    let _e38 = width_4;
    let _e40 = t_8;
    let _e43 = t_8;
    let _e49 = fade_4;
    faded_4 = (((((-6f / _e38) * _e40) * (1f - _e43)) * sign(node.offset)) / max(_e49, 0.000001f));
    let _e56 = fade_4;
    let _e58 = fall_2;
    let _e63 = fall_2;
    let _e66 = faded_4;
    return GaborFilteredNode(node.offset, (0.5f * _e56), (_e58 * (node.value - 0.5f)), (_e63 * node.slope), _e66);
}

// Adds a wave of a node: see gabor_impl_add_wave_3d. The filter multiplies the wave by exp(-2 pi^2 F.S F). With s = 2 pi^2
// S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
fn gabor_impl_add_filtered_wave_3d(sum: ptr<function, GaborField3d>, x: GaborFilteredNode, y: GaborFilteredNode, z: GaborFilteredNode, wave: vec4<f32>, evolution: f32, pixel: GaborMatrix, word: u32) {
    var a_9: vec2<f32>;
    var middle: vec3<f32>;
    var cosine_2: vec3<f32>;
    var sine: vec3<f32>;
    var s_8: vec3<f32>;
    var r_2: vec3<f32>;
    var even_3: vec3<f32>;
    var odd_3: vec3<f32>;
    var h_1: vec3<f32>;
    var mixed_2: f32;
    var i_h: vec3<f32>;
    var i_slope: vec3<f32>;
    var real_4: vec3<f32>;
    var imaginary_4: vec3<f32>;
    var value_12: vec2<f32>;
    var slope_12: vec3<f32>;
    var turned_1: vec3<f32>;
    var faded_5: vec3<f32>;
    let _e8 = gabor_impl_amplitude_at(word, evolution);
    let _e10 = gabor_impl_wave(wave.w);
    let _e11 = gabor_impl_product(_e8, _e10);
    a_9 = _e11;
    middle = vec3<f32>(x.middle, y.middle, z.middle);
    cosine_2 = vec3<f32>(x.cosine, y.cosine, z.cosine);
    sine = vec3<f32>(x.sine, y.sine, z.sine);
    let _e30 = gabor_impl_symmetric_3d(pixel, wave.xyz);
    s_8 = (19.739208f * _e30);
    let _e33 = a_9;
    let _e35 = s_8;
    a_9 = (_e33 * exp(-(max(dot(wave.xyz, _e35), 0f))));
    let _e42 = s_8;
    s_8 = clamp(_e42, vec3(-3f), vec3(3f));
    let _e49 = s_8;
    let _e50 = s_8;
    r_2 = (_e49 * _e50);
    let _e54 = r_2;
    let _e57 = r_2;
    even_3 = (vec3(1f) + (_e54 * (vec3(0.5f) + (0.041666668f * _e57))));
    let _e65 = s_8;
    let _e67 = r_2;
    let _e70 = r_2;
    odd_3 = (_e65 * (vec3(1f) + (_e67 * (vec3(0.16666667f) + (0.008333333f * _e70)))));
    let _e79 = middle;
    let _e80 = cosine_2;
    h_1 = (_e79 + _e80);
    let _e84 = sine;
    let _e86 = sine;
    let _e89 = h_1;
    mixed_2 = dot(pixel.mixed, ((_e84.yzx * _e86.zxy) * _e89));
    let _e93 = middle;
    let _e94 = even_3;
    let _e95 = cosine_2;
    h_1 = (_e93 + (_e94 * _e95));
    let _e99 = odd_3;
    let _e101 = sine;
    i_h = ((0.3183099f * _e99) * _e101);
    let _e106 = odd_3;
    let _e108 = cosine_2;
    i_slope = ((-3.1415927f * _e106) * _e108);
    let _e111 = h_1;
    let _e113 = h_1;
    let _e116 = i_h;
    let _e118 = i_h;
    real_4 = ((_e111.yzx * _e113.zxy) - (_e116.yzx * _e118.zxy));
    let _e123 = h_1;
    let _e125 = i_h;
    let _e128 = i_h;
    let _e130 = h_1;
    imaginary_4 = ((_e123.yzx * _e125.zxy) + (_e128.yzx * _e130.zxy));
    let _e135 = h_1;
    let _e137 = real_4;
    let _e140 = i_h;
    let _e142 = imaginary_4;
    let _e146 = mixed_2;
    let _e148 = h_1;
    let _e150 = imaginary_4;
    let _e153 = i_h;
    let _e155 = real_4;
    let _e160 = a_9;
    let _e161 = gabor_impl_product(vec2<f32>((((_e135.x * _e137.x) - (_e140.x * _e142.x)) + _e146), ((_e148.x * _e150.x) + (_e153.x * _e155.x))), _e160);
    value_12 = _e161;
    let _e163 = even_3;
    let _e164 = sine;
    let _e166 = real_4;
    let _e168 = i_slope;
    let _e169 = imaginary_4;
    slope_12 = (((_e163 * _e164) * _e166) - (_e168 * _e169));
    let _e173 = even_3;
    let _e174 = sine;
    let _e176 = imaginary_4;
    let _e178 = i_slope;
    let _e179 = real_4;
    turned_1 = (((_e173 * _e174) * _e176) + (_e178 * _e179));
    faded_5 = vec3<f32>(x.faded, y.faded, z.faded);
    let _e189 = (*sum);
    let _e191 = value_12;
    (*sum).noise = (_e189.noise + _e191.y);
    let _e195 = (*sum);
    let _e197 = slope_12;
    let _e198 = a_9;
    let _e201 = turned_1;
    let _e202 = a_9;
    let _e206 = value_12;
    let _e208 = faded_5;
    let _e212 = value_12;
    (*sum).gradient = (_e195.gradient + ((((_e197 * _e198.y) + (_e201 * _e202.x)) + (_e206.y * _e208)) + ((6.2831855f * _e212.x) * wave.xyz)));
    let _e220 = (*sum);
    let _e222 = value_12;
    (*sum).quadrature = (_e220.quadrature + _e222.x);
    let _e226 = (*sum);
    let _e228 = slope_12;
    let _e229 = a_9;
    let _e232 = turned_1;
    let _e233 = a_9;
    let _e237 = value_12;
    let _e239 = faded_5;
    let _e243 = value_12;
    (*sum).quadrature_gradient = (_e226.quadrature_gradient + ((((_e228 * _e229.x) - (_e232 * _e233.y)) + (_e237.x * _e239)) - ((6.2831855f * _e243.y) * wave.xyz)));
    return;
}

fn gabor_impl_add_filtered_waves_3d(sum: ptr<function, GaborField3d>, x: GaborFilteredNode, y: GaborFilteredNode, z: GaborFilteredNode, scale: vec3<f32>, evolution: f32, pixel: GaborMatrix, tangents: GaborTangents, column: u32, row: vec4<u32>) {
    var d_10: vec3<f32>;
    var star_4: GaborStar3d;
    var unit_6: vec4<f32>;
    d_10 = (scale * vec3<f32>(x.offset, y.offset, z.offset));
    let _e16 = d_10;
    let _e19 = gabor_impl_star_3d(tangents, _e16, (column * row.w));
    star_4 = _e19;
    unit_6 = vec4<f32>(scale.x, scale.y, scale.z, 1f);
    let _e28 = unit_6;
    let _e29 = star_4;
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, (_e28 * _e29.u), evolution, pixel, (column * row.x));
    let _e36 = unit_6;
    let _e37 = star_4;
    gabor_impl_add_filtered_wave_3d(sum, x, y, z, (_e36 * _e37.v), evolution, pixel, (column * row.y));
    if !(tangents.only) {
        let _e46 = unit_6;
        let _e47 = star_4;
        gabor_impl_add_filtered_wave_3d(sum, x, y, z, (_e46 * _e47.w), evolution, pixel, (column * row.z));
        return;
    } else {
        return;
    }
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
fn gabor_impl_transmitted_isotropic(frequency: f32, pixel: GaborPixelAxes, tangents: GaborTangents) -> f32 {
    var d_11: vec2<f32>;
    var unit_7: vec2<f32>;
    var mean_2: f32;
    var a_10: vec2<f32>;
    var b_10: vec2<f32>;
    var sum_33: f32;
    var apart_2: f32;
    var q_2: vec2<f32>;
    var larger_1: f32;
    var smaller_2: f32;
    let _e3 = gabor_impl_spread(pixel);
    d_11 = _e3;
    let _e10 = d_11;
    unit_7 = (vec2(min(((9.869604f * frequency) * frequency), 1000000f)) / _e10);
    if tangents.only {
        {
            a_10 = vec2<f32>(dot(tangents.along, pixel.major), dot(tangents.along, pixel.minor));
            b_10 = vec2<f32>(dot(tangents.across, pixel.major), dot(tangents.across, pixel.minor));
            let _e32 = unit_7;
            let _e33 = a_10;
            let _e34 = a_10;
            let _e36 = b_10;
            let _e37 = b_10;
            sum_33 = dot(_e32, ((_e33 * _e34) + (_e36 * _e37)));
            let _e42 = unit_7;
            let _e43 = a_10;
            let _e44 = a_10;
            let _e46 = b_10;
            let _e47 = b_10;
            let _e52 = unit_7;
            let _e53 = a_10;
            let _e54 = b_10;
            apart_2 = length(vec2<f32>(dot(_e42, ((_e43 * _e44) - (_e46 * _e47))), (2f * dot(_e52, (_e53 * _e54)))));
            let _e62 = apart_2;
            let _e63 = sum_33;
            let _e69 = apart_2;
            let _e70 = gabor_impl_mean_angle(_e69);
            mean_2 = (exp(min((0.5f * (_e62 - _e63)), 0f)) * _e70);
        }
    } else {
        {
            let _e72 = unit_7;
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
    let _e133 = d_11;
    let _e135 = d_11;
    return (_e132 * inverseSqrt((_e133.x * _e135.y)));
}

fn gabor_impl_isotropic_filtered(place: GaborPlace3d, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, tangents: GaborTangents, seed: u32) -> GaborField3d {
    var frequency_26: f32;
    var stretch_11: vec3<f32>;
    var whole_1: GaborPixelAxes;
    var resolved_1: GaborPixelAxes;
    var transmitted_2: f32;
    var amplitude_7: f32;
    var field_13: GaborField3d;
    var pixel_9: GaborMatrix;
    var s_9: vec3<f32>;
    var scale_5: vec3<f32>;
    var salt_15: u32;
    var x_22: GaborAxis;
    var y_20: GaborAxis;
    var z_13: GaborAxis;
    var x_0_: GaborFilteredNode;
    var x_1_: GaborFilteredNode;
    var x_2_: GaborFilteredNode;
    var sum_34: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var i_14: i32 = 0i;
    var y_j_1: GaborFilteredNode;
    var z_k_1: GaborFilteredNode;
    var row_11: vec4<u32>;
    var local_52: f32;
    var local_53: f32;
    var local_54: f32;
    frequency_26 = frequency;
    stretch_11 = (place.cells_per_radius / vec3(1.5f));
    let _e15 = frequency_26;
    frequency_26 = min(abs(_e15), 1000000f);
    let _e21 = gabor_impl_pixel(dx, dy, vec3(1f));
    whole_1 = _e21;
    let _e23 = whole_1;
    let _e25 = gabor_impl_resolved(_e23, 0.5f);
    resolved_1 = _e25;
    let _e27 = frequency_26;
    let _e28 = whole_1;
    let _e29 = gabor_impl_transmitted_isotropic(_e27, _e28, tangents);
    transmitted_2 = _e29;
    let _e31 = transmitted_2;
    let _e32 = frequency_26;
    let _e33 = resolved_1;
    let _e34 = gabor_impl_transmitted_isotropic(_e32, _e33, tangents);
    amplitude_7 = sqrt((_e31 / _e34));
    let _e38 = transmitted_2;
    if !((_e38 > 0.0000000001f)) {
        transmitted_2 = 0f;
    }
    let _e50 = transmitted_2;
    field_13 = GaborField3d(0f, vec3(0f), 0f, vec3(0f), (1f - _e50));
    let _e54 = transmitted_2;
    if (_e54 == 0f) {
        let _e57 = field_13;
        return _e57;
    }
    let _e58 = resolved_1;
    let _e60 = stretch_11;
    let _e62 = resolved_1;
    let _e64 = stretch_11;
    let _e67 = gabor_impl_covariance(GaborPixelAxes((_e58.major * _e60), (_e62.minor * _e64)));
    pixel_9 = _e67;
    let _e69 = pixel_9;
    s_9 = _e69.diagonal;
    let _e72 = frequency_26;
    let _e73 = stretch_11;
    scale_5 = (vec3(_e72) / _e73);
    let _e77 = gabor_impl_salt(seed);
    salt_15 = _e77;
    let _e85 = salt_15;
    let _e91 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e85, 0f, 1.5f);
    x_22 = _e91;
    let _e99 = salt_15;
    let _e107 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e99 ^ 1540483477u), 0f, 1.5f);
    y_20 = _e107;
    let _e115 = salt_15;
    let _e123 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (_e115 ^ 668265263u), 0f, 1.5f);
    z_13 = _e123;
    let _e125 = x_22;
    let _e127 = gabor_impl_node(_e125, 0i);
    let _e128 = s_9;
    let _e130 = gabor_impl_filtered_node_3d(_e127, _e128.x);
    x_0_ = _e130;
    let _e132 = x_22;
    let _e134 = gabor_impl_node(_e132, 1i);
    let _e135 = s_9;
    let _e137 = gabor_impl_filtered_node_3d(_e134, _e135.x);
    x_1_ = _e137;
    let _e139 = x_22;
    let _e141 = gabor_impl_node(_e139, 2i);
    let _e142 = s_9;
    let _e144 = gabor_impl_filtered_node_3d(_e141, _e142.x);
    x_2_ = _e144;
    loop {
        let _e157 = i_14;
        if !((_e157 < 9i)) {
            break;
        }
        {
            let _e164 = y_20;
            let _e165 = i_14;
            let _e168 = gabor_impl_node(_e164, (_e165 % 3i));
            let _e169 = s_9;
            let _e171 = gabor_impl_filtered_node_3d(_e168, _e169.y);
            y_j_1 = _e171;
            let _e173 = z_13;
            let _e174 = i_14;
            let _e177 = gabor_impl_node(_e173, (_e174 / 3i));
            let _e178 = s_9;
            let _e180 = gabor_impl_filtered_node_3d(_e177, _e178.z);
            z_k_1 = _e180;
            let _e182 = y_20;
            let _e183 = i_14;
            let _e186 = gabor_impl_node_word(_e182, (_e183 % 3i));
            let _e187 = z_13;
            let _e188 = i_14;
            let _e191 = gabor_impl_node_word(_e187, (_e188 / 3i));
            let _e193 = gabor_impl_row((_e186 * _e191));
            row_11 = _e193;
            let _e196 = x_0_;
            let _e197 = y_j_1;
            let _e198 = z_k_1;
            let _e199 = scale_5;
            let _e201 = pixel_9;
            let _e205 = x_22.word[0];
            let _e206 = row_11;
            gabor_impl_add_filtered_waves_3d((&sum_34), _e196, _e197, _e198, _e199, place.evolution, _e201, tangents, _e205, _e206);
            let _e209 = x_1_;
            let _e210 = y_j_1;
            let _e211 = z_k_1;
            let _e212 = scale_5;
            let _e214 = pixel_9;
            let _e218 = x_22.word[1];
            let _e219 = row_11;
            gabor_impl_add_filtered_waves_3d((&sum_34), _e209, _e210, _e211, _e212, place.evolution, _e214, tangents, _e218, _e219);
            let _e222 = x_2_;
            let _e223 = y_j_1;
            let _e224 = z_k_1;
            let _e225 = scale_5;
            let _e227 = pixel_9;
            let _e231 = x_22.word[2];
            let _e232 = row_11;
            gabor_impl_add_filtered_waves_3d((&sum_34), _e222, _e223, _e224, _e225, place.evolution, _e227, tangents, _e231, _e232);
        }
        continuing {
            let _e161 = i_14;
            i_14 = (_e161 + 1i);
        }
    }
    let _e234 = amplitude_7;
    if tangents.only {
        local_52 = 2f;
    } else {
        local_52 = 3f;
    }
    let _e239 = local_52;
    if false {
        local_53 = 1f;
    } else {
        local_53 = 1.125f;
    }
    let _e249 = local_53;
    if false {
        local_54 = 1f;
    } else {
        local_54 = 1.125f;
    }
    let _e262 = local_54;
    amplitude_7 = (_e234 * (inverseSqrt((_e239 * _e249)) / (1459955300000000000000000000f * _e262)));
    let _e267 = sum_34;
    let _e268 = amplitude_7;
    let _e269 = stretch_11;
    gabor_impl_add_field_3d((&field_13), _e267, _e268, _e269);
    let _e271 = field_13;
    return _e271;
}

fn gabor_field_3d_isotropic_filtered(place: GaborPlace3d, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    let _e5 = gabor_impl_all_directions();
    let _e6 = gabor_impl_isotropic_filtered(place, dx, dy, frequency, _e5, seed);
    return _e6;
}

fn gabor_field_surface_isotropic_filtered(place: GaborPlace3d, dx: vec3<f32>, dy: vec3<f32>, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_9: vec3<f32>;
    var aside_1: f32;
    var sum_35: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_55: i32;
    var i_15: i32;
    var local_56: i32;
    var local_57: f32;
    var power_8: f32;
    var field_14: GaborField3d;
    normal_9 = normal;
    let _e7 = normal_9;
    let _e8 = gabor_impl_unit(_e7);
    normal_9 = _e8;
    let _e9 = normal_9;
    let _e11 = normal_9;
    aside_1 = dot(_e9.xy, _e11.xy);
    let _e24 = aside_1;
    if (_e24 > 0.25f) {
        local_55 = 0i;
    } else {
        local_55 = 1i;
    }
    let _e30 = local_55;
    i_15 = _e30;
    loop {
        let _e32 = i_15;
        let _e33 = aside_1;
        if (_e33 < 0.5f) {
            local_56 = 2i;
        } else {
            local_56 = 1i;
        }
        let _e39 = local_56;
        if !((_e32 < _e39)) {
            break;
        }
        {
            let _e45 = i_15;
            if (_e45 == 0i) {
                let _e50 = aside_1;
                local_57 = smoothstep(0.25f, 0.5f, _e50);
            } else {
                let _e55 = aside_1;
                local_57 = (1f - smoothstep(0.25f, 0.5f, _e55));
            }
            let _e59 = local_57;
            let _e60 = gabor_impl_takeover(_e59);
            power_8 = _e60;
            let _e62 = normal_9;
            let _e63 = i_15;
            let _e64 = gabor_impl_tangents(_e62, _e63);
            let _e65 = i_15;
            let _e66 = gabor_derived_seed(seed, _e65);
            let _e67 = gabor_impl_isotropic_filtered(place, dx, dy, frequency, _e64, _e66);
            field_14 = _e67;
            let _e70 = field_14;
            let _e71 = power_8;
            gabor_impl_add_field_3d((&sum_35), _e70, sqrt(_e71), vec3(1f));
        }
        continuing {
            let _e42 = i_15;
            i_15 = (_e42 + 1i);
        }
    }
    let _e76 = sum_35;
    return _e76;
}

