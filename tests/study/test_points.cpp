// Tests the number of points of a Poisson process. test_ingredients.cpp compares all points with the
// reference.

#include "study/ingredients.hpp"
#include "study/noise.hpp"

#include <boost/math/distributions/poisson.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace gabor;

TEST_CASE("Poisson counts have the Poisson distribution at every mean", "[points]") {
    const vulkan::Device device;
    for (const int mean : {1, 2, 4, 10, 30, 70, 450}) {
        constexpr int side = 96;
        const study::PointSet set = study::point_set(device, {.impulses = mean}, side, 17);
        std::vector<double> counts;
        for (const auto& cell : set)
            counts.push_back(static_cast<double>(cell.size()));
        // Each bin is a range of counts up to a quantile.
        const boost::math::poisson law(mean);
        double chi = 0, below = -1, share = 0;
        int bins = -1;
        for (int k = 1; k <= 50; ++k) {
            const double to = k == 50 ? 1e9 : boost::math::quantile(law, k / 50.0);
            if (to == below)
                continue;
            const double expected = side * side * (boost::math::cdf(law, to) - share);
            const auto seen = std::ranges::count_if(counts, [&](double c) { return c > below && c <= to; });
            chi += std::pow(static_cast<double>(seen) - expected, 2) / expected;
            ++bins;
            below = to;
            share = boost::math::cdf(law, to);
        }
        INFO("mean " << mean << ": chi^2 " << chi << " of " << bins << " degrees of freedom");
        CHECK(std::abs(chi - bins) < 3.5 * std::sqrt(2.0 * bins));
    }
}

TEST_CASE("the best lattice of 15 hexagons is nearly regular", "[points]") {
    const study::HexagonalLattice hex = study::hexagonal_lattice(15);
    CHECK(std::hypot(hex.b[0], hex.b[1]) < 1.05 * std::hypot(hex.a[0], hex.a[1]));
}
