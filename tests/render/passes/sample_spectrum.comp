#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates gabor_spectrum.glsl at given places, for the tests.

#define GABOR_LOBES 3

#include "gabor_lattice.glsl"
#include "gabor_spectrum.glsl"

layout(local_size_x = 64) in;

struct Sample {
    vec2 p;
    vec2 dx;
    vec2 dy;
    float frequency;
    float orientation;
    float frequency_spread;
    float orientation_spread;
    uint seed;
    float padding;
    float lobes[15]; // frequency, orientation, radii along x and y, power of each
    ivec2 cell;      // of a place
    vec2 local;
    vec2 period;     // kernel radii
    float time;
};

struct Answer {
    vec2 filtered; // value and removed variance
    vec2 lobes_filtered;
    vec2 lobes_complex;
    vec2 spread_complex;
    vec3 spread; // with its gradient
    float spread_alone;
    vec3 lobes;
    float lobes_alone;
    vec4 filtered_gradient;
    vec4 lobes_filtered_gradient;
    vec2 placed_spread;
    vec2 placed_lobes;
    vec3 placed_filtered; // and the removed variance
    float padding;
    vec2 placed_slope;
    vec2 padding_2;
    vec4 four_filtered;
    float four_removed;
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

// Selects the answers to compute: millions of one kind would take too long with the others.
#define ALL 0
#define FILTERED 1
#define SPREAD 2
layout(constant_id = 0) const int wanted = ALL;

layout(push_constant) uniform Push {
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    GaborLobes lobes;
    lobes.count = 2 * GABOR_LOBES; // those beyond `count` are unused
    for (int k = 0; k < GABOR_LOBES; ++k)
        lobes.lobe[k] = gabor_lobe_elliptical(s.lobes[5 * k], s.lobes[5 * k + 1],
                                              vec2(s.lobes[5 * k + 2], s.lobes[5 * k + 3]), s.lobes[5 * k + 4]);
    if (wanted != SPREAD)
        answers[i].filtered = gabor_noise_filtered(s.p, s.dx, s.dy, s.frequency, s.orientation, s.seed);
    if (wanted != FILTERED)
        answers[i].spread = gabor_noise_spread_gradient(s.p, s.frequency, s.orientation, s.frequency_spread,
                                                        s.orientation_spread, s.seed);
    if (wanted == ALL) {
        answers[i].spread_alone = gabor_noise_spread(s.p, s.frequency, s.orientation, s.frequency_spread,
                                                     s.orientation_spread, s.seed);
        answers[i].spread_complex = gabor_noise_spread_complex(s.p, s.frequency, s.orientation, s.frequency_spread,
                                                               s.orientation_spread, s.seed);
        answers[i].lobes = gabor_noise_lobes_gradient(s.p, lobes, s.seed);
        answers[i].lobes_alone = gabor_noise_lobes(s.p, lobes, s.seed);
        answers[i].lobes_complex = gabor_noise_lobes_complex(s.p, lobes, s.seed);
        answers[i].lobes_filtered = gabor_noise_lobes_filtered(s.p, s.dx, s.dy, lobes, s.seed);
        answers[i].filtered_gradient =
            gabor_noise_filtered_gradient(s.p, s.dx, s.dy, s.frequency, s.orientation, s.seed);
        answers[i].lobes_filtered_gradient = gabor_noise_lobes_filtered_gradient(s.p, s.dx, s.dy, lobes, s.seed);
        GaborPlace place = gabor_place_tiled(vec2(0.0), s.period);
        place.cell = s.cell;
        place.local = s.local;
        place.animated = true;
        place.time = s.time;
        answers[i].placed_spread = gabor_field_spread(place, s.frequency, s.orientation, s.frequency_spread,
                                                      s.orientation_spread, s.seed).value;
        answers[i].placed_lobes = gabor_field_lobes(place, lobes, s.seed).value;
        GaborKernel kernel = gabor_kernel(s.frequency, s.orientation);
        float removed;
        GaborField field = gabor_field_filtered(place, kernel, gabor_footprint(s.dx, s.dy), s.seed, removed);
        answers[i].placed_filtered = vec3(field.value, removed);
        answers[i].placed_slope = vec2(field.slope_x.y, field.slope_y.y);
        answers[i].four_filtered =
            gabor_noise_four_filtered(s.p, s.dx, s.dy, s.frequency, s.orientation, s.seed, answers[i].four_removed);
    }
}
