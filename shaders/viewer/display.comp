#version 450
#extension GL_GOOGLE_include_directive : require

// Colours the pixels of a picture for a file, one band of rows at a time.

#include "viewer/display.glsl"

layout(local_size_x = display_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Values { float values[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Picture { float picture[]; };

float value_at(vec2 pixel, int channel) {
    ivec2 at = max(ivec2(floor(pixel)) - ivec2(0, first_row - 1), ivec2(0)); // the buffer starts with the last row of the previous band
    return values[(at.y * grid.x + at.x) * channels + channel];
}

void main() {
    int at = int(gl_GlobalInvocationID.x);
    if (at >= count)
        return;
    vec3 colour = shown(vec2(at % grid.x, first_row + at / grid.x) + 0.5);
    for (int i = 0; i < 3; ++i)
        picture[3 * at + i] = colour[i];
}
