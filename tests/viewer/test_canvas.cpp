// Tests the values that the window shows, as the device computes them.

#include "../largest.hpp"
#include "viewer/canvas.hpp"
#include "viewer/display.hpp"
#include "viewer/document_json.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace gabor;
using namespace gabor::viewer;

namespace {

const vulkan::Device& device() {
    static const vulkan::Device device;
    return device;
}

// Returns all values of a view, in full resolution or coarser.
std::vector<float> values_of(Canvas& canvas, const Document& document, Extent extent, int stride = 1) {
    canvas.draw(drawing_of(document), document.camera, extent, stride);
    const std::span<const float> values = canvas.pixels();
    return {values.begin(), values.end()};
}

// The same, drawn pixel by pixel.
std::vector<float> unbaked(render::Renderer& renderer, const Document& document, Extent extent, int stride) {
    const Drawing drawing = drawing_of(document);
    render::Viewport viewport = viewport_of(drawing, document.camera, extent, stride);
    viewport.blocks = render::Blocks::none;
    renderer.set(render::plan(drawing.request, viewport));
    std::vector<float> values;
    render::render_plan(device(), renderer, [&](std::span<const float> rows) {
        values.insert(values.end(), rows.begin(), rows.end());
    });
    return values;
}

bool uses_blocks(const Document& document) {
    const Drawing drawing = drawing_of(document);
    return render::uses_blocks(drawing.request, viewport_of(drawing, document.camera, {1, 1}));
}

void compare(const std::string& what, const std::vector<float>& found, const std::vector<float>& expected,
             double tolerance) {
    REQUIRE(found.size() == expected.size());
    REQUIRE(!found.empty());
    test::Largest largest;
    double power = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        power += double{expected[i]} * double{expected[i]} / static_cast<double>(found.size());
        largest.see(found[i], expected[i], tolerance, [&] { return fmt::format("value {}", i); });
    }
    CHECK(power > 0.3);
    largest.check(what);
}

} // namespace

TEST_CASE("drawing by blocks equals drawing pixel by pixel, wherever the camera is") {
    const Extent extent{150, 90};
    const auto check = [&](const std::string& name, const render::Request& request, Output output) {
        Document document = document_of(request);
        document.output = output;
        REQUIRE(uses_blocks(document));
        Canvas blocks(device());
        render::Renderer pixels(device());
        for (const Coordinate& corner :
             {Coordinate{0, 0}, Coordinate{-2, 0.37}, Coordinate{1'000'000'000, 0.9}})
            for (const auto& [zoom, stride] : {std::pair{1.0, 1}, std::pair{2.3, 1}, std::pair{2.3, 4}}) {
                document.camera = {corner, corner.moved(0.61), zoom};
                compare(fmt::format("{}, from {} on, zoom {}, stride {}", name, corner.whole, zoom, stride),
                        values_of(blocks, document, extent, stride),
                        unbaked(pixels, document, extent, stride), output == Output::gradient ? 2e-3 : 1e-4);
            }
    };
    render::Request request{.scale = 32, .seed = 3};
    check("lattice", request, Output::value);
    check("gradient", request, Output::gradient);
    request.recipe = noise::find_recipe("one");
    check("one", request, Output::phase);
    request.recipe = noise::find_recipe("lattice");
    request.view.tileable = true;
    request.evolution = 0.3;
    request.lobes = {{.frequency = 3, .radius = 1.7}, {.frequency = 5, .orientation = 70, .power = 0.3}};
    check("lobes, tileable", request, Output::value);
}

TEST_CASE("a coarse view is the same as a view of smaller scale with the filter on") {
    constexpr int side = 192;
    const auto check = [&](const std::string& name, const Document& document) {
        Canvas coarse(device()), small(device());
        for (const int stride : {2, 4, 8}) {
            const std::vector<float> found = values_of(coarse, document, {side, side}, stride);
            Document filtered = document;
            filtered.request.filter = true;
            filtered.camera.zoom /= stride;
            const std::vector<float> expected = values_of(small, filtered, {side / stride, side / stride});
            const std::size_t channels = small.channels().size(), own = coarse.channels().size();
            REQUIRE(found.size() / own == expected.size() / channels);
            double off = 0;
            for (std::size_t i = 0; i * own < found.size(); ++i)
                off += std::pow(double{found[i * own]} - double{expected[i * channels]}, 2);
            off = std::sqrt(off / static_cast<double>(found.size() / own));
            fmt::print("{}, stride {}: off by {:.3f}\n", name, stride, off);
            // If the request has no filter, each wave's amplitude is filtered but its window is not. Aliasing
            // would make the error 1.
            CHECK(off < (document.request.filter ? 1e-4 : 0.23));
        }
    };
    for (const double frequency : {1.0, 4.0}) { // wavelengths of 20 and 5 pixels
        Document document = document_of({.width = side,
                                         .height = side,
                                         .scale = 20,
                                         .lobes = {{.frequency = frequency, .orientation = 20}}});
        const std::string name = fmt::format("frequency {}", frequency);
        REQUIRE(uses_blocks(document));
        check(name, document);
        document.request.filter = true;
        check(name + ", filtered", document);
        document.request.view = {.projection = render::Projection::slice, .depth = 0.3};
        check(name + ", filtered slice", document);
        document.request.filter = false;
        check(name + ", slice", document);
    }
    Document document = document_of({.scale = 20, .lobes = {{.frequency = 3}}});
    document.output = Output::phase; // phases do not fade
    const auto coarsest = [&](double zoom) {
        return coarsest_stride(drawing_of(document), render::Paint(), zoom);
    };
    CHECK(coarsest(1) == 2);
    CHECK(coarsest(0.5) == 1);
    CHECK(coarsest(2) == 4);
    document.request.filter = true; // only the intensity fades
    document.output = Output::phasor;
    CHECK(coarsest(1) == 2);
}

TEST_CASE("terrain looks alike in any unit") {
    for (std::size_t look = 0; look < 4; ++look) {
        std::array<std::vector<float>, 2> seen;
        for (const auto& [k, extent] : {std::pair(0u, 2.0), {1u, 2000.0}}) {
            Document document = document_of({.width = 64, .height = 48, .scale = 8, .seed = 3});
            set_parameter(document, "view", std::string("terrain"));
            set_parameter(document, "scale", 8.0);
            set_parameter(document, "extent", extent);
            document.look = static_cast<Look>(look);
            Canvas canvas(device());
            const std::vector<float> values = values_of(canvas, document, {64, 48});
            FileColours colours(device(), document, canvas.channels());
            const std::span<const float> shown = colours.of(values);
            seen[k].assign(shown.begin(), shown.end());
        }
        test::Largest largest;
        for (std::size_t i = 0; i < seen[0].size(); ++i)
            largest.see(seen[1][i], seen[0][i], 4e-3, [&] { return fmt::format("value {}", i); });
        largest.check(std::string(look_names[look]));
        CHECK(std::ranges::max(seen[0]) - std::ranges::min(seen[0]) > 0.2f);
    }
}

TEST_CASE("a file's colours do not depend on its bands, and start again with each picture") {
    for (const Output output :
         {Output::lit, Output::lit_phasor, Output::phase}) { // lit stripes see the row above
        Document document = document_of({.width = 40, .height = 24, .scale = 8});
        document.output = output;
        document.colours = 3;
        Canvas canvas(device());
        const std::vector<float> values = values_of(canvas, document, {40, 24});
        const std::size_t row = values.size() / 24;
        FileColours colours(device(), document, canvas.channels());
        std::vector<std::vector<float>> seen;
        for (const std::vector<std::size_t>& bands : {std::vector<std::size_t>{24}, {1, 7, 16}, {24}}) {
            seen.emplace_back();
            std::size_t first = 0;
            for (const std::size_t rows : bands) {
                const auto shown = colours.of(std::span(values).subspan(first * row, rows * row));
                seen.back().insert(seen.back().end(), shown.begin(), shown.end());
                first += rows;
            }
        }
        CHECK(seen[0].size() == 3 * 40 * 24);
        CHECK(std::ranges::max(seen[0]) - std::ranges::min(seen[0]) > 0.2f);
        CHECK(seen[1] == seen[0]);
        CHECK(seen[2] == seen[0]);
    }
}
