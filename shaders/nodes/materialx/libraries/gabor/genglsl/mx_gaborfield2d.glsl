#include "lib/mx_gabor.glsl"

void mx_gaborfield2d(vec2 texcoord, float frequency, float orientation, int seed, out vec4 result)
{
    vec2 wave = min(abs(frequency), 1.0e6) * mx_gabor_wave(orientation / 360.0);
    result = mx_gabor_field2d(vec2(texcoord.x, texcoord.y), wave, seed);
}
