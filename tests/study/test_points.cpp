// Tests the numbers and positions of the points in each point set.

#include "study/ingredients.hpp"
#include "study/noise.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace gabor;
using study::Points;

TEST_CASE("each cell has exactly N impulses, even if N is prime", "[points]") {
    const vulkan::Device device;
    for (const Points points : study::all_points)
        for (const int n : {1, 2, 3, 5, 8, 13, 29}) {
            if (points == Points::poisson)
                continue;
            for (const auto& cell : study::point_set(device, {.points = points, .impulses = n}, 9, 3))
                REQUIRE(cell.size() == static_cast<std::size_t>(n));
        }
}

TEST_CASE("Poisson counts have Poisson's law at every mean", "[points]") {
    const vulkan::Device device;
    for (const int mean : {1, 2, 4, 10, 30, 70, 450}) {
        constexpr int side = 96;
        const study::PointSet set = study::point_set(device, {.impulses = mean}, side, 17);
        // Each bin has whole counts, and at least 20 are expected in it.
        const double cells = side * side;
        double chi = 0;
        int bins = 0;
        double expected = 0;
        double seen = 0;
        double expected_before = 0;
        double seen_before = 0;
        for (int k = 0; expected_before + expected < cells - 20; ++k) {
            expected += cells * std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0));
            seen += static_cast<double>(std::ranges::count(set, static_cast<std::size_t>(k),
                                                           [](const auto& cell) { return cell.size(); }));
            if (expected < 20)
                continue;
            chi += std::pow(seen - expected, 2) / expected;
            ++bins;
            expected_before += expected;
            seen_before += seen;
            expected = seen = 0;
        }
        const double rest = cells - expected_before;
        chi += std::pow(cells - seen_before - rest, 2) / rest;
        INFO("mean " << mean << ": chi^2 " << chi << " of " << bins << " degrees of freedom");
        CHECK(std::abs(chi - bins) < 3.5 * std::sqrt(2.0 * bins));
    }
}

TEST_CASE("each sub-cell of equal area has one jittered point", "[points]") {
    const vulkan::Device device;
    for (const int n : {4, 9, 16}) {
        const int rows = static_cast<int>(std::lround(std::sqrt(n)));
        const study::PointSet set =
            study::point_set(device, {.points = Points::jittered, .impulses = n}, 4, 5);
        std::set<std::pair<int, int>> taken;
        for (const auto& cell : set)
            for (const study::Point& p : cell)
                taken.emplace(static_cast<int>(std::floor(p.x * static_cast<float>(rows))),
                              static_cast<int>(std::floor(p.y * static_cast<float>(rows))));
        CHECK(taken.size() == static_cast<std::size_t>(16 * n));
    }
}

TEST_CASE("hexagons tile without gaps: each point is nearest to its own centre, across all cells",
          "[points]") {
    const vulkan::Device device;
    for (const int n : {2, 4, 7, 12, 29}) {
        const study::HexagonalLattice hex = study::hexagonal_lattice(n);
        const study::PointSet set =
            study::point_set(device, {.points = Points::jittered_hex, .impulses = n}, 5, 5);
        for (std::size_t cell = 0; cell < set.size(); ++cell)
            for (int k = 0; k < n; ++k) {
                const study::Point p = set[cell][static_cast<std::size_t>(k)];
                const auto distance = [&](int i, int j, int index) {
                    return std::hypot(double{p.x} - i - (index + 0.5) / n,
                                      double{p.y} - j - (index * hex.step % n + 0.5) / n);
                };
                const int x = static_cast<int>(cell % 5);
                const int y = static_cast<int>(cell / 5);
                double nearest = 9;
                for (int j = y - 1; j <= y + 1; ++j)
                    for (int i = x - 1; i <= x + 1; ++i)
                        for (int index = 0; index < n; ++index)
                            nearest = std::min(nearest, distance(i, j, index));
                REQUIRE(distance(x, y, k) <= nearest + 1e-5);
            }
    }
    // For 15 points, the best lattice is nearly regular: distances to neighbours differ by at most 5 %.
    const study::HexagonalLattice hex = study::hexagonal_lattice(15);
    CHECK(std::hypot(hex.b[0], hex.b[1]) < 1.05 * std::hypot(hex.a[0], hex.a[1]));
}

TEST_CASE("each elementary interval has one of 2^k scrambled Sobol points", "[points]") {
    const vulkan::Device device;
    const study::PointSet set =
        study::point_set(device, {.points = Points::scrambled_sobol, .impulses = 16}, 6, 5);
    for (int x_bits = 0; x_bits <= 4; ++x_bits) {
        const float columns = static_cast<float>(1 << x_bits);
        const float rows = static_cast<float>(1 << (4 - x_bits));
        std::set<std::pair<int, int>> intervals;
        for (const auto& cell : set)
            for (const study::Point& p : cell)
                intervals.emplace(static_cast<int>(std::floor(p.x * columns)),
                                  static_cast<int>(std::floor(p.y * rows)));
        CHECK(intervals.size() == 16 * set.size());
    }
}
