// Shared by passes/points.comp and host/lab/study.

#ifndef GABOR_POINTS_INTERFACE_H
#define GABOR_POINTS_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint points_group = 8; // invocations along x and y

GABOR_PUSH_CONSTANTS(PointsPush) {
    uint side;     // side of the square, in cells
    uint capacity; // largest number of impulses stored per cell
    uint seed;
};

GABOR_INTERFACE_END

#endif // GABOR_POINTS_INTERFACE_H
