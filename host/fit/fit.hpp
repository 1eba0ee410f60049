#pragma once

#include "fit/exemplar.hpp"
#include "fit/fit_error.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"

#include <vector>

namespace gabor::fit {

/// The most lobes that a preset may have.
constexpr int most_lobes = 16;

/// A texture of Gabor noise.
struct FittedNoise {
    std::vector<Wave> waves; ///< the most powerful first; weights are of components of variance 1
    noise::Colour colour;
    FitError error;                ///< before it got the exemplar's exact covariance
    std::vector<double> variances; ///< of the components there, as shares of the exemplar's
};

/// Fits at most so many lobes: fewer where more would fit what is chance in an exemplar of that size.
///
/// One after another, the lobe is chosen that takes most of what is left of the spectra; then all of them are
/// moved towards the least squares. After [GLLD12] Galerne, Lagae, Lefebvre, Drettakis, "Gabor noise by
/// example", 2012.
FittedNoise fit(const Exemplar& exemplar, int lobes, const Advance& advance);

/// The length in pixels that a preset measures these lobes in: the strongest one's radius, or so near it that
/// no other radius is more than 100 or less than 0.01.
double unit_of(const std::vector<Wave>& waves);

} // namespace gabor::fit
