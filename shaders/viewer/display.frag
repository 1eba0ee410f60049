#version 450
#extension GL_GOOGLE_include_directive : require

// Shows the values of a grid, coarse or fine, in the window.

#include "viewer/display.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Values { float values[]; };

layout(location = 0) out vec4 colour;

float value_of(ivec2 at, int channel) {
    at = clamp(at, ivec2(0), grid - 1);
    return values[(at.y * grid.x + at.x) * channels + channel];
}

// Interpolates linearly on a coarse grid; otherwise the grid has one value per pixel.
float value_at(vec2 pixel, int channel) {
    if (tiles)
        pixel = mod(pixel, size);
    if (!coarse)
        return value_of(ivec2(pixel), channel);
    vec2 at = pixel / stride - 0.5;
    ivec2 corner = ivec2(floor(at));
    vec2 f = at - vec2(corner);
    return mix(mix(value_of(corner, channel), value_of(corner + ivec2(1, 0), channel), f.x),
               mix(value_of(corner + ivec2(0, 1), channel), value_of(corner + 1, channel), f.x), f.y);
}

void main() {
    colour = vec4(shown(gl_FragCoord.xy - origin), 1.0);
}
