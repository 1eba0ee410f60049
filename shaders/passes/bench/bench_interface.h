// For passes/bench/bench.glsl and host/bench.

#ifndef GABOR_BENCH_INTERFACE_H
#define GABOR_BENCH_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint bench_group = 8; // invocations along x and y

GABOR_PUSH_CONSTANTS(BenchPush) {
    float frequency;   // cycles per kernel radius
    float orientation; // radians
    float pixel;       // kernel radii per pixel
    uint seed;
    uint width;
    uint height;
};

GABOR_INTERFACE_END

#endif // GABOR_BENCH_INTERFACE_H
