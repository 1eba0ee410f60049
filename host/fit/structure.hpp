#pragma once

#include "statistics/moments.hpp"

#include <span>
#include <vector>

namespace gabor::fit {

/// Distinguishes pictures with edges, lines or isolated objects from Gaussian textures, whose derivatives are
/// normal whatever the spectrum.
class Structure {
  public:
    explicit Structure(int width);

    /// Adds the next row of one channel. Pixels that do not count are NaN.
    void add_row(std::span<const float> row);

    /// How far derivatives are from normal: the largest of the excess kurtoses along x and y, which edges and
    /// isolated objects raise, and twice the skewness of the Laplacian, which ridges, creases and cells
    /// raise. It is 0 for a Gaussian texture or a few waves.
    double excess() const;

    /// Above this limit, noise visibly lacks the picture's structure: docs/by-example.md has examples.
    static constexpr double limit = 1;

  private:
    std::vector<float> rows_[3]; ///< the last rows of means of 2 x 2 pixels, the newest first
    std::vector<float> row_;     ///< the last row of pixels
    int count_ = 0;
    statistics::Moments across_;
    statistics::Moments down_;
    statistics::Moments laplacian_;
    std::vector<float> derivatives_;
};

} // namespace gabor::fit
