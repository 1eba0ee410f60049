// Shared by passes/bake.comp and host/render.

#ifndef GABOR_BAKE_INTERFACE_H
#define GABOR_BAKE_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint bake_group = 32; // runs of columns

// Consecutive pixels that use the same cells along an axis.
struct Run {
    int cell;    // the first cell used
    float local; // centre of the first pixel, in cells from the start of `cell + 1`
    int first;   // that pixel's index in the region; may be negative
    int count;   // number of pixels, at most block_columns along x
};

// One noise of the sum. Lengths are in its own kernel radii.
struct BakeWave {
    vec2 wave;        // like `wave` of gabor_field
    vec2 column_turn; // cos and sin of the phase change from one column to the next
    vec2 row_turn;    // cos and sin of the phase change from one row to the next
    float amplitude;  // factor of the noise, including the normalization of sparse noise
    uint seed;
    vec2 weights[3]; // weights of (quadrature, noise) in the components of a colour
};

// The noises of a dispatch share a kernel radius, so that the same runs serve them all.
GABOR_PUSH_CONSTANTS(BakePush) {
    GABOR_BAND
    vec2 radius;  // like GaborPlace.radius
    ivec2 period; // like GaborPlace.period
    vec2 pixel;   // kernel radii per pixel
    vec2 stretch; // kernel radii per unit of length in the derivatives
    float time;   // like GaborPlace.evolution, within [0, 1)
    uint first_wave;
    uint wave_count;
    uint first_column_run;
    uint column_runs;
    int first_slice;    // first of three nodes along z, for a slice of solid noise
    float slice_offset; // offset of the slice from the second of these nodes, in node spacings
};

GABOR_INTERFACE_END

#endif // GABOR_BAKE_INTERFACE_H
