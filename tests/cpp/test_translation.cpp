// The translation to C++ against the double-precision reference, and its range: compiled with contraction,
// without it, and with -ffast-math, as GPU compilers may do either.

#include "largest.hpp"
#include "reference/erosion.hpp"
#include "reference/lattice.hpp"
#include "reference/lattice_3d.hpp"
#include "reference/spectrum.hpp"
#include "render/range.hpp"
#include "translation.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace gabor::test {

static std::string to_string(const Arguments& a) {
    return fmt::format("p ({}, {}), cell ({}, {}) + ({}, {}), frequency {}, orientation {}, wave ({}, {}), "
                       "period ({}, {}), time {}, seed {}",
                       a.x, a.y, a.column, a.row, a.local_x, a.local_y, a.frequency, a.orientation, a.wave_x,
                       a.wave_y, a.period_x, a.period_y, a.time, a.seed);
}

static std::string to_string(const Pixel& pixel) {
    return fmt::format("dx ({}, {}), dy ({}, {})", pixel.dx[0], pixel.dx[1], pixel.dy[0], pixel.dy[1]);
}

} // namespace gabor::test

using namespace gabor;
using test::Arguments;
using test::Largest;
using test::Pixel;

namespace {

class Random {
  public:
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    float uniform(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }
    test::Vector vector(double most) {
        return {uniform(-most, most), uniform(-most, most), uniform(-most, most)};
    }
    // One number in eight is on an edge, and one next to it.
    float at_edge(float value) {
        const float edge = std::round(2 * value) / 2;
        return word() % 4 ? value : word() % 2 ? edge : std::nextafter(edge, word() % 2 ? 1e9f : -1e9f);
    }

  private:
    std::mt19937 random_{3};
};

} // namespace

TEST_CASE("the translation to C++ agrees with the reference") {
    for (const int taps : {2, 3, 4}) {
        Random draw;
        Largest value, gradient, stripes, at, animated, tiled;
        for (int i = 0; i < 20000; ++i) {
            const float reach = std::exp2(draw.uniform(0, 17));
            Arguments a;
            a.x = draw.at_edge(draw.uniform(-reach, reach));
            a.y = draw.at_edge(draw.uniform(-reach, reach));
            a.column = static_cast<std::int32_t>(draw.word());
            a.row = static_cast<std::int32_t>(draw.word());
            a.local_x = draw.at_edge(draw.uniform(-2, 3));
            a.local_y = draw.at_edge(draw.uniform(-2, 3));
            a.frequency = std::exp2(draw.uniform(-5, 6));
            a.orientation = draw.uniform(-8, 8);
            a.wave_x = draw.uniform(-4, 4);
            a.wave_y = draw.uniform(-4, 4);
            a.time = draw.uniform(-2, 2);
            a.seed = draw.word();
            const test::Values found = test::values(taps, a);

            const double tight =
                1.5e-5 * std::max(1.0, a.frequency / 4.0) * std::max(1.0, std::abs(a.orientation) / 2.0);
            noise::LatticePlace place;
            place.radius_x = place.radius_y = 0.5 * taps;
            // Fused with a difference, the product of p is not rounded to a float.
            place.local_x = a.x * (0.5f * static_cast<float>(taps));
            place.local_y = a.y * (0.5f * static_cast<float>(taps));
            const double rounding = std::max(std::abs(place.local_x), std::abs(place.local_y)) * 0x1p-24;
            const double loose = tight + 8 * std::numbers::pi * (a.frequency + 4) * rounding;
            const noise::Lattice reference(taps, a.frequency, a.orientation, a.seed);
            const auto here = reference.field(place);
            const double slope = 2 * std::numbers::pi * a.frequency + 4;
            value.see(found.gradient[0], here.value.imag(), loose, a);
            gradient.see(found.gradient[1], here.slope_x.imag(), slope * loose, a);
            gradient.see(found.gradient[2], here.slope_y.imag(), slope * loose, a);
            const noise::Lattice of_wave(taps, {a.wave_x, a.wave_y}, a.seed);
            const auto expected = noise::lattice_stripes(of_wave.field(place).value, 2);
            for (std::size_t c = 0; c < 3; ++c)
                stripes.see(found.stripes[c], expected[c], 2 * tight + 100 * rounding, a);
            place.animated = true;
            place.time = a.time;
            animated.see(found.animated, reference.field(place).value.imag(), loose, a);
            place = {};
            place.radius_x = place.radius_y = 0.5 * taps;
            place.cell_x = a.column;
            place.cell_y = a.row;
            place.local_x = a.local_x;
            place.local_y = a.local_y;
            at.see(found.at, reference.field(place).value.imag(), tight, a);

            a.x = draw.at_edge(draw.uniform(-20, 20));
            a.y = draw.at_edge(draw.uniform(-20, 20));
            a.period_x = draw.uniform(0.5, 9);
            a.period_y = draw.uniform(0.5, 9);
            place = {};
            const auto repeat = [taps](double p, double period, double& local, double& radius,
                                       std::int32_t& nodes) {
                nodes = std::max(static_cast<std::int32_t>(std::floor(period * 0.5 * taps + 0.5)), taps);
                radius = nodes / period;
                local = p * radius;
            };
            repeat(a.x, a.period_x, place.local_x, place.radius_x, place.period_x);
            repeat(a.y, a.period_y, place.local_y, place.radius_y, place.period_y);
            tiled.see(test::values(taps, a).tiled, reference.field(place).value.imag(),
                      tight + 2e-4 * (a.frequency + 4), a);
        }
        fmt::print("{} taps; largest differences in units of the tolerance\n", taps);
        value.check("gabor_noise");
        gradient.check("gabor_noise_gradient");
        stripes.check("gabor_stripes");
        animated.check("gabor_noise_animated");
        at.check("gabor_noise_at");
        tiled.check("gabor_noise_tiled");
    }
}

TEST_CASE("the variance is 1 at any distance") {
    for (const int taps : {2, 3, 4}) {
        Random draw;
        for (const double reach : {1.0, 1e5, 1e6, 1e7, 3e7, 1e8, 1e9, 4.29e9 / taps}) {
            constexpr int count = 20000;
            double sum = 0;
            float largest = 0;
            for (int i = 0; i < count; ++i) {
                Arguments a;
                a.x = draw.uniform(-reach, reach);
                a.y = draw.uniform(-reach, reach);
                a.seed = draw.word();
                const float noise = test::values(taps, a).gradient[0];
                sum += noise * noise;
                largest = std::max(largest, std::abs(noise));
            }
            INFO(taps << " taps, |p| < " << reach << ": variance " << sum / count << ", largest " << largest);
            CHECK(std::abs(sum / count - 1) < 5 * std::sqrt(2.0 / count));
            CHECK(largest < 6);
        }
    }
}

TEST_CASE("the variance of solid noise is 1 at any distance") {
    constexpr int count = 20000;
    for (const double reach : {16.0, 1e5, 1e7, 3e7, 1e8, 1e9, 1.43e9}) {
        Random draw;
        std::array<double, 3> power{};
        for (int i = 0; i < count; ++i) {
            const auto found =
                test::solid(draw.vector(reach), {}, {}, draw.uniform(0, 4), draw.vector(1), draw.word());
            for (std::size_t k = 0; k < power.size(); ++k)
                power[k] += found.noise[k] * found.noise[k];
        }
        for (std::size_t k = 0; k < power.size(); ++k) {
            INFO("noise " << k << ", |p| < " << reach << ": variance " << power[k] / count);
            CHECK(std::abs(power[k] / count - 1) < 5 * std::sqrt(2.0 / count));
        }
    }
}

TEST_CASE("solid noise, its gradient and its filter agree with the reference") {
    Random draw;
    Largest wave, isotropic, surface, slopes;
    std::array<double, 2> error{};
    constexpr int count = 2000, filtered = 60;
    for (int i = 0; i < count; ++i) {
        const auto p = draw.vector(16), normal = draw.vector(1), dx = draw.vector(0.15),
                   dy = draw.vector(0.15);
        const float frequency = draw.uniform(0, 4);
        const std::uint32_t seed = draw.word();
        const test::Solid found = test::solid(p, dx, dy, frequency, normal, seed);
        const auto where = [&] {
            return fmt::format("p ({}, {}, {}), frequency {}, normal ({}, {}, {}), seed {}", p[0], p[1], p[2],
                               frequency, normal[0], normal[1], normal[2], seed);
        };
        const noise::Lattice3d::Place place{.local = {p[0] * 1.5f, p[1] * 1.5f, p[2] * 1.5f}};
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        const noise::Lattice3d::Vector unit{normal[0] / length, normal[1] / length, normal[2] / length};
        const noise::Lattice3d of_wave({frequency * unit[0], frequency * unit[1], frequency * unit[2]}, seed);
        const noise::Isotropic3d of_all(frequency, seed);
        const auto waved = of_wave.field(place), even = of_all.field(place);
        double expected = 0;
        for (const auto& [weight, noise] : noise::surface_isotropic(unit, frequency, seed))
            expected += weight * noise.field(place).value.imag();
        wave.see(found.noise[0], waved.value.imag(), 5e-5, where);
        isotropic.see(found.noise[1], even.value.imag(), 5e-5, where);
        surface.see(found.noise[2], expected, 5e-5, where);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            slopes.see(found.slopes[axis], waved.slope[axis].imag(), 2e-3, where);
            slopes.see(found.slopes[3 + axis], even.slope[axis].imag(), 2e-3, where);
        }
        if (i >= filtered)
            continue;
        const auto wide = [](const test::Vector& v) { return noise::Lattice3d::Vector{v[0], v[1], v[2]}; };
        error[0] += std::pow(found.filtered[0] - of_wave.filtered(place, wide(dx), wide(dy)).value.imag(), 2);
        error[1] += std::pow(found.filtered[1] - of_all.filtered(place, wide(dx), wide(dy)).value.imag(), 2);
    }
    wave.check("gabor_noise_3d");
    isotropic.check("gabor_noise_3d_isotropic");
    surface.check("gabor_noise_surface_isotropic");
    slopes.check("the gradients");
    fmt::print("  filters off by {:.4f} and {:.4f} of the noise's deviation\n",
               std::sqrt(error[0] / filtered), std::sqrt(error[1] / filtered));
    CHECK(std::sqrt(error[0] / filtered) < 0.02);
    CHECK(std::sqrt(error[1] / filtered) < 0.02);
}

TEST_CASE("any finite arguments give finite noise") {
    constexpr float most = std::numeric_limits<float>::max();
    for (const int taps : {2, 3, 4}) {
        test::AnyFloat draw;
        test::Broken noise{"noise"}, slopes{"slopes"};
        for (int i = 0; i < 20000; ++i) {
            Arguments a;
            a.seed = draw.word();
            if (i % 3 == 0) {
                a.x = draw.within(test::world / 2);
                a.y = draw.within(test::world / 2);
                a.local_x = draw.within(64);
                a.local_y = draw.within(64);
                a.column = draw.cell();
                a.row = draw.cell();
                a.time = draw.within(most);
                a.period_x = a.period_y = 1e9f;
            } else if (i % 3 == 1) {
                a.frequency = draw.within(most);
                a.orientation = draw.within(most);
                a.wave_x = draw.within(most);
                a.wave_y = draw.within(most);
            } else {
                a.period_x = draw.within(most);
                a.period_y = draw.within(most);
                a.x = draw.within(1e4f);
                a.y = draw.within(1e4f);
            }
            const test::Values found = test::values(taps, a);
            const float one[] = {found.gradient[0], found.stripes[0], found.stripes[1], found.stripes[2],
                                 found.at,          found.tiled,      found.animated};
            noise.see(one, test::largest_noise, a);
            slopes.see(found.gradient, most, a);
        }
        for (const test::Broken& broken : {noise, slopes}) {
            INFO(taps << " taps, " << broken.function << ": " << broken.where);
            CHECK(broken.times == 0);
        }
    }
}

TEST_CASE("pixels that are lines, points or of any size have a footprint") {
    test::AnyFloat any;
    Random draw;
    test::Broken footprints{"gabor_footprint"}, values{"gabor_noise_filtered"}, removed{"removed"};
    for (int i = 0; i < 60000; ++i) {
        Pixel pixel;
        if (i % 2) {
            for (float* step : {pixel.dx, pixel.dx + 1, pixel.dy, pixel.dy + 1})
                *step = any.within(std::numeric_limits<float>::max());
        } else { // parallel, which makes the smaller deviation 0
            pixel.dx[0] = draw.uniform(-3, 3);
            pixel.dx[1] = draw.uniform(-3, 3);
            const float along = draw.word() % 4 ? draw.uniform(-2, 2) : 0;
            pixel.dy[0] = along * pixel.dx[0];
            pixel.dy[1] = along * pixel.dx[1];
        }
        Arguments a;
        a.x = draw.uniform(-9, 9);
        a.y = draw.uniform(-9, 9);
        a.frequency = draw.uniform(0, 2);
        const test::Filtered found = test::filtered(a, pixel);
        footprints.see(found.deviations, 0.51f, pixel);
        values.see(std::span(found.noise).first(3), test::largest_noise, pixel);
        removed.see(std::span(found.noise).last(1), 1.0001f, pixel);
    }
    for (const test::Broken& broken : {footprints, values, removed}) {
        INFO(broken.function << ": " << broken.where);
        CHECK(broken.times == 0);
    }
}

TEST_CASE("the filtered translation is the filtered noise") {
    Random draw;
    double error = 0, power = 0;
    constexpr int count = 150;
    for (int i = 0; i < count; ++i) {
        Arguments a;
        a.frequency = draw.uniform(0, 1.5);
        a.orientation = draw.uniform(0, 3);
        a.x = draw.uniform(-9, 9);
        a.y = draw.uniform(-9, 9);
        a.seed = draw.word();
        const Pixel pixel{{draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3)},
                          {draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3)}};
        const noise::Spectrum reference({{a.frequency, a.orientation, 1, 1, a.seed}});
        const auto expected =
            reference.filtered(a.x, a.y, {pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]}).value.imag();
        error += std::pow(test::filtered(a, pixel).noise[0] - expected, 2);
        power += expected * expected;
    }
    fmt::print("gabor_noise_filtered: {:.4f} of the noise's deviation off, of {:.2f} left\n",
               std::sqrt(error / count), std::sqrt(power / count));
    CHECK(power > 0.1 * count);
    CHECK(std::sqrt(error / count) < 0.015);
}

TEST_CASE("eroded hills agree with the reference") {
    for (const int taps : {2, 3}) {
        Random draw;
        Largest hills, heights, slopes;
        for (int i = 0; i < 20000; ++i) {
            Arguments a;
            a.column = static_cast<std::int32_t>(draw.word());
            a.row = static_cast<std::int32_t>(draw.word());
            a.local_x = draw.at_edge(draw.uniform(-2, 3));
            a.local_y = draw.at_edge(draw.uniform(-2, 3));
            a.period_x = a.period_y = 0;
            a.seed = draw.word();
            const Pixel pixel{{draw.uniform(-0.1, 0.1), 0}, {0, draw.uniform(-0.1, 0.1)}};
            const test::Eroded found = test::eroded(taps, a, pixel, true);
            const noise::Ground ground{{a.column, a.row}, {a.local_x, a.local_y}, {}};
            hills.see(
                found.base[0],
                noise::terrain(ground, {pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]}, a.seed).height,
                1e-6, a);
            const noise::Terrain base{found.base[0], {found.base[1], found.base[2]}, found.base[3]};
            const noise::Terrain terrain = noise::eroded(taps, ground, {pixel.dx[0], pixel.dx[1]},
                                                         {pixel.dy[0], pixel.dy[1]}, base, {}, a.seed);
            heights.see(found.terrain[0], terrain.height, 1e-5, a);
            slopes.see(found.terrain[1], terrain.slope[0], 2e-4, a);
            slopes.see(found.terrain[2], terrain.slope[1], 2e-4, a);
        }
        fmt::print("{} taps; largest differences in units of the tolerance\n", taps);
        hills.check("gabor_terrain_at");
        heights.check("gabor_eroded_at");
        slopes.check("  its slope");
    }
}

TEST_CASE("any place, pixel and base give a finite terrain") {
    constexpr float most = std::numeric_limits<float>::max();
    for (const int taps : {2, 3}) {
        test::AnyFloat draw;
        test::Broken terrain{"gabor_eroded_at"}, hills{"gabor_terrain_at"};
        for (int i = 0; i < 40000; ++i) {
            Arguments a;
            a.seed = draw.word();
            const bool tiled = i % 2;
            a.column = tiled ? 0 : draw.cell();
            a.row = tiled ? 0 : draw.cell();
            a.local_x = draw.within(1e6f);
            a.local_y = draw.within(1e6f);
            a.period_x = tiled ? std::max(std::abs(draw.within(1e6f)), 0.5f) : 0;
            a.period_y = i % 4 == 1 ? std::max(std::abs(draw.within(1e6f)), 0.5f) : 0;
            a.x = draw.within(1e30f);
            a.wave_x = draw.within(most);
            a.wave_y = draw.within(most);
            a.time = draw.within(1);
            const Pixel pixel{{draw.within(1e15f), draw.within(1e15f)},
                              {draw.within(1e15f), draw.within(1e15f)}};
            const test::Eroded found = test::eroded(taps, a, pixel, i % 3 == 0);
            hills.see(std::span(found.base).first(1), 1e30f, a);
            terrain.see(std::span(found.terrain).first(1), 2e30f, a);
            terrain.see(std::span(found.terrain).last(1), 1.001f, a);
        }
        for (const test::Broken& broken : {terrain, hills}) {
            INFO(taps << " taps, " << broken.function << ": " << broken.where);
            CHECK(broken.times == 0);
        }
    }
}

TEST_CASE("noise along a map read at the nodes agrees with the reference") {
    Random draw;
    Largest field;
    for (int i = 0; i < 20000; ++i) {
        Arguments a;
        // Next to a node's edge a float may round to the other side, where nodes have other numbers.
        const auto place_on = [&draw](float value) {
            return draw.word() % 4 ? value : std::round(2 * value) / 2;
        };
        a.column = static_cast<std::int32_t>(draw.word());
        a.row = static_cast<std::int32_t>(draw.word());
        a.local_x = place_on(draw.uniform(-2, 3));
        a.local_y = place_on(draw.uniform(-2, 3));
        a.time = draw.word() % 2 ? draw.uniform(-2, 2) : 0;
        a.seed = draw.word();
        test::Waves waves;
        noise::Lattice::Waves expected_waves;
        for (std::size_t k = 0; k < 9; ++k)
            for (std::size_t axis = 0; axis < 2; ++axis)
                expected_waves[k][axis] = waves.wave[k][axis] = draw.word() % 8 ? draw.uniform(-4, 4) : 0;
        const auto found = test::directed(a, waves);

        noise::LatticePlace place;
        place.cell_x = a.column;
        place.cell_y = a.row;
        place.local_x = a.local_x;
        place.local_y = a.local_y;
        place.animated = a.time != 0;
        place.time = a.time;
        const auto expected = noise::Lattice::field(place, expected_waves, a.seed);
        const double of_field[] = {expected.value.real(),   expected.value.imag(),   expected.slope_x.real(),
                                   expected.slope_x.imag(), expected.slope_y.real(), expected.slope_y.imag()};
        for (std::size_t c = 0; c < 6; ++c)
            field.see(found[c], of_field[c], c < 2 ? 2e-5 : 6e-4, a);
    }
    field.check("gabor_field_waves");
}

// Variances 1 of the value and sum (grad h grad h^T + 4 pi^2 h^2 F F^T) / (sum h^2)^2 of the gradient.
TEST_CASE("noise along a map read at the nodes has its law at every place") {
    constexpr int count = 1 << 17;
    Random draw;
    for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {0.5f, 0.5f}, {0.25f, -0.4f}, {-0.5f, 0.1f}}) {
        test::Waves waves;
        for (auto& wave : waves.wave)
            for (float& component : wave)
                component = draw.uniform(-1.5, 1.5);
        double expected[3] = {};
        for (int k = 0; k < 9; ++k) {
            const double dx = double{x} - std::floor(x + 0.5f) - k % 3 + 1;
            const double dy = double{y} - std::floor(y + 0.5f) - k / 3 + 1;
            const auto across = noise::lattice_window(3, dx / 1.5),
                       along = noise::lattice_window(3, dy / 1.5);
            const double h[] = {across.slope * along.value, across.value * along.slope};
            const double turns = 2 * std::numbers::pi * across.value * along.value;
            const double fx = turns * waves.wave[k][0], fy = turns * waves.wave[k][1];
            expected[0] += h[0] * h[0] + fx * fx;
            expected[1] += h[1] * h[1] + fy * fy;
            expected[2] += h[0] * h[1] + fx * fy;
        }
        double sums[8] = {};
        for (int i = 0; i < count; ++i) {
            Arguments a;
            a.column = a.row = 12;
            a.local_x = x;
            a.local_y = y;
            a.seed = draw.word();
            const auto f = test::directed(a, waves);
            const double n = f[1], nx = f[3], ny = f[5];
            const double products[] = {n * n,  nx * nx, ny * ny,       nx * ny,
                                       n * nx, n * ny,  n * n * n * n, nx * nx * nx * nx};
            for (std::size_t c = 0; c < 8; ++c)
                sums[c] += products[c] / count;
        }
        const double energy = 81.0 / 64; // (sum h^2)^2
        const double error = 5 * std::sqrt(2.0 / count);
        INFO("local (" << x << ", " << y << "): variances " << sums[0] << ", " << sums[1] << ", " << sums[2]
                       << ", kurtosis " << sums[6] / (sums[0] * sums[0]));
        CHECK(std::abs(sums[0] - 1) < error);
        CHECK(std::abs(sums[1] * energy / expected[0] - 1) < error);
        CHECK(std::abs(sums[2] * energy / expected[1] - 1) < error);
        CHECK(std::abs(sums[3] * energy - expected[2]) < error * std::sqrt(expected[0] * expected[1]));
        CHECK(std::abs(sums[4]) < error * std::sqrt(sums[1]));
        CHECK(std::abs(sums[5]) < error * std::sqrt(sums[2]));
        CHECK(std::abs(sums[6] / (sums[0] * sums[0]) - 3) < 5 * std::sqrt(24.0 / count) + 0.02);
        CHECK(std::abs(sums[7] / (sums[1] * sums[1]) - 3) < 5 * std::sqrt(24.0 / count) + 0.02);
    }
}

namespace {

// The profiles at a phase, sharp, from their definitions.
std::array<double, 5> sharp(double phase, double duty) {
    const double t = phase - std::floor(phase);
    return {0.5 - 0.5 * std::cos(2 * std::numbers::pi * t), 1 - std::abs(2 * t - 1), t, t < duty ? 1.0 : 0.0,
            4 * t * (1 - t)};
}

std::array<double, 5> averaged(double phase, double duty, double width) {
    constexpr int steps = 4000;
    std::array<double, 5> sum{};
    for (int i = 0; i < steps; ++i) {
        const auto values = sharp(phase + width * ((i + 0.5) / steps - 0.5), duty);
        for (std::size_t c = 0; c < 5; ++c)
            sum[c] += values[c] / steps;
    }
    return sum;
}

} // namespace

TEST_CASE("profiles are averages over a width, or over the phases that shorten stripes") {
    Random draw;
    Largest by_width, by_stripes;
    for (int i = 0; i < 2000; ++i) {
        const float phase = draw.uniform(-3, 3), duty = draw.uniform(0, 1);
        const float width = draw.word() % 4 ? draw.uniform(0, 1.2) : std::exp2(draw.uniform(-9, 0));
        const auto where = [&] { return fmt::format("phase {}, width {}, duty {}", phase, width, duty); };
        const auto found = test::profiles(phase, duty, width);
        const double used = std::clamp(static_cast<double>(width), 0.001, 1.0);
        const auto expected = averaged(phase, duty, used);
        for (std::size_t c = 0; c < 5; ++c)
            by_width.see(found[c], expected[c], 5e-4 + 1e-6 / used, where);

        const double length = std::sin(std::numbers::pi * used) / (std::numbers::pi * used);
        const double angle = 2 * std::numbers::pi * phase;
        const auto stripes = test::stripe_profiles(static_cast<float>(length * std::cos(angle)),
                                                   static_cast<float>(length * std::sin(angle)), duty);
        if (used > 0.02 && used < 0.98) // beyond, a length as a float does not tell a width or a phase
            for (std::size_t c = 0; c < 5; ++c)
                by_stripes.see(stripes[c], expected[c], 0.003 / used, where);
    }
    by_width.check("gabor_profile_...");
    by_stripes.check("gabor_stripes_sine ...");
}

// The mean of z min(1 / |z|, sharpness) and of |z|, z = v + sqrt(removed) times normal numbers.
TEST_CASE("filtered stripes are the mean of stripes over what a filter removes") {
    Random draw;
    Largest mean, intensity, sharp_ones, removed, at_places;
    std::mt19937 random(5);
    std::normal_distribution<> normal;
    std::vector<std::array<double, 2>> normals(4000);
    for (auto& pair : normals)
        pair = {normal(random), normal(random)};
    for (int i = 0; i < 200; ++i) {
        Arguments a;
        a.x = draw.uniform(-9, 9);
        a.y = draw.uniform(-9, 9);
        a.wave_x = draw.uniform(-1.5, 1.5);
        a.wave_y = draw.uniform(-1.5, 1.5);
        a.seed = draw.word();
        const float sharpness = draw.uniform(1, 4);
        const Pixel pixel{{draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3)},
                          {draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3)}};
        const auto found = test::filtered_stripes(a, pixel, sharpness);
        const noise::Spectrum reference(
            {{std::hypot(a.wave_x, a.wave_y), std::atan2(a.wave_y, a.wave_x), 1, 1, a.seed}});
        const auto value =
            reference.filtered(a.x, a.y, {pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]}).value;
        const double share = reference.removed({pixel.dx[0], pixel.dx[1]}, {pixel.dy[0], pixel.dy[1]});
        std::array<double, 3> sum{};
        for (const auto& [u, v] : normals) {
            const auto stripes =
                noise::lattice_stripes(value + std::sqrt(share) * std::complex(u, v), sharpness);
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += stripes[c] / static_cast<double>(normals.size());
        }
        mean.see(found[0], sum[0], 0.1, a);
        mean.see(found[1], sum[1], 0.1, a);
        intensity.see(found[2], sum[2], 0.13, a);
        removed.see(found[3], share, 0.02, a);
        const auto whole = test::filtered_stripes(a, {}, sharpness);
        const noise::Lattice lattice(3, {a.wave_x, a.wave_y}, a.seed);
        noise::LatticePlace place;
        place.local_x = a.x * 1.5f;
        place.local_y = a.y * 1.5f;
        const auto expected = noise::lattice_stripes(lattice.field(place).value, sharpness);
        for (std::size_t c = 0; c < 3; ++c)
            sharp_ones.see(whole[c], expected[c], 2e-4, a);

        a.column = static_cast<std::int32_t>(draw.word());
        a.row = static_cast<std::int32_t>(draw.word());
        a.local_x = draw.uniform(-2, 3);
        a.local_y = draw.uniform(-2, 3);
        a.time = draw.uniform(-2, 2);
        const auto placed = test::filtered_stripes_at(a, sharpness);
        place = {a.column, a.row, a.local_x, a.local_y};
        place.period_x = 7;
        place.period_y = 5;
        place.animated = true;
        place.time = a.time;
        const auto there = noise::lattice_stripes(lattice.field(place).value, sharpness);
        for (std::size_t c = 0; c < 3; ++c)
            at_places.see(placed[c], there[c], 2e-4, a);
        at_places.see(placed[3], 0, 1e-6, a);
    }
    mean.check("gabor_stripes_filtered");
    intensity.check("its intensity");
    removed.check("its removed variance");
    sharp_ones.check("of a point");
    at_places.check("gabor_stripes_filtered_at of a point");
}
