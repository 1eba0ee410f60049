// The sum of noises at a pixel, which passes/pixels.comp and passes/solid.comp write to the picture. Include it after the drop-ins
// and the definition of colour_binding.

#include "noise_channels.glsl"
#include "sum.glsl"
#include "colour.glsl"

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };

struct Values {
    float value; // apart from noise.complex.y, so that its last bit is the same whatever else is drawn
    Noise noise;
    Components components;
};

const Values no_values = Values(0.0, Noise(vec2(0.0), vec3(0.0), 0.0), Components(vec3(0.0), vec3(0.0)));

void add_wave(inout Values sum, Noise one, float amplitude, vec2 weights[3]) {
    sum.value += amplitude * one.complex.y;
    add_noise(sum.noise, one, amplitude);
    if (coloured)
        add_weighted(sum.components, one, weights);
}

// Writes the channels that bodies and planes share. `slope`: the derivatives to the right and down.
void write_values(int at, Values here, vec2 slope, vec3 colour) {
    for (int i = 0; i < (coloured ? 3 : 1); ++i)
        picture[at + i] = coloured ? colour[i] : here.value;
    if (quadrature_at >= 0)
        picture[at + quadrature_at] = here.noise.complex.x;
    if (gradient_at >= 0) {
        picture[at + gradient_at] = slope.x;
        picture[at + gradient_at + 1] = slope.y;
    }
    if (phasor_at >= 0) {
        vec2 phasor = gabor_turns_intensity(here.noise.complex.yx);
        picture[at + phasor_at] = phasor.x;
        picture[at + phasor_at + 1] = phasor.y;
    }
}
