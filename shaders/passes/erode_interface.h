// For passes/erode.comp and host/render.

#ifndef GABOR_ERODE_INTERFACE_H
#define GABOR_ERODE_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint erode_group = 8;   // pixels along x and y
const int erode_halo = 2;     // rows of the map that a slope needs above and below
const int erode_channels = 5; // height, slope along x and y, ridge, height minus the map's height

GABOR_PUSH_CONSTANTS(ErodePush) {
    vec2 period; // of a tile; 0 for none
    float pixel; // side of a pixel, in units of height
    uint seed;
    int map_width; // pixels
    int tileable;  // whether the map's columns repeat
    int hills;     // 1: hills of gabor_terrain in place of a map
    int first_column;
    int first_row; // of the band in the map; the heights begin erode_halo rows above it
    int width;
    int height;
    int octaves; // this and the following: GaborErosion
    float frequency;
    float strength;
    float lacunarity;
    float gain;
    float onset;
    float detail;
    float sharpness;
    float ridge_rounding;
    float crease_rounding;
    float gully_weight;
    float branching;
};

GABOR_INTERFACE_END

#endif // GABOR_ERODE_INTERFACE_H
