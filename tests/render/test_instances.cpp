// The distribution of the noise: one value at a random place of each of many independent instances.

#include "sampler.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace gabor;

namespace {

struct Law {
    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
};

Law measure(const vulkan::Device& device, const noise::Recipe& recipe, float frequency, float orientation,
            int batches) {
    constexpr std::size_t per_batch = 1 << 20;
    test::Sampler sampler(device, recipe, per_batch);
    std::mt19937 random(3);
    Law law;
    for (int batch = 0; batch < batches; ++batch) {
        for (test::Sample& sample : sampler.samples()) {
            const auto place = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
            const auto cell = [&] { return static_cast<std::int32_t>(random()); };
            sample = {noise::place_at(recipe, cell(), cell(), place(), place()), frequency, orientation,
                      static_cast<std::uint32_t>(random())};
        }
        for (const test::Answer& answer : sampler.answers(per_batch, test::Wanted::at)) {
            law.moments.add(answer.at);
            law.gaussianity.add(answer.at);
        }
    }
    return law;
}

} // namespace

TEST_CASE("mean 0 and variance 1 at every frequency", "[instances]") {
    const vulkan::Device device;
    const std::vector<float> low_and_high{0.002f, 30}; // with many phases nothing depends on the frequency
    for (const auto& [name, frequencies] : {std::pair("one", low_and_high),
                                            {"pure", low_and_high},
                                            {"paper", {0.002f, 0.1f, 0.7f, 1.5f, 30}}}) {
        for (const float frequency : frequencies) {
            const Law law = measure(device, noise::find_recipe(name), frequency, 0.3f, 9);
            INFO(name << ", frequency " << frequency);
            CHECK(law.moments.mean() == Approx(0).margin(0.0015));
            CHECK(law.moments.variance() == Approx(1).margin(0.002)); // four standard errors
        }
    }
}

TEST_CASE("Gaussianity of the recipes", "[instances]") {
    const vulkan::Device device;
    struct Expected {
        const char* recipe;
        double cvm;
    };
    // `one`, `pure`: from the characteristic function by quadrature. `paper`: 2^18 (kurtosis / 24)^2 0.1429
    // with the exact excess kurtosis -0.0325 (Campbell's theorem with the effect of stratification, by
    // quadrature).
    for (const auto& [name, expected] :
         {Expected{"one", 0.01}, Expected{"pure", 0.007}, Expected{"paper", 0.07}}) {
        const Law law = measure(device, noise::find_recipe(name), 4, 0.3f, 16);
        const statistics::Estimate cvm = law.gaussianity.index();
        fmt::print("{}: variance {:.5f}, excess kurtosis {:.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n", name,
                   law.moments.variance(), law.moments.excess_kurtosis(), cvm.value, cvm.low, cvm.high);
        CHECK(law.moments.variance() == Approx(1).margin(0.002));
        CHECK(law.moments.mean() == Approx(0).margin(0.0015));
        CHECK(std::abs(cvm.value - expected) < cvm.high - cvm.low); // four standard errors
        CHECK(cvm.high - cvm.low < 0.06);
    }
}

TEST_CASE("mean 0 and variance 1 with periods, in time, and of the quadrature", "[instances]") {
    const vulkan::Device device;
    constexpr std::size_t per_batch = 1 << 20;
    for (const noise::Recipe& recipe : noise::sparse_recipes()) {
        for (const float frequency : {0.25f, 3.0f}) {
            test::Sampler sampler(device, recipe, per_batch);
            std::mt19937 random(4);
            statistics::Moments tiled, animated, quadrature;
            for (int batch = 0; batch < 4; ++batch) {
                for (test::Sample& sample : sampler.samples()) {
                    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
                    sample = {noise::place_at(recipe, 0, 0, 8 * uniform(), 8 * uniform()), frequency, 0.3f,
                              static_cast<std::uint32_t>(random())};
                    sample.place.time = 0.13f;
                    sample.period_x = 2 + 2 * uniform();
                    sample.period_y = 2 + 2 * uniform();
                }
                for (const test::Answer& answer : sampler.answers(per_batch, test::Wanted::moving)) {
                    tiled.add(answer.tiled);
                    animated.add(answer.animated);
                    quadrature.add(answer.complex[0]);
                }
            }
            std::vector<statistics::Moments> all{tiled, animated};
            if (recipe.phases > 2 ||
                frequency > 1.5f) // at low frequency the quadrature of a sine kernel exceeds the sine
                all.push_back(quadrature);
            for (const statistics::Moments& moments : all) {
                INFO(recipe.name << ", frequency " << frequency);
                CHECK(moments.mean() == Approx(0).margin(0.002)); // four standard errors
                CHECK(moments.variance() == Approx(1).margin(0.003));
            }
        }
    }
}
