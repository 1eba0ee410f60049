// The distribution of the lattice noise on the device over independent instances: normal at each place and
// jointly. GABOR_LAW_SAMPLES sets the number of samples per statistic.

#include "lattice_sampler.hpp"
#include "law.hpp"
#include "reference/normal_mean.hpp"
#include "statistics/estimate.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

using namespace gabor;
using std::numbers::pi;
using test::Figure;
using test::LatticeSample;

namespace {

constexpr std::size_t per_batch = 1 << 18;
constexpr float frequency = 1.5;
constexpr float orientation = 0.4f;

int batches() {
    return static_cast<int>(std::ceil(test::law_samples() / per_batch));
}

using All = std::map<std::string, Figure>;

float uniform(std::mt19937& random) {
    return static_cast<float>(random() >> 8) * 0x1p-24f;
}

LatticeSample draw_instance(std::mt19937& random) {
    LatticeSample s{};
    s.local[0] = s.p[0] = 1000 * uniform(random);
    s.local[1] = s.p[1] = 1000 * uniform(random);
    s.radius[0] = s.radius[1] = 1.5f;
    s.frequency = frequency;
    s.orientation = orientation;
    s.time = uniform(random);
    s.tile[0] = 0.3f + 4 * uniform(random);
    s.tile[1] = 0.3f + 4 * uniform(random);
    s.seed = static_cast<std::uint32_t>(random());
    return s;
}

struct Waves {
    float frequency;
    float orientation;
    bool tiled;
};

LatticeSample draw_at(const std::vector<float>& local, int taps, const Waves& waves, std::mt19937& random) {
    LatticeSample s = draw_instance(random);
    s.frequency = waves.frequency;
    s.orientation = waves.orientation;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        s.cell[axis] = static_cast<std::int32_t>(random());
        s.local[axis] = local[axis];
        const auto least = static_cast<float>(taps);
        const float nodes = std::max(std::floor(s.tile[axis] * 0.5f * least + 0.5f), least);
        s.p[axis] = (std::floor(nodes * uniform(random)) + s.local[axis]) * s.tile[axis] / nodes;
    }
    return s;
}

} // namespace

TEST_CASE("the lattice noise has its law at each of 16 x 16 places of a cell", "[law]") {
    const vulkan::Device device;
    const int rounds = (batches() + 7) / 8; // batches for each wave
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        std::mt19937 random(8);
        const auto places = test::places_of_cell(16, 2);
        const std::size_t per_place = per_batch / places.size();
        test::Laws all(places);
        fmt::print("{} taps on {}\n", taps, device.info().name);
        for (const Waves& waves : {Waves{4, 0, false},
                                   {4, 0.4f, false},
                                   {4, 0.785398f, false},
                                   {4, 1.1f, false},
                                   {0, 0.4f, false},
                                   {0.05f, 0.4f, false},
                                   {0.7f, 0.4f, false},
                                   {30, 0.4f, false},
                                   {1.5f, 0.4f, true}}) {
            test::Laws laws(places);
            for (int round = 0; round < rounds; ++round) {
                for (std::size_t i = 0; i < per_batch; ++i)
                    sampler.samples()[i] = draw_at(places[i / per_place], taps, waves, random);
                const auto answers =
                    sampler.answers(per_batch, waves.tiled ? test::Wanted::moving : test::Wanted::at);
                for (std::size_t i = 0; i < per_batch; ++i)
                    laws.add(i / per_place, waves.tiled ? answers[i].tiled : answers[i].at);
            }
            laws.check(fmt::format("frequency {:<4} orientation {:.2f}{}", waves.frequency, waves.orientation,
                                   waves.tiled ? ", tiles" : ""));
            all.merge(laws);
        }
        all.check("all waves");
    }
}

TEST_CASE("the lattice noise, its gradient, quadrature, phasor and four are jointly normal", "[law]") {
    const vulkan::Device device;
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        std::mt19937 random(9);
        All all;
        for (int batch = 0; batch < batches(); ++batch) {
            for (LatticeSample& sample : sampler.samples())
                sample = draw_instance(random);
            for (const test::LatticeAnswer& a : sampler.answers(per_batch, test::Wanted::four)) {
                all["noise"].add(a.complex[1]);
                all["quadrature"].add(a.complex[0]);
                all["noise + quadrature"].add((a.complex[0] + a.complex[1]) / std::numbers::sqrt2);
                // E[n_x^2] = (2 pi F_x)^2 + sum h'^2 / sum h^2, and the latter is pi^2 / 3.
                const double wave = 2 * pi * frequency;
                const double x = std::hypot(wave * std::cos(orientation), pi / std::sqrt(3));
                const double y = std::hypot(wave * std::sin(orientation), pi / std::sqrt(3));
                all["d/dx"].add(a.gradient[0] / x);
                all["d/dy"].add(a.gradient[1] / y);
                const double phase = std::clamp<double>(a.phasor[0], 1e-9, 1 - 1e-9);
                all["phase, made normal"].add(statistics::normal_quantile(phase));
                all["intensity, made normal"].add(-statistics::normal_quantile(
                    std::clamp(std::exp(-0.5 * a.phasor[1] * a.phasor[1]), 1e-9, 1 - 1e-9)));
                all["four, first + second"].add((a.four[0] + a.four[1]) / std::numbers::sqrt2);
                all["four, third - fourth"].add((a.four[2] - a.four[3]) / std::numbers::sqrt2);
                all["four, the sum"].add((a.four[0] + a.four[1] + a.four[2] + a.four[3]) / 2);
            }
        }
        fmt::print("{} taps on {}\n", taps, device.info().name);
        for (const auto& [name, figure] : all)
            figure.check(name);
    }
}

TEST_CASE("tiles and every time of the lattice noise have its law", "[law]") {
    const vulkan::Device device;
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        std::mt19937 random(10);
        Figure tiled, animated;
        for (int batch = 0; batch < batches(); ++batch) {
            for (LatticeSample& sample : sampler.samples())
                sample = draw_instance(random);
            for (const test::LatticeAnswer& a : sampler.answers(per_batch, test::Wanted::moving)) {
                tiled.add(a.tiled);
                animated.add(a.animated);
            }
        }
        fmt::print("{} taps on {}\n", taps, device.info().name);
        tiled.check("tiles of any period");
        animated.check("at any time");
    }
}

TEST_CASE("pairs of values of the lattice noise are jointly normal", "[law]") {
    const vulkan::Device device;
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        std::mt19937 random(11);
        fmt::print("{} taps on {}\n", taps, device.info().name);
        for (int lag = 0; lag < 10; ++lag) {
            const double angle = 0.7 * lag;
            const double x = 0.08 * (lag + 1) * std::cos(angle);
            const double y = 0.08 * (lag + 1) * std::sin(angle);
            const double turns = frequency * (x * std::cos(orientation) + y * std::sin(orientation));
            const double correlation =
                noise::hann_correlation(x) * noise::hann_correlation(y) * std::cos(2 * pi * turns);
            Figure sum(std::sqrt(2 + 2 * correlation)), difference(std::sqrt(2 - 2 * correlation));
            for (int batch = 0; batch < (batches() + 1) / 2; ++batch) {
                const auto samples = sampler.samples();
                for (std::size_t i = 0; i < per_batch; i += 2) {
                    samples[i] = samples[i + 1] = draw_instance(random);
                    samples[i + 1].local[0] += static_cast<float>(x * taps / 2);
                    samples[i + 1].local[1] += static_cast<float>(y * taps / 2);
                }
                const auto answers = sampler.answers(per_batch, test::Wanted::at);
                for (std::size_t i = 0; i < per_batch; i += 2) {
                    sum.add(answers[i].at + answers[i + 1].at);
                    difference.add(answers[i].at - answers[i + 1].at);
                }
            }
            sum.check(fmt::format("sum at ({:.2f}, {:.2f})", x, y));
            difference.check("difference");
        }
    }
}

TEST_CASE("the lattice noise at two times is jointly normal, its correlation cos^2(pi lag)", "[law]") {
    const vulkan::Device device;
    test::LatticeSampler sampler(device, 3, per_batch);
    std::mt19937 random(12);
    for (const float lag : {0.05f, 0.16f, 0.25f, 0.5f}) {
        const double correlation = std::pow(std::cos(pi * lag), 2);
        Figure sum(std::sqrt(2 + 2 * correlation)), difference(std::sqrt(2 - 2 * correlation));
        const auto samples = sampler.samples();
        for (std::size_t i = 0; i < per_batch; i += 2) {
            samples[i] = samples[i + 1] = draw_instance(random);
            samples[i + 1].time += lag;
        }
        const auto answers = sampler.answers(per_batch, test::Wanted::moving);
        for (std::size_t i = 0; i < per_batch; i += 2) {
            sum.add(answers[i].animated + answers[i + 1].animated);
            difference.add(answers[i].animated - answers[i + 1].animated);
        }
        sum.check(fmt::format("lag {}: sum", lag));
        difference.check("difference");
    }
}
