#version 300 es
precision highp float;
precision highp int;

#include "node_modules/gabor-noise/shaders/gabor_noise.glsl"

out vec4 value;

void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    value = vec4(gl_FragCoord.y < 256.0 ? gabor_noise(p, 4.0, 0.7854, 7u)
        : gabor_noise_at(ivec2(1000000000, -1000000000), p, gabor_kernel(4.0, 0.7854), 7u));
}
