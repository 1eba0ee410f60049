#pragma once

namespace gabor::statistics {

/// Density of the standard normal law.
double normal_density(double x);

/// Phi(x), the probability that a standard normal variable is at most x.
double normal_cdf(double x);

/// The x with Phi(x) = p, to about 1e-15 relative. -inf at 0, +inf at 1, NaN outside [0, 1].
/// Source: Abramowitz and Stegun, 26.2.23 (error below 4.5e-4), then two steps of Halley's method.
double normal_quantile(double p);

} // namespace gabor::statistics
