// Shared by passes/places.glsl and host/lab/study.

#ifndef GABOR_PLACES_INTERFACE_H
#define GABOR_PLACES_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint places_group = 64; // invocations

GABOR_PUSH_CONSTANTS(PlacesPush) {
    vec2 wave;       // cycles per kernel radius
    vec2 corner;     // where the grid starts, in cells
    float amplitude; // the normalization K
    float spacing;   // distance between positions of the grid, in cells
    float within;    // 1 to add a random offset of up to a cell to the corner, else 0
    uint grid_bits;
    uint first; // first instance
    uint count; // number of values
    uint place_seed;
    uint noise_seed;
};

GABOR_INTERFACE_END

#endif // GABOR_PLACES_INTERFACE_H
