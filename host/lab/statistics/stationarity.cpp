#include "statistics/stationarity.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>

namespace gabor::statistics {

void InstanceStationarity::add(std::span<const float> window) {
    Moments moments;
    moments.add(window);
    contrasts_.push_back(moments.variance());
}

double InstanceStationarity::median_deviation() const {
    std::vector<double> deviations;
    std::ranges::transform(contrasts_, std::back_inserter(deviations), [](double c) { return std::sqrt(c); });
    return quantile(deviations, 0.5);
}

Moments ProcessStationarity::all() const {
    Moments all;
    for (const Moments& place : places_)
        all.merge(place);
    return all;
}

Dispersion ProcessStationarity::variance() const {
    std::vector<double> variances;
    std::ranges::transform(places_, std::back_inserter(variances), &Moments::variance);
    return dispersion(variances);
}

// The variance of n samples is nearly normal, with the relative variance (excess kurtosis + 2) / n.
double ProcessStationarity::chance_interdecile() const {
    const double n = static_cast<double>(places_.front().count());
    return 2 * quantile(boost::math::normal(), 0.9) * std::sqrt((all().excess_kurtosis() + 2) / n);
}

double ProcessStationarity::largest_mean() const {
    double largest = 0;
    for (const Moments& place : places_)
        largest = std::max(largest, std::abs(place.mean()));
    return largest;
}

double ProcessStationarity::chance_largest_mean() const {
    const double n = static_cast<double>(places_.front().count());
    const double count = static_cast<double>(places_.size());
    return quantile(boost::math::normal(), 1 - 0.05 / (2 * count)) * std::sqrt(all().variance() / n);
}

} // namespace gabor::statistics
