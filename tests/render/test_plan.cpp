// Tests how requests become plans, which are plain values and need no device.

#include "render/output/erosion.hpp"
#include "render/output/maps.hpp"
#include "render/plan/plan_parts.hpp"
#include "render/request/material.hpp"
#include "set_text.hpp"

#include "passes/bake_interface.h"
#include "passes/erode_interface.h"
#include "passes/line.h"
#include "passes/material_interface.h"
#include "passes/ocean_interface.h"
#include "passes/pictures.h"
#include "passes/pixels_interface.h"
#include "passes/solid_interface.h"
#include "passes/terrain_interface.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gabor;
using namespace gabor::render;

namespace {

Request request_of(const std::vector<std::pair<std::string, std::string>>& values) {
    Request request{.width = 150, .height = 113};
    for (const auto& [name, value] : values)
        set_text(request, name, value);
    check(request);
    return request;
}

Plan whole(const Request& request) {
    return plan(request, viewport_of(request, {0, 0, request.width, request.height}));
}

std::string shader_of(const std::vector<std::pair<std::string, std::string>>& values) {
    return whole(request_of(values)).steps.front().shader;
}

// The passes::Line of each column in a plan that draws pixel by pixel.
std::vector<passes::Line> columns(const Request& request, Viewport viewport) {
    viewport.blocks = Blocks::none;
    return values_of<passes::Line>(plan(request, viewport).tables.at(0));
}

// Returns the push constants of a plan that draws pixel by pixel, and the positions that it stores.
std::vector<Bytes> seen(const Request& request, Viewport viewport) {
    viewport.blocks = Blocks::none;
    const Plan made = plan(request, viewport, {3, 2, std::vector<float>(12, 1), true});
    std::vector<Bytes> all{made.steps.front().push};
    if (made.steps.front().shader.starts_with("pixels")) {
        auto push = values_of<passes::PixelsPush>(all.front()).front();
        if (request.paint.empty())
            push.paint_corner = {};
        all = {bytes_of(push), made.tables[0], made.tables[1]};
    }
    return all;
}

// Returns the push constants of a view of 300 x 200 pixels and of the same view of 200 x 300.
template <typename Push>
std::array<Push, 2> wide_and_tall(const char* view, const char* material = "none") {
    const auto push = [&](const char* width, const char* height) {
        const Request request =
            request_of({{"view", view}, {"material", material}, {"width", width}, {"height", height}});
        return values_of<Push>(whole(request).steps.front().push).at(0);
    };
    return {push("300", "200"), push("200", "300")};
}

// The distance in kernel cells from one line to the next, even where cells wrap around.
double step(const passes::Line& from, const passes::Line& to) {
    const auto cells = static_cast<std::uint32_t>(to.cell) - static_cast<std::uint32_t>(from.cell);
    return static_cast<double>(static_cast<std::int32_t>(cells)) + double{to.local} - double{from.local};
}

} // namespace

TEST_CASE("the fastest pass that can draw a request is chosen") {
    CHECK(shader_of({}) == "bake@3");
    CHECK(shader_of({{"recipe", "lattice-4"}}) == "bake@4");
    CHECK(shader_of({{"recipe", "one"}, {"gradient", "true"}}) == "bake");
    CHECK(shader_of({{"view", "slice"}}) == "bake@3");
    CHECK(shader_of({{"phasor", "true"}}) == "pixels@3");
    CHECK(shader_of({{"filter", "true"}}) == "pixels@3");
    CHECK(shader_of({{"view", "horizon"}, {"recipe", "pure"}}) == "pixels");
    CHECK(shader_of({{"view", "slice"}, {"filter", "true"}}) == "solid");
    CHECK(shader_of({{"view", "sphere"}}) == "solid@surface");
    CHECK(shader_of({{"view", "torus"}, {"solid", "true"}}) == "solid");
    CHECK(shader_of({{"material", "brushed-metal"}}) == "material@brushed_metal");
    CHECK(shader_of({{"fractal", "fbm"}}) == "fractal");
    CHECK(shader_of({{"fractal", "ridged"}, {"view", "horizon"}, {"filter", "true"}}) == "fractal");
}

TEST_CASE("a window uses blocks of one size at all scales, and no blocks at small scales") {
    Request request;
    Viewport viewport = viewport_of(request, {0, 0, 64, 64});
    viewport.blocks = Blocks::fixed;
    const Constants near = plan(request, viewport).steps.front().constants;
    viewport.camera.zoom = 3.7;
    CHECK(plan(request, viewport).steps.front().constants == near);
    CHECK(uses_blocks(request, viewport));
    viewport.camera.zoom = 0.3; // 6.4 pixels to a cell
    CHECK_FALSE(uses_blocks(request, viewport));
}

TEST_CASE("a window filters with one pipeline at all scales, and a picture with one for its scale") {
    Request request{.lobes = {{.frequency = 2},
                              {.frequency = 5, .radius = 0.05},
                              {.radius = 0.05, .stretch = 20},
                              {.stretch = 0.05}},
                    .filter = true};
    Viewport viewport = viewport_of(request, {0, 0, 64, 64});
    const auto constants = [&] { return plan(request, viewport).steps.front().constants; };
    CHECK(constants()[passes::narrow_waves_id] == 0b0001);
    CHECK(constants()[passes::wide_waves_id] == 0b1110); // of an oblong kernel, the shorter radius decides
    viewport.blocks = Blocks::fixed;
    const Constants near = constants();
    CHECK(near[passes::few_waves_id] == 0); // one pipeline for any number of waves above one
    for (const double zoom : {0.02, 0.1, 3.7, 50.0}) {
        viewport.camera.zoom = zoom;
        CHECK(constants() == near);
    }
}

TEST_CASE("a tile's oblong pixels are filtered in the form for their longer side") {
    for (const auto& [width, height] : {std::pair{"14", "106"}, {"106", "14"}}) {
        const Request tile = request_of({{"scale", "5.3"},
                                         {"width", width},
                                         {"height", height},
                                         {"filter", "true"},
                                         {"tileable", "true"}});
        const Constants constants = whole(tile).steps.front().constants;
        // Judged by the side of 14 pixels alone, the filter would be narrow.
        CHECK(constants[passes::narrow_waves_id] == 0);
        CHECK(constants[passes::wide_waves_id] == 0);
    }
}

TEST_CASE("every pass that a plan names exists") {
    std::vector<Request> requests;
    for (const noise::Recipe& recipe : noise::recipes())
        for (const char* phasor : {"false", "true"})
            requests.push_back(request_of({{"recipe", std::string(recipe.name)}, {"phasor", phasor}}));
    for (const std::string_view material : materials)
        requests.push_back(request_of({{"material", std::string(material)}}));
    requests.push_back(request_of({{"fractal", "billow"}}));
    for (const char* view : {"slice", "sphere", "torus"})
        requests.push_back(request_of({{"view", view}, {"filter", "true"}}));
    for (const Request& request : requests)
        for (const Step& step : whole(request).steps) {
            INFO(step.shader);
            CHECK(std::ranges::find(passes::pictures, step.shader, &passes::Module::name) !=
                  passes::pictures.end());
        }
}

TEST_CASE("a wide landscape is seen from as far away as a tall one") {
    const auto distance = [](const char* width, const char* height) {
        const Request request = request_of({{"view", "landscape"}, {"width", width}, {"height", height}});
        return values_of<passes::TerrainPush>(whole(request).steps.front().push).at(0).distance;
    };
    CHECK(distance("300", "200") == distance("200", "300"));
    CHECK(distance("300", "200") > distance("200", "200"));
}

TEST_CASE("a tall picture shows as much as a wide one") {
    const auto [land, tall_land] = wide_and_tall<passes::TerrainPush>("landscape");
    CHECK(land.pixel == tall_land.pixel);
    const auto [sea, tall_sea] = wide_and_tall<passes::OceanPush>("ocean");
    CHECK(sea.pixel == tall_sea.pixel);
    const auto [body, tall_body] = wide_and_tall<passes::MaterialPush>("sphere", "wood");
    CHECK(body.pixel == tall_body.pixel);
    CHECK(body.unit == tall_body.unit);
}

TEST_CASE("a coarse view shows what a smaller picture does, and a zoomed one what a larger one does") {
    const std::vector<std::vector<std::pair<std::string, std::string>>> all{
        {{"view", "terrain"}, {"extent", "50"}},
        {{"view", "landscape"}},
        {{"view", "ocean"}},
        {{"view", "slice"}},
        {{"view", "sphere"}, {"material", "wood"}},
        {{"view", "horizon"}},
        {{"view", "horizon"}, {"material", "wood"}},
        {{"material", "wood"}},
        {{"phasor", "true"}},
        {{"paint", "paint.png"}}};
    for (const auto& values : all) {
        Request request = request_of(values);
        request.width = 300;
        request.height = 180;
        Viewport viewport{.camera = default_camera(request).moved(3.3, -1.7),
                          .width = 320,
                          .height = 200,
                          .region = {8, 12, 40, 30}};
        const auto enlarged = [&](double factor) {
            Request made = request;
            made.width = static_cast<int>(300 * factor);
            made.height = static_cast<int>(180 * factor);
            made.scale *= factor;
            return made;
        };
        INFO(values.front().second << ", " << values.back().second);
        Viewport zoomed = viewport;
        zoomed.camera.zoom = 2;
        CHECK((seen(request, zoomed) == seen(enlarged(2), viewport)));
        Viewport coarse = viewport, small = viewport;
        coarse.stride = 2;
        small.width = 160;
        small.height = 100;
        Request half = enlarged(0.5);
        if (request.view.has_horizon()) // the scale is that of the bottom row
            half.scale = request.scale * (100 - 0.5 - sky_rows(100)) / (200 - 0.5 - sky_rows(200));
        CHECK((seen(request, coarse) == seen(half, small)));
    }
    const Request body = request_of({{"view", "sphere"}});
    Viewport viewport = viewport_of(body, {0, 0, 8, 8});
    viewport.stride = 4;
    CHECK(values_of<passes::SolidPush>(plan(body, viewport).steps.front().push).at(0).share == 0.25f);
}

TEST_CASE("maps of another side show as much along their shorter side") {
    Request request{.width = 60, .height = 40, .scale = 10};
    set_side(request, 80);
    CHECK(std::array{request.width, request.height} == std::array{80, 80});
    CHECK(request.scale == 20);
}

TEST_CASE("a longer focal length shows as much of a landscape from farther away") {
    const auto push = [](const char* length) {
        const Request request = request_of({{"view", "landscape"}, {"focal_length", length}});
        return values_of<passes::TerrainPush>(whole(request).steps.front().push).at(0);
    };
    const passes::TerrainPush near = push("28.8"), far = push("86.4");
    CHECK(far.distance == Approx(3 * near.distance));
    CHECK(far.distance * far.pixel == Approx(near.distance * near.pixel));
}

TEST_CASE("the default camera reproduces the picture's position exactly") {
    // 1000 / 2 / 7.3 is not a binary fraction, but the corner must be the origin.
    const Request request{.width = 1000, .height = 10, .scale = 7.3, .recipe = noise::find_recipe("one")};
    const std::vector<passes::Line> lines = columns(request, viewport_of(request, {0, 0, 1000, 1}));
    for (int i = 0; i < 1000; ++i) {
        const double place = (i + 0.5) * (1 / 7.3);
        CHECK(lines[static_cast<std::size_t>(i)].cell == std::floor(place));
        CHECK(lines[static_cast<std::size_t>(i)].local == static_cast<float>(place - std::floor(place)));
    }
}

TEST_CASE("a camera is as precise far away as nearby") {
    Camera camera;
    // Far away, the camera moves in steps that a single double could not represent.
    camera = camera.moved(2e9, -2e9);
    for (int i = 0; i < 1000; ++i)
        camera = camera.moved(1e-7, -1e-7);
    camera = camera.moved(-2e9, 2e9);
    CHECK(static_cast<double>(camera.x.whole) + camera.x.part == Approx(1e-4).margin(1e-12));
    CHECK(static_cast<double>(camera.y.whole) + camera.y.part == Approx(-1e-4).margin(1e-12));
}

TEST_CASE("the cell of a position follows from the sum of its whole and fractional parts") {
    const auto [cell, local] = cell_at({3, 0.9}, 1.5);
    CHECK(cell == 5);
    CHECK(local == Approx(0.85));
}

TEST_CASE("a plane in perspective is drawn from the position of its camera") {
    Request request = request_of({{"material", "wood"}, {"view", "horizon"}});
    Viewport viewport = viewport_of(request, {0, 0, 150, 113});
    viewport.camera.x = {2, 0.25};
    viewport.camera.y = {-4, 0.5};
    const auto push = values_of<passes::MaterialPush>(plan(request, viewport).steps.front().push).at(0);
    CHECK(push.corner.x == 2.25f);
    CHECK(push.corner.y == -3.5f);
    set_text(request, "material", "none");
    request.lobes = {{.radius = 2, .stretch = 3}}; // 2.25 and -3.5 are 1.6875 and -0.875 node spacings
    const auto wave = values_of<passes::PixelsWave>(plan(request, viewport).tables.at(2)).at(0);
    CHECK(wave.camera.x == 0.6875f);
    CHECK(wave.camera.y == 0.125f);
}

TEST_CASE("a slice is drawn from the position of its camera, at any zoom") {
    const Request request = request_of({{"view", "slice"}});
    Viewport viewport = viewport_of(request, {0, 0, 150, 113});
    viewport.blocks = Blocks::none;
    viewport.camera.x = {2, 0.25};
    viewport.camera.y = {-4, 0.5};
    for (const double zoom : {0.5, 1.0, 3.0}) {
        viewport.camera.zoom = zoom;
        const auto push = values_of<passes::SolidPush>(plan(request, viewport).steps.front().push).at(0);
        const double pixel = double{push.pixel};
        CHECK(pixel == Approx(1 / (request.scale * zoom)));
        CHECK((push.first_column + viewport.width / 2.0) * pixel == Approx(2.25).margin(pixel));
        CHECK((push.first_row + viewport.height / 2.0) * pixel == Approx(-3.5).margin(pixel));
    }
}

TEST_CASE("columns continue where cells wrap around") {
    for (const char* recipe : {"one", "lattice"}) {
        const Request request{.scale = 32, .recipe = noise::find_recipe(recipe)};
        const double cells = double{request.recipe.radius};
        Viewport viewport = viewport_of(request, {0, 0, 400, 1});
        viewport.width = 400;
        viewport.camera.x = {static_cast<std::int64_t>(2147483648.0 / cells) - 1, 0.25};
        const std::vector<passes::Line> lines = columns(request, viewport);
        REQUIRE(lines.size() == 400);
        for (std::size_t i = 1; i < lines.size(); ++i)
            REQUIRE(step(lines[i - 1], lines[i]) == Approx(cells / 32).margin(1e-6));
        CHECK(lines.front().cell > 0);
        CHECK(lines.back().cell < 0);
    }
}

TEST_CASE("zooming in brings sample positions closer together, and a coarse view spreads them") {
    const Request request;
    Viewport viewport = viewport_of(request, {0, 0, 64, 1});
    const std::vector<passes::Line> before = columns(request, viewport);
    viewport.camera.zoom = 2;
    const std::vector<passes::Line> zoomed = columns(request, viewport);
    viewport.stride = 8;
    const std::vector<passes::Line> coarse = columns(request, viewport);
    REQUIRE(before.size() == 64);
    for (std::size_t i = 1; i < before.size(); ++i) {
        CHECK(step(zoomed[0], zoomed[i]) == Approx(step(before[0], before[i]) / 2).margin(1e-5));
        CHECK(step(coarse[0], coarse[i]) == Approx(step(before[0], before[i]) * 4).margin(1e-5));
    }
}

TEST_CASE("a coarse view filters its waves for its larger pixels") {
    const Request request{.scale = 32, .lobes = {{.frequency = 4}}};
    Viewport viewport = viewport_of(request, {0, 0, 64, 64});
    const auto amplitude = [&](int stride) {
        viewport.stride = stride;
        return values_of<passes::BakeWave>(plan(request, viewport).tables.at(2)).at(0).amplitude;
    };
    // The deviation is half a pixel: merging 4 x 4 pixels adds 15/4 square pixels of variance.
    CHECK(amplitude(4) / amplitude(1) ==
          Approx(std::exp(-2 * std::pow(std::numbers::pi * 4 / 32, 2) * 15 / 4)).epsilon(1e-5));
    const float coarse = amplitude(4);
    viewport.camera.zoom = 0.25;
    CHECK(amplitude(1) == coarse);
}

TEST_CASE("an erosion reads its map with a margin around each band, and scales the map to what presets are "
          "made for") {
    HeightMap map{.open = {}, .width = 300, .height = 200, .pixel = {2, 3}, .tileable = true};
    SmoothedMap smoothed{.axes = {SplineAxis{60, 300, 0, 60}, SplineAxis{40, 200, 0, 40}},
                         .heights = std::vector<float>(63 * 43),
                         .slope = 0.05};
    const Request request =
        request_of({{"view", "terrain"}, {"octaves", "3"}, {"branching", "0.5"}, {"seed", "7"}});
    const Plan made = erosion_plan(map, smoothed, 600, request, {10, 20, 30, 40}, false);
    CHECK(made.channels.size() == 5);
    CHECK(erosion_plan(map, smoothed, 600, request, {10, 20, 30, 40}, true).channels.size() == 9);
    CHECK(made.width == 30);
    CHECK(made.height == 40);
    CHECK(made.source.width == 300);
    CHECK(made.source.halo == 1);
    const auto push = values_of<passes::ErodePush>(made.steps.front().push).front();
    CHECK(std::array{push.first_column, push.first_row, push.width, push.height} ==
          std::array{10, 20, 30, 40});
    CHECK(std::array{push.pixel.x, push.pixel.y} == std::array{8 / 300.0f, 8 / 200.0f});
    CHECK(std::array{push.period.x, push.period.y, push.unit} == std::array{8.0f, 8.0f, 75.0f});
    CHECK(std::array{push.cell.x, push.cell.y} == std::array{0, 0});
    CHECK(std::array{push.local.x, push.local.y, push.phase.x, push.phase.y} ==
          std::array{0.0f, 0.0f, 0.0f, 0.0f});
    CHECK(std::array{push.nodes.x, push.nodes.y} == std::array{0.2f, 0.2f});
    CHECK(push.steepness == Approx(0.637 / 0.05));
    CHECK(std::array{push.map_width, push.tileable, static_cast<int>(push.seed)} == std::array{300, 1, 7});
    CHECK(values_of<std::int32_t>(made.tables.front()).front() == 3);
    CHECK(values_of<float>(made.tables.front()).back() == 0.5f);

    map.tileable = false;
    map.world = std::array{-100, 250}; // p of -8/3 and 10
    smoothed.axes = {SplineAxis{1, 7, 5 / 7.0, 44}, SplineAxis{1, 7, 0.75, 30}};
    const Plan placed = erosion_plan(map, smoothed, 600, request, {0, 0, 300, 200}, false);
    const auto there = values_of<passes::ErodePush>(placed.steps.front().push).front();
    CHECK(std::array{there.cell.x, there.cell.y} == std::array{-3, 10});
    CHECK(there.local.x == Approx(1 / 3.0));
    CHECK(there.local.y == Approx(0).margin(1e-6));
    CHECK(std::array{there.phase.x, there.phase.y} == std::array{static_cast<float>(5 / 7.0), 0.75f});
    CHECK(there.nodes.x == static_cast<float>(1 / 7.0));
    CHECK(there.table_width == 47);
}

TEST_CASE("bands cover a region once, and blocks are never cut") {
    for (const char* phasor : {"false", "true"}) {
        const Request request = request_of({{"phasor", phasor}});
        const Plan made = plan(request, viewport_of(request, {5, 17, 90, 83}));
        for (const int wanted : {1, 20, 83, 1000}) {
            int row = 0;
            while (row < 83) {
                const Band band = band_at(made, row, wanted);
                REQUIRE(band.first_row == row);
                REQUIRE(band.rows > 0);
                CHECK(band.rows <= std::max(wanted, 32));
                CHECK(band.rows <= most_rows_of_a_band(made, wanted));
                for (const auto& [first, count] : made.steps.front().runs)
                    CHECK_FALSE((row > 0 && first < row && first + count > row));
                row += band.rows;
            }
            CHECK(row == 83);
        }
    }
}
