// The law of the noise in space over independent instances: one value at a random place of each.

#include "sampler_3d.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <random>

using namespace gabor;
using test::Kind;

namespace {

constexpr std::size_t per_batch = 1 << 19;

struct Law {
    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
};

class Uniform {
  public:
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    std::int32_t cell() { return static_cast<std::int32_t>(random_()); }
    float place() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }

  private:
    std::mt19937 random_{3};
};

Law measure(test::Sampler3d& sampler, const noise::Recipe& recipe, Kind kind, float frequency, int batches) {
    Uniform draw;
    Law law;
    for (int batch = 0; batch < batches; ++batch) {
        for (test::Sample3d& sample : sampler.samples()) {
            sample.place.cell = {draw.cell(), draw.cell(), draw.cell()};
            sample.place.local = {draw.place(), draw.place(), draw.place()};
            sample.place.radius.fill(recipe.radius);
            sample.frequency = frequency;
            sample.direction = {0.6f, 0.48f, 0.64f};
            sample.normal = {0.3f, -0.8f, 0.2f};
            sample.seed = draw.word();
            sample.kind = kind;
        }
        for (const test::Answer3d& answer : sampler.answers(per_batch, false)) {
            law.moments.add(answer.at);
            law.gaussianity.add(answer.at);
        }
    }
    return law;
}

} // namespace

TEST_CASE("in space mean 0 and variance 1 at every frequency", "[instances]") {
    const vulkan::Device device;
    test::Sampler3d sampler(device, noise::recipe_3d(), per_batch);
    for (const Kind kind : {Kind::oriented, Kind::isotropic, Kind::surface, Kind::surface_isotropic}) {
        for (const float frequency : {0.002f, 0.7f, 30.0f}) {
            const Law law = measure(sampler, noise::recipe_3d(), kind, frequency, 8);
            fmt::print("kind {}, frequency {}: mean {:.5f}, variance {:.5f}\n", static_cast<int>(kind),
                       frequency, law.moments.mean(), law.moments.variance());
            CHECK(law.moments.mean() == Approx(0).margin(0.002)); // four standard errors
            CHECK(law.moments.variance() == Approx(1).margin(0.003));
        }
    }
}

TEST_CASE("Gaussianity of the recipes in space", "[instances]") {
    const vulkan::Device device;
    struct Expected {
        noise::Recipe recipe;
        double kurtosis;
    };
    for (const auto& [recipe, kurtosis] :
         {Expected{noise::recipe_3d(), 0.063}, Expected{noise::pure_recipe_3d(), -0.002}}) {
        test::Sampler3d sampler(device, recipe, per_batch);
        const Law law = measure(sampler, recipe, Kind::oriented, 4, 16);
        const statistics::Estimate cvm = law.gaussianity.index();
        fmt::print("{}: variance {:.5f}, excess kurtosis {:.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n", recipe.name,
                   law.moments.variance(), law.moments.excess_kurtosis(), cvm.value, cvm.low, cvm.high);
        CHECK(law.moments.variance() == Approx(1).margin(0.002));
        CHECK(law.moments.excess_kurtosis() == Approx(kurtosis).margin(0.007));
        CHECK(cvm.high < 0.5);
    }
}
