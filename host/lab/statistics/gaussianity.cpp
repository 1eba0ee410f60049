#include "statistics/gaussianity.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace gabor::statistics {

namespace {

const boost::math::normal normal;

/// Computing T from the edges of b bins has a mean error of 1 / (6 b^2) and a random error of 0.2 / b. The
/// standard deviation of T itself is sqrt(1/45) = 0.15 for a normal distribution.
constexpr std::size_t bin_count = 4096;

/// Phi, interpolated linearly between 4097 points of [-8, 8]. The error is at most step^2 / 8 * max |Phi''| =
/// 4.6e-7, which moves an index by less than 1e-6, at a tenth of the cost of erfc.
class CdfTable {
  public:
    CdfTable() {
        for (std::size_t i = 0; i < values_.size(); ++i)
            values_[i] = cdf(normal, static_cast<double>(i) / places_per_unit - limit);
    }

    double operator()(double z) const {
        const double place = (std::clamp(z, -limit, limit) + limit) * places_per_unit;
        const auto index = std::min(static_cast<std::size_t>(place), values_.size() - 2);
        const double fraction = place - static_cast<double>(index);
        return values_[index] + fraction * (values_[index + 1] - values_[index]);
    }

  private:
    static constexpr double limit = 8;
    static constexpr double places_per_unit = 256;
    std::array<double, 16 * 256 + 1> values_;
};

const CdfTable table;

/// Returns the interval of a value whose variance would be null_variance + slope * max(truth, 0): every truth
/// from which the value is at most 1.96 standard deviations away (Wilson's score interval, 1927).
Estimate score_interval(double value, double null_variance, double slope) {
    // Solves (truth - value)^2 = quantile^2 (null_variance + slope truth) for a positive truth.
    constexpr double quantile = 1.96;
    const double null_half = quantile * std::sqrt(null_variance);
    const double shift = quantile * quantile * slope / 2;
    const double half = std::sqrt(null_half * null_half + shift * (2 * value + shift));
    const double low = value < null_half ? value - null_half : value + shift - half;
    const double high = value < -null_half ? value + null_half : value + shift + half;
    return {value, low, high};
}

} // namespace

Gaussianity::Gaussianity(double deviation) : deviation_(deviation), counts_(bin_count) {}

void Gaussianity::add(double value) {
    const float single = static_cast<float>(value);
    add(std::span(&single, 1));
}

void Gaussianity::add(std::span<const float> values) {
    const double scale = 1 / deviation_;
    for (const float value : values) {
        if (std::isnan(value))
            throw std::domain_error("a sample is not a number");
        const auto bin = static_cast<std::size_t>(table(value * scale) * bin_count);
        ++counts_[std::min(bin, bin_count - 1)];
    }
}

void Gaussianity::merge(const Gaussianity& other) {
    std::ranges::transform(counts_, other.counts_, counts_.begin(), std::plus());
}

std::uint64_t Gaussianity::count() const {
    return std::reduce(counts_.begin(), counts_.end(), std::uint64_t(0));
}

/// With D = F_n - Phi as a function of u, T = n integral D^2 du. D is the true deviation plus a Brownian
/// bridge, delta + B / sqrt(n). So the variance of T is 1/45, that of the integral of B^2 (Anderson and
/// Darling, 1952), plus that of the linear term 2 sqrt(n) integral delta B:
///     4 n double integral delta(u) delta(v) (min(u, v) - u v) = 4 n Var H(U),  H' = delta, U uniform.
/// This is 4 Var H / (integral delta^2) times n integral delta^2, the expectation of T - 1/6; the first
/// factor is computed from D, not delta: noise makes it larger, which is safer. Far from a normal
/// distribution T is normal; for a normal one it is skewed, but |T - 1/6| <= 1.96 sqrt(1/45) with probability
/// 0.949, because its lower tail is bounded. In between, the interval is wider than needed. The tests
/// simulate all this.
Estimate Gaussianity::index(double deviation) const {
    const double n = static_cast<double>(count());
    const double bins = static_cast<double>(bin_count);
    // The edges of the bins as probabilities under the distribution with that deviation, and one past the
    // last.
    std::vector<double> edges{0};
    for (std::size_t i = 1; i < bin_count; ++i) {
        const double u = static_cast<double>(i) / bins;
        edges.push_back(deviation == 1 ? u : cdf(normal, quantile(normal, u) / deviation));
    }
    edges.insert(edges.end(), {1, 1 + 1 / bins});
    double squares = 0;   // n^2 integral D^2
    double primitive = 0; // n H
    double mean = 0;
    double mean_square = 0;
    std::uint64_t below = 0;
    for (std::size_t bin = 0; bin < bin_count; ++bin) {
        const double width = (edges[bin + 2] - edges[bin]) / 2; // trapezium rule
        below += counts_[bin];
        const double d = static_cast<double>(below) - n * edges[bin + 1]; // n D
        squares += width * d * d;
        primitive += width * d;
        mean += width * primitive;
        mean_square += width * primitive * primitive;
    }
    const double variance = mean_square - mean * mean;

    const double scale = cvm_scale / n;
    const Estimate excess = score_interval(squares / n - 1.0 / 6, 1.0 / 45, 4 * variance / squares);
    return {scale * excess.value, scale * excess.low, scale * excess.high};
}

} // namespace gabor::statistics
