// Shared by passes/terrain.comp and host/render.

#ifndef GABOR_TERRAIN_INTERFACE_H
#define GABOR_TERRAIN_INTERFACE_H

#include "passes/constants.h"

GABOR_INTERFACE_BEGIN

const uint terrain_group = 8; // pixels along x and y

GABOR_PUSH_CONSTANTS(TerrainPush) {
    GABOR_BAND
    ivec2 cell;     // cell of the picture's corner, or of the point that the camera looks at
    vec2 corner;    // offset of that corner or point in its cell
    vec2 period;    // period of a tile, 0 for none
    vec2 center;    // the pixel that the camera looks at
    vec2 yaw;       // cosine and sine of the camera's azimuth
    vec2 pitch;     // cosine and sine of the camera's elevation
    vec2 sun;       // x and y of the unit vector to the sun
    float distance; // distance of the camera from the point that it looks at; 0 in the view from above
    float pixel;    // side of a pixel in kernel radii; in perspective, at distance 1 from the camera
    float unit;     // units of height per kernel radius
    float reach;    // the most that erosion adds to the hills
    uint seed;
    float water; // level of lakes in kernel radii
};

GABOR_INTERFACE_END

#endif // GABOR_TERRAIN_INTERFACE_H
