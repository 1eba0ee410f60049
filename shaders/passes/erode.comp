#version 450
#extension GL_GOOGLE_include_directive : require

// Erodes a heightmap. Slopes come from the map smoothed over 5 x 5 pixels, which hides the steps of 16-bit maps. The weights
// are binomial, (1, 4, 6, 4, 1) / 16, across the direction of a slope, and (-1, -2, 0, 2, 1) / 8 along it.

#include "passes/channels.h"
#include "passes/erode_interface.h"
#include "gabor_noise.glsl"
#include "gabor_erosion.glsl"

layout(local_size_x = erode_group, local_size_y = erode_group) in;

const int channels = erosion_added + 1;

layout(std430, set = 0, binding = 0) writeonly buffer Eroded { float eroded[]; };
layout(std430, set = 0, binding = 1) readonly buffer Erosion { GaborErosion erosion; };
layout(std430, set = 0, binding = 2) readonly buffer Map { float map[]; };

// The map's height at a pixel; rows count from the first row of the band.
float height_at(int column, int row) {
    column = tileable != 0 ? (column + map_width) % map_width : clamp(column, 0, map_width - 1);
    return map[(row + erode_halo) * map_width + column];
}

vec2 slope_at(int column, int row) {
    vec2 slope = vec2(0.0);
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            float height = height_at(column + i, row + j);
            float across_x = i == 0 ? 6.0 : abs(i) == 1 ? 4.0 : 1.0;
            float across_y = j == 0 ? 6.0 : abs(j) == 1 ? 4.0 : 1.0;
            float along_x = float(sign(i) * (3 - abs(i)));
            float along_y = float(sign(j) * (3 - abs(j)));
            slope += height * vec2(along_x * across_y, across_x * along_y);
        }
    }
    return slope / (128.0 * pixel);
}

void main() {
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int column = first_column + here.x;
    vec2 p = (vec2(column, first_row + here.y) + 0.5) * pixel;
    GaborTerrainPlace ground = GaborTerrainPlace(ivec2(0), p, period);
    GaborTerrain base = GaborTerrain(height_at(column, here.y), slope_at(column, here.y), 0.0, vec3(0.0), vec2(0.0));
    GaborTerrain terrain = gabor_eroded_at(ground, vec2(pixel, 0.0), vec2(0.0, pixel), base, erosion, seed);
    int at = channels * (before + here.y * width + here.x);
    eroded[at + erosion_height] = terrain.height;
    eroded[at + erosion_slope] = terrain.slope.x;
    eroded[at + erosion_slope + 1] = terrain.slope.y;
    eroded[at + erosion_ridge] = terrain.ridge;
    eroded[at + erosion_added] = terrain.height - base.height;
}
