#pragma once

#include <Eigen/Core>

namespace gabor::fit {

/// Kernel radii that can be found, in pixels. Windows hardly tell wider kernels apart; of a picture radii are
/// at most half its shorter side, so that the texture can be tiled at its size.
constexpr double smallest_radius = 2;
constexpr double largest_radius = 181;

/// The autocorrelation of Hann's window h(x) = (1 + cos pi x) / 2, at most 1, at a shift of t kernel radii:
/// of the lattice's noise, averaged over the places of a cell, that along each axis, without its wave.
double kernel_correlation(double t);

/// What the estimate of a power spectrum expects along one axis of a wave of `frequency` cycles per pixel
/// under kernels of a radius in pixels, and its derivatives. At all frequencies of the grid, negative ones
/// last.
///
/// A window of weights w(p) sees a stationary noise of autocovariance C(t) as sum_t C(t) L(t) e^(-2 pi i k
/// t), with L(t) = sum_p w(p) w(p + t): sampling, aliasing and what the window spreads are all in this sum.
struct AxisAtom {
    Eigen::ArrayXd value;
    Eigen::ArrayXd by_frequency;
    Eigen::ArrayXd by_log_radius;
};
AxisAtom axis_atom(double frequency, double radius);

} // namespace gabor::fit
