#pragma once

#include "fit/spectra.hpp"

namespace gabor::fit {

/// The smallest kernel radius that a fit uses, in pixels. Noise of this radius and of frequency 0 is nearly
/// white, with a correlation of 0.03 between neighbouring pixels.
constexpr double smallest_radius = 0.75;

/// The autocorrelation of the Hann window h(x) = (1 + cos pi x) / 2 at a shift of t, scaled to 1 at t = 0.
/// Apart from the wave, lattice noise has this autocorrelation at t kernel radii along each axis, averaged
/// over a cell.
double kernel_correlation(double t);

/// The spectrum that a scale is expected to estimate is the product of a factor along x and one along y. This
/// is the factor along `axis` (0 for x, 1 for y) at all frequencies of the grid, with its derivatives, for
/// waves of `frequency` cycles per pixel under kernels of `radius` pixels.
///
/// If pixels have the autocovariance C(t), samples that average them with weights a(p) have the
/// autocovariance sum_u A(u) C(t - u), with A(u) = sum_p a(p) a(p + u). If samples have the autocovariance
/// C(t), windows with weights w(p) give, on average, the spectrum sum_t C(t) L(t) e^(-2 pi i k t), with L(t)
/// = sum_p w(p) w(p + t). This accounts for sampling, aliasing and the leakage of windows.
struct AxisSpectrum {
    Eigen::ArrayXd value;
    Eigen::ArrayXd by_frequency;
    Eigen::ArrayXd by_log_radius;
};
AxisSpectrum axis_spectrum(const SpectrumScale& scale, int axis, double frequency, double radius,
                           bool with_derivatives);

/// Returns a scale's expected estimate of the complex autocovariance of samples along an axis, at lags 0 ...
/// scale.lags() - 1: the inverse transform of `AxisSpectrum::value`.
Eigen::ArrayXcd axis_autocovariance(const SpectrumScale& scale, int axis, double frequency, double radius);

} // namespace gabor::fit
