#pragma once

// A measured number with its confidence interval, and the normal distribution.

namespace gabor::statistics {

/// A measured number and the ends of its 95 % confidence interval, in the same unit.
struct Estimate {
    double value = 0;
    double low = 0;
    double high = 0;

    bool operator==(const Estimate&) const = default;
};

/// Returns the interval of a value whose variance would be null_variance + slope * max(truth, 0): every truth
/// from which the value is at most `quantile` standard deviations away (Wilson's score interval, 1927).
Estimate score_interval(double value, double null_variance, double slope, double quantile);

/// Density of the standard normal distribution.
double normal_density(double x);

/// Phi(x), the probability that a standard normal variable is at most x.
double normal_cdf(double x);

/// The x with Phi(x) = p: -inf at 0, +inf at 1, NaN outside [0, 1].
double normal_quantile(double p);

} // namespace gabor::statistics
