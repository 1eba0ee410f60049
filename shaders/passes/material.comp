#version 450
#extension GL_GOOGLE_include_directive : require

// A picture of the material GABOR_MATERIAL: its colour, height, roughness and metalness, and how it looks under a lamp.

#include "passes/material_interface.h"
#include "gabor_lattice.glsl"
#include "gabor_spectrum.glsl"
#include "gabor_materials.glsl"
#include "light.glsl"

layout(constant_id = 0) const bool filtered = false;
layout(constant_id = 1) const bool horizon = false; // a plane in perspective
const int channels = 9;

layout(local_size_x = material_group, local_size_y = material_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };

GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy)
{
    if (filtered)
        return GABOR_MATERIAL_FILTERED(p, dx, dy, seed);
    return GABOR_MATERIAL(p, seed);
}

void main()
{
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 place = vec2(here + ivec2(first_column, first_row)) + 0.5;

    vec2 p = pixel * place;
    vec2 dx = vec2(pixel, 0.0);
    vec2 dy = vec2(0.0, pixel);
    vec3 eye = eye_above(place, size);
    if (horizon) {
        // The camera looks along the plane from its height: depth = height * focal length / rows below the horizon.
        vec2 below = place - vec2(0.5 * size.x, sky);
        if (below.y <= 0.0) { // the sky
            for (int i = 0; i < channels; ++i)
                picture[at + i] = i < 6 ? 0.0 : sky_colour(-below.y / sky)[i - 6];
            return;
        }
        float near = pixel / below.y;
        p = near * vec2(below.x, -size.x);
        dx = vec2(near, 0.0);
        dy = near / below.y * vec2(-below.x, size.x);
        eye = normalize(vec3(-below.x, size.x, below.y));
    }

    // Slopes over a pixel's smaller side; in a loop, which compilers do not unroll.
    float side = min(length(dx), length(dy));
    GaborMaterial m = material_at(p, dx, dy);
    vec2 slope = vec2(0.0);
    for (int i = 0; i < 2; ++i) {
        vec2 along = i == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
        slope += (material_at(p + side * along, dx, dy).height - m.height) / side * along;
    }
    vec3 light = lit(m, slope, eye, lamp_above(horizon ? vec2(0.0) : (place - 0.5 * size) / max(size.x, size.y)));

    picture[at++] = m.colour.r;
    picture[at++] = m.colour.g;
    picture[at++] = m.colour.b;
    picture[at++] = m.height;
    picture[at++] = m.roughness;
    picture[at++] = m.metalness;
    picture[at++] = light.r;
    picture[at++] = light.g;
    picture[at] = light.b;
}
