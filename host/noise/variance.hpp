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

/// Variances of a wave of the lattice along one axis.
struct AxisVariance {
    double noise;
    double slope; ///< variance of the slope, per kernel radius squared
};

/// Returns the variances after a Gaussian filter. `frequency` is in cycles per kernel radius along the axis;
/// `deviation` is the filter's standard deviation, at most a kernel radius.
AxisVariance filtered_variance(double frequency, double deviation);

} // namespace gabor::noise
