// Compares the filter in space on the device with quadrature of the double-precision reference.

#include "reference/lattice.hpp"
#include "sampler_lattice_3d.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace gabor;
using noise::Lattice3d;
using std::numbers::pi;
using test::Entry3d;
using test::Largest;
using test::LatticeAnswer3d;
using test::LatticeSample3d;
using test::LatticeSampler3d;
using test::narrow;
using test::random_unit;
using Vector = Lattice3d::Vector;

namespace {

Vector scaled(double s, const Vector& v) {
    return {s * v[0], s * v[1], s * v[2]};
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Returns a pixel facing `normal`, turned by an angle around it, with the given deviation along one side and
// `ratio` times that along the other.
void set_footprint(LatticeSample3d& sample, const Vector& normal, double angle, double deviation,
                   double ratio) {
    const Vector aside = cross(normal, std::abs(normal[0]) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0});
    const Vector u =
        scaled(1 / std::sqrt(aside[0] * aside[0] + aside[1] * aside[1] + aside[2] * aside[2]), aside);
    const Vector v = cross(normal, u);
    for (std::size_t i = 0; i < 3; ++i) {
        sample.dx[i] = static_cast<float>(2 * deviation * (std::cos(angle) * u[i] + std::sin(angle) * v[i]));
        sample.dy[i] =
            static_cast<float>(2 * deviation * ratio * (std::cos(angle) * v[i] - std::sin(angle) * u[i]));
    }
}

// Rotates around a unit axis (Rodrigues' formula).
std::array<float, 3> rotated(const std::array<float, 3>& v, const Vector& axis, double angle) {
    const Vector aside = cross(axis, test::wide(v));
    const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] =
            std::cos(angle) * v[i] + std::sin(angle) * aside[i] + (1 - std::cos(angle)) * along * axis[i];
    return narrow(result);
}

LatticeSample3d somewhere(test::Draw& draw, double frequency, const Vector& direction) {
    LatticeSample3d sample;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sample.place.cell[axis] = draw.cell();
        sample.place.local[axis] = draw.uniform(0, 1);
    }
    sample.frequency = static_cast<float>(frequency);
    sample.direction = narrow(direction);
    sample.seed = draw.word();
    return sample;
}

Lattice3d reference_of(const LatticeSample3d& sample) {
    return Lattice3d(scaled(sample.frequency, test::unit(sample.direction)), sample.seed);
}

// Errors relative to the deviations of the unfiltered noise and gradient.
class Error {
  public:
    void see(const LatticeAnswer3d& answer, const LatticeSample3d& sample) {
        see(answer, sample, reference_of(sample));
    }

    template <typename Reference>
    void see(const LatticeAnswer3d& answer, const LatticeSample3d& sample, const Reference& reference) {
        const Lattice3d::Field exact =
            reference.filtered(sample.place, test::wide(sample.dx), test::wide(sample.dy));
        const auto square = [&](int component, std::complex<double> value) {
            return (std::pow(answer.value[component] - value.real(), 2) +
                    std::pow(answer.value[component + 1] - value.imag(), 2)) /
                   2;
        };
        const double value = square(0, exact.value);
        squares_ += value;
        largest_ = std::max(largest_, std::sqrt(value));
        double slopes = 0; // each wave contributes 4 pi^2 F^2, the window pi^2 / 3 along each axis
        double variance = std::pow(2 * pi * sample.frequency, 2);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            slopes += square(2 + 2 * static_cast<int>(axis), exact.slope[axis]);
            variance += std::pow(pi * sample.place.radius[axis] / 1.5, 2) / 3;
        }
        slope_squares_ += slopes / variance;
        if (count_++ % 8 == 0)
            removed_.see(answer.value[8],
                         reference.removed(sample.place, test::wide(sample.dx), test::wide(sample.dy)), 0.013,
                         sample);
    }

    void check(const std::string& name, double bound, double slope_bound) const {
        const double rmse = std::sqrt(squares_ / count_);
        const double slope_rmse = std::sqrt(slope_squares_ / count_);
        fmt::print("  {}: {:.2f} {:.2f}, gradient {:.2f}\n", name, 100 * rmse, 100 * largest_,
                   100 * slope_rmse);
        INFO(name);
        CHECK(count_ > 10);
        CHECK(rmse <= bound);
        CHECK(slope_rmse <= slope_bound);
        removed_.check("  removed variance");
    }

  private:
    int count_ = 0;
    double squares_ = 0;
    double largest_ = 0;
    double slope_squares_ = 0;
    Largest removed_;
};

// A sum of independent noises.
struct Terms {
    std::vector<noise::WeightedIsotropic> terms;

    Lattice3d::Field filtered(const Lattice3d::Place& place, const Vector& dx, const Vector& dy) const {
        Lattice3d::Field sum{};
        for (const auto& [weight, noise] : terms) {
            const Lattice3d::Field one = noise.filtered(place, dx, dy);
            sum.value += weight * one.value;
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum.slope[axis] += weight * one.slope[axis];
        }
        return sum;
    }

    double removed(const Lattice3d::Place& place, const Vector& dx, const Vector& dy) const {
        double sum = 0;
        for (const auto& [weight, noise] : terms)
            sum += weight * weight * noise.removed(place, dx, dy);
        return sum;
    }
};

const std::vector<Vector>& normals() {
    static const std::vector<Vector> list{
        {0, 0, 1}, test::unit({1, 1, 0}), test::unit({1, 1, 1}), test::unit({1, 2, 3})};
    return list;
}

} // namespace

TEST_CASE("the filter in space errs by 1 % at most up to a third of a radius, by 2 % up to a radius",
          "[filter][law]") {
    const vulkan::Device device;
    constexpr std::size_t count = 16;
    LatticeSampler3d sampler(device, count, Entry3d::field, true);
    test::Draw draw(41);
    fmt::print("  RMSE and largest error in percent of the deviation, RMSE of the gradient\n");
    for (const double deviation : {0.02, 0.08, 0.1, 1.0 / 6, 0.25, 0.354, 0.5}) {
        for (const double ratio : {0.0, 0.4, 1.0}) {
            for (const Vector& normal : normals()) {
                for (const double frequency : {0.0, 0.5, 1.0, 2.0}) {
                    for (LatticeSample3d& sample : sampler.samples()) {
                        sample = somewhere(draw, frequency, random_unit(draw));
                        set_footprint(sample, normal, ratio < 0.3 ? 0.8 : 0.3, deviation, ratio);
                    }
                    const auto answers = sampler.answers(count);
                    Error error;
                    for (std::size_t i = 0; i < count; ++i)
                        error.see(answers[i], sampler.samples()[i]);
                    error.check(fmt::format("deviation {:.3f} x {:.1f} across {:.2f}, frequency {}",
                                            deviation, ratio, fmt::join(normal, " "), frequency),
                                deviation < 0.17 ? 0.01 : 0.02, 0.1);
                }
            }
        }
    }
}

TEST_CASE("the filter in space agrees with quadrature of the noise, with periods and without",
          "[oracle][filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 400;
    LatticeSampler3d field(device, count, Entry3d::field, true);
    test::Draw draw(42);
    for (const bool periodic : {false, true}) {
        for (LatticeSample3d& sample : field.samples()) {
            sample = somewhere(draw, draw.word() % 4 ? draw.uniform(0, 2) : 0, random_unit(draw));
            set_footprint(sample, random_unit(draw), draw.uniform(-3, 3), std::exp2(draw.uniform(-6, -1)),
                          draw.word() % 3 ? draw.uniform(0, 1) : 0);
            for (std::size_t axis = 0; periodic && axis < 3; ++axis) {
                sample.place.period[axis] = 3 + static_cast<std::int32_t>(draw.word() % 9);
                sample.place.radius[axis] = 1.5f * draw.uniform(0.8f, 1.0f);
            }
        }
        const auto answers = field.answers(count);
        Error small, large;
        for (std::size_t i = 0; i < count; ++i) {
            const LatticeSample3d& sample = field.samples()[i];
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                square += std::pow(sample.dx[axis], 2);
            (square < 1.0 / 9 ? small : large).see(answers[i], sample);
        }
        small.check(periodic ? "periods, deviations up to 1/6" : "deviations up to 1/6", 0.005, 0.02);
        large.check(periodic ? "periods, deviations up to 1/2" : "deviations up to 1/2", 0.01, 0.03);
    }
}

TEST_CASE("gabor_noise_3d_filtered and surface noise are filtered as their terms are", "[oracle][filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 48;
    test::Draw draw(43);
    std::vector<LatticeSample3d> samples(count);
    for (LatticeSample3d& sample : samples) {
        sample.p = {draw.uniform(-9, 9), draw.uniform(-9, 9), draw.uniform(-9, 9)};
        for (std::size_t axis = 0; axis < 3; ++axis)
            sample.place.local[axis] = sample.p[axis] * 1.5f;
        sample.frequency = draw.uniform(0, 2);
        sample.direction = narrow(random_unit(draw));
        sample.normal = narrow(random_unit(draw));
        sample.seed = draw.word();
        set_footprint(sample, random_unit(draw), draw.uniform(-3, 3), std::exp2(draw.uniform(-5, 0)),
                      draw.uniform(0, 1));
    }
    constexpr std::size_t most = 64; // terms of a sum
    LatticeSampler3d field(device, count * most, Entry3d::field, true);
    using Waves = std::vector<noise::WeightedWave>;
    const auto check = [&](const char* name, Entry3d entry, int components, const auto& waves_of) {
        LatticeSampler3d sums(device, count, entry, true);
        std::ranges::copy(samples, sums.samples().begin());
        const auto answers = sums.answers(count);
        std::size_t used = 0;
        std::vector<Waves> waves;
        for (const LatticeSample3d& sample : samples) {
            waves.push_back(waves_of(sample));
            REQUIRE(waves.back().size() <= most);
            for (const noise::WeightedWave& wave : waves.back()) {
                LatticeSample3d& term = field.samples()[used++] = sample;
                term.direction = narrow(wave.wave);
                term.seed = wave.seed;
                term.frequency = static_cast<float>(std::hypot(wave.wave[0], wave.wave[1], wave.wave[2]));
            }
        }
        const auto terms = field.answers(used);
        Largest largest;
        std::size_t term = 0;
        for (std::size_t i = 0; i < count; ++i) {
            std::array<double, 9> sum{};
            for (const noise::WeightedWave& wave : waves[i]) {
                for (std::size_t c = 0; c < 8; ++c)
                    sum[c] += wave.weight * terms[term].value[c];
                sum[8] += wave.weight * wave.weight * terms[term].value[8];
                ++term;
            }
            if (components == 2) { // a noise and the variance removed
                largest.see(answers[i].value[0], sum[1], 1e-4, samples[i]);
                largest.see(answers[i].value[1], sum[8], 1e-5, samples[i]);
                continue;
            }
            for (std::size_t c = 0; c < 9; ++c)
                largest.see(answers[i].value[c], sum[c], c < 2 ? 1e-4 : c < 8 ? 1e-3 : 1e-5, samples[i]);
        }
        largest.check(name);
    };
    check("gabor_noise_3d_filtered", Entry3d::filtered, 2, [](const LatticeSample3d& sample) {
        return Waves{{1, scaled(sample.frequency, test::unit(sample.direction)), sample.seed}};
    });
    check("surface", Entry3d::surface, 9, [](const LatticeSample3d& sample) {
        return noise::surface_waves(test::unit(sample.normal), sample.frequency, test::unit(sample.direction),
                                    sample.seed);
    });
    LatticeSampler3d position(device, count, Entry3d::noise_isotropic_filtered);
    LatticeSampler3d place(device, count, Entry3d::isotropic, true);
    std::ranges::copy(samples, position.samples().begin());
    std::ranges::copy(samples, place.samples().begin());
    const auto values = position.answers(count);
    const auto fields = place.answers(count);
    Largest largest;
    for (std::size_t i = 0; i < count; ++i) {
        largest.see(values[i].value[0], fields[i].value[1], 1e-4, samples[i]);
        largest.see(values[i].value[1], fields[i].value[8], 1e-5, samples[i]);
    }
    largest.check("gabor_noise_3d_isotropic_filtered");
}

TEST_CASE("isotropic noise in space and on surfaces is filtered within 2 % up to 0.3 radii",
          "[filter][law]") {
    const vulkan::Device device;
    constexpr std::size_t count = 11;
    LatticeSampler3d space(device, count, Entry3d::isotropic, true);
    LatticeSampler3d surface(device, count, Entry3d::surface_isotropic, true);
    fmt::print(
        "  RMSE and largest error in percent of the deviation, RMSE of the gradient, error of the removed "
        "variance in 1 %\n");
    for (LatticeSampler3d* sampler : {&space, &surface}) {
        test::Draw draw(47);
        for (const double deviation : {0.03, 0.15}) {
            for (const double ratio : {0.0, 1.0}) {
                for (const double frequency : {0.0, 1.0, 2.5}) {
                    for (LatticeSample3d& sample : sampler->samples()) {
                        sample = somewhere(draw, frequency, {1, 0, 0});
                        const Vector normal = random_unit(draw);
                        sample.normal = narrow(normal);
                        set_footprint(sample, normal, draw.uniform(-3, 3), deviation, ratio);
                    }
                    const auto answers = sampler->answers(count);
                    Error error;
                    for (std::size_t i = 0; i < count; ++i) {
                        const LatticeSample3d& sample = sampler->samples()[i];
                        if (sampler == &space) {
                            error.see(answers[i], sample, noise::Isotropic3d(sample.frequency, sample.seed));
                            continue;
                        }
                        const auto terms = noise::surface_isotropic(test::unit(sample.normal),
                                                                    sample.frequency, sample.seed);
                        error.see(answers[i], sample, Terms{terms});
                    }
                    error.check(fmt::format("{}, deviation {:.3f} x {:.1f}, frequency {}",
                                            sampler == &space ? "space" : "surface", deviation, ratio,
                                            frequency),
                                0.02, 0.1);
                }
            }
        }
    }
}

TEST_CASE("the removed variance of isotropic noise is right for any pixel", "[filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 600;
    for (const Entry3d entry : {Entry3d::isotropic, Entry3d::surface_isotropic}) {
        LatticeSampler3d sampler(device, count, entry, true);
        test::Draw draw(48);
        for (LatticeSample3d& sample : sampler.samples()) {
            sample = somewhere(draw, draw.uniform(0, 3), {1, 0, 0});
            const Vector normal = random_unit(draw);
            sample.normal = narrow(normal);
            // The footprint does not always lie in the surface.
            set_footprint(sample, draw.word() % 2 ? normal : random_unit(draw), draw.uniform(-3, 3),
                          std::exp2(draw.uniform(-5, 1)), draw.uniform(0, 1));
        }
        const auto answers = sampler.answers(count);
        Largest removed;
        for (std::size_t i = 0; i < count; ++i) {
            const LatticeSample3d& s = sampler.samples()[i];
            const Vector dx = test::wide(s.dx), dy = test::wide(s.dy);
            removed.see(
                answers[i].value[8],
                entry == Entry3d::isotropic
                    ? noise::Isotropic3d(s.frequency, s.seed).removed(s.place, dx, dy)
                    : Terms{noise::surface_isotropic(test::unit(s.normal), s.frequency, s.seed)}.removed(
                          s.place, dx, dy),
                0.013, s);
        }
        removed.check(entry == Entry3d::isotropic ? "variance removed in space" : "  on surfaces");
    }
}

// Same method as for the filter in the plane, see test_spectrum.cpp.
TEST_CASE("the noise filtered in space has no jumps in place, in size or in rotation of the footprint",
          "[filter]") {
    const vulkan::Device device;
    constexpr std::size_t steps = 1 << 13;
    LatticeSampler3d of_a_wave(device, steps, Entry3d::filtered);
    LatticeSampler3d isotropic(device, steps, Entry3d::noise_isotropic_filtered);
    test::Draw draw(44);
    Largest place, size, rotation;
    std::size_t seen = 0;
    for (int path = 0; path < 120; ++path) {
        LatticeSampler3d& sampler = path < 60 ? of_a_wave : isotropic;
        LatticeSample3d sample;
        sample.p = {draw.uniform(-8, 8), draw.uniform(-8, 8), draw.uniform(-8, 8)};
        sample.frequency = path % 2 ? draw.uniform(0, 1) : draw.uniform(0, 4);
        sample.direction = narrow(random_unit(draw));
        sample.seed = draw.word();
        const Vector normal = random_unit(draw);
        const Vector direction = random_unit(draw);
        const double angle = draw.uniform(-4, 4);
        const double deviation = std::exp2(draw.uniform(-6, 0));
        const double ratio = path % 4 < 2 ? draw.uniform(0, 1) : 0;
        for (std::size_t i = 0; i < steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            LatticeSample3d& here = sampler.samples()[i] = sample;
            set_footprint(here, normal, angle, deviation, ratio);
            if (path % 3 == 0) { // 1.5 kernel radii
                for (std::size_t axis = 0; axis < 3; ++axis)
                    here.p[axis] += static_cast<float>(1.5 * t * direction[axis]);
            } else if (path % 3 == 1) { // together, the paths cover all sizes from 1/256 to 2
                set_footprint(here, normal, angle, std::exp2(-8 + 9 * (path % 60 / 3 + t) / 20), ratio);
            } else {
                here.dx = rotated(here.dx, direction, pi * t);
                here.dy = rotated(here.dy, direction, pi * t);
            }
        }
        const auto answers = sampler.answers(steps);
        Largest& largest = path % 3 == 0 ? place : path % 3 == 1 ? size : rotation;
        for (std::size_t i = 2; i + 1 < steps; ++i) {
            const auto value = [&](std::size_t k) { return double{answers[k].value[0]}; };
            const double expected =
                value(i - 1) + 0.5 * ((value(i - 1) - value(i - 2)) + (value(i + 1) - value(i)));
            largest.see(value(i), expected, 1e-4, sampler.samples()[i]);
            ++seen;
        }
    }
    place.check("in place");
    size.check("in size");
    rotation.check("in rotation");
    CHECK(seen > 800000);
}
