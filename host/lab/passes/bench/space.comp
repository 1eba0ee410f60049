#version 450
#extension GL_GOOGLE_include_directive : require

// Calls the functions of the 3D drop-in, as users do.

#include "gabor_noise.glsl"
#include "gabor_spectrum.glsl"
#include "gabor_noise_3d.glsl"
#include "bench.glsl"

layout(constant_id = option_id) const int function = 0; // numbered as in host/lab/bench/subjects.cpp

float value(vec2 p, uint instance) {
    vec3 place = vec3(p, 0.5);
    vec3 direction = vec3(cos(orientation), sin(orientation), 0.0);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    switch (function) {
    case 2:
        return gabor_noise_3d_isotropic(place, frequency, instance);
    case 3:
        return dot(gabor_noise_3d_gradient(place, frequency, direction, instance), vec4(1.0));
    case 4:
        return gabor_noise_surface(place, normal, frequency, direction, instance);
    case 5:
        return gabor_noise_surface_isotropic(place, normal, frequency, instance);
    case 6:
        return gabor_noise_3d_filtered(place, vec3(pixel, 0.0, 0.0), vec3(0.0, pixel, 0.0), frequency, direction, instance).x;
    default:
        return gabor_noise_3d(place, frequency, direction, instance);
    }
}
