#version 450
#extension GL_GOOGLE_include_directive : require

// Simplex noise for scale, written plainly: Perlin, "Noise hardware", 2001, in two dimensions: on triangles, of which
// each has three corners. As many of them to a kernel radius as gradient.comp has cells.

#include "bench.glsl"
#include "corner.glsl"

// What the gradient of a corner adds around it.
float corner_value(ivec2 corner, vec2 offset, uint instance) {
    float near = max(0.5 - dot(offset, offset), 0.0);
    near *= near;
    return near * near * slope(corner, offset, instance);
}

float value(vec2 p, uint instance) {
    p *= 2.0 * frequency;
    const float skew = 0.36602540; // (sqrt(3) - 1) / 2
    const float back = 0.21132487; // (3 - sqrt(3)) / 6
    vec2 corner = floor(p + skew * (p.x + p.y));
    ivec2 cell = ivec2(corner);
    vec2 f = p - corner + back * (corner.x + corner.y);
    vec2 middle = f.x > f.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    return 70.0 * (corner_value(cell, f, instance)
                   + corner_value(cell + ivec2(middle), f - middle + back, instance)
                   + corner_value(cell + ivec2(1, 1), f - 1.0 + 2.0 * back, instance));
}
