// Shared by passes/places.glsl and host/lab/study.

#ifndef GABOR_PLACES_INTERFACE_H
#define GABOR_PLACES_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint places_group = 64; // invocations

GABOR_PUSH_CONSTANTS(PlacesPush) {
    vec2 wave;       // cycles per kernel radius
    vec2 corner;     // where the grid starts, in cells
    float amplitude; // K
    float spacing;   // distance between places of the grid, in cells
    float within;    // 1 adds a random offset of up to a cell to the corner, 0 nothing
    uint grid_bits;
    uint first; // first instance
    uint count; // number of values
    uint place_seed;
    uint noise_seed;
};

GABOR_INTERFACE_END

#endif // GABOR_PLACES_INTERFACE_H
