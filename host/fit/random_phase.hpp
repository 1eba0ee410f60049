#pragma once

#include <cstdint>
#include <vector>

namespace gabor::fit {

/// Random-phase noise of a square picture of an even side, channels one after another: the moduli of its
/// transform with random phases, the same ones for all channels [GGM11: Galerne, Gousseau, Morel, "Random
/// phase textures: theory and synthesis", 2011]. That is all that a Gaussian texture can know of it. Of the
/// picture's periodic component [Moisan 2011, "Periodic plus smooth image decomposition"], whose edges fit
/// together. The means stay.
std::vector<float> random_phase(const std::vector<float>& picture, int side, std::uint32_t seed);

} // namespace gabor::fit
