// gabor_spectrum.wgsl: Gabor noise of any power spectrum, and without aliasing. Include it after gabor_lattice.wgsl: for WGSL.
//
// Made from shaders/gabor_spectrum.glsl by tools/translate and naga 30.0.1: change that file, not this one. Paste or include it after gabor_lattice.wgsl.
//
// Functions to call, at the end of the file:
//     gabor_noise_lobes, gabor_noise_lobes_gradient, gabor_noise_lobes_complex     a sum of lobes
//     gabor_noise_spread, gabor_noise_spread_gradient, gabor_noise_spread_complex  a range of waves, up to isotropic
//     gabor_noise_filtered, gabor_noise_lobes_filtered                             as a pixel sees it
//     gabor_lobe, gabor_footprint, gabor_field_filtered                            their parts
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
        var sum_3: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
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
                gabor_impl_accumulate((&sum_3), _e54, sqrt(_e55.power), (sqrt(_e58.power) / _e61.radius));
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
        let _e79 = sum_3;
        let _e82 = scale_1;
        let _e83 = sum_3;
        let _e86 = scale_1;
        let _e87 = sum_3;
        let _e90 = scale_1;
        let _e91 = sum_3;
        return GaborField((_e78 * _e79.value), (_e82 * _e83.slope_x), (_e86 * _e87.slope_y), (_e90 * _e91.four));
    } else if GABOR_TAPS == 4 {
        var lobes_1: GaborLobes;
        var sum_3: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
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
                gabor_impl_accumulate((&sum_3), _e54, sqrt(_e55.power), (sqrt(_e58.power) / _e61.radius));
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
        let _e79 = sum_3;
        let _e82 = scale;
        let _e83 = sum_3;
        let _e86 = scale;
        let _e87 = sum_3;
        let _e90 = scale;
        let _e91 = sum_3;
        return GaborField((_e78 * _e79.value), (_e82 * _e83.slope_x), (_e86 * _e87.slope_y), (_e90 * _e91.four));
    } else {
        var lobes_1: GaborLobes;
        var sum_3: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
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
                gabor_impl_accumulate((&sum_3), _e54, sqrt(_e55.power), (sqrt(_e58.power) / _e61.radius));
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
        let _e79 = sum_3;
        let _e82 = scale;
        let _e83 = sum_3;
        let _e86 = scale;
        let _e87 = sum_3;
        let _e90 = scale;
        let _e91 = sum_3;
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

// The noise of a range of waves at a place, as gabor_noise_spread, with its quadrature and derivatives per kernel radius.
fn gabor_field_spread(place: GaborPlace, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> GaborField {
    var frequency_8: f32;
    var frequency_spread_1: f32;
    var orientation_spread_1: f32;
    var sum_4: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f), vec4(0f));
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
                    gabor_impl_accumulate((&sum_4), _e129, _e130, _e131);
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
    let _e133 = sum_4;
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

// The filtered windows of one axis for the factors 1, z and 2 z^2 - 1. At a distance d from the node, with the cosine
// and sine of pi d / w, a window's real part is a polynomial in the cosine, its imaginary part the sine times another.
struct GaborBand {
    reach: f32,
    slope: f32,
    real_0_: vec3<f32>,
    real_1_: vec3<f32>,
    real_2_: vec3<f32>,
    real_3_: vec3<f32>,
    imaginary_0_: vec3<f32>,
    imaginary_1_: vec3<f32>,
    imaginary_2_: vec3<f32>,
}

//   deviation  of the filter along the axis
//   g, c       see above
fn gabor_impl_band(deviation: f32, g: f32, c: f32) -> GaborBand {
    var c_6: f32;
    var band: GaborBand;
    var wide: f32;
    var widest: f32;
    var t_2: f32;
    var taper: f32;
    var h: vec3<f32>;
    var q: f32;
    var center: f32;
    var curve: f32;
    var rise: f32;
    var rises: vec3<f32>;
    var curve_4_: f32;
    var scale_1: f32;
    var z: vec3<f32>;
    var even: vec3<f32>;
    var odd: vec3<f32>;
    var even_z: vec3<f32>;
    var odd_z: vec3<f32>;
    var even_zz: vec3<f32>;
    var odd_zz: vec3<f32>;
    var first_2: vec3<f32>;
    var second_1: vec3<f32>;
    var third_1: vec3<f32>;

    c_6 = c;
    wide = clamp(((25f * deviation) - 2f), 0f, 1f);
    widest = clamp(((5.882353f * deviation) - 1.5882353f), 0f, 1f);
    let _e21 = wide;
    let _e22 = widest;
    t_2 = ((_e21 + _e22) / 3f);
    let _e29 = t_2;
    band.reach = (1f + _e29);
    let _e36 = wide;
    let _e50 = widest;
    taper = (((min((0.625f * deviation), 0.05f) + (0.35f * _e36)) - (0.3f * clamp(((12.5f * deviation) - 2.125f), 0f, 1f))) + (0.1f * _e50));
    let _e56 = taper;
    band.slope = (1f / max(_e56, 0.001f));
    let _e65 = t_2;
    h = ((vec3<f32>(0.1581287f, -0.3374857f, 0.6033444f) * _e65) + vec3<f32>(-0.4607931f, 0.8628952f, -1.266219f));
    let _e75 = h;
    let _e76 = t_2;
    h = ((_e75 * _e76) + vec3<f32>(0.6127236f, -0.850095f, 0.8539023f));
    let _e84 = h;
    let _e85 = t_2;
    h = ((_e84 * _e85) + vec3<f32>(-0.4679222f, 0.271717f, -0.05810602f));
    let _e94 = h;
    let _e95 = t_2;
    h = ((_e94 * _e95) + vec3<f32>(0.1246983f, 0.1670957f, -0.06381795f));
    let _e103 = h;
    let _e104 = t_2;
    h = ((_e103 * _e104) + vec3<f32>(0.25f, 0f, 0f));
    let _e112 = band;
    q = (0.5f / _e112.reach);
    let _e117 = c_6;
    let _e119 = c_6;
    center = exp(((-(g) * _e117) * _e119));
    let _e125 = q;
    let _e127 = q;
    curve = exp((((2.5797362f - g) * _e125) * _e127));
    let _e133 = c_6;
    let _e135 = q;
    rise = exp((((2f * g) * _e133) * _e135));
    let _e139 = rise;
    let _e140 = rise;
    let _e141 = rise;
    let _e143 = rise;
    let _e144 = rise;
    let _e146 = rise;
    rises = vec3<f32>(_e139, (_e140 * _e141), ((_e143 * _e144) * _e146));
    let _e150 = curve;
    let _e151 = curve;
    let _e153 = curve;
    let _e155 = curve;
    curve_4_ = (((_e150 * _e151) * _e153) * _e155);
    let _e158 = h;
    let _e159 = center;
    let _e160 = curve;
    let _e161 = curve_4_;
    let _e162 = curve_4_;
    let _e163 = curve_4_;
    let _e165 = curve;
    h = (_e158 * (_e159 * vec3<f32>(_e160, _e161, ((_e162 * _e163) * _e165))));
    scale_1 = sqrt((2f * g));
    let _e174 = scale_1;
    let _e175 = q;
    z = ((_e174 * _e175) * vec3<f32>(1f, 2f, 3f));
    let _e183 = c_6;
    let _e184 = scale_1;
    c_6 = (_e183 * _e184);
    let _e186 = h;
    let _e187 = rises;
    let _e189 = rises;
    even = (_e186 * (_e187 + (vec3(1f) / _e189)));
    let _e195 = h;
    let _e196 = rises;
    let _e198 = rises;
    odd = (_e195 * (_e196 - (vec3(1f) / _e198)));
    let _e204 = z;
    let _e205 = odd;
    let _e207 = c_6;
    let _e208 = even;
    even_z = ((_e204 * _e205) - (_e207 * _e208));
    let _e212 = z;
    let _e213 = even;
    let _e215 = c_6;
    let _e216 = odd;
    odd_z = ((_e212 * _e213) - (_e215 * _e216));
    let _e221 = z;
    let _e222 = odd_z;
    let _e224 = c_6;
    let _e225 = even_z;
    let _e229 = even;
    even_zz = ((2f * ((_e221 * _e222) - (_e224 * _e225))) - _e229);
    let _e233 = z;
    let _e234 = even_z;
    let _e236 = c_6;
    let _e237 = odd_z;
    let _e241 = odd;
    odd_zz = ((2f * ((_e233 * _e234) - (_e236 * _e237))) - _e241);
    let _e244 = even;
    let _e246 = even_z;
    let _e248 = even_zz;
    first_2 = vec3<f32>(_e244.x, _e246.x, _e248.x);
    let _e252 = even;
    let _e254 = even_z;
    let _e256 = even_zz;
    second_1 = vec3<f32>(_e252.y, _e254.y, _e256.y);
    let _e260 = even;
    let _e262 = even_z;
    let _e264 = even_zz;
    third_1 = vec3<f32>(_e260.z, _e262.z, _e264.z);
    let _e269 = center;
    let _e270 = q;
    let _e273 = c_6;
    let _e276 = c_6;
    let _e278 = c_6;
    let _e284 = second_1;
    band.real_0_ = (((_e269 * _e270) * vec3<f32>(1f, -(_e273), (((2f * _e276) * _e278) - 1f))) - _e284);
    let _e287 = first_2;
    let _e289 = third_1;
    band.real_1_ = (_e287 - (3f * _e289));
    let _e294 = second_1;
    band.real_2_ = (2f * _e294);
    let _e298 = third_1;
    band.real_3_ = (4f * _e298);
    let _e300 = odd;
    let _e302 = odd_z;
    let _e304 = odd_zz;
    first_2 = vec3<f32>(_e300.x, _e302.x, _e304.x);
    let _e307 = odd;
    let _e309 = odd_z;
    let _e311 = odd_zz;
    second_1 = vec3<f32>(_e307.y, _e309.y, _e311.y);
    let _e314 = odd;
    let _e316 = odd_z;
    let _e318 = odd_zz;
    third_1 = vec3<f32>(_e314.z, _e316.z, _e318.z);
    let _e322 = first_2;
    let _e323 = third_1;
    band.imaginary_0_ = (_e322 - _e323);
    let _e327 = second_1;
    band.imaginary_1_ = (2f * _e327);
    let _e331 = third_1;
    band.imaginary_2_ = (4f * _e331);
    let _e333 = band;
    return _e333;
}

// The windows of a node at a distance, in kernel radii, as complex numbers, and their sums over the nodes of a row.
struct GaborFactors {
    real: vec3<f32>,
    imaginary: vec3<f32>,
}

//   turn  e^(pi i distance / w)
fn gabor_impl_factors(band: GaborBand, distance: f32, turn: vec2<f32>) -> GaborFactors {
    var taper_1: f32;
    var c_7: f32;
    var real_1: vec3<f32>;
    var imaginary_1: vec3<f32>;

    taper_1 = clamp(((band.reach - abs(distance)) * band.slope), 0f, 1f);
    let _e12 = taper_1;
    let _e13 = taper_1;
    let _e16 = taper_1;
    taper_1 = (_e12 * (_e13 * (3f - (2f * _e16))));
    c_7 = turn.x;
    let _e24 = c_7;
    let _e28 = c_7;
    let _e32 = c_7;
    real_1 = ((((((band.real_3_ * _e24) + band.real_2_) * _e28) + band.real_1_) * _e32) + band.real_0_);
    let _e38 = c_7;
    let _e42 = c_7;
    imaginary_1 = ((((band.imaginary_2_ * _e38) + band.imaginary_1_) * _e42) + band.imaginary_0_);
    let _e47 = taper_1;
    let _e48 = real_1;
    let _e50 = taper_1;
    let _e53 = imaginary_1;
    return GaborFactors((_e47 * _e48), ((_e50 * turn.y) * _e53));
}

fn gabor_impl_add_filtered(row: ptr<function, GaborFactors>, word: u32, column: GaborFactors, animated: bool, time: vec2<f32>) {
    var amplitude_2: vec2<f32>;
    var second_2: u32;

    let _e5 = gabor_impl_amplitude(word);
    amplitude_2 = _e5;
    let _e7 = gabor_impl_next_word(word);
    second_2 = _e7;
    if animated {
        let _e9 = amplitude_2;
        let _e10 = second_2;
        let _e11 = gabor_impl_amplitude(_e10);
        let _e12 = second_2;
        let _e13 = gabor_impl_next_word(_e12);
        let _e14 = gabor_impl_amplitude(_e13);
        let _e15 = gabor_impl_amplitude_at(time, _e9, _e11, _e14);
        amplitude_2 = _e15;
    }
    let _e17 = (*row);
    let _e19 = amplitude_2;
    let _e23 = amplitude_2;
    (*row).real = (_e17.real + ((_e19.x * column.real) - (_e23.y * column.imaginary)));
    let _e30 = (*row);
    let _e32 = amplitude_2;
    let _e36 = amplitude_2;
    (*row).imaginary = (_e30.imaginary + ((_e32.x * column.imaginary) + (_e36.y * column.real)));
    return;
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
        var place_7: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 1.5f));
        place_7 = _e13;
        let _e15 = place_7;
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
        var place_8: GaborPlace;
        var field_5: GaborField;

        let _e13 = gabor_place(vec2(0i), (p * 1.5f));
        place_8 = _e13;
        let _e15 = place_8;
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
        var place_9: GaborPlace;

        let _e13 = gabor_place(vec2(0i), (p * 1.5f));
        place_9 = _e13;
        let _e15 = place_9;
        let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
        return _e16.value;
    }
}

// What a pixel covers that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p) in kernel radii: a normal
// filter of covariance (dx dx^T + dy dy^T) / 4, half a pixel's standard deviation. Any two vectors, parallel ones too.
fn gabor_footprint(dx: vec2<f32>, dy: vec2<f32>) -> GaborFootprint {
    var dx_1: vec2<f32>;
    var dy_1: vec2<f32>;
    var footprint: GaborFootprint;
    var mean: f32;
    var axis: vec2<f32>;
    var apart: f32;
    var larger: f32;
    var side: f32;
    var local_9: f32;
    var smaller: f32;
    var local_10: f32;

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
    footprint.covariance = (0.25f * vec3<f32>(_e29.x, _e29.y, ((_e30.x * _e32.y) + (_e35.x * _e37.y))));
    let _e46 = footprint;
    let _e49 = footprint;
    mean = (0.5f * (_e46.covariance.x + _e49.covariance.y));
    let _e56 = footprint;
    let _e59 = footprint;
    let _e64 = footprint;
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
        local_9 = min(((_e93 / _e94) * _e96), _e98);
    } else {
        local_9 = 0f;
    }
    let _e102 = local_9;
    smaller = _e102;
    let _e105 = footprint;
    footprint.resolved = _e105.covariance;
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
                local_10 = ((0.5f * (0.25f - _e119)) / _e122);
            } else {
                local_10 = 0f;
            }
            let _e126 = local_10;
            axis = (_e113 * _e126);
            let _e131 = smaller;
            let _e134 = axis;
            let _e136 = axis;
            let _e141 = (vec2((0.5f * (0.25f + _e131))) + vec2<f32>(_e134.x, -(_e136.x)));
            let _e142 = axis;
            footprint.resolved = vec3<f32>(_e141.x, _e141.y, _e142.y);
        }
    }
    let _e147 = footprint;
    return _e147;
}

// The noise at a place as a pixel sees it, (real, imaginary), and the share of its variance that is removed. For
// periods, whose nodes are not 1 / GABOR_RADIUS apart, give gabor_footprint steps times place.radius / GABOR_RADIUS.
fn gabor_field_filtered(place: GaborPlace, kernel: GaborKernel, footprint: GaborFootprint, seed: u32) -> vec3<f32> {
    var kernel_10: GaborKernel;
    var wave_2: vec2<f32>;
    var transmitted: f32;
    var s_2: vec3<f32>;
    var blurred: vec2<f32>;
    var m: vec2<f32>;
    var c_8: vec2<f32>;
    var rho: f32;
    var r_1: f32;
    var lambda: f32;
    var weights: vec3<f32>;
    var g_1: vec2<f32>;
    var across: GaborBand;
    var along: GaborBand;
    var reach: vec2<f32>;
    var first_3: vec2<f32>;
    var count: vec2<i32>;
    var x_1: vec2<f32>;
    var node_1: vec2<i32>;
    var turns: vec2<f32>;
    var time_6: vec2<f32>;
    var salt_4: u32;
    var word_8: array<u32, 5>;
    var column_2: array<GaborFactors, 5>;
    var turn_1: vec2<f32>;
    var step_2: vec2<f32>;
    var back: vec2<f32>;
    var phase_1: vec2<f32> = vec2<f32>(1f, 0f);
    var i_4: i32 = 0i;
    var factors: GaborFactors;
    var sum_5: vec2<f32> = vec2(0f);
    var j_1: i32 = 0i;
    var row_word_1: u32;
    var row_4: GaborFactors;
    var words: vec2<u32>;
    var left: GaborFactors;
    var right: GaborFactors;
    var i_5: i32;
    var factors_1: GaborFactors;
    var part: vec2<f32>;
    var amplitude_3: f32;

    kernel_10 = kernel;
    let _e5 = kernel_10;
    wave_2 = (_e5.wave * (vec2(1.5f) / place.radius));
    let _e16 = wave_2;
    let _e18 = gabor_impl_transmitted(_e16, footprint.covariance);
    transmitted = _e18;
    let _e20 = transmitted;
    if (_e20 < 0.0000000001f) {
        return vec3<f32>(0f, 0f, 1f);
    }
    s_2 = footprint.resolved;
    let _e29 = s_2;
    let _e30 = wave_2;
    let _e31 = gabor_impl_symmetric(_e29, _e30);
    blurred = _e31;
    let _e33 = s_2;
    m = (_e33.xy + vec2(0.13069098f));
    let _e39 = m;
    let _e40 = _e39.yx;
    let _e41 = s_2;
    let _e47 = blurred;
    let _e48 = gabor_impl_symmetric(vec3<f32>(_e40.x, _e40.y, -(_e41.z)), _e47);
    let _e49 = s_2;
    let _e51 = s_2;
    let _e54 = m;
    let _e56 = m;
    c_8 = (_e48 / vec2(((_e49.z * _e51.z) - (_e54.x * _e56.y))));
    let _e63 = s_2;
    let _e65 = m;
    let _e67 = m;
    rho = (_e63.z * inverseSqrt((_e65.x * _e67.y)));
    let _e74 = rho;
    let _e75 = rho;
    r_1 = sqrt((1f - (_e74 * _e75)));
    let _e80 = rho;
    let _e82 = r_1;
    lambda = (_e80 / (1f + _e82));
    let _e89 = lambda;
    let _e92 = lambda;
    let _e94 = lambda;
    weights = vec3<f32>(1f, (-2f * _e89), ((0.5f * _e92) * _e94));
    let _e99 = r_1;
    let _e101 = m;
    g_1 = ((19.739208f * _e99) * _e101);
    let _e104 = s_2;
    let _e107 = g_1;
    let _e109 = c_8;
    let _e111 = gabor_impl_band(sqrt(_e104.x), _e107.x, _e109.x);
    across = _e111;
    let _e113 = s_2;
    let _e116 = g_1;
    let _e118 = c_8;
    let _e120 = gabor_impl_band(sqrt(_e113.y), _e116.y, _e118.y);
    along = _e120;
    let _e122 = across;
    let _e124 = along;
    reach = vec2<f32>(_e122.reach, _e124.reach);
    let _e133 = reach;
    first_3 = (floor((place.local - (1.5f * _e133))) + vec2(1f));
    let _e147 = reach;
    count = vec2<i32>(ceil(((3f * _e147) - vec2(0.001f))));
    let _e156 = first_3;
    x_1 = (place.local - _e156);
    let _e160 = first_3;
    node_1 = (place.cell + vec2<i32>(_e160));
    let _e169 = reach;
    turns = (vec2(0.5f) / (1.5f * _e169));
    let _e175 = gabor_impl_wave(place.time);
    time_6 = _e175;
    let _e177 = gabor_impl_salt(seed);
    salt_4 = _e177;
    let _e181 = turns;
    let _e183 = x_1;
    let _e186 = gabor_impl_wave((_e181.x * _e183.x));
    turn_1 = _e186;
    let _e188 = turns;
    let _e191 = gabor_impl_wave(-(_e188.x));
    step_2 = _e191;
    let _e193 = kernel_10;
    let _e196 = kernel_10;
    back = vec2<f32>(_e193.step_x.x, -(_e196.step_x.y));
    loop {
        let _e208 = i_4;
        if !((_e208 < 5i)) {
            break;
        }
        {
            let _e215 = i_4;
            let _e217 = node_1;
            let _e219 = i_4;
            let _e223 = gabor_impl_wrap((_e217.x + _e219), place.period.x);
            let _e224 = salt_4;
            let _e225 = gabor_impl_line_word(_e223, _e224);
            word_8[_e215] = _e225;
            let _e226 = across;
            let _e227 = x_1;
            let _e229 = i_4;
            let _e237 = turn_1;
            let _e238 = gabor_impl_factors(_e226, ((_e227.x - f32(_e229)) / 1.5f), _e237);
            factors = _e238;
            let _e240 = i_4;
            let _e242 = phase_1;
            let _e244 = factors;
            let _e247 = phase_1;
            let _e249 = factors;
            let _e253 = phase_1;
            let _e255 = factors;
            let _e258 = phase_1;
            let _e260 = factors;
            column_2[_e240] = GaborFactors(((_e242.x * _e244.real) - (_e247.y * _e249.imaginary)), ((_e253.x * _e255.imaginary) + (_e258.y * _e260.real)));
            let _e265 = turn_1;
            let _e266 = step_2;
            let _e267 = gabor_impl_product(_e265, _e266);
            turn_1 = _e267;
            let _e268 = phase_1;
            let _e269 = back;
            let _e270 = gabor_impl_product(_e268, _e269);
            phase_1 = _e270;
        }
        continuing {
            let _e212 = i_4;
            i_4 = (_e212 + 1i);
        }
    }
    let _e271 = turns;
    let _e273 = x_1;
    let _e276 = gabor_impl_wave((_e271.y * _e273.y));
    turn_1 = _e276;
    let _e277 = turns;
    let _e280 = gabor_impl_wave(-(_e277.y));
    step_2 = _e280;
    let _e281 = kernel_10;
    let _e284 = kernel_10;
    back = vec2<f32>(_e281.step_y.x, -(_e284.step_y.y));
    let _e289 = kernel_10;
    let _e293 = x_1;
    let _e295 = gabor_impl_wave(dot((_e289.wave / place.radius), _e293));
    phase_1 = _e295;
    loop {
        {
            let _e301 = node_1;
            let _e303 = j_1;
            let _e307 = gabor_impl_wrap((_e301.y + _e303), place.period.y);
            let _e308 = salt_4;
            let _e311 = gabor_impl_line_word(_e307, (_e308 ^ 1540483477u));
            row_word_1 = _e311;
            row_4 = GaborFactors(vec3(0f), vec3(0f));
            let _e322 = word_8[0];
            let _e323 = row_word_1;
            let _e324 = gabor_impl_node_word(_e322, _e323);
            let _e327 = column_2[0];
            let _e329 = time_6;
            gabor_impl_add_filtered((&row_4), _e324, _e327, place.animated, _e329);
            let _e333 = word_8[1];
            let _e336 = word_8[2];
            words = vec2<u32>(_e333, _e336);
            let _e341 = column_2[1];
            left = _e341;
            let _e345 = column_2[2];
            right = _e345;
            i_5 = 3i;
            loop {
                {
                    let _e350 = words;
                    let _e352 = row_word_1;
                    let _e353 = gabor_impl_node_word(_e350.x, _e352);
                    let _e354 = left;
                    let _e356 = time_6;
                    gabor_impl_add_filtered((&row_4), _e353, _e354, place.animated, _e356);
                    let _e359 = words;
                    let _e361 = row_word_1;
                    let _e362 = gabor_impl_node_word(_e359.y, _e361);
                    let _e363 = right;
                    let _e365 = time_6;
                    gabor_impl_add_filtered((&row_4), _e362, _e363, place.animated, _e365);
                    let _e369 = word_8[3];
                    let _e372 = word_8[4];
                    words = vec2<u32>(_e369, _e372);
                    let _e376 = column_2[3];
                    left = _e376;
                    let _e379 = column_2[4];
                    right = _e379;
                    let _e380 = i_5;
                    i_5 = (_e380 + 2i);
                }
                let _e383 = i_5;
                let _e384 = count;
                if !((_e383 < (_e384.x + 2i))) {
                    break;
                }
            }
            let _e390 = along;
            let _e391 = x_1;
            let _e393 = j_1;
            let _e401 = turn_1;
            let _e402 = gabor_impl_factors(_e390, ((_e391.y - f32(_e393)) / 1.5f), _e401);
            factors_1 = _e402;
            let _e404 = weights;
            let _e405 = factors_1;
            let _e407 = row_4;
            let _e410 = factors_1;
            let _e412 = row_4;
            let _e417 = weights;
            let _e418 = factors_1;
            let _e420 = row_4;
            let _e423 = factors_1;
            let _e425 = row_4;
            part = vec2<f32>(dot(_e404, ((_e405.real * _e407.real) - (_e410.imaginary * _e412.imaginary))), dot(_e417, ((_e418.real * _e420.imaginary) + (_e423.imaginary * _e425.real))));
            let _e432 = sum_5;
            let _e433 = part;
            let _e434 = phase_1;
            let _e435 = gabor_impl_product(_e433, _e434);
            sum_5 = (_e432 + _e435);
            let _e437 = turn_1;
            let _e438 = step_2;
            let _e439 = gabor_impl_product(_e437, _e438);
            turn_1 = _e439;
            let _e440 = phase_1;
            let _e441 = back;
            let _e442 = gabor_impl_product(_e440, _e441);
            phase_1 = _e442;
            let _e443 = j_1;
            j_1 = (_e443 + 1i);
        }
        let _e446 = j_1;
        let _e447 = count;
        if !((_e446 < _e447.y)) {
            break;
        }
    }
    let _e452 = lambda;
    let _e453 = lambda;
    let _e459 = wave_2;
    let _e460 = c_8;
    let _e462 = blurred;
    amplitude_3 = (sqrt((1f - (_e452 * _e453))) * exp((-19.739208f * dot((_e459 + _e460), _e462))));
    if any((footprint.resolved != footprint.covariance)) {
        let _e472 = amplitude_3;
        let _e473 = transmitted;
        let _e474 = wave_2;
        let _e475 = s_2;
        let _e476 = gabor_impl_transmitted(_e474, _e475);
        amplitude_3 = (_e472 * sqrt((_e473 / _e476)));
    }
    let _e480 = amplitude_3;
    let _e485 = sum_5;
    let _e486 = ((_e480 / 1642449700000000000000000000f) * _e485);
    let _e488 = transmitted;
    return vec3<f32>(_e486.x, _e486.y, (1f - _e488));
}

// Gabor noise at p as a pixel sees it that reaches dx and dy further to its neighbours, dFdx(p) and dFdy(p), and the
// share of the variance that this removed: what a material lost in roughness, or a picture in contrast. Against the
// noise filtered exactly, see gabor_footprint, the root mean square error is at most 1 % of the noise's deviation for
// steps of up to a third of a kernel radius and 2 % up to a whole one; what covers more fades as it should. Continuous
// in the place and in both steps.
// Cost: 9 nodes up to steps of 0.16 kernel radii, 16 up to 0.54, 25 beyond: on lavapipe 3.4 to 4.9 times gabor_noise.
fn gabor_noise_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    let _e13 = gabor_place(vec2(0i), (p * 1.5f));
    let _e14 = gabor_kernel(frequency, orientation);
    let _e15 = gabor_footprint(dx, dy);
    let _e16 = gabor_field_filtered(_e13, _e14, _e15, seed);
    return _e16.yz;
}

// The noise of several lobes at p, as gabor_noise_lobes, and filtered as gabor_noise_filtered.
fn gabor_noise_lobes_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec2<f32> {
    var lobes_9: GaborLobes;
    var sum_6: vec2<f32> = vec2(0f);
    var power_2: f32 = 0f;
    var i_6: i32 = 0i;
    var lobe_1: GaborLobe;
    var value_2: vec2<f32>;
    var local_11: vec2<f32>;

    lobes_9 = lobes;
    loop {
        let _e13 = i_6;
        let _e14 = lobes_9;
        if !((_e13 < _e14.count)) {
            break;
        }
        {
            let _e21 = i_6;
            let _e24 = lobes_9.lobe[_e21];
            lobe_1 = _e24;
            let _e26 = lobe_1;
            let _e30 = lobe_1;
            let _e34 = lobe_1;
            let _e38 = lobe_1;
            let _e40 = lobe_1;
            let _e43 = lobe_1;
            let _e45 = i_6;
            let _e46 = gabor_lobe_seed(seed, _e45);
            let _e47 = gabor_noise_filtered((p / vec2(_e26.radius)), (dx / vec2(_e30.radius)), (dy / vec2(_e34.radius)), (_e38.frequency * _e40.radius), _e43.orientation, _e46);
            value_2 = _e47;
            let _e49 = sum_6;
            let _e50 = lobe_1;
            let _e53 = lobe_1;
            let _e56 = value_2;
            sum_6 = (_e49 + (vec2<f32>(sqrt(_e50.power), _e53.power) * _e56));
            let _e59 = power_2;
            let _e60 = lobe_1;
            power_2 = (_e59 + _e60.power);
        }
        continuing {
            let _e18 = i_6;
            i_6 = (_e18 + 1i);
        }
    }
    let _e63 = power_2;
    if (_e63 > 0f) {
        let _e66 = sum_6;
        let _e67 = power_2;
        let _e70 = power_2;
        local_11 = (_e66 * vec2<f32>(inverseSqrt(_e67), (1f / _e70)));
    } else {
        local_11 = vec2(0f);
    }
    let _e77 = local_11;
    return _e77;
}
