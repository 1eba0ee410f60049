#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace gabor::statistics {

/// Count, mean, central moments and range of a stream of values, in one pass and without cancellation.
/// Partial results can be merged.
/// Source: Pébay, "Formulas for robust, one-pass parallel computation of covariances and arbitrary-order
/// statistical moments", Sandia report SAND2008-6212, 2008, equations 1.1 to 3.1.
class Moments {
  public:
    void add(double value);
    void add(std::span<const float> values);
    void merge(const Moments& other);

    std::uint64_t count() const { return count_; }
    double mean() const { return mean_; }
    /// The population variance, which divides by the count, not by count - 1. NaN without values.
    double variance() const { return m2_ / static_cast<double>(count_); }
    /// Returns NaN if the variance is 0, as does `excess_kurtosis`.
    double skewness() const;
    /// Returns 0 for a normal distribution.
    double excess_kurtosis() const;
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

    bool operator==(const Moments&) const = default;

  private:
    std::uint64_t count_ = 0;
    double mean_ = 0;
    double m2_ = 0; ///< sum of (x - mean)^2
    double m3_ = 0; ///< sum of (x - mean)^3
    double m4_ = 0; ///< sum of (x - mean)^4
    double minimum_ = std::numeric_limits<double>::infinity();
    double maximum_ = -std::numeric_limits<double>::infinity();
};

} // namespace gabor::statistics
