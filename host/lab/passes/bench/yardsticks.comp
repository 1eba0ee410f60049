#version 450
#extension GL_GOOGLE_include_directive : require

// Calls the noises that gabor_noise is compared with.

#include "bench.glsl"
#include "yardsticks.glsl"

layout(constant_id = option_id) const int function = 0; // numbered as in host/lab/bench/subjects.cpp

float value(vec2 p, uint instance) {
    switch (function) {
    default:
        return perlin_noise(p, frequency, instance);
    case 1:
        return simplex_noise(p, frequency, instance);
    case 2:
        return advice_noise(p, frequency, orientation, instance);
    case 3:
        return gabor_72_noise(p, frequency, orientation, instance);
    case 4:
        return phasor_noise(p, frequency, orientation, instance);
    case 5:
        return splats_16_noise(p, frequency, orientation, instance);
    case 6:
        return seminal_noise(p, frequency, orientation, instance);
    }
}
