#version 450
#extension GL_GOOGLE_include_directive : require

// Draws eroded hills from above or in perspective: colour, height, slope, light, ridge, and the height that erosion added.

#include "passes/channels.h"
#include "passes/terrain_interface.h"
#include "gabor_noise.glsl"
#include "gabor_erosion.glsl"
#include "gabor_fractal.glsl"
#include "ground.glsl"
#include "ranges.glsl"
#include "srgb.glsl"
#include "landscape.glsl"

layout(constant_id = view_id) const uint view = view_terrain;
layout(constant_id = cover_id) const int cover = 0;
layout(constant_id = lakes_id) const bool lakes = false;
layout(constant_id = unlit_id) const bool unlit = false;
const int channels = terrain_erosion + 1;

layout(local_size_x = terrain_group, local_size_y = terrain_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };
layout(std430, set = 0, binding = 1) readonly buffer Erosion { GaborErosion erosion; };

void main() {
    GaborErosion table = erosion; // loaded before any branch, because lavapipe would otherwise load it for each invocation
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 place = vec2(here + ivec2(first_column, first_row)) + 0.5;
    Ground ground = Ground(cell, period, seed, table, reach, sun, cover, lakes ? water : -2.0);
    RayHit hit; // the constant leaves one of these to compile
    if (view == view_terrain) hit = seen_from_above(ground, corner + pixel * place, pixel);
    else hit = seen_by_camera(ground, corner, distance, yaw, pitch, place - center, pixel);
    vec3 light = exposed(hit.light);
    for (int i = 0; i < 3; ++i) {
        picture[at + terrain_colour + i] = hit.colour[i];
        if (!unlit)
            picture[at + terrain_lit + i] = light[i];
    }
    picture[at + terrain_height] = unit * hit.ground.height;
    picture[at + terrain_slope] = hit.ground.slope.x;
    picture[at + terrain_slope + 1] = hit.ground.slope.y;
    picture[at + terrain_ridge] = hit.ground.ridge;
    picture[at + terrain_erosion] = unit * hit.added;
}
