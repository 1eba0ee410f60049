#version 450
#extension GL_GOOGLE_include_directive : require

// Any of the noises that the paper compares, the seminal one among them, for the viewer.

#include "../passes/ingredients.glsl"
#include "view.glsl"

layout(constant_id = 12) const int horizon = 0; // 1: a plane in perspective

void main()
{
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = before + here.y * width + here.x;
    Line column = columns[here.x];
    Line row = rows[here.y + first_row];
    vec2 local = vec2(column.local, row.local);
    if (horizon == 1) {
        if (row.local <= 0.0) { // the sky
            picture[at] = 0.0;
            return;
        }
        local = pixel / row.local * vec2(column.local, -focal_length) + vec2(camera_x, camera_y);
    }
    vec2 wave = frequency * vec2(cos(orientation), sin(orientation));
    picture[at] = amplitude * gabor_ingredients(ivec2(column.cell, row.cell), local, wave, seed);
}
