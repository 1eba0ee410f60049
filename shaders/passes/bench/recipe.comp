#version 450
#extension GL_GOOGLE_include_directive : require

// The drop-in with any recipe, as one would call it.

#include "../recipe.glsl"
#include "bench.glsl"

layout(constant_id = 10) const int entry = 0;

float value(vec2 p, uint instance)
{
    switch (entry) {
    case 1:
        vec3 bump = gabor_noise_gradient(p, frequency, orientation, instance);
        return bump.x + bump.y + bump.z;
    case 2:
        vec2 phasor = gabor_phasor(gabor_noise_complex(p, frequency, orientation, instance));
        return phasor.x + phasor.y;
    case 3:
        vec4 four = gabor_noise_four(p, frequency, orientation, instance);
        return four.x + four.y + four.z + four.w;
    case 4:
        return gabor_noise_tiled(p, vec2(16.0, 8.0), frequency, orientation, instance);
    case 5:
        return gabor_noise_animated(p, 0.3, frequency, orientation, instance);
    default:
        return gabor_noise(p, frequency, orientation, instance);
    }
}
