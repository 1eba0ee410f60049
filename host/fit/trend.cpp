#include "fit/trend.hpp"

#include <Eigen/Cholesky>

namespace gabor::fit {

namespace {

// The place of pixel `i` of `n`, in [-1, 1].
double place(int i, int n) {
    return (2.0 * i + 1) / n - 1;
}

// The polynomials along a row at v, in terms of 1, x, x^2.
Eigen::Matrix<double, 6, 3> polynomials_at(double v) {
    Eigen::Matrix<double, 6, 3> m;
    m.col(0) << 1, 0, v, 0, 0, v * v;
    m.col(1) << 0, 1, 0, 0, v, 0;
    m.col(2) << 0, 0, 0, 1, 0, 0;
    return m;
}

} // namespace

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
}

PixelSums::PixelSums(int width, int height, int channels)
    : height_(height), powers_(3, width), gram_(decltype(gram_)::Zero()),
      products_(decltype(products_)::Zero(6, channels)), squares_(Eigen::MatrixXd::Zero(channels, channels)) {
    for (int x = 0; x < width; ++x) {
        const double u = place(x, width);
        powers_.col(x) << 1, u, u * u;
    }
    row_gram_ = powers_ * powers_.transpose();
}

void PixelSums::add_row(std::span<const float> row) {
    values_ = Eigen::Map<const Eigen::MatrixXf>(row.data(), squares_.rows(), powers_.cols()).cast<double>();
    const Eigen::Matrix<double, 6, 3> polynomials = polynomials_at(place(row_++, height_));
    gram_ += polynomials * row_gram_ * polynomials.transpose();
    products_ += polynomials * (powers_ * values_.transpose());
    squares_ += values_ * values_.transpose();
}

Survey PixelSums::survey() const {
    const double pixels = gram_(0, 0);
    Survey result;
    result.trend = {static_cast<int>(powers_.cols()), height_, gram_.ldlt().solve(products_)};
    result.mean = products_.row(0).transpose() / pixels;
    result.covariance = (squares_ - products_.transpose() * result.trend.coefficients) / pixels;
    return result;
}

} // namespace gabor::fit
