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

/// Windows of one size, and the frequencies at which their estimate is compared with a model. SpectrumScales
/// after the first keep only frequencies of long waves and those near peaks that smaller windows cannot
/// resolve.
struct SpectrumScale {
    int spacing;     ///< pixels from one sample to the next: 1, 4, 16 ...; samples are averages
    int window;      ///< samples along each axis
    int grid;        ///< frequency k is k / grid cycles per sample, negative ones last
    double area = 1; ///< area of a frequency's cell, relative to the first scale
    /// n / (n + 100) for an estimate from n independent windows: its squared relative error is 1 / n, and the
    /// error of a sum of few lobes, about a tenth, adds 1 / 100 anyway.
    double confidence = 1;
    /// x goes from 0 to grid / 2. Frequencies at either end occur once in the whole plane; the others also
    /// represent their opposites.
    struct Frequency {
        int x;
        int y;
        double multiplicity;
    };
    std::vector<Frequency> frequencies = {};
    Eigen::Index begin = 0; ///< row of the first frequency in Spectra

    /// Along x and y: sum_p w(p) w(p + t) for t = 0 ... window - 1, relative to t = 0. Only the parts of the
    /// windows within the picture count.
    std::array<Eigen::ArrayXd, 2> lag_window = {};
    Eigen::ArrayXd averaging = {}; ///< sum_p a(p) a(p + t) for the weights a of pixels in a sample
    Eigen::MatrixXd cosine = {};   ///< cosine of 2 pi k t / grid: row k for a frequency, column t for a lag
    Eigen::MatrixXd sine = {};

    /// The longest waves that fit a window, in pixels.
    int length() const { return spacing * window; }
    /// The number of lags along an axis at which autocovariances are compared: 0, 1, 2 ... samples.
    Eigen::Index lags() const { return window / 2 + 1; }
};
using SpectrumScales = std::shared_ptr<const std::vector<SpectrumScale>>;

/// The scale of the smallest windows alone, at all frequencies of a grid of twice their side, so that lags do
/// not wrap around.
const SpectrumScales& first_scale();

/// The scales for a picture of this size, the smallest windows first, each with all its frequencies. The
/// largest windows are at most half as long as the picture's shorter side.
std::vector<SpectrumScale> scales_of(int width, int height);

/// A stored entry of a Hermitian matrix of channels: the real part of (c, d) for c <= d, or the imaginary
/// part for c < d.
struct MatrixEntry {
    int c;
    int d;
    bool imaginary;
};
/// All stored entries, the real parts first.
std::vector<MatrixEntry> entries(int channels);
constexpr Eigen::Index real_entries(int channels) {
    return channels * (channels + 1) / 2;
}

/// The matrix of the channels' cross-spectra at each frequency of each scale, P(c, d) = E[X_c X_d*], as a
/// density per (cycle per pixel)^2. Values have a row for each frequency and a column for each entry.
/// Opposite frequencies have conjugate matrices.
struct Spectra {
    int channels = 0;
    SpectrumScales scales;
    Eigen::MatrixXd values;

    /// Sets all spectra to 0.
    explicit Spectra(int channels, const SpectrumScales& scales = first_scale());
    /// The covariance of the channels: the integral of their spectra over the first scale.
    Eigen::MatrixXd covariance() const;
    /// Returns the spectra of the channels after this linear map.
    Spectra mapped(const Eigen::MatrixXd& map) const;
};

/// The sum of the channels' power spectra, each times its weight, from the columns of Spectra.
Eigen::ArrayXd total(const Eigen::MatrixXd& values, const Eigen::VectorXd& weights);

/// The autocovariance summed over channels, as windows of a scale see it: multiplied by their `lag_window`.
struct Autocovariance {
    Eigen::MatrixXd forward;  ///< at lags (x, y) of samples, in column x and row y
    Eigen::MatrixXd backward; ///< at lags (-x, y)
};

/// The weight of each row of Spectra in an integral over its scale, in cells of the first scale.
Eigen::ArrayXd measures(const std::vector<SpectrumScale>& scales);

/// Estimates the spectra of a picture, row by row, by Welch's method [Welch 1967] on every scale. Windows
/// extend beyond the picture's edges by half their side, so that all pixels count equally. Keeps only one
/// window's rows in memory.
class SpectraEstimate {
  public:
    /// Width and height must be at least `window_side` pixels.
    SpectraEstimate(int width, int height, int channels);
    ~SpectraEstimate();

    /// Adds the next row, channels interleaved, with 0 for missing pixels. `seen` is 1 or 0 for each pixel:
    /// windows in which less than nine tenths of the pixels are seen are left out.
    void add_row(std::span<const float> row, std::span<const float> seen);

    /// Returns the spectra; call it after the last row. SpectrumScales without windows are left out. Throws
    /// RequestError if none is left.
    Spectra spectra() const;
    /// Returns the autocovariance on each scale of `spectra`, summed over channels with these weights.
    std::vector<Autocovariance> autocovariances(const Eigen::VectorXd& weights) const;

  private:
    class Welch;
    class Decimation;
    int channels_;
    std::vector<SpectrumScale> scales_;
    std::vector<Welch> estimates_;        ///< one for each scale
    std::vector<Decimation> decimations_; ///< the picture at a quarter of its size, at a sixteenth ...
};

} // namespace gabor::fit
