// Shared by passes/solid.comp and host/render.

#ifndef GABOR_SOLID_INTERFACE_H
#define GABOR_SOLID_INTERFACE_H

#include "passes/colour.h"
#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint solid_group = 8; // pixels along x and y

// One noise of the sum, in its own kernel radii.
struct SolidWave {
    vec2 direction; // unit direction of the waves, in the plane z = 0
    float frequency;
    float radius;    // radius of its kernels, in kernel radii of the picture
    float amplitude; // the square root of its share of the variance
    uint seed;
    uint isotropic;  // 1 if it has waves in all directions
    vec2 weights[3]; // weights of (quadrature, noise) in the components of a colour
};

// Lengths are in kernel radii of the picture.
GABOR_PUSH_CONSTANTS(SolidPush) {
    GABOR_BAND
    vec2 center; // centre of the picture, in pixels from its corner
    vec2 yaw;    // cosine and sine of the eye's angle around the z axis
    vec2 pitch;  // cosine and sine of the eye's angle above the plane z = 0
    float pixel; // side of a pixel: in kernel radii for a slice, otherwise in the plane at distance 1 from
                 // the eye
    float unit;  // radius of the sphere in kernel radii
    float depth; // z of the slice, in kernel radii
    float share; // side of the filter's pixel on a body, in pixels of the view: less than 1 if the view is
                 // coarse
    float time;
    int waves;
};

GABOR_INTERFACE_END

#endif // GABOR_SOLID_INTERFACE_H
