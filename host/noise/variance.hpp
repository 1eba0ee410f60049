#pragma once

#include "noise/recipe.hpp"

namespace gabor::noise {

/// J(a) = integral over [-1, 1] of q(x)^2 cos(a x) dx for the recipe's window q.
double window_energy(const Recipe& recipe, double a);

/// Returns the variance of sum_i w_i q(d.x) q(d.y) sin(2 pi (F d.omega + phase_i)) by Campbell's theorem: the
/// number of impulses per unit area times E[w^2] times the mean energy of the kernels. `frequency` is in
/// cycles per kernel radius, `orientation` in radians, and `time` in periods of the animation, in which
/// phases turn 1 to 4 times either way.
double variance(const Recipe& recipe, double frequency, double orientation, double time = 0);

/// The integral of h'^2 over the integral of h^2 for a lattice's window, per kernel radius squared. The
/// variance of the noise's derivative along x is this plus (2 pi F.x)^2. With `lattice-2` that variance
/// depends on the position, and the sum is its mean over all positions.
double window_slope_energy(const Recipe& lattice);

/// Variances of a wave of the three-tap lattice along one axis.
struct AxisVariance {
    double noise;
    double slope; ///< variance of the slope, per kernel radius squared
};

/// Returns the variances after a Gaussian filter. `frequency` is in cycles per kernel radius along the axis;
/// `deviation` is the filter's standard deviation, at most a kernel radius.
AxisVariance filtered_variance(double frequency, double deviation);

} // namespace gabor::noise
