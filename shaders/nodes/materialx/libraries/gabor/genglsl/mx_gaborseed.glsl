#include "lib/mx_gabor.glsl"

void mx_gaborseed(int seed, int index, out int result)
{
    result = int(mx_gabor_derived_seed(uint(seed), index));
}
