#pragma once

#include "statistics/segments.hpp"
#include "statistics/transform.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace gabor::fit {

/// Windows of the power spectrum's estimate, in pixels, and the grid of frequencies that it is on: twice as
/// many, so that the lags of a window do not wrap around.
constexpr int window_side = 64;
constexpr int grid_side = 2 * window_side;
/// Columns: frequencies of x from 0 to half a cycle per pixel. Those of y are all there, negative ones last.
constexpr int grid_columns = grid_side / 2 + 1;
constexpr int grid_size = grid_side * grid_columns;

/// Hann's window for a side of `window_side` pixels, with squares that add up to 1.
const Eigen::ArrayXd& hann_window();

/// How many frequencies of the whole plane each of the grid stands for: 2, for it has an opposite one, or 1
/// in the first and the last column, where that is in the grid itself.
const Eigen::ArrayXd& multiplicities();

/// Where the parts of a Hermitian matrix of channels are kept: Re(c, d) for c <= d, and Im(c, d) for c < d.
struct Pair {
    int c;
    int d;
};
std::vector<Pair> real_pairs(int channels);
std::vector<Pair> imaginary_pairs(int channels);

/// The matrix of the channels' cross-spectra at each frequency, P(c, d) = E[X_c X_d*]: one column for each
/// pair, row ky * grid_columns + kx. Those of a frequency and of its opposite are conjugate.
struct Spectra {
    int channels = 0;
    Eigen::MatrixXd real;
    Eigen::MatrixXd imaginary;

    /// Zeros.
    explicit Spectra(int channels);
    /// The sum of the channels' power spectra.
    Eigen::ArrayXd total() const;
    /// The covariance of the channels: their integral.
    Eigen::MatrixXd covariance() const;
    /// Of the channels under this linear map.
    Spectra mapped(const Eigen::MatrixXd& map) const;
};

/// An estimate of the spectra of a picture that passes by row after row, by Welch's method [Welch 1967]:
/// windows 16 pixels apart, or 64 along each axis of a larger picture. Holds as many rows as a window has.
class SpectraEstimate {
  public:
    /// At least `window_side` pixels each way.
    SpectraEstimate(int width, int height, int channels);

    /// The next row, the channels of each pixel side by side.
    void add_row(std::span<const float> row);

    /// Call after the last row.
    Spectra spectra() const;

  private:
    void add_window(int left);

    statistics::Segments segments_;
    std::vector<float> window_; ///< the rest of the grid stays 0
    statistics::Transform transform_;
    std::vector<Eigen::ArrayXcf> transformed_; ///< of each channel
    Spectra sum_;
};

} // namespace gabor::fit
