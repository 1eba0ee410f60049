// As test_golden.cpp, of the noise in space and on surfaces.

#include "golden.hpp"
#include "sampler_3d.hpp"

#include <catch2/catch.hpp>

using namespace gabor;
using test::Golden;

TEST_CASE("values of every function in space are those of this version", "[golden]") {
    const vulkan::Device device;
    Golden golden("space");
    constexpr std::size_t count = Golden::side * Golden::side;
    constexpr float frequency = 3;
    const double tight = 1e-5;
    const double loose = test::slope_tolerance(frequency);
    test::Sampler3d sampler(device, noise::recipe_3d(), count);
    for (const bool away : {false, true}) {
        for (std::size_t i = 0; i < count; ++i) {
            const float column = static_cast<float>(i % Golden::side);
            const float row = static_cast<float>(i / Golden::side);
            test::Sample3d& sample = sampler.samples()[i];
            sample = {};
            if (away)
                sample.place.cell = {1'000'000'000, -1'000'000'000, 3};
            sample.place.local = {(column - 3.5f) * 0.375f, (row - 3.5f) * 0.375f, 0.4f};
            sample.position = sample.place.local; // R is 1
            sample.place.time = 0.3f;
            sample.frequency = frequency;
            sample.direction = {1, 0.5f, -2};
            sample.normal = {0.5f, -1, 0.25f};
            sample.tile = {2.5f, 3.25f, 4};
            sample.seed = 7;
        }
        const auto answers = sampler.answers(count);
        const auto block = [&](std::string_view name, double within, const auto& value) {
            golden.block(fmt::format("{}: {}", away ? "far" : "near", name), within,
                         [&](std::size_t i) { return value(answers[i]); });
        };
        using Answer = test::Answer3d;
        block("gabor_field_3d", tight, [](const Answer& a) { return a.value[1]; });
        for (std::size_t axis = 0; axis < 3; ++axis)
            block(fmt::format("gabor_field_3d, slope {}", axis), loose,
                  [&](const Answer& a) { return a.slope[axis][1]; });
        block("gabor_noise_3d_at", tight, [](const Answer& a) { return a.at; });
        if (away) // by position a float has steps of 64 there
            continue;
        block("gabor_noise_3d", tight, [](const Answer& a) { return a.noise; });
        block("gabor_noise_3d_isotropic", tight, [](const Answer& a) { return a.isotropic; });
        for (std::size_t c = 0; c < 4; ++c)
            block(fmt::format("gabor_noise_3d_gradient, {}", c), c ? loose : tight,
                  [&](const Answer& a) { return a.gradient[c]; });
        block("gabor_noise_3d_complex, real", tight, [](const Answer& a) { return a.complex[0]; });
        block("gabor_noise_3d_complex, imaginary", tight, [](const Answer& a) { return a.complex[1]; });
        block("gabor_noise_3d_tiled", tight, [](const Answer& a) { return a.tiled; });
        block("gabor_noise_3d_animated", tight, [](const Answer& a) { return a.animated; });
        block("gabor_noise_surface", 8 * tight, [](const Answer& a) { return a.surface; });
        block("gabor_noise_surface_isotropic", 8 * tight,
              [](const Answer& a) { return a.surface_isotropic; });
    }
    golden.finish();
}
