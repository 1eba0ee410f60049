// Shared by passes/bench/bench.glsl and host/lab/bench.

#ifndef GABOR_BENCH_INTERFACE_H
#define GABOR_BENCH_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint bench_group = 8; // invocations along x and y

// Ids of specialization constants. Lower ids are those of the recipe; ids from option_id on are the pass's
// own.
const uint sampling_id = 7;
const uint option_id = 8;

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
