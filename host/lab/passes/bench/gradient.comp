#version 450
#extension GL_GOOGLE_include_directive : require

// Gradient noise for scale, written plainly: Perlin, "Improving noise", 2002, in two dimensions, with an integer hash
// in place of the permutation table. Two of its cells to a kernel radius for each unit of frequency.

#include "bench.glsl"
#include "corner.glsl"

float value(vec2 p, uint instance) {
    p *= 2.0 * frequency;
    vec2 corner = floor(p);
    ivec2 cell = ivec2(corner);
    vec2 f = p - corner;
    vec2 fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float a = slope(cell, f, instance);
    float b = slope(cell + ivec2(1, 0), f - vec2(1.0, 0.0), instance);
    float c = slope(cell + ivec2(0, 1), f - vec2(0.0, 1.0), instance);
    float d = slope(cell + ivec2(1, 1), f - vec2(1.0, 1.0), instance);
    return mix(mix(a, b, fade.x), mix(c, d, fade.x), fade.y);
}
