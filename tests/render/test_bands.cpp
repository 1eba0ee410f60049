#include "largest.hpp"
#include "reference/lattice.hpp"
#include "reference/reference.hpp"
#include "render/renderer.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace gabor;

namespace {

std::vector<float> rendered(const vulkan::Device& device, const render::Request& request,
                            const image::Rect& region) {
    std::vector<float> pixels;
    render::render_region(device, request, region, [&](std::span<const float> rows) {
        pixels.insert(pixels.end(), rows.begin(), rows.end());
    });
    return pixels;
}

// Evaluates the reference of any recipe at x, y cells from the origin, with the given axes.
struct AnyReference {
    AnyReference(const noise::Recipe& recipe, const noise::Lobe& lobe, std::uint32_t seed)
        : recipe_(recipe), sparse_(noise::sparse_recipes().front(), lobe.frequency, lobe.angle(), seed),
          lattice_(std::max(recipe.taps, 2), lobe.frequency, lobe.angle(), seed) {
        if (!recipe.is_lattice())
            sparse_ = noise::Reference(recipe, lobe.frequency, lobe.angle(), seed);
    }

    struct Field {
        std::complex<double> value;
        std::complex<double> slope_x;
        std::complex<double> slope_y;
    };

    Field field(double x, double y, const render::Axis& x_axis, const render::Axis& y_axis,
                double time = 0) const {
        const double column = std::floor(x);
        const double row = std::floor(y);
        if (recipe_.taps > 0) {
            const auto f = lattice_.field({static_cast<std::int32_t>(column), static_cast<std::int32_t>(row),
                                           x - column, y - row, x_axis.radius, y_axis.radius, x_axis.period,
                                           y_axis.period, time != 0, time});
            return {f.value, f.slope_x, f.slope_y};
        }
        const auto f = sparse_.field({static_cast<std::int32_t>(column), static_cast<std::int32_t>(row),
                                      static_cast<float>(x - column), static_cast<float>(y - row),
                                      static_cast<float>(x_axis.radius), static_cast<float>(y_axis.radius),
                                      x_axis.period, y_axis.period, static_cast<float>(time)});
        return {f.value, f.slope_x, f.slope_y};
    }

  private:
    noise::Recipe recipe_;
    noise::Reference sparse_;
    noise::Lattice lattice_;
};

} // namespace

TEST_CASE("each pixel is the reference at its centre, at any scale", "[render]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::recipes()) {
        test::Largest largest;
        // For each scale a frequency as high as the pixels can show.
        for (const auto& [scale, frequency] :
             {std::pair(2.0, 0.9), std::pair(2.3, 0.001), std::pair(7.77, 2.0), std::pair(31.7, 4.0),
              std::pair(32.0, 0.1), std::pair(500.0, 64.0), std::pair(4096.0, 4.0),
              std::pair(4096.0, 1000.0)}) {
            // The far corner of the largest picture.
            const render::Request request{.width = 65536,
                                          .height = 65536,
                                          .scale = scale,
                                          .recipe = recipe,
                                          .lobes = {{frequency, 123}},
                                          .seed = 99};
            const image::Rect region{65536 - 70, 65536 - 45, 70, 45};
            const std::vector<float> pixels = rendered(device, request, region);
            const AnyReference reference(recipe, request.lobes.front(), 99);
            const render::Axis axis{recipe.radius, 0};
            REQUIRE(pixels.size() == 70 * 45);
            for (int y = 0; y < region.height; ++y) {
                for (int x = 0; x < region.width; ++x) {
                    const double px = (region.x + x + 0.5) / scale * recipe.radius;
                    const double py = (region.y + y + 0.5) / scale * recipe.radius;
                    // In units of the phase's rounding in single precision, and of a low sine's small values,
                    // which normalization amplifies.
                    const double tolerance =
                        1.5e-5 * std::max({1.0, frequency / 4, recipe.phases == 2 ? 0.1 / frequency : 0});
                    largest.see(pixels[static_cast<std::size_t>(y * region.width + x)],
                                reference.field(px, py, axis, axis).value.imag(), tolerance, [&] {
                                    return fmt::format("scale {}, frequency {}, pixel {}, {}", scale,
                                                       frequency, x, y);
                                });
                }
            }
        }
        largest.check(recipe.name);
    }
}

TEST_CASE("a region has the bits of the whole, whatever the bands", "[render]") {
    const vulkan::Device device;
    for (const char* recipe : {"lattice", "lattice-2", "lattice-4", "one"}) {
        INFO(recipe);
        const render::Request request{.width = 2500,
                                      .height = 4000,
                                      .scale = 20,
                                      .recipe = noise::find_recipe(recipe),
                                      .lobes = {{3, 20}},
                                      .seed = 1}; // more than two bands
        const std::vector<float> whole = rendered(device, request, {0, 0, request.width, request.height});
        for (const image::Rect& region : {image::Rect{0, 0, 1, 1}, image::Rect{2499, 3999, 1, 1},
                                          image::Rect{1, 1700, 2499, 333}, image::Rect{777, 13, 9, 3987}}) {
            const std::vector<float> part = rendered(device, request, region);
            REQUIRE(part.size() ==
                    static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height));
            std::size_t i = 0;
            bool same = true;
            for (int y = region.y; y < region.y + region.height; ++y)
                for (int x = region.x; x < region.x + region.width; ++x)
                    same &=
                        part[i++] == whole[static_cast<std::size_t>(y) * 2500 + static_cast<std::size_t>(x)];
            CHECK(same);
        }
    }
}

TEST_CASE("what the sink throws ends the rendering", "[render]") {
    const vulkan::Device device;
    const render::Request request{.width = 4096, .height = 8192, .seed = 1};
    int bands = 0;
    const auto sink = [&](std::span<const float>) {
        if (++bands == 2)
            throw 7;
    };
    CHECK_THROWS_AS(render::render_region(device, request, {0, 0, 4096, 8192}, sink), int);
    CHECK(bands == 2);
}

TEST_CASE("a tileable picture is the reference on a torus, at any time", "[render]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::recipes()) {
        const render::Request request{.width = 131,
                                      .height = 100,
                                      .scale = 16.3,
                                      .recipe = recipe,
                                      .lobes = {{3, 25}},
                                      .seed = 5,
                                      .time = 3.3,
                                      .view = render::Plane{.tileable = true}};
        const std::vector<float> pixels = rendered(device, request, {0, 0, request.width, request.height});
        const AnyReference reference(recipe, request.lobes.front(), 5);
        const double cells_x = std::floor(131 / 16.3 * recipe.radius);
        const double cells_y = std::floor(100 / 16.3 * recipe.radius);
        test::Largest largest;
        // The second round sees every pixel one period further along both axes.
        for (const int round : {0, 1}) {
            for (int y = 0; y < request.height; ++y) {
                for (int x = 0; x < request.width; ++x) {
                    const double u = (x + 0.5) / 131 * cells_x;
                    const double v = (y + 0.5) / 100 * cells_y;
                    const render::Axis x_axis{cells_x / 131 * 16.3, static_cast<int>(cells_x)};
                    const render::Axis y_axis{cells_y / 100 * 16.3, static_cast<int>(cells_y)};
                    const AnyReference::Field field =
                        reference.field(u + round * cells_x, v - round * cells_y, x_axis, y_axis, 0.3);
                    const double value = pixels[static_cast<std::size_t>(y * request.width + x)];
                    largest.see(value, field.value.imag(), 2e-5,
                                [&] { return fmt::format("pixel {}, {}", x, y); });
                }
            }
        }
        largest.check(recipe.name);
    }
}

TEST_CASE("quadrature and gradient are those of the reference", "[render]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::recipes()) {
        for (const bool with_quadrature : {true, false}) {
            const render::Request request{.width = 90,
                                          .height = 70,
                                          .scale = 21.3,
                                          .recipe = recipe,
                                          .lobes = {{4, 70}},
                                          .seed = 5,
                                          .quadrature = with_quadrature,
                                          .gradient = true};
            const std::size_t channels = render::channels(request).size();
            REQUIRE(channels == (with_quadrature ? 4 : 3));
            const std::vector<float> values = rendered(device, request, {0, 0, 90, 70});
            REQUIRE(values.size() == 90 * 70 * channels);
            const AnyReference reference(recipe, request.lobes.front(), 5);
            const render::Axis axis{recipe.radius, 0};
            test::Largest value, slope;
            const double slope_tolerance = 1.5e-5 * (2 * std::numbers::pi * 4 + 2);
            for (int i = 0; i < 90 * 70; ++i) {
                const double u = (i % 90 + 0.5) / 21.3 * recipe.radius;
                const double v = (i / 90 + 0.5) / 21.3 * recipe.radius;
                const AnyReference::Field field = reference.field(u, v, axis, axis);
                const float* pixel = &values[static_cast<std::size_t>(i) * channels];
                const auto place = [&] { return fmt::format("pixel {}, {}", i % 90, i / 90); };
                value.see(pixel[0], field.value.imag(), 1.5e-5, place);
                if (with_quadrature)
                    value.see(pixel[1], field.value.real(), 1.5e-5, place);
                slope.see(pixel[channels - 2], field.slope_x.imag(), slope_tolerance, place);
                slope.see(pixel[channels - 1], field.slope_y.imag(), slope_tolerance, place);
            }
            value.check(recipe.name);
            slope.check("  its gradient");
        }
    }
}
