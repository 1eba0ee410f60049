// Compares gabor_noise_grid.hpp with the noise of each pixel.

#include "largest.hpp"

#include "gabor_noise_grid.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <vector>

using gabor::test::Largest;

namespace {

// The noise of a pixel, whose position is split in double precision.
GaborField pixel_of(const GaborGrid& grid, std::size_t column, std::size_t row) {
    GaborPlace place = gabor_place_tiled(gabor_vec2(0.0f), grid.period);
    const double x = (grid.x + static_cast<double>(column) * grid.step) * double{place.cells_per_radius.x},
                 y = (grid.y + static_cast<double>(row) * grid.step) * double{place.cells_per_radius.y};
    place.cell = gabor_ivec2(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    place.local = gabor_vec2(static_cast<float>(x - std::floor(x)), static_cast<float>(y - std::floor(y)));
    place.evolution = grid.evolution;
    return gabor_field(place, grid.wave, grid.seed);
}

} // namespace

TEST_CASE("a grid has the noise of its pixels, whatever their number per node, period, time and place",
          "[grid]") {
    Largest noise, gradient;
    for (int i = 0; i < 120; ++i) {
        GaborGrid grid;
        grid.width = 1 + static_cast<std::size_t>(i * 7 % 97);
        grid.height = 1 + static_cast<std::size_t>(i * 5 % 41);
        grid.x = (i % 4 == 3 ? 1e6 : 0) + 1.37 * i - 20;
        grid.y = 0.71 * i - 7;
        grid.step = i % 3 == 0 ? 1 / 3.0 : i % 3 == 1 ? 1 / 16.0 : 0.71; // from half a node to nodes apart
        const float frequency = static_cast<float>(i % 21);
        grid.wave = gabor_wave_vector(frequency, 0.3f * static_cast<float>(i));
        grid.seed = static_cast<std::uint32_t>(i);
        grid.evolution = i % 5 == 4 ? 0.3f : 0.0f;
        grid.period = i % 6 == 5   ? gabor_vec2(4.0f, 6.0f)
                      : i % 6 == 2 ? gabor_vec2(0.0f, 5.0f)
                                   : gabor_vec2(0.0f);
        const std::size_t pixels = grid.width * grid.height;
        std::vector<float> plain(pixels), quadrature(pixels), complex(pixels), sloped(pixels), x(pixels),
            y(pixels);
        gabor_noise_grid(grid, plain.data());
        gabor_noise_grid_quadrature(grid, complex.data(), quadrature.data());
        gabor_noise_grid_gradient(grid, sloped.data(), x.data(), y.data());
        for (std::size_t at = 0; at < pixels; ++at) {
            const GaborField expected = pixel_of(grid, at % grid.width, at / grid.width);
            const auto where = [&] { return fmt::format("grid {}, pixel {}", i, at); };
            noise.see(double{plain[at]}, double{expected.noise}, 2e-5, where);
            noise.see(double{complex[at]}, double{expected.noise}, 2e-5, where);
            noise.see(double{sloped[at]}, double{expected.noise}, 2e-5, where);
            noise.see(double{quadrature[at]}, double{expected.quadrature}, 2e-5, where);
            const double unit = 2e-5 * (1 + 6.2831853 * double{frequency});
            gradient.see(double{x[at]}, double{expected.gradient.x}, unit, where);
            gradient.see(double{y[at]}, double{expected.gradient.y}, unit, where);
        }
    }
    noise.check("noise");
    gradient.check("gradient");
}
