#version 450
#extension GL_GOOGLE_include_directive : require

#ifdef LATTICE
#include "gabor_noise.glsl"
#else
#include "gabor_sparse.glsl"
#endif

layout(local_size_x = 8) in;
layout(std430, binding = 0) writeonly buffer Values { float values[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    vec2 p = (vec2(pixel) + 0.5) / 32.0;
    values[pixel.y * 256u + pixel.x] = gabor_noise(p, 4.0, radians(45.0), 7u);
}
