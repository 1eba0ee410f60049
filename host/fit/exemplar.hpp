#pragma once

#include "fit/spectra.hpp"
#include "fit/structure.hpp"
#include "fit/trend.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace gabor::fit {

/// Called with the share of the work done, from 0 to 1. Throwing an exception ends the work.
using Advance = std::function<void(double)>;

/// The smallest width and height of a picture that can be fitted, in pixels.
constexpr int least_side = 2 * window_side;

/// Counts values of variance about 1, to estimate their distribution.
class Histogram {
  public:
    void add(float value);

    /// Returns the coefficients of 1, z, ... z^5 of an increasing polynomial. It maps the standard normal
    /// distribution to the distribution of the values as closely as is possible with mean 0 and variance 1.
    ///
    /// The Hermite polynomials He_n are orthogonal under the normal distribution, so the polynomial nearest
    /// to the quantiles Q(z) has the coefficients a_n = E[Q(z) He_n(z)] / n!. Truncated at degree 5, it may
    /// fall in places. The coefficients a_n t^(n - 1), t <= 1, smooth it with a normal filter (Mehler's
    /// formula), and it rises everywhere once t is small enough.
    std::array<double, 6> polynomial() const;

  private:
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(4096);
};

/// What a fit needs to know about a photograph. Spectra, histograms and structure are those of its principal
/// components, scaled to variance 1, without the quadratic trend.
struct Exemplar {
    int width = 0;
    int height = 0;
    int channels = 0;       ///< 1 if red, green and blue are equal everywhere
    std::string profile;    ///< name of the ICC profile, unless its colours are sRGB's
    bool linear = false;    ///< whether values are linear light, as in OpenEXR, instead of sRGB
    double transparent = 0; ///< share of the pixels left out because they are more transparent than opaque
    double fireflies = 0;   ///< share of the pixels left out because they are far brighter than all others
    Trend trend;            ///< trend of each channel
    Eigen::VectorXd mean;   ///< mean of each channel
    /// One column per component, with its standard deviation as norm: channels = mean + components * values.
    Eigen::MatrixXd components;
    Spectra spectra{1};                          ///< spectra of the components
    std::vector<Autocovariance> autocovariances; ///< sums over the channels, one for each scale
    std::vector<Histogram> histograms;           ///< histogram of each component
    double structure = 0;                        ///< Structure::excess of the first component
};

/// Reads the file twice, or three times if it has fireflies, and keeps only one window's rows in memory,
/// unless EXIF data turn the photograph.
/// Throws RequestError if the file cannot be read, or if the picture is too small, transparent or constant,
/// or has a value that is not finite.
Exemplar read_exemplar(const std::filesystem::path& path, const Advance& advance);

} // namespace gabor::fit
