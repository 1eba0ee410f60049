#version 450
#extension GL_GOOGLE_include_directive : require

// Erodes a heightmap. Gullies follow the map smoothed to their scale, a cubic B-spline; what erosion adds to the smoothed map is
// added to the map.

#include "passes/channels.h"
#include "passes/erode_interface.h"
#include "gabor_noise.glsl"
#include "gabor_erosion.glsl"

layout(constant_id = channels_id) const int channels = erosion_cover;

layout(local_size_x = erode_group, local_size_y = erode_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Eroded { float eroded[]; };
layout(std430, set = 0, binding = 1) readonly buffer Erosion { GaborErosion erosion; };
layout(std430, set = 0, binding = 2) readonly buffer Smooth { float smoothed[]; };
layout(std430, set = 0, binding = 3) readonly buffer Map { float map[]; };

// The smoothed map at a pixel, in units of p.
GaborTerrain smooth_at(vec2 place) {
    vec2 at = place * nodes + phase;
    ivec2 first = ivec2(at);
    vec2 t = at - vec2(first);
    vec4 x, y, slope_x, slope_y, curvature_x, curvature_y;
    gabor_impl_splines(t.x, x, slope_x, curvature_x);
    gabor_impl_splines(t.y, y, slope_y, curvature_y);
    float height = 0.0;
    vec2 slope = vec2(0.0);
    vec3 curvature = vec3(0.0);
    for (int j = 0; j < 4; ++j) {
        int row = (first.y + j) * table_width + first.x;
        vec4 four = vec4(smoothed[row], smoothed[row + 1], smoothed[row + 2], smoothed[row + 3]);
        vec3 along = vec3(dot(x, four), dot(slope_x, four), dot(curvature_x, four));
        height += y[j] * along.x;
        slope += vec2(y[j] * along.y, slope_y[j] * along.x);
        curvature += vec3(y[j] * along.z, slope_y[j] * along.y, curvature_y[j] * along.x);
    }
    vec2 to_p = nodes / pixel;
    float scale = steepness / unit;
    return GaborTerrain(scale * height, scale * to_p * slope, 0.0,
                        scale * curvature * vec3(to_p.x * to_p.x, to_p.x * to_p.y, to_p.y * to_p.y), vec2(0.0));
}

// The map's height at a pixel, or `here` where it has none; rows count from the first row of the band.
float height_at(int column, int row, float here) {
    column = tileable != 0 ? (column + map_width) % map_width : clamp(column, 0, map_width - 1);
    float height = map[(row + erode_halo) * map_width + column];
    return height < missing_height ? height : here;
}

// Sobel's weights, 1, 2, 1 across the direction of a slope.
vec2 slope_at(int column, int row, float here) {
    vec2 slope = vec2(0.0);
    for (int i = -1; i <= 1; ++i) {
        float weight = i == 0 ? 0.25 : 0.125;
        slope.x += weight * (height_at(column + 1, row + i, here) - height_at(column - 1, row + i, here));
        slope.y += weight * (height_at(column + i, row + 1, here) - height_at(column + i, row - 1, here));
    }
    return slope / (pixel * unit);
}

void main() {
    GaborErosion table = erosion; // loaded before any branch, because lavapipe would otherwise load it for each invocation
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int column = first_column + here.x;
    float before_erosion = map[(here.y + erode_halo) * map_width + column];
    vec2 place = vec2(column, first_row + here.y) + 0.5;
    GaborTerrain base = smooth_at(place);
    GaborTerrain terrain = gabor_eroded_at(GaborTerrainPlace(cell, pixel * place + local, period), vec2(pixel.x, 0.0),
                                           vec2(0.0, pixel.y), base, table, seed);
    float added = (terrain.height - base.height) * unit / steepness;
    vec2 slope = slope_at(column, here.y, before_erosion) + (terrain.slope - base.slope) / steepness;
    bool has_height = before_erosion < missing_height;
    if (!has_height) { // neither eroded nor sloped
        before_erosion = missing;
        added = terrain.ridge = 0.0;
        slope = vec2(0.0);
    }
    int at = channels * (before + here.y * width + here.x);
    eroded[at + erosion_height] = before_erosion + added;
    eroded[at + erosion_slope] = slope.x;
    eroded[at + erosion_slope + 1] = slope.y;
    eroded[at + erosion_ridge] = terrain.ridge;
    eroded[at + erosion_added] = added;
    if (channels == erosion_cover) return;
    terrain.height = (before_erosion + added - middle) / relief;
    terrain.slope = slope;
    vec4 cover = gabor_ground_cover(terrain);
    for (int i = 0; i < 4; ++i)
        eroded[at + erosion_cover + i] = has_height ? cover[i] : 0.0;
}
