// Calls the functions as Shader Graph's Custom Function nodes do: in graphs of single precision, those whose names end in _float,
// and in graphs of half precision, those in _half. VALUE combines the results that the scene draws.
#include "GaborNoise.hlsl"

RWStructuredBuffer<float> values : register(u0);

[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 place = (float2(pixel.xy) + 0.5) / 32.0;
    float2 wave = gabor_wave_vector(4.0, 0.7854);
    float noise;
    float quadrature;
    float2 gradient;
    float3 stripes;
    GaborStripes_float(place, wave, 2.0, 7.0, noise, gradient, stripes);
    GaborNoise_float(place, 4.0, 0.7854, 7.0, noise, quadrature);
    float fractal;
    float2 slope;
    GaborFractal_float(place, 3.3, 0.5, 0.0, 0.0, 7.0, fractal, slope);
    half half_noise;
    half half_quadrature;
    half2 half_gradient;
    half3 half_stripes;
    GaborStripes_half((half2)place, (half2)wave, (half)2.0, (half)7.0, half_noise, half_gradient, half_stripes);
    GaborNoise_half((half2)place, (half)4.0, (half)0.7854, (half)7.0, half_noise, half_quadrature);
    half half_fractal;
    half2 half_slope;
    GaborFractal_half((half2)place, (half)3.3, (half)0.5, (half)0.0, (half)0.0, (half)7.0, half_fractal, half_slope);
    // The functions for half are called so that the compiler checks them; positions in half precision are off by a pixel.
    bool calculated = abs(half_noise - noise) < 4.0 && abs(half_quadrature - quadrature) < 4.0 && half_gradient.x < 100.0
        && half_stripes.z < 10.0 && abs(half_fractal) < 10.0 && half_slope.x < 100.0;
    values[pixel.y * 256 + pixel.x] = calculated ? VALUE : 1.0e9;
}
