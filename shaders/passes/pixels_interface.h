// For passes/pixels.comp, host/render, and the viewer, which draws with it.

#ifndef GABOR_PIXELS_INTERFACE_H
#define GABOR_PIXELS_INTERFACE_H

#include "passes/line.h"

GABOR_INTERFACE_BEGIN

const uint pixels_group = 8; // pixels along x and y

struct Lobe {
    float frequency;
    float orientation; // radians
    float frequency_spread;
    float orientation_spread; // radians
    float power;
};

GABOR_PUSH_CONSTANTS(PixelsPush) {
    vec2 radius;       // as in GaborPlace
    ivec2 period;      // as in GaborPlace
    ivec2 paint_size;  // samples
    vec2 paint_scale;  // samples of the paint per pixel
    vec2 paint_corner; // of the region, in samples
    vec2 camera;       // in perspective: where it stands in its cell
    float time;        // as in GaborPlace
    float frequency;
    float orientation;  // radians
    float pixel;        // kernel radii per pixel; in perspective the camera's height in kernel radii
    float focal_length; // pixels, in perspective
    uint seed;
    int width;
    int height;
    int first_row; // of the band
    int before;    // pixels in the buffer before those of the band
};

GABOR_INTERFACE_END

#endif // GABOR_PIXELS_INTERFACE_H
