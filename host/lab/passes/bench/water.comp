#version 450
#extension GL_GOOGLE_include_directive : require

// Calls the functions of the sea, as users do.

#include "gabor_noise.glsl"
#include "gabor_ocean.glsl"
#include "bench.glsl"

layout(constant_id = option_id) const int function = 0; // numbered as in host/lab/bench/subjects.cpp

layout(std140, set = 0, binding = 1) uniform Table { GaborOcean ocean; };

float value(vec2 p, uint instance) {
    vec2 at = 8.0 * p, dx = vec2(8.0 * pixel, 0.0), dy = dx.yx; // metres
    GaborWater water;
    float foam = 0.0;
    switch (function) {
    case 1:
        water = gabor_water_filtered(at, dx, dy, 60.5, ocean, instance);
        break;
    case 2:
        return gabor_water(at, 60.5, ocean, instance).height;
    case 3:
        water = gabor_water_filtered(at, dx, dy, 60.5, ocean, instance);
        foam = gabor_foam(at, dx, dy, water, ocean, instance);
        break;
    default:
        water = gabor_water(at, 60.5, ocean, instance);
    }
    return water.height + dot(water.slope + water.shift, vec2(1.0)) + water.jacobian + dot(water.lost, vec3(1.0)) + foam;
}
