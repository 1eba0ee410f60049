#include "statistics/estimate.hpp"

#include <boost/math/special_functions/erf.hpp>

#include <cmath>
#include <numbers>

namespace gabor::statistics {

Estimate score_interval(double value, double null_variance, double slope, double quantile) {
    // Solves (truth - value)^2 = quantile^2 (null_variance + slope truth) for a positive truth.
    const double null_half = quantile * std::sqrt(null_variance);
    const double shift = quantile * quantile * slope / 2;
    const double half = std::sqrt(null_half * null_half + shift * (2 * value + shift));
    const double low = value < null_half ? value - null_half : value + shift - half;
    const double high = value < -null_half ? value + null_half : value + shift + half;
    return {value, low, high};
}

double normal_density(double x) {
    return std::exp(-0.5 * x * x) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
}

double normal_cdf(double x) {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

double normal_quantile(double p) {
    using namespace boost::math::policies;
    using Quiet = policy<domain_error<ignore_error>, overflow_error<ignore_error>>;
    return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p, Quiet());
}

} // namespace gabor::statistics
