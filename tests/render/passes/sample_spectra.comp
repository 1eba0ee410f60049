#version 450
#extension GL_GOOGLE_include_directive : require

// What the drop-in's spectra and filter answer at any places, for the tests.

#define GABOR_LOBES 3

#include "recipe.glsl"

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    vec2 radius;
    ivec2 period;
    float time;
    uint seed;
    vec2 dx;
    vec2 dy;
    float lobes[15]; // frequency, orientation, frequency_spread, orientation_spread, power of each
    float padding;
    vec2 p; // of the functions of a position, kernel radii
};

struct Answer {
    vec2 value; // gabor_field of the three lobes
    vec2 slope_x;
    vec2 slope_y;
    vec2 value_filtered; // gabor_field_filtered
    float removed;
    float spread; // the functions of a position; this and the next have the first lobe alone
    vec2 filtered;
    float chosen; // gabor_noise_lobes
    float sum;
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
    GaborLobes lobes;
    lobes.count = GABOR_LOBES;
    for (int k = 0; k < GABOR_LOBES; ++k)
        lobes.lobe[k] = gabor_lobe(s.lobes[5 * k], s.lobes[5 * k + 1], s.lobes[5 * k + 2], s.lobes[5 * k + 3],
                                   s.lobes[5 * k + 4]);
    GaborKernel kernel = gabor_kernel_lobes(lobes);
    GaborPlace place = GaborPlace(s.cell, s.local, s.radius, s.period, s.time);
    GaborField field = gabor_field(place, kernel, s.seed);
    vec2 p = s.p;

    Answer answer;
    answer.value = field.value;
    answer.slope_x = field.slope_x;
    answer.slope_y = field.slope_y;
    answer.spread = gabor_noise_spread(p, s.lobes[0], s.lobes[1], s.lobes[2], s.lobes[3], s.seed);
    answer.chosen = gabor_noise_lobes(p, lobes, s.seed);
    answer.sum = gabor_noise_sum(p, lobes, s.seed);
    answer.value_filtered = vec2(0.0);
    answer.removed = 0.0;
    answer.filtered = vec2(0.0);
    if (s.dx != vec2(0.0) || s.dy != vec2(0.0)) { // else it would take most of the time for nothing
        GaborFootprint footprint = gabor_footprint(s.dx, s.dy);
        answer.value_filtered = gabor_field_filtered(place, kernel, footprint, s.seed);
        answer.removed = gabor_removed(kernel, footprint);
        answer.filtered = gabor_noise_filtered(p, s.dx, s.dy, s.lobes[0], s.lobes[1], s.seed);
    }
    answers[i] = answer;
}
