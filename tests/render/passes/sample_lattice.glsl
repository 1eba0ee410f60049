// Evaluates the lattice noise at given places, for the tests. GABOR_TAPS is defined before.

#include "gabor_lattice.glsl"

// 0: all the answers, 1: only `at`, 2: `tiled` and `animated`, 3: `complex`, `gradient` and `four`, 4: of a wave vector
layout(constant_id = 0) const int wanted = 0;

layout(local_size_x = 64) in;

struct Sample {
    ivec2 cell;
    vec2 local;
    vec2 p; // what the functions of a position see
    vec2 radius;
    ivec2 period;
    int animated;
    float time;
    float frequency;
    float orientation;
    uint seed;
    float period_x; // of gabor_noise_tiled, kernel radii
    float period_y;
    float sharpness;
    vec2 wave;
};

struct Answer {
    vec2 value; // gabor_field
    vec2 slope_x;
    vec2 slope_y;
    vec2 complex;
    vec2 phasor;
    vec2 gradient; // without the noise, which must be `noise`
    float noise;
    float gradient_noise;
    float tiled;
    float animated;
    float unorm;
    float at; // gabor_noise_at(cell, local)
    uint word;
    uint padding;
    vec4 four; // gabor_noise_four
    vec4 wave; // gabor_noise_wave_gradient, and gabor_noise_wave
    vec2 wave_complex;
    float wave_tiled;
    float stripes_tiled; // its cosine plus twice its sine and four times its intensity
    vec4 stripes;        // in w as stripes_tiled that of gabor_stripes_at(place)
};

float packed(vec3 v) {
    return dot(v, vec3(1.0, 2.0, 4.0));
}

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    GaborKernel kernel = gabor_kernel(s.frequency, s.orientation);
    vec2 p = s.p;
    bool all = wanted == 0;
    if (all || wanted == 1)
        answers[i].at = gabor_noise_at(s.cell, s.local, kernel, s.seed);
    if (all || wanted == 2) {
        answers[i].tiled = gabor_noise_tiled(p, vec2(s.period_x, s.period_y), s.frequency, s.orientation, s.seed);
        answers[i].animated = gabor_noise_animated(p, s.time, s.frequency, s.orientation, s.seed);
    }
    if (all || wanted == 3) {
        answers[i].complex = gabor_noise_complex(p, s.frequency, s.orientation, s.seed);
        answers[i].phasor = gabor_phasor(answers[i].complex);
        vec3 gradient = gabor_noise_gradient(p, s.frequency, s.orientation, s.seed);
        answers[i].gradient_noise = gradient.x;
        answers[i].gradient = gradient.yz;
        answers[i].four = gabor_noise_four(p, s.frequency, s.orientation, s.seed);
    }
    if (all || wanted == 4) {
        vec2 period = vec2(s.period_x, s.period_y);
        answers[i].wave = vec4(gabor_noise_wave_gradient(p, s.wave, s.seed), gabor_noise_wave(p, s.wave, s.seed));
        answers[i].wave_complex = gabor_noise_wave_complex(p, s.wave, s.seed);
        answers[i].wave_tiled = gabor_noise_wave_tiled(p, period, s.wave, s.seed);
        answers[i].stripes_tiled = packed(gabor_stripes_tiled(p, period, s.wave, s.sharpness, s.seed));
        GaborPlace place = GaborPlace(s.cell, s.local, s.radius, s.period, s.animated != 0, s.time);
        answers[i].stripes = vec4(gabor_stripes(p, s.wave, s.sharpness, s.seed),
                                  packed(gabor_stripes_at(place, s.wave, s.sharpness, s.seed)));
    }
    if (!all)
        return;

    GaborPlace place = GaborPlace(s.cell, s.local, s.radius, s.period, s.animated != 0, s.time);
    GaborField field = gabor_field(place, kernel, s.seed);
    answers[i].value = field.value;
    answers[i].slope_x = field.slope_x;
    answers[i].slope_y = field.slope_y;
    answers[i].noise = gabor_noise(p, s.frequency, s.orientation, s.seed);
    answers[i].unorm = gabor_unorm(field.value.y);
    uint salt = gabor_impl_salt(s.seed);
    answers[i].word = gabor_impl_line_word(s.cell.x, salt) * gabor_impl_line_word(s.cell.y, salt ^ GABOR_IMPL_ROWS);
}
