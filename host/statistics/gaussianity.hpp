#pragma once

#include "statistics/estimate.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::statistics {

/// Cramér-von Mises indices are 2^18 times the integral of (F - Phi)^2 dPhi: what is expected of the
/// Cramér-von Mises statistic, less its 1/6, when it is taken from 2^18 independent samples.
constexpr double cvm_scale = 1 << 18;

/// An empirical distribution function is kept as the counts of samples in bins that are uniform in
/// u = Phi((x - mean) / deviation): integers, so that merging is exact in any order.
using Counts = std::vector<std::uint64_t>;

/// Counts `values` into the bins of `counts`. Values beyond eight deviations, infinite ones too, go to the
/// outermost bins. Throws std::domain_error at a NaN.
void count_uniform(std::span<const float> values, double mean, double deviation,
                   std::span<std::uint64_t> counts);

/// n (F(u_k) - u_k) at the upper edges u_k = (k + 1) / bins of the bins, F being the empirical distribution
/// function: exact there, whatever the width of the bins.
std::vector<double> deviations(std::span<const std::uint64_t> counts);

/// The integral over u in [0, 1] of the product of two functions given at the upper edges of uniform bins,
/// at least one of which vanishes at 0 and 1 (trapezium rule).
double integrate_product(std::span<const double> a, std::span<const double> b);

/// How far the distribution of independent samples is from a normal one of mean 0 and known standard
/// deviation.
///
/// From n samples, T = 1 / (12 n) + sum_i ((2 i - 1) / (2 n) - Phi(x_(i)))^2, and the index is
/// 2^18 (T - 1/6) / n: its expectation does not depend on n, and is 0 for a
/// normal distribution.
class Gaussianity {
  public:
    /// `deviation`: the standard deviation that theory predicts, in the unit of the samples.
    explicit Gaussianity(double deviation = 1);

    /// Throws std::domain_error at a NaN.
    void add(double value);
    void add(std::span<const float> values);
    /// Counts are in units of each one's own deviation, so the two deviations need not agree.
    void merge(const Gaussianity& other);

    std::uint64_t count() const;

    /// The index and its interval; the ends, like the value, may be negative. NaN without samples.
    /// `deviation`: that of the normal distribution to compare with, where only the samples tell it: in units
    /// of the predicted one, not much larger than 1 and not much smaller than 0.1, or bins are too coarse.
    Estimate index(double deviation = 1) const;

  private:
    double deviation_;
    Counts counts_;
};

} // namespace gabor::statistics
