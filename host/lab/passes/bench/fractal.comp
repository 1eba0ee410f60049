#version 450
#extension GL_GOOGLE_include_directive : require

// Calls the functions of the fractal drop-in, as users do.

#include "gabor_noise.glsl"
#include "gabor_fractal.glsl"
#include "bench.glsl"

layout(constant_id = option_id) const int function = 0; // numbered as in host/lab/bench/subjects.cpp
layout(constant_id = option_id + 1) const int octaves = 5;

float value(vec2 p, uint instance) {
    if (octaves == 0)
        return p.x;
    GaborPlace place = gabor_place_at(p);
    GaborFractal fractal = gabor_fractal(float(octaves), 0.5);
    if (function == 2)
        fractal.basis = GABOR_PERLIN;
    switch (function) {
    default:
        return gabor_smooth(p, instance);
    case 1:
        return gabor_perlin(p, instance);
    case 3:
        return gabor_fbm(p, float(octaves), 0.5, instance);
    case 2:
    case 4: {
        GaborFractalNoise plain = gabor_fractal_noise(place, fractal, instance);
        return plain.noise + plain.gradient.x + plain.gradient.y;
    }
    case 5: {
        GaborFractalNoise filtered =
            gabor_fractal_noise_filtered(place, vec2(0.02, 0.0), vec2(0.0, 0.1), fractal, instance);
        return filtered.noise + filtered.gradient.x + filtered.gradient.y;
    }
    case 6:
        return gabor_fbm_3d(vec3(p, 0.5), float(octaves), 0.5, instance);
    }
}
