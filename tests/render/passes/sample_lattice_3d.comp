#version 450
#extension GL_GOOGLE_include_directive : require

// What gabor_lattice_3d.glsl answers at any places, for the tests.

#include "gabor_lattice.glsl"
#include "gabor_lattice_3d.glsl"

layout(local_size_x = 64) in;

// In scalars, for a vec3 would be padded.
struct Sample {
    int cell[3];
    float local[3];
    float radius[3];
    int period[3];
    int animated;
    float time;
    float frequency;
    float direction[3];
    float normal[3];
    float dx[3];
    float dy[3];
    float p[3];    // of the functions of a position
    float tile[3]; // periods of gabor_noise_3d_tiled, kernel radii
    uint seed;
};

struct Answer {
    float field[8]; // gabor_field_3d
    float value; // the functions by place, with the footprint
    float removed;
    float isotropic[2];
    float surface[2];
    float surface_isotropic[2];
    float noise; // the functions of a position
    float gradient[4];
    float complex[2];
    float four[4];
    float tiled;
    float animated;
    float filtered[2];
    float noise_isotropic;
    float noise_surface;
    float noise_surface_isotropic;
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
    int wanted; // 0: all; 1: the field; 2: the value; 3: sums by place; 4: gabor_noise_3d_four
};

vec3 vector(float v[3])
{
    return vec3(v[0], v[1], v[2]);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    vec3 direction = vector(s.direction);
    vec3 normal = vector(s.normal);
    vec3 dx = vector(s.dx);
    vec3 dy = vector(s.dy);
    vec3 p = vector(s.p);
    vec3 wave = gabor_wave_3d(s.frequency, direction);
    bool filtered = dx != vec3(0.0) || dy != vec3(0.0);
    GaborPlace3d place = GaborPlace3d(ivec3(s.cell[0], s.cell[1], s.cell[2]), vector(s.local), vector(s.radius),
                                      ivec3(s.period[0], s.period[1], s.period[2]), s.animated != 0, s.time, filtered,
                                      dx, dy);
    if (wanted <= 1) {
        GaborField3d field = gabor_field_3d(place, wave, s.seed);
        for (int c = 0; c < 2; ++c) {
            answers[i].field[c] = field.value[c];
            answers[i].field[2 + c] = field.slope_x[c];
            answers[i].field[4 + c] = field.slope_y[c];
            answers[i].field[6 + c] = field.slope_z[c];
        }
    }
    if (wanted == 0 || wanted == 2) {
        vec2 value = gabor_value_3d(place, wave, s.seed);
        answers[i].value = value.x;
        answers[i].removed = value.y;
    }
    if (wanted == 0 || wanted == 3) {
        vec2 isotropic = gabor_isotropic_3d(place, s.frequency, s.seed);
        vec2 surface = gabor_surface_3d(place, normal, s.frequency, direction, s.seed);
        vec2 surface_isotropic = gabor_surface_isotropic_3d(place, normal, s.frequency, s.seed);
        for (int c = 0; c < 2; ++c) {
            answers[i].isotropic[c] = isotropic[c];
            answers[i].surface[c] = surface[c];
            answers[i].surface_isotropic[c] = surface_isotropic[c];
        }
    }
    if (wanted == 0 || wanted == 4) {
        vec4 four = gabor_noise_3d_four(p, s.frequency, direction, s.seed);
        for (int c = 0; c < 4; ++c)
            answers[i].four[c] = four[c];
    }
    if (wanted != 0)
        return;
    vec4 gradient = gabor_noise_3d_gradient(p, s.frequency, direction, s.seed);
    vec2 complex = gabor_noise_3d_complex(p, s.frequency, direction, s.seed);
    vec2 average = gabor_noise_3d_filtered(p, dx, dy, s.frequency, direction, s.seed);
    for (int c = 0; c < 4; ++c)
        answers[i].gradient[c] = gradient[c];
    for (int c = 0; c < 2; ++c) {
        answers[i].complex[c] = complex[c];
        answers[i].filtered[c] = average[c];
    }
    answers[i].noise = gabor_noise_3d(p, s.frequency, direction, s.seed);
    answers[i].tiled = gabor_noise_3d_tiled(p, vector(s.tile), s.frequency, direction, s.seed);
    answers[i].animated = gabor_noise_3d_animated(p, s.time, s.frequency, direction, s.seed);
    answers[i].noise_isotropic = gabor_noise_3d_isotropic(p, s.frequency, s.seed);
    answers[i].noise_surface = gabor_noise_surface(p, normal, s.frequency, direction, s.seed);
    answers[i].noise_surface_isotropic = gabor_noise_surface_isotropic(p, normal, s.frequency, s.seed);
}
