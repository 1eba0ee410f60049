#pragma once

#include "statistics/moments.hpp"
#include "statistics/quantile.hpp"

#include <span>
#include <vector>

namespace gabor::statistics {

/// Instance stationarity [TNVT19, 3.3, figure 4]: how the contrast (variance) varies from window to window;
/// in the paper, windows are one kernel diameter wide. Results do not depend on the order of the windows.
class InstanceStationarity {
  public:
    /// Adds all pixels of one window.
    void add(std::span<const float> window);

    Dispersion contrast() const { return dispersion(contrasts_); }
    /// Median of the square root of the contrast.
    double median_deviation() const;

  private:
    std::vector<double> contrasts_;
};

/// Process stationarity [TNVT19, 3.2]: the mean and the variance at each of several positions in a cell, over
/// equally many instances.
class ProcessStationarity {
  public:
    /// Adds the values at one more position.
    void add(const Moments& place) { places_.push_back(place); }

    const std::vector<Moments>& places() const { return places_; }
    /// The dispersion of the variances.
    Dispersion variance() const;
    /// The relative interdecile that equal variances would show by chance.
    double chance_interdecile() const;
    /// The largest magnitude of a mean.
    double largest_mean() const;
    /// The bound that the largest mean exceeds by chance in one case out of twenty if all means are 0.
    double chance_largest_mean() const;

  private:
    Moments all() const;

    std::vector<Moments> places_;
};

} // namespace gabor::statistics
