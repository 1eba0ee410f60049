#pragma once

#include <complex>
#include <memory>
#include <span>
#include <vector>

struct kiss_fft_state;
struct kiss_fftr_state;

namespace gabor::statistics {

/// The discrete Fourier transform of a square array of real values,
/// X(k) = sum_p x(p) exp(-2 pi i k.p / side).
class FourierTransform {
  public:
    /// `side` must be even.
    explicit FourierTransform(int side);

    /// Transforms side * side values. The result has `side` rows for ky (negative ones last) and side / 2 + 1
    /// columns for kx >= 0. The span stays valid until the next call.
    std::span<const std::complex<float>> operator()(std::span<const float> values);

  private:
    std::size_t side_;
    std::unique_ptr<kiss_fftr_state, void (*)(void*)> rows_;
    std::unique_ptr<kiss_fft_state, void (*)(void*)> columns_;
    std::vector<std::complex<float>> values_;
    std::vector<std::complex<float>> column_;
};

} // namespace gabor::statistics
