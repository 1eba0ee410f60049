#include "fit/spectra.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gabor::fit {

namespace {

constexpr int hop = 16;
constexpr int most_windows = 64; ///< along each axis

// Evenly from the first pixel to the last, so that no border is left out.
std::vector<int> window_begins(int length) {
    const int slack = length - window_side;
    const int steps = std::clamp((slack + hop - 1) / hop, 1, most_windows - 1);
    std::vector<int> begins;
    for (int i = 0; i <= steps; ++i)
        begins.push_back(static_cast<int>(std::int64_t{slack} * i / steps));
    return begins;
}

} // namespace

const Eigen::ArrayXd& hann_window() {
    static const Eigen::ArrayXd window = [] {
        Eigen::ArrayXd w(window_side);
        for (int i = 0; i < window_side; ++i)
            w[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / window_side);
        return Eigen::ArrayXd(w / w.matrix().norm());
    }();
    return window;
}

const Eigen::ArrayXd& multiplicities() {
    static const Eigen::ArrayXd values = [] {
        Eigen::ArrayXd m = Eigen::ArrayXd::Constant(grid_size, 2);
        for (int y = 0; y < grid_side; ++y)
            m[y * grid_columns] = m[(y + 1) * grid_columns - 1] = 1;
        return m;
    }();
    return values;
}

std::vector<Pair> real_pairs(int channels) {
    std::vector<Pair> pairs;
    for (int c = 0; c < channels; ++c)
        for (int d = c; d < channels; ++d)
            pairs.push_back({c, d});
    return pairs;
}

std::vector<Pair> imaginary_pairs(int channels) {
    std::vector<Pair> pairs = real_pairs(channels);
    std::erase_if(pairs, [](const Pair& pair) { return pair.c == pair.d; });
    return pairs;
}

Spectra::Spectra(int count)
    : channels(count), real(Eigen::MatrixXd::Zero(grid_size, std::ssize(real_pairs(count)))),
      imaginary(Eigen::MatrixXd::Zero(grid_size, std::ssize(imaginary_pairs(count)))) {}

Eigen::ArrayXd Spectra::total() const {
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(grid_size);
    Eigen::Index column = 0;
    for (const auto& [c, d] : real_pairs(channels)) {
        if (c == d)
            sum += real.col(column).array();
        ++column;
    }
    return sum;
}

Eigen::MatrixXd Spectra::covariance() const {
    const Eigen::VectorXd integral = real.transpose() * multiplicities().matrix() / (grid_side * grid_side);
    Eigen::MatrixXd result(channels, channels);
    Eigen::Index at = 0;
    for (const auto& [c, d] : real_pairs(channels))
        result(c, d) = result(d, c) = integral[at++];
    return result;
}

Spectra Spectra::mapped(const Eigen::MatrixXd& map) const {
    const auto apply = [&](const Eigen::MatrixXd& from, const std::vector<Pair>& pairs, double mirrored) {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(std::ssize(pairs), std::ssize(pairs));
        for (std::size_t i = 0; i < pairs.size(); ++i)
            for (std::size_t j = 0; j < pairs.size(); ++j) {
                const auto& [c, d] = pairs[i];
                const auto& [a, b] = pairs[j];
                double& entry = matrix(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i));
                entry = map(c, a) * map(d, b);
                if (a != b)
                    entry += mirrored * map(c, b) * map(d, a);
            }
        return Eigen::MatrixXd(from * matrix);
    };
    Spectra result(channels);
    result.real = apply(real, real_pairs(channels), 1);
    result.imaginary = apply(imaginary, imaginary_pairs(channels), -1);
    return result;
}

SpectraEstimate::SpectraEstimate(int width, int height, int channels)
    : width_(width), channels_(channels), columns_(window_begins(width)), lines_(window_begins(height)),
      rows_(static_cast<std::size_t>(window_side) * static_cast<std::size_t>(width) *
            static_cast<std::size_t>(channels)),
      window_(std::size_t{grid_side} * grid_side), transform_(grid_side),
      transformed_(static_cast<std::size_t>(channels)), sum_(channels) {}

void SpectraEstimate::add_row(std::span<const float> row) {
    std::copy(row.begin(), row.end(), rows_.begin() + (row_ % window_side) * std::ssize(row));
    ++row_;
    if (band_ == lines_.size() || lines_[band_] + window_side != row_)
        return;
    for (const int left : columns_)
        add_window(left, lines_[band_]);
    ++band_;
}

void SpectraEstimate::add_window(int left, int top) {
    const Eigen::ArrayXd& hann = hann_window();
    for (int c = 0; c < channels_; ++c) {
        for (int y = 0; y < window_side; ++y) {
            const std::ptrdiff_t line = (top + y) % window_side;
            const float* in = rows_.data() + (line * width_ + left) * channels_ + c;
            float* out = window_.data() + std::ptrdiff_t{y} * grid_side;
            for (int x = 0; x < window_side; ++x)
                out[x] = in[std::ptrdiff_t{x} * channels_] * static_cast<float>(hann[x] * hann[y]);
        }
        const auto values = transform_(window_);
        transformed_[static_cast<std::size_t>(c)] =
            Eigen::Map<const Eigen::ArrayXcf>(values.data(), grid_size);
    }
    const auto product = [&](const Pair& pair) {
        return transformed_[static_cast<std::size_t>(pair.c)] *
               transformed_[static_cast<std::size_t>(pair.d)].conjugate();
    };
    Eigen::Index column = 0;
    for (const Pair& pair : real_pairs(channels_))
        sum_.real.col(column++).array() += product(pair).real().cast<double>();
    column = 0;
    for (const Pair& pair : imaginary_pairs(channels_))
        sum_.imaginary.col(column++).array() += product(pair).imag().cast<double>();
}

Spectra SpectraEstimate::spectra() const {
    const auto windows = static_cast<double>(columns_.size() * lines_.size());
    Spectra result = sum_;
    result.real /= windows;
    result.imaginary /= windows;
    return result;
}

} // namespace gabor::fit
