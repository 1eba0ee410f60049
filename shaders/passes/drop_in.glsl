// Values of the noise of a drop-in that was included before, where the study looks.

#include "places.glsl"

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    uint seed;
    vec2 p = place_of(i, seed);
    values[i] = amplitude * gabor_noise(p / GABOR_RADIUS, length(wave), atan(wave.y, wave.x), seed);
}
