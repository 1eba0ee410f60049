#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gabor::noise {

/// A sample point for a function's mean under a normal density in the plane, with its weight.
struct NormalPoint {
    double u; ///< position along the first axis, in deviations
    double v; ///< position along the second axis, in deviations
    double weight;
};

/// Points of the trapezoidal rule out to six deviations. Their spacing is at most `step`, in the unit of the
/// deviations, and at most two thirds of a deviation, at which the rule errs by less than 1e-15.
inline std::vector<NormalPoint> normal_points(const std::array<double, 2>& deviations, double step) {
    std::array<int, 2> half{};
    for (std::size_t i = 0; i < 2; ++i)
        if (deviations[i] >= 1e-7)
            half[i] = std::max(9, static_cast<int>(std::ceil(6 * deviations[i] / step)));
    std::vector<NormalPoint> points;
    double weights = 0;
    for (int j = -half[1]; j <= half[1]; ++j) {
        for (int i = -half[0]; i <= half[0]; ++i) {
            const double u = half[0] ? 6.0 * i / half[0] : 0;
            const double v = half[1] ? 6.0 * j / half[1] : 0;
            if (u * u + v * v > 36)
                continue;
            points.push_back({u, v, std::exp(-(u * u + v * v) / 2)});
            weights += points.back().weight;
        }
    }
    for (NormalPoint& point : points)
        point.weight /= weights;
    return points;
}

/// The correlation between two points x apart along an axis, for noise with Hann's window h: the integral of
/// h(t) h(t + x) divided by that of h^2.
inline double hann_correlation(double x) {
    x = std::abs(x);
    if (x >= 2)
        return 0;
    const double turn = std::numbers::pi * x;
    return ((2 - x) * (1 + 0.5 * std::cos(turn)) + 1.5 / std::numbers::pi * std::sin(turn)) / 3;
}

} // namespace gabor::noise
