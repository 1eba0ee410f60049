#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace gabor::statistics {

/// Count, mean, central moments and range of a stream of values, in one pass and without cancellation.
/// Partial results merge.
/// Source: Pébay, "Formulas for robust, one-pass parallel computation of covariances and arbitrary-order
/// statistical moments", Sandia report SAND2008-6212, 2008, equations 1.1 to 3.1.
class Moments {
  public:
    Moments() = default;

    void add(double value);
    void add(std::span<const float> values);
    void merge(const Moments& other);

    std::uint64_t count() const { return state_.count; }
    double mean() const { return state_.mean; }
    /// The population variance, divided by the count. NaN without values.
    double variance() const { return state_.m2 / static_cast<double>(state_.count); }
    /// Sum of (x - mean)^2; 0 without values.
    double squared_deviations() const { return state_.m2; }
    /// Returns NaN if the variance is 0, as does `excess_kurtosis`.
    double skewness() const;
    /// Returns 0 for a normal distribution.
    double excess_kurtosis() const;
    double minimum() const { return state_.minimum; }
    double maximum() const { return state_.maximum; }

    bool operator==(const Moments&) const = default;

  private:
    struct State {
        std::uint64_t count = 0;
        double mean = 0;
        double m2 = 0; ///< sum of (x - mean)^2
        double m3 = 0; ///< sum of (x - mean)^3
        double m4 = 0; ///< sum of (x - mean)^4
        double minimum = std::numeric_limits<double>::infinity();
        double maximum = -std::numeric_limits<double>::infinity();

        bool operator==(const State&) const = default;
    };

    explicit Moments(const State& state) : state_(state) {}

    State state_;
};

} // namespace gabor::statistics
