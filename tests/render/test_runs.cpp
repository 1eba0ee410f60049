#include "render/plan/plan_parts.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace gabor;

TEST_CASE("runs cover every pixel once, and all pixels of a run visit the same cells", "[runs]") {
    for (const double cells_per_pixel : {0.5, 0.75, 0.43, 1 / 31.7, 1.5 / 32, 1.0 / 4096}) {
        for (const double radius : {1.0, 1.06, 1.5}) {
            for (const int first : {0, 1, 17, 65000}) {
                int next = 0;
                for (const passes::Run& run : render::make_runs(first, 500, cells_per_pixel, radius, 8)) {
                    REQUIRE(run.count >= 1);
                    REQUIRE(run.count <= 8);
                    REQUIRE((next == 0 ? run.first <= 0 && run.first + run.count > 0 : run.first == next));
                    next = run.first + run.count;
                    const double start = (first + run.first + 0.5) * cells_per_pixel;
                    const double end = start + (run.count - 1) * cells_per_pixel;
                    REQUIRE(std::floor(start - radius) == run.cell);
                    REQUIRE(std::floor(end - radius) == run.cell);
                    REQUIRE(run.local == Approx(start - run.cell - 1).margin(1e-6));
                }
                REQUIRE(next >= 500);
            }
        }
    }
}

TEST_CASE("part of a row is cut into the same runs as the whole row, at any scale", "[runs]") {
    std::mt19937 random(5);
    for (int round = 0; round < 20000; ++round) {
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<>(low, high)(random);
        };
        const double cells_per_pixel = std::exp2(uniform(-8, 0));
        const double radius = round % 2 ? uniform(0.5, 2) : 0.5 * (1 + round % 4);
        const int longest = 1 << round % 5;
        const int first = static_cast<int>(uniform(0, 300));
        const auto whole = render::make_runs(0, 330, cells_per_pixel, radius, longest);
        const auto part = render::make_runs(first, 20, cells_per_pixel, radius, longest);
        std::size_t i = 0;
        while (whole[i].first + whole[i].count <= first)
            ++i;
        for (const passes::Run& run : part) {
            INFO(cells_per_pixel << " cells per pixel, radius " << radius << ", at most " << longest
                                 << ", from " << first);
            REQUIRE(run.first + first == whole[i].first);
            REQUIRE(run.count == whole[i].count);
            REQUIRE(run.cell == whole[i].cell);
            REQUIRE(run.local == whole[i].local);
            ++i;
        }
    }
}
