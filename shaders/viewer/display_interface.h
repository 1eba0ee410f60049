// Shared by viewer/display.glsl and host/viewer.

#ifndef GABOR_VIEWER_SHOW_INTERFACE_H
#define GABOR_VIEWER_SHOW_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint display_group = 256; // pixels per group, when writing files
const int own_colours = 5;      // the number of the user's colour map

// The ids of the specialization constants that viewer/display.glsl describes.
const uint display_output_id = 0;
const uint display_colours_id = 1;
const uint display_channels_id = 2;
const uint display_companion_id = 3;
const uint display_normal_id = 4;
const uint display_coverage_id = 5;
const uint display_coarse_id = 6;
const uint display_tiles_id = 7;
const uint display_profile_id = 8;
const uint display_unlit_id = 9;
const uint display_environment_id = 10;
const uint display_constant_count = 11;

GABOR_PUSH_CONSTANTS(DisplayPush) {
    vec2 origin;     // origin of the canvas in the framebuffer, in pixels
    ivec2 grid;      // number of values along x and y
    vec2 size;       // size of the canvas, in pixels
    vec2 lamp;       // like `lamp` in passes/light.glsl
    float stride;    // pixels per value
    float contrast;  // standard deviations from the mean to the ends of the colour map
    float deviation; // standard deviation of a derivative, per kernel radius
    float spacing;   // distance between values, in kernel radii or units of height
    float green;     // sign of green in normals: 1 for up, as in OpenGL, -1 for down, as in DirectX
    int first_row;   // first row of the band, when writing files
    int count;       // number of pixels in the band
    float turns;     // turns of the stripes' phase per pixel
    uvec4 ramp_low;  // the user's colour map: eight stops with 8 bits each for red, green, blue and position
    uvec4 ramp_high;
};

GABOR_INTERFACE_END

#endif // GABOR_VIEWER_SHOW_INTERFACE_H
