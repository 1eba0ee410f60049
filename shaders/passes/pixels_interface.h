// For passes/pixels.comp and host/render.

#ifndef GABOR_PIXELS_INTERFACE_H
#define GABOR_PIXELS_INTERFACE_H

#include "passes/colour.h"
#include "passes/constants.h"
#include "passes/line.h"

GABOR_INTERFACE_BEGIN

const uint pixels_group = 8; // pixels along x and y

// One noise of the sum, in its own kernel radii.
struct PixelsWave {
    vec2 nodes;        // as GaborPlace.radius
    ivec2 period;      // as in GaborPlace
    vec2 camera;       // in perspective: where it stands in its cell
    float frequency;   // of the wave; where it is painted, times that of the paint
    float orientation; // radians, and that of the paint more
    float radius;      // of its kernels, in those of the picture
    float amplitude;   // the root of its share of the variance
    uint seed;
    int table;       // of lines
    vec2 weights[3]; // in the components of colours, of (quadrature, noise)
};

// Lengths are in kernel radii of the picture.
GABOR_PUSH_CONSTANTS(PixelsPush) {
    GABOR_BAND
    ivec2 paint_size;   // samples
    vec2 paint_scale;   // samples of the paint per pixel
    vec2 paint_corner;  // of the region, in samples
    float time;         // as in GaborPlace
    float pixel;        // kernel radii per pixel; in perspective the camera's height in kernel radii
    float focal_length; // pixels, in perspective
    int waves;
    int tables; // of lines: each column and each row has one in each, side by side
};

GABOR_INTERFACE_END

#endif // GABOR_PIXELS_INTERFACE_H
