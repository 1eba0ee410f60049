#version 450
#extension GL_GOOGLE_include_directive : require

// The drop-in with any recipe, as one would call it.

#include "../recipe.glsl"
#include "bench.glsl"

float value(vec2 p, uint instance)
{
    return gabor_noise(p, frequency, orientation, instance);
}
