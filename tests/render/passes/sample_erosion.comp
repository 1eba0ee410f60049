#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates hills and erosion at given places, for the tests.

#include "gabor_lattice.glsl"
#include "gabor_erosion.glsl"
#include "../../../host/lab/passes/bench/splat_erosion.glsl"

layout(constant_id = 0) const int wanted = 0; // 0: all the answers, 1: `eroded`, 2: the same by random splats

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    vec2 period;
    vec2 dx;
    vec2 dy;
    vec2 slope; // of the base, with height and ridge, unless it is gabor_terrain_at
    float height;
    float ridge;
    int own_base;
    uint seed;
    GaborErosion erosion;
};

struct Answer {
    vec4 hills;  // height, slope, ridge
    vec4 eroded; // gabor_eroded_at
    vec4 plain;  // the functions of a position, in cell 0
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
};

vec4 numbers(GaborTerrain terrain) {
    return vec4(terrain.height, terrain.slope, terrain.ridge);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    GaborGround ground = GaborGround(s.cell, s.local, s.period);
    GaborTerrain hills = gabor_terrain_at(ground, s.dx, s.dy, s.seed);
    GaborTerrain base = hills;
    if (s.own_base != 0)
        base = GaborTerrain(s.height, s.slope, s.ridge);
    if (wanted == 2)
        answers[i].eroded = numbers(gabor_splat_eroded(s.local, base, s.erosion, s.seed));
    else
        answers[i].eroded = numbers(gabor_eroded_at(ground, s.dx, s.dy, base, s.erosion, s.seed));
    answers[i].hills = numbers(hills);
    if (wanted != 0)
        return;
    vec2 p = vec2(s.cell) + s.local;
    if (s.period.x > 0.0 && s.period.y > 0.0)
        answers[i].plain = numbers(gabor_eroded_tiled(p, s.period, gabor_terrain_tiled(p, s.period, s.seed), s.erosion, s.seed));
    else if (s.dx != vec2(0.0) || s.dy != vec2(0.0))
        answers[i].plain = numbers(gabor_eroded_filtered(p, s.dx, s.dy, gabor_terrain_filtered(p, s.dx, s.dy, s.seed), s.erosion, s.seed));
    else
        answers[i].plain = numbers(gabor_eroded(p, gabor_terrain(p, s.seed), s.erosion, s.seed));
}
