#include "statistics/estimate.hpp"

#include <cmath>

namespace gabor::statistics {

Estimate score_interval(double value, double null_variance, double slope, double quantile) {
    // (truth - value)^2 = quantile^2 (null_variance + slope truth), where that truth is positive.
    const double null_half = quantile * std::sqrt(null_variance);
    const double shift = quantile * quantile * slope / 2;
    const double half = std::sqrt(null_half * null_half + shift * (2 * value + shift));
    const double low = value < null_half ? value - null_half : value + shift - half;
    const double high = value < -null_half ? value + null_half : value + shift + half;
    return {value, low, high};
}

} // namespace gabor::statistics
