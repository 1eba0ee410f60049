// Tests the number of points of a Poisson process. test_ingredients.cpp compares all points with the
// reference.

#include "study/ingredients.hpp"
#include "study/noise.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace gabor;

TEST_CASE("Poisson counts have Poisson's law at every mean", "[points]") {
    const vulkan::Device device;
    for (const int mean : {1, 2, 4, 10, 30, 70, 450}) {
        constexpr int side = 96;
        const study::PointSet set = study::point_set(device, {.impulses = mean}, side, 17);
        // Each bin is a range of counts in which at least 20 cells are expected.
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

TEST_CASE("the best lattice of 15 hexagons is nearly regular", "[points]") {
    const study::HexagonalLattice hex = study::hexagonal_lattice(15);
    CHECK(std::hypot(hex.b[0], hex.b[1]) < 1.05 * std::hypot(hex.a[0], hex.a[1]));
}
