#include "lib/mx_gabor.glsl"
#include "lib/mx_gabor_fractal.glsl"

void mx_gaborfractalfield3d(vec3 position, float octaves, float lacunarity, float gain, int shape, int basis, int seed,
                            out vec4 result)
{
    result = mx_gabor_fractal(position, 1, octaves, lacunarity, gain, shape, basis, seed);
}
