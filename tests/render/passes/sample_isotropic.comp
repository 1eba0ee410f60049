#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates the isotropic noise of gabor_spectrum.glsl at given places, for the tests.

#include "gabor_lattice.glsl"
#include "gabor_spectrum.glsl"

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    vec2 radius;
    ivec2 period;
    vec2 p; // of functions of a position
    vec2 tile;
    vec2 dx;
    vec2 dy;
    float frequency;
    float time;
    int animated;
    uint seed;
};

struct Answer {
    vec2 value;
    vec2 slope_x;
    vec2 slope_y;
    vec2 filtered; // and the removed variance
    vec3 gradient;
    float noise;
    float tiled;
    float placed_filtered;
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

// Selects the answers to compute.
#define ALL 0
#define FIELD 1
#define FILTERED 2
layout(constant_id = 0) const int wanted = ALL;

layout(push_constant) uniform Push {
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    GaborPlace place = GaborPlace(s.cell, s.local, s.radius, s.period, s.animated != 0, s.time);
    Answer answer;
    if (wanted != FILTERED) {
        GaborField field = gabor_field_isotropic(place, s.frequency, s.seed);
        answer.value = field.value;
        answer.slope_x = field.slope_x;
        answer.slope_y = field.slope_y;
    }
    if (wanted != FIELD)
        answer.filtered = gabor_noise_isotropic_filtered(s.p, s.dx, s.dy, s.frequency, s.seed);
    if (wanted == ALL) {
        answer.gradient = gabor_noise_isotropic_gradient(s.p, s.frequency, s.seed);
        answer.noise = gabor_noise_isotropic(s.p, s.frequency, s.seed);
        answer.tiled = gabor_noise_isotropic_tiled(s.p, s.tile, s.frequency, s.seed);
        float removed;
        answer.placed_filtered = gabor_field_isotropic_filtered(place, s.frequency, gabor_footprint(vec2(0.0), vec2(0.0)),
                                                                s.seed, removed).value.y;
    }
    answers[i] = answer;
}
