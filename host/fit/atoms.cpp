#include "fit/atoms.hpp"

#include "fit/spectra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::fit {

namespace {

using std::numbers::pi;

double correlation_slope(double t) {
    const double u = std::min(std::abs(t), 2.0);
    return -(1 - std::cos(pi * u) + (2 - u) * pi / 2 * std::sin(pi * u)) / 3;
}

// L(t) for t = 0 ... window_side - 1, twice for the lags that have an opposite.
const Eigen::ArrayXd& lag_window() {
    static const Eigen::ArrayXd window = [] {
        const Eigen::ArrayXd& w = hann_window();
        Eigen::ArrayXd lags(window_side);
        for (int t = 0; t < window_side; ++t)
            lags[t] = (t == 0 ? 1 : 2) * (w.head(window_side - t) * w.tail(window_side - t)).sum();
        return lags;
    }();
    return window;
}

// cos and sin of 2 pi k t / grid_side.
struct Waves {
    Eigen::MatrixXd cosine{grid_side, window_side};
    Eigen::MatrixXd sine{grid_side, window_side};

    Waves() {
        for (int k = 0; k < grid_side; ++k)
            for (int t = 0; t < window_side; ++t) {
                const double phase = 2 * pi * (k * t % grid_side) / grid_side;
                cosine(k, t) = std::cos(phase);
                sine(k, t) = std::sin(phase);
            }
    }
};

} // namespace

double kernel_correlation(double t) {
    const double u = std::min(std::abs(t), 2.0);
    return ((2 - u) * (1 + std::cos(pi * u) / 2) + 1.5 / pi * std::sin(pi * u)) / 3;
}

AxisAtom axis_atom(double frequency, double radius) {
    static const Waves waves;
    const Eigen::ArrayXd lags = Eigen::ArrayXd::LinSpaced(window_side, 0, window_side - 1);
    const Eigen::ArrayXd& window = lag_window();
    const Eigen::ArrayXd phase = 2 * pi * frequency * lags;
    const Eigen::ArrayXd cosine = phase.cos();
    const Eigen::ArrayXd sine = phase.sin();
    const Eigen::ArrayXd a =
        window * lags.unaryExpr([&](double t) { return kernel_correlation(t / radius); });
    const Eigen::ArrayXd b = 2 * pi * lags * a;
    const Eigen::ArrayXd r =
        window * lags.unaryExpr([&](double t) { return -t / radius * correlation_slope(t / radius); });
    const auto sum = [&](const Eigen::ArrayXd& c, const Eigen::ArrayXd& s) {
        return Eigen::ArrayXd(waves.cosine * c.matrix() + waves.sine * s.matrix());
    };
    return {sum(a * cosine, a * sine), sum(-b * sine, b * cosine), sum(r * cosine, r * sine)};
}

} // namespace gabor::fit
