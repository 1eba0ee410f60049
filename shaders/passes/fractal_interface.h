// Shared by passes/fractal.comp and host/render.

#ifndef GABOR_FRACTAL_INTERFACE_H
#define GABOR_FRACTAL_INTERFACE_H

#include "passes/constants.h"
#include "passes/line.h"

GABOR_INTERFACE_BEGIN

const uint fractal_group = 8; // pixels along x and y

// Lengths are in kernel radii of the first octave.
GABOR_PUSH_CONSTANTS(FractalPush) {
    GABOR_BAND
    vec2 nodes;         // like GaborPlace.cells_per_radius
    ivec2 period;       // like GaborPlace.period
    vec2 camera;        // the camera's position in its cell, in perspective
    float time;         // like GaborPlace.evolution
    float pixel;        // kernel radii per pixel; in perspective, the camera's height in kernel radii
    float focal_length; // focal length in pixels, in perspective
    float octaves;      // this and the next three are members of GaborFractal
    float gain;
    float lacunarity;
    float turn;
    float warp; // strength of a warp by fBm of the same octaves
    uint seed;
};

GABOR_INTERFACE_END

#endif // GABOR_FRACTAL_INTERFACE_H
