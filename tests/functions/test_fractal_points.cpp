// Compares gabor_fractal_points.hpp with the noise of each point.

#include "largest.hpp"

#include "gabor_fractal_points.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <vector>

using gabor::test::Largest;

TEST_CASE("many points have the noise of each, whatever its octaves, period, time and place", "[fractal]") {
    Largest noise, gradient, volume;
    for (int i = 0; i < 96; ++i) {
        const auto share = [i](int k, int of) {
            return static_cast<float>(i * k % of) / static_cast<float>(of);
        };
        GaborFractal fractal = gabor_fractal(1.0f + 6.0f * share(5, 31), 0.3f + 0.6f * share(3, 7));
        fractal.lacunarity = i % 3 == 0 ? 2.0f : 1.5f + share(11, 23);
        fractal.turn = i % 4 == 0 ? 0.0f : 6.0f * share(7, 29) - 3.0f;
        fractal.basis = i % 2 == 0 ? GABOR_SMOOTH : GABOR_PERLIN;
        fractal.shape = i % 5 == 3 ? GABOR_BILLOW : i % 5 == 4 ? GABOR_RIDGED : GABOR_FBM;
        const auto seed = static_cast<std::uint32_t>(i);
        const gabor_vec3 period = i % 6 == 5   ? gabor_vec3(4.0f, 6.0f, 3.0f)
                                  : i % 6 == 2 ? gabor_vec3(0.0f, 5.0f, 0.0f)
                                               : gabor_vec3(0.0f);
        const std::size_t count = i == 0 ? 0 : 1 + static_cast<std::size_t>(i * 7 % 150); // blocks have 64
        std::vector<GaborPlace> place;
        std::vector<GaborPlace3d> place_3d;
        for (std::size_t k = 0; k < count; ++k) {
            const auto along = static_cast<float>(k);
            const gabor_vec3 p(0.37f * along - 9.0f, 5.0f - 0.11f * along, 0.05f * along);
            place.push_back(gabor_place_tiled(p.xy(), period.xy()));
            place_3d.push_back(gabor_place_3d_tiled(p, period));
            place.back().evolution = place_3d.back().evolution = i % 8 > 5 ? 0.3f : 0.0f;
            if (i % 7 < 3) { // else all cells are 0
                place.back().cell = gabor_ivec2(i * 1000003 - 40000000, 77 - int(k % 5));
                place_3d.back().cell = gabor_ivec3(place.back().cell, 12345678);
            }
        }
        std::vector<float> plain(count), sloped(count), x(count), y(count), solid(count);
        gabor_fractal_points(place.data(), count, fractal, seed, plain.data());
        gabor_fractal_points_gradient(place.data(), count, fractal, seed, sloped.data(), x.data(), y.data());
        gabor_fractal_points_3d(place_3d.data(), count, fractal, seed, solid.data());
        for (std::size_t k = 0; k < count; ++k) {
            const auto where = [&] { return fmt::format("fractal {}, point {}", i, k); };
            const GaborFractalNoise expected = gabor_fractal_noise(place[k], fractal, seed);
            noise.see(double{plain[k]}, double{expected.noise}, 2e-5, where);
            noise.see(double{sloped[k]}, double{expected.noise}, 2e-5, where);
            gradient.see(double{x[k]}, double{expected.gradient.x}, 1e-3, where);
            gradient.see(double{y[k]}, double{expected.gradient.y}, 1e-3, where);
            volume.see(double{solid[k]}, double{gabor_fractal_noise_3d(place_3d[k], fractal, seed).noise},
                       2e-5, where);
        }
    }
    noise.check("noise");
    gradient.check("gradient");
    volume.check("noise in a volume");
}
