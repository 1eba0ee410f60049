#version 450
#extension GL_GOOGLE_include_directive : require

// The functions of golden/functions.glsl, GABOR_OF_SET: call k at point i becomes values[64 k + i].

#include "../../golden/sets.h"
#if defined GOLDEN_NOISE
#include "gabor_noise.glsl"
#else
#include "gabor_lattice.glsl"
#endif
#if defined GOLDEN_SPECTRUM
#include "gabor_spectrum.glsl"
#endif

layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };

int next = int(gl_LocalInvocationID.x);
#define SEE(call) values[next] = call; next += 64;
#include "../../golden/functions.glsl"

void main() {
    see_all(int(gl_LocalInvocationID.x));
}
