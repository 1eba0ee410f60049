#include "noise/recipe.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>
#include <tuple>

using namespace gabor;

// The README, the published figures and users' pixels depend on these values.
TEST_CASE("recipes have their published values and visit the expected number of impulses") {
    using Values = std::tuple<int, float, float, int, std::array<float, 3>>;
    for (const auto& [name, published, visited] :
         {std::tuple{"one", Values{1, 1.0f, 0.675f, 256, {3, -4.5f, 2.5f}}, 9},
          {"pure", Values{1, 1.5f, 0.5f, 256, {1, -1, 1}}, 16},
          {"paper", Values{2, 1.0f, 1.0f, 2, {1, 0, 0}}, 18}}) {
        const noise::Recipe& r = noise::find_recipe(name);
        CHECK(r.name == name);
        CHECK(Values{r.impulses, r.radius, r.weight_floor, r.phases, r.window} == published);
        CHECK(noise::visited_impulses(r) == visited);
    }
    CHECK(noise::visited_impulses({"", 3, 1.5f, 0.2f, 2, {0.5f, 1.5f, -1}, ""}) == 48);
    CHECK_THROWS_AS(noise::find_recipe("two"), std::out_of_range);
}
