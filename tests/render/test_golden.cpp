// What this version of the noise is, in numbers: the words of impulses bit for bit, and 8 x 8 values of every
// function of the drop-in for each recipe, at the origin and 10^9 cells away. Whoever changes them changes
// pixels, and so the version. The numbers are in tests/golden; after a change that is meant, this writes them
// anew, and the diff shows what changed:
//
//     GABOR_GOLDEN=write build/dev/tests/test_render "[golden]"

#include "golden.hpp"
#include "sampler.hpp"

#include <catch2/catch.hpp>

using namespace gabor;
using test::Golden;
using test::slope_tolerance;
using test::tolerance;

namespace {

constexpr std::size_t count = Golden::side * Golden::side;
constexpr float step = 0.375f; // kernel radii between values; blocks have three radii, and all edges of cells
constexpr std::int32_t far = 1'000'000'000;
constexpr float frequency = 3;
constexpr float orientation = 0.7f;
constexpr std::uint32_t seed = 7;

float column(std::size_t i) {
    return static_cast<float>(i % Golden::side);
}

float row(std::size_t i) {
    return static_cast<float>(i / Golden::side);
}

// Around the origin.
test::Sample near_sample(const noise::Recipe& recipe, std::size_t i) {
    const float x = (column(i) - 3.5f) * step;
    const float y = (row(i) - 3.5f) * step;
    test::Sample sample{noise::place_at(recipe, 0, 0, x * recipe.radius, y * recipe.radius), frequency,
                        orientation, seed};
    sample.x = x;
    sample.y = y;
    sample.period_x = 2.5f;
    sample.period_y = 3.25f;
    return sample;
}

// By cell in steps as above; by position, where a float has steps of 64.
test::Sample far_sample(const noise::Recipe& recipe, std::size_t i) {
    test::Sample sample{
        noise::place_at(recipe, far, -far, column(i) * step * recipe.radius, row(i) * step * recipe.radius),
        frequency, orientation, seed};
    sample.x = static_cast<float>(far) + 64 * column(i);
    sample.y = -static_cast<float>(far) - 64 * row(i);
    sample.period_x = 1024;
    sample.period_y = 2048;
    return sample;
}

template <typename Sampler, typename MakeSample>
auto ask(Sampler& sampler, const MakeSample& make_sample) {
    for (std::size_t i = 0; i < count; ++i)
        sampler.samples()[i] = make_sample(i);
    return sampler.answers(count);
}

} // namespace

TEST_CASE("words of impulses are those of this version", "[golden]") {
    const vulkan::Device device;
    test::Sampler sampler(device, noise::find_recipe("one"), count);
    Golden golden("words");
    for (const std::int32_t base : {-4, far}) {
        for (const std::uint32_t of : {0u, 7u, 4294967295u}) {
            for (const std::uint32_t index : {0u, 1u, 2u}) {
                const auto answers = ask(sampler, [&](std::size_t i) {
                    const auto cell = [&](float k) { return base + static_cast<std::int32_t>(k); };
                    test::Sample sample{
                        noise::place_at(noise::find_recipe("one"), cell(column(i)), cell(row(i)), 0, 0),
                        frequency, orientation, of, index};
                    return sample;
                });
                golden.block(fmt::format("from cell {}, seed {}, impulse {}", base, of, index), 0,
                             [&](std::size_t i) { return answers[i].word; });
            }
        }
    }
    golden.finish();
}

TEST_CASE("values of every function are those of this version", "[golden]") {
    const vulkan::Device device;
    Golden golden("noise");
    const double tight = tolerance(frequency);
    const double loose = slope_tolerance(frequency);
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        test::Sampler sampler(device, recipe, count);
        for (const bool away : {false, true}) {
            // Still, then in time and with periods.
            for (const bool moving : {false, true}) {
                const auto answers = ask(sampler, [&](std::size_t i) {
                    test::Sample sample = away ? far_sample(recipe, i) : near_sample(recipe, i);
                    if (moving) {
                        sample.place.time = 0.3f;
                        sample.place.period_x = 3;
                        sample.place.period_y = 5;
                        sample.place.radius_x *= 0.75f;
                    }
                    return sample;
                });
                const auto block = [&](std::string_view name, double within, const auto& value) {
                    golden.block(fmt::format("{}, {}: {}", recipe.name, away ? "far" : "near", name), within,
                                 [&](std::size_t i) { return value(answers[i]); });
                };
                using Answer = test::Answer;
                if (moving) {
                    block("gabor_noise_animated", tight, [](const Answer& a) { return a.animated; });
                    block("gabor_field with periods in time", tight,
                          [](const Answer& a) { return a.value[1]; });
                    block("its slope along x", loose, [](const Answer& a) { return a.slope_x[1]; });
                    block("its slope along y", loose, [](const Answer& a) { return a.slope_y[1]; });
                    continue;
                }
                block("gabor_noise", tight, [](const Answer& a) { return a.noise; });
                block("gabor_noise_gradient, the noise", tight,
                      [](const Answer& a) { return a.gradient[0]; });
                block("gabor_noise_gradient, along x", loose, [](const Answer& a) { return a.gradient[1]; });
                block("gabor_noise_gradient, along y", loose, [](const Answer& a) { return a.gradient[2]; });
                block("gabor_noise_complex, real", tight, [](const Answer& a) { return a.complex[0]; });
                block("gabor_noise_complex, imaginary", tight, [](const Answer& a) { return a.complex[1]; });
                block("gabor_noise_tiled", tight, [](const Answer& a) { return a.tiled; });
                block("gabor_noise_at", tight, [](const Answer& a) { return a.at; });
                block("gabor_unorm", tight, [](const Answer& a) { return a.unorm; });
                block("gabor_phasor, phase", 1e-4, [](const Answer& a) { return a.phasor[0]; });
                block("gabor_phasor, intensity", tight, [](const Answer& a) { return a.phasor[1]; });
            }
        }
    }
    golden.finish();
}
