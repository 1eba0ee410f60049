#version 450
#extension GL_GOOGLE_include_directive : require

// Draws eroded hills from above or in perspective: colour, height, slope, light, ridge, and the height that erosion added.

#include "passes/terrain_interface.h"
#include "gabor_noise.glsl"
#include "gabor_erosion.glsl"
#include "landscape.glsl"

layout(constant_id = view_id) const uint view = view_terrain;
const int channels = 11;

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
    Ground ground = Ground(cell, period, seed, table, reach, sun);
    RayHit hit;
    if (view == view_terrain) {
        hit = seen_from_above(ground, corner + pixel * place, pixel);
    } else {
        vec3 eye = vec3(corner.x, 0.0, corner.y) + distance * camera_at(yaw, pitch);
        hit = seen_along(ground, eye, camera_ray(yaw, pitch, pixel * (place - center)), pixel, distance);
    }
    picture[at++] = hit.colour.r;
    picture[at++] = hit.colour.g;
    picture[at++] = hit.colour.b;
    picture[at++] = unit * hit.ground.height;
    picture[at++] = hit.ground.slope.x;
    picture[at++] = hit.ground.slope.y;
    picture[at++] = hit.light.r;
    picture[at++] = hit.light.g;
    picture[at++] = hit.light.b;
    picture[at++] = hit.ground.ridge;
    picture[at] = unit * hit.added;
}
