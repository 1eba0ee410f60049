// Shared by the benchmark's passes. Each defines
//     float value(vec2 p, uint instance)

#include "passes/bench/bench_interface.h"

layout(constant_id = use_id) const uint use = use_timing;

layout(local_size_x = bench_group, local_size_y = bench_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };

float value(vec2 p, uint instance);

// Any good generator would do. This is PCG-RXS-M-XS (O'Neill, HMC-CS-2014-0905).
uint random_word(inout uint state) {
    state = state * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

void main() {
    uvec2 here = gl_GlobalInvocationID.xy;
    if (here.x >= width || here.y >= height)
        return;
    uint index = here.y * width + here.x;
    vec2 p = (vec2(here) + 0.5) * pixel;
    uint instance = seed;
    if (use == use_samples) {
        uint state = index * 0x9e3779b9u + seed;
        random_word(state);
        instance = random_word(state);
        uint x = random_word(state);
        uint y = random_word(state);
        p = vec2(float(x), float(y)) * (64.0 / 4294967296.0);
    }
    float sum = 0.0;
    for (uint i = 0u;;) {
        sum += value(p + vec2(31.7 * float(i), 0.0), instance);
        if (use != use_timing || ++i == values)
            break;
    }
    picture[index] = sum;
}
