#pragma once

#include "statistics/moments.hpp"
#include "statistics/spread.hpp"

#include <span>
#include <vector>

namespace gabor::statistics {

/// Instance stationarity [TNVT19, 3.3, figure 4]: how the mean and the contrast, which is the variance, of
/// windows of one kernel diameter differ from window to window. Results depend on the windows and not on
/// their order, so parts merge into exactly the answer of the whole.
class Windows {
  public:
    /// All pixels of one window.
    void add(std::span<const float> window);
    void merge(const Windows& other);

    Spread contrast() const { return spread(contrasts_); }
    /// Median of the square root of the contrast.
    double deviation() const;
    /// Median of the means.
    double mean_median() const { return quantile(means_, 0.5); }
    /// From the first to the last decile of the means.
    double mean_range() const { return quantile(means_, 0.9) - quantile(means_, 0.1); }

  private:
    std::vector<double> contrasts_;
    std::vector<double> means_;
};

/// Process stationarity [TNVT19, 3.2]: the mean and the variance at each of several places of a cell, over
/// many instances. Parts merge into the answer of the whole, to rounding.
class Places {
  public:
    explicit Places(std::size_t places) : places_(places) {}

    /// The values of one instance, or of several after each other, place by place.
    void add(std::span<const float> instances);
    /// The other must have as many places.
    void merge(const Places& other);

    /// Of the variances.
    Spread variance() const;
    /// The relative interdecile that chance alone gives them, were they all the same.
    double variance_chance() const;
    /// The largest magnitude of a mean.
    double largest_mean() const;
    /// What chance alone exceeds in one case of twenty, were all means 0.
    double mean_chance() const;

  private:
    Moments all() const;

    std::vector<Moments> places_;
};

} // namespace gabor::statistics
