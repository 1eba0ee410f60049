#include "lib/mx_gabor.glsl"
#include "lib/mx_gabor_fractal.glsl"

void mx_gaborfractalfield2d(vec2 texcoord, float octaves, float lacunarity, float gain, int shape, int basis, int seed,
                            out vec3 result)
{
    vec4 sum = mx_gabor_fractal(vec3(texcoord.x, texcoord.y, 0.0), 0, octaves, lacunarity, gain, shape, basis, seed);
    result = vec3(sum.x, sum.y, sum.z);
}
