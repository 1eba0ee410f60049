#pragma once

#include <vector>

namespace gabor::statistics {

/// How much positive numbers differ: [TNVT19] has it as "median and relative interdecile".
struct Spread {
    double median = 0;
    double interdecile = 0; ///< (q90 - q10) / median
};

/// The number below which a share of `values` lies, interpolated linearly between order statistics.
/// Throws std::invalid_argument without values.
double quantile(std::vector<double> values, double share);

Spread spread(const std::vector<double>& values);

} // namespace gabor::statistics
