// Shared by passes/ocean.comp and host/render.

#ifndef GABOR_OCEAN_INTERFACE_H
#define GABOR_OCEAN_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

#define GABOR_OCEAN_BANDS 12 // waves down to 0.1 m

const uint ocean_group = 8; // pixels along x and y

GABOR_PUSH_CONSTANTS(OceanPush) {
    GABOR_BAND
    vec2 center;    // the pixel that the camera looks at
    vec2 yaw;       // cosine and sine of the camera's azimuth
    vec2 pitch;     // cosine and sine of the camera's elevation
    vec2 sun;       // x and y of the unit vector to the sun
    float altitude; // metres
    float pixel;    // side of a pixel at distance 1 from the camera
    int second;
    float fraction; // of a second
    uint seed;
};

GABOR_INTERFACE_END

#endif // GABOR_OCEAN_INTERFACE_H
