// Generated from gabor_direction.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl; pasted after their texts, it includes nothing.
//
// gabor_direction.hlsl: Gabor noise along a direction map, which it reads at the nodes of the lattice instead of at the
// pixel.
//
// Paste or include this file after gabor_noise.hlsl, with GABOR_TAPS 3, and after these lines:
//
//     float2 flow(float2 p) { return 3.0 * texture(map, p / size).xy; }   // your map: a wave vector at each p
//     #define GABOR_DIRECTION(p) flow(p)                              // float2(0.0) if you call only gabor_field_waves
//
//     GaborField f = gabor_field_direction(gabor_place_at(p), 7u);    // noise along the map
//     float3 s = gabor_stripes_of(f, 2.0);                              // cosine, sine, intensity
//
// Elsewhere, noise takes the map's wave vector at the pixel: the noise jumps where the map jumps, and stripes crowd
// around a vortex. Here each of the nine nodes around a point has its own wave vector, so stripes join across a jump
// within a kernel radius. A map of undirected lines also jumps, from o to o + pi. Noise does not show this jump, but
// stripes lose contrast within a kernel radius. Store such a map as (cos 2 o, sin 2 o), which textures can interpolate.
//
// For any map, value and gradient are normal at every point (up to three standard deviations, as in
// gabor_noise.hlsl), and the value has variance 1. The gradient takes the map's variation into account. Wave vectors
// are in cycles per kernel radius, up to 10^6 along each axis; use (0, 0) where the map has no direction. A call costs
// 1.5 to 1.7 times as much as gabor_noise, including nine evaluations of a computed map.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#if GABOR_TAPS != 3
#error gabor_direction.hlsl needs GABOR_TAPS 3
#endif
#ifndef GABOR_DIRECTION
#error Define GABOR_DIRECTION(p), the wave vector at p, before gabor_direction.hlsl
#endif
#ifndef GABOR_DIRECTION_HLSL
#define GABOR_DIRECTION_HLSL 1

// ---- With wave vectors that you read yourself, for several maps or a language without macros -----------------------

// The map's wave vectors at the nine nodes around a place, row by row: node `index` is at gabor_node_position(place,
// index).
struct GaborWaves {
    float2 wave[9];
};

// float2 gabor_node_position(GaborPlace place, int index)
//     Where to read the map for node `index` (0 to 8) around `place`: in kernel radii, within the place's period.

// GaborField gabor_field_waves(GaborPlace place, GaborWaves waves, uint seed)
//     The noise, its quadrature, and their gradients at `place`. gabor_stripes_of turns the field into stripes.

// ---- With a map, in languages with macros: define GABOR_DIRECTION(p) before the file -------------------------------

// GaborField gabor_field_direction(GaborPlace place, uint seed)
//     The noise, its quadrature, and their gradients at `place`.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// With a wave vector F_c for each node c, windows h and amplitudes A as in gabor_noise.hlsl,
//
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) exp(2 pi i F_c.(p - c)),
//
// where F_c does not depend on p. Multiplying A_c by a complex number of modulus 1 does not change its distribution, so
// the value has the distribution of gabor_noise for any F_c. The gradient is linear in the same amplitudes and
// therefore also normal, with the covariance K^2 E|A|^2 / 2 sum_c (grad h grad h^T + 4 pi^2 h^2 F_c F_c^T), where h is
// the product of both windows.

float2 gabor_node_position(GaborPlace place, int index) {
    int2 node = (int2)(floor(place.local + 0.5)) + int2(index - index / 3 * 3 - 1, index / 3 - 1);
    node = int2(gabor_impl_wrap(place.cell.x + node.x, place.period.x),
                 gabor_impl_wrap(place.cell.y + node.y, place.period.y));
    return (float2)(node) / place.cells_per_radius;
}

// Adds a node's wave at `d` kernel radii from the node; x and y are (window, derivative) along each axis.
void gabor_impl_add_directed_wave(inout GaborField sum, float2 amplitude, float2 wave, float2 d, float2 x, float2 y) {
    wave = clamp(wave, -1.0e6, 1.0e6);
    float2 a = gabor_impl_product(amplitude, gabor_impl_wave(dot(wave, d)));
    float2 value = x.x * y.x * a, slope = float2(x.y * y.x, x.x * y.y);
    sum.noise += value.y;
    sum.gradient += a.y * slope + 6.2831853 * value.x * wave; // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += a.x * slope - 6.2831853 * value.y * wave;
}

GaborField gabor_field_waves(GaborPlace place, GaborWaves waves, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, place.cells_per_radius.x);
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                                      place.cells_per_radius.y);
    float2 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    GaborField sum = GaborField_of(0.0, (float2)(0.0), 0.0, (float2)(0.0), 0.0);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            float2 amplitude = gabor_impl_amplitude_at(x.word[i] * y.word[j], place.evolution);
            float2 d = float2(x.offset - float(i - 1), y.offset - float(j - 1)) / place.cells_per_radius;
            gabor_impl_add_directed_wave(sum, amplitude, waves.wave[3 * j + i], d,
                                         float2(x.node[i].x, stretch.x * x.node[i].z),
                                         float2(y.node[j].x, stretch.y * y.node[j].z));
        }
    }
    GaborField field = GaborField_of(0.0, (float2)(0.0), 0.0, (float2)(0.0), 0.0);
    gabor_impl_add_field(field, sum, 1.0 / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY), (float2)(1.0));
    return field;
}

GaborField gabor_field_direction(GaborPlace place, uint seed) {
    GaborWaves waves;
    for (int i = 0; i < 9; ++i)
        waves.wave[i] = GABOR_DIRECTION(gabor_node_position(place, i));
    return gabor_field_waves(place, waves, seed);
}

#endif
