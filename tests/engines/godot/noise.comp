#version 450

#include "gabor_noise.glsl"

layout(local_size_x = 8) in;
layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    vec2 p = (vec2(pixel) + 0.5) / 32.0;
    values[pixel.y * 256u + pixel.x] = gabor_noise(p, 4.0, 0.7854, 7u);
}
