// Shared by passes/erode.comp and host/render.

#ifndef GABOR_ERODE_INTERFACE_H
#define GABOR_ERODE_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint erode_group = 8; // pixels along x and y
const int erode_halo = 2;   // rows of the map that a slope needs above and below

GABOR_PUSH_CONSTANTS(ErodePush) {
    GABOR_BAND       // a band of the map's pixels
        vec2 period; // period of a tile, 0 for none
    float pixel;     // side of a pixel, in units of height
    uint seed;
    int map_width; // pixels
    int tileable;  // whether the map's columns repeat
};

GABOR_INTERFACE_END

#endif // GABOR_ERODE_INTERFACE_H
