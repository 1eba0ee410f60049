// The channels of a pixel of noise: how many there are and, for those that a request can add, their indices. Vectors have the
// index of their first component, and missing channels -1.

#include "passes/constants.h"

layout(constant_id = channels_id) const int channels = 1;
layout(constant_id = quadrature_id) const int quadrature_at = -1;
layout(constant_id = gradient_id) const int gradient_at = -1; // derivatives to the right and down
layout(constant_id = phasor_id) const int phasor_at = -1;     // phase and intensity
layout(constant_id = normal_id) const int normal_at = -1;     // normal (right, down, towards the eye); derivative towards the eye
layout(constant_id = coverage_id) const int coverage_at = -1;
layout(constant_id = removed_id) const int removed_at = -1;
layout(constant_id = coloured_id) const bool coloured = false; // whether the first channels are a colour instead of noises
