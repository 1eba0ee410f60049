#version 450
#extension GL_GOOGLE_include_directive : require

// Computes variants of the drop-in's recipes for the studies `frontier` and `future`: any number of impulses,
// lattice, distribution of magnitudes and window.

layout(constant_id = 0) const int impulses = 1;
layout(constant_id = 1) const float radius = 1.0; // radius in cells
layout(constant_id = 2) const int brick = 0;      // 1: odd rows of cells are shifted by half a cell
layout(constant_id = 3) const float jitter = 1.0; // 0: impulses stay at the centre of their cell
layout(constant_id = 4) const int magnitudes = 0; // 0 uniform in [weight_floor, 1], 1 weight_floor or 1, 2 Rayleigh
layout(constant_id = 5) const float weight_floor = 1.0;
layout(constant_id = 6) const int window = 0; // 0 separable polynomial, 1 radial polynomial, 2 truncated Gaussian
layout(constant_id = 7) const float window_x = 1.0;
layout(constant_id = 8) const float window_y = 0.0;
layout(constant_id = 9) const float window_z = 0.0;

#define GABOR_WINDOW vec3(window_x, window_y, window_z)
#include "gabor_sparse.glsl"
#include "places.glsl"

float magnitude(uint word) {
    float u = (float(int(word >> 8u)) + 0.5) / 16777216.0;
    if (magnitudes == 2)
        return sqrt(-2.0 * log(u));
    if (magnitudes == 1)
        return u < 0.5 ? weight_floor : 1.0;
    return weight_floor + (1.0 - weight_floor) * u;
}

float envelope(vec2 d) {
    if (window == 0)
        return gabor_impl_window(d.x).x * gabor_impl_window(d.y).x;
    if (window == 1)
        return gabor_impl_window(length(d)).x;
    return dot(d, d) <= 1.0 ? exp(-3.14159265 * dot(d, d)) : 0.0;
}

float noise(vec2 p, uint seed) {
    float largest_shift = brick == 1 ? 0.5 : 0.0;
    int columns = int(ceil(2.0 * radius + largest_shift)) + 1;
    int rows = int(ceil(2.0 * radius)) + 1;
    vec2 first = floor(p - radius - vec2(largest_shift, 0.0));
    uint seed_word = gabor_impl_seed_word(seed);
    float sum = 0.0;
    for (int j = 0; j < rows; ++j) {
        float row = first.y + float(j);
        float shift = brick == 1 ? fract(0.5 * row) : 0.0;
        uint row_word = gabor_impl_row_word(int(row), seed_word);
        for (int i = 0; i < columns; ++i) {
            float column = first.x + float(i);
            for (int k = 0; k < impulses; ++k) {
                uint word = gabor_impl_impulse_word(int(column), row_word, k);
                uint more = gabor_impl_mix(word, 3u);
                vec2 place = gabor_impl_impulse(word).position_plus_one - 1.5;
                vec2 d = (p - (jitter * place + vec2(column + shift, row) + 0.5)) / radius;
                float phase = float(int((more ^ word) & 0xffu)) / 256.0;
                sum += magnitude(more) * envelope(d) * gabor_impl_sine(dot(wave, d) + phase);
            }
        }
    }
    return sum;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    uint seed;
    vec2 p = place_of(i, seed);
    values[i] = amplitude * noise(p, seed);
}
