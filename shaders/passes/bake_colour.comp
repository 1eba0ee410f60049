#version 450
#extension GL_GOOGLE_include_directive : require

// The last step of a bake in colour: turns the components summed by passes/bake.comp into each pixel's colour.

#include "passes/bake_interface.h"
const int colour_binding = 4;
#include "colour.glsl"
#include "noise_channels.glsl"

layout(local_size_x = bake_group) in;

layout(std430, set = 0, binding = 0) buffer Picture { float picture[]; };

void main() {
    // Without an early return, lavapipe loads the colour once instead of once for each invocation.
    bool inside = gl_GlobalInvocationID.x < uint(width);
    int column = min(int(gl_GlobalInvocationID.x), width - 1);
    int at = (before + int(gl_GlobalInvocationID.y) * width + column) * channels;
    vec3 value = colour_of(vec3(picture[at], picture[at + 1], picture[at + 2]), vec3(0.0));
    if (inside) {
        for (int i = 0; i < 3; ++i)
            picture[at + i] = value[i];
    }
}
