#include "../../translations/gabor_noise.hlsl"
