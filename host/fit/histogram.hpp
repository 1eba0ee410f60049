#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace gabor::fit {

/// Counts values of variance about 1, to estimate their distribution.
class Histogram {
  public:
    void add(float value);

    /// Returns the coefficients of 1, z, ... z^5 of an increasing polynomial. It maps the standard normal
    /// distribution to the distribution of the values as closely as is possible with mean 0 and variance 1.
    ///
    /// The Hermite polynomials He_n are orthogonal under the normal distribution, so the polynomial nearest
    /// to the quantiles Q(z) has the coefficients a_n = E[Q(z) He_n(z)] / n!. Truncated at degree 5, it may
    /// fall in places. The coefficients a_n t^(n - 1), t <= 1, smooth it with a normal filter (Mehler's
    /// formula), and it rises everywhere once t is small enough.
    std::array<double, 6> polynomial() const;

  private:
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(4096);
};

} // namespace gabor::fit
