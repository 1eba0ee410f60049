// gabor_lattice_3d.wgsl: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.wgsl; every name that it adds begins with gabor_ or Gabor: for WGSL.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate and naga 30.0.1: change that file, not this one. Paste or include it after gabor_lattice.wgsl.
//
// As in the plane, the nodes c of a cubic lattice, R = 3/2 to the kernel radius, have independent normal amplitudes A,
// and each sends out a wave under a product of Hann windows h(x) = (1 + cos pi x) / 2 that ends one kernel radius away:
//
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
//
// The nearest node and its neighbours, 27, reach a point. Whatever the wave vector F is, the variance is 1 at every
// place: so F may follow a surface, which sees the frequency asked for and no trace of the lattice. Several directions
// are a sum of independent noises, which makes everything, gradients and pairs of places too, jointly normal.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Where to evaluate, and how space and time close upon themselves: see GaborPlace.
struct GaborPlace3d {
    cell: vec3<i32>,
    local: vec3<f32>,
    radius: vec3<f32>,
    period: vec3<i32>,
    animated: bool,
    time: f32,
    filtered: bool,
    dx: vec3<f32>,
    dy: vec3<f32>,
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
struct GaborField3d {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
    slope_z: vec2<f32>,
    removed: f32,
}

// Along each axis.
struct GaborAxes3d {
    x: GaborAxis,
    y: GaborAxis,
    z: GaborAxis,
    base: vec2<f32>,
}

fn gabor_impl_axes(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborAxes3d {
    var n: GaborAxes3d;
    var salt_4: u32;
    var local_12: f32;
    var local_13: f32;

    let _e4 = gabor_impl_salt(seed);
    salt_4 = _e4;
    let _e13 = salt_4;
    let _e17 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e13, wave.x, place.radius.x);
    n.x = _e17;
    let _e25 = salt_4;
    let _e31 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e25 ^ 1540483477u), wave.y, place.radius.y);
    n.y = _e31;
    let _e39 = salt_4;
    let _e45 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (_e39 ^ 668265263u), wave.z, place.radius.z);
    n.z = _e45;
    if false {
        local_12 = 1f;
    } else {
        local_12 = 1.125f;
    }
    let _e56 = local_12;
    if false {
        local_13 = 1f;
    } else {
        local_13 = 1.125f;
    }
    let _e68 = local_13;
    let _e71 = n;
    let _e74 = n;
    let _e78 = n;
    let _e81 = n;
    let _e86 = n;
    let _e89 = n;
    let _e94 = gabor_impl_wave((((_e71.x.turns * _e74.x.offset) + (_e78.y.turns * _e81.y.offset)) + (_e86.z.turns * _e89.z.offset)));
    n.base = ((inverseSqrt(_e56) / (1459955300000000000000000000f * _e68)) * _e94);
    let _e96 = n;
    return _e96;
}

// The word of a row in a slice of nodes: odd and of 24 bits, as those of lines are.
fn gabor_impl_slice_word(row: u32, slice: u32) -> u32 {
    return (((row * slice) >> 8u) | 8388609u);
}

// Adds slice k of nodes, a sum as in the plane: to `sum` the noise, in zw with the derivatives of windows along x, to
// `slopes` with those along y, in zw along z.
fn gabor_impl_add_slice(sum: ptr<function, vec4<f32>>, slopes: ptr<function, vec4<f32>>, n: GaborAxes3d, k: i32, place: GaborPlace3d) {
    var rows: GaborAxis;
    var slice_1: vec4<f32>;
    var slope_6: vec4<f32>;

    rows = n.y;
    let _e17 = gabor_impl_slice_word(n.y.word[0], n.z.word[k]);
    rows.word[0i] = _e17;
    let _e28 = gabor_impl_slice_word(n.y.word[1], n.z.word[k]);
    rows.word[1i] = _e28;
    let _e39 = gabor_impl_slice_word(n.y.word[2], n.z.word[k]);
    rows.word[2i] = _e39;
    let _e43 = rows;
    gabor_impl_sum(n.x, _e43, place.animated, place.time, (&slice_1), (&slope_6));
    let _e51 = slice_1;
    gabor_impl_add(sum, _e51, n.z.node[k].xy);
    let _e57 = (*slopes);
    let _e58 = slope_6;
    let _e64 = gabor_impl_product(_e58.xy, n.z.node[k].xy);
    let _e65 = slice_1;
    let _e71 = gabor_impl_product(_e65.xy, n.z.node[k].zw);
    (*slopes) = (_e57 + vec4<f32>(_e64.x, _e64.y, _e71.x, _e71.y));
    return;
}

fn gabor_impl_windowed(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborField3d {
    var n_2: GaborAxes3d;
    var sum_5: vec4<f32> = vec4(0f);
    var slopes_1: vec4<f32> = vec4(0f);
    var value_4: vec2<f32>;
    var turned_1: vec2<f32>;
    var stretch_1: vec3<f32>;

    let _e3 = gabor_impl_axes(place, wave, seed);
    n_2 = _e3;
    let _e13 = n_2;
    gabor_impl_add_slice((&sum_5), (&slopes_1), _e13, 0i, place);
    let _e19 = n_2;
    gabor_impl_add_slice((&sum_5), (&slopes_1), _e19, 1i, place);
    let _e25 = n_2;
    gabor_impl_add_slice((&sum_5), (&slopes_1), _e25, 2i, place);
    let _e29 = sum_5;
    let _e31 = n_2;
    let _e33 = gabor_impl_product(_e29.xy, _e31.base);
    value_4 = _e33;
    let _e36 = value_4;
    let _e39 = value_4;
    turned_1 = (6.2831855f * vec2<f32>(-(_e36.y), _e39.x));
    stretch_1 = (place.radius / vec3(1.5f));
    let _e52 = value_4;
    let _e53 = stretch_1;
    let _e55 = sum_5;
    let _e57 = n_2;
    let _e59 = gabor_impl_product(_e55.zw, _e57.base);
    let _e62 = turned_1;
    let _e65 = stretch_1;
    let _e67 = slopes_1;
    let _e69 = n_2;
    let _e71 = gabor_impl_product(_e67.xy, _e69.base);
    let _e74 = turned_1;
    let _e77 = stretch_1;
    let _e79 = slopes_1;
    let _e81 = n_2;
    let _e83 = gabor_impl_product(_e79.zw, _e81.base);
    let _e86 = turned_1;
    return GaborField3d(_e52, ((_e53.x * _e59) + (wave.x * _e62)), ((_e65.y * _e71) + (wave.y * _e74)), ((_e77.z * _e83) + (wave.z * _e86)), 0f);
}

// Three times three complex numbers.
struct GaborMatrix {
    real: mat3x3<f32>,
    imaginary: mat3x3<f32>,
}

fn gabor_impl_matrix_product(m: GaborMatrix, n: GaborMatrix) -> GaborMatrix {
    return GaborMatrix(((m.real * n.real) - (m.imaginary * n.imaginary)), ((m.real * n.imaginary) + (m.imaginary * n.real)));
}

// The amplitudes of a slice of nodes, a column for each row, as `x` and `y` take them from nodes to waves.
fn gabor_impl_slice(n: GaborAxes3d, slice: u32, place: GaborPlace3d, x: GaborMatrix, y: GaborMatrix) -> GaborMatrix {
    var m_1: GaborMatrix;
    var j_1: i32 = 0i;
    var row_2: u32;
    var i: i32;
    var amplitude_1: vec2<f32>;

    loop {
        let _e8 = j_1;
        if !((_e8 < 3i)) {
            break;
        }
        {
            let _e15 = j_1;
            let _e19 = gabor_impl_slice_word(n.y.word[_e15], slice);
            row_2 = _e19;
            i = 0i;
            loop {
                let _e23 = i;
                if !((_e23 < 3i)) {
                    break;
                }
                {
                    let _e30 = i;
                    let _e34 = row_2;
                    let _e38 = gabor_impl_amplitude_at((n.x.word[_e30] * _e34), place.animated, place.time);
                    amplitude_1 = _e38;
                    let _e40 = i;
                    let _e41 = j_1;
                    let _e45 = amplitude_1;
                    m_1.real[_e41][_e40] = _e45.x;
                    let _e47 = i;
                    let _e48 = j_1;
                    let _e52 = amplitude_1;
                    m_1.imaginary[_e48][_e47] = _e52.y;
                }
                continuing {
                    let _e27 = i;
                    i = (_e27 + 1i);
                }
            }
        }
        continuing {
            let _e12 = j_1;
            j_1 = (_e12 + 1i);
        }
    }
    let _e54 = m_1;
    let _e55 = gabor_impl_matrix_product(x, _e54);
    let _e56 = gabor_impl_matrix_product(_e55, y);
    return _e56;
}

// What an axis' three nodes add to the three waves that they are together between nodes:
//     h(x - c) e^(2 pi i F (x - c)) = sum_a h_a e^(2 pi i (F + a/2) (x - c)),   a = -1, 0, 1,   h_a = 1/4, 1/2, 1/4.
// Within half a deviation of the filter from its window's end a node fades, so that nothing jumps.
fn gabor_impl_waves(axis: GaborAxis, deviation: f32) -> GaborMatrix {
    var d: vec3<f32>;
    var step_: vec2<f32>;
    var reach: vec3<f32>;
    var real: vec3<f32>;
    var imaginary: vec3<f32>;
    var turn_5: vec2<f32>;
    var c_1: vec3<f32>;
    var s_2: vec3<f32>;

    d = ((vec3(axis.offset) + vec3<f32>(1f, 0f, -1f)) / vec3(1.5f));
    let _e18 = gabor_impl_wave(axis.turns);
    step_ = _e18;
    let _e21 = d;
    reach = clamp(((vec3(1f) - abs(_e21)) / vec3(max((0.5f * deviation), 0.000001f))), vec3(0f), vec3(1f));
    let _e37 = reach;
    let _e39 = reach;
    let _e43 = reach;
    reach = (_e37 * ((0.5f * _e39) * (vec3(3f) - (2f * _e43))));
    let _e49 = reach;
    let _e50 = step_;
    let _e53 = step_;
    real = (_e49 * vec3<f32>(_e50.x, 1f, _e53.x));
    let _e58 = reach;
    let _e59 = step_;
    let _e62 = step_;
    imaginary = (_e58 * vec3<f32>(_e59.y, 0f, -(_e62.y)));
    let _e70 = d;
    let _e73 = gabor_impl_wave((0.5f * _e70.y));
    turn_5 = (0.5f * _e73);
    let _e76 = turn_5;
    let _e85 = turn_5;
    c_1 = ((_e76.x * vec3<f32>(-0.5f, 1f, -0.5f)) + (_e85.y * vec3<f32>(-0.8660254f, 0f, 0.8660254f)));
    let _e95 = turn_5;
    let _e104 = turn_5;
    s_2 = ((_e95.y * vec3<f32>(-0.5f, 1f, -0.5f)) - (_e104.x * vec3<f32>(-0.8660254f, 0f, 0.8660254f)));
    let _e114 = real;
    let _e115 = c_1;
    let _e117 = imaginary;
    let _e118 = s_2;
    let _e120 = ((_e114 * _e115) + (_e117 * _e118));
    let _e121 = real;
    let _e122 = real;
    let _e123 = c_1;
    let _e125 = imaginary;
    let _e126 = s_2;
    let _e128 = ((_e122 * _e123) - (_e125 * _e126));
    let _e142 = imaginary;
    let _e143 = c_1;
    let _e145 = real;
    let _e146 = s_2;
    let _e148 = ((_e142 * _e143) - (_e145 * _e146));
    let _e149 = imaginary;
    let _e150 = imaginary;
    let _e151 = c_1;
    let _e153 = real;
    let _e154 = s_2;
    let _e156 = ((_e150 * _e151) + (_e153 * _e154));
    return GaborMatrix(mat3x3<f32>(vec3<f32>(_e120.x, _e120.y, _e120.z), vec3<f32>(_e121.x, _e121.y, _e121.z), vec3<f32>(_e128.x, _e128.y, _e128.z)), mat3x3<f32>(vec3<f32>(_e148.x, _e148.y, _e148.z), vec3<f32>(_e149.x, _e149.y, _e149.z), vec3<f32>(_e156.x, _e156.y, _e156.z)));
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: (det(1 + S^2))^(-1/4).
fn gabor_impl_filtered(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborField3d {
    var dx: vec3<f32>;
    var dy: vec3<f32>;
    var stretch_2: vec3<f32>;
    var deviation_1: vec3<f32>;
    var n_5: GaborAxes3d;
    var x_5: GaborMatrix;
    var y_6: GaborMatrix;
    var z_1: GaborMatrix;
    var first_1: GaborMatrix;
    var second_1: GaborMatrix;
    var third_1: GaborMatrix;
    var sum_6: vec2<f32> = vec2(0f);
    var slope_x: vec2<f32> = vec2(0f);
    var slope_y: vec2<f32> = vec2(0f);
    var slope_z: vec2<f32> = vec2(0f);
    var kept: f32 = 0f;
    var b_2: i32 = 0i;
    var m_2: GaborMatrix;
    var c_2: i32;
    var a_2: i32;
    var aside: vec3<f32>;
    var k_1: vec3<f32>;
    var left: f32;
    var value_5: vec2<f32>;
    var trace: f32;
    var determinant_: f32;
    var fade: f32;
    var base: vec2<f32>;

    dx = clamp(place.dx, vec3(-1000000f), vec3(1000000f));
    dy = clamp(place.dy, vec3(-1000000f), vec3(1000000f));
    stretch_2 = (place.radius / vec3(1.5f));
    let _e28 = stretch_2;
    let _e30 = dx;
    let _e31 = dx;
    let _e33 = dy;
    let _e34 = dy;
    deviation_1 = ((0.5f * _e28) * sqrt(((_e30 * _e31) + (_e33 * _e34))));
    let _e40 = gabor_impl_axes(place, wave, seed);
    n_5 = _e40;
    let _e42 = n_5;
    let _e44 = deviation_1;
    let _e46 = gabor_impl_waves(_e42.x, _e44.x);
    x_5 = _e46;
    let _e48 = n_5;
    let _e50 = deviation_1;
    let _e52 = gabor_impl_waves(_e48.y, _e50.y);
    y_6 = _e52;
    let _e54 = n_5;
    let _e56 = deviation_1;
    let _e58 = gabor_impl_waves(_e54.z, _e56.z);
    z_1 = _e58;
    let _e60 = x_5;
    let _e63 = x_5;
    x_5 = GaborMatrix(transpose(_e60.real), transpose(_e63.imaginary));
    let _e67 = n_5;
    let _e72 = n_5.z.word[0];
    let _e73 = x_5;
    let _e74 = y_6;
    let _e75 = gabor_impl_slice(_e67, _e72, place, _e73, _e74);
    first_1 = _e75;
    let _e77 = n_5;
    let _e82 = n_5.z.word[1];
    let _e83 = x_5;
    let _e84 = y_6;
    let _e85 = gabor_impl_slice(_e77, _e82, place, _e83, _e84);
    second_1 = _e85;
    let _e87 = n_5;
    let _e92 = n_5.z.word[2];
    let _e93 = x_5;
    let _e94 = y_6;
    let _e95 = gabor_impl_slice(_e87, _e92, place, _e93, _e94);
    third_1 = _e95;
    loop {
        let _e113 = b_2;
        if !((_e113 < 3i)) {
            break;
        }
        {
            let _e120 = b_2;
            let _e123 = first_1.real[_e120];
            let _e124 = b_2;
            let _e127 = second_1.real[_e124];
            let _e128 = b_2;
            let _e131 = third_1.real[_e128];
            let _e145 = b_2;
            let _e148 = first_1.imaginary[_e145];
            let _e149 = b_2;
            let _e152 = second_1.imaginary[_e149];
            let _e153 = b_2;
            let _e156 = third_1.imaginary[_e153];
            m_2 = GaborMatrix(mat3x3<f32>(vec3<f32>(_e123.x, _e123.y, _e123.z), vec3<f32>(_e127.x, _e127.y, _e127.z), vec3<f32>(_e131.x, _e131.y, _e131.z)), mat3x3<f32>(vec3<f32>(_e148.x, _e148.y, _e148.z), vec3<f32>(_e152.x, _e152.y, _e152.z), vec3<f32>(_e156.x, _e156.y, _e156.z)));
            let _e172 = m_2;
            let _e173 = z_1;
            let _e174 = gabor_impl_matrix_product(_e172, _e173);
            m_2 = _e174;
            c_2 = 0i;
            loop {
                let _e177 = c_2;
                if !((_e177 < 3i)) {
                    break;
                }
                {
                    a_2 = 0i;
                    loop {
                        let _e186 = a_2;
                        if !((_e186 < 3i)) {
                            break;
                        }
                        {
                            let _e193 = a_2;
                            let _e197 = b_2;
                            let _e201 = c_2;
                            aside = vec3<f32>(f32((_e193 - 1i)), f32((_e197 - 1i)), f32((_e201 - 1i)));
                            let _e208 = stretch_2;
                            let _e210 = aside;
                            k_1 = (wave + ((0.5f * _e208) * _e210));
                            let _e216 = k_1;
                            let _e217 = dx;
                            let _e219 = k_1;
                            let _e220 = dx;
                            let _e223 = k_1;
                            let _e224 = dy;
                            let _e226 = k_1;
                            let _e227 = dy;
                            left = exp((-4.934802f * ((dot(_e216, _e217) * dot(_e219, _e220)) + (dot(_e223, _e224) * dot(_e226, _e227)))));
                            let _e234 = left;
                            let _e235 = a_2;
                            let _e236 = c_2;
                            let _e240 = m_2.real[_e236][_e235];
                            let _e241 = a_2;
                            let _e242 = c_2;
                            let _e246 = m_2.imaginary[_e242][_e241];
                            value_5 = (_e234 * vec2<f32>(_e240, _e246));
                            let _e250 = sum_6;
                            let _e251 = value_5;
                            sum_6 = (_e250 + _e251);
                            let _e253 = slope_x;
                            let _e254 = k_1;
                            let _e256 = value_5;
                            let _e259 = value_5;
                            slope_x = (_e253 + (_e254.x * vec2<f32>(-(_e256.y), _e259.x)));
                            let _e264 = slope_y;
                            let _e265 = k_1;
                            let _e267 = value_5;
                            let _e270 = value_5;
                            slope_y = (_e264 + (_e265.y * vec2<f32>(-(_e267.y), _e270.x)));
                            let _e275 = slope_z;
                            let _e276 = k_1;
                            let _e278 = value_5;
                            let _e281 = value_5;
                            slope_z = (_e275 + (_e276.z * vec2<f32>(-(_e278.y), _e281.x)));
                            let _e286 = kept;
                            let _e287 = left;
                            let _e288 = left;
                            let _e292 = aside;
                            let _e293 = aside;
                            kept = (_e286 + ((_e287 * _e288) * exp2((-2f * dot(_e292, _e293)))));
                        }
                        continuing {
                            let _e190 = a_2;
                            a_2 = (_e190 + 1i);
                        }
                    }
                }
                continuing {
                    let _e181 = c_2;
                    c_2 = (_e181 + 1i);
                }
            }
        }
        continuing {
            let _e117 = b_2;
            b_2 = (_e117 + 1i);
        }
    }
    let _e300 = dx;
    let _e301 = dx;
    let _e303 = dy;
    let _e304 = dy;
    trace = (0.25f * (dot(_e300, _e301) + dot(_e303, _e304)));
    let _e310 = dx;
    let _e311 = dy;
    let _e313 = dx;
    let _e314 = dy;
    determinant_ = (0.0625f * dot(cross(_e310, _e311), cross(_e313, _e314)));
    let _e320 = trace;
    let _e321 = trace;
    let _e324 = determinant_;
    let _e325 = determinant_;
    fade = inverseSqrt(sqrt(max(((1f + (_e320 * _e321)) + (_e324 * (_e325 - 2f))), 1f)));
    let _e335 = fade;
    let _e336 = n_5;
    base = (_e335 * _e336.base);
    let _e340 = base;
    let _e341 = sum_6;
    let _e342 = gabor_impl_product(_e340, _e341);
    let _e343 = base;
    let _e345 = slope_x;
    let _e347 = gabor_impl_product(_e343, (6.2831855f * _e345));
    let _e348 = base;
    let _e350 = slope_y;
    let _e352 = gabor_impl_product(_e348, (6.2831855f * _e350));
    let _e353 = base;
    let _e355 = slope_z;
    let _e357 = gabor_impl_product(_e353, (6.2831855f * _e355));
    let _e359 = fade;
    let _e360 = fade;
    let _e366 = kept;
    return GaborField3d(_e342, _e347, _e352, _e357, (1f - (((_e359 * _e360) * 0.2962963f) * _e366)));
}

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
fn gabor_place_3d(cell: vec3<i32>, local: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3(1.5f), vec3(0i), false, 0f, false, vec3(0f), vec3(0f));
}

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
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

fn gabor_wave_3d(frequency: f32, direction: vec3<f32>) -> vec3<f32> {
    let _e5 = gabor_impl_unit(direction);
    return (min(abs(frequency), 1000000f) * _e5);
}

fn gabor_field_3d(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborField3d {
    if place.filtered {
        let _e4 = gabor_impl_filtered(place, wave, seed);
        return _e4;
    }
    let _e5 = gabor_impl_windowed(place, wave, seed);
    return _e5;
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
fn gabor_impl_add_term(sum: ptr<function, GaborField3d>, place: GaborPlace3d, wave: vec3<f32>, seed: u32, index: i32, power: f32) {
    var term: GaborField3d;

    let _e6 = gabor_lobe_seed(seed, index);
    let _e7 = gabor_field_3d(place, wave, _e6);
    term = _e7;
    let _e10 = (*sum);
    let _e13 = term;
    (*sum).value = (_e10.value + (sqrt(power) * _e13.value));
    let _e18 = (*sum);
    let _e21 = term;
    (*sum).slope_x = (_e18.slope_x + (sqrt(power) * _e21.slope_x));
    let _e26 = (*sum);
    let _e29 = term;
    (*sum).slope_y = (_e26.slope_y + (sqrt(power) * _e29.slope_y));
    let _e34 = (*sum);
    let _e37 = term;
    (*sum).slope_z = (_e34.slope_z + (sqrt(power) * _e37.slope_z));
    let _e42 = (*sum);
    let _e44 = term;
    (*sum).removed = (_e42.removed + (power * _e44.removed));
    return;
}

// Directions evenly along a spiral over half the sphere. Their number is real and the last one has what is left of the
// power, so that all is continuous in frequency.
fn gabor_isotropic_3d(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d {
    var count: f32;
    var sum_8: GaborField3d = GaborField3d(vec2(0f), vec2(0f), vec2(0f), vec2(0f), 0f);
    var i_1: i32 = 0i;
    var share: f32;
    var z_2: f32;
    var direction_1: vec3<f32>;

    count = (8f + (8f * min((frequency * frequency), 64f)));
    loop {
        let _e24 = i_1;
        let _e25 = count;
        if !((_e24 < i32(ceil(_e25)))) {
            break;
        }
        {
            let _e33 = count;
            let _e34 = i_1;
            let _e39 = count;
            share = (min((_e33 - f32(_e34)), 1f) / _e39);
            let _e42 = i_1;
            let _e44 = count;
            let _e47 = share;
            z_2 = ((f32(_e42) / _e44) + (0.5f * _e47));
            let _e52 = z_2;
            let _e53 = z_2;
            let _e58 = i_1;
            let _e61 = gabor_impl_wave((0.618034f * f32(_e58)));
            let _e62 = (sqrt((1f - (_e52 * _e53))) * _e61);
            let _e63 = z_2;
            direction_1 = vec3<f32>(_e62.x, _e62.y, _e63);
            let _e69 = direction_1;
            let _e70 = gabor_wave_3d(frequency, _e69);
            let _e71 = i_1;
            let _e72 = share;
            gabor_impl_add_term((&sum_8), place, _e70, seed, _e71, _e72);
        }
        continuing {
            let _e30 = i_1;
            i_1 = (_e30 + 1i);
        }
    }
    let _e74 = sum_8;
    return _e74;
}

// The power of the first of two sums where it takes over from the second as x goes from `low` to `high`.
fn gabor_impl_takeover(low: f32, high: f32, x: f32) -> f32 {
    var share_1: f32;

    share_1 = smoothstep(low, high, x);
    let _e5 = share_1;
    let _e6 = share_1;
    let _e8 = share_1;
    let _e9 = share_1;
    let _e12 = share_1;
    let _e15 = share_1;
    return ((_e5 * _e6) / ((_e8 * _e9) + ((1f - _e12) * (1f - _e15))));
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
fn gabor_surface_3d(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var normal_1: vec3<f32>;
    var direction_3: vec3<f32>;
    var local_15: vec3<f32>;
    var other: vec3<f32>;
    var power_1: f32;
    var sum_9: GaborField3d = GaborField3d(vec2(0f), vec2(0f), vec2(0f), vec2(0f), 0f);

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
        local_15 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_15 = vec3<f32>(1f, 0f, 0f);
    }
    let _e26 = local_15;
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
    let _e45 = direction_3;
    let _e46 = direction_3;
    let _e48 = gabor_impl_takeover(0.0625f, 0.25f, dot(_e45, _e46));
    power_1 = _e48;
    let _e61 = power_1;
    if (_e61 > 0f) {
        let _e65 = direction_3;
        let _e66 = gabor_wave_3d(frequency, _e65);
        let _e68 = power_1;
        gabor_impl_add_term((&sum_9), place, _e66, seed, 0i, _e68);
    }
    let _e70 = power_1;
    if (_e70 < 1f) {
        let _e74 = other;
        let _e75 = gabor_wave_3d(frequency, _e74);
        let _e78 = power_1;
        gabor_impl_add_term((&sum_9), place, _e75, seed, 1i, (1f - _e78));
    }
    let _e81 = sum_9;
    return _e81;
}

// Directions evenly over half a turn from that of the parallel around an axis: z, and near its poles x.
fn gabor_surface_isotropic_3d(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_3: vec3<f32>;
    var count_1: f32;
    var power_2: f32;
    var sum_10: GaborField3d = GaborField3d(vec2(0f), vec2(0f), vec2(0f), vec2(0f), 0f);
    var axis_2: i32 = 0i;
    var local_16: vec3<f32>;
    var along: vec3<f32>;
    var i_2: i32;
    var share_2: f32;
    var turn_6: vec2<f32>;
    var direction_4: vec3<f32>;

    normal_3 = normal;
    let _e5 = normal_3;
    let _e6 = gabor_impl_unit(_e5);
    normal_3 = _e6;
    count_1 = (2f + (4.5f * min(abs(frequency), 32f)));
    let _e17 = normal_3;
    let _e19 = normal_3;
    let _e22 = gabor_impl_takeover(0.25f, 0.5f, dot(_e17.xy, _e19.xy));
    power_2 = _e22;
    loop {
        let _e37 = axis_2;
        if !((_e37 < 2i)) {
            break;
        }
        {
            let _e44 = axis_2;
            if (_e44 == 0i) {
                local_16 = vec3<f32>(0f, 0f, 1f);
            } else {
                local_16 = vec3<f32>(1f, 0f, 0f);
            }
            let _e56 = local_16;
            let _e57 = normal_3;
            let _e59 = gabor_impl_unit(cross(_e56, _e57));
            along = _e59;
            i_2 = 0i;
            loop {
                let _e63 = i_2;
                let _e64 = count_1;
                let _e68 = power_2;
                if !(((_e63 < i32(ceil(_e64))) && (_e68 > 0f))) {
                    break;
                }
                {
                    let _e76 = count_1;
                    let _e77 = i_2;
                    let _e82 = count_1;
                    share_2 = (min((_e76 - f32(_e77)), 1f) / _e82);
                    let _e86 = i_2;
                    let _e88 = count_1;
                    let _e91 = share_2;
                    let _e95 = gabor_impl_wave((0.5f * ((f32(_e86) / _e88) + (0.5f * _e91))));
                    turn_6 = _e95;
                    let _e97 = turn_6;
                    let _e99 = along;
                    let _e101 = turn_6;
                    let _e103 = normal_3;
                    let _e104 = along;
                    direction_4 = ((_e97.x * _e99) + (_e101.y * cross(_e103, _e104)));
                    let _e110 = direction_4;
                    let _e111 = gabor_wave_3d(frequency, _e110);
                    let _e113 = axis_2;
                    let _e115 = i_2;
                    let _e117 = power_2;
                    let _e118 = share_2;
                    gabor_impl_add_term((&sum_10), place, _e111, seed, ((256i * _e113) + _e115), (_e117 * _e118));
                }
                continuing {
                    let _e73 = i_2;
                    i_2 = (_e73 + 1i);
                }
            }
            let _e122 = power_2;
            power_2 = (1f - _e122);
        }
        continuing {
            let _e41 = axis_2;
            axis_2 = (_e41 + 1i);
        }
    }
    let _e124 = sum_10;
    return _e124;
}

// gabor_noise_3d with its quadrature, for gabor_phasor: see gabor_noise_complex.
fn gabor_noise_3d_complex(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_wave_3d(frequency, direction);
    let _e13 = gabor_field_3d(_e11, _e12, seed);
    return _e13.value;
}

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p          position in kernel radii, |p| < 2^31 / R; at 10^5 a float steps by 0.008
//   frequency  cycles per kernel radius; its magnitude is used, up to 10^6
//   direction  of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
//   seed       any; each seed is another instance, independent of the others
// Where frequency and direction vary continuously so does the noise; a slope of theirs adds to that of the noise.
fn gabor_noise_3d(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e4 = gabor_noise_3d_complex(p, frequency, direction, seed);
    return _e4.y;
}

// The noise at p and its gradient: (noise, d/dx, d/dy, d/dz), per kernel radius. For bumps take away the part along the
// normal.
fn gabor_noise_3d_gradient(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec4<f32> {
    var place_14: GaborPlace3d;
    var field_1: GaborField3d;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_14 = _e11;
    let _e13 = place_14;
    let _e14 = gabor_wave_3d(frequency, direction);
    let _e15 = gabor_field_3d(_e13, _e14, seed);
    field_1 = _e15;
    let _e17 = field_1;
    let _e20 = field_1;
    let _e23 = field_1;
    let _e26 = field_1;
    return vec4<f32>(_e17.value.y, _e20.slope_x.y, _e23.slope_y.y, _e26.slope_z.y);
}

// Four noises at p, independent of each other; the first is gabor_noise_3d.
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

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
fn gabor_noise_3d_tiled(p: vec3<f32>, period: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var period_5: vec3<f32>;
    var nodes_1: vec3<f32>;
    var place_15: GaborPlace3d;

    period_5 = period;
    let _e6 = period_5;
    period_5 = max(_e6, vec3(0.0009765625f));
    let _e10 = period_5;
    nodes_1 = max(floor(((_e10 * 1.5f) + vec3(0.5f))), vec3(3f));
    let _e26 = period_5;
    let _e29 = period_5;
    let _e32 = nodes_1;
    let _e33 = period_5;
    let _e36 = gabor_place_3d(vec3(0i), ((p - (floor((p / _e26)) * _e29)) * (_e32 / _e33)));
    place_15 = _e36;
    let _e39 = nodes_1;
    let _e40 = period_5;
    place_15.radius = (_e39 / _e40);
    let _e43 = nodes_1;
    place_15.period = vec3<i32>(_e43);
    let _e45 = place_15;
    let _e46 = gabor_wave_3d(frequency, direction);
    let _e47 = gabor_field_3d(_e45, _e46, seed);
    return _e47.value.y;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
fn gabor_noise_3d_animated(p: vec3<f32>, time: f32, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var place_16: GaborPlace3d;

    let _e12 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_16 = _e12;
    place_16.animated = true;
    place_16.time = time;
    let _e17 = place_16;
    let _e18 = gabor_wave_3d(frequency, direction);
    let _e19 = gabor_field_3d(_e17, _e18, seed);
    return _e19.value.y;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
fn gabor_noise_3d_filtered(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var place_17: GaborPlace3d;
    var field_2: GaborField3d;

    let _e13 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_17 = _e13;
    place_17.filtered = true;
    place_17.dx = dx;
    place_17.dy = dy;
    let _e19 = place_17;
    let _e20 = gabor_wave_3d(frequency, direction);
    let _e21 = gabor_field_3d(_e19, _e20, seed);
    field_2 = _e21;
    let _e23 = field_2;
    let _e26 = field_2;
    return vec2<f32>(_e23.value.y, _e26.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 of them.
fn gabor_noise_3d_isotropic(p: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e10 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e11 = gabor_isotropic_3d(_e10, frequency, seed);
    return _e11.value.y;
}

// Noise on a surface at its point p, whose normal has any length but 0, its waves along the projection of a direction.
// The frequency is as asked for where the surface is flat; where it is curved the waves of a kernel bend.
fn gabor_noise_surface(p: vec3<f32>, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e12 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e13 = gabor_surface_3d(_e12, normal, frequency, direction, seed);
    return _e13.value.y;
}

// Noise on a surface along all directions of its tangent plane: a sum of 2 + 4.5 F, of twice as many between two axes.
fn gabor_noise_surface_isotropic(p: vec3<f32>, normal: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_surface_isotropic_3d(_e11, normal, frequency, seed);
    return _e12.value.y;
}
