// Every function of the drop-in, on the device, against the double-precision reference.

#include "noise/reference.hpp"
#include "sampler.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

using namespace gabor;

namespace {

constexpr std::size_t per_batch = 1 << 14;

struct Largest {
    double difference = 0; ///< in units of the tolerance
    std::string place = "nowhere";

    void see(double value, double expected, double tolerance, const test::Sample& sample) {
        const double scaled = std::abs(value - expected) / tolerance;
        if (scaled <= difference) // a NaN is seen
            return;
        difference = scaled;
        place = fmt::format(
            "{} instead of {} at cell ({}, {}) + ({}, {}), frequency {}, orientation {}, seed {}", value,
            expected, sample.position.cell_x, sample.position.cell_y, sample.position.local_x,
            sample.position.local_y, sample.frequency, sample.orientation, sample.seed);
    }
};

// 1e-5 up to frequency 4, above in proportion to it: single precision carries no more of the phase.
double tolerance(double frequency) {
    return 1e-5 * std::max(1.0, frequency / 4);
}

const noise::Recipe sines{"sines", 3, 1.5f, 0.2f, 2, {0.5f, 1.5f, -1.0f}, ""};
const noise::Recipe uneven{"uneven", 1, 1.06f, 0.5f, 4, {1, 0, 0}, ""};

} // namespace

TEST_CASE("gabor_noise and gabor_noise_at agree with the reference", "[oracle]") {
    const vulkan::Device device;
    std::mt19937 random(1);
    const auto uniform = [&](double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random));
    };
    for (const noise::Recipe& recipe : {noise::find_recipe("one"), noise::find_recipe("pure"),
                                        noise::find_recipe("paper"), sines, uneven}) {
        test::Sampler sampler(device, recipe, per_batch);
        Largest at;
        Largest plain;
        Largest unorm;
        std::size_t points = 0;
        for (int batch = 0; batch < 34; ++batch) {
            // The frequencies cover 0.1 to 64 evenly in octaves, both ends and the series' end included.
            const float frequency =
                batch == 0 ? 0.47745f : 0.1f * static_cast<float>(std::exp2(batch * 0.28281));
            const float orientation =
                batch % 4 == 0 ? static_cast<float>(batch / 4) * 0.78539816f : uniform(-8, 8);
            const auto seed = static_cast<std::uint32_t>(batch == 1 ? 0 : random());
            for (test::Sample& sample : sampler.samples()) {
                sample = {{}, frequency, orientation, seed};
                noise::Position& p = sample.position;
                // All quadrants, up to 10^6, and one in four on or next to a cell's edge.
                const float reach = std::exp2(uniform(0, 20));
                p.local_x = uniform(-reach, reach);
                p.local_y = uniform(-reach, reach);
                if (random() % 4 == 0)
                    p.local_x = std::round(p.local_x);
                if (random() % 4 == 0)
                    p.local_y = std::nextafter(std::round(p.local_y), random() % 2 ? 1e9f : -1e9f);
                if (random() % 2) {
                    p.cell_x = static_cast<std::int32_t>(random());
                    p.cell_y = static_cast<std::int32_t>(random());
                    p.local_x -= std::floor(p.local_x);
                    p.local_y -= std::floor(p.local_y);
                }
            }
            const noise::Reference reference(recipe, frequency, orientation, seed);
            const auto answers = sampler.answers(per_batch);
            for (std::size_t i = 0; i < per_batch; ++i) {
                const test::Sample& sample = sampler.samples()[i];
                const double expected = reference(sample.position);
                at.see(answers[i].at, expected, tolerance(frequency), sample);
                unorm.see(answers[i].unorm, std::clamp(0.5 + 0.25 * expected, 0.0, 1.0), tolerance(frequency),
                          sample);
                if (recipe.radius == 1) { // else the shader's division and product round
                    const noise::Position here{0, 0, sample.position.local_x, sample.position.local_y};
                    plain.see(answers[i].plain, reference(here), tolerance(frequency), sample);
                }
            }
            points += per_batch;
        }
        fmt::print("{}: {} points on {}; largest differences in units of 1e-5 max(1, F / 4)\n", recipe.name,
                   points, device.info().name);
        fmt::print("  gabor_noise_at {:.3f}: {}\n", at.difference, at.place);
        fmt::print("  gabor_noise    {:.3f}: {}\n", plain.difference, plain.place);
        CHECK(at.difference <= 1);
        CHECK(plain.difference <= 1);
        CHECK(unorm.difference <= 1);
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
        sample = {{cell(), cell(), 0.5f, 0.5f},
                  4,
                  0,
                  static_cast<std::uint32_t>(i % 5 == 0 ? random() % 3 : random()),
                  static_cast<std::uint32_t>(random() % 40)};
        ++i;
    }
    const auto answers = sampler.answers(1 << 16);
    for (std::size_t k = 0; k < answers.size(); ++k) {
        const test::Sample& s = sampler.samples()[k];
        REQUIRE(answers[k].word ==
                noise::impulse_word(s.position.cell_x, s.position.cell_y, static_cast<int>(s.index), s.seed));
    }
}

TEST_CASE("frequencies outside the range are clamped and never give NaN", "[oracle]") {
    const vulkan::Device device;
    test::Sampler sampler(device, noise::find_recipe("one"), 64);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float frequencies[] = {0, -0.0f, 1e-30f, -3, 1e30f, infinity, -infinity};
    for (std::size_t i = 0; i < std::size(frequencies); ++i)
        sampler.samples()[i] = {{3, 4, 0.3f, 0.8f}, frequencies[i], 0.3f, 5};
    sampler.samples()[std::size(frequencies)] = {{3, 4, 0.3f, 0.8f}, 1e-6f, 0.3f, 5};
    sampler.samples()[std::size(frequencies) + 1] = {{3, 4, 0.3f, 0.8f}, 3, 0.3f, 5};
    const auto answers = sampler.answers(std::size(frequencies) + 2);
    for (std::size_t i = 0; i < std::size(frequencies); ++i)
        CHECK(std::isfinite(answers[i].at));
    const float lowest = answers[std::size(frequencies)].at;
    for (const std::size_t i : {0u, 1u, 2u})
        CHECK(answers[i].at == lowest);
    CHECK(answers[3].at == answers[std::size(frequencies) + 1].at);
}
