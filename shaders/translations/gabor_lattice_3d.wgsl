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
    channel: i32,
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

// Three times three complex numbers.
struct GaborMatrix {
    real: mat3x3<f32>,
    imaginary: mat3x3<f32>,
}

fn gabor_impl_matrix_product(m: GaborMatrix, n: GaborMatrix) -> GaborMatrix {
    return GaborMatrix(((m.real * n.real) - (m.imaginary * n.imaginary)), ((m.real * n.imaginary) + (m.imaginary * n.real)));
}

fn gabor_impl_amplitude_3d(word: u32, place: GaborPlace3d) -> vec2<f32> {
    var word_9: u32;
    var i: i32 = 0i;

    word_9 = word;
    loop {
        let _e5 = i;
        if !((_e5 < place.channel)) {
            break;
        }
        let _e12 = word_9;
        let _e13 = gabor_impl_next_word(_e12);
        word_9 = _e13;
        continuing {
            let _e9 = i;
            i = (_e9 + 1i);
        }
    }
    let _e14 = word_9;
    let _e17 = gabor_impl_wave(place.time);
    let _e18 = gabor_impl_amplitude_at(_e14, place.animated, _e17);
    return _e18;
}

// The word of a row of a slice of nodes, odd and of 24 bits, as those of lines are.
fn gabor_impl_slice_word(row: u32, slice: u32) -> u32 {
    return (((row * slice) >> 8u) | 8388609u);
}

// The amplitudes of a slice, a column for each row.
fn gabor_impl_slice(columns: vec4<u32>, rows: vec4<u32>, slice: u32, place: GaborPlace3d) -> GaborMatrix {
    var m_1: GaborMatrix;
    var j: i32 = 0i;
    var row_4: u32;
    var a_4: vec2<f32>;
    var b_4: vec2<f32>;
    var c_3: vec2<f32>;

    loop {
        let _e7 = j;
        if !((_e7 < 3i)) {
            break;
        }
        {
            let _e14 = j;
            let _e16 = gabor_impl_slice_word(rows[_e14], slice);
            row_4 = _e16;
            let _e19 = row_4;
            let _e20 = gabor_impl_node_word(columns.x, _e19);
            let _e21 = gabor_impl_amplitude_3d(_e20, place);
            a_4 = _e21;
            let _e24 = row_4;
            let _e25 = gabor_impl_node_word(columns.y, _e24);
            let _e26 = gabor_impl_amplitude_3d(_e25, place);
            b_4 = _e26;
            let _e29 = row_4;
            let _e30 = gabor_impl_node_word(columns.z, _e29);
            let _e31 = gabor_impl_amplitude_3d(_e30, place);
            c_3 = _e31;
            let _e33 = j;
            let _e36 = a_4;
            let _e38 = b_4;
            let _e40 = c_3;
            m_1.real[_e33] = vec3<f32>(_e36.x, _e38.x, _e40.x);
            let _e43 = j;
            let _e46 = a_4;
            let _e48 = b_4;
            let _e50 = c_3;
            m_1.imaginary[_e43] = vec3<f32>(_e46.y, _e48.y, _e50.y);
        }
        continuing {
            let _e11 = j;
            j = (_e11 + 1i);
        }
    }
    let _e53 = m_1;
    return _e53;
}

// The nodes that reach a place: by axis, and their amplitudes by slice.
struct GaborNodes3d {
    x: GaborAxis,
    y: GaborAxis,
    z: GaborAxis,
    a: GaborMatrix,
    b: GaborMatrix,
    c: GaborMatrix,
    offset: vec3<f32>,
    turns: vec3<f32>,
    base: vec2<f32>,
}

fn gabor_impl_nodes(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborNodes3d {
    var n_1: GaborNodes3d;
    var first_2: vec3<f32>;
    var node_1: vec3<i32>;
    var salt_4: u32;
    var none_1: GaborWindows = GaborWindows(vec4(0f), vec4(0f));

    first_2 = (floor((place.local - vec3(1.5f))) + vec3(1f));
    let _e17 = first_2;
    node_1 = (place.cell + vec3<i32>(_e17));
    let _e21 = gabor_impl_salt(seed);
    salt_4 = _e21;
    let _e25 = first_2;
    n_1.offset = ((place.local - _e25) - vec3(1f));
    n_1.turns = (wave / place.radius);
    let _e40 = node_1;
    let _e44 = salt_4;
    let _e45 = n_1;
    let _e48 = gabor_impl_wave(_e45.turns.x);
    let _e49 = n_1;
    let _e52 = gabor_impl_windows(_e49.offset.x);
    let _e53 = none_1;
    let _e54 = gabor_impl_axis(_e40.x, place.period.x, _e44, _e48, _e52, _e53);
    n_1.x = _e54;
    let _e56 = node_1;
    let _e60 = salt_4;
    let _e63 = n_1;
    let _e66 = gabor_impl_wave(_e63.turns.y);
    let _e67 = n_1;
    let _e70 = gabor_impl_windows(_e67.offset.y);
    let _e71 = none_1;
    let _e72 = gabor_impl_axis(_e56.y, place.period.y, (_e60 ^ 1540483477u), _e66, _e70, _e71);
    n_1.y = _e72;
    let _e74 = node_1;
    let _e78 = salt_4;
    let _e81 = n_1;
    let _e84 = gabor_impl_wave(_e81.turns.z);
    let _e85 = n_1;
    let _e88 = gabor_impl_windows(_e85.offset.z);
    let _e89 = none_1;
    let _e90 = gabor_impl_axis(_e74.z, place.period.z, (_e78 ^ 668265263u), _e84, _e88, _e89);
    n_1.z = _e90;
    let _e92 = n_1;
    let _e95 = n_1;
    let _e98 = n_1;
    let _e102 = gabor_impl_slice(_e92.x.word, _e95.y.word, _e98.z.word.x, place);
    n_1.a = _e102;
    let _e104 = n_1;
    let _e107 = n_1;
    let _e110 = n_1;
    let _e114 = gabor_impl_slice(_e104.x.word, _e107.y.word, _e110.z.word.y, place);
    n_1.b = _e114;
    let _e116 = n_1;
    let _e119 = n_1;
    let _e122 = n_1;
    let _e126 = gabor_impl_slice(_e116.x.word, _e119.y.word, _e122.z.word.z, place);
    n_1.c = _e126;
    let _e134 = n_1;
    let _e136 = n_1;
    let _e139 = gabor_impl_wave(dot(_e134.turns, _e136.offset));
    n_1.base = (0.00000000000000000000000000057402616f * _e139);
    let _e141 = n_1;
    return _e141;
}

// From sums over nodes to those with factors: each column of a matrix has an axis' three. First along x and y, slice by
// slice; then along z for column `j` of those along y, with columns for z.
fn gabor_impl_along_xy(n: ptr<function, GaborNodes3d>, x: GaborMatrix, y: GaborMatrix) {
    var x_2: GaborMatrix;

    x_2 = x;
    let _e4 = x_2;
    let _e7 = x_2;
    x_2 = GaborMatrix(transpose(_e4.real), transpose(_e7.imaginary));
    let _e12 = x_2;
    let _e13 = (*n);
    let _e15 = gabor_impl_matrix_product(_e12, _e13.a);
    let _e16 = gabor_impl_matrix_product(_e15, y);
    (*n).a = _e16;
    let _e18 = x_2;
    let _e19 = (*n);
    let _e21 = gabor_impl_matrix_product(_e18, _e19.b);
    let _e22 = gabor_impl_matrix_product(_e21, y);
    (*n).b = _e22;
    let _e24 = x_2;
    let _e25 = (*n);
    let _e27 = gabor_impl_matrix_product(_e24, _e25.c);
    let _e28 = gabor_impl_matrix_product(_e27, y);
    (*n).c = _e28;
    return;
}

fn gabor_impl_along_z(n: GaborNodes3d, j: i32, z: GaborMatrix) -> GaborMatrix {
    let _e48 = gabor_impl_matrix_product(GaborMatrix(mat3x3<f32>(vec3<f32>(n.a.real[j].x, n.a.real[j].y, n.a.real[j].z), vec3<f32>(n.b.real[j].x, n.b.real[j].y, n.b.real[j].z), vec3<f32>(n.c.real[j].x, n.c.real[j].y, n.c.real[j].z)), mat3x3<f32>(vec3<f32>(n.a.imaginary[j].x, n.a.imaginary[j].y, n.a.imaginary[j].z), vec3<f32>(n.b.imaginary[j].x, n.b.imaginary[j].y, n.b.imaginary[j].z), vec3<f32>(n.c.imaginary[j].x, n.c.imaginary[j].y, n.c.imaginary[j].z))), z);
    return _e48;
}

// An axis' factors and their derivatives.
fn gabor_impl_factors_3d(axis: GaborAxis) -> GaborMatrix {
    let _e2 = axis.real.xyz;
    let _e4 = axis.slope_real.xyz;
    let _e18 = axis.imaginary.xyz;
    let _e20 = axis.slope_imaginary.xyz;
    return GaborMatrix(mat3x3<f32>(vec3<f32>(_e2.x, _e2.y, _e2.z), vec3<f32>(_e4.x, _e4.y, _e4.z), vec3<f32>(0f, 0f, 0f)), mat3x3<f32>(vec3<f32>(_e18.x, _e18.y, _e18.z), vec3<f32>(_e20.x, _e20.y, _e20.z), vec3<f32>(0f, 0f, 0f)));
}

fn gabor_impl_windowed(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborField3d {
    var n_4: GaborNodes3d;
    var values: GaborMatrix;
    var slopes: GaborMatrix;
    var value_2: vec2<f32>;
    var slope_x: vec2<f32>;
    var slope_y: vec2<f32>;
    var slope_z: vec2<f32>;
    var turned_1: vec2<f32>;
    var stretch_1: vec3<f32>;

    let _e3 = gabor_impl_nodes(place, wave, seed);
    n_4 = _e3;
    let _e6 = n_4;
    let _e8 = gabor_impl_factors_3d(_e6.x);
    let _e9 = n_4;
    let _e11 = gabor_impl_factors_3d(_e9.y);
    gabor_impl_along_xy((&n_4), _e8, _e11);
    let _e13 = n_4;
    let _e15 = n_4;
    let _e17 = gabor_impl_factors_3d(_e15.z);
    let _e18 = gabor_impl_along_z(_e13, 0i, _e17);
    values = _e18;
    let _e20 = n_4;
    let _e22 = n_4;
    let _e24 = gabor_impl_factors_3d(_e22.z);
    let _e25 = gabor_impl_along_z(_e20, 1i, _e24);
    slopes = _e25;
    let _e27 = n_4;
    let _e32 = values.real[0];
    let _e37 = values.imaginary[0];
    let _e40 = gabor_impl_product(_e27.base, vec2<f32>(_e32.x, _e37.x));
    value_2 = _e40;
    let _e42 = n_4;
    let _e47 = values.real[0];
    let _e52 = values.imaginary[0];
    let _e55 = gabor_impl_product(_e42.base, vec2<f32>(_e47.y, _e52.y));
    slope_x = _e55;
    let _e57 = n_4;
    let _e62 = slopes.real[0];
    let _e67 = slopes.imaginary[0];
    let _e70 = gabor_impl_product(_e57.base, vec2<f32>(_e62.x, _e67.x));
    slope_y = _e70;
    let _e72 = n_4;
    let _e77 = values.real[1];
    let _e82 = values.imaginary[1];
    let _e85 = gabor_impl_product(_e72.base, vec2<f32>(_e77.x, _e82.x));
    slope_z = _e85;
    let _e88 = value_2;
    let _e91 = value_2;
    turned_1 = (6.2831855f * vec2<f32>(-(_e88.y), _e91.x));
    stretch_1 = (place.radius / vec3(1.5f));
    let _e104 = value_2;
    let _e105 = stretch_1;
    let _e107 = slope_x;
    let _e110 = turned_1;
    let _e113 = stretch_1;
    let _e115 = slope_y;
    let _e118 = turned_1;
    let _e121 = stretch_1;
    let _e123 = slope_z;
    let _e126 = turned_1;
    return GaborField3d(_e104, ((_e105.x * _e107) + (wave.x * _e110)), ((_e113.y * _e115) + (wave.y * _e118)), ((_e121.z * _e123) + (wave.z * _e126)), 0f);
}

// What an axis' three nodes add to the three waves that they are together between nodes:
//     h(x - c) e^(2 pi i F (x - c)) = sum_a h_a e^(2 pi i (F + a/2) (x - c)),   a = -1, 0, 1,   h_a = 1/4, 1/2, 1/4.
// Within half a deviation of the filter from its window's end a node fades, so that nothing jumps.
fn gabor_impl_waves(offset: f32, turns: f32, deviation: f32) -> GaborMatrix {
    var d_1: vec3<f32>;
    var step_2: vec2<f32>;
    var reach: vec3<f32>;
    var real_2: vec3<f32>;
    var imaginary_2: vec3<f32>;
    var turn_1: vec2<f32>;
    var c_4: vec3<f32>;
    var s_2: vec3<f32>;

    d_1 = ((vec3(offset) + vec3<f32>(1f, 0f, -1f)) / vec3(1.5f));
    let _e17 = gabor_impl_wave(turns);
    step_2 = _e17;
    let _e20 = d_1;
    reach = clamp(((vec3(1f) - abs(_e20)) / vec3(max((0.5f * deviation), 0.000001f))), vec3(0f), vec3(1f));
    let _e36 = reach;
    let _e38 = reach;
    let _e42 = reach;
    reach = (_e36 * ((0.5f * _e38) * (vec3(3f) - (2f * _e42))));
    let _e48 = reach;
    let _e49 = step_2;
    let _e52 = step_2;
    real_2 = (_e48 * vec3<f32>(_e49.x, 1f, _e52.x));
    let _e57 = reach;
    let _e58 = step_2;
    let _e61 = step_2;
    imaginary_2 = (_e57 * vec3<f32>(_e58.y, 0f, -(_e61.y)));
    let _e69 = d_1;
    let _e72 = gabor_impl_wave((0.5f * _e69.y));
    turn_1 = (0.5f * _e72);
    let _e75 = turn_1;
    let _e84 = turn_1;
    c_4 = ((_e75.x * vec3<f32>(-0.5f, 1f, -0.5f)) + (_e84.y * vec3<f32>(-0.8660254f, 0f, 0.8660254f)));
    let _e94 = turn_1;
    let _e103 = turn_1;
    s_2 = ((_e94.y * vec3<f32>(-0.5f, 1f, -0.5f)) - (_e103.x * vec3<f32>(-0.8660254f, 0f, 0.8660254f)));
    let _e113 = real_2;
    let _e114 = c_4;
    let _e116 = imaginary_2;
    let _e117 = s_2;
    let _e119 = ((_e113 * _e114) + (_e116 * _e117));
    let _e120 = real_2;
    let _e121 = real_2;
    let _e122 = c_4;
    let _e124 = imaginary_2;
    let _e125 = s_2;
    let _e127 = ((_e121 * _e122) - (_e124 * _e125));
    let _e141 = imaginary_2;
    let _e142 = c_4;
    let _e144 = real_2;
    let _e145 = s_2;
    let _e147 = ((_e141 * _e142) - (_e144 * _e145));
    let _e148 = imaginary_2;
    let _e149 = imaginary_2;
    let _e150 = c_4;
    let _e152 = real_2;
    let _e153 = s_2;
    let _e155 = ((_e149 * _e150) + (_e152 * _e153));
    return GaborMatrix(mat3x3<f32>(vec3<f32>(_e119.x, _e119.y, _e119.z), vec3<f32>(_e120.x, _e120.y, _e120.z), vec3<f32>(_e127.x, _e127.y, _e127.z)), mat3x3<f32>(vec3<f32>(_e147.x, _e147.y, _e147.z), vec3<f32>(_e148.x, _e148.y, _e148.z), vec3<f32>(_e155.x, _e155.y, _e155.z)));
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: (det(1 + S^2))^(-1/4).
fn gabor_impl_filtered(place: GaborPlace3d, wave: vec3<f32>, seed: u32) -> GaborField3d {
    var dx: vec3<f32>;
    var dy: vec3<f32>;
    var stretch_2: vec3<f32>;
    var deviation_1: vec3<f32>;
    var n_5: GaborNodes3d;
    var z_1: GaborMatrix;
    var sum_3: vec2<f32> = vec2(0f);
    var slope_x_1: vec2<f32> = vec2(0f);
    var slope_y_1: vec2<f32> = vec2(0f);
    var slope_z_1: vec2<f32> = vec2(0f);
    var kept: f32 = 0f;
    var b_5: i32 = 0i;
    var m_2: GaborMatrix;
    var c_5: i32;
    var a_5: i32;
    var aside: vec3<f32>;
    var k_2: vec3<f32>;
    var left: f32;
    var value_3: vec2<f32>;
    var trace: f32;
    var determinant_: f32;
    var fade: f32;
    var base_1: vec2<f32>;

    dx = clamp(place.dx, vec3(-1000000f), vec3(1000000f));
    dy = clamp(place.dy, vec3(-1000000f), vec3(1000000f));
    stretch_2 = (place.radius / vec3(1.5f));
    let _e28 = stretch_2;
    let _e30 = dx;
    let _e31 = dx;
    let _e33 = dy;
    let _e34 = dy;
    deviation_1 = ((0.5f * _e28) * sqrt(((_e30 * _e31) + (_e33 * _e34))));
    let _e40 = gabor_impl_nodes(place, wave, seed);
    n_5 = _e40;
    let _e43 = n_5;
    let _e46 = n_5;
    let _e49 = deviation_1;
    let _e51 = gabor_impl_waves(_e43.offset.x, _e46.turns.x, _e49.x);
    let _e52 = n_5;
    let _e55 = n_5;
    let _e58 = deviation_1;
    let _e60 = gabor_impl_waves(_e52.offset.y, _e55.turns.y, _e58.y);
    gabor_impl_along_xy((&n_5), _e51, _e60);
    let _e62 = n_5;
    let _e65 = n_5;
    let _e68 = deviation_1;
    let _e70 = gabor_impl_waves(_e62.offset.z, _e65.turns.z, _e68.z);
    z_1 = _e70;
    loop {
        let _e88 = b_5;
        if !((_e88 < 3i)) {
            break;
        }
        {
            let _e95 = n_5;
            let _e96 = b_5;
            let _e97 = z_1;
            let _e98 = gabor_impl_along_z(_e95, _e96, _e97);
            m_2 = _e98;
            c_5 = 0i;
            loop {
                let _e102 = c_5;
                if !((_e102 < 3i)) {
                    break;
                }
                {
                    a_5 = 0i;
                    loop {
                        let _e111 = a_5;
                        if !((_e111 < 3i)) {
                            break;
                        }
                        {
                            let _e118 = a_5;
                            let _e122 = b_5;
                            let _e126 = c_5;
                            aside = vec3<f32>(f32((_e118 - 1i)), f32((_e122 - 1i)), f32((_e126 - 1i)));
                            let _e133 = stretch_2;
                            let _e135 = aside;
                            k_2 = (wave + ((0.5f * _e133) * _e135));
                            let _e141 = k_2;
                            let _e142 = dx;
                            let _e144 = k_2;
                            let _e145 = dx;
                            let _e148 = k_2;
                            let _e149 = dy;
                            let _e151 = k_2;
                            let _e152 = dy;
                            left = exp((-4.934802f * ((dot(_e141, _e142) * dot(_e144, _e145)) + (dot(_e148, _e149) * dot(_e151, _e152)))));
                            let _e159 = left;
                            let _e160 = a_5;
                            let _e161 = c_5;
                            let _e165 = m_2.real[_e161][_e160];
                            let _e166 = a_5;
                            let _e167 = c_5;
                            let _e171 = m_2.imaginary[_e167][_e166];
                            value_3 = (_e159 * vec2<f32>(_e165, _e171));
                            let _e175 = sum_3;
                            let _e176 = value_3;
                            sum_3 = (_e175 + _e176);
                            let _e178 = slope_x_1;
                            let _e179 = k_2;
                            let _e181 = value_3;
                            let _e184 = value_3;
                            slope_x_1 = (_e178 + (_e179.x * vec2<f32>(-(_e181.y), _e184.x)));
                            let _e189 = slope_y_1;
                            let _e190 = k_2;
                            let _e192 = value_3;
                            let _e195 = value_3;
                            slope_y_1 = (_e189 + (_e190.y * vec2<f32>(-(_e192.y), _e195.x)));
                            let _e200 = slope_z_1;
                            let _e201 = k_2;
                            let _e203 = value_3;
                            let _e206 = value_3;
                            slope_z_1 = (_e200 + (_e201.z * vec2<f32>(-(_e203.y), _e206.x)));
                            let _e211 = kept;
                            let _e212 = left;
                            let _e213 = left;
                            let _e217 = aside;
                            let _e218 = aside;
                            kept = (_e211 + ((_e212 * _e213) * exp2((-2f * dot(_e217, _e218)))));
                        }
                        continuing {
                            let _e115 = a_5;
                            a_5 = (_e115 + 1i);
                        }
                    }
                }
                continuing {
                    let _e106 = c_5;
                    c_5 = (_e106 + 1i);
                }
            }
        }
        continuing {
            let _e92 = b_5;
            b_5 = (_e92 + 1i);
        }
    }
    let _e225 = dx;
    let _e226 = dx;
    let _e228 = dy;
    let _e229 = dy;
    trace = (0.25f * (dot(_e225, _e226) + dot(_e228, _e229)));
    let _e235 = dx;
    let _e236 = dy;
    let _e238 = dx;
    let _e239 = dy;
    determinant_ = (0.0625f * dot(cross(_e235, _e236), cross(_e238, _e239)));
    let _e245 = trace;
    let _e246 = trace;
    let _e249 = determinant_;
    let _e250 = determinant_;
    fade = inverseSqrt(sqrt(max(((1f + (_e245 * _e246)) + (_e249 * (_e250 - 2f))), 1f)));
    let _e260 = fade;
    let _e261 = n_5;
    base_1 = (_e260 * _e261.base);
    let _e265 = base_1;
    let _e266 = sum_3;
    let _e267 = gabor_impl_product(_e265, _e266);
    let _e268 = base_1;
    let _e270 = slope_x_1;
    let _e272 = gabor_impl_product(_e268, (6.2831855f * _e270));
    let _e273 = base_1;
    let _e275 = slope_y_1;
    let _e277 = gabor_impl_product(_e273, (6.2831855f * _e275));
    let _e278 = base_1;
    let _e280 = slope_z_1;
    let _e282 = gabor_impl_product(_e278, (6.2831855f * _e280));
    let _e284 = fade;
    let _e285 = fade;
    let _e291 = kept;
    return GaborField3d(_e267, _e272, _e277, _e282, (1f - (((_e284 * _e285) * 0.2962963f) * _e291)));
}

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
fn gabor_place_3d(cell: vec3<i32>, local: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3(1.5f), vec3(0i), false, 0f, false, vec3(0f), vec3(0f), 0i);
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

fn gabor_impl_channel(place: GaborPlace3d, wave: vec3<f32>, seed: u32, channel: i32) -> f32 {
    var place_11: GaborPlace3d;

    place_11 = place;
    place_11.channel = channel;
    let _e6 = place_11;
    let _e7 = gabor_field_3d(_e6, wave, seed);
    return _e7.value.y;
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
    var sum_5: GaborField3d = GaborField3d(vec2(0f), vec2(0f), vec2(0f), vec2(0f), 0f);
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
            gabor_impl_add_term((&sum_5), place, _e70, seed, _e71, _e72);
        }
        continuing {
            let _e30 = i_1;
            i_1 = (_e30 + 1i);
        }
    }
    let _e74 = sum_5;
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
    var local_8: vec3<f32>;
    var other: vec3<f32>;
    var power_1: f32;
    var sum_6: GaborField3d = GaborField3d(vec2(0f), vec2(0f), vec2(0f), vec2(0f), 0f);

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
        local_8 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_8 = vec3<f32>(1f, 0f, 0f);
    }
    let _e26 = local_8;
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
        gabor_impl_add_term((&sum_6), place, _e66, seed, 0i, _e68);
    }
    let _e70 = power_1;
    if (_e70 < 1f) {
        let _e74 = other;
        let _e75 = gabor_wave_3d(frequency, _e74);
        let _e78 = power_1;
        gabor_impl_add_term((&sum_6), place, _e75, seed, 1i, (1f - _e78));
    }
    let _e81 = sum_6;
    return _e81;
}

// Directions evenly over half a turn from that of the parallel around an axis: z, and near its poles x.
fn gabor_surface_isotropic_3d(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_3: vec3<f32>;
    var count_1: f32;
    var power_2: f32;
    var sum_7: GaborField3d = GaborField3d(vec2(0f), vec2(0f), vec2(0f), vec2(0f), 0f);
    var axis_1: i32 = 0i;
    var local_9: vec3<f32>;
    var along: vec3<f32>;
    var i_2: i32;
    var share_2: f32;
    var turn_2: vec2<f32>;
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
        let _e37 = axis_1;
        if !((_e37 < 2i)) {
            break;
        }
        {
            let _e44 = axis_1;
            if (_e44 == 0i) {
                local_9 = vec3<f32>(0f, 0f, 1f);
            } else {
                local_9 = vec3<f32>(1f, 0f, 0f);
            }
            let _e56 = local_9;
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
                    turn_2 = _e95;
                    let _e97 = turn_2;
                    let _e99 = along;
                    let _e101 = turn_2;
                    let _e103 = normal_3;
                    let _e104 = along;
                    direction_4 = ((_e97.x * _e99) + (_e101.y * cross(_e103, _e104)));
                    let _e110 = direction_4;
                    let _e111 = gabor_wave_3d(frequency, _e110);
                    let _e113 = axis_1;
                    let _e115 = i_2;
                    let _e117 = power_2;
                    let _e118 = share_2;
                    gabor_impl_add_term((&sum_7), place, _e111, seed, ((256i * _e113) + _e115), (_e117 * _e118));
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
            let _e41 = axis_1;
            axis_1 = (_e41 + 1i);
        }
    }
    let _e124 = sum_7;
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
    var place_16: GaborPlace3d;
    var field_1: GaborField3d;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_16 = _e11;
    let _e13 = place_16;
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
    var place_17: GaborPlace3d;
    var wave_7: vec3<f32>;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_17 = _e11;
    let _e13 = gabor_wave_3d(frequency, direction);
    wave_7 = _e13;
    let _e15 = place_17;
    let _e16 = wave_7;
    let _e18 = gabor_impl_channel(_e15, _e16, seed, 0i);
    let _e19 = place_17;
    let _e20 = wave_7;
    let _e22 = gabor_impl_channel(_e19, _e20, seed, 1i);
    let _e23 = place_17;
    let _e24 = wave_7;
    let _e26 = gabor_impl_channel(_e23, _e24, seed, 2i);
    let _e27 = place_17;
    let _e28 = wave_7;
    let _e30 = gabor_impl_channel(_e27, _e28, seed, 3i);
    return vec4<f32>(_e18, _e22, _e26, _e30);
}

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
fn gabor_noise_3d_tiled(p: vec3<f32>, period: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var period_5: vec3<f32>;
    var nodes_1: vec3<f32>;
    var place_18: GaborPlace3d;

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
    place_18 = _e36;
    let _e39 = nodes_1;
    let _e40 = period_5;
    place_18.radius = (_e39 / _e40);
    let _e43 = nodes_1;
    place_18.period = vec3<i32>(_e43);
    let _e45 = place_18;
    let _e46 = gabor_wave_3d(frequency, direction);
    let _e47 = gabor_field_3d(_e45, _e46, seed);
    return _e47.value.y;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
fn gabor_noise_3d_animated(p: vec3<f32>, time: f32, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var place_19: GaborPlace3d;

    let _e12 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_19 = _e12;
    place_19.animated = true;
    place_19.time = time;
    let _e17 = place_19;
    let _e18 = gabor_wave_3d(frequency, direction);
    let _e19 = gabor_field_3d(_e17, _e18, seed);
    return _e19.value.y;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
fn gabor_noise_3d_filtered(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var place_20: GaborPlace3d;
    var field_2: GaborField3d;

    let _e13 = gabor_place_3d(vec3(0i), (p * 1.5f));
    place_20 = _e13;
    place_20.filtered = true;
    place_20.dx = dx;
    place_20.dy = dy;
    let _e19 = place_20;
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
