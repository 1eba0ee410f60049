#version 450
#extension GL_GOOGLE_include_directive : require

// Shows the pixels of a picture in a file.

#include "viewer/show.glsl"

layout(local_size_x = show_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Values { float values[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Picture { float picture[]; };

float value_at(vec2 pixel, int channel)
{
    return values[int(pixel.x) * channels + channel];
}

void main()
{
    int at = int(gl_GlobalInvocationID.x);
    if (at >= grid.x)
        return;
    vec3 colour = shown(vec2(at, 0.0));
    for (int i = 0; i < 3; ++i)
        picture[3 * at + i] = colour[i];
}
