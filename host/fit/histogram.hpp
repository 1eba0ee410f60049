#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace gabor::fit {

/// Counts values of variance about 1, to estimate their distribution.
class Quantiles {
  public:
    Quantiles();
    void add(float value);

    /// The monotone polynomial of degree 5 that takes the standard normal law to the law of the values as
    /// nearly as one of mean 0 and variance 1 can: coefficients of 1, z, ... z^5.
    ///
    /// Hermite's polynomials He_n are orthogonal under the normal law, so that the nearest polynomial has the
    /// coefficients a_n = E[Q(z) He_n(z)] / n! of the quantiles Q(z). Cut off it may fall; a_n t^(n - 1), t
    /// <= 1, is its smoothing by a normal filter (Mehler's formula), which rises everywhere once t is small
    /// enough.
    std::array<double, 6> polynomial() const;

  private:
    std::vector<std::uint64_t> counts_;
};

} // namespace gabor::fit
