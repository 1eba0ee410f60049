// Shared by host/render and the passes that draw in colour.

#ifndef GABOR_COLOUR_H
#define GABOR_COLOUR_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

// How components become colours, like noise::Colour. Only x, y and z of each vector are used.
struct PixelsColour {
    vec4 histogram[6]; // coefficients of 1, z, ... z^5 for each component
    vec4 mean;
    vec4 mixing[3]; // a row for each channel
};

GABOR_INTERFACE_END

#endif // GABOR_COLOUR_H
