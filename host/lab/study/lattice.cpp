#include "study/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gabor::study {

double lattice_window(int taps, double x) {
    const double d = std::abs(x);
    if (d >= 1)
        return 0;
    if (taps > 2)
        return 0.5 + 0.5 * std::cos(std::numbers::pi * d);
    const double c = (1 - d) * (1 - d) * (1 + 2 * d);
    return c / std::hypot(c, 1 - c);
}

CovarianceOverCell lattice_covariance(int taps, const std::array<double, 2>& lag, int side) {
    const double spacing = 2.0 / taps; // distance between nodes, in kernel radii
    // Returns the nodes' sum of window products at each position, divided by their sum of squared windows.
    const auto along = [&](double distance) {
        std::vector<double> sums;
        for (int place = 0; place < side; ++place) {
            double sum = 0;
            double power = 0;
            for (int node = -taps; node <= taps; ++node) {
                const double x = (static_cast<double>(place) / side - node) * spacing;
                sum += lattice_window(taps, x) * lattice_window(taps, x + distance);
                power += std::pow(lattice_window(taps, x), 2);
            }
            sums.push_back(sum / power);
        }
        return sums;
    };
    const std::vector<double> columns = along(lag[0]);
    const std::vector<double> rows = along(lag[1]);
    CovarianceOverCell result;
    for (const double a : columns)
        for (const double b : rows)
            result.mean += a * b / (side * side);
    int crossing = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (x + lag[0] / spacing * side < side && y + lag[1] / spacing * side < side)
                continue;
            const double difference =
                columns[static_cast<std::size_t>(x)] * rows[static_cast<std::size_t>(y)] - result.mean;
            result.rms += difference * difference;
            result.largest = std::max(result.largest, std::abs(difference));
            ++crossing;
        }
    }
    result.rms = std::sqrt(result.rms / std::max(crossing, 1));
    return result;
}

} // namespace gabor::study
