#include "noise/recipe.hpp"
#include "noise/spectrum.hpp"
#include "reference/lattice.hpp"
#include "reference/sum.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <vector>

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

TEST_CASE("a recipe's waves are those of the spread, up to 16 frequencies and 64 directions") {
    const std::uint32_t seed = 9;
    for (const auto& [frequency, frequency_spread, orientation_spread, count] :
         {std::tuple{2.5, 0.4, 60.0, 0u},
          {0.6, 0.1, 0.0, 1u},
          {6.0, 1.0, 0.0, 16u},
          {20.0, 0.0, 90.0, 64u},
          {60.0, 0.2, 90.0, 1024u}}) {
        const noise::Lobe lobe{frequency, 20, frequency_spread, orientation_spread};
        const std::vector<noise::Wave> waves = noise::waves(std::array{lobe}, seed);
        const std::vector<noise::SpectrumLobe> expected = noise::spread_lobes(
            frequency, noise::radians(20), frequency_spread, noise::radians(orientation_spread), seed);
        REQUIRE(waves.size() == expected.size());
        CHECK((count == 0 || waves.size() == count));
        for (std::size_t i = 0; i < waves.size(); ++i) {
            CHECK(waves[i].frequency == Approx(expected[i].frequency));
            CHECK(waves[i].angle == Approx(expected[i].orientation));
            CHECK(waves[i].share == Approx(expected[i].power));
            CHECK(waves[i].seed == expected[i].seed);
        }
    }
}

TEST_CASE("in space, a wave for all directions replaces those of an isotropic spread") {
    const std::vector<noise::Wave> one =
        noise::waves(std::array{noise::Lobe{.frequency = 3, .orientation_spread = 90}}, 9, true);
    REQUIRE(one.size() == 1);
    CHECK((one[0].isotropic && one[0].frequency == 3 && one[0].share == 1 && one[0].seed == 9));
    const noise::Lobe lobe{
        .frequency = 2.5, .frequency_spread = 0.4, .orientation_spread = 90, .radius = 0.5, .stretch = 4};
    const std::vector<noise::Wave> three = noise::waves(std::array{lobe}, 9, true);
    REQUIRE(three.size() == 3); // an odd number of waves has seeds of its own
    for (int i = 0; i < 3; ++i) {
        const noise::Wave& wave = three[static_cast<std::size_t>(i)];
        CHECK(wave.isotropic);
        CHECK(wave.frequency == Approx(2.5 * (1 + 0.4 * (2 * i - 2) / 3)));
        CHECK(wave.radius == std::array{1.0, 1.0});
        CHECK(wave.share == Approx(1.0 / 3));
        CHECK(wave.seed == noise::lattice_derived_seed(9, 128 * (64 + i)));
    }
}
