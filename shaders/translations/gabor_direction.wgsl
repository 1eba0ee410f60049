// Generated from gabor_direction.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 59e759942eb8a70a.
//
// gabor_direction.wgsl: Gabor noise along a direction map, which it reads at the nodes of the lattice instead of at the
// pixel.
//
// Paste or include this file after gabor_noise.wgsl, with GABOR_TAPS 3, and after these lines:
//
//     vec2f flow(vec2f p) { return 3.0 * texture(map, p / size).xy; }   // your map: a wave vector at each p
//     #define GABOR_DIRECTION(p) flow(p)                              // vec2f(0.0) if you call only gabor_field_waves
//
//     vec3f s = gabor_stripes_direction(p, 2.0, 7u);                   // cosine, sine, intensity
//
// gabor_noise_wave takes the map's wave vector at the pixel: the noise jumps where the map jumps, and stripes crowd
// around a vortex. Here each of the nine nodes around a point has its own wave vector, so stripes join across a jump
// within a kernel radius. A map of lines without a sign jumps, too, from o to o + pi: gabor_noise_direction shows
// nothing of it, while stripes lose contrast within a kernel radius. Store such a map as (cos 2 o, sin 2 o), which
// textures can interpolate.
//
// For any map, value and gradient are normal at every point (up to three standard deviations, as in
// gabor_noise.wgsl), and the value has variance 1. The gradient takes the map's variation into account. Wave vectors
// are in cycles per kernel radius, up to 10^6 along each axis; use (0, 0) where the map has no direction. A call costs
// 1.5 to 1.7 times as much as gabor_noise_wave, including nine evaluations of a computed map.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// ---- With wave vectors that you read yourself, for several maps or a language without macros -----------------------

// The map's wave vectors at the nine nodes around a place, row by row: node `index` is at gabor_node_position(place,
// index).
struct GaborWaves {
    wave: array<vec2<f32>, 9>,
}

// vec2f gabor_node_position(GaborPlace place, i32 index)
//     Where to read the map for node `index` (0 to 8) around `place`: in kernel radii, within the place's period.

// GaborField gabor_field_waves(GaborPlace place, GaborWaves waves, u32 seed)
//     The noise, its quadrature, and their gradients at `place`. gabor_stripes_of turns the field's value into stripes.

// ---- With a map, in languages with macros: define GABOR_DIRECTION(p) before the file -------------------------------

// GaborField gabor_field_direction(GaborPlace place, u32 seed)
//     The noise, its quadrature, and their gradients at `place`. All functions below call it.

// f32 gabor_noise_direction(vec2f p, u32 seed)
// vec3f gabor_noise_direction_gradient(vec2f p, u32 seed)
// vec2f gabor_noise_direction_complex(vec2f p, u32 seed)
// f32 gabor_noise_direction_tiled(vec2f p, vec2f period, u32 seed)
//     Like gabor_noise, gabor_noise_gradient, gabor_noise_complex and gabor_noise_tiled, with the map's wave vectors.

// vec3f gabor_stripes_direction(vec2f p, f32 sharpness, u32 seed)
// vec3f gabor_stripes_direction_tiled(vec2f p, vec2f period, f32 sharpness, u32 seed)
// vec3f gabor_stripes_direction_at(GaborPlace place, f32 sharpness, u32 seed)
//     Stripes along the map, like gabor_stripes, gabor_stripes_tiled and gabor_stripes_at.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// With a wave vector F_c for each node c, windows h and amplitudes A as in gabor_noise.wgsl,
//
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) exp(2 pi i F_c.(p - c)),
//
// where F_c does not depend on p. Multiplying A_c by a complex number of modulus 1 does not change its distribution, so
// the value has the distribution of gabor_noise for any F_c. The gradient is linear in the same amplitudes and
// therefore also normal, with the covariance K^2 E|A|^2 / 2 sum_c (grad h grad h^T + 4 pi^2 h^2 F_c F_c^T), where h is
// the product of both windows.

fn gabor_node_position(place: GaborPlace, index: i32) -> vec2<f32> {
    var node: vec2<i32>;
    node = (vec2<i32>(floor((place.local + vec2(0.5f)))) + vec2<i32>(((index - ((index / 3i) * 3i)) - 1i), ((index / 3i) - 1i)));
    let _e24 = node;
    let _e29 = gabor_impl_wrap((place.cell.x + _e24.x), place.period.x);
    let _e32 = node;
    let _e37 = gabor_impl_wrap((place.cell.y + _e32.y), place.period.y);
    node = vec2<i32>(_e29, _e37);
    let _e39 = node;
    return (vec2<f32>(_e39) / place.radius);
}

// Adds a node's wave at `d` kernel radii from the node; x and y are (window, derivative) along each axis.
fn gabor_impl_add_directed_wave(sum: ptr<function, GaborField>, amplitude: vec2<f32>, wave: vec2<f32>, d: vec2<f32>, x: vec2<f32>, y: vec2<f32>) {
    var wave_11: vec2<f32>;
    var value_5: vec2<f32>;
    var turned_1: vec2<f32>;
    wave_11 = wave;
    let _e7 = wave_11;
    wave_11 = clamp(_e7, vec2(-1000000f), vec2(1000000f));
    let _e14 = wave_11;
    let _e16 = gabor_impl_wave(dot(_e14, d));
    let _e17 = gabor_impl_product(amplitude, _e16);
    value_5 = _e17;
    let _e24 = value_5;
    let _e27 = value_5;
    turned_1 = (((6.2831855f * x.x) * y.x) * vec2<f32>(-(_e24.y), _e27.x));
    let _e33 = (*sum);
    let _e38 = value_5;
    (*sum).value = (_e33.value + ((x.x * y.x) * _e38));
    let _e42 = (*sum);
    let _e47 = value_5;
    let _e49 = wave_11;
    let _e51 = turned_1;
    (*sum).slope_x = (_e42.slope_x + (((x.y * y.x) * _e47) + (_e49.x * _e51)));
    let _e56 = (*sum);
    let _e61 = value_5;
    let _e63 = wave_11;
    let _e65 = turned_1;
    (*sum).slope_y = (_e56.slope_y + (((x.x * y.y) * _e61) + (_e63.y * _e65)));
    return;
}

fn gabor_field_waves(place: GaborPlace, waves: GaborWaves, seed: u32) -> GaborField {
    var waves_1: GaborWaves;
    var salt_4: u32;
    var x_5: GaborAxis;
    var y_5: GaborAxis;
    var stretch_1: vec2<f32>;
    var sum_5: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f));
    var j_1: i32 = 0i;
    var i: i32;
    var amplitude_2: vec2<f32>;
    var d_1: vec2<f32>;
    var local_12: f32;
    var scale: f32;
    waves_1 = waves;
    let _e4 = gabor_impl_salt(seed);
    salt_4 = _e4;
    let _e12 = salt_4;
    let _e16 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e12, 0f, place.radius.x);
    x_5 = _e16;
    let _e24 = salt_4;
    let _e30 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e24 ^ 1540483477u), 0f, place.radius.y);
    y_5 = _e30;
    stretch_1 = (place.radius / vec2(1.5f));
    loop {
        let _e50 = j_1;
        if !((_e50 < 3i)) {
            break;
        }
        {
            i = 0i;
            loop {
                let _e59 = i;
                if !((_e59 < 3i)) {
                    break;
                }
                {
                    let _e66 = i;
                    let _e69 = x_5.word[_e66];
                    let _e70 = j_1;
                    let _e73 = y_5.word[_e70];
                    let _e77 = gabor_impl_amplitude_at((_e69 * _e73), place.animated, place.moment);
                    amplitude_2 = _e77;
                    let _e79 = x_5;
                    let _e81 = i;
                    let _e86 = y_5;
                    let _e88 = j_1;
                    d_1 = (vec2<f32>((_e79.offset - f32((_e81 - 1i))), (_e86.offset - f32((_e88 - 1i)))) / place.radius);
                    let _e98 = amplitude_2;
                    let _e100 = j_1;
                    let _e102 = i;
                    let _e106 = waves_1.wave[((3i * _e100) + _e102)];
                    let _e107 = d_1;
                    let _e108 = i;
                    let _e111 = x_5.node[_e108];
                    let _e113 = stretch_1;
                    let _e115 = i;
                    let _e118 = x_5.node[_e115];
                    let _e122 = j_1;
                    let _e125 = y_5.node[_e122];
                    let _e127 = stretch_1;
                    let _e129 = j_1;
                    let _e132 = y_5.node[_e129];
                    gabor_impl_add_directed_wave((&sum_5), _e98, _e106, _e107, vec2<f32>(_e111.x, (_e113.x * _e118.z)), vec2<f32>(_e125.x, (_e127.y * _e132.z)));
                }
                continuing {
                    let _e63 = i;
                    i = (_e63 + 1i);
                }
            }
        }
        continuing {
            let _e54 = j_1;
            j_1 = (_e54 + 1i);
        }
    }
    if false {
        local_12 = 1f;
    } else {
        local_12 = 1.125f;
    }
    let _e148 = local_12;
    scale = (1f / (1459955300000000000000000000f * _e148));
    let _e152 = scale;
    let _e153 = sum_5;
    let _e156 = scale;
    let _e157 = sum_5;
    let _e160 = scale;
    let _e161 = sum_5;
    return GaborField((_e152 * _e153.value), (_e156 * _e157.slope_x), (_e160 * _e161.slope_y));
}

