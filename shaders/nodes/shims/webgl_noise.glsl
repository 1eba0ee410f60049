// webgl_noise.glsl: snoise, cnoise and pnoise of webgl-noise, by Gabor noise, for shaders that call them.
//
// Delete the shader's own snoise, cnoise and pnoise, and paste this file after gabor_noise.glsl and gabor_fractal.glsl.
//
//     float snoise(vec2 v), float snoise(vec3 v)    for simplex noise
//     float cnoise(vec2 P), float cnoise(vec3 P)    for Perlin noise
//     float pnoise(vec2 P, vec2 rep), float pnoise(vec3 P, vec3 rep)
//         for Perlin noise that repeats after rep cells along each axis; an axis with rep 0 does not repeat
//
// Their size, deviation and mean are those of the webgl-noise of 2011 to 2020, as in npm's glsl-noise. What differs:
//     pattern  another one, the same at every place for the same call; it does not repeat after 289 cells
//     values   normally distributed, with no bound: |snoise(vec2)| exceeds 1 at 3.4 % of all places, snoise(vec3) at
//              0.7 %, cnoise at 0.3 and 0.1 %. Clamp what must stay in -1 to 1.
//     places   the deviation is the same at every place; in webgl-noise, cnoise is 0 at all corners of its cells
//     rep      at least 3, and of any size
//
// These names have no prefix, as shaders call them. Version, precision and macros are those of gabor_noise.glsl.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_FRACTAL_GLSL
#error Include gabor_noise.glsl and gabor_fractal.glsl before webgl_noise.glsl
#endif
#ifndef GABOR_WEBGL_NOISE_GLSL
#define GABOR_WEBGL_NOISE_GLSL 1

// The factors are deviations of webgl-noise, and centroids of its spectra over those of gabor_perlin (0.62 cycles per
// cell) and of a plane through gabor_perlin_3d (0.55): see README.md.

float snoise(vec2 v) {
    return 0.472 * gabor_perlin(1.66 * v, 0u);
}

float snoise(vec3 v) {
    return 0.373 * gabor_perlin_3d(1.55 * v, 0u);
}

float cnoise(vec2 P) {
    return 0.335 * gabor_perlin(P, 0u);
}

float cnoise(vec3 P) {
    return 0.297 * gabor_perlin_3d(0.92 * P, 0u);
}

float pnoise(vec2 P, vec2 rep) {
    GaborFractal octave = gabor_fractal(1.0, 0.0);
    octave.basis = GABOR_PERLIN;
    GaborPlace place = gabor_place_tiled(1.186 * P, 1.186 * rep); // as in gabor_perlin
    return 0.335 * gabor_fractal_noise(place, octave, 0u).noise;
}

float pnoise(vec3 P, vec3 rep) {
    GaborFractal octave = gabor_fractal(1.0, 0.0);
    octave.basis = GABOR_PERLIN;
    GaborPlace3d place = gabor_place_3d_tiled(1.09112 * P, 1.09112 * rep); // 0.92 * 1.186
    return 0.297 * gabor_fractal_noise_3d(place, octave, 0u).noise;
}

#endif
