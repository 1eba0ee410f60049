#include "noise/recipe.hpp"

#include "error.hpp"

#include <catch2/catch.hpp>

#include <tuple>

using namespace gabor;

TEST_CASE("custom recipes are parsed, printed and checked") {
    const noise::Recipe own = noise::find_recipe("N=2,R=1.25,A=0.5,phases=64,window=1:0.5:0");
    CHECK(own.impulses == 2);
    CHECK(own.radius == 1.25f);
    CHECK(own.weight_floor == 0.5f);
    CHECK(own.phases == 64);
    CHECK(own.window == std::array{1.0f, 0.5f, 0.0f});
    CHECK(noise::to_string(own) == "N=2,R=1.25,A=0.5,phases=64,window=1:0.5:0");
    for (const noise::Recipe& recipe : noise::recipes())
        CHECK(noise::to_string(recipe) == recipe.name);
    for (const char* extreme :
         {"N=16,R=3,A=1,phases=256,window=99:-0.5:0.5", "N=1,R=1,A=0,phases=2,window=0:0.02:0"})
        CHECK(noise::to_string(noise::find_recipe(extreme)) == extreme);
    for (const char* wrong :
         {"N=0,R=1,A=0.5,phases=64,window=1:0:0", "N=17,R=1,A=0.5,phases=64,window=1:0:0",
          "N=1,R=0.9,A=0.5,phases=64,window=1:0:0", "N=1,R=3.1,A=0.5,phases=64,window=1:0:0",
          "N=1,R=1,A=1.1,phases=64,window=1:0:0", "N=1,R=1,A=-0.1,phases=64,window=1:0:0",
          "N=1,R=1,A=0.5,phases=3,window=1:0:0", "N=1,R=1,A=0.5,phases=1,window=1:0:0",
          "N=1,R=1,A=0.5,phases=512,window=1:0:0", "N=1,R=1,A=0.5,phases=64,window=0.005:0:0",
          "N=1,R=1,A=0.5,phases=64,window=99:-1:0.5", "N=1,R=1,A=0.5,phases=64,window=1:0:0,",
          "N=1,R=1,A=0.5,phases=64,window=1:0", "N=1,R=nan,A=0.5,phases=64,window=1:0:0"})
        CHECK_THROWS_AS(noise::find_recipe(wrong), RequestError);
}

// The README, the published figures and users' pixels depend on these values.
TEST_CASE("recipes have their published values and visit the expected number of impulses") {
    for (const auto& [values, name, visited] :
         {std::tuple{"N=1,R=1,A=0.675,phases=256,window=3:-4.5:2.5", "one", 9},
          {"N=1,R=1.5,A=0.5,phases=256,window=1:-1:1", "pure", 16},
          {"N=2,R=1,A=1,phases=2,window=1:0:0", "paper", 18},
          {"N=3,R=1.5,A=0.2,phases=2,window=0.5:1.5:-1", "custom", 48}}) {
        const noise::Recipe recipe = noise::find_recipe(values);
        CHECK(recipe.name == name);
        CHECK(noise::visited_impulses(recipe) == visited);
    }
    CHECK_THROWS_WITH(noise::find_recipe("two"), Catch::Contains("one") && Catch::Contains("paper"));
}
