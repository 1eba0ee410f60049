#pragma once

#include "noise/lobe.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::noise {

/// A noise of a single wave vector. Independent ones add up to any spectrum.
struct Wave {
    double frequency = 4; ///< cycles per unit of length
    double angle = 0;     ///< radians, of the wave vector
    double radius = 1;    ///< of its kernels, in units of length
    double share = 1;     ///< of the variance
    std::uint32_t seed = 0;
    /// In space: whether it goes in all directions. `angle` is then without meaning.
    bool isotropic = false;
};

/// The noises whose sum has a plane's power spectrum, those of shaders/gabor_spectrum.glsl. A single lobe has
/// the request's seed for its own, several lobes one each.
std::vector<Wave> waves(std::span<const Lobe> lobes, std::uint32_t seed);

/// The same in space, where an orientation spread of 90 degrees is every direction, and others spread in the
/// plane z = 0.
std::vector<Wave> waves_in_space(std::span<const Lobe> lobes, std::uint32_t seed);

/// The different kernel radii among them, in the order in which they come.
std::vector<double> radii(std::span<const Wave> waves);

} // namespace gabor::noise
