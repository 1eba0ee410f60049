#pragma once

#include "study/variant.hpp"

namespace gabor::study {

/// How much of a kernel's power is where it was asked for. The spectrum of a kernel is that of its window
/// around the wave vector: a lobe up to its first minimum, then sidelobes.
struct Purity {
    double sidelobe = 0; ///< power of the largest sidelobe, dB of the lobe's peak
    double outside = 0;  ///< share of the power that is outside the lobe
};

Purity purity(const Window& window);

} // namespace gabor::study
