#pragma once

#include "statistics/estimate.hpp"
#include "statistics/moments.hpp"

#include <span>
#include <vector>

namespace gabor::statistics {

/// Instance stationarity [TNVT19, 3.3, figure 4]: how the contrast, which is the variance, of
/// windows, of one kernel diameter in the paper, differ from window to window. Results depend on the windows
/// and not on their order, so parts merge into exactly the answer of the whole.
class InstanceStationarity {
  public:
    /// All pixels of one window.
    void add(std::span<const float> window);
    void merge(const InstanceStationarity& other);

    Dispersion contrast() const { return dispersion(contrasts_); }
    /// Median of the square root of the contrast.
    double median_deviation() const;

  private:
    std::vector<double> contrasts_;
};

/// Process stationarity [TNVT19, 3.2]: the mean and the variance at each of several places of a cell, over
/// many instances. Parts merge into the answer of the whole, to rounding.
class ProcessStationarity {
  public:
    explicit ProcessStationarity(std::size_t places) : places_(places) {}

    /// The values of one instance, or of several after each other, place by place.
    void add(std::span<const float> instances);
    /// The other must have as many places.
    void merge(const ProcessStationarity& other);

    /// Of the variances.
    Dispersion variance() const;
    /// The relative interdecile that the variances would show by chance, were they all the same.
    double chance_interdecile() const;
    /// The largest magnitude of a mean.
    double largest_mean() const;
    /// What the largest mean would exceed by chance in one case of twenty, were all means 0.
    double chance_largest_mean() const;

  private:
    Moments all() const;

    std::vector<Moments> places_;
};

} // namespace gabor::statistics
