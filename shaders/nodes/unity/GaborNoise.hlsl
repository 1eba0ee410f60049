// The functions that Shader Graph's Custom Function nodes call.
//   Place         position in kernel radii
//   Frequency     cycles per kernel radius
//   Orientation   direction of the waves, in radians from +x towards +y
//   Wave          wave vector, in cycles per kernel radius; it may follow a direction map
//   Sharpness     sharpness of stripes where they fork; 2 is a good value
//   Seed          a whole number
//   Octaves       1 to 16; the last one fades in with the fraction
//   Gain          amplitude of an octave relative to the previous one
//   Shape         0 for fBm, 1 for billows, 2 for ridges
//   Basis         0 for smooth octaves, 1 for octaves like Perlin noise
// Noise and Quadrature have mean 0 and variance 1; the quadrature's waves are a quarter of a period ahead. Gradient is the
// gradient of Noise, per kernel radius. Stripes holds (cosine, sine, intensity): see gabor_stripes.
#ifndef GABOR_NOISE_NODE_HLSL
#define GABOR_NOISE_NODE_HLSL

#include "gabor_noise.hlsl"
#include "gabor_fractal.hlsl"

void GaborNoise_float(float2 Place, float Frequency, float Orientation, float Seed, out float Noise, out float Quadrature)
{
    float2 value = gabor_noise_quadrature(Place, Frequency, Orientation, (uint)(int)Seed);
    Noise = value.x;
    Quadrature = value.y;
}

void GaborStripes_float(float2 Place, float2 Wave, float Sharpness, float Seed, out float Noise, out float2 Gradient, out float3 Stripes)
{
    GaborField field = gabor_field(gabor_place_at(Place), Wave, (uint)(int)Seed);
    Noise = field.noise;
    Gradient = field.gradient;
    Stripes = gabor_stripes_of(field, Sharpness);
}

GaborFractal GaborFractal_node(float Octaves, float Gain, float Shape, float Basis)
{
    GaborFractal fractal = gabor_fractal(Octaves, Gain);
    fractal.shape = (int)(Shape + 0.5);
    fractal.basis = (int)(Basis + 0.5);
    return fractal;
}

void GaborFractal_float(float2 Place, float Octaves, float Gain, float Shape, float Basis, float Seed, out float Noise, out float2 Gradient)
{
    GaborFractal fractal = GaborFractal_node(Octaves, Gain, Shape, Basis);
    GaborFractalNoise noise = gabor_fractal_noise(gabor_place_at(Place), fractal, (uint)(int)Seed);
    Noise = noise.noise;
    Gradient = noise.gradient;
}

// Averages over a pixel: for fragment stages alone.
void GaborFractalFiltered_float(float2 Place, float Octaves, float Gain, float Shape, float Basis, float Seed, out float Noise, out float2 Gradient)
{
    GaborFractal fractal = GaborFractal_node(Octaves, Gain, Shape, Basis);
    GaborFractalNoise noise = gabor_fractal_noise_filtered(gabor_place_at(Place), ddx(Place), ddy(Place), fractal, (uint)(int)Seed);
    Noise = noise.noise;
    Gradient = noise.gradient;
}

// For graphs with half precision; the noise itself is computed in full precision.
void GaborNoise_half(half2 Place, half Frequency, half Orientation, half Seed, out half Noise, out half Quadrature)
{
    float2 value = gabor_noise_quadrature((float2)Place, (float)Frequency, (float)Orientation, (uint)(int)Seed);
    Noise = (half)value.x;
    Quadrature = (half)value.y;
}

void GaborStripes_half(half2 Place, half2 Wave, half Sharpness, half Seed, out half Noise, out half2 Gradient, out half3 Stripes)
{
    float noise;
    float2 gradient;
    float3 stripes;
    GaborStripes_float((float2)Place, (float2)Wave, (float)Sharpness, (float)Seed, noise, gradient, stripes);
    Noise = (half)noise;
    Gradient = (half2)gradient;
    Stripes = (half3)stripes;
}

void GaborFractal_half(half2 Place, half Octaves, half Gain, half Shape, half Basis, half Seed, out half Noise, out half2 Gradient)
{
    float noise;
    float2 gradient;
    GaborFractal_float((float2)Place, (float)Octaves, (float)Gain, (float)Shape, (float)Basis, (float)Seed, noise, gradient);
    Noise = (half)noise;
    Gradient = (half2)gradient;
}

void GaborFractalFiltered_half(half2 Place, half Octaves, half Gain, half Shape, half Basis, half Seed, out half Noise, out half2 Gradient)
{
    float noise;
    float2 gradient;
    GaborFractalFiltered_float((float2)Place, (float)Octaves, (float)Gain, (float)Shape, (float)Basis, (float)Seed, noise, gradient);
    Noise = (half)noise;
    Gradient = (half2)gradient;
}

#endif
