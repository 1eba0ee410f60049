// Compares every function of the drop-in on the device with the double-precision reference.

#include "oracle.hpp"
#include "sampler.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;
using test::slope_tolerance;
using test::tolerance;

namespace {

constexpr std::size_t per_batch = 1 << 14;

const noise::Recipe sines{"sines", 3, 1.5f, 0.2f, 2, {0.5f, 1.5f, -1.0f}, ""};
const noise::Recipe uneven{"uneven", 1, 1.06f, 0.5f, 4, {1, 0, 0}, ""};

} // namespace

TEST_CASE("the noise, its quadrature and its gradient agree with the reference", "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t count = 1 << 12;
    Draw draw(1);
    for (const noise::Recipe& recipe : {noise::find_recipe("one"), noise::find_recipe("pure"),
                                        noise::find_recipe("paper"), sines, uneven}) {
        test::Sampler sampler(device, recipe, count);
        Differences of;
        std::size_t points = 0;
        for (int batch = 0; batch < 34; ++batch) {
            // Frequencies from 0.1 to 64, evenly in octaves, with both ends and the end of the series.
            const float frequency =
                batch == 0 ? 0.63662f : 0.1f * static_cast<float>(std::exp2(batch * 0.28281));
            const float orientation =
                batch % 4 == 0 ? static_cast<float>(batch / 4) * 0.78539816f : draw.uniform(-8, 8);
            const std::uint32_t seed = batch == 1 ? 0 : draw.word();
            for (test::Sample& sample : sampler.samples())
                sample = {draw.place(recipe), frequency, orientation, seed};
            const noise::Reference reference(recipe, frequency, orientation, seed);
            const auto answers = sampler.answers(count);
            const double tight = tolerance(frequency);
            const double loose = slope_tolerance(frequency);
            // At low frequency a sine is small and its quadrature correspondingly large.
            const double quadrature_tight = tight * (recipe.phases == 2 ? std::max(1.0, 2.0 / frequency) : 1);
            const double quadrature_loose = loose * quadrature_tight / tight;
            for (std::size_t i = 0; i < count; ++i) {
                const test::Sample& sample = sampler.samples()[i];
                const test::Answer& answer = answers[i];
                const noise::Reference::Field field = reference.field(sample.place);
                const double expected = field.value.imag();
                of["gabor_field"].see(answer.value[1], expected, tight, sample);
                of["gabor_field, real part"].see(answer.value[0], field.value.real(), quadrature_tight,
                                                 sample);
                of["gabor_field, gradient"].see(answer.slope_x[1], field.slope_x.imag(), loose, sample);
                of["gabor_field, gradient"].see(answer.slope_y[1], field.slope_y.imag(), loose, sample);
                of["gabor_field, gradient of the real part"].see(answer.slope_x[0], field.slope_x.real(),
                                                                 quadrature_loose, sample);
                of["gabor_field, gradient of the real part"].see(answer.slope_y[0], field.slope_y.real(),
                                                                 quadrature_loose, sample);
                of["gabor_noise_at"].see(answer.at, expected, tight, sample);
                of["gabor_unorm"].see(answer.unorm, std::clamp(0.5 + 0.25 * expected, 0.0, 1.0), tight,
                                      sample);
                const noise::Reference::Field here = reference.field(test::here(sample, recipe));
                of["gabor_noise"].see(answer.noise, here.value.imag(), tight, sample);
                of["gabor_noise"].see(answer.gradient[0], here.value.imag(), tight, sample);
                of["gabor_noise"].see(answer.complex[1], here.value.imag(), tight, sample);
                of["gabor_noise_complex"].see(answer.complex[0], here.value.real(), quadrature_tight, sample);
                of["gabor_noise_gradient"].see(answer.gradient[1], here.slope_x.imag(), loose, sample);
                of["gabor_noise_gradient"].see(answer.gradient[2], here.slope_y.imag(), loose, sample);
            }
            points += count;
        }
        fmt::print("{}: {} points on {}; largest differences in units of the tolerance\n", recipe.name,
                   points, device.info().name);
        test::check(of, 9);
    }
}

TEST_CASE("periods in space and time agree with the reference", "[oracle]") {
    const vulkan::Device device;
    Draw draw(5);
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::Sampler sampler(device, recipe, per_batch);
        Differences of;
        for (int batch = 0; batch < 16; ++batch) {
            const float frequency = draw.uniform(1.5, 8);
            const float orientation = draw.uniform(-8, 8);
            const std::uint32_t seed = draw.word();
            for (test::Sample& sample : sampler.samples()) {
                sample = {draw.place(recipe), frequency, orientation, seed};
                noise::Place& p = sample.place;
                p.time = draw.uniform(-2, 2);
                p.period_x = static_cast<std::int32_t>(draw.word() % 100);
                p.period_y = static_cast<std::int32_t>(2 + draw.word() % 5);
                p.radius_x = recipe.radius * draw.uniform(0.5, 1);
                p.radius_y = recipe.radius * draw.uniform(0.5, 1);
                sample.period_x = draw.uniform(1, 20); // clamped to 2
                sample.period_y = draw.uniform(1, 3);
            }
            const noise::Reference reference(recipe, frequency, orientation, seed);
            const auto answers = sampler.answers(per_batch);
            const double tight =
                2 * tolerance(frequency); // fewer cells per radius give fewer, larger impulses
            for (std::size_t i = 0; i < per_batch; ++i) {
                const test::Sample& sample = sampler.samples()[i];
                const noise::Reference::Field field = reference.field(sample.place);
                of["gabor_field"].see(answers[i].value[1], field.value.imag(), tight, sample);
                of["gabor_field, gradient"].see(answers[i].slope_x[1], field.slope_x.imag(),
                                                2 * slope_tolerance(frequency), sample);
                of["gabor_field, gradient"].see(answers[i].slope_y[1], field.slope_y.imag(),
                                                2 * slope_tolerance(frequency), sample);

                // Functions of a position, where a float resolves it: it rounds by 10^-6, and the wave turns
                // by 2 pi F per radius.
                const double rounded = 3e-5 * (1 + frequency);
                const double x = sample.x;
                const double y = sample.y;
                if (std::max(std::abs(x), std::abs(y)) > 8)
                    continue;
                noise::Place still = test::here(sample, recipe);
                still.time = sample.place.time;
                of["gabor_noise_animated"].see(answers[i].animated, reference(still), rounded, sample);
                const double period_x = std::max(2.0f, sample.period_x);
                const double period_y = std::max(2.0f, sample.period_y);
                const double cells_x = std::floor(period_x * recipe.radius);
                const double cells_y = std::floor(period_y * recipe.radius);
                noise::Place tile;
                tile.radius_x = static_cast<float>(cells_x / period_x);
                tile.radius_y = static_cast<float>(cells_y / period_y);
                tile.local_x = static_cast<float>(x * cells_x / period_x);
                tile.local_y = static_cast<float>(y * cells_y / period_y);
                tile.period_x = static_cast<std::int32_t>(cells_x);
                tile.period_y = static_cast<std::int32_t>(cells_y);
                of["gabor_noise_tiled"].see(answers[i].tiled, reference(tile), rounded, sample);
            }
        }
        fmt::print("{}, with periods; largest differences in units of the tolerance\n", recipe.name);
        test::check(of, 4);
    }
}

TEST_CASE("the gradient equals differences of the reference", "[oracle]") {
    Draw draw(6);
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        const noise::Reference reference(recipe, 3, 0.7, 9);
        for (int i = 0; i < 2000; ++i) {
            // Places exact in a float, on and across the edges of cells and windows.
            const auto coordinate = [&] { return std::floor(draw.uniform(-8, 8) * 256) / 256; };
            const float x = coordinate();
            const float y = coordinate();
            const auto value = [&](float dx, float dy) {
                return reference(noise::place_at(recipe, 0, 0, x + dx, y + dy));
            };
            constexpr float h = 0x1p-12f;
            const noise::Reference::Field field = reference.field(noise::place_at(recipe, 0, 0, x, y));
            const double along_x = (value(h, 0) - value(-h, 0)) / (2 * h) * recipe.radius;
            const double along_y = (value(0, h) - value(0, -h)) / (2 * h) * recipe.radius;
            // h^2 / 6 times the third derivative, (2 pi F)^3 times a few sigma.
            REQUIRE(field.slope_x.imag() == Approx(along_x).margin(5e-4));
            REQUIRE(field.slope_y.imag() == Approx(along_y).margin(5e-4));
        }
    }
}

TEST_CASE("phase and intensity reproduce the complex value", "[oracle]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::Sampler sampler(device, recipe, per_batch);
        Draw draw(7);
        for (test::Sample& sample : sampler.samples())
            sample = {draw.place(recipe), 4, 0.3f, 8};
        for (const test::Answer& answer : sampler.answers(per_batch)) {
            const double turn = 2 * std::numbers::pi * answer.phasor[0];
            REQUIRE((answer.phasor[0] >= 0 && answer.phasor[0] < 1));
            REQUIRE(answer.phasor[1] * std::cos(turn) == Approx(answer.value[0]).margin(2e-5));
            REQUIRE(answer.phasor[1] * std::sin(turn) == Approx(answer.value[1]).margin(2e-5));
        }
    }
}

TEST_CASE("impulse words agree bit for bit", "[oracle]") {
    const vulkan::Device device;
    test::Sampler sampler(device, noise::find_recipe("one"), 1 << 16);
    std::mt19937 random(2);
    std::size_t i = 0;
    for (test::Sample& sample : sampler.samples()) {
        constexpr std::int32_t edges[] = {0,
                                          1,
                                          -1,
                                          1'000'000'000,
                                          std::numeric_limits<std::int32_t>::max(),
                                          std::numeric_limits<std::int32_t>::min()};
        const auto cell = [&] {
            return i % 3 == 0 ? edges[random() % 6] : static_cast<std::int32_t>(random());
        };
        sample = {noise::place_at(noise::find_recipe("one"), cell(), cell(), 0.5f, 0.5f), 4, 0,
                  static_cast<std::uint32_t>(i % 5 == 0 ? random() % 3 : random()),
                  static_cast<std::uint32_t>(random() % 40)};
        ++i;
    }
    const auto answers = sampler.answers(1 << 16);
    for (std::size_t k = 0; k < answers.size(); ++k) {
        const test::Sample& s = sampler.samples()[k];
        REQUIRE(answers[k].word ==
                noise::impulse_word(s.place.cell_x, s.place.cell_y, static_cast<int>(s.index), s.seed));
    }
}

TEST_CASE("frequencies outside the range are clamped and never give NaN", "[oracle]") {
    const vulkan::Device device;
    test::Sampler sampler(device, noise::find_recipe("one"), 64);
    const noise::Place here = noise::place_at(noise::find_recipe("one"), 3, 4, 0.3f, 0.8f);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float frequencies[] = {0, -0.0f, 1e-30f, -3, 1e30f, infinity, -infinity};
    for (std::size_t i = 0; i < std::size(frequencies); ++i)
        sampler.samples()[i] = {here, frequencies[i], 0.3f, 5};
    sampler.samples()[std::size(frequencies)] = {here, 1e-6f, 0.3f, 5};
    sampler.samples()[std::size(frequencies) + 1] = {here, 3, 0.3f, 5};
    const auto answers = sampler.answers(std::size(frequencies) + 2);
    for (std::size_t i = 0; i < std::size(frequencies); ++i)
        CHECK(std::isfinite(answers[i].at));
    const float lowest = answers[std::size(frequencies)].at;
    for (const std::size_t i : {0u, 1u, 2u})
        CHECK(answers[i].at == lowest);
    CHECK(answers[3].at == answers[std::size(frequencies) + 1].at);
}

TEST_CASE("painted frequency and orientation leave no seam", "[oracle]") {
    const vulkan::Device device;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::Sampler sampler(device, recipe, per_batch);
        const std::span<test::Sample> samples = sampler.samples();
        constexpr double step = 0x1p-11; // kernel radii; the line crosses eight cells
        for (std::size_t i = 0; i < per_batch; ++i) {
            const double x = static_cast<double>(i) * step;
            samples[i] = {noise::place_at(recipe, 0, 0, static_cast<float>(x * recipe.radius), 0.37f),
                          static_cast<float>(4 + std::sin(x)), static_cast<float>(std::sin(0.7 * x)), 3};
        }
        const auto answers = sampler.answers(per_batch);
        Largest bend;
        // The second derivative is at most (2 pi F)^2 times a few sigma; a seam would exceed that by its
        // height.
        const double bound = std::pow(2 * std::numbers::pi * 5 * step, 2) * 5;
        for (std::size_t i = 1; i + 1 < per_batch; ++i)
            bend.see(double{answers[i - 1].at} + answers[i + 1].at, 2 * double{answers[i].at}, bound,
                     samples[i]);
        bend.check(recipe.name);
    }
}
