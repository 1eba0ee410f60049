// As Shader Graph calls the function of its Custom Function node; in graphs of half precision, the other.
#include "shaders/nodes/unity/GaborNoise.hlsl"

RWStructuredBuffer<float> values : register(u0);

[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 _Property_Place = (float2(pixel.xy) + 0.5) / 32.0;
    float _GaborNoise_Noise;
    float _GaborNoise_Quadrature;
    GaborNoise_float(_Property_Place, 4.0, 0.7854, 7.0, _GaborNoise_Noise, _GaborNoise_Quadrature);
    half noise;
    half quadrature;
    GaborNoise_half((half2)_Property_Place, (half)4.0, (half)0.7854, (half)7.0, noise, quadrature);
    // The second one is called, or compilers would not look at it; a place in half precision is off by a pixel.
    bool calculated = abs(noise - _GaborNoise_Noise) < 4.0 && abs(quadrature - _GaborNoise_Quadrature) < 4.0;
    values[pixel.y * 256 + pixel.x] = calculated ? _GaborNoise_Noise : 1.0e9;
}
