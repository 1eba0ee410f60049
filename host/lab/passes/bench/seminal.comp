#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

// The seminal noise as its authors' published method goes: Lagae, Lefebvre, Drettakis and Dutre, "Procedural noise
// using sparse Gabor convolution", 2009. A generator seeded for each cell and drawn from in sequence, a Poisson number
// of impulses (Knuth's product), uniform weights, a Gaussian cut off at the kernel radius, a cosine. With `advice` it
// is the paper's advice, written in the same plain way: a fixed number, Bernoulli weights, a sine. Both compute the
// direction of the wave for every impulse, as published; with `hoisted` once for each pixel.

#include "bench.glsl"

layout(constant_id = option_id) const int mean_impulses = 30;
layout(constant_id = option_id + 1) const bool advice = false;
layout(constant_id = option_id + 2) const bool hoisted = false;

const float pi = 3.14159265;

uint generator;
vec2 wave; // radians per kernel radius, where hoisted

void seed_generator(ivec2 cell, uint instance) {
    uint word = uint(cell.x) * 0x9e3779b1u ^ (uint(cell.y) * 0x85ebca6bu + instance * 0xc2b2ae35u);
    generator = (word ^ (word >> 15u)) * 0x846ca68bu | 1u;
}

// A multiplicative congruential generator: uniform in [0, 1).
float uniform_value() {
    generator *= 3039177861u;
    return float(generator) / 4294967296.0;
}

int poisson(float mean) {
    float limit = exp(-mean);
    int count = 0;
    float product = uniform_value();
    while (product > limit) {
        ++count;
        product *= uniform_value();
    }
    return count;
}

float kernel(vec2 d) {
    float envelope = exp(-pi * dot(d, d));
    float phase = hoisted ? dot(wave, d)
                          : 2.0 * pi * frequency * (d.x * cos(orientation) + d.y * sin(orientation));
    return envelope * (advice ? sin(phase) : cos(phase));
}

float cell_value(ivec2 cell, vec2 offset, uint instance) {
    seed_generator(cell, instance);
    int count = advice ? mean_impulses : poisson(float(mean_impulses));
    float sum = 0.0;
    [[unroll]] for (int i = 0; i < count; ++i) {
        float x = uniform_value();
        float y = uniform_value();
        float u = uniform_value();
        float weight = advice ? (u < 0.5 ? -1.0 : 1.0) : 2.0 * u - 1.0;
        vec2 d = offset - vec2(x, y);
        if (dot(d, d) < 1.0)
            sum += weight * kernel(d);
    }
    return sum;
}

float value(vec2 p, uint instance) {
    vec2 corner = floor(p);
    ivec2 cell = ivec2(corner);
    vec2 f = p - corner;
    if (hoisted)
        wave = 2.0 * pi * frequency * vec2(cos(orientation), sin(orientation));
    float sum = 0.0;
    [[unroll]] for (int j = -1; j <= 1; ++j)
        [[unroll]] for (int i = -1; i <= 1; ++i)
            sum += cell_value(cell + ivec2(i, j), f - vec2(float(i), float(j)), instance);
    // Variance: impulses times E[w^2] times the energy of the kernel where sin^2 and cos^2 average to 1/2.
    float energy = 0.25 * (1.0 - exp(-2.0 * pi));
    return sum * inversesqrt(float(mean_impulses) * energy * (advice ? 1.0 : 1.0 / 3.0));
}
