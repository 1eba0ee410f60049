// The law of gabor_lattice_3d.glsl: over independent instances at fixed places, and of its sums by their
// parts.

#include "sampler_lattice_3d.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gabor;
using noise::Lattice3d;
using std::numbers::pi;
using test::Entry3d;
using test::LatticeSample3d;
using test::LatticeSampler3d;
using Vector = Lattice3d::Vector;

namespace {

struct Law {
    explicit Law(double deviation) : gaussianity(deviation) {}

    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
};

// Combinations of an answer's numbers, each with the deviation that theory predicts.
struct Combination {
    std::string name;
    std::vector<double> factors;
    double deviation;
};

// The laws of combinations over instances at one place, each law normal and of the variance predicted.
void check(LatticeSampler3d& sampler, const LatticeSample3d& sample, int batches,
           const std::vector<Combination>& combinations, double largest_index) {
    test::Draw draw(31);
    std::vector<Law> laws;
    for (const Combination& c : combinations)
        laws.emplace_back(c.deviation);
    const std::size_t count = sampler.samples().size();
    for (int batch = 0; batch < batches; ++batch) {
        for (LatticeSample3d& one : sampler.samples()) {
            one = sample;
            one.place.cell = {draw.cell(), draw.cell(), draw.cell()};
            one.seed = draw.word();
        }
        for (const test::LatticeAnswer3d& answer : sampler.answers(count)) {
            for (std::size_t k = 0; k < laws.size(); ++k) {
                double sum = 0;
                for (std::size_t c = 0; c < combinations[k].factors.size(); ++c)
                    sum += combinations[k].factors[c] * answer.value[c];
                laws[k].moments.add(sum);
                laws[k].gaussianity.add(sum);
            }
        }
    }
    const double samples = static_cast<double>(count) * batches;
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const Combination& c = combinations[k];
        const double mean = laws[k].moments.mean() / c.deviation;
        const double variance = laws[k].moments.variance() / (c.deviation * c.deviation);
        const statistics::Estimate index = laws[k].gaussianity.index();
        fmt::print(
            "  {:<28} mean {:+.5f}, variance {:.5f}, excess kurtosis {:+.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n",
            c.name, mean, variance, laws[k].moments.excess_kurtosis(), index.value, index.low, index.high);
        INFO(c.name << " at " << to_string(sample));
        CHECK(mean == Approx(0).margin(4.5 / std::sqrt(samples)));
        CHECK(variance == Approx(1).margin(4.5 * std::sqrt(2 / samples)));
        CHECK(index.value < largest_index + 2.0 * statistics::cvm_scale /
                                                samples); // which chance alone exceeds once in 10^4
    }
}

LatticeSample3d at(const std::array<float, 3>& local, float frequency) {
    LatticeSample3d sample;
    sample.place.local = local;
    sample.frequency = frequency;
    sample.direction = {0.6f, 0.48f, 0.64f};
    return sample;
}

// Both parts of the noise, those of its gradient, and sums of them: jointly normal.
// sum h'^2 = pi^2 / 4 * 3/2 and sum h^2 = 9/8 along an axis, so a slope has the variance pi^2 / 3 + (2 pi
// F)^2.
std::vector<Combination> of_field(const LatticeSample3d& sample) {
    const Vector direction = test::unit(sample.direction);
    const auto slope = [&](std::size_t axis) {
        return std::sqrt(pi * pi / 3 + std::pow(2 * pi * sample.frequency * direction[axis], 2));
    };
    // d/dx of one part and the other part itself covary by 2 pi F_x.
    const double covariance = 2 * pi * sample.frequency * direction[0];
    const double mixed = std::sqrt(1 + 1 + 2 * covariance / slope(0));
    const double slopes = 4 * pi * pi * sample.frequency * sample.frequency * direction[0] * direction[1];
    const double both = std::sqrt(2 + 2 * slopes / (slope(0) * slope(1)));
    return {{"noise", {0, 1}, 1},
            {"quadrature", {1}, 1},
            {"their sum", {1, 1}, std::sqrt(2.0)},
            {"d/dx", {0, 0, 0, 1}, slope(0)},
            {"d/dy", {0, 0, 0, 0, 0, 1}, slope(1)},
            {"d/dz", {0, 0, 0, 0, 0, 0, 0, 1}, slope(2)},
            {"d/dx + d/dy", {0, 0, 0, 1 / slope(0), 0, 1 / slope(1)}, both},
            {"quadrature + d/dx", {1, 0, 0, 1 / slope(0)}, mixed}};
}

Vector random_unit(test::Draw& draw) {
    return test::unit({draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)});
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

const std::array<float, 3> places[] = {{0, 0, 0}, {0.5f, 0.5f, 0.5f}, {0.25f, 0.5f, 0}};

} // namespace

TEST_CASE("noise on the lattice in space is normal at fixed places, with its gradient and quadrature",
          "[law]") {
    const vulkan::Device device;
    LatticeSampler3d sampler(device, 1 << 15, Entry3d::field);
    for (const auto& place : places) {
        const LatticeSample3d sample = at(place, 1);
        fmt::print("at {}\n", place);
        check(sampler, sample, 32, of_field(sample), 0.1);
    }
}

// The covariance of two places along the lattice's axes, from the windows: of the nodes that reach both.
namespace {

double covariance(const LatticeSample3d& sample, const std::array<float, 3>& lag) {
    double product = 1;
    double turns = 0;
    const Vector direction = test::unit(sample.direction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto window = [](double offset) {
            return std::abs(offset) < 1.5 ? (1 + std::cos(pi * offset / 1.5)) / 2 : 0;
        };
        double sum = 0;
        for (double node = -3; node <= 5; ++node)
            sum +=
                window(sample.place.local[axis] - node) * window(sample.place.local[axis] + lag[axis] - node);
        product *= sum / (9.0 / 8);
        turns += sample.frequency * direction[axis] * lag[axis] / 1.5;
    }
    return product * std::cos(2 * pi * turns);
}

} // namespace

TEST_CASE("pairs of places on the lattice in space are jointly normal", "[law]") {
    const vulkan::Device device;
    constexpr std::size_t pairs = 1 << 16;
    LatticeSampler3d sampler(device, 2 * pairs, Entry3d::field);
    test::Draw draw(37);
    for (const std::array<float, 3> lag : {std::array{0.3f, 0.0f, 0.0f}, std::array{0.0f, 0.7f, 0.7f},
                                           std::array{0.5f, -0.5f, 1.0f}, std::array{1.5f, 0.0f, 0.4f}}) {
        const LatticeSample3d first = at(places[draw.word() % 3], 1);
        const double between = covariance(first, lag);
        Law sum(std::sqrt(2 + 2 * between));
        Law difference(std::sqrt(2 - 2 * between));
        for (std::size_t i = 0; i < pairs; ++i) {
            LatticeSample3d one = first;
            one.place.cell = {draw.cell(), draw.cell(), draw.cell()};
            one.seed = draw.word();
            sampler.samples()[2 * i] = one;
            for (std::size_t axis = 0; axis < 3; ++axis)
                one.place.local[axis] += lag[axis];
            sampler.samples()[2 * i + 1] = one;
        }
        const auto answers = sampler.answers(2 * pairs);
        for (std::size_t i = 0; i < pairs; ++i) {
            const double a = answers[2 * i].value[1];
            const double b = answers[2 * i + 1].value[1];
            sum.moments.add(a + b);
            sum.gaussianity.add(a + b);
            difference.moments.add(a - b);
            difference.gaussianity.add(a - b);
        }
        const double margin = 4.5 * std::sqrt(2.0 / pairs);
        fmt::print("  lag {}, covariance {:.3f}: cvm of the sum {:.3f}, of the difference {:.3f}\n", lag,
                   between, sum.gaussianity.index().value, difference.gaussianity.index().value);
        CHECK(sum.moments.variance() == Approx(2 + 2 * between).epsilon(margin));
        CHECK(difference.moments.variance() == Approx(2 - 2 * between).epsilon(margin));
        const double chance = 2.0 * statistics::cvm_scale / pairs;
        CHECK(sum.gaussianity.index().value < 0.5 + chance);
        CHECK(difference.gaussianity.index().value < 0.5 + chance);
    }
}

TEST_CASE("surface noise on the lattice has variance 1 for every normal", "[law]") {
    const vulkan::Device device;
    test::Draw draw(32);
    for (const Entry3d entry : {Entry3d::surface, Entry3d::surface_isotropic}) {
        LatticeSampler3d sampler(device, 1 << 15, entry);
        for (int i = 0; i < 6; ++i) {
            LatticeSample3d sample = at(places[i % 3], 1);
            const Vector normal = random_unit(draw);
            // The last three near the direction, where another one takes over.
            for (std::size_t axis = 0; axis < 3; ++axis)
                sample.normal[axis] = static_cast<float>(
                    i < 3 ? normal[axis] : sample.direction[axis] + 0.15 * i * normal[axis] - 0.3);
            check(sampler, sample, 8,
                  {{fmt::format("normal {:.3f}", fmt::join(sample.normal, " ")), {0, 1}, 1}}, 0.5);
        }
    }
}

TEST_CASE("waves of surface noise are tangent, as long as asked, and of variance 1 together", "[oracle]") {
    test::Draw draw(33);
    double longest = 0;
    double shortest = 1e9;
    for (int i = 0; i < 20000; ++i) {
        const Vector normal = random_unit(draw);
        Vector direction = random_unit(draw);
        if (i % 4 == 0) { // near the normal, and the normal itself
            for (std::size_t axis = 0; axis < 3; ++axis)
                direction[axis] = normal[axis] + (i % 8 ? 0.3 : 0.01) * direction[axis];
            const double length = std::sqrt(dot(direction, direction));
            for (double& coordinate : direction)
                coordinate /= length;
        }
        const double frequency = draw.uniform(0.1f, 6);
        for (const auto& waves : {noise::surface_waves(normal, frequency, direction, 1),
                                  noise::surface_isotropic_waves(normal, frequency, 1)}) {
            double power = 0;
            for (const noise::WeightedWave& w : waves) {
                power += w.weight * w.weight;
                const double length = std::sqrt(dot(w.wave, w.wave)) / frequency;
                longest = std::max(longest, length);
                shortest = std::min(shortest, length);
                REQUIRE(std::abs(dot(w.wave, normal)) < 1e-9 * frequency);
            }
            REQUIRE(power == Approx(1).margin(1e-9));
        }
    }
    fmt::print("frequency on the surface: {:.9f} to {:.9f} of that asked for\n", shortest, longest);
    CHECK(shortest > 1 - 1e-9);
    CHECK(longest < 1 + 1e-9);
}

// The power of Hann's window as a lobe falls off as a normal law with a deviation of 1/sqrt(12) cycles would.
TEST_CASE("the directions of isotropic noise are even", "[oracle]") {
    test::Draw draw(34);
    for (const double frequency : {0.5, 1.0, 1.5, 2.0, 2.9, 4.0, 5.1}) {
        // On the surface: the power by angle, from the lobes' parts across the angle.
        double worst = 0;
        for (int i = 0; i < 50; ++i) {
            const Vector normal = random_unit(draw);
            const auto waves = noise::surface_isotropic_waves(normal, frequency, 1);
            Vector u = waves[0].wave;
            for (double& coordinate : u)
                coordinate /= frequency;
            const Vector v{normal[1] * u[2] - normal[2] * u[1], normal[2] * u[0] - normal[0] * u[2],
                           normal[0] * u[1] - normal[1] * u[0]};
            std::vector<double> powers;
            for (int k = 0; k < 90; ++k) {
                double power = 0;
                for (const noise::WeightedWave& w : waves) {
                    const double angle = pi * k / 90 - std::atan2(dot(w.wave, v), dot(w.wave, u));
                    const double across = 2 * frequency * std::abs(std::sin(std::remainder(angle, pi) / 2));
                    power += w.weight * w.weight * std::exp(-6 * across * across);
                }
                powers.push_back(power);
            }
            double mean = 0;
            for (const double power : powers)
                mean += power / 90;
            for (const double power : powers)
                worst = std::max(worst, std::abs(power / mean - 1));
        }
        // In space: the second moments of the directions are those of the sphere.
        double moments = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) {
                double moment = 0;
                for (const noise::WeightedWave& w : noise::isotropic_waves(frequency, 1))
                    moment += w.weight * w.weight * w.wave[a] * w.wave[b] / (frequency * frequency);
                moments = std::max(moments, std::abs(moment - (a == b ? 1.0 / 3 : 0)));
            }
        }
        fmt::print("frequency {}: on surfaces angular power even within {:.3f}; in space second moments "
                   "within {:.3f}\n",
                   frequency, worst, moments);
        CHECK(worst < 0.08);
        CHECK(moments < 0.035);
    }
}

TEST_CASE("noise on the lattice in space through a footprint is nearly the average over it", "[oracle]") {
    test::Draw draw(35);
    constexpr int nodes = 6; // to each side of the normal law's middle, up to 4.2 deviations
    struct Case {
        double frequency, pixel, largest;
    };
    for (const auto& [frequency, pixel, largest] :
         {Case{0, 0.1, 0.0015}, Case{0, 0.333, 0.025}, Case{1, 0.1, 0.0015}, Case{1, 0.333, 0.025},
          Case{2, 0.1, 0.0015}, Case{2, 0.333, 0.015}, Case{2, 1, 0.08}, Case{1, 1, 0.1}, Case{0, 1, 0.22}}) {
        double error = 0;
        double left = 0;
        double average = 0;
        double predicted = 0;
        constexpr int instances = 150;
        for (int i = 0; i < instances; ++i) {
            Vector wave = random_unit(draw);
            for (double& coordinate : wave)
                coordinate *= frequency;
            Vector dx = random_unit(draw);
            Vector dy = random_unit(draw);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                dx[axis] *= pixel;
                dy[axis] *= pixel * (i % 3 ? 1.0 : 0.2);
            }
            const Lattice3d reference(wave, draw.word());
            Lattice3d::Place place;
            for (float& coordinate : place.local)
                coordinate = draw.uniform(0, 1);
            double sum = 0;
            double weights = 0;
            for (int k = -nodes; k <= nodes; ++k) {
                for (int l = -nodes; l <= nodes; ++l) {
                    const double x = 4.2 * k / nodes;
                    const double y = 4.2 * l / nodes;
                    const double weight = std::exp(-(x * x + y * y) / 2);
                    Lattice3d::Place moved = place;
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        moved.local[axis] += static_cast<float>(0.75 * (x * dx[axis] + y * dy[axis]));
                    sum += weight * reference.field(moved).value.imag();
                    weights += weight;
                }
            }
            const Lattice3d::Field filtered = reference.filtered(place, dx, dy);
            error += std::pow(filtered.value.imag() - sum / weights, 2) / instances;
            left += std::pow(filtered.value.imag(), 2) / instances;
            average += std::pow(sum / weights, 2) / instances;
            predicted += (1 - filtered.removed) / instances;
        }
        fmt::print("frequency {}, pixel {}: error {:.4f}, deviation {:.3f} for {:.3f}, predicted {:.3f}\n",
                   frequency, pixel, std::sqrt(error), std::sqrt(left), std::sqrt(average),
                   std::sqrt(predicted));
        CHECK(std::sqrt(error) < largest);
    }
}

TEST_CASE("the filter on the lattice in space is continuous where the nodes change", "[oracle]") {
    test::Draw draw(36);
    double largest = 0;
    for (int i = 0; i < 300; ++i) {
        const Lattice3d reference({draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)},
                                  draw.word());
        const float pixel = std::exp2(draw.uniform(-5, 1));
        const Vector dx{pixel * draw.uniform(-1, 1), pixel * draw.uniform(-1, 1),
                        pixel * draw.uniform(-1, 1)};
        const Vector dy{pixel * draw.uniform(-1, 1), pixel * draw.uniform(-1, 1),
                        pixel * draw.uniform(-1, 1)};
        Lattice3d::Place before;
        for (float& coordinate : before.local)
            coordinate = draw.uniform(0, 1);
        Lattice3d::Place after = before;
        const std::size_t axis = draw.word() % 3;
        before.local[axis] = 0.499999f;
        after.local[axis] = 0.500001f;
        largest = std::max(largest, std::abs(reference.filtered(after, dx, dy).value.imag() -
                                             reference.filtered(before, dx, dy).value.imag()));
    }
    fmt::print("across a change of nodes the filtered noise moves by {:.2g} at most\n", largest);
    CHECK(largest < 2e-4);
}
