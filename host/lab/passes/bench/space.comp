#version 450
#extension GL_GOOGLE_include_directive : require

// Calls the functions of the 3D drop-in, as users do.

#include "gabor_noise.glsl"
#include "gabor_filter.glsl"
#include "gabor_noise_3d.glsl"
#include "gabor_filter_3d.glsl"
#include "bench.glsl"

layout(constant_id = option_id) const int function = 0; // numbered as in host/lab/bench/subjects.cpp

float value(vec2 p, uint instance) {
    vec3 at = vec3(p, 0.5);
    GaborPlace3d place = gabor_place_3d_at(at);
    vec3 direction = vec3(cos(orientation), sin(orientation), 0.0);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    switch (function) {
    case 2:
        return gabor_noise_3d_isotropic(at, frequency, instance);
    case 3:
        GaborField3d field = gabor_field_3d(place, frequency * direction, instance);
        return field.noise + dot(field.gradient, vec3(1.0));
    case 4:
        return gabor_noise_surface(at, normal, frequency, direction, instance);
    case 5:
        return gabor_field_surface_isotropic(place, normal, frequency, instance).noise;
    case 6:
        return gabor_field_3d_filtered(place, vec3(pixel, 0.0, 0.0), vec3(0.0, pixel, 0.0), frequency * direction, instance)
            .noise;
    default:
        return gabor_noise_3d(at, frequency, direction, instance);
    }
}
