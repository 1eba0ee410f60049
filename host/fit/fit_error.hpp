#pragma once

#include "fit/exemplar.hpp"
#include "fit/levenberg.hpp"

namespace gabor::fit {

/// How far a sum of waves is from an exemplar.
struct FitError {
    double l1 = 0;  ///< sum of |model - estimate| over the total power spectrum in windows of 64 pixels,
                    ///< relative to the estimate
    double l2 = 0;  ///< root of the sum of squared differences of all cross-spectra, relative to the estimate
    double low = 0; ///< l1 for waves longer than 64 pixels, in the largest windows; 0 if none are larger
    int furthest_lag = 0;       ///< largest lag compared, in pixels: about a quarter of the shorter side
    double autocorrelation = 0; ///< largest difference between autocorrelations up to that lag
    double chance = 0;          ///< standard error of an autocorrelation that is estimated from this exemplar
};

/// Compares waves, given in the exemplar's components, with the exemplar.
FitError fit_error(const Exemplar& exemplar, const std::vector<Wave>& waves);

} // namespace gabor::fit
