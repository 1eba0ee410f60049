#include "statistics/gaussianity.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace gabor::statistics {

namespace {

/// Reading T off the edges of b bins errs by 1 / (6 b^2) on average and by 0.2 / b at random, against the
/// standard deviation sqrt(1/45) = 0.15 that T itself has for a normal law.
constexpr std::size_t bin_count = 4096;

} // namespace

Gaussianity::Gaussianity(double deviation) : Gaussianity(deviation, Counts(bin_count)) {}

Gaussianity::Gaussianity(double deviation, Counts counts)
    : deviation_(deviation), counts_(std::move(counts)) {
    if (counts_.size() != bin_count)
        throw std::invalid_argument("Gaussianity needs 4096 counts");
}

void Gaussianity::add(double value) {
    const float single = static_cast<float>(value);
    add(std::span(&single, 1));
}

void Gaussianity::add(std::span<const float> values) {
    count_uniform(values, 0, deviation_, counts_);
}

void Gaussianity::merge(const Gaussianity& other) {
    std::transform(counts_.begin(), counts_.end(), other.counts_.begin(), counts_.begin(), std::plus<>());
}

std::uint64_t Gaussianity::count() const {
    return std::reduce(counts_.begin(), counts_.end(), std::uint64_t(0));
}

/// With D = F_n - Phi as a function of u, T = n integral D^2 du. D is delta + B / sqrt(n), the true deviation
/// and a Brownian bridge, so that T has the variance 1/45 of the integral of B^2 (Anderson and Darling, 1952)
/// plus that of the linear term 2 sqrt(n) integral delta B:
///     4 n double integral delta(u) delta(v) (min(u, v) - u v) = 4 n Var H(U),  H' = delta, U uniform.
/// This is 4 Var H / (integral delta^2) times n integral delta^2, the expectation of T - 1/6; the first
/// factor is taken from D, where noise makes it larger than from delta, that is safer. Far from a normal law
/// T is normal; for a normal law it is skewed, but |T - 1/6| <= 1.96 sqrt(1/45) in 0.949 of all cases all the
/// same, because the lower tail ends before. Between the two the interval is wider than it need be. Simulated
/// in the tests.
Estimate Gaussianity::index() const {
    const double n = static_cast<double>(count());
    const double bins = static_cast<double>(bin_count);
    const std::vector<double> deviation = deviations(counts_); // n D
    std::vector<double> primitive;                             // n H
    for (const double d : deviation)
        primitive.push_back((primitive.empty() ? 0 : primitive.back()) + d / bins);
    const double squares = integrate_product(deviation, deviation);
    const double mean = std::reduce(primitive.begin(), primitive.end()) / bins;
    const double variance = integrate_product(primitive, primitive) - mean * mean;

    const double scale = cvm_scale / n;
    const Estimate excess = score_interval(squares / n - 1.0 / 6, 1.0 / 45, 4 * variance / squares, 1.96);
    return {scale * excess.value, scale * excess.low, scale * excess.high};
}

} // namespace gabor::statistics
