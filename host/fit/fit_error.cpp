#include "fit/fit_error.hpp"

#include <cmath>
#include <numbers>

namespace gabor::fit {

namespace {

double sum(const Eigen::ArrayXd& values) {
    return (values * multiplicities()).sum();
}

// Over all entries of the matrices: those off the diagonal are there twice.
double squares(const Spectra& spectra) {
    double result = 2 * sum(spectra.imaginary.rowwise().squaredNorm().array());
    Eigen::Index column = 0;
    for (const auto& [c, d] : real_pairs(spectra.channels))
        result += (c == d ? 1 : 2) * sum(spectra.real.col(column++).array().square());
    return result;
}

} // namespace

Eigen::MatrixXd autocorrelation(const Spectra& spectra) {
    constexpr int lags = 2 * furthest_lag + 1;
    const Eigen::ArrayXd power = spectra.total() * multiplicities();
    const Eigen::Map<const Eigen::Matrix<double, grid_side, grid_columns, Eigen::RowMajor>> plane(
        power.data());
    const auto waves = [&](int frequencies, auto function) {
        Eigen::MatrixXd result(lags, frequencies);
        for (int t = 0; t < lags; ++t)
            for (int k = 0; k < frequencies; ++k)
                result(t, k) = function(2 * std::numbers::pi * (t - furthest_lag) * k / grid_side);
        return result;
    };
    const auto cosine = [](double phase) { return std::cos(phase); };
    const auto sine = [](double phase) { return std::sin(phase); };
    Eigen::MatrixXd result = waves(grid_side, cosine) * plane * waves(grid_columns, cosine).transpose() -
                             waves(grid_side, sine) * plane * waves(grid_columns, sine).transpose();
    const Eigen::ArrayXd& window = hann_window();
    Eigen::VectorXd seen(lags); // the windows' own
    for (int t = -furthest_lag; t <= furthest_lag; ++t) {
        const int overlap = window_side - std::abs(t);
        seen[t + furthest_lag] = (window.head(overlap) * window.tail(overlap)).sum();
    }
    result.array() /= (seen * seen.transpose()).array();
    return result / result(furthest_lag, furthest_lag);
}

FitError compare(const Spectra& estimate, const Spectra& model) {
    Spectra difference = model;
    difference.real -= estimate.real;
    difference.imaginary -= estimate.imaginary;
    FitError error;
    error.l1 = sum(difference.total().abs()) / sum(estimate.total());
    error.l2 = std::sqrt(squares(difference) / squares(estimate));
    error.autocorrelation = (autocorrelation(model) - autocorrelation(estimate)).cwiseAbs().maxCoeff();
    return error;
}

} // namespace gabor::fit
