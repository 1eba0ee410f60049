// gabor_lattice_3d.wgsl: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_spectrum.wgsl, which has the filter; every name that it adds begins with gabor_, Gabor or GABOR_: for WGSL.
//
// Digest of the GLSL and of this file: ecfc74f6861c47e8
// Made from shaders/gabor_lattice_3d.glsl by tools/translate and naga 30.0.1: change that file, not this one. Paste or include it after gabor_lattice.wgsl. Paste or include it after gabor_spectrum.wgsl.
//
//     float n = gabor_noise_3d(p, 2.0, vec3(1.0, 0.0, 0.0), 7u);        // mean 0, variance 1
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
// As in the plane, of the nodes c of a lattice, R = 3/2 to the kernel radius, the nearest and its neighbours, 27, reach
// a point with their waves under Hann's windows h, times independent normal amplitudes A:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// Whatever the wave vector F is, the variance is 1 at every place: so F may follow a surface, which sees the frequency
// asked for and no trace of the lattice. Several directions are a sum of independent noises, jointly normal like one.
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

// The noise and its quadrature, each with its gradient per kernel radius. Apart, so that compilers drop unused ones.
struct GaborField3d {
    noise: f32,
    gradient: vec3<f32>,
    quadrature: f32,
    quadrature_gradient: vec3<f32>,
    removed: f32,
}

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
fn gabor_place_3d(cell: vec3<i32>, local: vec3<f32>) -> GaborPlace3d {
    return GaborPlace3d(cell, local, vec3(1.5f), vec3(0i), false, 0f, false, vec3(0f), vec3(0f));
}

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
fn gabor_impl_unit(v: vec3<f32>) -> vec3<f32> {
    var v_3: vec3<f32>;

    v_3 = v;
    let _e2 = v_3;
    v_3 = clamp(_e2, vec3(-1000000000000000f), vec3(1000000000000000f));
    let _e9 = v_3;
    let _e10 = v_3;
    let _e11 = v_3;
    return (_e9 * inverseSqrt(max(dot(_e10, _e11), 0.000000000000000000000000000001f)));
}

// Adds slice k of nodes: to `sum` the noise and, in zw, derivatives of windows along x, to `slopes` along y and z. The
// filter adds mixed derivatives, with its covariances yz, zx, xy.
fn gabor_impl_add_slice(sum: ptr<function, vec4<f32>>, slopes: ptr<function, vec4<f32>>, place: GaborPlace3d, x: GaborAxis, y: GaborAxis, z: GaborAxis, k: i32, mixed: vec3<f32>) {
    var y_8: GaborAxis;
    var j_4: i32 = 0i;
    var slice_3: vec4<f32>;
    var slope_10: vec4<f32>;

    y_8 = y;
    loop {
        let _e11 = j_4;
        if !((_e11 < 3i)) {
            break;
        }
        let _e18 = j_4;
        let _e21 = j_4;
        let _e24 = y_8.word[_e21];
        let _e27 = gabor_impl_slice_word(_e24, z.word[k]);
        y_8.word[_e18] = _e27;
        continuing {
            let _e15 = j_4;
            j_4 = (_e15 + 1i);
        }
    }
    let _e30 = y_8;
    gabor_impl_sum(x, _e30, place.animated, place.time, (&slice_3), (&slope_10));
    let _e38 = slice_3;
    gabor_impl_add(sum, _e38, z.node[k].xy);
    let _e43 = (*slopes);
    let _e44 = slope_10;
    let _e49 = gabor_impl_product(_e44.xy, z.node[k].xy);
    let _e50 = slice_3;
    let _e55 = gabor_impl_product(_e50.xy, z.node[k].zw);
    (*slopes) = (_e43 + vec4<f32>(_e49.x, _e49.y, _e55.x, _e55.y));
    if place.filtered {
        let _e63 = (*sum);
        let _e65 = slope_10;
        let _e69 = slice_3;
        let _e76 = gabor_impl_product(((mixed.x * _e65.xy) + (mixed.y * _e69.zw)), z.node[k].zw);
        let _e78 = slope_10;
        let _e83 = gabor_impl_product(_e78.zw, z.node[k].xy);
        let _e85 = (_e76 + (mixed.z * _e83));
        (*sum) = (_e63 + vec4<f32>(_e85.x, _e85.y, 0f, 0f));
        return;
    } else {
        return;
    }
}

// The noise of 27 nodes; filtered by three waves along each axis. E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1, and the
// derivative of a wave is 2 pi i F times it.
fn gabor_impl_sum_3d(place: GaborPlace3d, wave: vec3<f32>, pixel: GaborMatrix, salt: u32) -> GaborField3d {
    var x_8: GaborAxis;
    var y_9: GaborAxis;
    var z_4: GaborAxis;
    var local_29: f32;
    var local_30: f32;
    var turn_9: vec2<f32>;
    var blurred_4: vec3<f32>;
    var sum_13: vec4<f32> = vec4(0f);
    var slopes_1: vec4<f32> = vec4(0f);

    let _e15 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, 1.5f);
    x_8 = _e15;
    let _e30 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), wave.y, 1.5f);
    y_9 = _e30;
    let _e45 = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, (salt ^ 668265263u), wave.z, 1.5f);
    z_4 = _e45;
    if false {
        local_29 = 1f;
    } else {
        local_29 = 1.125f;
    }
    let _e56 = local_29;
    if false {
        local_30 = 1f;
    } else {
        local_30 = 1.125f;
    }
    let _e68 = local_30;
    let _e71 = x_8;
    let _e73 = x_8;
    let _e76 = y_9;
    let _e78 = y_9;
    let _e82 = z_4;
    let _e84 = z_4;
    let _e88 = gabor_impl_wave((((_e71.turns * _e73.offset) + (_e76.turns * _e78.offset)) + (_e82.turns * _e84.offset)));
    turn_9 = ((inverseSqrt(_e56) / (1459955300000000000000000000f * _e68)) * _e88);
    if place.filtered {
        {
            let _e92 = gabor_impl_symmetric_3d(pixel, wave);
            blurred_4 = _e92;
            let _e97 = blurred_4;
            gabor_impl_filter((&x_8), pixel.diagonal.x, _e97.x);
            let _e103 = blurred_4;
            gabor_impl_filter((&y_9), pixel.diagonal.y, _e103.y);
            let _e109 = blurred_4;
            gabor_impl_filter((&z_4), pixel.diagonal.z, _e109.z);
            let _e112 = turn_9;
            let _e115 = blurred_4;
            turn_9 = (_e112 * exp((-19.739208f * dot(wave, _e115))));
        }
    }
    let _e128 = x_8;
    let _e129 = y_9;
    let _e130 = z_4;
    gabor_impl_add_slice((&sum_13), (&slopes_1), place, _e128, _e129, _e130, 0i, pixel.mixed);
    let _e137 = x_8;
    let _e138 = y_9;
    let _e139 = z_4;
    gabor_impl_add_slice((&sum_13), (&slopes_1), place, _e137, _e138, _e139, 1i, pixel.mixed);
    let _e146 = x_8;
    let _e147 = y_9;
    let _e148 = z_4;
    gabor_impl_add_slice((&sum_13), (&slopes_1), place, _e146, _e147, _e148, 2i, pixel.mixed);
    let _e153 = sum_13;
    let _e155 = turn_9;
    let _e156 = gabor_impl_product(_e153.xy, _e155);
    let _e157 = sum_13;
    let _e159 = turn_9;
    let _e160 = gabor_impl_product(_e157.zw, _e159);
    sum_13 = vec4<f32>(_e156.x, _e156.y, _e160.x, _e160.y);
    let _e166 = slopes_1;
    let _e168 = turn_9;
    let _e169 = gabor_impl_product(_e166.xy, _e168);
    let _e170 = slopes_1;
    let _e172 = turn_9;
    let _e173 = gabor_impl_product(_e170.zw, _e172);
    slopes_1 = vec4<f32>(_e169.x, _e169.y, _e173.x, _e173.y);
    let _e179 = sum_13;
    let _e181 = sum_13;
    let _e183 = slopes_1;
    let _e185 = slopes_1;
    let _e189 = sum_13;
    let _e194 = sum_13;
    let _e196 = sum_13;
    let _e198 = slopes_1;
    let _e200 = slopes_1;
    let _e204 = sum_13;
    return GaborField3d(_e179.y, (vec3<f32>(_e181.w, _e183.y, _e185.w) + ((6.2831855f * _e189.x) * wave)), _e194.x, (vec3<f32>(_e196.z, _e198.x, _e200.z) - ((6.2831855f * _e204.y) * wave)), 0f);
}

fn gabor_impl_accumulate_3d(sum: ptr<function, GaborField3d>, field: GaborField3d, amplitude: f32) {
    let _e4 = (*sum);
    (*sum).noise = (_e4.noise + (amplitude * field.noise));
    let _e10 = (*sum);
    (*sum).gradient = (_e10.gradient + (amplitude * field.gradient));
    let _e16 = (*sum);
    (*sum).quadrature = (_e16.quadrature + (amplitude * field.quadrature));
    let _e22 = (*sum);
    (*sum).quadrature_gradient = (_e22.quadrature_gradient + (amplitude * field.quadrature_gradient));
    return;
}

// The share of its variance that a lobe keeps, of a pixel whose axes are at right angles: see gabor_impl_transmitted.
fn gabor_impl_transmitted_3d(wave: vec3<f32>, major: vec3<f32>, minor: vec3<f32>) -> f32 {
    var d_2: vec2<f32>;
    var k_2: vec2<f32>;

    d_2 = (vec2(1f) + (1.644934f * vec2<f32>(dot(major, major), dot(minor, minor))));
    k_2 = vec2<f32>(dot(wave, major), dot(wave, minor));
    let _e17 = k_2;
    let _e18 = k_2;
    let _e21 = d_2;
    let _e30 = d_2;
    let _e32 = d_2;
    return (exp(-(min((9.869604f * dot((_e17 * _e18), (vec2(1f) / _e21))), 80f))) * inverseSqrt((_e30.x * _e32.y)));
}

// The covariance of the place's pixel; beyond a deviation of 1/2 that at 1/2, at which noise has the amplitude that is
// left. And the share of its variance that the noise keeps.
fn gabor_impl_pixel(place: GaborPlace3d, wave: vec3<f32>, stretch: vec3<f32>, amplitude: ptr<function, f32>, transmitted: ptr<function, f32>) -> GaborMatrix {
    var dx_7: vec3<f32>;
    var dy_7: vec3<f32>;
    var twice_1: vec2<f32>;
    var cosine_1: f32;
    var turn_10: vec2<f32>;
    var major_1: vec3<f32>;
    var minor_1: vec3<f32>;

    dx_7 = (clamp(place.dx, vec3(-1000000f), vec3(1000000f)) * stretch);
    dy_7 = (clamp(place.dy, vec3(-1000000f), vec3(1000000f)) * stretch);
    let _e23 = dx_7;
    let _e24 = dx_7;
    let _e26 = dy_7;
    let _e27 = dy_7;
    let _e31 = dx_7;
    let _e32 = dy_7;
    twice_1 = vec2<f32>((dot(_e23, _e24) - dot(_e26, _e27)), (2f * dot(_e31, _e32)));
    let _e37 = twice_1;
    let _e39 = twice_1;
    cosine_1 = (_e37.x / max(length(_e39), 0.000000000000000000000000000001f));
    let _e50 = cosine_1;
    turn_10 = sqrt(max((vec2(0.5f) + (vec2<f32>(0.5f, -0.5f) * _e50)), vec2(0f)));
    let _e59 = twice_1;
    if (_e59.y < 0f) {
        let _e64 = turn_10;
        turn_10.y = -(_e64.y);
    }
    let _e67 = turn_10;
    let _e69 = dx_7;
    let _e71 = turn_10;
    let _e73 = dy_7;
    major_1 = ((_e67.x * _e69) + (_e71.y * _e73));
    let _e77 = turn_10;
    let _e79 = dy_7;
    let _e81 = turn_10;
    let _e83 = dx_7;
    minor_1 = ((_e77.x * _e79) - (_e81.y * _e83));
    let _e87 = major_1;
    let _e88 = minor_1;
    let _e89 = gabor_impl_transmitted_3d(wave, _e87, _e88);
    (*transmitted) = _e89;
    let _e90 = major_1;
    let _e91 = major_1;
    let _e92 = major_1;
    major_1 = (_e90 * inverseSqrt(max(dot(_e91, _e92), 1f)));
    let _e98 = minor_1;
    let _e99 = minor_1;
    let _e100 = minor_1;
    minor_1 = (_e98 * inverseSqrt(max(dot(_e99, _e100), 1f)));
    let _e106 = (*transmitted);
    let _e107 = major_1;
    let _e108 = minor_1;
    let _e109 = gabor_impl_transmitted_3d(wave, _e107, _e108);
    (*amplitude) = sqrt((_e106 / _e109));
    let _e112 = (*transmitted);
    if !((_e112 > 0.0000000001f)) {
        (*transmitted) = 0f;
    }
    let _e118 = major_1;
    let _e119 = major_1;
    let _e121 = minor_1;
    let _e122 = minor_1;
    let _e127 = major_1;
    let _e129 = major_1;
    let _e132 = minor_1;
    let _e134 = minor_1;
    return GaborMatrix((0.25f * ((_e118 * _e119) + (_e121 * _e122))), (0.25f * ((_e127.yzx * _e129.zxy) + (_e132.yzx * _e134.zxy))));
}

// With periods, whose nodes are not 1 / GABOR_RADIUS apart, everything counts in units of GABOR_RADIUS nodes.
fn gabor_field_3d(place: GaborPlace3d, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var stretch_3: vec3<f32>;
    var wave_20: vec3<f32>;
    var salt_10: u32;
    var amplitude_6: f32 = 1f;
    var transmitted_2: f32 = 1f;
    var wide_1: f32 = 0f;
    var pixel_1: GaborMatrix = GaborMatrix(vec3(0f), vec3(0f));
    var variance_1: vec3<f32>;
    var sum_15: GaborField3d;
    var noise_4: vec4<f32>;
    var quadrature_1: vec4<f32>;

    stretch_3 = (place.radius / vec3(1.5f));
    let _e15 = gabor_impl_unit(direction);
    let _e17 = stretch_3;
    wave_20 = ((min(abs(frequency), 1000000f) * _e15) / _e17);
    let _e20 = gabor_impl_salt(seed);
    salt_10 = _e20;
    if place.filtered {
        {
            let _e35 = wave_20;
            let _e36 = stretch_3;
            let _e41 = gabor_impl_pixel(place, _e35, _e36, (&amplitude_6), (&transmitted_2));
            pixel_1 = _e41;
            let _e42 = pixel_1;
            variance_1 = _e42.diagonal;
            let _e46 = variance_1;
            let _e48 = variance_1;
            let _e51 = variance_1;
            wide_1 = clamp(((100f * sqrt(max(max(_e46.x, _e48.y), _e51.z))) - 9f), 0f, 1f);
        }
    }
    let _e68 = transmitted_2;
    sum_15 = GaborField3d(0f, vec3(0f), 0f, vec3(0f), (1f - _e68));
    let _e72 = transmitted_2;
    if (_e72 == 0f) {
        let _e75 = sum_15;
        return _e75;
    }
    let _e76 = wide_1;
    if (_e76 < 1f) {
        let _e80 = wave_20;
        let _e81 = pixel_1;
        let _e82 = salt_10;
        let _e83 = gabor_impl_sum_3d(place, _e80, _e81, _e82);
        let _e85 = wide_1;
        let _e87 = amplitude_6;
        gabor_impl_accumulate_3d((&sum_15), _e83, ((1f - _e85) * _e87));
    }
    let _e90 = wide_1;
    if (_e90 > 0f) {
        {
            let _e100 = wave_20;
            let _e101 = pixel_1;
            let _e102 = wide_1;
            let _e105 = salt_10;
            gabor_impl_filtered_space(place.cell, place.local, place.period, place.animated, place.time, _e100, _e101, (_e102 > 0f), _e105, (&noise_4), (&quadrature_1));
            let _e111 = noise_4;
            let _e113 = noise_4;
            let _e115 = quadrature_1;
            let _e117 = quadrature_1;
            let _e121 = wide_1;
            let _e122 = amplitude_6;
            gabor_impl_accumulate_3d((&sum_15), GaborField3d(_e111.x, _e113.yzw, _e115.x, _e117.yzw, 0f), (_e121 * _e122));
        }
    }
    let _e126 = sum_15;
    let _e128 = stretch_3;
    sum_15.gradient = (_e126.gradient * _e128);
    let _e131 = sum_15;
    let _e133 = stretch_3;
    sum_15.quadrature_gradient = (_e131.quadrature_gradient * _e133);
    let _e135 = sum_15;
    return _e135;
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
fn gabor_impl_add_term(sum: ptr<function, GaborField3d>, place: GaborPlace3d, frequency: f32, direction: vec3<f32>, seed: u32, index: i32, power: f32) {
    var term: GaborField3d;

    let _e7 = gabor_lobe_seed(seed, index);
    let _e8 = gabor_field_3d(place, frequency, direction, _e7);
    term = _e8;
    let _e11 = term;
    gabor_impl_accumulate_3d(sum, _e11, sqrt(power));
    let _e15 = (*sum);
    let _e17 = term;
    (*sum).removed = (_e15.removed + (power * _e17.removed));
    return;
}

// Of directions evenly in a range, a real number `count` of them, the last in what is left of it: the place of number
// `index`, from 0 to 1, and its power. That is nearly in proportion to its size, but falls to 0 as the square of that: in
// proportion, the amplitude, its root, would begin with an infinite slope.
fn gabor_impl_direction(index: i32, count: f32) -> vec2<f32> {
    var size: vec2<f32>;
    var power_4: vec2<f32>;

    size = vec2<f32>(min((count - f32(index)), 1f), fract(count));
    let _e9 = size;
    let _e10 = size;
    let _e14 = size;
    power_4 = (((_e9 * _e10) * 1.05f) / (_e14 + vec2(0.05f)));
    let _e22 = size;
    let _e27 = power_4;
    let _e30 = power_4;
    return vec2<f32>(((f32(index) + (0.5f * _e22.x)) / count), (_e27.x / (floor(count) + _e30.y)));
}

// Directions evenly on a spiral over half the sphere.
fn gabor_isotropic_3d(place: GaborPlace3d, frequency: f32, seed: u32) -> GaborField3d {
    var count_1: f32;
    var sum_17: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var i_6: i32 = 0i;
    var part_2: vec2<f32>;
    var direction_3: vec3<f32>;

    count_1 = (8f + (8f * min((frequency * frequency), 64f)));
    loop {
        let _e22 = i_6;
        let _e23 = count_1;
        if !((_e22 < i32(ceil(_e23)))) {
            break;
        }
        {
            let _e31 = i_6;
            let _e32 = count_1;
            let _e33 = gabor_impl_direction(_e31, _e32);
            part_2 = _e33;
            let _e36 = part_2;
            let _e38 = part_2;
            let _e44 = i_6;
            let _e47 = gabor_impl_wave((0.618034f * f32(_e44)));
            let _e48 = (sqrt((1f - (_e36.x * _e38.x))) * _e47);
            let _e49 = part_2;
            direction_3 = vec3<f32>(_e48.x, _e48.y, _e49.x);
            let _e56 = direction_3;
            let _e57 = i_6;
            let _e58 = part_2;
            gabor_impl_add_term((&sum_17), place, frequency, _e56, seed, _e57, _e58.y);
        }
        continuing {
            let _e28 = i_6;
            i_6 = (_e28 + 1i);
        }
    }
    let _e61 = sum_17;
    return _e61;
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
fn gabor_surface_3d(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> GaborField3d {
    var normal_1: vec3<f32>;
    var direction_5: vec3<f32>;
    var local_31: vec3<f32>;
    var other: vec3<f32>;
    var power_5: f32;
    var sum_18: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var local_32: i32;
    var i_7: i32;
    var local_33: i32;
    var local_34: vec3<f32>;
    var local_35: f32;

    normal_1 = normal;
    direction_5 = direction;
    let _e7 = normal_1;
    let _e8 = gabor_impl_unit(_e7);
    normal_1 = _e8;
    let _e9 = direction_5;
    let _e10 = gabor_impl_unit(_e9);
    direction_5 = _e10;
    let _e11 = direction_5;
    let _e12 = direction_5;
    if (abs(_e12.z) < 0.7f) {
        local_31 = vec3<f32>(0f, 0f, 1f);
    } else {
        local_31 = vec3<f32>(1f, 0f, 0f);
    }
    let _e26 = local_31;
    other = cross(_e11, _e26);
    let _e29 = direction_5;
    let _e30 = direction_5;
    let _e31 = normal_1;
    let _e33 = normal_1;
    direction_5 = (_e29 - (dot(_e30, _e31) * _e33));
    let _e36 = other;
    let _e37 = other;
    let _e38 = normal_1;
    let _e40 = normal_1;
    other = (_e36 - (dot(_e37, _e38) * _e40));
    let _e45 = direction_5;
    let _e46 = direction_5;
    let _e49 = gabor_impl_takeover(smoothstep(0.0625f, 0.25f, dot(_e45, _e46)));
    power_5 = _e49;
    let _e60 = power_5;
    if (_e60 > 0f) {
        local_32 = 0i;
    } else {
        local_32 = 1i;
    }
    let _e66 = local_32;
    i_7 = _e66;
    loop {
        let _e68 = i_7;
        let _e69 = power_5;
        if (_e69 < 1f) {
            local_33 = 2i;
        } else {
            local_33 = 1i;
        }
        let _e75 = local_33;
        if !((_e68 < _e75)) {
            break;
        }
        let _e82 = i_7;
        if (_e82 == 0i) {
            let _e85 = direction_5;
            local_34 = _e85;
        } else {
            let _e86 = other;
            local_34 = _e86;
        }
        let _e88 = local_34;
        let _e89 = i_7;
        let _e90 = i_7;
        if (_e90 == 0i) {
            let _e93 = power_5;
            local_35 = _e93;
        } else {
            let _e95 = power_5;
            local_35 = (1f - _e95);
        }
        let _e98 = local_35;
        gabor_impl_add_term((&sum_18), place, frequency, _e88, seed, _e89, _e98);
        continuing {
            let _e78 = i_7;
            i_7 = (_e78 + 1i);
        }
    }
    let _e100 = sum_18;
    return _e100;
}

// Directions evenly over half a turn in the tangent plane, from the circle of latitude around z; near the poles around x.
fn gabor_surface_isotropic_3d(place: GaborPlace3d, normal: vec3<f32>, frequency: f32, seed: u32) -> GaborField3d {
    var normal_3: vec3<f32>;
    var count_2: f32;
    var power_6: f32;
    var sum_19: GaborField3d = GaborField3d(0f, vec3(0f), 0f, vec3(0f), 0f);
    var axis_3: i32 = 0i;
    var local_36: vec3<f32>;
    var along_1: vec3<f32>;
    var i_8: i32;
    var part_3: vec2<f32>;
    var turn_11: vec2<f32>;
    var direction_6: vec3<f32>;

    normal_3 = normal;
    let _e5 = normal_3;
    let _e6 = gabor_impl_unit(_e5);
    normal_3 = _e6;
    count_2 = (2f + (4.5f * min(abs(frequency), 32f)));
    let _e17 = normal_3;
    let _e19 = normal_3;
    let _e23 = gabor_impl_takeover(smoothstep(0.25f, 0.5f, dot(_e17.xy, _e19.xy)));
    power_6 = _e23;
    loop {
        let _e36 = axis_3;
        if !((_e36 < 2i)) {
            break;
        }
        {
            let _e43 = axis_3;
            if (_e43 == 0i) {
                local_36 = vec3<f32>(0f, 0f, 1f);
            } else {
                local_36 = vec3<f32>(1f, 0f, 0f);
            }
            let _e55 = local_36;
            let _e56 = normal_3;
            let _e58 = gabor_impl_unit(cross(_e55, _e56));
            along_1 = _e58;
            i_8 = 0i;
            loop {
                let _e62 = i_8;
                let _e63 = count_2;
                let _e67 = power_6;
                if !(((_e62 < i32(ceil(_e63))) && (_e67 > 0f))) {
                    break;
                }
                {
                    let _e75 = i_8;
                    let _e76 = count_2;
                    let _e77 = gabor_impl_direction(_e75, _e76);
                    part_3 = _e77;
                    let _e80 = part_3;
                    let _e83 = gabor_impl_wave((0.5f * _e80.x));
                    turn_11 = _e83;
                    let _e85 = turn_11;
                    let _e87 = along_1;
                    let _e89 = turn_11;
                    let _e91 = normal_3;
                    let _e92 = along_1;
                    direction_6 = ((_e85.x * _e87) + (_e89.y * cross(_e91, _e92)));
                    let _e98 = direction_6;
                    let _e100 = axis_3;
                    let _e102 = i_8;
                    let _e104 = power_6;
                    let _e105 = part_3;
                    gabor_impl_add_term((&sum_19), place, frequency, _e98, seed, ((256i * _e100) + _e102), (_e104 * _e105.y));
                }
                continuing {
                    let _e72 = i_8;
                    i_8 = (_e72 + 1i);
                }
            }
            let _e110 = power_6;
            power_6 = (1f - _e110);
        }
        continuing {
            let _e40 = axis_3;
            axis_3 = (_e40 + 1i);
        }
    }
    let _e112 = sum_19;
    return _e112;
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
    var field_11: GaborField3d;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    field_11 = _e12;
    let _e14 = field_11;
    let _e16 = field_11;
    return vec4<f32>(_e14.noise, _e16.gradient.x, _e16.gradient.y, _e16.gradient.z);
}

// (quadrature, noise), for gabor_phasor: see gabor_noise_complex.
fn gabor_noise_3d_complex(p: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var field_12: GaborField3d;

    let _e11 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e12 = gabor_field_3d(_e11, frequency, direction, seed);
    field_12 = _e12;
    let _e14 = field_12;
    let _e16 = field_12;
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
    var period_9: vec3<f32>;
    var nodes_1: vec3<f32>;
    var place_24: GaborPlace3d;

    period_9 = period;
    let _e6 = period_9;
    period_9 = clamp(_e6, vec3(0.0009765625f), vec3(1000000000f));
    let _e12 = period_9;
    nodes_1 = max(floor(((_e12 * 1.5f) + vec3(0.5f))), vec3(3f));
    let _e28 = period_9;
    let _e31 = period_9;
    let _e34 = nodes_1;
    let _e35 = period_9;
    let _e38 = gabor_place_3d(vec3(0i), ((p - (floor((p / _e28)) * _e31)) * (_e34 / _e35)));
    place_24 = _e38;
    let _e41 = nodes_1;
    let _e42 = period_9;
    place_24.radius = (_e41 / _e42);
    let _e45 = nodes_1;
    place_24.period = vec3<i32>(_e45);
    let _e47 = place_24;
    let _e48 = gabor_field_3d(_e47, frequency, direction, seed);
    return _e48.noise;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
fn gabor_noise_3d_animated(p: vec3<f32>, time: f32, frequency: f32, direction: vec3<f32>, seed: u32) -> f32 {
    var place_25: GaborPlace3d;

    place_25 = GaborPlace3d(vec3(0i), (p * 1.5f), vec3(1.5f), vec3(0i), true, time, false, vec3(0f), vec3(0f));
    let _e27 = place_25;
    let _e28 = gabor_field_3d(_e27, frequency, direction, seed);
    return _e28.noise;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter and its accuracy are those of gabor_noise_filtered: 1 % up to a third of a kernel radius along the pixel's
// longest axis, 2 % up to a whole one. Continuous in the place and in both steps. On GPUs 1.4 times gabor_noise_3d up to
// steps of 0.18, with 27 nodes; from 0.2 on 4.2 times, with 64, and up to 6.6 times with 125.
fn gabor_noise_3d_filtered(p: vec3<f32>, dx: vec3<f32>, dy: vec3<f32>, frequency: f32, direction: vec3<f32>, seed: u32) -> vec2<f32> {
    var place_26: GaborPlace3d;
    var field_13: GaborField3d;

    place_26 = GaborPlace3d(vec3(0i), (p * 1.5f), vec3(1.5f), vec3(0i), false, 0f, true, dx, dy);
    let _e25 = place_26;
    let _e26 = gabor_field_3d(_e25, frequency, direction, seed);
    field_13 = _e26;
    let _e28 = field_13;
    let _e30 = field_13;
    return vec2<f32>(_e28.noise, _e30.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 noises, rounded up, for a frequency F of at most 8, and no more
// beyond. Its power differs between directions by 14 % (root mean square) at F = 0.5, 16 % at 1 and 25 % at 4.
fn gabor_noise_3d_isotropic(p: vec3<f32>, frequency: f32, seed: u32) -> f32 {
    let _e10 = gabor_place_3d(vec3(0i), (p * 1.5f));
    let _e11 = gabor_isotropic_3d(_e10, frequency, seed);
    return _e11.noise;
}

// Noise on a surface at its point p, whose normal has any length from 10^-15 to 10^15, its waves along the projection of a direction: one
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
