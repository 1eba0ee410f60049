#include "noise/reference.hpp"
#include "render/bands.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace gabor;

namespace {

std::vector<float> rendered(const vulkan::Device& device, const render::Picture& picture,
                            const image::Window& region) {
    std::vector<float> pixels;
    render::render_bands(device, picture, region, [&](std::span<const float> rows) {
        pixels.insert(pixels.end(), rows.begin(), rows.end());
    });
    return pixels;
}

} // namespace

TEST_CASE("each pixel is the reference at its centre", "[render]") {
    const vulkan::Device device;
    for (const char* recipe : {"one", "pure", "paper"}) {
        // The far corner of the largest picture, at a scale that does not divide it.
        const render::Picture picture{65536, 65536, 31.7, 4, 123, 99, recipe};
        const image::Window region{65536 - 70, 65536 - 45, 70, 45};
        const std::vector<float> pixels = rendered(device, picture, region);
        const double radius = noise::find_recipe(recipe).radius;
        const noise::Reference reference(noise::find_recipe(recipe), 4, 123 * std::numbers::pi / 180, 99);
        REQUIRE(pixels.size() == 70 * 45);
        for (int y = 0; y < region.height; ++y) {
            for (int x = 0; x < region.width; ++x) {
                const double px = (region.x + x + 0.5) / picture.scale * radius;
                const double py = (region.y + y + 0.5) / picture.scale * radius;
                const noise::Position place{static_cast<int>(px), static_cast<int>(py),
                                            static_cast<float>(px - std::floor(px)),
                                            static_cast<float>(py - std::floor(py))};
                INFO("pixel " << x << ", " << y);
                REQUIRE(pixels[static_cast<std::size_t>(y * region.width + x)] ==
                        Approx(reference(place)).margin(1e-5));
            }
        }
    }
}

TEST_CASE("a region has the bits of the whole, whatever the bands", "[render]") {
    const vulkan::Device device;
    const render::Picture picture{2500, 4000, 20, 3, 20, 1, "one"}; // more than two bands
    const std::vector<float> whole = rendered(device, picture, {0, 0, picture.width, picture.height});
    for (const image::Window& region : {image::Window{0, 0, 1, 1}, image::Window{2499, 3999, 1, 1},
                                        image::Window{1, 1700, 2499, 333}, image::Window{777, 13, 9, 3987}}) {
        const std::vector<float> part = rendered(device, picture, region);
        REQUIRE(part.size() ==
                static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height));
        std::size_t i = 0;
        bool same = true;
        for (int y = region.y; y < region.y + region.height; ++y)
            for (int x = region.x; x < region.x + region.width; ++x)
                same &= part[i++] == whole[static_cast<std::size_t>(y) * 2500 + static_cast<std::size_t>(x)];
        CHECK(same);
    }
}

TEST_CASE("what the sink throws ends the rendering", "[render]") {
    const vulkan::Device device;
    const render::Picture picture{4096, 8192, 32, 4, 0, 1, "one"};
    int bands = 0;
    const auto sink = [&](std::span<const float>) {
        if (++bands == 2)
            throw 7;
    };
    CHECK_THROWS_AS(render::render_bands(device, picture, {0, 0, 4096, 8192}, sink), int);
    CHECK(bands == 2);
}
