#include "fit/trend.hpp"

#include <Eigen/Cholesky>

namespace gabor::fit {

namespace {

// The place of pixel `i` of `n`, in [-1, 1].
double place(int i, int n) {
    return (2.0 * i + 1) / n - 1;
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

MomentSums::MomentSums(int width, int height, int channels)
    : width_(width), height_(height), gram_(decltype(gram_)::Zero()),
      products_(decltype(products_)::Zero(6, channels)), squares_(Eigen::MatrixXd::Zero(channels, channels)) {
}

void MomentSums::add_row(std::span<const float> row) {
    const double v = place(row_++, height_);
    Eigen::Matrix<double, 6, 1> polynomials;
    Eigen::VectorXd values(products_.cols());
    const float* at = row.data();
    for (int x = 0; x < width_; ++x) {
        const double u = place(x, width_);
        polynomials << 1, u, v, u * u, u * v, v * v;
        for (double& value : values)
            value = *at++;
        gram_.selfadjointView<Eigen::Lower>().rankUpdate(polynomials);
        products_.noalias() += polynomials * values.transpose();
        squares_.noalias() += values * values.transpose();
    }
}

Moments MomentSums::moments() const {
    const Eigen::Matrix<double, 6, 6> gram = gram_.selfadjointView<Eigen::Lower>();
    const double pixels = gram(0, 0);
    Moments result;
    result.trend = {width_, height_, gram.ldlt().solve(products_)};
    result.mean = products_.row(0).transpose() / pixels;
    result.covariance = (squares_ - products_.transpose() * result.trend.coefficients) / pixels;
    return result;
}

} // namespace gabor::fit
