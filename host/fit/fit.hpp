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
    Spectra model;                 ///< of the exemplar's channels
    FitError error;                ///< of the model before it got the exemplar's exact covariance
    std::vector<double> variances; ///< of the components there, as shares of the exemplar's
};

/// Fits at most so many lobes: fewer where more would fit what is chance in an exemplar of that size.
///
/// One after another, the lobe is chosen that takes most of what is left of the spectra; then all of them are
/// moved towards the least squares. After [GLLD12] Galerne, Lagae, Lefebvre, Drettakis, "Gabor noise by
/// example", 2012.
FittedNoise fit(const Exemplar& exemplar, int lobes, const Advance& advance);

/// The exemplar's spectra in its own channels.
Spectra channel_spectra(const Exemplar& exemplar);

} // namespace gabor::fit
