#version 450
#extension GL_GOOGLE_include_directive : require

// Draws a sea in perspective: colour, height, slope, light, and foam.

#include "passes/channels.h"
#include "passes/ocean_interface.h"
#include "gabor_noise.glsl"
#include "gabor_ocean.glsl"
#include "gabor_fractal.glsl"
#include "srgb.glsl"
#include "seascape.glsl"

const int channels = ocean_foam + 1;

layout(local_size_x = ocean_group, local_size_y = ocean_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };
layout(std430, set = 0, binding = 1) readonly buffer Ocean { GaborOcean ocean; };

void main() {
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    Sea sea = sea_of(ocean, seed, second, fraction, sun);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 place = vec2(here + ivec2(first_column, first_row)) + 0.5 - center;
    SeaHit hit = seen_at_sea_in_pixel(sea, altitude, yaw, pitch, place, pixel);
    for (int i = 0; i < 3; ++i) {
        picture[at + ocean_colour + i] = hit.colour[i];
        picture[at + ocean_lit + i] = hit.light[i];
    }
    picture[at + ocean_height] = hit.water.height;
    picture[at + ocean_slope] = hit.water.slope.x;
    picture[at + ocean_slope + 1] = hit.water.slope.y;
    picture[at + ocean_jacobian] = hit.water.jacobian;
    picture[at + ocean_foam] = hit.foam;
}
