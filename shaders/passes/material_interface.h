// For passes/material.comp and host/render.

#ifndef GABOR_MATERIAL_INTERFACE_H
#define GABOR_MATERIAL_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint material_group = 8; // pixels along x and y

GABOR_PUSH_CONSTANTS(MaterialPush) {
    GABOR_BAND
    vec2 size;   // of the whole picture, in pixels
    vec2 center; // the pixel that is seen from straight above, or where the camera looks
    vec2 corner; // where p is in the picture's corner, or under the camera
    vec2 yaw;    // of a body: cosine and sine of the eye's angle around the axis z
    vec2 pitch;  // and of its height above the plane z = 0
    float
        pixel;  // units of p per pixel; in perspective the camera's height in them; of a body as in SolidPush
    float unit; // of a body: the unit in which the sphere has radius 1, in those of p
    float sky;  // rows above the horizon, 0 but in perspective
    uint seed;
};

GABOR_INTERFACE_END

#endif // GABOR_MATERIAL_INTERFACE_H
