#include "fit/spectra.hpp"

#include <cmath>
#include <numbers>

namespace gabor::fit {

namespace {

constexpr int hop = 16;

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
    : segments_(width, height, channels, window_side, hop), window_(std::size_t{grid_side} * grid_side),
      transform_(grid_side), transformed_(static_cast<std::size_t>(channels)), sum_(channels) {}

void SpectraEstimate::add_row(std::span<const float> row) {
    for (const int left : segments_.add_row(row))
        add_window(left);
}

void SpectraEstimate::add_window(int left) {
    for (int c = 0; c < sum_.channels; ++c) {
        segments_.weigh(left, c, window_, grid_side);
        const auto values = transform_(window_);
        transformed_[static_cast<std::size_t>(c)] =
            Eigen::Map<const Eigen::ArrayXcf>(values.data(), grid_size);
    }
    const auto product = [&](const Pair& pair) {
        return transformed_[static_cast<std::size_t>(pair.c)] *
               transformed_[static_cast<std::size_t>(pair.d)].conjugate();
    };
    Eigen::Index column = 0;
    for (const Pair& pair : real_pairs(sum_.channels))
        sum_.real.col(column++).array() += product(pair).real().cast<double>();
    column = 0;
    for (const Pair& pair : imaginary_pairs(sum_.channels))
        sum_.imaginary.col(column++).array() += product(pair).imag().cast<double>();
}

Spectra SpectraEstimate::spectra() const {
    const double scale = 1 / (static_cast<double>(segments_.count()) * std::pow(segments_.window_power(), 2));
    Spectra result = sum_;
    result.real *= scale;
    result.imaginary *= scale;
    return result;
}

} // namespace gabor::fit
