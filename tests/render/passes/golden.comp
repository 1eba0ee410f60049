#version 450
#extension GL_GOOGLE_include_directive : require

// Evaluates the functions of golden/functions.glsl for GABOR_OF_SET. The result of call k at point i of n is
// values[n k + i]. The first 64 points have golden values, the next 4096 have arbitrary arguments, and the
// others are compared with C++.

#include "../../golden/sets.h"
#if defined GOLDEN_SPARSE
#include "gabor_sparse.glsl"
#else
#include "gabor_noise.glsl"
#endif
#if defined GOLDEN_EROSION
#include "gabor_erosion.glsl"
#elif defined GOLDEN_FRACTAL
#include "gabor_fractal.glsl"
#elif defined GOLDEN_OCEAN
#include "gabor_ocean.glsl"
#elif defined GOLDEN_DIRECTION
#define GABOR_DIRECTION(p) (0.3 * (p))
#include "gabor_direction.glsl"
#elif defined GOLDEN_NOISE_3D
#include "gabor_filter.glsl"
#include "gabor_noise_3d.glsl"
#include "gabor_filter_3d.glsl"
#elif defined GOLDEN_SPECTRUM || defined GOLDEN_MATERIALS
#include "gabor_spectrum.glsl"
#include "gabor_filter.glsl"
#endif

layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };

uint next = gl_GlobalInvocationID.x;
#define SEE(call) values[next] = call; next += 64u * gl_NumWorkGroups.x;
#include "../../golden/functions.glsl"

void main() {
    int point = int(gl_GlobalInvocationID.x);
    see_all(point < 64 || point >= 64 * 65 ? point : -point);
}
