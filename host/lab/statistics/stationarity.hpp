#pragma once

#include "statistics/moments.hpp"
#include "statistics/quantile.hpp"

#include <span>
#include <vector>

namespace gabor::statistics {

/// Instance stationarity [TNVT19, 3.3, figure 4]: how much the contrast, that is the variance, differs
/// between windows (of one kernel diameter in the paper). Results do not depend on the order of the windows.
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

/// Process stationarity [TNVT19, 3.2]: the mean and the variance at each of several places of a cell, over
/// many instances, as many at each place.
class ProcessStationarity {
  public:
    /// Adds the values at one more place.
    void add(const Moments& place) { places_.push_back(place); }

    const std::vector<Moments>& places() const { return places_; }
    /// Median and relative interdecile of the variances.
    Dispersion variance() const;
    /// The relative interdecile that equal variances would show by chance.
    double chance_interdecile() const;
    /// The largest magnitude of a mean.
    double largest_mean() const;
    /// The value that the largest mean would exceed by chance in one case of twenty if all means were 0.
    double chance_largest_mean() const;

  private:
    Moments all() const;

    std::vector<Moments> places_;
};

} // namespace gabor::statistics
