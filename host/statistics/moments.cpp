#include "statistics/moments.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::statistics {

void Moments::add(double value) {
    merge(Moments({1, value, 0, 0, 0, value, value}));
}

void Moments::add(std::span<const float> values) {
    // Short runs stay in the cache for the second pass, which computes moments about their own mean.
    constexpr std::size_t run_length = 4096;
    while (!values.empty()) {
        const auto run = values.first(std::min(run_length, values.size()));
        values = values.subspan(run.size());

        State part;
        part.count = run.size();
        double sum = 0;
        for (const double value : run) {
            sum += value;
            part.minimum = std::min(part.minimum, value);
            part.maximum = std::max(part.maximum, value);
        }
        part.mean = sum / static_cast<double>(run.size());
        for (const float value : run) {
            const double d = value - part.mean;
            const double d2 = d * d;
            part.m2 += d2;
            part.m3 += d2 * d;
            part.m4 += d2 * d2;
        }
        merge(Moments(part));
    }
}

void Moments::merge(const Moments& other) {
    const State a = state_;
    const State& b = other.state_;
    if (b.count == 0)
        return;
    const double na = static_cast<double>(a.count);
    const double nb = static_cast<double>(b.count);
    const double n = na + nb;
    const double d = (b.mean - a.mean) / n;
    const double d2 = d * d;

    state_.count = a.count + b.count;
    state_.mean = a.mean + nb * d;
    state_.m2 = a.m2 + b.m2 + d2 * n * na * nb;
    state_.m3 = a.m3 + b.m3 + d2 * d * n * na * nb * (na - nb) + 3 * d * (na * b.m2 - nb * a.m2);
    state_.m4 = a.m4 + b.m4 + d2 * d2 * n * na * nb * (na * na - na * nb + nb * nb) +
                6 * d2 * (na * na * b.m2 + nb * nb * a.m2) + 4 * d * (na * b.m3 - nb * a.m3);
    state_.minimum = std::min(a.minimum, b.minimum);
    state_.maximum = std::max(a.maximum, b.maximum);
}

double Moments::skewness() const {
    return std::sqrt(static_cast<double>(state_.count)) * state_.m3 / std::pow(state_.m2, 1.5);
}

double Moments::excess_kurtosis() const {
    return static_cast<double>(state_.count) * state_.m4 / (state_.m2 * state_.m2) - 3;
}

} // namespace gabor::statistics
