// gabor_lattice_3d.wgsl: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.wgsl; every name that it adds begins with gabor_, Gabor or GABOR_: for WGSL.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate and naga 30.0.1: change that file, not this one. Paste or include it after gabor_lattice.wgsl.
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

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
fn gabor_place_3d(cell: vec3<i32>, local: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3(1.5f), vec3(0i), false, 0f, false, vec3(0f), vec3(0f));
}

// The noise and its quadrature, each with its gradient per kernel radius. Apart, so that compilers drop unused ones.
struct GaborField3d {
    noise: f32,
    gradient: vec3<f32>,
    quadrature: f32,
    quadrature_gradient: vec3<f32>,
    removed: f32,
}

// The word of a row in a slice of nodes: odd and of 24 bits, as those of lines are.
fn gabor_impl_slice_word(row: u32, slice: u32) -> u32 {
    return (((row * slice) >> 8u) | 8388609u);
}

// A complex number for each of 27 nodes or waves, in the order of three indices.
struct GaborCube {
    number: array<vec2<f32>, 27>,
}

// Takes the first index from the nodes along an axis to the three waves that they are together between nodes, and makes
// it the last: for a = -1, 0, 1 a node adds e^(pi i a d) / 4 = (h - 1/2 - i a h' / pi) / 2, 1/2 and again the first of
// its window h(d). Within half a deviation of the filter from the window's end it fades, so that nothing jumps.
fn gabor_impl_to_waves(nodes: GaborCube, axis: GaborAxis, deviation: f32) -> GaborCube {
    var value_4: vec4<f32>;
    var slope_6: vec4<f32>;
    var phase_1: array<vec2<f32>, 3>;
    var i: i32 = 0i;
    var inside: f32;
    var fade: f32;
    var waves: GaborCube;
    var n: i32 = 0i;
    var mean: vec2<f32>;
    var even: vec2<f32>;
    var odd: vec2<f32>;
    var i_1: i32;
    var node: vec2<f32>;

    gabor_impl_windows(axis.offset, (&value_4), (&slope_6));
    loop {
        let _e13 = i;
        if !((_e13 < 3i)) {
            break;
        }
        {
            let _e24 = i;
            inside = (1f - (abs(((axis.offset + 1f) - f32(_e24))) / 1.5f));
            let _e40 = inside;
            fade = smoothstep(0f, max((0.5f * deviation), 0.000001f), _e40);
            let _e43 = i;
            let _e46 = fade;
            let _e49 = i;
            let _e54 = gabor_impl_wave((f32((1i - _e49)) * axis.turns));
            phase_1[_e43] = ((0.5f * _e46) * _e54);
        }
        continuing {
            let _e17 = i;
            i = (_e17 + 1i);
        }
    }
    loop {
        let _e59 = n;
        if !((_e59 < 9i)) {
            break;
        }
        {
            mean = vec2(0f);
            even = vec2(0f);
            odd = vec2(0f);
            i_1 = 0i;
            loop {
                let _e77 = i_1;
                if !((_e77 < 3i)) {
                    break;
                }
                {
                    let _e85 = i_1;
                    let _e87 = n;
                    let _e91 = i_1;
                    let _e93 = phase_1[_e91];
                    let _e94 = gabor_impl_product(nodes.number[((9i * _e85) + _e87)], _e93);
                    node = _e94;
                    let _e96 = mean;
                    let _e97 = node;
                    mean = (_e96 + _e97);
                    let _e99 = even;
                    let _e100 = i_1;
                    let _e102 = value_4[_e100];
                    let _e105 = node;
                    even = (_e99 + ((_e102 - 0.5f) * _e105));
                    let _e108 = odd;
                    let _e110 = i_1;
                    let _e112 = slope_6[_e110];
                    let _e114 = node;
                    let _e116 = node;
                    odd = (_e108 + ((0.3183099f * _e112) * vec2<f32>(_e114.y, -(_e116.x))));
                }
                continuing {
                    let _e81 = i_1;
                    i_1 = (_e81 + 1i);
                }
            }
            let _e123 = n;
            let _e127 = even;
            let _e128 = odd;
            waves.number[(3i * _e123)] = (_e127 - _e128);
            let _e131 = n;
            let _e137 = mean;
            waves.number[((3i * _e131) + 1i)] = _e137;
            let _e139 = n;
            let _e145 = even;
            let _e146 = odd;
            waves.number[((3i * _e139) + 2i)] = (_e145 + _e146);
        }
        continuing {
            let _e63 = n;
            n = (_e63 + 1i);
        }
    }
    let _e148 = waves;
    return _e148;
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: |det(1 + i S)|^(-1/2).
fn gabor_impl_filtered(place: GaborPlace3d, wave: vec3<f32>, x: GaborAxis, y: GaborAxis, z: GaborAxis, turn: vec2<f32>) -> GaborField3d {
    var dx: vec3<f32>;
    var dy: vec3<f32>;
    var trace: f32;
    var determinant_: f32;
    var fade_1: f32;
    var spacing: vec3<f32>;
    var cube: GaborCube;
    var n_1: i32 = 0i;
    var row_2: u32;
    var sum_4: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 1f);
    var n_2: i32 = 0i;
    var aside: vec3<f32>;
    var k: vec3<f32>;
    var left: f32;
    var value_5: vec2<f32>;

    dx = clamp(place.dx, vec3(-1000000f), vec3(1000000f));
    dy = clamp(place.dy, vec3(-1000000f), vec3(1000000f));
    let _e23 = dx;
    let _e24 = dx;
    let _e26 = dy;
    let _e27 = dy;
    trace = (0.25f * (dot(_e23, _e24) + dot(_e26, _e27)));
    let _e33 = dx;
    let _e34 = dy;
    let _e36 = dx;
    let _e37 = dy;
    determinant_ = (0.0625f * dot(cross(_e33, _e34), cross(_e36, _e37)));
    let _e42 = trace;
    let _e44 = determinant_;
    fade_1 = inverseSqrt(length(vec2<f32>(_e42, (1f - _e44))));
    spacing = ((0.5f * place.radius) / vec3(1.5f));
    loop {
        let _e63 = n_1;
        if !((_e63 < 27i)) {
            break;
        }
        {
            let _e70 = n_1;
            let _e77 = n_1;
            let _e82 = gabor_impl_slice_word(y.word[((_e70 / 3i) % 3i)], z.word[(_e77 / 9i)]);
            row_2 = _e82;
            let _e84 = n_1;
            let _e87 = n_1;
            let _e92 = row_2;
            let _e96 = gabor_impl_amplitude_at((x.word[(_e87 % 3i)] * _e92), place.animated, place.time);
            cube.number[_e84] = _e96;
        }
        continuing {
            let _e67 = n_1;
            n_1 = (_e67 + 1i);
        }
    }
    let _e97 = cube;
    let _e98 = spacing;
    let _e100 = dx;
    let _e102 = dy;
    let _e107 = gabor_impl_to_waves(_e97, z, (_e98.z * length(vec2<f32>(_e100.z, _e102.z))));
    cube = _e107;
    let _e108 = cube;
    let _e109 = spacing;
    let _e111 = dx;
    let _e113 = dy;
    let _e118 = gabor_impl_to_waves(_e108, y, (_e109.y * length(vec2<f32>(_e111.y, _e113.y))));
    cube = _e118;
    let _e119 = cube;
    let _e120 = spacing;
    let _e122 = dx;
    let _e124 = dy;
    let _e129 = gabor_impl_to_waves(_e119, x, (_e120.x * length(vec2<f32>(_e122.x, _e124.x))));
    cube = _e129;
    loop {
        let _e141 = n_2;
        if !((_e141 < 27i)) {
            break;
        }
        {
            let _e148 = n_2;
            let _e152 = n_2;
            let _e158 = n_2;
            aside = (vec3<f32>(f32((_e148 % 3i)), f32(((_e152 / 3i) % 3i)), f32((_e158 / 9i))) - vec3(1f));
            let _e167 = spacing;
            let _e168 = aside;
            k = (wave + (_e167 * _e168));
            let _e172 = fade_1;
            let _e175 = k;
            let _e176 = dx;
            let _e178 = k;
            let _e179 = dx;
            let _e182 = k;
            let _e183 = dy;
            let _e185 = k;
            let _e186 = dy;
            left = (_e172 * exp((-4.934802f * ((dot(_e175, _e176) * dot(_e178, _e179)) + (dot(_e182, _e183) * dot(_e185, _e186))))));
            let _e194 = left;
            let _e195 = n_2;
            let _e198 = cube.number[_e195];
            let _e199 = gabor_impl_product(_e198, turn);
            value_5 = (_e194 * _e199);
            let _e203 = sum_4;
            let _e205 = value_5;
            sum_4.noise = (_e203.noise + _e205.y);
            let _e209 = sum_4;
            let _e212 = value_5;
            let _e215 = k;
            sum_4.gradient = (_e209.gradient + ((6.2831855f * _e212.x) * _e215));
            let _e219 = sum_4;
            let _e221 = value_5;
            sum_4.quadrature = (_e219.quadrature + _e221.x);
            let _e225 = sum_4;
            let _e228 = value_5;
            let _e231 = k;
            sum_4.quadrature_gradient = (_e225.quadrature_gradient - ((6.2831855f * _e228.y) * _e231));
            let _e235 = sum_4;
            let _e240 = left;
            let _e242 = left;
            let _e246 = aside;
            let _e247 = aside;
            sum_4.removed = (_e235.removed - (((0.2962963f * _e240) * _e242) * exp2((-2f * dot(_e246, _e247)))));
        }
        continuing {
            let _e145 = n_2;
            n_2 = (_e145 + 1i);
        }
    }
    let _e253 = sum_4;
    return _e253;
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

// Adds slice k of nodes: to `sum` the noise and, in zw, derivatives of windows along x, to `slopes` along y and z.
fn gabor_impl_add_slice(sum: ptr<function, vec4<f32>>, slopes: ptr<function, vec4<f32>>, place: GaborPlace3d, x: GaborAxis, y: GaborAxis, z: GaborAxis, k: i32) {
    var y_7: GaborAxis;
    var j_1: i32 = 0i;
    var slice_1: vec4<f32>;
    var slope_7: vec4<f32>;

    y_7 = y;
    loop {
        let _e10 = j_1;
        if !((_e10 < 3i)) {
            break;
        }
        let _e17 = j_1;
        let _e20 = j_1;
        let _e23 = y_7.word[_e20];
        let _e26 = gabor_impl_slice_word(_e23, z.word[k]);
        y_7.word[_e17] = _e26;
        continuing {
            let _e14 = j_1;
            j_1 = (_e14 + 1i);
        }
    }
    let _e29 = y_7;
    gabor_impl_sum(x, _e29, place.animated, place.time, (&slice_1), (&slope_7));
    let _e37 = slice_1;
    gabor_impl_add(sum, _e37, z.node[k].xy);
    let _e42 = (*slopes);
    let _e43 = slope_7;
    let _e48 = gabor_impl_product(_e43.xy, z.node[k].xy);
    let _e49 = slice_1;
    let _e54 = gabor_impl_product(_e49.xy, z.node[k].zw);
    (*slopes) = (_e42 + vec4<f32>(_e48.x, _e48.y, _e54.x, _e54.y));
    return;
}

// E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1, and the derivative of a wave is 2 pi i F times it.
fn gabor_field_3d(place: GaborPlace3d, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var wave_3: vec3<f32>;
    var salt_4: u32;
    var rows: u32;
    var slices: u32;
    var x_6: GaborAxis;
    var y_8: GaborAxis;
    var z_3: GaborAxis;
    var local_13: f32;
    var local_14: f32;
    var turn_6: vec2<f32>;
    var sum_6: vec4<f32> = vec4(0f);
    var slopes_1: vec4<f32> = vec4(0f);
    var stretch_1: vec3<f32>;

    let _e7 = gabor_impl_unit(direction);
    wave_3 = (min(abs(frequency), 1000000f) * _e7);
    let _e10 = gabor_impl_salt(seed);
    salt_4 = _e10;
    let _e12 = salt_4;
    rows = (_e12 ^ 1540483477u);
    let _e16 = salt_4;
    slices = (_e16 ^ 668265263u);
    let _e26 = salt_4;
    let _e27 = wave_3;
    let _e31 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e26, _e27.x, place.radius.x);
    x_6 = _e31;
    let _e39 = rows;
    let _e40 = wave_3;
    let _e44 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, _e39, _e40.y, place.radius.y);
    y_8 = _e44;
    let _e52 = slices;
    let _e53 = wave_3;
    let _e57 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, _e52, _e53.z, place.radius.z);
    z_3 = _e57;
    if false {
        local_13 = 1f;
    } else {
        local_13 = 1.125f;
    }
    let _e68 = local_13;
    if false {
        local_14 = 1f;
    } else {
        local_14 = 1.125f;
    }
    let _e80 = local_14;
    let _e83 = x_6;
    let _e85 = x_6;
    let _e88 = y_8;
    let _e90 = y_8;
    let _e94 = z_3;
    let _e96 = z_3;
    let _e100 = gabor_impl_wave((((_e83.turns * _e85.offset) + (_e88.turns * _e90.offset)) + (_e94.turns * _e96.offset)));
    turn_6 = ((inverseSqrt(_e68) / (1459955300000000000000000000f * _e80)) * _e100);
    if place.filtered {
        let _e104 = wave_3;
        let _e105 = x_6;
        let _e106 = y_8;
        let _e107 = z_3;
        let _e108 = turn_6;
        let _e109 = gabor_impl_filtered(place, _e104, _e105, _e106, _e107, _e108);
        return _e109;
    }
    let _e118 = x_6;
    let _e119 = y_8;
    let _e120 = z_3;
    gabor_impl_add_slice((&sum_6), (&slopes_1), place, _e118, _e119, _e120, 0i);
    let _e126 = x_6;
    let _e127 = y_8;
    let _e128 = z_3;
    gabor_impl_add_slice((&sum_6), (&slopes_1), place, _e126, _e127, _e128, 1i);
    let _e134 = x_6;
    let _e135 = y_8;
    let _e136 = z_3;
    gabor_impl_add_slice((&sum_6), (&slopes_1), place, _e134, _e135, _e136, 2i);
    let _e140 = sum_6;
    let _e142 = turn_6;
    let _e143 = gabor_impl_product(_e140.xy, _e142);
    let _e144 = sum_6;
    let _e146 = turn_6;
    let _e147 = gabor_impl_product(_e144.zw, _e146);
    sum_6 = vec4<f32>(_e143.x, _e143.y, _e147.x, _e147.y);
    let _e153 = slopes_1;
    let _e155 = turn_6;
    let _e156 = gabor_impl_product(_e153.xy, _e155);
    let _e157 = slopes_1;
    let _e159 = turn_6;
    let _e160 = gabor_impl_product(_e157.zw, _e159);
    slopes_1 = vec4<f32>(_e156.x, _e156.y, _e160.x, _e160.y);
    stretch_1 = (place.radius / vec3(1.5f));
    let _e174 = sum_6;
    let _e176 = stretch_1;
    let _e177 = sum_6;
    let _e179 = slopes_1;
    let _e181 = slopes_1;
    let _e186 = sum_6;
    let _e189 = wave_3;
    let _e192 = sum_6;
    let _e194 = stretch_1;
    let _e195 = sum_6;
    let _e197 = slopes_1;
    let _e199 = slopes_1;
    let _e204 = sum_6;
    let _e207 = wave_3;
    return GaborField3d(_e174.y, ((_e176 * vec3<f32>(_e177.w, _e179.y, _e181.w)) + ((6.2831855f * _e186.x) * _e189)), _e192.x, ((_e194 * vec3<f32>(_e195.z, _e197.x, _e199.z)) - ((6.2831855f * _e204.y) * _e207)), 0f);
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
fn gabor_impl_add_term(sum: ptr<function, GaborField3d>, place: GaborPlace3d, frequency: f32, direction: vec3<f32>, seed: u32, index: i32, power: f32) {
    var term: GaborField3d;

    let _e7 = gabor_lobe_seed(seed, index);
    let _e8 = gabor_field_3d(place, frequency, direction, _e7);
    term = _e8;
    let _e11 = (*sum);
    let _e14 = term;
    (*sum).noise = (_e11.noise + (sqrt(power) * _e14.noise));
    let _e19 = (*sum);
    let _e22 = term;
    (*sum).gradient = (_e19.gradient + (sqrt(power) * _e22.gradient));
    let _e27 = (*sum);
    let _e30 = term;
    (*sum).quadrature = (_e27.quadrature + (sqrt(power) * _e30.quadrature));
    let _e35 = (*sum);
    let _e38 = term;
    (*sum).quadrature_gradient = (_e35.quadrature_gradient + (sqrt(power) * _e38.quadrature_gradient));
    let _e43 = (*sum);
    let _e45 = term;
    (*sum).removed = (_e43.removed + (power * _e45.removed));
    return;
}

// Directions evenly on a spiral over half the sphere, a real number of them: the last has what is left of the power.
fn gabor_isotropic_3d(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d {
    var count: f32;
    var sum_8: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var i_2: i32 = 0i;
    var share: f32;
    var z_4: f32;
    var direction_2: vec3<f32>;

    count = (8f + (8f * min((frequency * frequency), 64f)));
    loop {
        let _e22 = i_2;
        let _e23 = count;
        if !((_e22 < i32(ceil(_e23)))) {
            break;
        }
        {
            let _e31 = count;
            let _e32 = i_2;
            let _e37 = count;
            share = (min((_e31 - f32(_e32)), 1f) / _e37);
            let _e40 = i_2;
            let _e42 = count;
            let _e45 = share;
            z_4 = ((f32(_e40) / _e42) + (0.5f * _e45));
            let _e50 = z_4;
            let _e51 = z_4;
            let _e56 = i_2;
            let _e59 = gabor_impl_wave((0.618034f * f32(_e56)));
            let _e60 = (sqrt((1f - (_e50 * _e51))) * _e59);
            let _e61 = z_4;
            direction_2 = vec3<f32>(_e60.x, _e60.y, _e61);
            let _e67 = direction_2;
            let _e68 = i_2;
            let _e69 = share;
            gabor_impl_add_term((&sum_8), place, frequency, _e67, seed, _e68, _e69);
        }
        continuing {
            let _e28 = i_2;
            i_2 = (_e28 + 1i);
        }
    }
    let _e71 = sum_8;
    return _e71;
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
    var direction_4: vec3<f32>;
    var local_15: vec3<f32>;
    var other: vec3<f32>;
    var power_1: f32;
    var sum_9: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_16: i32;
    var i_3: i32;
    var local_17: i32;
    var local_18: vec3<f32>;
    var local_19: f32;

    normal_1 = normal;
    direction_4 = direction;
    let _e7 = normal_1;
    let _e8 = gabor_impl_unit(_e7);
    normal_1 = _e8;
    let _e9 = direction_4;
    let _e10 = gabor_impl_unit(_e9);
    direction_4 = _e10;
    let _e11 = direction_4;
    let _e12 = direction_4;
    if (abs(_e12.z) < 0.7f) {
        local_15 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_15 = vec3<f32>(1f, 0f, 0f);
    }
    let _e26 = local_15;
    other = cross(_e11, _e26);
    let _e29 = direction_4;
    let _e30 = direction_4;
    let _e31 = normal_1;
    let _e33 = normal_1;
    direction_4 = (_e29 - (dot(_e30, _e31) * _e33));
    let _e36 = other;
    let _e37 = other;
    let _e38 = normal_1;
    let _e40 = normal_1;
    other = (_e36 - (dot(_e37, _e38) * _e40));
    let _e45 = direction_4;
    let _e46 = direction_4;
    let _e48 = gabor_impl_takeover(0.0625f, 0.25f, dot(_e45, _e46));
    power_1 = _e48;
    let _e59 = power_1;
    if (_e59 > 0f) {
        local_16 = 0i;
    } else {
        local_16 = 1i;
    }
    let _e65 = local_16;
    i_3 = _e65;
    loop {
        let _e67 = i_3;
        let _e68 = power_1;
        if (_e68 < 1f) {
            local_17 = 2i;
        } else {
            local_17 = 1i;
        }
        let _e74 = local_17;
        if !((_e67 < _e74)) {
            break;
        }
        let _e81 = i_3;
        if (_e81 == 0i) {
            let _e84 = direction_4;
            local_18 = _e84;
        } else {
            let _e85 = other;
            local_18 = _e85;
        }
        let _e87 = local_18;
        let _e88 = i_3;
        let _e89 = i_3;
        if (_e89 == 0i) {
            let _e92 = power_1;
            local_19 = _e92;
        } else {
            let _e94 = power_1;
            local_19 = (1f - _e94);
        }
        let _e97 = local_19;
        gabor_impl_add_term((&sum_9), place, frequency, _e87, seed, _e88, _e97);
        continuing {
            let _e77 = i_3;
            i_3 = (_e77 + 1i);
        }
    }
    let _e99 = sum_9;
    return _e99;
}

// Directions evenly over half a turn in the tangent plane, from the circle of latitude around z; near the poles around x.
fn gabor_surface_isotropic_3d(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_3: vec3<f32>;
    var count_1: f32;
    var power_2: f32;
    var sum_10: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var axis_2: i32 = 0i;
    var local_20: vec3<f32>;
    var along: vec3<f32>;
    var i_4: i32;
    var share_2: f32;
    var turn_7: vec2<f32>;
    var direction_5: vec3<f32>;

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
        let _e35 = axis_2;
        if !((_e35 < 2i)) {
            break;
        }
        {
            let _e42 = axis_2;
            if (_e42 == 0i) {
                local_20 = vec3<f32>(0f, 0f, 1f);
            } else {
                local_20 = vec3<f32>(1f, 0f, 0f);
            }
            let _e54 = local_20;
            let _e55 = normal_3;
            let _e57 = gabor_impl_unit(cross(_e54, _e55));
            along = _e57;
            i_4 = 0i;
            loop {
                let _e61 = i_4;
                let _e62 = count_1;
                let _e66 = power_2;
                if !(((_e61 < i32(ceil(_e62))) && (_e66 > 0f))) {
                    break;
                }
                {
                    let _e74 = count_1;
                    let _e75 = i_4;
                    let _e80 = count_1;
                    share_2 = (min((_e74 - f32(_e75)), 1f) / _e80);
                    let _e84 = i_4;
                    let _e86 = count_1;
                    let _e89 = share_2;
                    let _e93 = gabor_impl_wave((0.5f * ((f32(_e84) / _e86) + (0.5f * _e89))));
                    turn_7 = _e93;
                    let _e95 = turn_7;
                    let _e97 = along;
                    let _e99 = turn_7;
                    let _e101 = normal_3;
                    let _e102 = along;
                    direction_5 = ((_e95.x * _e97) + (_e99.y * cross(_e101, _e102)));
                    let _e108 = direction_5;
                    let _e110 = axis_2;
                    let _e112 = i_4;
                    let _e114 = power_2;
                    let _e115 = share_2;
                    gabor_impl_add_term((&sum_10), place, frequency, _e108, seed, ((256i * _e110) + _e112), (_e114 * _e115));
                }
                continuing {
                    let _e71 = i_4;
                    i_4 = (_e71 + 1i);
                }
            }
            let _e119 = power_2;
            power_2 = (1f - _e119);
        }
        continuing {
            let _e39 = axis_2;
            axis_2 = (_e39 + 1i);
        }
    }
    let _e121 = sum_10;
    return _e121;
}

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p, frequency, seed  as for gabor_noise
//   direction           of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
fn gabor_noise_3d(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    return _e12.noise;
}

// The same with its gradient: (noise, d/dx, d/dy, d/dz). For bumps take away the part of it along the normal.
fn gabor_noise_3d_gradient(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec4<f32> {
    var field_1: GaborField3d;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    field_1 = _e12;
    let _e14 = field_1;
    let _e16 = field_1;
    return vec4<f32>(_e14.noise, _e16.gradient.x, _e16.gradient.y, _e16.gradient.z);
}

// (quadrature, noise), for gabor_phasor: see gabor_noise_complex.
fn gabor_noise_3d_complex(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var field_2: GaborField3d;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    field_2 = _e12;
    let _e14 = field_2;
    let _e16 = field_2;
    return vec2<f32>(_e14.quadrature, _e16.noise);
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
    var nodes_2: vec3<f32>;
    var place_11: GaborPlace3d;

    period_5 = period;
    let _e6 = period_5;
    period_5 = clamp(_e6, vec3(0.0009765625f), vec3(1000000000f));
    let _e12 = period_5;
    nodes_2 = max(floor(((_e12 * 1.5f) + vec3(0.5f))), vec3(3f));
    let _e28 = period_5;
    let _e31 = period_5;
    let _e34 = nodes_2;
    let _e35 = period_5;
    let _e38 = gabor_place_3d(vec3(0i), ((p - (floor((p / _e28)) * _e31)) * (_e34 / _e35)));
    place_11 = _e38;
    let _e41 = nodes_2;
    let _e42 = period_5;
    place_11.radius = (_e41 / _e42);
    let _e45 = nodes_2;
    place_11.period = vec3<i32>(_e45);
    let _e47 = place_11;
    let _e48 = gabor_field_3d(_e47, frequency, direction, seed);
    return _e48.noise;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
fn gabor_noise_3d_animated(p: vec3<f32>, time: f32, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var place_12: GaborPlace3d;

    place_12 = GaborPlace3d(vec3(0i), (p * 1.5f), vec3(1.5f), vec3(0i), true, time, false, vec3(0f), vec3(0f));
    let _e27 = place_12;
    let _e28 = gabor_field_3d(_e27, frequency, direction, seed);
    return _e28.noise;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
fn gabor_noise_3d_filtered(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var place_13: GaborPlace3d;
    var field_3: GaborField3d;

    place_13 = GaborPlace3d(vec3(0i), (p * 1.5f), vec3(1.5f), vec3(0i), false, 0f, true, dx, dy);
    let _e25 = place_13;
    let _e26 = gabor_field_3d(_e25, frequency, direction, seed);
    field_3 = _e26;
    let _e28 = field_3;
    let _e30 = field_3;
    return vec2<f32>(_e28.noise, _e30.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 noises for a frequency F of at most 8, and no more beyond.
fn gabor_noise_3d_isotropic(p: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e10 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e11 = gabor_isotropic_3d(_e10, frequency, seed);
    return _e11.noise;
}

// Noise on a surface at its point p, whose normal has any length but 0, its waves along the projection of a direction: one
// noise, two where that is 14 to 30 degrees from the normal. Where the surface is curved the waves of a kernel bend.
fn gabor_noise_surface(p: vec3<f32>, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    let _e12 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e13 = gabor_surface_3d(_e12, normal, frequency, direction, seed);
    return _e13.noise;
}

// The same along all directions of the tangent plane: 2 + 4.5 F noises, F up to 32, twice as many 30 to 45 degrees from z.
fn gabor_noise_surface_isotropic(p: vec3<f32>, normal: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_surface_isotropic_3d(_e11, normal, frequency, seed);
    return _e12.noise;
}
