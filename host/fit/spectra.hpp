#pragma once

#include "statistics/segments.hpp"
#include "statistics/transform.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace gabor::fit {

/// The side of the smallest windows that spectra are estimated with, in pixels.
constexpr int window_side = 64;

/// Windows of one size, and the frequencies at which their estimate is compared with a model. All scales but
/// the first have those of long waves, and those near peaks that smaller windows cannot resolve.
struct Scale {
    int spacing;     ///< pixels from one sample to the next: 1, 4, 16 ... by averages over twice as many
    int window;      ///< samples along each axis
    int grid;        ///< frequency k is k / grid cycles per sample, negative ones last
    double area = 1; ///< of a frequency's cell, relative to the first scale's
    /// n / (n + 100) for an estimate from n independent windows: its squared error is 1 / n, and a sum of few
    /// lobes misses a tenth of the power anyway.
    double confidence = 1;
    /// x from 0 to grid / 2. Those at its ends are in the whole plane once, the others stand for their
    /// opposite too.
    struct Frequency {
        int x;
        int y;
        double multiplicity;
    };
    std::vector<Frequency> frequencies = {};
    Eigen::Index begin = 0; ///< the row of the first of them in Spectra

    /// Along x and y: sum_p w(p) w(p + t) for t = 0 ... window - 1, as much as there is of the windows in the
    /// picture, as a share of that for 0.
    std::array<Eigen::ArrayXd, 2> lag_window = {};
    Eigen::ArrayXd averaging = {}; ///< the same of the averages' weights, in pixels, once
    Eigen::MatrixXd cosine = {};   ///< of 2 pi k t / grid: a row for each frequency, a column for each lag
    Eigen::MatrixXd sine = {};

    /// The longest waves that fit a window, in pixels.
    int length() const { return spacing * window; }
    /// Lags of samples along an axis that its autocovariances are compared at: 0 ... this - 1.
    Eigen::Index lags() const { return window / 2 + 1; }
};
using Scales = std::shared_ptr<const std::vector<Scale>>;

/// The scale of the smallest windows alone, at all frequencies of a grid of twice their side, so that lags do
/// not wrap around.
const Scales& first_scale();

/// The scales that a picture of this size has, the smallest windows first, each with all its frequencies. The
/// largest windows are half as long as its shorter side.
std::vector<Scale> scales_of(int width, int height);

/// Where the parts of a Hermitian matrix of channels are kept: Re(c, d) for c <= d, and Im(c, d) for c < d.
struct Pair {
    int c;
    int d;
};
std::vector<Pair> real_pairs(int channels);
std::vector<Pair> imaginary_pairs(int channels);

/// The matrix of the channels' cross-spectra at each frequency of each scale, P(c, d) = E[X_c X_d*], per
/// cycle per pixel along each axis: one column for each pair. Those of a frequency and of its opposite are
/// conjugate.
struct Spectra {
    int channels = 0;
    Scales scales;
    Eigen::MatrixXd real;
    Eigen::MatrixXd imaginary;

    /// Zeros.
    explicit Spectra(int channels, const Scales& scales = first_scale());
    /// The sum of the channels' power spectra.
    Eigen::ArrayXd total() const;
    /// The covariance of the channels: their integral over the first scale.
    Eigen::MatrixXd covariance() const;
    /// Of the channels under this linear map.
    Spectra mapped(const Eigen::MatrixXd& map) const;
};

/// The autocovariance of all channels together as the windows of a scale see it, each lag weighed by theirs.
struct Autocovariance {
    Eigen::MatrixXd forward;  ///< at lags (x, y) of samples, in column x and row y
    Eigen::MatrixXd backward; ///< at (-x, y)
};

/// What each row of Spectra counts in an integral over its scale, in cells of the first scale.
Eigen::ArrayXd measures(const std::vector<Scale>& scales);

/// An estimate of the spectra of a picture that passes by row after row, by Welch's method [Welch 1967] on
/// every scale. Windows reach over the picture's edges by half of their side, so that all of its pixels count
/// alike. Holds as many rows as windows have.
class SpectraEstimate {
  public:
    /// At least `window_side` pixels each way.
    SpectraEstimate(int width, int height, int channels);
    ~SpectraEstimate();
    SpectraEstimate(SpectraEstimate&&) noexcept;

    /// The next row, the channels of each pixel side by side, 0 where there is nothing to be seen. `seen` is
    /// 1 or 0 for each pixel: windows that see less than nine tenths are left out.
    void add_row(std::span<const float> row, std::span<const float> seen);

    /// Call after the last row. Scales without windows are left out. Throws RequestError where nothing is
    /// left.
    Spectra spectra() const;
    /// For each of their scales, with a weight for each channel.
    std::vector<Autocovariance> autocovariances(const Eigen::VectorXd& weights) const;

  private:
    class Welch;
    class Decimation;
    int channels_;
    std::vector<Scale> scales_;
    std::vector<Welch> estimates_;        ///< one for each scale
    std::vector<Decimation> decimations_; ///< the picture at a quarter of its size, at a sixteenth ...
};

} // namespace gabor::fit
