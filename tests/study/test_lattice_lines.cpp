// Checks that the lattice does not show in power spectra. If the noise is standard normal at every place,
// E[f(n)] is the same everywhere for every f. Otherwise it repeats from node to node and makes peaks at whole
// numbers of cycles per node spacing. GABOR_LAW_SAMPLES sets the number of pixels.

#include "../functions/law.hpp"
#include "render/parameters.hpp"
#include "render/renderer.hpp"
#include "statistics/lines.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

using namespace gabor;

namespace {

constexpr int pictures = 12; // independent, because they use different nodes

// The side of each picture, in pixels.
int picture_side() {
    const double side = std::clamp(std::sqrt(test::law_samples() / 6), 256.0, 4096.0);
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(side)));
}

using statistics::NoiseLines;
using Peaks = std::array<double, NoiseLines::count>;

// With 12 pictures, one of the six frequencies exceeds this by chance in one of 2500 runs.
constexpr double beyond_chance = 2.5;

// The largest peak of each function at the lattice's frequencies. `modulation` is that of the amplitude along
// x, with one cycle per cell.
Peaks peaks(const vulkan::Device& device, const char* recipe, double frequency, double modulation = 0) {
    const int side = picture_side();
    render::Request request;
    request.recipe = noise::find_recipe(recipe);
    request.lobes[0].frequency = frequency;
    request.lobes[0].orientation = 0;
    request.scale = statistics::Lines::pixels_per_cell * double{request.recipe.radius};
    request.seed = 1;
    request.width = side;
    request.height = pictures * side;
    render::check(request);

    NoiseLines lines(side);
    std::vector<float> modulated(static_cast<std::size_t>(side));
    render::render_region(
        device, request, {0, 0, request.width, request.height}, [&](std::span<const float> rows) {
            for (; !rows.empty(); rows = rows.subspan(modulated.size())) {
                for (std::size_t x = 0; x < modulated.size(); ++x)
                    modulated[x] =
                        rows[x] * static_cast<float>(1 + modulation * std::cos(std::numbers::pi / 2 *
                                                                               static_cast<double>(x % 4)));
                lines.add_row(modulated);
            }
        });

    const Peaks result = lines.largest();
    fmt::print("  {:<10} frequency {:<4} ", recipe, frequency);
    for (std::size_t f = 0; f < result.size(); ++f)
        fmt::print(" {}: {:.2f}", NoiseLines::names[f], result[f]);
    fmt::print("\n");
    return result;
}

} // namespace

TEST_CASE("the lattice does not show in power spectra", "[law]") {
    const vulkan::Device device;
    fmt::print(
        "{} pictures of {} x {} pixels on {}; power at the lattice's frequencies over its surroundings:\n",
        pictures, picture_side(), picture_side(), device.info().name);
    for (const double frequency : {1.5, 4.0}) {
        INFO("frequency " << frequency);
        for (const char* recipe : {"lattice", "lattice-4"}) {
            for (const double peak : peaks(device, recipe, frequency)) {
                INFO(recipe);
                CHECK(peak > 0.3);
                CHECK(peak < beyond_chance);
            }
        }
        // With two taps a single amplitude determines the value at a node; its law is only nearly normal,
        // which shows in the tails.
        const Peaks two = peaks(device, "lattice-2", frequency);
        CHECK(two[NoiseLines::value] < beyond_chance);
        CHECK(two[NoiseLines::square] < beyond_chance);
        // The test detects the kurtosis of `one`, which depends on the place, and an amplitude modulation
        // of 2 %.
        const Peaks one = peaks(device, "one", frequency);
        for (const std::size_t f : {NoiseLines::magnitude, NoiseLines::fourth_power, NoiseLines::tails})
            CHECK(one[f] > 20);
        CHECK(peaks(device, "lattice", frequency, 0.02)[NoiseLines::square] > 2 * beyond_chance);
    }
}
