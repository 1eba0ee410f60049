#include "statistics/moments.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::statistics {

void Moments::add(double value) {
    Moments one;
    one.count_ = 1;
    one.mean_ = one.minimum_ = one.maximum_ = value;
    merge(one);
}

void Moments::add(std::span<const float> values) {
    // Short runs stay in the cache for the second pass, which computes moments about their own mean.
    constexpr std::size_t run_length = 4096;
    while (!values.empty()) {
        const auto run = values.first(std::min(run_length, values.size()));
        values = values.subspan(run.size());

        Moments part;
        part.count_ = run.size();
        double sum = 0;
        for (const double value : run) {
            sum += value;
            part.minimum_ = std::min(part.minimum_, value);
            part.maximum_ = std::max(part.maximum_, value);
        }
        part.mean_ = sum / static_cast<double>(run.size());
        for (const float value : run) {
            const double d = value - part.mean_;
            const double d2 = d * d;
            part.m2_ += d2;
            part.m3_ += d2 * d;
            part.m4_ += d2 * d2;
        }
        merge(part);
    }
}

void Moments::merge(const Moments& b) {
    const Moments a = *this;
    if (b.count_ == 0)
        return;
    const double na = static_cast<double>(a.count_);
    const double nb = static_cast<double>(b.count_);
    const double n = na + nb;
    const double d = (b.mean_ - a.mean_) / n;
    const double d2 = d * d;

    count_ = a.count_ + b.count_;
    mean_ = a.mean_ + nb * d;
    m2_ = a.m2_ + b.m2_ + d2 * n * na * nb;
    m3_ = a.m3_ + b.m3_ + d2 * d * n * na * nb * (na - nb) + 3 * d * (na * b.m2_ - nb * a.m2_);
    m4_ = a.m4_ + b.m4_ + d2 * d2 * n * na * nb * (na * na - na * nb + nb * nb) +
          6 * d2 * (na * na * b.m2_ + nb * nb * a.m2_) + 4 * d * (na * b.m3_ - nb * a.m3_);
    minimum_ = std::min(a.minimum_, b.minimum_);
    maximum_ = std::max(a.maximum_, b.maximum_);
}

double Moments::skewness() const {
    return std::sqrt(static_cast<double>(count_)) * m3_ / std::pow(m2_, 1.5);
}

double Moments::excess_kurtosis() const {
    return static_cast<double>(count_) * m4_ / (m2_ * m2_) - 3;
}

} // namespace gabor::statistics
