#version 450
#extension GL_GOOGLE_include_directive : require

// The drop-in's noise for the viewer: the noise itself, its quadrature, and its gradient.

#include "../passes/recipe.glsl"
#include "grid.glsl"

void evaluate(ivec2 cell, vec2 local, uint instance, uint at)
{
    GaborPlace place = gabor_place(cell, local);
    place.time = time;
    GaborField field = gabor_field(place, gabor_kernel(frequency, orientation), instance);
    values[at] = field.value.y;
    if (channels > 1)
        values[at + 1u] = field.value.x;
    if (channels > 2) {
        values[at + 2u] = field.slope_x.y;
        values[at + 3u] = field.slope_y.y;
    }
}
