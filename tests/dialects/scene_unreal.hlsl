// The code that Unreal's material compiler generates from a Custom node's text and its include file, except for the
// name of the first parameter.
#define MaterialFloat float
#define MaterialFloat2 float2
#include "gabor_noise.ush"

struct FMaterialPixelParameters {
    float4 SvPosition;
};

MaterialFloat CustomExpression0(FMaterialPixelParameters, MaterialFloat2 Place, MaterialFloat Frequency, MaterialFloat Orientation, MaterialFloat Seed)
{
#include "custom.hlsl"
}

RWStructuredBuffer<float> values : register(u0);

[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    FMaterialPixelParameters Parameters;
    Parameters.SvPosition = float4(float2(pixel.xy) + 0.5, 0.0, 1.0);
    values[pixel.y * 256 + pixel.x] = CustomExpression0(Parameters, Parameters.SvPosition.xy / 32.0, 4.0, 0.7854, 7.0);
}
