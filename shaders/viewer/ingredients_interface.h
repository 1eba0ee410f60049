// For viewer/ingredients.comp, and host/viewer, which draws with it.

#ifndef GABOR_VIEWER_INGREDIENTS_INTERFACE_H
#define GABOR_VIEWER_INGREDIENTS_INTERFACE_H

#include "passes/line.h"

GABOR_INTERFACE_BEGIN

const uint ingredients_group = 8; // pixels along x and y

GABOR_PUSH_CONSTANTS(IngredientsPush) {
    vec2 wave;          // cycles per kernel radius
    vec2 camera;        // in perspective: where it stands in its cell
    float amplitude;    // makes the variance 1
    float pixel;        // in perspective: the camera's height in kernel radii
    float focal_length; // pixels, in perspective
    uint seed;
    int width;
    int height;
    int first_row; // of the band
    int before;    // pixels in the buffer before those of the band
};

GABOR_INTERFACE_END

#endif // GABOR_VIEWER_INGREDIENTS_INTERFACE_H
