#pragma once

#include "fit/spectra.hpp"

namespace gabor::fit {

/// The smallest kernel radius that a fit can find, in pixels: at frequency 0 its noise is nearly white, with
/// a correlation of 0.03 between neighbouring pixels.
constexpr double smallest_radius = 0.75;

/// The autocorrelation of Hann's window h(x) = (1 + cos pi x) / 2, at most 1, at a shift of t kernel radii:
/// the autocorrelation of the lattice's noise along each axis, averaged over a cell, without its wave.
double kernel_correlation(double t);

/// Returns what a scale's estimate is on average, and its derivatives, at all frequencies of the grid along
/// `axis`, 0 for x and 1 for y. The noise has waves of `frequency` cycles per pixel under kernels of `radius`
/// pixels.
///
/// Averages of weights a(p) give samples the autocovariance sum_u A(u) C(t - u), with A(u) = sum_p a(p) a(p +
/// u), and windows of weights w(p) see a stationary noise of autocovariance C(t) as sum_t C(t) L(t) e^(-2 pi
/// i k t), with L(t) = sum_p w(p) w(p + t): this sum includes sampling, aliasing and the leakage of windows.
struct AxisAtom {
    Eigen::ArrayXd value;
    Eigen::ArrayXd by_frequency;
    Eigen::ArrayXd by_log_radius;
};
AxisAtom axis_atom(const Scale& scale, int axis, double frequency, double radius, bool with_derivatives);

/// Returns the complex autocovariance of samples along an axis, as a scale's estimate sees it on average, at
/// lags 0 ... scale.lags() - 1: the inverse transform of `AxisAtom::value`.
Eigen::ArrayXcd axis_autocovariance(const Scale& scale, int axis, double frequency, double radius);

} // namespace gabor::fit
