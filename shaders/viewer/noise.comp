#version 450
#extension GL_GOOGLE_include_directive : require

// The drop-in's noise for the viewer: the noise itself, its quadrature, and its gradient.

#include "../passes/recipe.glsl"
#include "grid.glsl"

void write(GaborField field, uint at)
{
    values[at] = field.value.y;
    if (channels > 1)
        values[at + 1u] = field.value.x;
    if (channels > 2) {
        values[at + 2u] = field.slope_x.y;
        values[at + 3u] = field.slope_y.y;
    }
}

void evaluate(ivec2 cell, vec2 local, uint instance, uint at)
{
    GaborPlace place = gabor_place(cell, local);
    place.time = time;
    write(gabor_field(place, gabor_kernel(frequency, orientation), instance), at);
}

void evaluate_view(vec2 pixel, uint at)
{
    vec2 p;
    vec2 dx;
    vec2 dy;
    if (perspective(pixel, p, dx, dy))
        evaluate(ivec2(cell_x, cell_y), vec2(local_x, local_y) + p * GABOR_RADIUS, seed, at);
    else
        for (uint i = 0u; i < uint(channels); ++i)
            values[at + i] = 0.0;
}
