// Shared by passes/erode.comp and host/render.

#ifndef GABOR_ERODE_INTERFACE_H
#define GABOR_ERODE_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint erode_group = 8;         // pixels along x and y
const int erode_halo = 1;           // rows of the map that a slope needs above and below
const float missing_height = 3e38f; // a pixel without a height

GABOR_PUSH_CONSTANTS(ErodePush) {
    GABOR_BAND       // a band of the map's pixels
        vec2 period; // period of a tile in units of p, 0 for none
    vec2 nodes;      // nodes of the smoothed map per pixel
    vec2 phase;      // node of the map's corner
    vec2 pixel;      // sides of a pixel in units of p
    ivec2 cell;      // of the map's corner in its world
    vec2 local;      // what remains of the corner, in units of p
    float unit;      // unit of p in the unit of the map's heights
    float steepness; // slopes as the erosion sees them, relative to the map's
    float missing;   // the height of pixels that have none
    float middle;    // halfway between the map's lowest and highest point
    float relief;    // the height of the highest point above that
    uint seed;
    int map_width;   // pixels
    int table_width; // nodes in a row of the smoothed map
    int tileable;    // whether the map's columns repeat
};

GABOR_INTERFACE_END

#endif // GABOR_ERODE_INTERFACE_H
