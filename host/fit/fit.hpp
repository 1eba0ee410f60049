#pragma once

#include "fit/exemplar.hpp"
#include "fit/levenberg.hpp"
#include "noise/colour.hpp"
#include "render/request/request.hpp"

#include <string>
#include <vector>

namespace gabor::fit {

/// The largest number of lobes in a preset.
constexpr int most_lobes = 16;

/// How far a sum of waves is from an exemplar.
struct FitError {
    double l1 = 0;  ///< sum of |model - estimate| over the total power spectrum in windows of 64 pixels,
                    ///< relative to the estimate
    double l2 = 0;  ///< root of the sum of squared differences of all cross-spectra, relative to the estimate
    double low = 0; ///< l1 for waves longer than 64 pixels, in the largest windows; 0 if none are larger
    double low_share = 0;       ///< share of such waves in the power
    int furthest_lag = 0;       ///< largest lag compared, in pixels: about a quarter of the shorter side
    double autocorrelation = 0; ///< largest difference between autocorrelations up to that lag
    double chance = 0;          ///< standard error of an autocorrelation that is estimated from this exemplar
};

/// Compares waves, given in the exemplar's components, with the exemplar.
FitError fit_error(const Exemplar& exemplar, const std::vector<Wave>& waves);

/// A texture of Gabor noise.
struct FittedNoise {
    std::vector<Wave> waves; ///< the most powerful first, with weights in components of variance 1
    noise::Colour colour;
    FitError error; ///< before correction to the exemplar's exact covariance
};

/// Fits at most `lobes` lobes: fewer if more would overfit an exemplar of that size.
///
/// Adds one lobe at a time, the one that reduces the residual of the spectra most, then refines all of them
/// by least squares. Based on [GLLD12] Galerne, Lagae, Lefebvre, Drettakis, "Gabor noise by example", 2012.
FittedNoise fit(const Exemplar& exemplar, int lobes, const Advance& advance);

/// The request for a picture of the texture, with the exemplar's size and scale.
render::Request request_of(const Exemplar& exemplar, const FittedNoise& fitted);

/// Returns one sentence for each warning: pixels that were left out, and features of the photograph that the
/// noise lacks.
std::vector<std::string> warnings(const Exemplar& exemplar, const FittedNoise& fitted);

} // namespace gabor::fit
