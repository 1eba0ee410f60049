#include "fit/fit.hpp"

#include "fit/axis_spectrum.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::fit {

namespace {

// Consecutive rows of the spectra, and the weight of each row in sums.
struct SpectrumRows {
    Eigen::Index begin;
    Eigen::ArrayXd measure;

    double sum(const Eigen::ArrayXd& values) const {
        return (values.segment(begin, measure.size()) * measure).sum();
    }
    // Sums squares over all entries of the matrices. Entries off the diagonal are stored once but occur
    // twice.
    double squares(const Spectra& spectra) const {
        double result = 0;
        Eigen::Index column = 0;
        for (const auto& [c, d, imaginary] : entries(spectra.channels))
            result += (c == d ? 1 : 2) * sum(spectra.values.col(column++).array().square());
        return result;
    }
};

// The rows of frequencies below 1 / window_side cycles per pixel.
SpectrumRows low_rows(const SpectrumScale& scale) {
    SpectrumRows rows{scale.begin, measures({scale})};
    const double limit = static_cast<double>(scale.grid) * scale.spacing / window_side;
    Eigen::Index row = 0;
    for (const SpectrumScale::Frequency& k : scale.frequencies) {
        const int y = 2 * k.y > scale.grid ? scale.grid - k.y : k.y;
        if (std::hypot(k.x, y) > limit)
            rows.measure[row] = 0;
        ++row;
    }
    return rows;
}

Autocovariance autocovariance(const SpectrumScale& scale, const std::vector<Wave>& waves,
                              const Eigen::VectorXd& weights) {
    const auto zero = Eigen::MatrixXd::Zero(scale.lags(), scale.lags());
    Autocovariance result{zero, zero};
    for (const Wave& wave : waves) {
        const double power = wave.weight.cwiseAbs2().dot(weights);
        const Eigen::VectorXcd x = axis_autocovariance(scale, 0, wave.frequency.x(), wave.radius.x());
        const Eigen::VectorXcd y = axis_autocovariance(scale, 1, wave.frequency.y(), wave.radius.y());
        result.forward += power * (y * x.transpose()).real();
        result.backward += power * (y * x.adjoint()).real();
    }
    return result;
}

// Compares autocovariances at lags of at most half a window's side.
double largest_difference(const SpectrumScale& scale, const Autocovariance& a, const Autocovariance& b) {
    const Eigen::ArrayXXd apart =
        (a.forward - b.forward).cwiseAbs().cwiseMax((a.backward - b.backward).cwiseAbs());
    double largest = 0;
    for (Eigen::Index y = 0; y < scale.lags(); ++y)
        for (Eigen::Index x = 0; x < scale.lags(); ++x)
            if (std::hypot(x, y) < static_cast<double>(scale.lags()))
                largest = std::max(largest, apart(y, x) / (scale.lag_window[0][x] * scale.lag_window[1][y]));
    return largest;
}

} // namespace

FitError fit_error(const Exemplar& exemplar, const std::vector<Wave>& waves) {
    const Spectra estimate = exemplar.spectra.mapped(exemplar.components);
    const Spectra found =
        model(waves, exemplar.spectra.channels, exemplar.spectra.scales).mapped(exemplar.components);
    Spectra difference = found;
    difference.values -= estimate.values;
    const Eigen::VectorXd all = Eigen::VectorXd::Ones(estimate.channels);
    const Eigen::ArrayXd power = total(estimate.values, all);
    const Eigen::ArrayXd apart = total(difference.values, all).abs();
    const std::vector<SpectrumScale>& scales = *estimate.scales;
    const SpectrumRows first{0, measures({scales.front()})};
    FitError error;
    error.l1 = first.sum(apart) / first.sum(power);
    error.l2 = std::sqrt(first.squares(difference) / first.squares(estimate));
    if (scales.size() > 1) {
        const SpectrumRows low = low_rows(scales.back());
        error.low = low.sum(apart) / low.sum(power);
        error.low_share = low.sum(power) / first.sum(power);
    }

    const Eigen::VectorXd weights = exemplar.components.colwise().squaredNorm();
    const double variance = estimate.covariance().trace();
    double squares = 0; // the integral of the squared autocorrelation over all lags
    for (std::size_t i = 0; i < exemplar.autocovariances.size(); ++i) {
        const SpectrumScale& scale = scales[i];
        const Autocovariance& seen = exemplar.autocovariances[i];
        error.autocorrelation =
            std::max(error.autocorrelation,
                     largest_difference(scale, seen, autocovariance(scale, waves, weights)) / variance);
        error.furthest_lag = scale.length() / 2;
        squares = 2 * (seen.forward.squaredNorm() + seen.backward.squaredNorm()) *
                  std::pow(scale.spacing / variance, 2);
    }
    error.chance = std::sqrt(squares / exemplar.width / exemplar.height); // Bartlett's formula
    return error;
}

} // namespace gabor::fit
