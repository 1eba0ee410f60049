#include "lib/mx_gabor.glsl"

void mx_gaborfield3d(vec3 position, float frequency, vec3 direction, int seed, out vec4 result)
{
    vec3 unit = direction / sqrt(max(dot(direction, direction), 1.0e-30));
    result = mx_gabor_field3d(position, min(abs(frequency), 1.0e6) * unit, seed);
}
