// gabor_spectrum.wgsl: Gabor noise of any power spectrum, and without aliasing. Include it after gabor_lattice.wgsl: for WGSL.
//
// Made from shaders/gabor_spectrum.glsl by tools/translate and naga 30.0.1: change that file, not this one. Paste or include it after gabor_lattice.wgsl.
//
// Functions to call, at the end of the file; each has one with _gradient, and the first two one with _complex:
//     gabor_noise_lobes                                  a sum of lobes
//     gabor_noise_spread                                 a range of waves, up to isotropic
//     gabor_noise_filtered, gabor_noise_lobes_filtered   as a pixel sees it
//     gabor_noise_four_filtered                          four independent ones at once
//     gabor_lobe, gabor_footprint                        what these are given
//     gabor_field_...                                    the same by place
//
// The unit of length is the kernel radius, as in gabor_lattice.wgsl, and every function's variance is exactly 1.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Waves around one wave vector: see gabor_lobe.
struct GaborLobe {
    frequency: f32,
    orientation: f32,
    radius: f32,
    power: f32,
}

// A power spectrum: the first `count` lobes.
struct GaborLobes {
    lobe: array<GaborLobe, 4>,
    count: i32,
}

fn gabor_impl_accumulate(sum: ptr<function, GaborField>, field: GaborField, amplitude: f32, slope: f32) {
    let _e5 = (*sum);
    (*sum).value = (_e5.value + (amplitude * field.value));
    let _e11 = (*sum);
    (*sum).slope_x = (_e11.slope_x + (slope * field.slope_x));
    let _e17 = (*sum);
    (*sum).slope_y = (_e17.slope_y + (slope * field.slope_y));
    let _e23 = (*sum);
    (*sum).four = (_e23.four + (amplitude * field.four));
    return;
}

// The same place, period and time for a kernel whose radius is `radius` times that of the place's. Its position is
// rounded to a float: within a period, or without one as p is.
fn gabor_place_scaled(place: GaborPlace, radius: f32) -> GaborPlace {
    var cell_2: vec2<i32>;
    var unit: vec2<f32>;
    var scaled: GaborPlace;

    let _e6 = gabor_impl_wrap(place.cell.x, place.period.x);
    let _e11 = gabor_impl_wrap(place.cell.y, place.period.y);
    cell_2 = vec2<i32>(_e6, _e11);
    unit = (vec2(1f) / (place.radius * radius));
    let _e20 = cell_2;
    let _e24 = unit;
    let _e28 = unit;
    let _e30 = gabor_place_tiled(((vec2<f32>(_e20) + place.local) * _e24), (vec2<f32>(place.period) * _e28));
    scaled = _e30;
    scaled.animated = place.animated;
    scaled.time = place.time;
    let _e36 = scaled;
    return _e36;
}

// The noise of a sum of lobes at a place, with its quadrature and derivatives per kernel radius of the place.
fn gabor_field_lobes(place: GaborPlace, lobes: GaborLobes, seed: u32) -> GaborField {
    if GABOR_TAPS == 2 {
        var lobes_1: GaborLobes;
        var sum_4: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
        var power: f32 = 0f;
        var i: i32 = 0i;
        var lobe: GaborLobe;
        var scaled_1: GaborPlace;
        var kernel_7: GaborKernel;
        var field_2: GaborField;
        var local_7: f32;
        var scale_1: f32;

        lobes_1 = lobes;
        loop {
            let _e18 = i;
            let _e19 = lobes_1;
            if !((_e18 < _e19.count)) {
                break;
            }
            {
                let _e26 = i;
                let _e29 = lobes_1.lobe[_e26];
                lobe = _e29;
                let _e31 = lobe;
                let _e33 = gabor_place_scaled(place, _e31.radius);
                scaled_1 = _e33;
                let _e35 = lobe;
                let _e37 = lobe;
                let _e40 = lobe;
                let _e42 = gabor_kernel((_e35.frequency * _e37.radius), _e40.orientation);
                let _e43 = scaled_1;
                let _e45 = gabor_kernel_stretched(_e42, _e43.radius);
                kernel_7 = _e45;
                let _e47 = scaled_1;
                let _e48 = kernel_7;
                let _e49 = i;
                let _e50 = gabor_lobe_seed(seed, _e49);
                let _e51 = gabor_field(_e47, _e48, _e50);
                field_2 = _e51;
                let _e54 = field_2;
                let _e55 = lobe;
                let _e58 = lobe;
                let _e61 = lobe;
                gabor_impl_accumulate((&sum_4), _e54, sqrt(_e55.power), (sqrt(_e58.power) / _e61.radius));
                let _e65 = power;
                let _e66 = lobe;
                power = (_e65 + _e66.power);
            }
            continuing {
                let _e23 = i;
                i = (_e23 + 1i);
            }
        }
        let _e69 = power;
        if (_e69 > 0f) {
            let _e72 = power;
            local_7 = inverseSqrt(_e72);
        } else {
            local_7 = 0f;
        }
        let _e76 = local_7;
        scale_1 = _e76;
        let _e78 = scale_1;
        let _e79 = sum_4;
        let _e82 = scale_1;
        let _e83 = sum_4;
        let _e86 = scale_1;
        let _e87 = sum_4;
        let _e90 = scale_1;
        let _e91 = sum_4;
        return GaborField((_e78 * _e79.value), (_e82 * _e83.slope_x), (_e86 * _e87.slope_y), (_e90 * _e91.four));
    } else if GABOR_TAPS == 4 {
        var lobes_1: GaborLobes;
        var sum_4: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
        var power: f32 = 0f;
        var i: i32 = 0i;
        var lobe: GaborLobe;
        var scaled_1: GaborPlace;
        var kernel_7: GaborKernel;
        var field_2: GaborField;
        var local_7: f32;
        var scale: f32;

        lobes_1 = lobes;
        loop {
            let _e18 = i;
            let _e19 = lobes_1;
            if !((_e18 < _e19.count)) {
                break;
            }
            {
                let _e26 = i;
                let _e29 = lobes_1.lobe[_e26];
                lobe = _e29;
                let _e31 = lobe;
                let _e33 = gabor_place_scaled(place, _e31.radius);
                scaled_1 = _e33;
                let _e35 = lobe;
                let _e37 = lobe;
                let _e40 = lobe;
                let _e42 = gabor_kernel((_e35.frequency * _e37.radius), _e40.orientation);
                let _e43 = scaled_1;
                let _e45 = gabor_kernel_stretched(_e42, _e43.radius);
                kernel_7 = _e45;
                let _e47 = scaled_1;
                let _e48 = kernel_7;
                let _e49 = i;
                let _e50 = gabor_lobe_seed(seed, _e49);
                let _e51 = gabor_field(_e47, _e48, _e50);
                field_2 = _e51;
                let _e54 = field_2;
                let _e55 = lobe;
                let _e58 = lobe;
                let _e61 = lobe;
                gabor_impl_accumulate((&sum_4), _e54, sqrt(_e55.power), (sqrt(_e58.power) / _e61.radius));
                let _e65 = power;
                let _e66 = lobe;
                power = (_e65 + _e66.power);
            }
            continuing {
                let _e23 = i;
                i = (_e23 + 1i);
            }
        }
        let _e69 = power;
        if (_e69 > 0f) {
            let _e72 = power;
            local_7 = inverseSqrt(_e72);
        } else {
            local_7 = 0f;
        }
        let _e76 = local_7;
        scale = _e76;
        let _e78 = scale;
        let _e79 = sum_4;
        let _e82 = scale;
        let _e83 = sum_4;
        let _e86 = scale;
        let _e87 = sum_4;
        let _e90 = scale;
        let _e91 = sum_4;
        return GaborField((_e78 * _e79.value), (_e82 * _e83.slope_x), (_e86 * _e87.slope_y), (_e90 * _e91.four));
    } else {
        var lobes_1: GaborLobes;
        var sum_4: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
        var power: f32 = 0f;
        var i: i32 = 0i;
        var lobe: GaborLobe;
        var scaled_1: GaborPlace;
        var kernel_7: GaborKernel;
        var field_2: GaborField;
        var local_7: f32;
        var scale: f32;

        lobes_1 = lobes;
        loop {
            let _e18 = i;
            let _e19 = lobes_1;
            if !((_e18 < _e19.count)) {
                break;
            }
            {
                let _e26 = i;
                let _e29 = lobes_1.lobe[_e26];
                lobe = _e29;
                let _e31 = lobe;
                let _e33 = gabor_place_scaled(place, _e31.radius);
                scaled_1 = _e33;
                let _e35 = lobe;
                let _e37 = lobe;
                let _e40 = lobe;
                let _e42 = gabor_kernel((_e35.frequency * _e37.radius), _e40.orientation);
                let _e43 = scaled_1;
                let _e45 = gabor_kernel_stretched(_e42, _e43.radius);
                kernel_7 = _e45;
                let _e47 = scaled_1;
                let _e48 = kernel_7;
                let _e49 = i;
                let _e50 = gabor_lobe_seed(seed, _e49);
                let _e51 = gabor_field(_e47, _e48, _e50);
                field_2 = _e51;
                let _e54 = field_2;
                let _e55 = lobe;
                let _e58 = lobe;
                let _e61 = lobe;
                gabor_impl_accumulate((&sum_4), _e54, sqrt(_e55.power), (sqrt(_e58.power) / _e61.radius));
                let _e65 = power;
                let _e66 = lobe;
                power = (_e65 + _e66.power);
            }
            continuing {
                let _e23 = i;
                i = (_e23 + 1i);
            }
        }
        let _e69 = power;
        if (_e69 > 0f) {
            let _e72 = power;
            local_7 = inverseSqrt(_e72);
        } else {
            local_7 = 0f;
        }
        let _e76 = local_7;
        scale = _e76;
        let _e78 = scale;
        let _e79 = sum_4;
        let _e82 = scale;
        let _e83 = sum_4;
        let _e86 = scale;
        let _e87 = sum_4;
        let _e90 = scale;
        let _e91 = sum_4;
        return GaborField((_e78 * _e79.value), (_e82 * _e83.slope_x), (_e86 * _e87.slope_y), (_e90 * _e91.four));
    }
}

// Of `c`: how many lobes there are, of both numbers where one fades.
fn gabor_impl_pieces(c: f32) -> i32 {
    var local_8: i32;

    if (fract(c) > 0.8f) {
        local_8 = ((2i * i32(c)) + 1i);
    } else {
        local_8 = i32(c);
    }
    let _e11 = local_8;
    return _e11;
}

// Of lobe `i`: its place in the range, from -1 to 1, its share of the power, and a number for its seed.
fn gabor_impl_piece(i: i32, c: f32) -> vec3<f32> {
    var i_2: i32;
    var n: i32;
    var share: f32;
    var width: f32;

    i_2 = i;
    n = i32(c);
    share = min((5f - (5f * fract(c))), 1f);
    let _e13 = i_2;
    let _e14 = n;
    if (_e13 >= _e14) {
        {
            let _e16 = i_2;
            let _e17 = n;
            i_2 = (_e16 - _e17);
            let _e19 = n;
            n = (_e19 + 1i);
            let _e23 = share;
            share = (1f - _e23);
        }
    }
    let _e26 = n;
    width = (1f / f32(_e26));
    let _e31 = i_2;
    let _e36 = width;
    let _e40 = share;
    let _e41 = width;
    let _e43 = i_2;
    let _e44 = n;
    return vec3<f32>(((((2f * f32(_e31)) + 1f) * _e36) - 1f), (_e40 * _e41), f32((_e43 + ((_e44 & 1i) * 64i))));
}

// The noise of a range of waves at a place, as gabor_noise_spread, with quadrature and derivatives per kernel radius.
fn gabor_field_spread(place: GaborPlace, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> GaborField {
    var frequency_8: f32;
    var frequency_spread_1: f32;
    var orientation_spread_1: f32;
    var sum_5: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
    var shells: f32;
    var shell_count: i32;
    var j: i32 = 0i;
    var shell: vec3<f32>;
    var magnitude: f32;
    var directions: f32;
    var direction_count: i32;
    var i_3: i32;
    var direction: vec3<f32>;
    var kernel_8: GaborKernel;
    var field_3: GaborField;
    var amplitude_1: f32;

    frequency_8 = frequency;
    frequency_spread_1 = frequency_spread;
    orientation_spread_1 = orientation_spread;
    let _e19 = frequency_8;
    frequency_8 = min(abs(_e19), 1000000f);
    let _e23 = frequency_spread_1;
    frequency_spread_1 = clamp(_e23, 0f, 1f);
    let _e27 = orientation_spread_1;
    orientation_spread_1 = clamp(_e27, 0f, 1.5707963f);
    let _e32 = frequency_spread_1;
    let _e34 = frequency_8;
    shells = clamp((((2.857f * _e32) * _e34) + 0.8f), 1f, 16f);
    let _e42 = shells;
    let _e43 = gabor_impl_pieces(_e42);
    shell_count = _e43;
    loop {
        let _e47 = j;
        let _e48 = shell_count;
        if !((_e47 < _e48)) {
            break;
        }
        {
            let _e54 = j;
            let _e55 = shells;
            let _e56 = gabor_impl_piece(_e54, _e55);
            shell = _e56;
            let _e58 = frequency_8;
            let _e60 = frequency_spread_1;
            let _e61 = shell;
            magnitude = (_e58 * (1f + (_e60 * _e61.x)));
            let _e68 = orientation_spread_1;
            let _e71 = magnitude;
            directions = clamp((((0.63661975f * _e68) * ((4.44f * _e71) + 0.6f)) + 0.8f), 1f, 64f);
            let _e82 = directions;
            let _e83 = gabor_impl_pieces(_e82);
            direction_count = _e83;
            i_3 = 0i;
            loop {
                let _e87 = i_3;
                let _e88 = direction_count;
                if !((_e87 < _e88)) {
                    break;
                }
                {
                    let _e94 = i_3;
                    let _e95 = directions;
                    let _e96 = gabor_impl_piece(_e94, _e95);
                    direction = _e96;
                    let _e98 = magnitude;
                    let _e99 = orientation_spread_1;
                    let _e100 = direction;
                    let _e104 = gabor_kernel(_e98, (orientation + (_e99 * _e100.x)));
                    kernel_8 = _e104;
                    let _e106 = kernel_8;
                    let _e108 = gabor_kernel_stretched(_e106, place.radius);
                    kernel_8 = _e108;
                    let _e109 = kernel_8;
                    let _e111 = shell;
                    let _e114 = direction;
                    let _e118 = gabor_lobe_seed(seed, i32(((128f * _e111.z) + _e114.z)));
                    let _e119 = gabor_field(place, _e109, _e118);
                    field_3 = _e119;
                    let _e121 = shell;
                    let _e123 = direction;
                    amplitude_1 = sqrt((_e121.y * _e123.y));
                    let _e129 = field_3;
                    let _e130 = amplitude_1;
                    let _e131 = amplitude_1;
                    gabor_impl_accumulate((&sum_5), _e129, _e130, _e131);
                }
                continuing {
                    let _e91 = i_3;
                    i_3 = (_e91 + 1i);
                }
            }
        }
        continuing {
            let _e51 = j;
            j = (_e51 + 1i);
        }
    }
    let _e133 = sum_5;
    return _e133;
}

// What a pixel covers: see gabor_footprint.
struct GaborFootprint {
    covariance: vec3<f32>,
    resolved: vec3<f32>,
}

// A symmetric matrix (xx, yy, xy) times a vector.
fn gabor_impl_symmetric(matrix: vec3<f32>, v: vec2<f32>) -> vec2<f32> {
    return ((matrix.xy * v) + (matrix.z * v.yx));
}

// The share of its variance that a wave's lobe keeps under a filter of covariance S: with the lobe's power taken as
// normal, of variance 1/12 along each axis, as Hann's window has it,
//     |1 + 2/3 pi^2 S|^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F).
fn gabor_impl_transmitted(wave: vec2<f32>, covariance: vec3<f32>) -> f32 {
    var widened: vec3<f32>;
    var determinant_: f32;
    var through: vec2<f32>;
    var exponent: f32;

    widened = (vec3<f32>(1f, 1f, 0f) + (6.579736f * covariance));
    let _e10 = widened;
    let _e12 = widened;
    let _e15 = widened;
    let _e17 = widened;
    determinant_ = ((_e10.x * _e12.y) - (_e15.z * _e17.z));
    let _e22 = widened;
    let _e24 = widened;
    let _e26 = widened;
    let _e30 = gabor_impl_symmetric(vec3<f32>(_e22.y, _e24.x, -(_e26.z)), wave);
    let _e31 = determinant_;
    through = (_e30 / vec2(_e31));
    let _e36 = through;
    let _e37 = gabor_impl_symmetric(covariance, _e36);
    exponent = (39.478416f * dot(wave, _e37));
    let _e41 = exponent;
    let _e46 = determinant_;
    return (exp(-(min(_e41, 80f))) * inverseSqrt(_e46));
}

// Of three waves: the windows of an axis' three nodes, in two parts, real and imaginary. A wave q of Hann's window has
// the factor exp(-2 pi^2 S q^2 - 4 pi^2 (S F) q), q = -1/2, 0, 1/2. Half a deviation from its end a window begins to
// fade.
//   x         offset from the second node, in [-1/2, 1/2) node spacings
//   variance  S along the axis
//   blurred   S F
fn gabor_impl_filtered_windows(x: f32, variance: f32, blurred: f32, real: ptr<function, GaborWindows>, imaginary: ptr<function, GaborWindows>) {
    var rise: f32;
    var part: vec2<f32>;
    var hann: GaborWindows;
    var inside: vec3<f32>;
    var fade: vec4<f32>;
    var wave_2: vec4<f32>;

    rise = exp((19.739208f * blurred));
    let _e15 = rise;
    let _e17 = rise;
    let _e20 = rise;
    let _e22 = rise;
    part = ((0.5f * exp((-4.934802f * variance))) * vec2<f32>((_e15 + (1f / _e17)), (_e20 - (1f / _e22))));
    let _e28 = gabor_impl_windows(x);
    hann = _e28;
    inside = (vec3(1f) - (abs((vec3(x) + vec3<f32>(1f, 0f, -1f))) / vec3(1.5f)));
    let _e48 = inside;
    let _e61 = clamp((_e48 / vec3(clamp((0.5f * sqrt(variance)), 0.001f, 0.05f))), vec3(0f), vec3(1f));
    fade = vec4<f32>(_e61.x, _e61.y, _e61.z, 0f);
    let _e68 = fade;
    let _e69 = fade;
    let _e72 = fade;
    fade = (_e68 * (_e69 * (vec4(3f) - (2f * _e72))));
    let _e78 = fade;
    let _e79 = hann;
    wave_2 = (_e78 * (_e79.value - vec4(0.5f)));
    let _e87 = hann;
    let _e89 = fade;
    hann.slope = (_e87.slope * _e89);
    let _e92 = fade;
    let _e94 = part;
    let _e96 = wave_2;
    let _e99 = part;
    let _e101 = hann;
    (*real) = GaborWindows(((0.5f * _e92) + (_e94.x * _e96)), (_e99.x * _e101.slope));
    let _e106 = part;
    let _e109 = hann;
    let _e114 = part;
    let _e117 = wave_2;
    (*imaginary) = GaborWindows(((0.3183099f * _e106.y) * _e109.slope), ((-3.1415927f * _e114.y) * _e117));
    return;
}

// The noise at a place, filtered by three waves along each axis.
fn gabor_impl_filtered_narrow(place: GaborPlace, kernel: GaborKernel, wave: vec2<f32>, s: vec3<f32>, seed: u32) -> GaborField {
    var kernel_10: GaborKernel;
    var first_2: vec2<f32>;
    var offset_1: vec2<f32>;
    var node_1: vec2<i32>;
    var salt_4: u32;
    var blurred_1: vec2<f32>;
    var real_3: GaborWindows;
    var imaginary_3: GaborWindows;
    var columns_4: GaborAxis;
    var rows_3: GaborAxis;
    var sum_6: GaborSum;
    var base_1: vec2<f32>;
    var value_2: vec2<f32>;
    var turned_1: vec2<f32>;
    var slope_x: vec2<f32>;

    kernel_10 = kernel;
    first_2 = (floor((place.local - vec2(1.5f))) + vec2(1f));
    let _e19 = first_2;
    offset_1 = ((place.local - _e19) - vec2(1f));
    let _e26 = first_2;
    node_1 = (place.cell + vec2<i32>(_e26));
    let _e30 = gabor_impl_salt(seed);
    salt_4 = _e30;
    let _e32 = gabor_impl_symmetric(s, wave);
    blurred_1 = _e32;
    let _e36 = offset_1;
    let _e39 = blurred_1;
    gabor_impl_filtered_windows(_e36.x, s.x, _e39.x, (&real_3), (&imaginary_3));
    let _e45 = node_1;
    let _e49 = salt_4;
    let _e50 = kernel_10;
    let _e52 = real_3;
    let _e53 = imaginary_3;
    let _e54 = gabor_impl_axis(_e45.x, place.period.x, _e49, _e50.step_x, _e52, _e53);
    columns_4 = _e54;
    let _e56 = offset_1;
    let _e59 = blurred_1;
    gabor_impl_filtered_windows(_e56.y, s.y, _e59.y, (&real_3), (&imaginary_3));
    let _e65 = node_1;
    let _e69 = salt_4;
    let _e72 = kernel_10;
    let _e74 = real_3;
    let _e75 = imaginary_3;
    let _e76 = gabor_impl_axis(_e65.y, place.period.y, (_e69 ^ 1540483477u), _e72.step_y, _e74, _e75);
    rows_3 = _e76;
    let _e78 = columns_4;
    let _e79 = rows_3;
    let _e82 = gabor_impl_sum(_e78, _e79, place.animated, place.time);
    sum_6 = _e82;
    let _e86 = blurred_1;
    let _e90 = offset_1;
    let _e98 = gabor_impl_wave(dot(wave, (_e90 / vec2(1.5f))));
    base_1 = (exp((-19.739208f * dot(wave, _e86))) * _e98);
    let _e102 = sum_6;
    let _e105 = sum_6;
    sum_6.real = (_e102.real + (s.z * _e105.mixed_real));
    let _e110 = sum_6;
    let _e113 = sum_6;
    sum_6.imaginary = (_e110.imaginary + (s.z * _e113.mixed_imaginary));
    let _e117 = sum_6;
    let _e120 = sum_6;
    let _e124 = base_1;
    let _e125 = gabor_impl_product(vec2<f32>(_e117.real.x, _e120.imaginary.x), _e124);
    value_2 = _e125;
    let _e128 = value_2;
    let _e131 = value_2;
    turned_1 = (6.2831855f * vec2<f32>(-(_e128.y), _e131.x));
    let _e136 = sum_6;
    let _e139 = sum_6;
    slope_x = vec2<f32>(_e136.slope_real.x, _e139.slope_imaginary.x);
    let _e144 = value_2;
    let _e145 = slope_x;
    let _e146 = base_1;
    let _e147 = gabor_impl_product(_e145, _e146);
    let _e149 = turned_1;
    let _e152 = sum_6;
    let _e154 = base_1;
    let _e155 = gabor_impl_product(_e152.slope_y, _e154);
    let _e157 = turned_1;
    let _e160 = base_1;
    let _e162 = sum_6;
    let _e165 = base_1;
    let _e167 = sum_6;
    return GaborField(_e144, (_e147 + (wave.x * _e149)), (_e155 + (wave.y * _e157)), ((_e160.x * _e162.imaginary) + (_e165.y * _e167.real)));
}

// Of nine waves: complex numbers for the factors 1, z and z^2 - 1/2 of an axis.
struct GaborFactors {
    real: vec3<f32>,
    imaginary: vec3<f32>,
}

// An axis: its filtered windows are, for each factor, mean + even . cos(2 pi q d) + i odd . sin(2 pi q d) with the four
// q = 0.3, 0.6, 0.9 and 1.2, at a distance of d kernel radii.
struct GaborBand {
    g: f32,
    c: f32,
    mean: vec3<f32>,
    even_0_: vec4<f32>,
    even_1_: vec4<f32>,
    even_2_: vec4<f32>,
    odd_0_: vec4<f32>,
    odd_1_: vec4<f32>,
    odd_2_: vec4<f32>,
    offset: f32,
    first: i32,
    period: i32,
    salt: u32,
    back: vec2<f32>,
}

// With the windows; `m` is r M.
fn gabor_impl_band(m: f32, c: f32, offset: f32, first: i32, period: i32, salt: u32, step: vec2<f32>) -> GaborBand {
    var b_4: GaborBand;
    var center: f32;
    var fall: f32;
    var fall_4_: f32;
    var rise_1: f32;
    var rises: vec4<f32>;
    var wave_4: vec4<f32> = vec4<f32>(0.23650835f, 0.1063056f, 0.01392097f, -0.00794986f);
    var q: vec4<f32> = vec4<f32>(0.3f, 0.6f, 0.9f, 1.2f);
    var z: f32;

    b_4.g = (19.739208f * m);
    b_4.c = c;
    let _e12 = b_4;
    center = exp(((-(_e12.g) * c) * c));
    fall = exp((0.23217617f - (1.7765288f * m)));
    let _e25 = fall;
    let _e26 = fall;
    let _e28 = fall;
    let _e30 = fall;
    fall_4_ = (((_e25 * _e26) * _e28) * _e30);
    let _e34 = b_4;
    rise_1 = exp(((0.6f * _e34.g) * c));
    let _e40 = rise_1;
    let _e41 = rise_1;
    let _e42 = rise_1;
    let _e44 = rise_1;
    let _e45 = rise_1;
    let _e47 = rise_1;
    let _e49 = rise_1;
    let _e50 = rise_1;
    let _e52 = rise_1;
    let _e54 = rise_1;
    rises = vec4<f32>(_e40, (_e41 * _e42), ((_e44 * _e45) * _e47), (((_e49 * _e50) * _e52) * _e54));
    let _e65 = wave_4;
    let _e66 = center;
    let _e67 = fall;
    let _e68 = fall_4_;
    let _e69 = fall_4_;
    let _e70 = fall_4_;
    let _e72 = fall;
    let _e74 = fall_4_;
    let _e75 = fall_4_;
    let _e77 = fall_4_;
    let _e79 = fall_4_;
    wave_4 = (_e65 * (_e66 * vec4<f32>(_e67, _e68, ((_e69 * _e70) * _e72), (((_e74 * _e75) * _e77) * _e79))));
    let _e91 = b_4;
    z = sqrt((2f * _e91.g));
    let _e98 = center;
    let _e101 = z;
    let _e104 = z;
    let _e106 = z;
    b_4.mean = ((0.3f * _e98) * vec3<f32>(1f, (-(_e101) * c), ((((_e104 * c) * _e106) * c) - 0.5f)));
    let _e114 = wave_4;
    let _e115 = rises;
    let _e117 = wave_4;
    let _e118 = rises;
    b_4.even_0_ = ((_e114 * _e115) + (_e117 / _e118));
    let _e122 = wave_4;
    let _e123 = rises;
    let _e125 = wave_4;
    let _e126 = rises;
    b_4.odd_0_ = ((_e122 * _e123) - (_e125 / _e126));
    let _e130 = z;
    let _e131 = q;
    let _e132 = b_4;
    let _e135 = b_4;
    b_4.even_1_ = (_e130 * ((_e131 * _e132.odd_0_) - (c * _e135.even_0_)));
    let _e141 = z;
    let _e142 = q;
    let _e143 = b_4;
    let _e146 = b_4;
    b_4.odd_1_ = (_e141 * ((_e142 * _e143.even_0_) - (c * _e146.odd_0_)));
    let _e152 = z;
    let _e153 = q;
    let _e154 = b_4;
    let _e157 = b_4;
    let _e163 = b_4;
    b_4.even_2_ = ((_e152 * ((_e153 * _e154.odd_1_) - (c * _e157.even_1_))) - (0.5f * _e163.even_0_));
    let _e168 = z;
    let _e169 = q;
    let _e170 = b_4;
    let _e173 = b_4;
    let _e179 = b_4;
    b_4.odd_2_ = ((_e168 * ((_e169 * _e170.even_1_) - (c * _e173.odd_1_))) - (0.5f * _e179.odd_0_));
    b_4.offset = offset;
    b_4.first = first;
    b_4.period = period;
    b_4.salt = salt;
    b_4.back = vec2<f32>(step.x, -(step.y));
    let _e192 = b_4;
    return _e192;
}

// A column or a row of nodes: its word and its window for each factor, with the noise's wave.
struct GaborLine {
    word: u32,
    window: GaborFactors,
    turn: vec2<f32>,
    phase: vec2<f32>,
}

// Line `index`, 0 to 4, from the turn and the phase of the one before.
fn gabor_impl_filtered_line(line: GaborLine, b: GaborBand, index: i32) -> GaborLine {
    var line_1: GaborLine;
    var two_1: vec2<f32>;
    var three: vec2<f32>;
    var four: vec2<f32>;
    var cosine_2: vec4<f32>;
    var sine_2: vec4<f32>;
    var real_4: vec3<f32>;
    var imaginary_4: vec3<f32>;
    var fade_1: f32;
    var phase_1: vec2<f32>;

    line_1 = line;
    let _e8 = gabor_impl_wrap((b.first + index), b.period);
    let _e10 = gabor_impl_line_word(_e8, b.salt);
    line_1.word = _e10;
    let _e12 = line_1;
    let _e18 = gabor_impl_product(_e12.turn, vec2<f32>(0.309017f, -0.95105654f));
    line_1.turn = _e18;
    let _e20 = line_1;
    let _e23 = gabor_impl_product(_e20.phase, b.back);
    line_1.phase = _e23;
    let _e24 = line_1;
    let _e26 = line_1;
    let _e28 = gabor_impl_product(_e24.turn, _e26.turn);
    two_1 = _e28;
    let _e30 = two_1;
    let _e31 = line_1;
    let _e33 = gabor_impl_product(_e30, _e31.turn);
    three = _e33;
    let _e35 = two_1;
    let _e36 = two_1;
    let _e37 = gabor_impl_product(_e35, _e36);
    four = _e37;
    let _e39 = line_1;
    let _e42 = two_1;
    let _e44 = three;
    let _e46 = four;
    cosine_2 = vec4<f32>(_e39.turn.x, _e42.x, _e44.x, _e46.x);
    let _e50 = line_1;
    let _e53 = two_1;
    let _e55 = three;
    let _e57 = four;
    sine_2 = vec4<f32>(_e50.turn.y, _e53.y, _e55.y, _e57.y);
    let _e63 = cosine_2;
    let _e66 = cosine_2;
    let _e69 = cosine_2;
    real_4 = (b.mean + vec3<f32>(dot(b.even_0_, _e63), dot(b.even_1_, _e66), dot(b.even_2_, _e69)));
    let _e75 = sine_2;
    let _e78 = sine_2;
    let _e81 = sine_2;
    imaginary_4 = vec3<f32>(dot(b.odd_0_, _e75), dot(b.odd_1_, _e78), dot(b.odd_2_, _e81));
    fade_1 = clamp((5.555556f - (2.222222f * abs((b.offset - f32(index))))), 0f, 1f);
    let _e97 = fade_1;
    let _e98 = fade_1;
    let _e102 = fade_1;
    let _e106 = line_1;
    phase_1 = (((_e97 * _e98) * (3f - (2f * _e102))) * _e106.phase);
    let _e111 = phase_1;
    let _e113 = real_4;
    let _e115 = phase_1;
    let _e117 = imaginary_4;
    let _e120 = phase_1;
    let _e122 = imaginary_4;
    let _e124 = phase_1;
    let _e126 = real_4;
    line_1.window = GaborFactors(((_e111.x * _e113) - (_e115.y * _e117)), ((_e120.x * _e122) + (_e124.y * _e126)));
    let _e130 = line_1;
    return _e130;
}

// A row's sums of amplitudes times windows, of four noises.
struct GaborRow {
    first: GaborFactors,
    second: GaborFactors,
    third: GaborFactors,
    fourth: GaborFactors,
}

fn gabor_impl_add_amplitude(sum: ptr<function, GaborFactors>, window: GaborFactors, a: vec2<f32>) {
    let _e4 = (*sum);
    (*sum).real = (_e4.real + ((a.x * window.real) - (a.y * window.imaginary)));
    let _e15 = (*sum);
    (*sum).imaginary = (_e15.imaginary + ((a.x * window.imaginary) + (a.y * window.real)));
    return;
}

// Adds a node.
fn gabor_impl_add_filtered(row: ptr<function, GaborRow>, column: GaborLine, row_word: u32, animated: bool, time: vec2<f32>) {
    var word_8: u32;

    let _e6 = gabor_impl_node_word(column.word, row_word);
    word_8 = _e6;
    let _e8 = (*row);
    let _e11 = word_8;
    let _e12 = gabor_impl_amplitude_at(_e11, animated, time);
    gabor_impl_add_amplitude((&(*row).first), column.window, _e12);
    let _e15 = word_8;
    let _e16 = gabor_impl_next_word(_e15);
    word_8 = _e16;
    let _e17 = (*row);
    let _e20 = word_8;
    let _e21 = gabor_impl_amplitude_at(_e20, animated, time);
    gabor_impl_add_amplitude((&(*row).second), column.window, _e21);
    let _e24 = word_8;
    let _e25 = gabor_impl_next_word(_e24);
    word_8 = _e25;
    let _e26 = (*row);
    let _e29 = word_8;
    let _e30 = gabor_impl_amplitude_at(_e29, animated, time);
    gabor_impl_add_amplitude((&(*row).third), column.window, _e30);
    let _e33 = word_8;
    let _e34 = gabor_impl_next_word(_e33);
    word_8 = _e34;
    let _e35 = (*row);
    let _e38 = word_8;
    let _e39 = gabor_impl_amplitude_at(_e38, animated, time);
    gabor_impl_add_amplitude((&(*row).fourth), column.window, _e39);
    return;
}

// q times each factor, from the factors themselves, but for what z^3 has of the next of Hermite's polynomials.
fn gabor_impl_times_q(f: GaborFactors, b: GaborBand) -> GaborFactors {
    var z_1: f32;

    z_1 = inverseSqrt((2f * b.g));
    let _e7 = z_1;
    let _e25 = z_1;
    return GaborFactors(((_e7 * vec3<f32>(f.real.y, (f.real.z + (0.5f * f.real.x)), f.real.y)) + (b.c * f.real)), ((_e25 * vec3<f32>(f.imaginary.y, (f.imaginary.z + (0.5f * f.imaginary.x)), f.imaginary.y)) + (b.c * f.imaginary)));
}

// The sum over the factors of both axes.
fn gabor_impl_contracted(a: GaborFactors, b: GaborFactors, weights: vec3<f32>) -> vec2<f32> {
    return vec2<f32>(dot(weights, ((a.real * b.real) - (a.imaginary * b.imaginary))), dot(weights, ((a.real * b.imaginary) + (a.imaginary * b.real))));
}

// The noise at a place, filtered by nine waves along each axis.
fn gabor_impl_filtered_wide(place: GaborPlace, kernel: GaborKernel, wave: vec2<f32>, s: vec3<f32>, rows: i32, seed: u32) -> GaborField {
    var kernel_12: GaborKernel;
    var m_1: vec2<f32>;
    var blurred_2: vec2<f32>;
    var c_6: vec2<f32>;
    var rho: f32;
    var r_1: f32;
    var lambda: f32;
    var weights_1: vec3<f32>;
    var first_4: vec2<f32>;
    var offset_3: vec2<f32>;
    var node_2: vec2<i32>;
    var salt_6: u32;
    var time_6: vec2<f32>;
    var across: GaborBand;
    var along: GaborBand;
    var line_2: GaborLine;
    var c0_: GaborLine;
    var c1_: GaborLine;
    var c2_: GaborLine;
    var c3_: GaborLine;
    var c4_: GaborLine;
    var sum_8: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
    var j_1: i32 = 0i;
    var none_1: GaborFactors;
    var row_4: GaborRow;
    var value_3: vec2<f32>;
    var amplitude_2: f32;
    var x_2: vec2<f32>;
    var y_1: vec2<f32>;

    kernel_12 = kernel;
    m_1 = (s.xy + vec2(0.13069098f));
    let _e12 = gabor_impl_symmetric(s, wave);
    blurred_2 = _e12;
    let _e14 = m_1;
    let _e15 = _e14.yx;
    let _e21 = blurred_2;
    let _e22 = gabor_impl_symmetric(vec3<f32>(_e15.x, _e15.y, -(s.z)), _e21);
    let _e26 = m_1;
    let _e28 = m_1;
    c_6 = (_e22 / vec2(((s.z * s.z) - (_e26.x * _e28.y))));
    let _e36 = m_1;
    let _e38 = m_1;
    rho = (s.z * inverseSqrt((_e36.x * _e38.y)));
    let _e45 = rho;
    let _e46 = rho;
    r_1 = sqrt((1f - (_e45 * _e46)));
    let _e51 = rho;
    let _e53 = r_1;
    lambda = (_e51 / (1f + _e53));
    let _e60 = lambda;
    let _e63 = lambda;
    let _e65 = lambda;
    weights_1 = vec3<f32>(1f, (-2f * _e60), ((2f * _e63) * _e65));
    first_4 = (floor((place.local + vec2(0.5f))) - vec2(2f));
    let _e79 = first_4;
    offset_3 = (place.local - _e79);
    let _e83 = first_4;
    node_2 = (place.cell + vec2<i32>(_e83));
    let _e87 = gabor_impl_salt(seed);
    salt_6 = _e87;
    let _e90 = gabor_impl_wave(place.time);
    time_6 = _e90;
    let _e92 = r_1;
    let _e93 = m_1;
    let _e96 = c_6;
    let _e98 = offset_3;
    let _e100 = node_2;
    let _e104 = salt_6;
    let _e105 = kernel_12;
    let _e107 = gabor_impl_band((_e92 * _e93.x), _e96.x, _e98.x, _e100.x, place.period.x, _e104, _e105.step_x);
    across = _e107;
    let _e109 = r_1;
    let _e110 = m_1;
    let _e113 = c_6;
    let _e115 = offset_3;
    let _e117 = node_2;
    let _e121 = salt_6;
    let _e124 = kernel_12;
    let _e126 = gabor_impl_band((_e109 * _e110.y), _e113.y, _e115.y, _e117.y, place.period.y, (_e121 ^ 1540483477u), _e124.step_y);
    along = _e126;
    let _e131 = offset_3;
    let _e136 = gabor_impl_wave((0.2f * (_e131.x + 1f)));
    line_2.turn = _e136;
    let _e138 = kernel_12;
    line_2.phase = _e138.step_x;
    let _e140 = line_2;
    let _e141 = across;
    let _e143 = gabor_impl_filtered_line(_e140, _e141, 0i);
    c0_ = _e143;
    let _e145 = c0_;
    let _e146 = across;
    let _e148 = gabor_impl_filtered_line(_e145, _e146, 1i);
    c1_ = _e148;
    let _e150 = c1_;
    let _e151 = across;
    let _e153 = gabor_impl_filtered_line(_e150, _e151, 2i);
    c2_ = _e153;
    let _e155 = c2_;
    let _e156 = across;
    let _e158 = gabor_impl_filtered_line(_e155, _e156, 3i);
    c3_ = _e158;
    let _e160 = c3_;
    let _e161 = across;
    let _e163 = gabor_impl_filtered_line(_e160, _e161, 4i);
    c4_ = _e163;
    let _e167 = offset_3;
    let _e172 = gabor_impl_wave((0.2f * (_e167.y + 1f)));
    line_2.turn = _e172;
    let _e174 = offset_3;
    let _e182 = gabor_impl_wave(dot(wave, (_e174 / vec2(1.5f))));
    let _e183 = kernel_12;
    let _e185 = gabor_impl_product(_e182, _e183.step_y);
    line_2.phase = _e185;
    loop {
        let _e198 = j_1;
        if !((_e198 < rows)) {
            break;
        }
        {
            let _e204 = line_2;
            let _e205 = along;
            let _e206 = j_1;
            let _e207 = gabor_impl_filtered_line(_e204, _e205, _e206);
            line_2 = _e207;
            none_1 = GaborFactors(vec3(0f), vec3(0f));
            let _e214 = none_1;
            let _e215 = none_1;
            let _e216 = none_1;
            let _e217 = none_1;
            row_4 = GaborRow(_e214, _e215, _e216, _e217);
            let _e221 = c0_;
            let _e222 = line_2;
            let _e225 = time_6;
            gabor_impl_add_filtered((&row_4), _e221, _e222.word, place.animated, _e225);
            let _e228 = c1_;
            let _e229 = line_2;
            let _e232 = time_6;
            gabor_impl_add_filtered((&row_4), _e228, _e229.word, place.animated, _e232);
            let _e235 = c2_;
            let _e236 = line_2;
            let _e239 = time_6;
            gabor_impl_add_filtered((&row_4), _e235, _e236.word, place.animated, _e239);
            let _e242 = c3_;
            let _e243 = line_2;
            let _e246 = time_6;
            gabor_impl_add_filtered((&row_4), _e242, _e243.word, place.animated, _e246);
            let _e249 = c4_;
            let _e250 = line_2;
            let _e253 = time_6;
            gabor_impl_add_filtered((&row_4), _e249, _e250.word, place.animated, _e253);
            let _e255 = row_4;
            let _e257 = line_2;
            let _e259 = weights_1;
            let _e260 = gabor_impl_contracted(_e255.first, _e257.window, _e259);
            value_3 = _e260;
            let _e263 = sum_8;
            let _e265 = value_3;
            sum_8.value = (_e263.value + _e265);
            let _e268 = sum_8;
            let _e270 = row_4;
            let _e272 = across;
            let _e273 = gabor_impl_times_q(_e270.first, _e272);
            let _e274 = line_2;
            let _e276 = weights_1;
            let _e277 = gabor_impl_contracted(_e273, _e274.window, _e276);
            sum_8.slope_x = (_e268.slope_x + _e277);
            let _e280 = sum_8;
            let _e282 = row_4;
            let _e284 = line_2;
            let _e286 = along;
            let _e287 = gabor_impl_times_q(_e284.window, _e286);
            let _e288 = weights_1;
            let _e289 = gabor_impl_contracted(_e282.first, _e287, _e288);
            sum_8.slope_y = (_e280.slope_y + _e289);
            let _e292 = sum_8;
            let _e294 = value_3;
            let _e296 = row_4;
            let _e298 = line_2;
            let _e300 = weights_1;
            let _e301 = gabor_impl_contracted(_e296.second, _e298.window, _e300);
            let _e303 = row_4;
            let _e305 = line_2;
            let _e307 = weights_1;
            let _e308 = gabor_impl_contracted(_e303.third, _e305.window, _e307);
            let _e310 = row_4;
            let _e312 = line_2;
            let _e314 = weights_1;
            let _e315 = gabor_impl_contracted(_e310.fourth, _e312.window, _e314);
            sum_8.four = (_e292.four + vec4<f32>(_e294.y, _e301.y, _e308.y, _e315.y));
        }
        continuing {
            let _e201 = j_1;
            j_1 = (_e201 + 1i);
        }
    }
    let _e320 = lambda;
    let _e321 = lambda;
    let _e327 = c_6;
    let _e329 = blurred_2;
    amplitude_2 = (sqrt((1f - (_e320 * _e321))) * exp((-19.739208f * dot((wave + _e327), _e329))));
    let _e336 = sum_8;
    let _e339 = sum_8;
    x_2 = (6.2831855f * (_e336.slope_x + (wave.x * _e339.value)));
    let _e346 = sum_8;
    let _e349 = sum_8;
    y_1 = (6.2831855f * (_e346.slope_y + (wave.y * _e349.value)));
    let _e355 = amplitude_2;
    let _e356 = sum_8;
    let _e359 = amplitude_2;
    let _e360 = x_2;
    let _e363 = x_2;
    let _e367 = amplitude_2;
    let _e368 = y_1;
    let _e371 = y_1;
    let _e375 = amplitude_2;
    let _e376 = sum_8;
    return GaborField((_e355 * _e356.value), (_e359 * vec2<f32>(-(_e360.y), _e363.x)), (_e367 * vec2<f32>(-(_e368.y), _e371.x)), (_e375 * _e376.four));
}

// The noise at a place as a pixel sees it, as gabor_field, and the share of its variance that is removed: what the
// functions below call. For periods, whose nodes are not 1 / GABOR_RADIUS apart, give gabor_footprint steps times
// place.radius / GABOR_RADIUS.
fn gabor_field_filtered(place: GaborPlace, kernel: GaborKernel, footprint: GaborFootprint, seed: u32, removed: ptr<function, f32>) -> GaborField {
    var kernel_14: GaborKernel;
    var stretch_1: vec2<f32>;
    var wave_6: vec2<f32>;
    var transmitted: f32;
    var sum_9: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
    var s_4: vec3<f32>;
    var amplitude_3: f32 = 0.00000000000000000000000000060884664f;
    var wide: f32;
    var share_1: f32;
    var share_2: f32;
    var local_9: i32;
    var rows_5: i32;

    kernel_14 = kernel;
    stretch_1 = (place.radius / vec2(1.5f));
    let _e14 = kernel_14;
    let _e16 = stretch_1;
    wave_6 = (_e14.wave / _e16);
    let _e19 = wave_6;
    let _e21 = gabor_impl_transmitted(_e19, footprint.covariance);
    transmitted = _e21;
    let _e24 = transmitted;
    (*removed) = (1f - _e24);
    let _e36 = transmitted;
    if (_e36 < 0.0000000001f) {
        let _e39 = sum_9;
        return _e39;
    }
    s_4 = footprint.resolved;
    if any((footprint.resolved != footprint.covariance)) {
        let _e52 = amplitude_3;
        let _e53 = transmitted;
        let _e54 = wave_6;
        let _e55 = s_4;
        let _e56 = gabor_impl_transmitted(_e54, _e55);
        amplitude_3 = (_e52 * sqrt((_e53 / _e56)));
    }
    let _e61 = s_4;
    let _e63 = s_4;
    wide = clamp(((33.333332f * sqrt(max(_e61.x, _e63.y))) - 2.6666667f), 0f, 1f);
    let _e74 = wide;
    if (_e74 < 1f) {
        {
            let _e78 = wide;
            let _e80 = amplitude_3;
            share_1 = ((1f - _e78) * _e80);
            let _e84 = kernel_14;
            let _e85 = wave_6;
            let _e86 = s_4;
            let _e87 = gabor_impl_filtered_narrow(place, _e84, _e85, _e86, seed);
            let _e88 = share_1;
            let _e89 = share_1;
            gabor_impl_accumulate((&sum_9), _e87, _e88, _e89);
        }
    }
    let _e91 = wide;
    if (_e91 > 0f) {
        {
            let _e94 = wide;
            let _e95 = amplitude_3;
            share_2 = (_e94 * _e95);
            let _e98 = wide;
            if (_e98 > 0f) {
                local_9 = 5i;
            } else {
                local_9 = 0i;
            }
            let _e104 = local_9;
            rows_5 = _e104;
            let _e107 = kernel_14;
            let _e108 = wave_6;
            let _e109 = s_4;
            let _e110 = rows_5;
            let _e111 = gabor_impl_filtered_wide(place, _e107, _e108, _e109, _e110, seed);
            let _e112 = share_2;
            let _e113 = share_2;
            gabor_impl_accumulate((&sum_9), _e111, _e112, _e113);
        }
    }
    let _e116 = sum_9;
    let _e118 = stretch_1;
    sum_9.slope_x = (_e116.slope_x * _e118.x);
    let _e122 = sum_9;
    let _e124 = stretch_1;
    sum_9.slope_y = (_e122.slope_y * _e124.y);
    let _e127 = sum_9;
    return _e127;
}

// A lobe of waves around one wave vector.
//   frequency, orientation  as for gabor_noise, whatever the radius: cycles per unit of p, radians
//   radius                  of its kernel, positive: the lobe's bandwidth falls with it, as 1/sqrt(12) / radius cycles
//                           (standard deviation along each axis)
//   power                   in proportion to other lobes', not negative
fn gabor_lobe(frequency: f32, orientation: f32, radius: f32, power: f32) -> GaborLobe {
    return GaborLobe(frequency, orientation, radius, power);
}

// The noise of several lobes at p, a sum of independent noises [TNVT19, figure 6]: normal, mean 0, variance 1. At the
// cost of gabor_noise for each lobe.
//     #define GABOR_LOBES 2              // before the file
//     GaborLobes lobes;
//     lobes.lobe[0] = gabor_lobe(4.0, 0.0, 1.0, 2.0);
//     lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.5, 1.0);
//     lobes.count = 2;
fn gabor_noise_lobes(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> f32 {
    if GABOR_TAPS == 2 {
        var lobes_3: GaborLobes;

        lobes_3 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = lobes_3;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        return _e13.value.y;
    } else if GABOR_TAPS == 4 {
        var lobes_3: GaborLobes;

        lobes_3 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = lobes_3;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        return _e13.value.y;
    } else {
        var lobes_3: GaborLobes;

        lobes_3 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = lobes_3;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        return _e13.value.y;
    }
}

// The same with its analytic gradient: (noise, d/dx, d/dy).
fn gabor_noise_lobes_gradient(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec3<f32> {
    if GABOR_TAPS == 2 {
        var lobes_5: GaborLobes;
        var field_4: GaborField;

        lobes_5 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = lobes_5;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        field_4 = _e13;
        let _e15 = field_4;
        let _e18 = field_4;
        let _e21 = field_4;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    } else if GABOR_TAPS == 4 {
        var lobes_5: GaborLobes;
        var field_4: GaborField;

        lobes_5 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = lobes_5;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        field_4 = _e13;
        let _e15 = field_4;
        let _e18 = field_4;
        let _e21 = field_4;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    } else {
        var lobes_5: GaborLobes;
        var field_4: GaborField;

        lobes_5 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = lobes_5;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        field_4 = _e13;
        let _e15 = field_4;
        let _e18 = field_4;
        let _e21 = field_4;
        return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
    }
}

// The same with its quadrature, as gabor_noise_complex.
fn gabor_noise_lobes_complex(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec2<f32> {
    if GABOR_TAPS == 2 {
        var lobes_7: GaborLobes;

        lobes_7 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 1f));
        let _e12 = lobes_7;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        return _e13.value;
    } else if GABOR_TAPS == 4 {
        var lobes_7: GaborLobes;

        lobes_7 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 2f));
        let _e12 = lobes_7;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        return _e13.value;
    } else {
        var lobes_7: GaborLobes;

        lobes_7 = lobes;
        let _e11 = gabor_place(vec2(0i), (p * 1.5f));
        let _e12 = lobes_7;
        let _e13 = gabor_field_lobes(_e11, _e12, seed);
        return _e13.value;
    }
}

// Noise of many waves at p: within `orientation_spread` radians of the orientation and within the share
// `frequency_spread` (0 to 1) of the frequency, both evenly spread, as far as lobes of kernel radius 1 can be. pi/2
// radians are every direction: isotropic noise, whose power varies with direction by at most 5 %. Normal with all its
// derivatives, mean 0, variance 1. Continuous where the arguments are.
// Cost: that of gabor_noise for each lobe. Of directions there are, with o for the orientation_spread,
//     (4.44 frequency + 0.6) o / (pi/2) + 0.8, rounded down, from 1 to 64,
// 10 for isotropic noise of frequency 2, and of frequencies in the same way 2.86 frequency_spread frequency + 0.8, up
// to 16; at some arguments, a fifth of all, two such numbers next to each other together.
fn gabor_noise_spread(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> f32 {
    if GABOR_TAPS == 2 {
        var place_7: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 1f));
        place_7 = _e13;
        let _e15 = place_7;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value.y;
    } else if GABOR_TAPS == 4 {
        var place_7: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 2f));
        place_7 = _e13;
        let _e15 = place_7;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value.y;
    } else {
        var place_10: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 1.5f));
        place_10 = _e13;
        let _e15 = place_10;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value.y;
    }
}

// The same with its analytic gradient: (noise, d/dx, d/dy).
fn gabor_noise_spread_gradient(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> vec3<f32> {
    if GABOR_TAPS == 2 {
        var place_8: GaborPlace;
        var field_5: GaborField;

        let _e13 = gabor_place(vec2(0i), (p * 1f));
        place_8 = _e13;
        let _e15 = place_8;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        field_5 = _e16;
        let _e18 = field_5;
        let _e21 = field_5;
        let _e24 = field_5;
        return vec3<f32>(_e18.value.y, _e21.slope_x.y, _e24.slope_y.y);
    } else if GABOR_TAPS == 4 {
        var place_8: GaborPlace;
        var field_5: GaborField;

        let _e13 = gabor_place(vec2(0i), (p * 2f));
        place_8 = _e13;
        let _e15 = place_8;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        field_5 = _e16;
        let _e18 = field_5;
        let _e21 = field_5;
        let _e24 = field_5;
        return vec3<f32>(_e18.value.y, _e21.slope_x.y, _e24.slope_y.y);
    } else {
        var place_11: GaborPlace;
        var field_5: GaborField;

        let _e13 = gabor_place(vec2(0i), (p * 1.5f));
        place_11 = _e13;
        let _e15 = place_11;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        field_5 = _e16;
        let _e18 = field_5;
        let _e21 = field_5;
        let _e24 = field_5;
        return vec3<f32>(_e18.value.y, _e21.slope_x.y, _e24.slope_y.y);
    }
}

// The same with its quadrature, as gabor_noise_complex.
fn gabor_noise_spread_complex(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> vec2<f32> {
    if GABOR_TAPS == 2 {
        var place_9: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 1f));
        place_9 = _e13;
        let _e15 = place_9;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value;
    } else if GABOR_TAPS == 4 {
        var place_9: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 2f));
        place_9 = _e13;
        let _e15 = place_9;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value;
    } else {
        var place_12: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 1.5f));
        place_12 = _e13;
        let _e15 = place_12;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value;
    }
}

// What a pixel covers that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p) in kernel radii: a normal
// filter of covariance (dx dx^T + dy dy^T) / 4, half a pixel's standard deviation. Any two vectors, parallel ones too.
fn gabor_footprint(dx: vec2<f32>, dy: vec2<f32>) -> GaborFootprint {
    var dx_1: vec2<f32>;
    var dy_1: vec2<f32>;
    var footprint_1: GaborFootprint;
    var mean: f32;
    var axis: vec2<f32>;
    var apart: f32;
    var larger: f32;
    var side: f32;
    var local_10: f32;
    var smaller: f32;
    var local_11: f32;

    dx_1 = dx;
    dy_1 = dy;
    let _e4 = dx_1;
    let _e5 = dx_1;
    let _e7 = dy_1;
    let _e8 = dy_1;
    if !(((dot(_e4, _e5) + dot(_e7, _e8)) < 1000000f)) {
        {
            dx_1 = vec2<f32>(1000f, 0f);
            dy_1 = vec2<f32>(0f, 1000f);
        }
    }
    let _e23 = dx_1;
    let _e24 = dx_1;
    let _e26 = dy_1;
    let _e27 = dy_1;
    let _e29 = ((_e23 * _e24) + (_e26 * _e27));
    let _e30 = dx_1;
    let _e32 = dx_1;
    let _e35 = dy_1;
    let _e37 = dy_1;
    footprint_1.covariance = (0.25f * vec3<f32>(_e29.x, _e29.y, ((_e30.x * _e32.y) + (_e35.x * _e37.y))));
    let _e46 = footprint_1;
    let _e49 = footprint_1;
    mean = (0.5f * (_e46.covariance.x + _e49.covariance.y));
    let _e56 = footprint_1;
    let _e59 = footprint_1;
    let _e64 = footprint_1;
    axis = vec2<f32>((0.5f * (_e56.covariance.x - _e59.covariance.y)), _e64.covariance.z);
    let _e69 = axis;
    apart = length(_e69);
    let _e72 = mean;
    let _e73 = apart;
    larger = (_e72 + _e73);
    let _e77 = dx_1;
    let _e79 = dy_1;
    let _e82 = dx_1;
    let _e84 = dy_1;
    side = (0.25f * ((_e77.x * _e79.y) - (_e82.y * _e84.x)));
    let _e90 = larger;
    if (_e90 > 0.000000000001f) {
        let _e93 = side;
        let _e94 = larger;
        let _e96 = side;
        let _e98 = mean;
        local_10 = min(((_e93 / _e94) * _e96), _e98);
    } else {
        local_10 = 0f;
    }
    let _e102 = local_10;
    smaller = _e102;
    let _e105 = footprint_1;
    footprint_1.resolved = _e105.covariance;
    let _e107 = larger;
    if (_e107 > 0.25f) {
        {
            let _e110 = smaller;
            smaller = min(_e110, 0.25f);
            let _e113 = axis;
            let _e114 = apart;
            if (_e114 > 0f) {
                let _e119 = smaller;
                let _e122 = apart;
                local_11 = ((0.5f * (0.25f - _e119)) / _e122);
            } else {
                local_11 = 0f;
            }
            let _e126 = local_11;
            axis = (_e113 * _e126);
            let _e131 = smaller;
            let _e134 = axis;
            let _e136 = axis;
            let _e141 = (vec2((0.5f * (0.25f + _e131))) + vec2<f32>(_e134.x, -(_e136.x)));
            let _e142 = axis;
            footprint_1.resolved = vec3<f32>(_e141.x, _e141.y, _e142.y);
        }
    }
    let _e147 = footprint_1;
    return _e147;
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this removed: what a material lost in roughness, or a picture in contrast. Against the
// noise filtered exactly, see gabor_footprint, the root mean square error is at most 1 % of the noise's deviation for
// steps of up to a third of a kernel radius and 2 % up to a whole one; what covers more fades as it should. Continuous
// in the place and in both steps.
// Cost: on GPUs 1.5 times gabor_noise up to steps of 0.16 kernel radii, with 9 nodes; beyond, with 25, about 4.5 times.
// Where compilers run both sides of a branch, as for CPUs, 4 to 7 times.
fn gabor_noise_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    var removed_1: f32;
    var field_6: GaborField;

    let _e14 = gabor_place(vec2(0i), (p * 1.5f));
    let _e15 = gabor_kernel(frequency, orientation);
    let _e16 = gabor_footprint(dx, dy);
    let _e19 = gabor_field_filtered(_e14, _e15, _e16, seed, (&removed_1));
    field_6 = _e19;
    let _e21 = field_6;
    let _e24 = removed_1;
    return vec2<f32>(_e21.value.y, _e24);
}

// The same with the filtered noise's gradient: (noise, d/dx, d/dy, removed variance).
fn gabor_noise_filtered_gradient(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec4<f32> {
    var removed_2: f32;
    var field_7: GaborField;

    let _e14 = gabor_place(vec2(0i), (p * 1.5f));
    let _e15 = gabor_kernel(frequency, orientation);
    let _e16 = gabor_footprint(dx, dy);
    let _e19 = gabor_field_filtered(_e14, _e15, _e16, seed, (&removed_2));
    field_7 = _e19;
    let _e21 = field_7;
    let _e24 = field_7;
    let _e27 = field_7;
    let _e30 = removed_2;
    return vec4<f32>(_e21.value.y, _e24.slope_x.y, _e27.slope_y.y, _e30);
}

// Four noises at p as a pixel sees them, those of gabor_noise_four, and the share that is removed of the variance of
// each.
fn gabor_noise_four_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32, removed: ptr<function, f32>) -> vec4<f32> {
    let _e14 = gabor_place(vec2(0i), (p * 1.5f));
    let _e15 = gabor_kernel(frequency, orientation);
    let _e16 = gabor_footprint(dx, dy);
    let _e19 = gabor_field_filtered(_e14, _e15, _e16, seed, removed);
    return _e19.four;
}

// The noise of several lobes at p, as gabor_noise_lobes, filtered and with its gradient: (noise, d/dx, d/dy, removed).
fn gabor_noise_lobes_filtered_gradient(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec4<f32> {
    var lobes_9: GaborLobes;
    var sum_10: vec4<f32> = vec4(0f);
    var power_2: f32 = 0f;
    var i_4: i32 = 0i;
    var lobe_1: GaborLobe;
    var unit_1: f32;
    var noise_1: vec4<f32>;
    var local_12: vec4<f32>;

    lobes_9 = lobes;
    loop {
        let _e13 = i_4;
        let _e14 = lobes_9;
        if !((_e13 < _e14.count)) {
            break;
        }
        {
            let _e21 = i_4;
            let _e24 = lobes_9.lobe[_e21];
            lobe_1 = _e24;
            let _e27 = lobe_1;
            unit_1 = (1f / _e27.radius);
            let _e31 = unit_1;
            let _e33 = unit_1;
            let _e35 = unit_1;
            let _e37 = lobe_1;
            let _e39 = lobe_1;
            let _e42 = lobe_1;
            let _e44 = i_4;
            let _e45 = gabor_lobe_seed(seed, _e44);
            let _e46 = gabor_noise_filtered_gradient((p * _e31), (dx * _e33), (dy * _e35), (_e37.frequency * _e39.radius), _e42.orientation, _e45);
            noise_1 = _e46;
            let _e48 = sum_10;
            let _e49 = lobe_1;
            let _e53 = unit_1;
            let _e54 = unit_1;
            let _e56 = (sqrt(_e49.power) * vec3<f32>(1f, _e53, _e54));
            let _e57 = lobe_1;
            let _e63 = noise_1;
            sum_10 = (_e48 + (vec4<f32>(_e56.x, _e56.y, _e56.z, _e57.power) * _e63));
            let _e66 = power_2;
            let _e67 = lobe_1;
            power_2 = (_e66 + _e67.power);
        }
        continuing {
            let _e18 = i_4;
            i_4 = (_e18 + 1i);
        }
    }
    let _e70 = power_2;
    if (_e70 > 0f) {
        let _e73 = sum_10;
        let _e74 = power_2;
        let _e76 = vec3(inverseSqrt(_e74));
        let _e78 = power_2;
        local_12 = (_e73 * vec4<f32>(_e76.x, _e76.y, _e76.z, (1f / _e78)));
    } else {
        local_12 = vec4(0f);
    }
    let _e88 = local_12;
    return _e88;
}

// The noise alone, and the removed variance.
fn gabor_noise_lobes_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec2<f32> {
    var lobes_11: GaborLobes;
    var value_4: vec4<f32>;

    lobes_11 = lobes;
    let _e6 = lobes_11;
    let _e7 = gabor_noise_lobes_filtered_gradient(p, dx, dy, _e6, seed);
    value_4 = _e7;
    let _e9 = value_4;
    let _e11 = value_4;
    return vec2<f32>(_e9.x, _e11.w);
}
