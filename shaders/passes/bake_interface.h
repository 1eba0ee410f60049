// For passes/bake.comp and host/render.

#ifndef GABOR_BAKE_INTERFACE_H
#define GABOR_BAKE_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint bake_group = 32; // runs of columns

// Consecutive pixels that visit the same cells along an axis.
struct Run {
    int cell;    // the first cell visited
    float local; // place of the first pixel's centre, in cells from where the next cell begins
    int first;   // that pixel, counted from the region's first: it may be negative
    int count;   // along x at most block_columns
};

GABOR_PUSH_CONSTANTS(BakePush) {
    vec2 wave;        // as in GaborKernel
    vec2 column_turn; // cos and sin of the phase from one column to the next
    vec2 row_turn;    // and from one row to the next
    vec2 radius;      // as in GaborPlace
    ivec2 period;     // as in GaborPlace
    float time;       // as in GaborPlace, within [0, 1)
    float amplitude;  // as in GaborKernel, times what fewer cells per radius take; 1 for the lattice
    float pixel;      // kernel radii per pixel
    uint seed;
    int width;
    int height;
    int first_row; // of the band, in the units of Run.first
    uint column_runs;
    uint first_row_run;
};

GABOR_INTERFACE_END

#endif // GABOR_BAKE_INTERFACE_H
