#pragma once

#include "noise/lobe.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gabor::noise {

/// A noise with one wave vector. Sums of independent waves can have any spectrum.
struct Wave {
    double frequency = 4;               ///< cycles per unit of length
    double angle = 0;                   ///< direction of the wave vector, in radians
    std::array<double, 2> radius{1, 1}; ///< radii of its kernels along x and y, in units of length
    double share = 1;                   ///< fraction of the variance
    std::uint32_t seed = 0;
    /// In space: whether waves go in all directions. `angle` is then unused.
    bool isotropic = false;

    /// Returns the wave vector in cycles per kernel radius along each axis.
    std::array<double, 2> in_kernels() const;
};

/// Returns the noises whose sum has this power spectrum in the plane, as in shaders/gabor_spectrum.glsl. A
/// single lobe uses the request's seed; several lobes have one seed each.
///
/// In space, an orientation spread of 90 degrees covers all directions, and smaller spreads stay in the plane
/// z = 0. Kernels are round, with the geometric mean of both radii.
std::vector<Wave> waves(std::span<const Lobe> lobes, std::uint32_t seed, bool in_space = false);

/// Returns the different kernel radii of the waves, in order of appearance.
std::vector<std::array<double, 2>> radii(std::span<const Wave> waves);

} // namespace gabor::noise
