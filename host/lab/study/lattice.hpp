#pragma once

#include <array>

namespace gabor::study {

/// Returns the window of a node of shaders/gabor_noise.glsl along one axis, x kernel radii from the node:
/// Hann's, or for two taps c / sqrt(c^2 + (1 - c)^2) with c = (1 - |x|)^2 (1 + 2 |x|). The squared windows of
/// the two nodes sum to 1.
double lattice_window(int taps, double x);

/// The covariance of two values a lag apart without the wave: the sum of the products of their windows.
/// Differences are taken over the positions in a cell for which the two values are in different cells.
struct CovarianceOverCell {
    double mean = 0;    ///< mean over the whole cell
    double rms = 0;     ///< root mean square difference from the mean
    double largest = 0; ///< largest difference from the mean
};

/// Computes the covariance at `side` x `side` positions, the first at the corner of the cell. `lag` is in
/// kernel radii.
CovarianceOverCell lattice_covariance(int taps, const std::array<double, 2>& lag, int side);

} // namespace gabor::study
