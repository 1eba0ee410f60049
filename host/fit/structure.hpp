#pragma once

#include "statistics/moments.hpp"

#include <span>
#include <vector>

namespace gabor::fit {

/// Tells pictures that have edges, lines or isolated things from those that a Gaussian texture can be: by the
/// excess kurtosis of derivatives, which is 0 for a Gaussian texture of any spectrum.
class Structure {
  public:
    explicit Structure(int width);

    /// The next row of one channel.
    void add_row(std::span<const float> row);

    /// The larger one of the derivatives along x and y.
    double excess_kurtosis() const;

    /// From here on random-phase noise has visibly lost something: grass has 1.7, gravel 2.3, bricks 17.
    static constexpr double limit = 1;

  private:
    std::vector<float> rows_[3]; ///< the last ones, the newest first
    int count_ = 0;
    statistics::Moments across_;
    statistics::Moments down_;
    std::vector<float> derivatives_;
};

} // namespace gabor::fit
