#version 450
#extension GL_GOOGLE_include_directive : require

// What the drop-in in space answers at any places, for the tests.

#include "recipe_3d.glsl"

layout(local_size_x = 64) in;

// In scalars, for a vec3 would be padded.
struct Sample {
    int cell[3];
    float local[3];
    float radius[3];
    int period[3];
    float time;
    float frequency;
    float direction[3];
    float normal[3];
    float dx[3];
    float dy[3];
    float tile[3]; // periods of gabor_noise_3d_tiled, kernel radii
    float p[3];    // of the functions of a position, kernel radii
    uint seed;
    int kind;  // of the kernel: 0 oriented, 1 isotropic, 2 surface, 3 isotropic on the surface
    int index; // of the impulse whose word is wanted
};

struct Answer {
    float value[2]; // gabor_field_3d
    float slope_x[2];
    float slope_y[2];
    float slope_z[2];
    float at; // gabor_noise_3d_at(cell, local)
    float noise; // this and those below but for `word`: of p
    float isotropic;
    float gradient[4];
    float complex[2];
    float tiled;
    float animated;
    float surface;
    float surface_isotropic;
    uint word;
    float direction[3]; // of the impulse whose word is wanted
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
    int wanted; // 0: all the answers, 1: only `at`
};

GaborKernel3d kernel_of(Sample s, vec3 direction, vec3 normal)
{
    if (s.kind == 0)
        return gabor_kernel_3d(s.frequency, direction);
    if (s.kind == 1)
        return gabor_kernel_isotropic_3d(s.frequency);
    if (s.kind == 2)
        return gabor_kernel_surface(s.frequency, direction, normal);
    return gabor_kernel_surface_isotropic(s.frequency, normal);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    ivec3 cell = ivec3(s.cell[0], s.cell[1], s.cell[2]);
    vec3 local = vec3(s.local[0], s.local[1], s.local[2]);
    vec3 direction = vec3(s.direction[0], s.direction[1], s.direction[2]);
    vec3 normal = vec3(s.normal[0], s.normal[1], s.normal[2]);
    vec3 dx = vec3(s.dx[0], s.dx[1], s.dx[2]);
    vec3 dy = vec3(s.dy[0], s.dy[1], s.dy[2]);

    GaborKernel3d kernel = kernel_of(s, direction, normal);
    if (dx != vec3(0.0) || dy != vec3(0.0))
        kernel = gabor_filtered_3d(kernel, dx, dy);
    answers[i].at = gabor_noise_3d_at(cell, local, kernel, s.seed);
    if (wanted == 1)
        return;

    GaborPlace3d place = GaborPlace3d(cell, local, vec3(s.radius[0], s.radius[1], s.radius[2]),
                                      ivec3(s.period[0], s.period[1], s.period[2]), s.time);
    GaborField3d field = gabor_field_3d(place, kernel, s.seed);
    vec3 p = vec3(s.p[0], s.p[1], s.p[2]);
    vec4 gradient = gabor_noise_3d_gradient(p, s.frequency, direction, s.seed);
    vec2 complex = gabor_noise_3d_complex(p, s.frequency, direction, s.seed);
    vec3 tile = vec3(s.tile[0], s.tile[1], s.tile[2]);
    uint slice_word = gabor_impl_row_word(cell.z, gabor_impl_seed_word(s.seed));
    uint word = gabor_impulse_word_3d(cell.x, gabor_impl_row_word(cell.y, slice_word), s.index);
    vec3 sphere = gabor_sphere_3d(word);
    for (int c = 0; c < 2; ++c) {
        answers[i].value[c] = field.value[c];
        answers[i].slope_x[c] = field.slope_x[c];
        answers[i].slope_y[c] = field.slope_y[c];
        answers[i].slope_z[c] = field.slope_z[c];
        answers[i].complex[c] = complex[c];
    }
    for (int c = 0; c < 4; ++c)
        answers[i].gradient[c] = gradient[c];
    for (int c = 0; c < 3; ++c)
        answers[i].direction[c] = sphere[c];
    answers[i].noise = gabor_noise_3d(p, s.frequency, direction, s.seed);
    answers[i].isotropic = gabor_noise_3d_isotropic(p, s.frequency, s.seed);
    answers[i].tiled = gabor_noise_3d_tiled(p, tile, s.frequency, direction, s.seed);
    answers[i].animated = gabor_noise_3d_animated(p, s.time, s.frequency, direction, s.seed);
    answers[i].surface = gabor_noise_surface(p, normal, s.frequency, direction, s.seed);
    answers[i].surface_isotropic = gabor_noise_surface_isotropic(p, normal, s.frequency, s.seed);
    answers[i].word = word;
}
