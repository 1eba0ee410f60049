#version 450
#extension GL_GOOGLE_include_directive : require

// Erodes hills with the drop-in or with the filter that uses random splats.

#include "gabor_noise.glsl"
#include "gabor_erosion.glsl"
#include "splat_erosion.glsl"
#include "bench.glsl"

layout(constant_id = option_id) const bool splats = false;
layout(constant_id = option_id + 1) const int octaves = 5;

float value(vec2 p, uint instance) {
    GaborErosion erosion = gabor_erosion();
    erosion.octaves = octaves;
    GaborTerrain base = gabor_terrain(p, instance);
    GaborTerrain terrain = splats ? gabor_splat_eroded(p, base, erosion, instance)
                                  : gabor_eroded(p, base, erosion, instance);
    return terrain.height + terrain.slope.x + terrain.slope.y + terrain.ridge;
}
