#include "fit/exemplar.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gabor::fit {

namespace {

constexpr double reach = 8; // the bins cover -reach to reach
constexpr std::size_t degree = 5;
using Coefficients = std::array<double, degree + 1>;

// He_0 ... He_5 at z.
Coefficients hermite(double z) {
    Coefficients he{1, z};
    for (std::size_t n = 1; n < degree; ++n)
        he[n + 1] = z * he[n] - static_cast<double>(n) * he[n - 1];
    return he;
}

// He_n(z) phi(z) at the quantile z of p, where phi is the normal density. The integral of He_(n + 1) phi is
// -He_n phi, which is 0 at p = 0 and 1.
Coefficients ends(double p) {
    Coefficients values{};
    if (p <= 0 || p >= 1)
        return values;
    const boost::math::normal normal;
    const double z = quantile(normal, p);
    const double density = pdf(normal, z);
    values = hermite(z);
    for (double& value : values)
        value *= density;
    return values;
}

// Tells whether the sum of a_n He_n rises from -4 to 4. Uses He_n' = n He_(n - 1).
bool rises(const Coefficients& a) {
    for (double z = -4; z <= 4; z += 0.0625) {
        const Coefficients he = hermite(z);
        double slope = 0;
        for (std::size_t n = 1; n <= degree; ++n)
            slope += a[n] * static_cast<double>(n) * he[n - 1];
        if (slope < 0)
            return false;
    }
    return true;
}

} // namespace

void Histogram::add(float value) {
    const double place = (value + reach) / (2 * reach) * static_cast<double>(counts_.size());
    ++counts_[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(counts_.size() - 1)))];
}

std::array<double, 6> Histogram::polynomial() const {
    const auto all = static_cast<double>(std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}));
    Coefficients projected{};
    std::uint64_t below = 0;
    Coefficients low{};
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
        if (counts_[bin] == 0)
            continue;
        below += counts_[bin];
        const double middle =
            (static_cast<double>(bin) + 0.5) * (2 * reach / static_cast<double>(counts_.size())) - reach;
        const Coefficients high = ends(static_cast<double>(below) / all);
        for (std::size_t n = 1; n <= degree; ++n)
            projected[n] += middle * (low[n - 1] - high[n - 1]);
        low = high;
    }
    constexpr Coefficients factorials{1, 1, 2, 6, 24, 120};
    for (std::size_t n = 2; n <= degree; ++n)
        projected[n] /= factorials[n];

    Coefficients a = projected;
    for (double t = 1; !rises(a); t -= 1.0 / 64)
        for (std::size_t n = 2; n <= degree; ++n)
            a[n] = projected[n] * std::pow(t, static_cast<double>(n - 1));
    double variance = 0;
    for (std::size_t n = 1; n <= degree; ++n)
        variance += factorials[n] * a[n] * a[n];
    for (double& coefficient : a)
        coefficient /= std::sqrt(variance);

    // He_2 = z^2 - 1, He_3 = z^3 - 3 z, He_4 = z^4 - 6 z^2 + 3, He_5 = z^5 - 10 z^3 + 15 z.
    return {3 * a[4] - a[2], a[1] - 3 * a[3] + 15 * a[5], a[2] - 6 * a[4], a[3] - 10 * a[5], a[4], a[5]};
}

} // namespace gabor::fit
