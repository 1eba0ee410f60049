#pragma once

#include <complex>
#include <memory>
#include <span>

namespace gabor::statistics {

/// The discrete Fourier transform of squares of real values, X(k) = sum_p x(p) exp(-2 pi i k.p / side).
class Transform {
  public:
    /// `side` must be even.
    explicit Transform(int side);
    ~Transform();
    Transform(Transform&&) noexcept;

    /// Transforms side * side values. The result has `side` rows for ky (negative ones last) and side / 2 + 1
    /// columns for kx >= 0. The span stays valid until the next call.
    std::span<const std::complex<float>> operator()(std::span<const float> values);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace gabor::statistics
