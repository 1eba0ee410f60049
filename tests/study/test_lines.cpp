#include "statistics/lines.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

using gabor::statistics::Lines;
using gabor::statistics::NoiseLines;

namespace {

constexpr int side = 64;
constexpr double turn = 2 * std::numbers::pi;

// Returns the largest line of white noise of variance 1 plus a wave; frequencies are in cycles per cell.
double largest_with(double amplitude, double x_cycles, double y_cycles) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    Lines lines(side);
    std::vector<float> row(side);
    for (int y = 0; y < 12 * side; ++y) {
        for (int x = 0; x < side; ++x)
            row[static_cast<std::size_t>(x)] = static_cast<float>(
                normal(random) +
                amplitude * std::cos(turn * (x_cycles * x + y_cycles * y) / Lines::pixels_per_cell + 1));
        lines.add_row(row);
    }
    return lines.largest();
}

} // namespace

TEST_CASE("a wave at a cell frequency is a line with the power predicted by theory", "[lines]") {
    // A wave of amplitude a has the power (a / 2)^2 side^4, and white noise side^2.
    const double amplitude = 0.2;
    const double expected = 1 + std::pow(amplitude / 2 * side, 2);
    for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}, {1, 2}, {2, 1}, {-1, 0}, {3, 1}})
        CHECK(largest_with(amplitude, x, y) == Approx(expected).epsilon(0.3)); // three standard errors
}

TEST_CASE("white noise and a wave off the cell frequencies give no line", "[lines]") {
    CHECK(largest_with(0, 0, 0) > 0.5);
    CHECK(largest_with(0, 0, 0) < 2);
    CHECK(largest_with(0.2, 1 + 1.0 / 16, 0) < 2);
    CHECK(largest_with(0.2, 1.5, 0.25) < 2);
}

TEST_CASE("lines need a picture of whole cells", "[lines]") {
    CHECK(std::isnan(Lines(side).largest()));
    CHECK_THROWS_AS(Lines(30), std::invalid_argument);
    CHECK_THROWS_AS(Lines(16), std::invalid_argument);
}
