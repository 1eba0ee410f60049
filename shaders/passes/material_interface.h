// For passes/material.comp and host/render.

#ifndef GABOR_MATERIAL_INTERFACE_H
#define GABOR_MATERIAL_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint material_group = 8; // pixels along x and y

GABOR_PUSH_CONSTANTS(MaterialPush) {
    vec2 size;   // of the whole picture, in pixels
    float pixel; // units of p per pixel; in perspective the camera's height in them
    float sky;   // rows above the horizon, 0 but in perspective
    uint seed;
    int first_column; // of these pixels in the picture
    int first_row;
    int width;
    int height;
    int before; // pixels in the buffer before those of the band
};

GABOR_INTERFACE_END

#endif // GABOR_MATERIAL_INTERFACE_H
