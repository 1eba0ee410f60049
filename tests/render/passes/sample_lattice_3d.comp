#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates one function of gabor_lattice_3d.glsl at given places, for the tests. GABOR_OF_... names it, as in
// sampler_lattice_3d.hpp: drivers take seconds to compile a pipeline that contains all of them.

#include "gabor_lattice.glsl"
#include "gabor_spectrum.glsl"
#include "gabor_lattice_3d.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 0) const int filtered = 0; // the functions that take a place
layout(constant_id = 1) const int animated = 0;

// Scalars, because a vec3 would be padded.
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
    float p[3];    // of the functions of a position
    float tile[3]; // periods of gabor_noise_3d_tiled, kernel radii
    uint seed;
};

struct Answer {
    float value[9];
};

layout(std430, set = 0, binding = 0) readonly buffer Samples { Sample samples[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };

layout(push_constant) uniform Push {
    uint count;
};

vec3 vector(float v[3]) {
    return vec3(v[0], v[1], v[2]);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    Sample s = samples[i];
    float f = s.frequency;
    vec3 direction = vector(s.direction);
    vec3 normal = vector(s.normal);
    vec3 p = vector(s.p);
    GaborPlace3d place = GaborPlace3d(ivec3(s.cell[0], s.cell[1], s.cell[2]), vector(s.local), vector(s.radius),
                                      ivec3(s.period[0], s.period[1], s.period[2]), animated != 0, s.time,
                                      filtered != 0, vector(s.dx), vector(s.dy));
#if defined GABOR_OF_field || defined GABOR_OF_isotropic || defined GABOR_OF_surface || defined GABOR_OF_surface_isotropic
    GaborField3d field;
#if defined GABOR_OF_field
    field = gabor_field_3d(place, f, direction, s.seed);
#elif defined GABOR_OF_isotropic
    field = gabor_isotropic_3d(place, f, s.seed);
#elif defined GABOR_OF_surface
    field = gabor_surface_3d(place, normal, f, direction, s.seed);
#elif defined GABOR_OF_surface_isotropic
    field = gabor_surface_isotropic_3d(place, normal, f, s.seed);
#endif
    answers[i].value[0] = field.quadrature;
    answers[i].value[1] = field.noise;
    for (int axis = 0; axis < 3; ++axis) {
        answers[i].value[2 + 2 * axis] = field.quadrature_gradient[axis];
        answers[i].value[3 + 2 * axis] = field.gradient[axis];
    }
    answers[i].value[8] = field.removed;
#else // a function of a position
    vec4 answer = vec4(0.0);
#if defined GABOR_OF_noise
    answer.x = gabor_noise_3d(p, f, direction, s.seed);
#elif defined GABOR_OF_complex
    answer.xy = gabor_noise_3d_complex(p, f, direction, s.seed);
#elif defined GABOR_OF_gradient
    answer = gabor_noise_3d_gradient(p, f, direction, s.seed);
#elif defined GABOR_OF_four
    answer = gabor_noise_3d_four(p, f, direction, s.seed);
#elif defined GABOR_OF_tiled
    answer.x = gabor_noise_3d_tiled(p, vector(s.tile), f, direction, s.seed);
#elif defined GABOR_OF_animated
    answer.x = gabor_noise_3d_animated(p, s.time, f, direction, s.seed);
#elif defined GABOR_OF_filtered
    answer.xy = gabor_noise_3d_filtered(p, vector(s.dx), vector(s.dy), f, direction, s.seed);
#elif defined GABOR_OF_noise_isotropic
    answer.x = gabor_noise_3d_isotropic(p, f, s.seed);
#elif defined GABOR_OF_noise_isotropic_gradient
    answer = gabor_noise_3d_isotropic_gradient(p, f, s.seed);
#elif defined GABOR_OF_noise_isotropic_filtered
    answer.xy = gabor_noise_3d_isotropic_filtered(p, vector(s.dx), vector(s.dy), f, s.seed);
#elif defined GABOR_OF_noise_surface
    answer.x = gabor_noise_surface(p, normal, f, direction, s.seed);
#elif defined GABOR_OF_noise_surface_isotropic
    answer.x = gabor_noise_surface_isotropic(p, normal, f, s.seed);
#endif
    for (int c = 0; c < 4; ++c)
        answers[i].value[c] = answer[c];
#endif
}
