// The law of the lattice noise on the device: normal at places and together, over independent instances.
// GABOR_LAW_SAMPLES says how many samples each figure has.

#include "lattice_sampler.hpp"
#include "statistics/estimate.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>

using namespace gabor;
using std::numbers::pi;
using test::LatticeSample;

namespace {

constexpr std::size_t per_batch = 1 << 18;
constexpr float frequency = 1.5;
constexpr float orientation = 0.4f;

int batches() {
    const char* text = std::getenv("GABOR_LAW_SAMPLES");
    const double samples = text ? std::strtod(text, nullptr) : 1 << 21;
    return static_cast<int>(std::ceil(samples / per_batch));
}

// Random numbers that are gathered first, so that their deviation need not be known, then compared with the
// normal law.
class Gathered {
  public:
    void add(double value) {
        moments_.add(value);
        values_.push_back(static_cast<float>(value));
    }

    void check(const std::string& name, double deviation = 0) const {
        statistics::Gaussianity gaussianity(deviation == 0 ? std::sqrt(moments_.variance()) : deviation);
        gaussianity.add(values_);
        const statistics::Estimate cvm = gaussianity.index();
        const double n = static_cast<double>(values_.size());
        fmt::print(
            "  {:<34} mean {:8.5f}, variance {:.5f}, excess kurtosis {:7.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n",
            name, moments_.mean(), moments_.variance(), moments_.excess_kurtosis(), cvm.value, cvm.low,
            cvm.high);
        INFO(name);
        CHECK(std::abs(moments_.mean()) < 5 * std::sqrt(moments_.variance() / n));
        if (deviation > 0)
            CHECK(std::abs(moments_.variance() / (deviation * deviation) - 1) < 5 * std::sqrt(2 / n));
        CHECK(cvm.low < 0.05);
    }

  private:
    statistics::Moments moments_;
    std::vector<float> values_;
};

using All = std::map<std::string, Gathered>;

LatticeSample draw_instance(std::mt19937& random) {
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    LatticeSample s{};
    s.local[0] = s.p[0] = 1000 * uniform();
    s.local[1] = s.p[1] = 1000 * uniform();
    s.radius[0] = s.radius[1] = 1.5f;
    s.frequency = frequency;
    s.orientation = orientation;
    s.time = uniform();
    s.tile[0] = 0.3f + 4 * uniform();
    s.tile[1] = 0.3f + 4 * uniform();
    s.seed = static_cast<std::uint32_t>(random());
    return s;
}

} // namespace

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
        for (const auto& [name, gathered] : all)
            gathered.check(name, 1);
    }
}

TEST_CASE("tiles and every time of the lattice noise have its law", "[law]") {
    const vulkan::Device device;
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        std::mt19937 random(10);
        Gathered tiled, animated;
        for (int batch = 0; batch < batches(); ++batch) {
            for (LatticeSample& sample : sampler.samples())
                sample = draw_instance(random);
            for (const test::LatticeAnswer& a : sampler.answers(per_batch, test::Wanted::moving)) {
                tiled.add(a.tiled);
                animated.add(a.animated);
            }
        }
        fmt::print("{} taps on {}\n", taps, device.info().name);
        tiled.check("tiles of any period", 1);
        animated.check("at any time", 1);
    }
}

TEST_CASE("pairs of values of the lattice noise are jointly normal", "[law]") {
    const vulkan::Device device;
    test::LatticeSampler sampler(device, 3, per_batch);
    std::mt19937 random(11);
    for (int lag = 0; lag < 10; ++lag) {
        const double angle = 0.7 * lag;
        const double distance = 0.08 * (lag + 1);
        Gathered sum, difference;
        for (int batch = 0; batch < (batches() + 1) / 2; ++batch) {
            const auto samples = sampler.samples();
            for (std::size_t i = 0; i < per_batch; i += 2) {
                samples[i] = samples[i + 1] = draw_instance(random);
                samples[i + 1].local[0] += static_cast<float>(distance * std::cos(angle) * 1.5);
                samples[i + 1].local[1] += static_cast<float>(distance * std::sin(angle) * 1.5);
            }
            const auto answers = sampler.answers(per_batch, test::Wanted::at);
            for (std::size_t i = 0; i < per_batch; i += 2) {
                sum.add(answers[i].at + answers[i + 1].at);
                difference.add(answers[i].at - answers[i + 1].at);
            }
        }
        sum.check(
            fmt::format("sum at ({:.2f}, {:.2f})", distance * std::cos(angle), distance * std::sin(angle)));
        difference.check("difference");
    }
}

TEST_CASE("the lattice noise at two times is jointly normal, its correlation cos^2(pi lag)", "[law]") {
    const vulkan::Device device;
    test::LatticeSampler sampler(device, 3, per_batch);
    std::mt19937 random(12);
    for (const float lag : {0.05f, 0.16f, 0.25f, 0.5f}) {
        Gathered sum, difference;
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
        const double correlation = std::pow(std::cos(pi * lag), 2);
        sum.check(fmt::format("lag {}: sum", lag), std::sqrt(2 + 2 * correlation));
        difference.check("difference", std::sqrt(2 - 2 * correlation));
    }
}
