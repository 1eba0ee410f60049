#include "statistics/segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gabor::statistics {

namespace {

constexpr int most_segments = 64; ///< number along each axis

/// Periodic Hann window: segments half a side apart give every pixel the same weight.
std::vector<float> hann_window(int side) {
    std::vector<float> window;
    for (int i = 0; i < side; ++i)
        window.push_back(static_cast<float>(0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / side)));
    return window;
}

std::vector<int> segment_begins(int length, int side, int hop) {
    const int slack = length - side;
    const int steps = std::clamp((slack + hop - 1) / hop, 1, most_segments - 1);
    std::vector<int> begins;
    for (int i = 0; i <= steps; ++i)
        begins.push_back(static_cast<int>(std::int64_t{slack} * i / steps));
    return begins;
}

} // namespace

Segments::Segments(int width, int height, int channels, int side, int hop)
    : width_(width), channels_(channels), side_(side), columns_(segment_begins(width, side, hop)),
      lines_(segment_begins(height, side, hop)), window_(hann_window(side)),
      rows_(static_cast<std::size_t>(side) * static_cast<std::size_t>(width) *
            static_cast<std::size_t>(channels)) {}

std::span<const int> Segments::add_row(std::span<const float> row) {
    std::ranges::copy(row, rows_.begin() + row_ % side_ * std::ssize(row));
    ++row_;
    if (band_ == lines_.size() || lines_[band_] + side_ != row_)
        return {};
    ++band_;
    return columns_;
}

void Segments::copy_windowed(int left, int channel, std::span<float> into, int stride) const {
    for (int y = 0; y < side_; ++y) {
        const std::ptrdiff_t line = (row_ + y) % side_; // y = 0 is the oldest row
        const float* in = rows_.data() + (line * width_ + left) * channels_ + channel;
        float* out = into.data() + std::ptrdiff_t{y} * stride;
        for (std::size_t x = 0; x < window_.size(); ++x)
            out[x] = in[x * static_cast<std::size_t>(channels_)] * window_[x] *
                     window_[static_cast<std::size_t>(y)];
    }
}

double Segments::window_power() const {
    double power = 0;
    for (const double w : window_)
        power += w * w;
    return power;
}

} // namespace gabor::statistics
