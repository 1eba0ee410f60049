#pragma once

#include "fit/spectra.hpp"

#include <Eigen/Core>

namespace gabor::fit {

/// Lags up to which autocorrelations are compared.
constexpr int furthest_lag = 32;

/// How far a model's spectra are from an estimate.
struct FitError {
    double l1 = 0; ///< sum of |model - estimate| of the total power, relative to the sum of the estimate
    double l2 = 0; ///< root of the sum of squares over all cross-spectra, relative likewise
    double autocorrelation = 0; ///< largest difference up to `furthest_lag` pixels along x and y
};
FitError compare(const Spectra& estimate, const Spectra& model);

/// The autocorrelation of the channels together at lags from -furthest_lag to furthest_lag: a row for each of
/// y.
Eigen::MatrixXd autocorrelation(const Spectra& spectra);

} // namespace gabor::fit
