#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::statistics {

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

} // namespace gabor::statistics
