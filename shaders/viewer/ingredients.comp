#version 450
#extension GL_GOOGLE_include_directive : require

// Sums of any of the noises that the paper compares, the seminal one among them, for the viewer. It reads what
// passes/pixels.comp does, with one node to the kernel radius and amplitudes that make the variance 1.

#include "passes/pixels_interface.h"
#include "../passes/ingredients.glsl"

layout(constant_id = 12) const bool horizon = false; // a plane in perspective

layout(local_size_x = pixels_group, local_size_y = pixels_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Columns { Line columns[]; };
layout(std430, set = 0, binding = 1) readonly buffer Rows { Line rows[]; };
layout(std430, set = 0, binding = 2) readonly buffer Waves { PixelsWave wave_table[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Picture { float picture[]; };

float value_at(PixelsWave wave, ivec2 here) {
    Line column = columns[here.x * tables + wave.table];
    Line row = rows[here.y * tables + wave.table];
    vec2 local = vec2(column.local, row.local);
    if (horizon) {
        if (row.local <= 0.0) // the sky
            return 0.0;
        local = pixel / row.local * vec2(column.local, -focal_length) / wave.radius + wave.camera;
    }
    vec2 vector = wave.frequency * vec2(cos(wave.orientation), sin(wave.orientation));
    return wave.amplitude * gabor_ingredients(ivec2(column.cell, row.cell), local, vector, wave.seed);
}

void main() {
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    float sum = 0.0;
    for (int i = 0; i < waves; ++i)
        sum += value_at(wave_table[i], here + ivec2(0, first_row));
    picture[before + here.y * width + here.x] = sum;
}
