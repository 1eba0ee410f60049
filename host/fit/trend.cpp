#include "fit/trend.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gabor::fit {

namespace {

// The centre of pixel `i` of `n`, in [-1, 1].
double place(int i, int n) {
    return (2.0 * i + 1) / n - 1;
}

// The six polynomials along the row at v, as coefficients of 1, x, x^2.
Eigen::Matrix<double, 6, 3> polynomials_at(double v) {
    Eigen::Matrix<double, 6, 3> m;
    m.col(0) << 1, 0, v, 0, 0, v * v;
    m.col(1) << 0, 1, 0, 0, v, 0;
    m.col(2) << 0, 0, 0, 1, 0, 0;
    return m;
}

} // namespace

double Trend::light(double u, double v) const {
    const Eigen::Vector<double, 6> total = coefficients.rowwise().sum();
    const double mean = total[0] + (total[3] + total[5]) / 3;
    return (total[0] + u * (total[1] + u * total[3] + v * total[4]) + v * (total[2] + v * total[5])) / mean;
}

void Trend::subtract(int y, std::span<float> row) const {
    const double v = place(y, height);
    for (Eigen::Index c = 0; c < coefficients.cols(); ++c) {
        const auto of = coefficients.col(c);
        const double constant = of[0] + v * (of[2] + v * of[5]);
        const double slope = of[1] + v * of[4];
        auto at = static_cast<std::size_t>(c);
        for (int x = 0; x < width; ++x, at += static_cast<std::size_t>(coefficients.cols())) {
            const double u = place(x, width);
            row[at] = static_cast<float>(row[at] - (constant + u * (slope + u * of[3])));
        }
    }
    if (contrast == 0)
        return;
    const auto channels = static_cast<std::size_t>(coefficients.cols());
    for (int x = 0; x < width; ++x) {
        const auto factor = static_cast<float>(std::pow(std::max(light(place(x, width), v), 0.1), -contrast));
        for (float& value : row.subspan(static_cast<std::size_t>(x) * channels, channels))
            value *= factor;
    }
}

PixelSums::PixelSums(int width, int height, int channels)
    : height_(height), powers_(3, width), gram_(decltype(gram_)::Zero()),
      products_(decltype(products_)::Zero(6, channels)), squares_(Eigen::MatrixXd::Zero(channels, channels)) {
    for (int x = 0; x < width; ++x) {
        const double u = place(x, width);
        powers_.col(x) << 1, u, u * u;
    }
}

void PixelSums::add_row(std::span<const float> row, std::span<const float> seen) {
    const Eigen::RowVectorXd counts =
        Eigen::Map<const Eigen::RowVectorXf>(seen.data(), powers_.cols()).cast<double>();
    values_ = Eigen::Map<const Eigen::MatrixXf>(row.data(), squares_.rows(), powers_.cols()).cast<double>() *
              counts.asDiagonal();
    const auto width = static_cast<int>(powers_.cols());
    for (int x = 0; x < width; ++x) {
        Block& block = blocks_[static_cast<std::size_t>(row_ * std::int64_t{blocks} / height_ * blocks +
                                                        x * std::int64_t{blocks} / width)];
        const double sum = values_.col(x).sum();
        block.count += counts[x];
        block.sum += sum;
        block.squares += sum * sum;
    }
    const Eigen::Matrix<double, 6, 3> polynomials = polynomials_at(place(row_++, height_));
    gram_ += polynomials * (powers_ * counts.asDiagonal() * powers_.transpose()) * polynomials.transpose();
    products_ += polynomials * (powers_ * values_.transpose());
    squares_ += values_ * values_.transpose();
}

PixelStatistics PixelSums::statistics() const {
    const double pixels = gram_(0, 0);
    PixelStatistics result;
    result.trend = {static_cast<int>(powers_.cols()), height_, gram_.ldlt().solve(products_)};
    result.mean = products_.row(0).transpose() / pixels;
    result.covariance = (squares_ - products_.transpose() * result.trend.coefficients) / pixels;
    find_contrast(result);
    return result;
}

// Regresses the logarithm of each block's deviation on that of its brightness.
void PixelSums::find_contrast(PixelStatistics& statistics) const {
    constexpr double least_correlation = 0.3; // chance gives about 1 / blocks
    Trend& trend = statistics.trend;
    std::vector<Eigen::Vector3d> found; // logarithm of light, logarithm of deviation, variance
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (int i = 0; i < blocks * blocks; ++i) {
        const Block& block = blocks_[static_cast<std::size_t>(i)];
        const double light = trend.light(place(i % blocks, blocks), place(i / blocks, blocks));
        if (!(light > 0))
            return;
        const double variance = (block.squares - block.sum * block.sum / block.count) / block.count;
        if (block.count < 2 || !(variance > 0))
            continue;
        found.emplace_back(std::log(light), 0.5 * std::log(variance), variance);
        mean += found.back().head<2>();
    }
    Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector3d& block : found) {
        const Eigen::Vector2d apart = block.head<2>() - mean / static_cast<double>(found.size());
        products += apart * apart.transpose();
    }
    if (!(products(0, 1) > least_correlation * std::sqrt(products(0, 0) * products(1, 1))))
        return;
    trend.contrast = std::min(products(0, 1) / products(0, 0), 1.0);
    double before = 0;
    double after = 0;
    for (const Eigen::Vector3d& block : found) {
        before += block[2];
        after += block[2] * std::exp(-2 * trend.contrast * block[0]);
    }
    statistics.covariance *= after / before;
}

} // namespace gabor::fit
