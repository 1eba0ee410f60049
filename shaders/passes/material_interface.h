// Shared by passes/material.comp and host/render.

#ifndef GABOR_MATERIAL_INTERFACE_H
#define GABOR_MATERIAL_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint material_group = 8; // pixels along x and y

GABOR_PUSH_CONSTANTS(MaterialPush) {
    GABOR_BAND
    vec2 size;   // size of the whole picture, in pixels
    vec2 center; // the pixel seen from straight above, or the one that the camera looks at
    vec2 corner; // p at the picture's corner, or under the camera
    vec2 yaw;    // cosine and sine of the eye's angle around the z axis, for a body
    vec2 pitch;  // cosine and sine of the eye's angle above the plane z = 0
    vec2 lamp;   // like `lamp` in passes/light.glsl
    float pixel; // units of p per pixel; in perspective, the camera's height in units of p; for a body, as in
                 // SolidPush
    float unit;  // radius of the sphere in units of p, for a body
    float sky;   // rows above the horizon; 0 unless in perspective
    uint seed;
};

GABOR_INTERFACE_END

#endif // GABOR_MATERIAL_INTERFACE_H
