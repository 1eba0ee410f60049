#include "statistics/spectrum.hpp"

#include <kiss_fft.h>
#include <kiss_fftr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <new>
#include <numbers>
#include <stdexcept>

namespace gabor::statistics {

namespace {

constexpr int longest_side = 512;
constexpr int shortest_side = 8;
constexpr int most_segments = 64;                           ///< per direction
constexpr std::int64_t most_values = std::int64_t(1) << 25; ///< rows held, in floats

/// Periodic Hann window: segments half a side apart then weigh every pixel alike.
std::vector<float> hann_window(int side) {
    std::vector<float> window;
    for (int i = 0; i < side; ++i)
        window.push_back(static_cast<float>(0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / side)));
    return window;
}

/// Segments spread evenly from the first pixel to the last, so that no border is left out.
std::vector<int> segment_begins(int length, int side) {
    const int slack = length - side;
    const int steps = std::clamp((2 * slack + side - 1) / side, 1, most_segments - 1);
    std::vector<int> begins;
    for (int i = 0; i <= steps; ++i)
        begins.push_back(static_cast<int>(std::int64_t(slack) * i / steps));
    return begins;
}

/// Two-dimensional transform of side * side real values: rows, then the columns of fx >= 0.
/// (kiss_fftndr_alloc of KISS FFT 131.1 refuses sides of 64 and more.)
class Transform {
  public:
    explicit Transform(int side)
        : side_(static_cast<std::size_t>(side)),
          rows_(kiss_fftr_alloc(side, 0, nullptr, nullptr), kiss_fft_free),
          columns_(kiss_fft_alloc(side, 0, nullptr, nullptr), kiss_fft_free), half_(side_ * (side_ / 2 + 1)),
          column_(side_) {
        if (!rows_ || !columns_)
            throw std::bad_alloc();
    }

    /// Adds the squared modulus of the transform of `values` to `power`.
    void add_power(std::span<const float> values, std::span<double> power) {
        const std::size_t width = side_ / 2 + 1;
        for (std::size_t y = 0; y < side_; ++y)
            kiss_fftr(rows_.get(), &values[y * side_], &half_[y * width]);
        for (std::size_t x = 0; x < width; ++x) {
            kiss_fft_stride(columns_.get(), &half_[x], column_.data(), static_cast<int>(width));
            for (std::size_t y = 0; y < side_; ++y) {
                const double re = column_[y].r;
                const double im = column_[y].i;
                power[y * width + x] += re * re + im * im;
            }
        }
    }

  private:
    std::size_t side_;
    std::unique_ptr<kiss_fftr_state, void (*)(void*)> rows_;
    std::unique_ptr<kiss_fft_state, void (*)(void*)> columns_;
    std::vector<kiss_fft_cpx> half_;
    std::vector<kiss_fft_cpx> column_;
};

} // namespace

struct Spectrum::State {
    int width;
    int side;
    std::vector<int> columns; ///< where segments begin
    std::vector<int> lines;
    std::vector<float> window;
    Transform transform;
    std::vector<float> rows; ///< row y of the picture in place y % side
    std::vector<float> segment;
    std::vector<double> power;
    int row = 0;
    std::size_t band = 0; ///< bands of segments that are complete

    void add_segment(int left, int top);
};

void Spectrum::State::add_segment(int left, int top) {
    float* out = segment.data();
    for (int y = 0; y < side; ++y) {
        const auto place = static_cast<std::size_t>((top + y) % side) * static_cast<std::size_t>(width);
        const float* in = rows.data() + place + left;
        for (int x = 0; x < side; ++x)
            *out++ = in[x] * window[static_cast<std::size_t>(x)] * window[static_cast<std::size_t>(y)];
    }
    transform.add_power(segment, power);
}

Spectrum::Spectrum(int width, int height) {
    const int side = segment_side(width, height).value_or(0);
    if (side == 0)
        throw std::invalid_argument("too few pixels for a spectrum");
    const auto n = static_cast<std::size_t>(side);
    state_ = std::make_unique<State>(State{width, side, segment_begins(width, side),
                                           segment_begins(height, side), hann_window(side), Transform(side),
                                           std::vector<float>(n * static_cast<std::size_t>(width)),
                                           std::vector<float>(n * n), std::vector<double>(n * (n / 2 + 1))});
}

Spectrum::~Spectrum() = default;
Spectrum::Spectrum(Spectrum&&) noexcept = default;

int Spectrum::side() const {
    return state_->side;
}

void Spectrum::add_row(std::span<const float> row) {
    State& s = *state_;
    std::copy(row.begin(), row.end(), s.rows.begin() + std::ptrdiff_t(s.row % s.side) * s.width);
    ++s.row;
    if (s.band == s.lines.size() || s.lines[s.band] + s.side != s.row)
        return;
    for (const int left : s.columns)
        s.add_segment(left, s.lines[s.band]);
    ++s.band;
}

std::vector<double> Spectrum::periodogram() const {
    const State& s = *state_;
    double window_power = 0; // of one direction; the window is a product of two
    for (const double w : s.window)
        window_power += w * w;
    const double side = s.side;
    const double segments = static_cast<double>(s.columns.size() * s.band);
    // Parseval: sum_k |X_k|^2 = side^2 sum (w x)^2, whose expectation is side^2 window_power^2 variance.
    const double scale = 1 / (segments * side * side * window_power * window_power);
    std::vector<double> result(s.power);
    for (double& cell : result)
        cell *= scale;
    return result;
}

std::optional<int> segment_side(int width, int height) {
    const int longest = std::min({width / 2, height / 2, longest_side});
    if (longest < shortest_side)
        return {};
    int side = static_cast<int>(std::bit_floor(static_cast<unsigned>(longest)));
    while (std::int64_t(side) * width > most_values && side > shortest_side)
        side /= 2;
    return side;
}

} // namespace gabor::statistics
