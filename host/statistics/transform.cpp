#include "statistics/transform.hpp"

#include <kiss_fft.h>
#include <kiss_fftr.h>

#include <new>

namespace gabor::statistics {

// Transforms rows, then columns, because kiss_fftndr_alloc of KISS FFT 131.1 refuses sides of 64 or more.
FourierTransform::FourierTransform(int side)
    : side_(static_cast<std::size_t>(side)), rows_(kiss_fftr_alloc(side, 0, nullptr, nullptr), kiss_fft_free),
      columns_(kiss_fft_alloc(side, 0, nullptr, nullptr), kiss_fft_free), values_(side_ * (side_ / 2 + 1)),
      column_(side_) {
    if (!rows_ || !columns_)
        throw std::bad_alloc();
}

std::span<const std::complex<float>> FourierTransform::operator()(std::span<const float> values) {
    // Both types store the real part, then the imaginary part.
    const auto of_kiss = [](std::complex<float>* value) { return reinterpret_cast<kiss_fft_cpx*>(value); };
    const std::size_t width = side_ / 2 + 1;
    for (std::size_t y = 0; y < side_; ++y)
        kiss_fftr(rows_.get(), &values[y * side_], of_kiss(&values_[y * width]));
    for (std::size_t x = 0; x < width; ++x) {
        kiss_fft_stride(columns_.get(), of_kiss(&values_[x]), of_kiss(column_.data()),
                        static_cast<int>(width));
        for (std::size_t y = 0; y < side_; ++y)
            values_[y * width + x] = column_[y];
    }
    return values_;
}

} // namespace gabor::statistics
