#version 450
#extension GL_GOOGLE_include_directive : require

// Simplex noise, for scale.

#include "bench.glsl"
#include "yardsticks.glsl"

float value(vec2 p, uint instance) {
    return simplex_noise(p, frequency, instance);
}
