// For viewer/show.glsl, and host/viewer, which shows with it.

#ifndef GABOR_VIEWER_SHOW_INTERFACE_H
#define GABOR_VIEWER_SHOW_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint show_group = 256; // pixels, in files

GABOR_PUSH_CONSTANTS(ShowPush) {
    vec2 origin;     // of the canvas in the framebuffer, pixels
    ivec2 grid;      // values each way
    vec2 size;       // of the canvas, pixels
    float stride;    // pixels per value
    float contrast;  // standard deviations from the mean to the ends
    float deviation; // of a derivative, per kernel radius
    float spacing;   // of a material: from value to value, in its units
    float green;     // of normals: 1 for up, as OpenGL has it, -1 for down, as DirectX
    int first_row;   // in files: of the band
    int count;       // and its pixels
};

GABOR_INTERFACE_END

#endif // GABOR_VIEWER_SHOW_INTERFACE_H
