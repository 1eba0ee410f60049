#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates the noise of any ingredients at the positions of places.glsl.

#include "ingredients.glsl"
#include "places.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    uint seed;
    vec2 p = place_of(i, seed);
    values[i] = amplitude * gabor_ingredients(p, wave, seed);
}
