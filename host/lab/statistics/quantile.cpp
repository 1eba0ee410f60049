#include "statistics/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gabor::statistics {

double quantile(std::vector<double> values, double share) {
    if (values.empty())
        throw std::invalid_argument("no values to take a quantile of");
    std::ranges::sort(values);
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], rank - static_cast<double>(below));
}

Dispersion dispersion(const std::vector<double>& values) {
    const double median = quantile(values, 0.5);
    return {median, (quantile(values, 0.9) - quantile(values, 0.1)) / median};
}

} // namespace gabor::statistics
