#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::statistics {

/// A measured number and the ends of its 95 % confidence interval, in the same unit.
struct Estimate {
    double value = 0;
    double low = 0;
    double high = 0;

    bool operator==(const Estimate&) const = default;
};

/// A Cramér-von Mises index is 2^18 times the integral of (F - Phi)^2 dPhi: the expected Cramér-von Mises
/// statistic of 2^18 independent samples, minus 1/6, its expectation for normal samples.
constexpr double cvm_scale = 1 << 18;

/// Distance of independent samples from a normal distribution with mean 0 and known standard deviation.
///
/// From n samples, T = 1 / (12 n) + sum_i ((2 i - 1) / (2 n) - Phi(x_(i)))^2, and the index is
/// 2^18 (T - 1/6) / n: its expectation does not depend on n, and is 0 for a normal distribution.
class Gaussianity {
  public:
    /// `deviation` is the standard deviation that theory predicts, in the unit of the samples.
    explicit Gaussianity(double deviation = 1);

    /// Throws std::domain_error for NaN. Values beyond eight standard deviations, even infinite ones, count
    /// as that far away.
    void add(double value);
    void add(std::span<const float> values);
    /// Merges counts, exactly and in any order. Each object counts in units of its own deviation, so the two
    /// deviations may differ.
    void merge(const Gaussianity& other);

    std::uint64_t count() const;

    /// Returns the index and its interval; both may be negative, and are NaN without samples. To compare the
    /// samples with a normal distribution that has another deviation, such as their own, pass `deviation` in
    /// units of the predicted one. The bins are too coarse for deviations much above 1 or much below 0.1.
    Estimate index(double deviation = 1) const;

  private:
    double deviation_;
    std::vector<std::uint64_t> counts_; ///< in bins that are uniform in Phi(x / deviation)
};

} // namespace gabor::statistics
