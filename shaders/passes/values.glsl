// The sum of noises at a pixel, which passes/pixels.comp and passes/solid.comp write to the picture. Include it after the drop-ins
// and the definition of colour_binding.

#include "noise_channels.glsl"
#include "sum.glsl"
#include "colour.glsl"

layout(constant_id = values_id) const int values = 1; // number of independent noises

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };

struct Values {
    vec4 values; // independent noises
    Noise noise; // the first of them
    Components components;
};

const Values no_values =
    Values(vec4(0.0), Noise(vec2(0.0), vec3(0.0), 0.0), Components(vec3(0.0), vec3(0.0)));

// Adds the wave of one of the independent noises.
void add_wave(inout Values sum, int value, Noise one, float amplitude, vec3 radius, vec2 weights[3]) {
    sum.values[value] += amplitude * one.complex.y;
    if (value == 0)
        add_noise(sum.noise, one, amplitude, radius);
    if (coloured) // which implies a single noise
        add_weighted(sum.components, one, weights);
}

// Writes the channels that bodies and planes share. `slope`: the derivatives to the right and down.
void write_values(int at, Values here, vec2 slope, vec3 colour) {
    for (int i = 0; i < (coloured ? 3 : values); ++i)
        picture[at + i] = coloured ? colour[i] : here.values[i];
    if (quadrature_at >= 0)
        picture[at + quadrature_at] = here.noise.complex.x;
    if (gradient_at >= 0) {
        picture[at + gradient_at] = slope.x;
        picture[at + gradient_at + 1] = slope.y;
    }
    if (phasor_at >= 0) {
        vec2 phasor = gabor_phasor(here.noise.complex);
        picture[at + phasor_at] = phasor.x;
        picture[at + phasor_at + 1] = phasor.y;
    }
}
