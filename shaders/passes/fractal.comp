#version 450
#extension GL_GOOGLE_include_directive : require

// Draws fractal noise in the plane, from above or in perspective.

#include "passes/fractal_interface.h"
#include "gabor_noise.glsl"
#include "gabor_fractal.glsl"
#include "noise_channels.glsl"
#include "plane.glsl"
#include "swirls.glsl"

layout(constant_id = filter_id) const bool filtered = false;
layout(constant_id = view_id) const uint view = view_flat;
const bool horizon = view == view_horizon;
layout(constant_id = tiled_id) const bool tiled = false;
layout(constant_id = animated_id) const bool animated = false;
layout(constant_id = basis_id) const int basis = GABOR_SMOOTH;
layout(constant_id = shape_id) const int shape = GABOR_FBM;
layout(constant_id = warped_id) const bool warped = false;

layout(local_size_x = fractal_group, local_size_y = fractal_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };
layout(std430, set = 0, binding = 1) readonly buffer Columns { Line columns[]; };
layout(std430, set = 0, binding = 2) readonly buffer Rows { Line rows[]; };

void main() {
    ivec2 pixel_at = ivec2(gl_GlobalInvocationID.xy);
    if (pixel_at.x >= width || pixel_at.y >= height)
        return;
    int at = (before + pixel_at.y * width + pixel_at.x) * channels;
    pixel_at.y += first_row;
    Line column = columns[pixel_at.x], row = rows[pixel_at.y];
    vec2 local = vec2(column.local, row.local);
    GaborFractalNoise noise = GaborFractalNoise(0.0, vec2(0.0), 1.0, vec3(0.0)); // the sky's
    if (!horizon || local.y > 0.0) {
        Footprint here = footprint_from_above(vec2(0.0), pixel);
        if (horizon) {
            here = footprint_below_horizon(local, pixel, focal_length);
            local = here.position * nodes + camera;
        }
        GaborPlace place = GaborPlace(ivec2(column.cell, row.cell), local, nodes, tiled ? period : ivec2(0), animated ? time : 0.0);
        GaborFractal fractal = GaborFractal(octaves, gain, lacunarity, turn, basis, shape);
        noise = warped_noise(place, filtered, here.dx, here.dy, warped ? warp : 0.0, fractal, seed);
    }
    picture[at] = noise.noise;
    if (gradient_at >= 0) {
        picture[at + gradient_at] = noise.gradient.x;
        picture[at + gradient_at + 1] = noise.gradient.y;
    }
    if (removed_at >= 0)
        picture[at + removed_at] = noise.removed;
}
