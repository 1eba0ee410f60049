// passes/bake.comp, block by block, and passes/pixels.comp, pixel by pixel, draw the same picture.

#include "largest.hpp"
#include "render/parameters.hpp"
#include "render/renderer.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace gabor;

namespace {

// Draws plans with a renderer that keeps its pipelines.
std::vector<float> filled(render::Renderer& renderer, const render::Request& request,
                          const image::Rect& region, render::Blocks blocks) {
    render::Viewport viewport = render::viewport_of(request, region);
    viewport.blocks = blocks;
    renderer.set(render::plan(request, viewport));
    std::vector<float> values;
    render::render_plan(renderer.device(), renderer, [&](std::span<const float> rows) {
        values.insert(values.end(), rows.begin(), rows.end());
    });
    return values;
}

// The request with its phasor, which only passes/pixels.comp draws.
render::Request with_phasor(render::Request request) {
    request.phasor = true;
    return request;
}

// Compares a region, and its phasor with its values.
void check_blocks_are_pixels(render::Renderer& renderer, const render::Request& request,
                             const image::Rect& region) {
    render::check(request);
    REQUIRE(render::uses_blocks(request, render::viewport_of(request, region)));
    const std::vector<float> blocks = filled(renderer, request, region, render::Blocks::fitted);
    const std::vector<float> pixels = filled(renderer, with_phasor(request), region, render::Blocks::none);
    const std::vector<std::string> names = render::channels(request);
    const std::size_t all = names.size() + 2; // phase and intensity
    const auto count = static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height);
    REQUIRE(blocks.size() == count * names.size());
    REQUIRE(pixels.size() == count * all);
    std::vector<test::Largest> largest(names.size());
    test::Largest phasor_sine;
    float lowest = blocks.front();
    float highest = blocks.front();
    for (std::size_t i = 0; i < count; ++i) {
        const auto place = [&] { return fmt::format("pixel {}", i); };
        for (std::size_t c = 0; c < names.size(); ++c) {
            largest[c].see(pixels[i * all + c], blocks[i * names.size() + c],
                           names[c].starts_with("gradient") ? 1e-3 : 4e-5, place);
        }
        const double turn = 2 * std::numbers::pi * pixels[i * all + names.size()];
        phasor_sine.see(pixels[i * all + names.size() + 1] * std::sin(turn), pixels[i * all], 1e-4, place);
        lowest = std::min(lowest, blocks[i * names.size()]);
        highest = std::max(highest, blocks[i * names.size()]);
    }
    INFO(request.recipe.name << ", scale " << request.scale << ", region " << region.x << "," << region.y);
    for (std::size_t c = 0; c < names.size(); ++c)
        largest[c].check(names[c]);
    phasor_sine.check("phasor");
    CHECK(highest - lowest > 0.1f);
}

} // namespace

TEST_CASE("drawing pixel by pixel equals drawing by blocks", "[pixels]") {
    const vulkan::Device device;
    render::Renderer renderer(device);
    for (const char* recipe : {"lattice", "lattice-2", "lattice-4", "one", "pure", "paper"}) {
        for (const bool tileable : {false, true}) {
            const render::Request request{.width = 300,
                                          .height = 200,
                                          .scale = 20,
                                          .recipe = noise::find_recipe(recipe),
                                          .lobes = {{4, 25}},
                                          .time = 0.2,
                                          .view = render::Plane{.tileable = tileable},
                                          .quadrature = true,
                                          .gradient = true};
            check_blocks_are_pixels(renderer, request, {0, 0, 300, 200});
        }
    }
}

TEST_CASE("blocks are pixels on both sides of a cell at large scales", "[pixels]") {
    const vulkan::Device device;
    render::Renderer renderer(device);
    for (const auto& [recipe, cells_per_radius] : {std::pair("lattice", 1.5),
                                                   {"lattice-2", 1.0},
                                                   {"lattice-4", 2.0},
                                                   {"one", 1.0},
                                                   {"paper", 1.0},
                                                   {"pure", 1.5}}) {
        render::Request request{
            .width = 16384, .height = 16384, .recipe = noise::find_recipe(recipe), .lobes = {{6, 25}}};
        for (const double scale : {999.5, 1507.0, 4096.0}) {
            request.scale = scale;
            const double cell = scale / cells_per_radius;
            check_blocks_are_pixels(renderer, request,
                                    {static_cast<int>(2 * cell) - 40, static_cast<int>(cell) - 21, 83, 61});
        }
    }
}

TEST_CASE("blocks are pixels in every corner of the largest picture", "[pixels]") {
    const vulkan::Device device;
    render::Renderer renderer(device);
    const render::Request request{.width = 65536, .height = 65536, .scale = 7.7, .lobes = {{2, 25}}};
    for (const int x : {0, 65536 - 37})
        for (const int y : {0, 65536 - 45})
            check_blocks_are_pixels(renderer, request, {x, y, 37, 45});
}
