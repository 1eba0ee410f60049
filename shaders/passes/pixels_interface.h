// Shared by passes/pixels.comp and host/render.

#ifndef GABOR_PIXELS_INTERFACE_H
#define GABOR_PIXELS_INTERFACE_H

#include "passes/colour.h"
#include "passes/constants.h"
#include "passes/line.h"

GABOR_INTERFACE_BEGIN

const uint pixels_group = 8; // pixels along x and y

// One noise of the sum, in its own kernel radii.
struct PixelsWave {
    vec2 nodes;        // like GaborPlace.radius
    ivec2 period;      // like GaborPlace.period
    vec2 camera;       // the camera's position in its cell, in perspective
    float frequency;   // cycles per radius along x, or a factor for the painted frequency
    float orientation; // radians, added to any painted orientation
    vec2 radius;       // radii of its kernels along x and y, in kernel radii of the picture
    float amplitude;   // the square root of its share of the variance
    uint seed;
    int table;       // index of its table of lines
    vec2 weights[3]; // weights of (quadrature, noise) in the components of a colour
};

// Lengths are in kernel radii of the picture.
GABOR_PUSH_CONSTANTS(PixelsPush) {
    GABOR_BAND
    ivec2 paint_size;   // size of the paint, in samples
    vec2 paint_scale;   // paint samples per pixel
    vec2 paint_corner;  // corner of the region, in samples
    float time;         // like GaborPlace.evolution
    float pixel;        // kernel radii per pixel; in perspective, the camera's height in kernel radii
    float focal_length; // focal length in pixels, in perspective
    int waves;
    int tables; // number of tables of lines, interleaved: each column or row has one line per table
};

GABOR_INTERFACE_END

#endif // GABOR_PIXELS_INTERFACE_H
