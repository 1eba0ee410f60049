#version 450
#extension GL_GOOGLE_include_directive : require

// A picture, pixel by pixel. The place of each column and row comes from the host, which computes it in double
// precision: any part of a picture of any size gets the same bits.

#include "recipe.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

struct Place {
    int cell;
    float local;
};

layout(std430, set = 0, binding = 0) readonly buffer Columns { Place columns[]; };
layout(std430, set = 0, binding = 1) readonly buffer Rows { Place rows[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Picture { float picture[]; };

layout(push_constant) uniform Push {
    vec2 wave;
    float amplitude;
    uint seed;
    uint width;
    uint first_row;
    uint row_count;
};

void main()
{
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (pixel.x >= width || pixel.y >= row_count)
        return;
    Place x = columns[pixel.x];
    Place y = rows[first_row + pixel.y];
    picture[pixel.y * width + pixel.x] =
        gabor_noise_at(ivec2(x.cell, y.cell), vec2(x.local, y.local), GaborKernel(wave, amplitude), seed);
}
