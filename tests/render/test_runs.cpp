#include "render/bake.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace gabor;

TEST_CASE("runs cover every pixel once, within one set of cells", "[runs]") {
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

TEST_CASE("a part is cut where the whole is", "[runs]") {
    const auto whole = render::make_runs(0, 2000, 1 / 31.7, 1, 8);
    const auto part = render::make_runs(777, 500, 1 / 31.7, 1, 8);
    std::size_t i = 0;
    while (whole[i].first + whole[i].count <= 777)
        ++i;
    for (const passes::Run& run : part) {
        CHECK(run.first + 777 == whole[i].first);
        CHECK(run.count == whole[i].count);
        CHECK(run.cell == whole[i].cell);
        CHECK(run.local == whole[i].local);
        ++i;
    }
}
