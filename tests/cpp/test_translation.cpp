// The translation to C++ compiled with -ffast-math, as GPU compilers may do: its range, its law and its
// profiles. Its values are compared with golden ones, however they are rounded.

#include "largest.hpp"
#include "reference/lattice.hpp"
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

  private:
    std::mt19937 random_{3};
};

} // namespace

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
                test::solid(draw.vector(reach), draw.uniform(0, 4), draw.vector(1), draw.word());
            for (std::size_t k = 0; k < power.size(); ++k)
                power[k] += found[k] * found[k];
        }
        for (std::size_t k = 0; k < power.size(); ++k) {
            INFO("noise " << k << ", |p| < " << reach << ": variance " << power[k] / count);
            CHECK(std::abs(power[k] / count - 1) < 5 * std::sqrt(2.0 / count));
        }
    }
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

TEST_CASE("pixels of any size, even lines and points, have a footprint") {
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

TEST_CASE("any place, pixel and base give finite terrain") {
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

// Variances 1 of the value and sum (grad h grad h^T + 4 pi^2 h^2 F F^T) / (sum h^2)^2 of the gradient.
TEST_CASE("noise along a map that is read at the nodes is normal at every place") {
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

TEST_CASE("profiles are averages over a width, or over the phases that shortened stripes stand for") {
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
        if (used > 0.02 && used < 0.98) // beyond, a float length is too coarse to determine width or phase
            for (std::size_t c = 0; c < 5; ++c)
                by_stripes.see(stripes[c], expected[c], 0.003 / used, where);
    }
    by_width.check("gabor_profile_...");
    by_stripes.check("gabor_stripes_sine ...");
}

// The mean of z min(1 / |z|, sharpness) and of |z|, z = v + sqrt(removed) times normal numbers.
TEST_CASE("filtered stripes are the mean of stripes over the removed noise") {
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
            {{std::hypot(a.wave_x, a.wave_y), std::atan2(a.wave_y, a.wave_x), {1, 1}, 1, a.seed}});
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
