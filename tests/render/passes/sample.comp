#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates the drop-in at given places, for the tests.

#include "recipe.glsl"

layout(constant_id = 7) const int wanted = 0; // 0: all the answers, 1: only `at`, 2: `complex`, `tiled` and `animated`

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    vec2 radius;
    ivec2 period;
    float time;
    float frequency;
    float orientation;
    uint seed;
    uint index;     // of the impulse whose word to return
    float period_x; // of gabor_noise_tiled, kernel radii
    float period_y;
    uint padding;
    vec2 p;         // of the functions of a position, kernel radii
};

struct Answer {
    vec2 value; // gabor_field
    vec2 slope_x;
    vec2 slope_y;
    vec2 complex; // this and those below but for `at`: of p
    vec3 gradient;
    float noise;
    float tiled;
    float animated;
    float unorm;
    float at; // gabor_noise_at(cell, local)
    vec2 phasor;
    uint word;
    uint padding;
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    GaborKernel kernel = gabor_kernel(s.frequency, s.orientation);
    vec2 p = s.p;
    bool all = wanted == 0;
    if (all || wanted == 1)
        answers[i].at = gabor_noise_at(s.cell, s.local, kernel, s.seed);
    if (all || wanted == 2) {
        answers[i].complex = gabor_noise_complex(p, s.frequency, s.orientation, s.seed);
        answers[i].tiled = gabor_noise_tiled(p, vec2(s.period_x, s.period_y), s.frequency, s.orientation, s.seed);
        answers[i].animated = gabor_noise_animated(p, s.time, s.frequency, s.orientation, s.seed);
    }
    if (!all)
        return;

    GaborField field = gabor_field(GaborPlace(s.cell, s.local, s.radius, s.period, s.time), kernel, s.seed);
    answers[i].value = field.value;
    answers[i].slope_x = field.slope_x;
    answers[i].slope_y = field.slope_y;
    answers[i].gradient = gabor_noise_gradient(p, s.frequency, s.orientation, s.seed);
    answers[i].noise = gabor_noise(p, s.frequency, s.orientation, s.seed);
    answers[i].unorm = gabor_unorm(field.value.y);
    answers[i].phasor = gabor_phasor(field.value);
    answers[i].word = gabor_impl_impulse_word(s.cell.x, gabor_impl_row_word(s.cell.y, gabor_impl_seed_word(s.seed)), int(s.index));
}
