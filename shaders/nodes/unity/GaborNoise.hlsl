// What Shader Graph's Custom Function node calls: the noise, mean 0 and variance 1, and its quadrature, of mean 0 and
// variance 1 too and with waves a quarter period ahead.
//   Place         in kernel radii
//   Frequency     cycles per kernel radius
//   Orientation   of the waves, in radians from +x towards +y
//   Seed          a whole number
#ifndef GABOR_NOISE_NODE_HLSL
#define GABOR_NOISE_NODE_HLSL

#include "gabor_lattice.hlsl"

void GaborNoise_float(float2 Place, float Frequency, float Orientation, float Seed, out float Noise, out float Quadrature)
{
    float2 value = gabor_noise_complex(Place, Frequency, Orientation, (uint)(int)Seed);
    Noise = value.y;
    Quadrature = value.x;
}

// For graphs of half precision: the noise itself is calculated in full.
void GaborNoise_half(half2 Place, half Frequency, half Orientation, half Seed, out half Noise, out half Quadrature)
{
    float2 value = gabor_noise_complex((float2)Place, (float)Frequency, (float)Orientation, (uint)(int)Seed);
    Noise = (half)value.y;
    Quadrature = (half)value.x;
}

#endif
