#version 450
#extension GL_GOOGLE_include_directive : require

// Draws the material of the function GABOR_MATERIAL, whose parameters have the type GABOR_PARAMETERS: its colour, height,
// roughness and metalness, its lit colour, and its slopes or, for a body, the coverage.

#include "passes/material_interface.h"
#include "gabor_noise.glsl"
#include "gabor_spectrum.glsl"
#include "gabor_materials.glsl"

layout(constant_id = filter_id) const bool filtered = false;
layout(constant_id = tiled_id) const bool tiled = false;
layout(constant_id = view_id) const uint view = view_flat;
layout(constant_id = environment_id) const int environment = 0;
const bool body = view == view_sphere || view == view_torus;
const int channels = body ? 10 : 11;
const int rays = 4;

#include "body.glsl"
#include "light.glsl"

layout(local_size_x = material_group, local_size_y = material_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };
layout(std430, set = 0, binding = 1) readonly buffer Parameters { GABOR_PARAMETERS parameters; };

GABOR_PARAMETERS look;

GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy) {
    GaborPixel there = gabor_pixel(p);
    if (filtered)
        there = gabor_pixel_filtered(p, dx, dy);
    if (tiled)
        there = gabor_pixel_tiled(there, pixel * size);
    return GABOR_MATERIAL(there, look, seed);
}

#include "relief.glsl"

void main() {
    look = parameters; // loaded before any branch, because lavapipe would otherwise load it for each invocation
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 place = vec2(here + ivec2(first_column, first_row)) + 0.5;

    vec3 p = vec3(corner + pixel * place, 0.0);
    vec3 dx = vec3(pixel, 0.0, 0.0);
    vec3 dy = vec3(0.0, pixel, 0.0);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    vec2 seen_from = (place - center) / (2.0 * max(center.x, center.y));
    vec3 eye = eye_above(seen_from);
    float coverage = 1.0;
    Axes axes;
    if (view == view_horizon) {
        // The camera looks horizontally: depth = camera height * focal length / rows below the horizon.
        seen_from = vec2(0.0);
        vec2 below = place - vec2(center.x, sky);
        if (below.y <= 0.0) { // the sky
            for (int i = 0; i < channels; ++i)
                picture[at + i] = i < 6 || i > 8 ? 0.0 : sky_colour(-below.y / sky)[i - 6];
            return;
        }
        float near = pixel / below.y;
        p = vec3(corner + near * vec2(below.x, -size.x), 0.0);
        dx = vec3(near, 0.0, 0.0);
        dy = vec3(near / below.y * vec2(-below.x, size.x), 0.0);
        eye = normalize(vec3(-below.x, size.x, below.y));
    }
    if (body) {
        seen_from = vec2(0.0);
        axes = camera_axes();
        Seen seen = seen_at(place - 0.5, axes);
        coverage = seen.coverage;
        if (!seen.found) {
            for (int i = 0; i < channels; ++i)
                picture[at + i] = i < 6 || i == 9 ? 0.0 : backdrop[i - 6];
            return;
        }
        p = unit * seen.p;
        dx = unit * seen.dx;
        dy = unit * seen.dy;
        normal = seen.normal;
        eye = normalize(in_picture(eye_distance * axes.toward_eye - seen.p, axes));
    }

    Relief relief = relief_at(p, dx, dy, normal, body);
    GaborMaterial m = relief.material;
    vec3 slope = relief.slope;
    vec3 bumped = bumped_normal(normal, slope);
    if (body)
        bumped = in_picture(bumped, axes);
    vec3 light = lit(Surface(m.colour, m.roughness, m.metalness), bumped, eye, lamp_above(seen_from, lamp),
                     body ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    if (body)
        light = mix(backdrop, light, coverage);

    picture[at++] = m.colour.r;
    picture[at++] = m.colour.g;
    picture[at++] = m.colour.b;
    picture[at++] = m.height;
    picture[at++] = m.roughness;
    picture[at++] = m.metalness;
    picture[at++] = light.r;
    picture[at++] = light.g;
    picture[at++] = light.b;
    picture[at++] = body ? coverage : slope.x;
    if (!body)
        picture[at] = slope.y;
}
