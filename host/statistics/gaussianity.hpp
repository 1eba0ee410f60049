#pragma once

#include "statistics/estimate.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::statistics {

/// A Cramér-von Mises index is 2^18 times the integral of (F - Phi)^2 dPhi: the expected Cramér-von Mises
/// statistic of 2^18 independent samples, minus 1/6, its expectation for normal samples.
constexpr double cvm_scale = 1 << 18;

/// An empirical distribution function is stored as counts of samples in bins that are uniform in u = Phi((x -
/// mean) / deviation). Counts are integers, so merging is exact in any order.
using Counts = std::vector<std::uint64_t>;

/// Adds `from` to `into`, element by element.
template <typename Values>
void add_to(Values& into, const Values& from) {
    for (std::size_t i = 0; i < from.size(); ++i)
        into[i] += from[i];
}

/// Counts `values` into the bins of `counts`. Values beyond eight standard deviations, even infinite ones, go
/// to the outermost bins. Throws std::domain_error for NaN.
void count_uniform(std::span<const float> values, double mean, double deviation,
                   std::span<std::uint64_t> counts);

/// Returns n (F(u_k) - u_k) at the upper edges u_k = (k + 1) / bins of the bins, where F is the empirical
/// distribution function. These values are exact, whatever the width of the bins.
std::vector<double> deviations(std::span<const std::uint64_t> counts);

/// The integral over u in [0, 1] of the product of two functions given at the upper edges of uniform bins,
/// at least one of which vanishes at 0 and 1 (trapezium rule).
double integrate_product(std::span<const double> a, std::span<const double> b);

/// Distance of independent samples from a normal distribution with mean 0 and known standard deviation.
///
/// From n samples, T = 1 / (12 n) + sum_i ((2 i - 1) / (2 n) - Phi(x_(i)))^2, and the index is
/// 2^18 (T - 1/6) / n: its expectation does not depend on n, and is 0 for a normal distribution.
class Gaussianity {
  public:
    /// `deviation` is the standard deviation that theory predicts, in the unit of the samples.
    explicit Gaussianity(double deviation = 1);

    /// Throws std::domain_error for NaN.
    void add(double value);
    void add(std::span<const float> values);
    /// Merges counts. Each object counts in units of its own deviation, so the two deviations may differ.
    void merge(const Gaussianity& other);

    std::uint64_t count() const;

    /// Returns the index and its interval; both may be negative, and are NaN without samples. To compare the
    /// samples with a normal distribution that has another deviation, such as their own, pass `deviation` in
    /// units of the predicted one. The bins are too coarse for deviations much above 1 or much below 0.1.
    Estimate index(double deviation = 1) const;

  private:
    double deviation_;
    Counts counts_;
};

} // namespace gabor::statistics
