#pragma once

#include <array>
#include <complex>
#include <span>
#include <string_view>
#include <vector>

namespace gabor::statistics {

/// Measures spectral lines. A pattern that repeats from cell to cell of a grid has all its power at whole
/// numbers of cycles per cell. In a picture of whole cells, the spectrum at these frequencies exceeds its
/// surroundings.
class Lines {
  public:
    static constexpr int pixels_per_cell = 4;

    /// Expects pictures of `side` x `side` pixels whose first pixel is at a corner of a cell. Throws
    /// std::invalid_argument unless `side` is a multiple of 4 and at least 32.
    explicit Lines(int side);

    /// Adds the next row. After `side` rows, the next picture begins.
    void add_row(std::span<const float> row);

    /// Returns the largest ratio of the power at (1, 0), (0, 1), (1, 1), (1, -1), (1, 2) or (2, 1) cycles per
    /// cell to the mean power of the 24 frequencies around it, both averaged over the pictures. Without
    /// lines, the ratio at each frequency differs from 1 only by chance: after K pictures, K times the ratio
    /// is a gamma variable of shape K. NaN if there are no pictures.
    double largest() const;

  private:
    using Complex = std::complex<double>;
    static constexpr int reach = 2; ///< radius of the surroundings, in steps of 1 / side cycles per pixel
    static constexpr int steps = 2 * reach + 1;

    void end_picture();

    int side_;
    int row_ = 0;
    std::vector<float> cosine_; ///< cosines for steps 0 to `reach`, pixel by pixel
    std::vector<float> sine_;
    std::vector<Complex> sums_;  ///< indexed by step and pixel of a cell along y, then along x; end_picture()
                                 ///< sums over the pixels
    std::vector<double> powers_; ///< indexed by frequency, then by step along y and x
};

/// Measures the spectral lines of several functions of a noise. If the noise's mean, variance, kurtosis or
/// tails depend on the position within a cell, one of the functions has lines.
class NoiseLines {
  public:
    enum Function : std::size_t { value, square, magnitude, fourth_power, tails, count };
    /// The formula of each function of a value n.
    static constexpr std::array<std::string_view, count> names{"n", "n^2", "|n|", "n^4", "|n| > 2.5"};

    /// Expects pictures as Lines does, of a noise with variance 1.
    explicit NoiseLines(int side) : lines_(count, Lines(side)) {}
    void add_row(std::span<const float> row);

    /// Returns Lines::largest of each function, in the order of the names.
    std::array<double, count> largest() const;

  private:
    std::vector<Lines> lines_;
    std::vector<float> of_row_;
};

} // namespace gabor::statistics
