#include "fit/axis_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gabor::fit {

namespace {

using Complexes = Eigen::ArrayXcd;
using std::numbers::pi;

double correlation_slope(double t) {
    const double u = std::min(std::abs(t), 2.0);
    return -(1 - std::cos(pi * u) + (2 - u) * pi / 2 * std::sin(pi * u)) / 3;
}

// Returns the autocovariance of samples, multiplied by their spacing, at lags of 0 ... count - 1 spacings.
// `pixels` is the autocovariance C(0), C(1) ... of the pixels, with C(-t) = C(t)*.
Complexes sampled(const SpectrumScale& scale, const Complexes& pixels, Eigen::Index count) {
    if (scale.spacing == 1)
        return pixels.head(count);
    const Eigen::Index reach = scale.averaging.size() - 1;
    Complexes result = Complexes::Zero(count);
    for (Eigen::Index t = 0; t < count; ++t)
        for (Eigen::Index u = -reach; u <= reach; ++u) {
            const Eigen::Index at = t * scale.spacing - u;
            if (std::abs(at) < pixels.size())
                result[t] += scale.averaging[std::abs(u)] * (at < 0 ? std::conj(pixels[-at]) : pixels[at]);
        }
    return result * scale.spacing;
}

const Eigen::ArrayXd& lag_window(const SpectrumScale& scale, int axis) {
    return scale.lag_window[static_cast<std::size_t>(axis)];
}

// The lags at which a kernel, whose autocovariance extends to 2 radii, contributes to a window's spectrum.
struct Lags {
    Eigen::Index count;    ///< number of lags between samples
    Eigen::ArrayXd pixels; ///< the lags 0, 1 ... between pixels
    Complexes wave;        ///< the wave at these lags

    Lags(const SpectrumScale& scale, double frequency, double radius) {
        const Eigen::Index reach = scale.averaging.size() - 1;
        const auto size = std::min(static_cast<Eigen::Index>(2 * radius) + 1,
                                   Eigen::Index{scale.window - 1} * scale.spacing + reach + 1);
        count = std::min<Eigen::Index>(scale.window, (size - 1 + reach) / scale.spacing + 1);
        pixels = Eigen::ArrayXd::LinSpaced(size, 0, static_cast<double>(size - 1));
        const Eigen::ArrayXd phase = 2 * pi * frequency * pixels;
        wave.resize(size);
        wave.real() = phase.cos();
        wave.imag() = phase.sin();
    }
    Complexes covariance(double radius) const {
        return wave * pixels.unaryExpr([&](double t) { return kernel_correlation(t / radius); });
    }
};

} // namespace

double kernel_correlation(double t) {
    const double u = std::min(std::abs(t), 2.0);
    return ((2 - u) * (1 + std::cos(pi * u) / 2) + 1.5 / pi * std::sin(pi * u)) / 3;
}

AxisSpectrum axis_spectrum(const SpectrumScale& scale, int axis, double frequency, double radius,
                           bool with_derivatives) {
    const Lags lags(scale, frequency, radius);
    const auto transformed = [&](const Complexes& covariance) {
        Complexes seen = sampled(scale, covariance, lags.count) * lag_window(scale, axis).head(lags.count);
        seen.tail(lags.count - 1) *= 2; // includes the opposite lags
        return Eigen::ArrayXd(scale.cosine.leftCols(lags.count) * seen.real().matrix() +
                              scale.sine.leftCols(lags.count) * seen.imag().matrix());
    };
    const Complexes value = lags.covariance(radius);
    if (!with_derivatives)
        return {transformed(value), {}, {}};
    const auto slope = [&](double t) { return -t / radius * correlation_slope(t / radius); };
    return {transformed(value), transformed(value * std::complex<double>(0, 2 * pi) * lags.pixels),
            transformed(lags.wave * lags.pixels.unaryExpr(slope))};
}

Eigen::ArrayXcd axis_autocovariance(const SpectrumScale& scale, int axis, double frequency, double radius) {
    const Lags lags(scale, frequency, radius);
    Complexes seen = Complexes::Zero(scale.window);
    seen.head(lags.count) = sampled(scale, lags.covariance(radius), lags.count) *
                            lag_window(scale, axis).head(lags.count) / scale.spacing;
    Complexes result = seen.head(scale.lags());
    if (scale.grid == scale.window) // long lags wrap around
        for (Eigen::Index t = 1; t < scale.lags(); ++t)
            result[t] += std::conj(seen[scale.window - t]);
    return result;
}

} // namespace gabor::fit
