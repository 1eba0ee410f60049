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
        return dot(perlin_noise_gradient(p, frequency, instance), vec3(1.0));
    case 2:
        return dot(perlin_fbm(p, frequency, 0.5, instance), vec3(1.0));
    case 3:
        return simplex_noise(p, frequency, instance);
    case 4:
        return advice_noise(p, frequency, orientation, instance);
    case 5:
        return gabor_72_noise(p, frequency, orientation, instance);
    case 6:
        return phasor_noise(p, frequency, orientation, instance);
    case 7:
        return splats_16_noise(p, frequency, orientation, instance);
    case 8:
        return seminal_183_noise(p, frequency, orientation, instance);
    case 9:
        return seminal_noise(p, frequency, orientation, instance);
    }
}
