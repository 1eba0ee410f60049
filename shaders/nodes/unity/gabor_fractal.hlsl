#include "../../translations/gabor_fractal.hlsl"
