#version 450
#extension GL_GOOGLE_include_directive : require

// What the drop-in answers at any places, for the tests and the study.

#include "recipe.glsl"

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    float frequency;
    float orientation;
    uint seed;
    uint index; // of the impulse whose word is wanted
};

struct Answer {
    float at;    // gabor_noise_at(cell, local)
    float plain; // gabor_noise(local / R), which ignores the cell
    float unorm; // gabor_unorm(at)
    uint word;   // gabor_impulse_word(cell, index)
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
};

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    float at = gabor_noise_at(s.cell, s.local, gabor_kernel(s.frequency, s.orientation), s.seed);
    float plain = gabor_noise(s.local / GABOR_RADIUS, s.frequency, s.orientation, s.seed);
    uint row_word = gabor_row_word(s.cell.y, gabor_seed_word(s.seed));
    answers[i] = Answer(at, plain, gabor_unorm(at), gabor_impulse_word(s.cell.x, row_word, int(s.index)));
}
