// gabor_ingredients.glsl: the points, weights, kernels and envelopes that [TNVT19] compares, for the study.
//
//     n(p) = K sum_i w_i g(p - x_i),    g(d) = envelope(d) wave(2 pi (F d.omega + phase_i)),    |d| <= 1
//
// A cell is as wide as the kernel radius. Define these before including this file, as macros or
// specialization constants:
//
//   GABOR_IMPULSES   N, impulses per cell, at least 1; the mean for Poisson points, exact for all others
//   GABOR_POINTS     0 Poisson   1 stratified   2 jittered   3 jittered hexagonal   4 Sobol   5 scrambled Sobol
//   GABOR_WEIGHTS    0 uniform in [-1, 1]   1 Bernoulli, -1 or 1   2 none
//   GABOR_KERNEL     0 cosine   1 sine   2 random phase
//   GABOR_ENVELOPE   0 truncated Gaussian   1 C0: Gaussian minus its value at the edge
//                    2 C1 radial (1 - |d|^2)^2   3 C1 separable (1 - x^2)^2 (1 - y^2)^2
//   GABOR_PERIOD     cells after which the instance repeats, at least 3; 0 if it does not
//   GABOR_HEX_STEP, GABOR_HEX_A, GABOR_HEX_B, GABOR_HEX_OVERHANG    the lattice of the hexagons
//
// The noise is gabor_ingredients; gabor_count and gabor_point give its impulses. Names with gabor_impl_ are
// private.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_INGREDIENTS_GLSL
#define GABOR_INGREDIENTS_GLSL

#include "gabor_sparse.glsl" // provides the hash and the sine

// ---- Points --------------------------------------------------------------------------------------------------------

// Returns a Poisson count by Knuth's product of uniforms, as in the seminal implementation. Splits the mean
// into parts of at most 64, for which exp does not underflow.
int gabor_impl_poisson_count(float mean, uint cell_word) {
    int draws = 0;
    int parts = 0;
    for (; mean > 0.0; mean -= 64.0) {
        float end = exp(-min(mean, 64.0));
        float product = 1.0;
        do {
            uint word = gabor_impl_mix(cell_word + uint(draws++) * GABOR_IMPL_CELL_STRIDE, cell_word);
            product *= (float(int(word >> 8u)) + 0.5) / 16777216.0;
        } while (product > end);
        ++parts;
    }
    return draws - parts;
}

// Returns two numbers in (0, 1) from bits 8 to 31.
vec2 gabor_impl_unit_square(uint word) {
    return (vec2(int(word >> 20u), int((word >> 8u) & 0xfffu)) + 0.5) / 4096.0;
}

// Returns a random point in one of N sub-cells of equal area in round(sqrt(N)) rows. If N is not a square, some
// rows have one sub-cell more than others, and the height of a row is proportional to its number of sub-cells.
vec2 gabor_impl_jittered_point(int index, vec2 unit) {
    float n = float(GABOR_IMPULSES);
    float i = float(index);
    float rows = floor(sqrt(n) + 0.5);
    float row = floor((i * rows + 0.5) / n);
    float first = floor((row * n + rows - 0.5) / rows);
    float next = floor(((row + 1.0) * n + rows - 0.5) / rows);
    return vec2((i - first + unit.x) / (next - first), (first + unit.y * (next - first)) / n);
}

// The Voronoi cells of the lattice (i / N, i STEP / N) mod 1 are N equal hexagons per cell, which tile the
// plane across all cells. Returns a random point in one of them. A and B are a reduced basis of the
// lattice with A.B >= 0. A random point of their parallelogram becomes uniform in the hexagon when moved by
// whichever of A, B and B - A bring it nearer to the centre.
vec2 gabor_impl_hexagon_point(int index, vec2 unit) {
    float n = float(GABOR_IMPULSES);
    vec2 a = GABOR_HEX_A;
    vec2 b = GABOR_HEX_B;
    vec2 c = b - a;
    vec2 d = (unit.x - 0.5) * a + (unit.y - 0.5) * b;
    d -= a * floor(dot(d, a) / dot(a, a) + 0.5);
    d -= b * floor(dot(d, b) / dot(b, b) + 0.5);
    d -= c * floor(dot(d, c) / dot(c, c) + 0.5);
    float row = floor(n * fract(float(index * GABOR_HEX_STEP) / n) + 0.5);
    return vec2(float(index) + 0.5, row + 0.5) / n + d;
}

// Sobol's sequence in two dimensions as 32-bit fractions. The first coordinate is the bit reversal of the index. The
// second has the primitive polynomial x + 1, so that each direction number v is followed by v ^ (v >> 1).
// These numbers form Pascal's triangle modulo 2, which is applied here to all bits in five steps (Ahmed, "An
// Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", EGSR 2024).
uvec2 gabor_impl_sobol_point(uint index) {
    uint v = index;
    v ^= (v & 0xffff0000u) >> 16u;
    v ^= (v & 0xff00ff00u) >> 8u;
    v ^= (v & 0xf0f0f0f0u) >> 4u;
    v ^= (v & 0xccccccccu) >> 2u;
    v ^= (v & 0xaaaaaaaau) >> 1u;
    return uvec2(bitfieldReverse(index), bitfieldReverse(v));
}

// Owen's nested scrambling: each bit is flipped by a hash of the bits above it (the hash of Laine and Karras 2011 in
// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020).
uint gabor_impl_owen_scrambled(uint fraction, uint seed) {
    uint v = bitfieldReverse(fraction);
    v += seed;
    v ^= v * 0x6c50b47cu;
    v ^= v * 0xb82f1e52u;
    v ^= v * 0xc7afe638u;
    v ^= v * 0x8d22f6e6u;
    return bitfieldReverse(v);
}

// Returns the number of impulses in a cell. `cell_word` is the cell's hash: that of an impulse with index -1.
int gabor_count(uint cell_word) {
    return GABOR_POINTS == 0 ? gabor_impl_poisson_count(float(GABOR_IMPULSES), cell_word) : GABOR_IMPULSES;
}

// Returns the position of an impulse relative to its cell's corner. With Sobol points, a cell has N successive points from
// a random start in the sequence; with scrambled ones, it has the first N under its own scrambling.
vec2 gabor_point(int index, uint word, uint cell_word) {
    if (GABOR_POINTS == 2)
        return gabor_impl_jittered_point(index, gabor_impl_unit_square(word));
    if (GABOR_POINTS == 3)
        return gabor_impl_hexagon_point(index, gabor_impl_unit_square(word));
    if (GABOR_POINTS >= 4) {
        uvec2 fraction = gabor_impl_sobol_point(uint(index) + (GABOR_POINTS == 4 ? cell_word : 0u));
        if (GABOR_POINTS == 5)
            fraction = uvec2(gabor_impl_owen_scrambled(fraction.x, cell_word),
                             gabor_impl_owen_scrambled(fraction.y, gabor_impl_mix(cell_word, 1u)));
        return vec2(ivec2(fraction >> 8u)) / 16777216.0;
    }
    return gabor_impl_unit_square(word);
}

// ---- Weights, kernels and envelopes --------------------------------------------------------------------------------

float gabor_impl_ingredient_weight(uint word) {
    if (GABOR_WEIGHTS == 0)
        return (float(int(word & 0xffu)) - 127.5) / 128.0;
    return GABOR_WEIGHTS == 1 && (word & 0x80u) != 0u ? -1.0 : 1.0;
}

float gabor_impl_ingredient_wave(float turns, uint word) {
    if (GABOR_KERNEL == 2)
        turns += float(int(gabor_impl_mix(word, 2u) >> 8u)) / 16777216.0;
    return gabor_impl_sine(GABOR_KERNEL == 0 ? turns + 0.25 : turns);
}

float gabor_impl_ingredient_envelope(vec2 d) {
    if (GABOR_ENVELOPE == 3) {
        vec2 u = max(1.0 - d * d, 0.0);
        return u.x * u.x * u.y * u.y;
    }
    float square = dot(d, d);
    if (GABOR_ENVELOPE == 2) {
        float u = max(1.0 - square, 0.0);
        return u * u;
    }
    float gaussian = exp(-3.14159265 * square) - (GABOR_ENVELOPE == 1 ? 0.0432139183 : 0.0);
    return square <= 1.0 ? gaussian : 0.0;
}

// ---- The noise -----------------------------------------------------------------------------------------------------

int gabor_impl_wrapped_cell(int cell) {
    float period = float(GABOR_PERIOD);
    return GABOR_PERIOD == 0 ? cell : cell - int(period * floor((float(cell) + 0.5) / period));
}

// Returns the sum, without K, at cell + local in kernel radii. `wave` is F omega, in cycles per kernel radius. Cells wrap
// around at 2^31.
float gabor_ingredients(ivec2 cell, vec2 local, vec2 wave, uint seed) {
    float reach = GABOR_POINTS == 3 ? 1.0 + GABOR_HEX_OVERHANG : 1.0;
    int visited = GABOR_POINTS == 3 && GABOR_HEX_OVERHANG > 0.0 ? 4 : 3;
    cell += ivec2(floor(local));
    local -= floor(local);
    vec2 first = floor(local - reach);
    uint seed_word = gabor_impl_seed_word(seed);
    float sum = 0.0;
    for (int j = 0; j < visited; ++j) {
        uint row_word = gabor_impl_row_word(gabor_impl_wrapped_cell(cell.y + int(first.y) + j), seed_word);
        for (int i = 0; i < visited; ++i) {
            int column = gabor_impl_wrapped_cell(cell.x + int(first.x) + i);
            uint cell_word = gabor_impl_impulse_word(column, row_word, -1);
            vec2 corner = first + vec2(float(i), float(j));
            int count = gabor_count(cell_word);
            for (int k = 0; k < count; ++k) {
                uint word = gabor_impl_impulse_word(column, row_word, k);
                vec2 d = (local - gabor_point(k, word, cell_word)) - corner;
                sum += gabor_impl_ingredient_weight(word) * gabor_impl_ingredient_envelope(d)
                     * gabor_impl_ingredient_wave(dot(wave, d), word);
            }
        }
    }
    return sum;
}

float gabor_ingredients(vec2 p, vec2 wave, uint seed) {
    return gabor_ingredients(ivec2(0), p, wave, seed);
}

#endif // GABOR_INGREDIENTS_GLSL
