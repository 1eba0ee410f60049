// Shared by passes/bench/bench.glsl and host/lab/bench.

#ifndef GABOR_BENCH_INTERFACE_H
#define GABOR_BENCH_INTERFACE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

const uint bench_group = 8; // invocations along x and y

// Ids of specialization constants. Lower ids are those of the recipe; ids from option_id on are the pass's
// own.
const uint use_id = 7; // one of the uses below
const uint option_id = 8;

// Uses of a pass.
const uint use_timing = 0;     // each invocation sums several values, so that writing the sum costs little
const uint use_samples = 1;    // each invocation samples a random point of an independent instance
const uint use_statistics = 2; // each invocation has one value, for the compiler's statistics

GABOR_PUSH_CONSTANTS(BenchPush) {
    float frequency;   // cycles per kernel radius
    float orientation; // radians
    float pixel;       // kernel radii per pixel
    uint seed;
    uint width;
    uint height;
    uint values; // per invocation of a timed pass
};

GABOR_INTERFACE_END

#endif // GABOR_BENCH_INTERFACE_H
