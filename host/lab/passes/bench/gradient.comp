#version 450
#extension GL_GOOGLE_include_directive : require

// Perlin's gradient noise, for scale.

#include "bench.glsl"
#include "yardsticks.glsl"

float value(vec2 p, uint instance) {
    return perlin_noise(p, frequency, instance);
}
