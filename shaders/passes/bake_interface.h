// For passes/bake.comp and host/render.

#ifndef GABOR_BAKE_INTERFACE_H
#define GABOR_BAKE_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint bake_group = 32; // runs of columns

// Consecutive pixels that visit the same cells along an axis.
struct Run {
    int cell;    // the first cell visited
    float local; // place of the first pixel's centre, in cells from where the next cell begins
    int first;   // that pixel, counted from the region's first: it may be negative
    int count;   // along x at most block_columns
};

// One noise of the sum. Lengths are in its own kernel radii.
struct BakeWave {
    vec2 wave;        // as in GaborKernel
    vec2 column_turn; // cos and sin of the phase from one column to the next
    vec2 row_turn;    // and from one row to the next
    float amplitude;  // what it is multiplied with; for the sparse noise, what normalizes it too
    uint seed;
    vec2 weights[3]; // in the components of colours, of (quadrature, noise)
};

// The noises of one kernel radius: their pixels fall into the same runs.
GABOR_PUSH_CONSTANTS(BakePush) {
    GABOR_BAND
    vec2 radius;   // as in GaborPlace
    ivec2 period;  // as in GaborPlace
    float time;    // as in GaborPlace, within [0, 1)
    float pixel;   // kernel radii per pixel
    float stretch; // kernel radii per unit of length, in which derivatives are
    uint first_wave;
    uint wave_count;
    uint first_column_run;
    uint column_runs;
    int first_slice;    // of a slice of space: the first of its three nodes along z
    float slice_offset; // from the second of them, in node spacings
};

GABOR_INTERFACE_END

#endif // GABOR_BAKE_INTERFACE_H
