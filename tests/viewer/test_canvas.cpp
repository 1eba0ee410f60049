// Tests the values that the window shows, as the device computes them.

#include "../largest.hpp"
#include "viewer/canvas.hpp"

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
    request.view = render::Plane{true};
    request.time = 0.3;
    request.lobes = {{.frequency = 3, .radius = 1.7}, {.frequency = 5, .orientation = 70, .power = 0.3}};
    check("lobes, tileable", request, Output::value);
}

TEST_CASE("a coarse view filters its waves instead of aliasing them") {
    constexpr int side = 192;
    // Filters the fine view with a Gaussian whose standard deviation is half a coarse pixel.
    const auto expected = [&](const std::vector<float>& fine, int stride, double already) {
        const double variance = (stride * stride - already) / 4.0;
        const int reach = 3 * stride;
        const int count = side / stride;
        std::vector<float> seen;
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < count; ++i) {
                double sum = 0;
                double weights = 0;
                const double x = (i + 0.5) * stride - 0.5;
                const double y = (j + 0.5) * stride - 0.5;
                for (int v = std::max(j * stride - reach, 0); v < std::min(j * stride + reach, side); ++v)
                    for (int u = std::max(i * stride - reach, 0); u < std::min(i * stride + reach, side);
                         ++u) {
                        const double weight =
                            std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * variance));
                        sum += weight * double{fine[static_cast<std::size_t>(v * side + u)]};
                        weights += weight;
                    }
                seen.push_back(static_cast<float>(sum / weights));
            }
        return seen;
    };
    const auto check = [&](const std::string& name, const Document& document) {
        Canvas canvas(device());
        const auto first = [&](const std::vector<float>& values) { // the first channel of each pixel
            std::vector<float> kept;
            for (std::size_t i = 0; i < values.size(); i += canvas.channels().size())
                kept.push_back(values[i]);
            return kept;
        };
        const std::vector<float> fine = first(values_of(canvas, document, {side, side}));
        for (const int stride : {2, 4, 8}) {
            const std::vector<float> found = first(values_of(canvas, document, {side, side}, stride));
            const std::vector<float> wanted = expected(fine, stride, document.request.filter ? 1 : 0);
            double off = 0;
            const int count = side / stride;
            const int margin = 24 / stride + 1; // where the filter reaches beyond the fine view
            for (int j = margin; j < count - margin; ++j)
                for (int i = margin; i < count - margin; ++i) {
                    const auto at = static_cast<std::size_t>(j * count + i);
                    off +=
                        std::pow(double{found[at]} - double{wanted[at]}, 2) / std::pow(count - 2 * margin, 2);
                }
            fmt::print("{}, stride {}: off by {:.3f}\n", name, stride, std::sqrt(off));
            // If the request has no filter, each wave's amplitude is filtered but its window is not. Over ten
            // seeds the largest error is 0.16 to 0.21, and at most 0.007 with a filter; aliasing would make
            // it 1.
            CHECK(std::sqrt(off) < (document.request.filter ? 0.01 : 0.23));
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
        document.request.view = render::Slice{0.3};
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
