#pragma once

#include <vector>

namespace gabor::statistics {

/// Returns the number below which the fraction `share` of `values` lies, interpolated linearly between them.
/// Throws std::invalid_argument if `values` is empty.
double quantile(std::vector<double> values, double share);

/// The spread of positive values, "median and relative interdecile" in [TNVT19].
struct Dispersion {
    double median = 0;
    double interdecile = 0; ///< (q90 - q10) / median
};

/// Returns the median and the relative interdecile of `values`.
Dispersion dispersion(const std::vector<double>& values);

} // namespace gabor::statistics
