#pragma once

#include "fit/exemplar.hpp"
#include "fit/fit_error.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"

#include <vector>

namespace gabor::fit {

/// The largest number of lobes in a preset.
constexpr int most_lobes = 16;

/// A texture of Gabor noise.
struct FittedNoise {
    std::vector<Wave> waves; ///< the most powerful first, with weights in components of variance 1
    noise::Colour colour;
    FitError error;                ///< measured before `normalize` corrects the covariance
    std::vector<double> variances; ///< of the components before that, as shares of the exemplar's variances
};

/// Fits at most `lobes` lobes: fewer if more would only fit chance in an exemplar of that size.
///
/// Adds one lobe at a time, the one that reduces the residual of the spectra most, then refines all of them
/// by least squares. Based on [GLLD12] Galerne, Lagae, Lefebvre, Drettakis, "Gabor noise by example", 2012.
FittedNoise fit(const Exemplar& exemplar, int lobes, const Advance& advance);

/// The unit of length of a preset with these lobes, in pixels: the radius of the strongest lobe, or the
/// nearest length for which all radii are from 0.01 to 100 units.
double unit_of(const std::vector<Wave>& waves);

} // namespace gabor::fit
