#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace gabor::statistics {

/// Count, mean, central moments and range of a stream of values, in one pass and without cancellation.
/// Partial results merge, and `State` is plain numbers, so that a study can be spread over machines.
/// Source: Pébay, "Formulas for robust, one-pass parallel computation of covariances and arbitrary-order
/// statistical moments", Sandia report SAND2008-6212, 2008, equations 1.1 to 3.1.
class Moments {
  public:
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

    Moments() = default;
    explicit Moments(const State& state) : state_(state) {}

    void add(double value);
    void add(std::span<const float> values);
    void merge(const Moments& other);

    std::uint64_t count() const { return state_.count; }
    double mean() const { return state_.mean; }
    /// Of the population: divided by count. NaN without values.
    double variance() const { return state_.m2 / static_cast<double>(state_.count); }
    /// NaN where the variance is 0, as is the kurtosis.
    double skewness() const;
    /// 0 for a normal distribution.
    double excess_kurtosis() const;
    double minimum() const { return state_.minimum; }
    double maximum() const { return state_.maximum; }

    const State& state() const { return state_; }
    bool operator==(const Moments&) const = default;

  private:
    State state_;
};

} // namespace gabor::statistics
