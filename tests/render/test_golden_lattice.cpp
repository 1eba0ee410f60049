// As test_golden.cpp, for the lattice noise with 2, 3 and 4 taps, and in space.

#include "golden.hpp"
#include "lattice_sampler.hpp"
#include "sampler_lattice_3d.hpp"

#include <catch2/catch.hpp>

using namespace gabor;
using test::Golden;
using test::LatticeAnswer;
using test::LatticeSample;

TEST_CASE("values of the lattice noise are those of this version", "[golden]") {
    constexpr std::size_t count = Golden::side * Golden::side;
    constexpr double tight = 2e-5;
    constexpr double loose = tight * 25; // derivatives
    const vulkan::Device device;
    Golden golden("lattice");
    for (const int taps : {2, 3, 4}) {
        test::LatticeSampler sampler(device, taps, count);
        for (const bool away : {false, true}) {
            for (std::size_t i = 0; i < count; ++i) {
                const float x = 0.375f * (static_cast<float>(i % Golden::side) - 3.5f);
                const float y = 0.375f * (static_cast<float>(i / Golden::side) - 3.5f);
                const float radius = 0.5f * static_cast<float>(taps);
                LatticeSample s{};
                s.cell[0] = away ? 1'000'000'000 : 0;
                s.cell[1] = -s.cell[0];
                s.local[0] = x * radius;
                s.local[1] = y * radius;
                s.p[0] = away ? 64 * x : x;
                s.p[1] = away ? 64 * y : y;
                s.radius[0] = s.radius[1] = radius;
                s.time = 0.3f;
                s.frequency = 3;
                s.orientation = 0.7f;
                s.seed = 7;
                s.tile[0] = 2.5f;
                s.tile[1] = 3.25f;
                sampler.samples()[i] = s;
            }
            const auto answers = sampler.answers(count);
            const auto block = [&](std::string_view name, double within, const auto& value) {
                golden.block(fmt::format("{} taps, {}: {}", taps, away ? "far" : "near", name), within,
                             [&](std::size_t i) { return value(answers[i]); });
            };
            block("word", 0, [](const LatticeAnswer& a) { return a.word; });
            block("gabor_noise", tight, [](const LatticeAnswer& a) { return a.noise; });
            block("gabor_noise_gradient, along x", loose,
                  [](const LatticeAnswer& a) { return a.gradient[0]; });
            block("gabor_noise_gradient, along y", loose,
                  [](const LatticeAnswer& a) { return a.gradient[1]; });
            block("gabor_noise_complex, real", tight, [](const LatticeAnswer& a) { return a.complex[0]; });
            block("gabor_noise_tiled", tight, [](const LatticeAnswer& a) { return a.tiled; });
            block("gabor_noise_animated", tight, [](const LatticeAnswer& a) { return a.animated; });
            block("gabor_noise_at", tight, [](const LatticeAnswer& a) { return a.at; });
            block("gabor_unorm", tight, [](const LatticeAnswer& a) { return a.unorm; });
            block("gabor_phasor, phase", 1e-4, [](const LatticeAnswer& a) { return a.phasor[0]; });
            block("gabor_phasor, intensity", tight, [](const LatticeAnswer& a) { return a.phasor[1]; });
            for (std::size_t c = 0; c < 4; ++c)
                block(fmt::format("gabor_noise_four, {}", c), tight,
                      [c](const LatticeAnswer& a) { return a.four[c]; });
        }
    }
    golden.finish();
}

TEST_CASE("values of the noise on the lattice in space are those of this version", "[golden]") {
    constexpr std::size_t count = Golden::side * Golden::side;
    constexpr double tight = 5e-5;
    constexpr double loose = tight * 25; // derivatives
    struct Function {
        const char* name;
        test::Entry3d entry;
        std::vector<double> tolerances; // of what it answers
    };
    const vulkan::Device device;
    Golden golden("lattice_3d");
    for (const auto& [name, entry, tolerances] :
         {Function{"gabor_noise_3d_gradient", test::Entry3d::gradient, {tight, loose, loose, loose}},
          Function{"gabor_noise_3d_tiled", test::Entry3d::tiled, {tight}},
          Function{"gabor_noise_3d_filtered", test::Entry3d::filtered, {tight, tight}},
          Function{"gabor_noise_surface", test::Entry3d::noise_surface, {tight}}}) {
        test::LatticeSampler3d sampler(device, count, entry);
        for (std::size_t i = 0; i < count; ++i) {
            const float x = 0.375f * (static_cast<float>(i % Golden::side) - 3.5f);
            const float y = 0.375f * (static_cast<float>(i / Golden::side) - 3.5f);
            test::LatticeSample3d s;
            s.p = {x, y, 0.5f * x - 0.25f * y};
            s.place.time = 0.3f;
            s.frequency = 1.5f;
            s.direction = {0.6f, -0.5f, 0.3f};
            s.normal = {x, 0.4f, y};
            s.dx = {0.2f, 0, 0.05f};
            s.dy = {0, 0.1f, 0.1f};
            s.tile = {2.5f, 3.25f, 4};
            s.seed = 7;
            sampler.samples()[i] = s;
        }
        const auto answers = sampler.answers(count);
        for (std::size_t c = 0; c < tolerances.size(); ++c)
            golden.block(fmt::format("{}, {}", name, c), tolerances[c],
                         [&](std::size_t i) { return answers[i].value[c]; });
    }
    golden.finish();
}
