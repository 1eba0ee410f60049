// Generated from gabor_direction.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 5f2506f64fa3b2a6.
// Paste it after gabor_noise.wgsl.
//
// gabor_direction.wgsl: Gabor noise along a direction map, which it reads at the nodes of the lattice instead of at the
// pixel.
//
// Paste or include this file after gabor_noise.wgsl, with GABOR_TAPS 3, and after these lines:
//
//     vec2f flow(vec2f p) { return 3.0 * texture(map, p / size).xy; }   // your map: a wave vector at each p
//     #define GABOR_DIRECTION(p) flow(p)                              // vec2f(0.0) if you call only gabor_field_waves
//
//     GaborField f = gabor_field_direction(gabor_place_at(p), 7u);    // noise along the map
//     vec3f s = gabor_stripes_of(f, 2.0);                              // cosine, sine, intensity
//
// Elsewhere, noise takes the map's wave vector at the pixel: the noise jumps where the map jumps, and stripes crowd
// around a vortex. Here each of the nine nodes around a point has its own wave vector, so stripes join across a jump
// within a kernel radius. A map of undirected lines also jumps, from o to o + pi. Noise does not show this jump, but
// stripes lose contrast within a kernel radius. Store such a map as (cos 2 o, sin 2 o), which textures can interpolate.
//
// For any map, value and gradient are normal at every point (up to three standard deviations, as in
// gabor_noise.wgsl), and the value has variance 1. The gradient takes the map's variation into account. Wave vectors
// are in cycles per kernel radius, up to 10^6 along each axis; use (0, 0) where the map has no direction. A call costs
// 1.5 to 1.7 times as much as gabor_noise, including nine evaluations of a computed map.
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
//     The noise, its quadrature, and their gradients at `place`. gabor_stripes_of turns the field into stripes.

// ---- With a map, in languages with macros: define GABOR_DIRECTION(p) before the file -------------------------------

// GaborField gabor_field_direction(GaborPlace place, u32 seed)
//     The noise, its quadrature, and their gradients at `place`.

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
    return (vec2<f32>(_e39) / place.cells_per_radius);
}

// Adds a node's wave at `d` kernel radii from the node; x and y are (window, derivative) along each axis.
fn gabor_impl_add_directed_wave(sum: ptr<function, GaborField>, amplitude: vec2<f32>, wave: vec2<f32>, d: vec2<f32>, x: vec2<f32>, y: vec2<f32>) {
    var wave_6: vec2<f32>;
    var a_2: vec2<f32>;
    var value_4: vec2<f32>;
    var slope_6: vec2<f32>;
    wave_6 = wave;
    let _e7 = wave_6;
    wave_6 = clamp(_e7, vec2(-1000000f), vec2(1000000f));
    let _e14 = wave_6;
    let _e16 = gabor_impl_wave(dot(_e14, d));
    let _e17 = gabor_impl_product(amplitude, _e16);
    a_2 = _e17;
    let _e22 = a_2;
    value_4 = ((x.x * y.x) * _e22);
    slope_6 = vec2<f32>((x.y * y.x), (x.x * y.y));
    let _e34 = (*sum);
    let _e36 = value_4;
    (*sum).noise = (_e34.noise + _e36.y);
    let _e40 = (*sum);
    let _e42 = a_2;
    let _e44 = slope_6;
    let _e47 = value_4;
    let _e50 = wave_6;
    (*sum).gradient = (_e40.gradient + ((_e42.y * _e44) + ((6.2831855f * _e47.x) * _e50)));
    let _e55 = (*sum);
    let _e57 = value_4;
    (*sum).quadrature = (_e55.quadrature + _e57.x);
    let _e61 = (*sum);
    let _e63 = a_2;
    let _e65 = slope_6;
    let _e68 = value_4;
    let _e71 = wave_6;
    (*sum).quadrature_gradient = (_e61.quadrature_gradient + ((_e63.x * _e65) - ((6.2831855f * _e68.y) * _e71)));
    return;
}

fn gabor_field_waves(place: GaborPlace, waves: GaborWaves, seed: u32) -> GaborField {
    var waves_1: GaborWaves;
    var salt_4: u32;
    var x_6: GaborAxis;
    var y_5: GaborAxis;
    var stretch_2: vec2<f32>;
    var sum_6: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var j_1: i32 = 0i;
    var i: i32;
    var amplitude_3: vec2<f32>;
    var d_1: vec2<f32>;
    var field_4: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var local_11: f32;
    waves_1 = waves;
    let _e4 = gabor_impl_salt(seed);
    salt_4 = _e4;
    let _e12 = salt_4;
    let _e16 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e12, 0f, place.cells_per_radius.x);
    x_6 = _e16;
    let _e24 = salt_4;
    let _e30 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e24 ^ 1540483477u), 0f, place.cells_per_radius.y);
    y_5 = _e30;
    stretch_2 = (place.cells_per_radius / vec2(1.5f));
    loop {
        let _e51 = j_1;
        if !((_e51 < 3i)) {
            break;
        }
        {
            i = 0i;
            loop {
                let _e60 = i;
                if !((_e60 < 3i)) {
                    break;
                }
                {
                    let _e67 = i;
                    let _e70 = x_6.word[_e67];
                    let _e71 = j_1;
                    let _e74 = y_5.word[_e71];
                    let _e77 = gabor_impl_amplitude_at((_e70 * _e74), place.evolution);
                    amplitude_3 = _e77;
                    let _e79 = x_6;
                    let _e81 = i;
                    let _e86 = y_5;
                    let _e88 = j_1;
                    d_1 = (vec2<f32>((_e79.offset - f32((_e81 - 1i))), (_e86.offset - f32((_e88 - 1i)))) / place.cells_per_radius);
                    let _e98 = amplitude_3;
                    let _e100 = j_1;
                    let _e102 = i;
                    let _e106 = waves_1.wave[((3i * _e100) + _e102)];
                    let _e107 = d_1;
                    let _e108 = i;
                    let _e111 = x_6.node[_e108];
                    let _e113 = stretch_2;
                    let _e115 = i;
                    let _e118 = x_6.node[_e115];
                    let _e122 = j_1;
                    let _e125 = y_5.node[_e122];
                    let _e127 = stretch_2;
                    let _e129 = j_1;
                    let _e132 = y_5.node[_e129];
                    gabor_impl_add_directed_wave((&sum_6), _e98, _e106, _e107, vec2<f32>(_e111.x, (_e113.x * _e118.z)), vec2<f32>(_e125.x, (_e127.y * _e132.z)));
                }
                continuing {
                    let _e64 = i;
                    i = (_e64 + 1i);
                }
            }
        }
        continuing {
            let _e55 = j_1;
            j_1 = (_e55 + 1i);
        }
    }
    let _e147 = sum_6;
    if false {
        local_11 = 1f;
    } else {
        local_11 = 1.125f;
    }
    let _e159 = local_11;
    gabor_impl_add_field((&field_4), _e147, (1f / (1459955300000000000000000000f * _e159)), vec2(1f));
    let _e165 = field_4;
    return _e165;
}

