#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates gabor_direction.glsl at given places, for the tests.

#include "gabor_lattice.glsl"

// A map with a jump, as map_at in test_direction.cpp.
vec2 map_at(vec2 p) {
    return p.x + p.y > 1.0 ? vec2(1.5, 0.25 * p.y) : vec2(-0.5 * p.x, 2.0);
}
#define GABOR_DIRECTION(p) map_at(p)
#include "gabor_direction.glsl"

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    vec2 radius;
    ivec2 period;
    vec2 p; // of functions of a position
    vec2 tile;
    float time;
    int animated;
    uint seed;
    float sharpness;
    vec2 waves[9];
};

struct Answer {
    vec2 given[3]; // gabor_field_waves: value, slope_x, slope_y
    vec2 field[3]; // gabor_field_direction
    vec2 nodes[9];
    vec2 complex;
    vec3 gradient;
    float noise;
    vec3 stripes;
    float tiled;
    vec3 stripes_tiled;
    float padding;
    vec3 stripes_at;
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
    GaborPlace place = GaborPlace(s.cell, s.local, s.radius, s.period, s.animated != 0, s.time);
    GaborWaves waves;
    Answer answer;
    for (int k = 0; k < 9; ++k) {
        waves.wave[k] = s.waves[k];
        answer.nodes[k] = gabor_node_position(place, k);
    }
    GaborField given = gabor_field_waves(place, waves, s.seed);
    answer.given = vec2[](given.value, given.slope_x, given.slope_y);
    place.cell = ivec2(0); // the map is bounded only near the origin
    GaborField field = gabor_field_direction(place, s.seed);
    answer.field = vec2[](field.value, field.slope_x, field.slope_y);
    answer.stripes_at = gabor_stripes_direction_at(place, s.sharpness, s.seed);
    answer.noise = gabor_noise_direction(s.p, s.seed);
    answer.complex = gabor_noise_direction_complex(s.p, s.seed);
    answer.gradient = gabor_noise_direction_gradient(s.p, s.seed);
    answer.stripes = gabor_stripes_direction(s.p, s.sharpness, s.seed);
    answer.tiled = gabor_noise_direction_tiled(s.p, s.tile, s.seed);
    answer.stripes_tiled = gabor_stripes_direction_tiled(s.p, s.tile, s.sharpness, s.seed);
    answers[i] = answer;
}
