#version 450
#extension GL_GOOGLE_include_directive : require

// Any of the noises that the paper compares, the seminal one among them, for the viewer.

#include "viewer/ingredients_interface.h"
#include "../passes/ingredients.glsl"

layout(constant_id = 12) const bool horizon = false; // a plane in perspective

layout(local_size_x = ingredients_group, local_size_y = ingredients_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Columns { Line columns[]; };
layout(std430, set = 0, binding = 1) readonly buffer Rows { Line rows[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Picture { float picture[]; };

void main()
{
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = before + here.y * width + here.x;
    Line column = columns[here.x];
    Line row = rows[here.y + first_row];
    vec2 local = vec2(column.local, row.local);
    if (horizon) {
        if (row.local <= 0.0) { // the sky
            picture[at] = 0.0;
            return;
        }
        local = pixel / row.local * vec2(column.local, -focal_length) + camera;
    }
    picture[at] = amplitude * gabor_ingredients(ivec2(column.cell, row.cell), local, wave, seed);
}
