#include "statistics/transform.hpp"

#include <kiss_fft.h>
#include <kiss_fftr.h>

#include <new>
#include <vector>

namespace gabor::statistics {

// Transforms rows, then columns, because kiss_fftndr_alloc of KISS FFT 131.1 refuses sides of 64 and more.
struct Transform::State {
    explicit State(int length)
        : side(static_cast<std::size_t>(length)),
          rows(kiss_fftr_alloc(length, 0, nullptr, nullptr), kiss_fft_free),
          columns(kiss_fft_alloc(length, 0, nullptr, nullptr), kiss_fft_free), values(side * (side / 2 + 1)),
          column(side) {
        if (!rows || !columns)
            throw std::bad_alloc();
    }

    std::size_t side;
    std::unique_ptr<kiss_fftr_state, void (*)(void*)> rows;
    std::unique_ptr<kiss_fft_state, void (*)(void*)> columns;
    std::vector<std::complex<float>> values;
    std::vector<std::complex<float>> column;
};

Transform::Transform(int side) : state_(std::make_unique<State>(side)) {}
Transform::~Transform() = default;
Transform::Transform(Transform&&) noexcept = default;

std::span<const std::complex<float>> Transform::operator()(std::span<const float> values) {
    // Both types store the real part, then the imaginary part.
    const auto of_kiss = [](std::complex<float>* value) { return reinterpret_cast<kiss_fft_cpx*>(value); };
    State& s = *state_;
    const std::size_t width = s.side / 2 + 1;
    for (std::size_t y = 0; y < s.side; ++y)
        kiss_fftr(s.rows.get(), &values[y * s.side], of_kiss(&s.values[y * width]));
    for (std::size_t x = 0; x < width; ++x) {
        kiss_fft_stride(s.columns.get(), of_kiss(&s.values[x]), of_kiss(s.column.data()),
                        static_cast<int>(width));
        for (std::size_t y = 0; y < s.side; ++y)
            s.values[y * width + x] = s.column[y];
    }
    return s.values;
}

} // namespace gabor::statistics
