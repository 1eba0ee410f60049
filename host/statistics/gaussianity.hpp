#pragma once

#include "statistics/edf.hpp"
#include "statistics/estimate.hpp"

#include <cstdint>
#include <span>

namespace gabor::statistics {

/// Cramér-von Mises indices are 2^18 times the integral of (F - Phi)^2 dPhi: what is expected of the
/// Cramér-von Mises statistic, less its 1/6, when it is taken from 2^18 independent samples.
constexpr double cvm_scale = 1 << 18;

/// How far the law of independent samples is from a normal law of mean 0 and known standard deviation.
///
/// From n samples, T = 1 / (12 n) + sum_i ((2 i - 1) / (2 n) - Phi(x_(i)))^2, and the index is
/// 2^18 (T - 1/6) / n: its expectation does not depend on n, and is 0 for a normal law.
class Gaussianity {
  public:
    /// `deviation`: the standard deviation that theory predicts, in the unit of the samples.
    explicit Gaussianity(double deviation = 1);

    /// Continues from the counts of another. Throws std::invalid_argument when their number is wrong.
    Gaussianity(double deviation, Counts counts);

    /// Throws std::domain_error at a NaN.
    void add(double value);
    void add(std::span<const float> values);
    /// Counts are in units of each one's own deviation, so the two deviations need not agree.
    void merge(const Gaussianity& other);

    std::uint64_t count() const;
    const Counts& counts() const { return counts_; }

    /// The index and its interval; the ends, like the value, may be negative. NaN without samples.
    Estimate index() const;

  private:
    double deviation_;
    Counts counts_;
};

} // namespace gabor::statistics
