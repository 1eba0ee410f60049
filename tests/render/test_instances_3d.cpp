// The law of the noise in space over independent instances: one value at a random place of each.

#include "sampler_3d.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
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
        for (const test::Answer3d& answer : sampler.answers(per_batch, test::Wanted::at)) {
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
            if (kind != Kind::oriented && frequency != 0.7f)
                continue;
            const Law law = measure(sampler, noise::recipe_3d(), kind, frequency, 6);
            fmt::print("kind {}, frequency {}: mean {:.5f}, variance {:.5f}\n", static_cast<int>(kind),
                       frequency, law.moments.mean(), law.moments.variance());
            CHECK(law.moments.mean() == Approx(0).margin(0.002)); // nearly four standard errors
            CHECK(law.moments.variance() == Approx(1).margin(0.003));
        }
    }
}

TEST_CASE("Gaussianity of the recipes in space", "[instances]") {
    const vulkan::Device device;
    struct Expected {
        noise::Recipe recipe;
        Kind kind;
        double kurtosis;
    };
    // By quadrature over the window, the cells and the weights.
    for (const auto& [recipe, kind, kurtosis] : {Expected{noise::recipe_3d(), Kind::oriented, 0.048},
                                                 Expected{noise::recipe_3d(), Kind::surface_isotropic, 0.064},
                                                 Expected{noise::pure_recipe_3d(), Kind::oriented, -0.002}}) {
        test::Sampler3d sampler(device, recipe, per_batch);
        const Law law = measure(sampler, recipe, kind, 4, 16);
        const statistics::Estimate cvm = law.gaussianity.index();
        fmt::print("{}, kind {}: variance {:.5f}, excess kurtosis {:.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n",
                   recipe.name, static_cast<int>(kind), law.moments.variance(), law.moments.excess_kurtosis(),
                   cvm.value, cvm.low, cvm.high);
        CHECK(law.moments.variance() == Approx(1).margin(0.002));
        CHECK(law.moments.excess_kurtosis() == Approx(kurtosis).margin(0.007));
        CHECK(cvm.high < 0.5);
    }
}

TEST_CASE("in space the variance is 1 at each place of a cell", "[instances]") {
    const vulkan::Device device;
    test::Sampler3d sampler(device, noise::recipe_3d(), per_batch);
    Uniform draw;
    for (const std::array<float, 3>& place :
         {std::array{0.0f, 0.0f, 0.0f}, std::array{0.5f, 0.5f, 0.5f}, std::array{0.25f, 0.5f, 0.0f}}) {
        statistics::Moments moments;
        for (int batch = 0; batch < 4; ++batch) {
            for (test::Sample3d& sample : sampler.samples()) {
                sample = {};
                sample.place.cell = {draw.cell(), draw.cell(), draw.cell()};
                sample.place.local = place;
                sample.seed = draw.word();
                sample.kind = Kind::surface_isotropic;
            }
            for (const test::Answer3d& answer : sampler.answers(per_batch, test::Wanted::at))
                moments.add(answer.at);
        }
        INFO("at " << place[0] << ", " << place[1] << ", " << place[2]);
        CHECK(moments.mean() == Approx(0).margin(0.003)); // four standard errors
        CHECK(moments.variance() == Approx(1).margin(0.004));
    }
}

TEST_CASE("directions of impulses are uniform on the sphere, whatever their place and phase", "[instances]") {
    constexpr int count = 1 << 21;
    Uniform draw;
    double first[3]{}, second[3][3]{}, fourth[3]{}, with_place[3][3]{}, with_phase[3][3][2]{};
    for (int i = 0; i < count; ++i) {
        const noise::Impulse3d impulse(
            noise::impulse_word_3d({draw.cell(), draw.cell(), draw.cell()}, 0, draw.word()));
        const double turn = 4 * std::numbers::pi * impulse.phase;
        for (std::size_t a = 0; a < 3; ++a) {
            const double s = impulse.direction[a];
            first[a] += s / count;
            fourth[a] += std::pow(s, 4) / count;
            for (std::size_t b = 0; b < 3; ++b) {
                const double product = s * impulse.direction[b];
                second[a][b] += product / count;
                with_place[a][b] += s * (impulse.place[b] - 0.5) / count;
                with_phase[a][b][0] += product * std::cos(turn) / count;
                with_phase[a][b][1] += product * std::sin(turn) / count;
            }
        }
    }
    // Five standard errors; each factor is at most 1.
    const double margin = 5 * std::sqrt(1.0 / 3 / count);
    for (std::size_t a = 0; a < 3; ++a) {
        CHECK(first[a] == Approx(0).margin(margin));
        CHECK(fourth[a] == Approx(0.2).margin(margin));
        for (std::size_t b = 0; b < 3; ++b) {
            CHECK(second[a][b] == Approx(a == b ? 1.0 / 3 : 0).margin(margin));
            CHECK(with_place[a][b] == Approx(0).margin(margin));
            CHECK(with_phase[a][b][0] == Approx(0).margin(margin));
            CHECK(with_phase[a][b][1] == Approx(0).margin(margin));
        }
    }
}

TEST_CASE("isotropic noise is as steep along all axes, and on a surface along all tangents", "[instances]") {
    const vulkan::Device device;
    const noise::Recipe& recipe = noise::recipe_3d();
    test::Sampler3d sampler(device, recipe, per_batch);
    // What the window alone adds to the variance of a slope: integral(q'^2) / integral(q^2), by midpoints.
    double slopes = 0;
    double energy = 0;
    for (int i = 0; i < 2000; ++i) {
        const double x = (i + 0.5) / 1000 - 1;
        const double u = 1 - x * x;
        const auto& c = recipe.window;
        energy += std::pow(u * u * (c[0] + c[1] * u + c[2] * u * u), 2);
        slopes += std::pow(-2 * x * u * (2 * c[0] + 3 * c[1] * u + 4 * c[2] * u * u), 2);
    }
    constexpr double frequency = 1.5;
    const double wave = std::pow(2 * std::numbers::pi * frequency, 2);
    const noise::Vector3 normal = test::unit({0.3f, -0.8f, 0.2f});
    for (const Kind kind : {Kind::isotropic, Kind::surface_isotropic}) {
        Uniform draw;
        double products[3][3]{};
        constexpr int batches = 2;
        for (int batch = 0; batch < batches; ++batch) {
            for (test::Sample3d& sample : sampler.samples()) {
                sample = {};
                sample.place.cell = {draw.cell(), draw.cell(), draw.cell()};
                sample.place.local = {draw.place(), draw.place(), draw.place()};
                sample.frequency = static_cast<float>(frequency);
                sample.normal = {0.3f, -0.8f, 0.2f};
                sample.seed = draw.word();
                sample.kind = kind;
            }
            for (const test::Answer3d& answer : sampler.answers(per_batch))
                for (std::size_t a = 0; a < 3; ++a)
                    for (std::size_t b = 0; b < 3; ++b)
                        products[a][b] +=
                            double{answer.slope[a][1]} * answer.slope[b][1] / batches / per_batch;
        }
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) {
                const double one = a == b ? 1 : 0;
                const double expected =
                    slopes / energy * one +
                    wave * (kind == Kind::isotropic ? one / 3 : 0.5 * (one - normal[a] * normal[b]));
                INFO("kind " << static_cast<int>(kind) << ", axes " << a << " and " << b);
                CHECK(products[a][b] ==
                      Approx(expected).margin(0.005 * wave)); // four standard errors or more
            }
        }
    }
}
