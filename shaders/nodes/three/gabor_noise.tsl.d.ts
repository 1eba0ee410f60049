// Types of gabor_noise.tsl.js. Positions are in kernel radii, frequencies in cycles per kernel radius, orientations in
// radians from x towards y. Noise has mean 0 and variance 1; each seed gives an independent noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

import type { Node } from "three/webgpu";

type Value = Node | number;

/** Gabor noise: a float. */
export function gabor_noise(p: Node, frequency: Value, orientation: Value, seed: Value): Node;
/** (noise, quadrature), of which the second has cosines instead of sines: a vec2. */
export function gabor_noise_quadrature(p: Node, frequency: Value, orientation: Value, seed: Value): Node;
/** (noise, d/dx, d/dy), derivatives per kernel radius: a vec3. */
export function gabor_noise_gradient(p: Node, frequency: Value, orientation: Value, seed: Value): Node;
/** Noise that repeats after `period`, a vec2, from 1/1024 to 10^9 kernel radii along each axis. */
export function gabor_noise_tiled(p: Node, period: Node, frequency: Value, orientation: Value, seed: Value): Node;
/** Noise that evolves in place and repeats when `evolution` grows by 1. */
export function gabor_noise_animated(p: Node, evolution: Value, frequency: Value, orientation: Value, seed: Value): Node;
/** Noise in 3D; p and direction are vec3, and direction may have any length but 0. */
export function gabor_noise_3d(p: Node, frequency: Value, direction: Node, seed: Value): Node;
/** (cosine, sine, intensity) of stripes of even contrast, at right angles to a wave vector, a vec2. 2 is a good sharpness. */
export function gabor_stripes(p: Node, wave: Node, sharpness: Value, seed: Value): Node;

/** A position with a period and an evolution in turns. Without an evolution, the noise stands still. */
export interface GaborPlace { p: Node; period?: Node; evolution?: Value; }
export interface GaborField { noise: Node; quadrature: Node; gradient: Node; }
export interface GaborPlace3d { p: Node; }
export interface GaborField3d { noise: Node; gradient: Node; }

export function gabor_place_at(p: Node): GaborPlace;
/** A position in noise with the period of gabor_noise_tiled. */
export function gabor_place_tiled(p: Node, period: Node): GaborPlace;
export function gabor_place_3d_at(p: Node): GaborPlace3d;
/** The wave vector with a frequency and an orientation: a vec2. */
export function gabor_wave_vector(frequency: Value, orientation: Value): Node;
/** The noise, its quadrature and its gradient, in one evaluation. The wave vector may vary with p. */
export function gabor_field(place: GaborPlace, wave: Node, seed: Value): GaborField;
/** The same in 3D; the wave is a vec3. */
export function gabor_field_3d(place: GaborPlace3d, wave: Node, seed: Value): GaborField3d;
/** The stripes of any noise, like gabor_stripes. */
export function gabor_stripes_of(field: GaborField, sharpness: Value): Node;

/** The seed of part `index` of a sum of independent noises. */
export function gabor_derived_seed(seed: Value, index: Value): Node;
/** Maps -2 ... 2 to [0, 1] and clamps the rest. */
export function gabor_unorm(noise: Value): Node;

/**
 * The view-space normal, for `normalNode`, of a surface that the noise raises along its normal: like bumpMap, but with one
 * evaluation of the noise.
 * @param gradient the noise's gradient with respect to p
 * @param p the position at which the noise was evaluated
 * @param height height of the relief per unit of noise, in view units
 */
export function gabor_normal(gradient: Node, p: Node, height: Value): Node;

/** Brushed metal, streaks along x: colour is linear, height and its slope are in units of p. */
export function gabor_brushed_metal(p: Node, seed: Value):
    { colour: Node, height: Node, slope: Node, roughness: Node, metalness: Node };

/** The noise of an octave. */
export const GABOR_SMOOTH: 0, GABOR_PERLIN: 1;
/** What octaves become before they are summed. */
export const GABOR_FBM: 0, GABOR_BILLOW: 1, GABOR_RIDGED: 2;

/** A sum of 1 to 16 octaves, of which the last one fades in with the fraction. Each basis and shape is a shader of its own. */
export interface GaborFractal { octaves: Value; gain: Value; lacunarity: Value; turn: Value; basis: 0 | 1; shape: 0 | 1 | 2; }
export interface GaborFractalNoise { noise: Node; gradient: Node; }
export interface GaborWarp { place: GaborPlace; dx: Node; dy: Node; }

/**
 * fBm of smooth noise, unless `choices` has other members of a GaborFractal. `gain` is the amplitude of an octave relative to
 * the previous one.
 */
export function gabor_fractal(octaves: Value, gain: Value, choices?: Partial<GaborFractal>): GaborFractal;
/**
 * Any sum of octaves, with mean 0 and variance 1, and its gradient per kernel radius of the first octave. A period must have at
 * least 8/3 kernel radii.
 */
export function gabor_fractal_noise(place: GaborPlace, fractal: GaborFractal, seed: Value): GaborFractalNoise;
/** The same, averaged over the pixel between dFdx(p) and dFdy(p). */
export function gabor_fractal_noise_filtered(place: GaborPlace, dx: Node, dy: Node, fractal: GaborFractal, seed: Value):
    GaborFractalNoise;
export function gabor_fractal_noise_3d(place: GaborPlace3d, fractal: GaborFractal, seed: Value): GaborFractalNoise;
export function gabor_fractal_noise_3d_filtered(place: GaborPlace3d, dx: Node, dy: Node, fractal: GaborFractal, seed: Value):
    GaborFractalNoise;
/** Sums of smooth octaves: floats. */
export function gabor_fbm(p: Node, octaves: Value, gain: Value, seed: Value): Node;
export function gabor_fbm_3d(p: Node, octaves: Value, gain: Value, seed: Value): Node;
export function gabor_billow(p: Node, octaves: Value, gain: Value, seed: Value): Node;
export function gabor_ridged(p: Node, octaves: Value, gain: Value, seed: Value): Node;
/** One octave. gabor_perlin replaces Perlin noise: p is in its cells. */
export function gabor_smooth(p: Node, seed: Value): Node;
export function gabor_perlin(p: Node, seed: Value): Node;
export function gabor_perlin_3d(p: Node, seed: Value): Node;
/**
 * Moves a place along two noises whose deviation is `strength` in kernel radii. A gradient g there becomes
 * (dot(g, dx), dot(g, dy)), and a pixel (a, b) becomes a dx + b dy.
 */
export function gabor_warp(place: GaborPlace, strength: Value, fractal: GaborFractal, seed: Value): GaborWarp;
/** The rank of a normal value among all values, in [0, 1]: gabor_uniform(noise) < 0.3 on 30 % of the area. */
export function gabor_uniform(noise: Value): Node;
