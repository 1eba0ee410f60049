// The code that Unreal's material compiler generates from Custom nodes' texts and their include files, except for the
// names of the first parameters. VALUE is the call that the scene draws.
#define MaterialFloat float
#define MaterialFloat2 float2
#include "gabor_noise.ush"
#include "gabor_fractal.ush"

struct FMaterialPixelParameters {
    float4 SvPosition;
};

MaterialFloat CustomExpression0(FMaterialPixelParameters, MaterialFloat2 Place, MaterialFloat Frequency, MaterialFloat Orientation, MaterialFloat Seed)
{
#include "custom.hlsl"
}

MaterialFloat CustomExpression1(FMaterialPixelParameters, MaterialFloat2 Place, MaterialFloat Octaves, MaterialFloat Gain, MaterialFloat Shape,
                                MaterialFloat Basis, MaterialFloat Seed)
{
#include "fractal.hlsl"
}

RWStructuredBuffer<float> values : register(u0);

[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    FMaterialPixelParameters Parameters;
    Parameters.SvPosition = float4(float2(pixel.xy) + 0.5, 0.0, 1.0);
    float2 Place = Parameters.SvPosition.xy / 32.0;
    values[pixel.y * 256 + pixel.x] = VALUE;
}
