#include "gabor_noise.hlsl"

RWStructuredBuffer<float> values : register(u0);

[numthreads(8, 1, 1)]
void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 p = (float2(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256 + pixel.x] = gabor_noise(p, 4.0, 0.7854, 7);
}
