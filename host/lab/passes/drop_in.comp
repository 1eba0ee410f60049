#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates a recipe's noise at the positions of places.glsl with the drop-in's own function.

#include "recipe.glsl"
#include "places.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    uint seed;
    vec2 p = place_of(i, seed);
    values[i] = amplitude * gabor_noise(p / GABOR_CELLS_PER_RADIUS, length(wave), atan(wave.y, wave.x), seed);
}
