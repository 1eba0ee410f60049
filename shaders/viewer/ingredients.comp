#version 450
#extension GL_GOOGLE_include_directive : require

// Any of the noises that the paper compares, the seminal one among them, for the viewer.

#include "../passes/ingredients.glsl"
#include "grid.glsl"

void evaluate(ivec2 cell, vec2 local, uint instance, uint at)
{
    // Cells are told by floats here: 1024 of them each way keep the offsets precise, and then it repeats.
    vec2 p = vec2(cell & 1023) + local;
    vec2 wave = frequency * vec2(cos(orientation), sin(orientation));
    values[at] = amplitude * gabor_ingredients(p, wave, instance);
}

void evaluate_view(vec2 pixel, uint at)
{
    vec2 p;
    vec2 dx;
    vec2 dy;
    if (perspective(pixel, p, dx, dy))
        evaluate(ivec2(cell_x, cell_y), vec2(local_x, local_y) + p, seed, at);
    else
        values[at] = 0.0;
}
