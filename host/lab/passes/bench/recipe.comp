#version 450
#extension GL_GOOGLE_include_directive : require

// Calls the functions of any recipe's drop-in, as users do.

#include "recipe.glsl"
#if GABOR_TAPS == 3
#include "gabor_spectrum.glsl"
#include "gabor_filter.glsl"
#endif
#include "bench.glsl"

layout(constant_id = option_id) const int function = 0; // numbered as in host/lab/bench/subjects.cpp

float value(vec2 p, uint instance) {
    switch (function) {
    case 1:
        vec3 bump = gabor_noise_gradient(p, frequency, orientation, instance);
        return bump.x + bump.y + bump.z;
    case 2:
        vec2 phasor = gabor_turns_intensity(gabor_noise_quadrature(p, frequency, orientation, instance));
        return phasor.x + phasor.y;
    case 3:
        return gabor_noise_tiled(p, vec2(16.0, 8.0), frequency, orientation, instance);
    case 4:
        return gabor_noise_animated(p, 0.3, frequency, orientation, instance);
#if GABOR_TAPS == 3
    case 5:
        return gabor_noise_spread(p, frequency, orientation, 0.0, 1.5707963, instance);
    case 6:
        GaborLobes lobes;
        for (int i = 0; i < 3; ++i)
            lobes.lobe[i] = gabor_lobe(frequency + float(i), orientation + float(i), 1.0, 1.0);
        lobes.count = 3;
        return gabor_field_lobes(gabor_place_at(p), lobes, instance).noise;
    case 7:
        vec2 filtered = gabor_noise_filtered(p, vec2(0.02, 0.0), vec2(0.0, 0.1), frequency, orientation, instance);
        return filtered.x + filtered.y;
    case 8:
        return gabor_noise_isotropic(p, frequency, instance);
#endif
    default:
        return gabor_noise(p, frequency, orientation, instance);
    }
}
