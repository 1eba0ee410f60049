// Compares isotropic noise of gabor_spectrum.glsl on the device with the double-precision reference and with
// its law.

#include "law.hpp"
#include "oracle.hpp"
#include "reference/lattice.hpp"
#include "reference/normal_mean.hpp"
#include "sampler.hpp"

#include "passes/sample_isotropic.h"

#include <array>
#include <cmath>
#include <numbers>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;

namespace {

constexpr double pi = std::numbers::pi;

/// As in passes/sample_isotropic.comp.
struct Sample {
    std::int32_t cell[2]{};
    float local[2]{};
    float radius[2]{1.5f, 1.5f};
    std::int32_t period[2]{};
    float p[2]{};
    float tile[2]{4, 4};
    float dx[2]{};
    float dy[2]{};
    float frequency = 1;
    float time = 0;
    std::int32_t animated = 0;
    std::uint32_t seed = 0;
};

struct Answer {
    float value[2];
    float slope_x[2];
    float slope_y[2];
    float filtered[2];
    float gradient[3];
    float noise;
    float tiled;
    float placed_filtered;
    float padding[2];
};

enum class Part : std::int32_t { all, field, filtered };

std::string to_string(const Sample& s) {
    return fmt::format(
        "cell ({}, {}) + ({}, {}), radius ({}, {}), period ({}, {}), p ({}, {}), tile ({}, {}), "
        "footprint ({}, {}), ({}, {}), frequency {}, time {}, seed {}",
        s.cell[0], s.cell[1], s.local[0], s.local[1], s.radius[0], s.radius[1], s.period[0], s.period[1],
        s.p[0], s.p[1], s.tile[0], s.tile[1], s.dx[0], s.dx[1], s.dy[0], s.dy[1], s.frequency,
        s.animated ? s.time : 0, s.seed);
}

struct Sampler : test::Probe<Sample, Answer> {
    Sampler(const vulkan::Device& device, std::size_t capacity)
        : Probe(device, capacity, sample_isotropic_spirv, {}) {}

    auto answers(std::size_t count, Part part) {
        return Probe::answers(count, static_cast<test::Wanted>(part));
    }
};

// The reference at a position in kernel radii.
noise::Lattice::Field reference_at(double x, double y, const Sample& s) {
    noise::LatticePlace place;
    place.local_x = 1.5 * x;
    place.local_y = 1.5 * y;
    return noise::lattice_isotropic(place, s.frequency, s.seed);
}

// The reference at the sample's position, averaged over its pixel: a sum over a grid of four deviations each
// way.
double filtered_reference(const Sample& s) {
    constexpr int steps = 20;
    double sum = 0, weights = 0;
    for (int i = -steps; i <= steps; ++i) {
        for (int j = -steps; j <= steps; ++j) {
            const double a = 4.0 * i / steps, b = 4.0 * j / steps;
            const double weight = std::exp(-(a * a + b * b) / 2);
            sum += weight * reference_at(double{s.p[0]} + (a * s.dx[0] + b * s.dy[0]) / 2,
                                         double{s.p[1]} + (a * s.dx[1] + b * s.dy[1]) / 2, s)
                                .value.imag();
            weights += weight;
        }
    }
    return sum / weights;
}

// Makes a pixel with standard deviations `deviation` and `ratio` times that, its longer axis at an angle.
void set_pixel(Sample& s, double deviation, double ratio, double angle) {
    s.dx[0] = static_cast<float>(2 * deviation * std::cos(angle));
    s.dx[1] = static_cast<float>(2 * deviation * std::sin(angle));
    s.dy[0] = -static_cast<float>(ratio) * s.dx[1];
    s.dy[1] = static_cast<float>(ratio) * s.dx[0];
}

// Of a part of the gradient: half of 4 pi^2 F^2 from the waves, pi^2 / 3 from the windows.
double slope_deviation(double frequency) {
    return std::sqrt(2 * pi * pi * frequency * frequency + pi * pi / 3);
}

} // namespace

TEST_CASE("isotropic noise agrees with the reference in any cell, period and moment", "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t count = 1 << 13;
    Sampler sampler(device, count);
    Draw draw(61);
    for (Sample& s : sampler.samples()) {
        s = {{draw.cell(), draw.cell()}, {draw.uniform(-2, 2), draw.uniform(-2, 2)}};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (draw.word() % 4 == 0)
                s.local[axis] = std::round(s.local[axis]);
            if (draw.word() % 3 == 0) {
                s.period[axis] = 3 + static_cast<std::int32_t>(draw.word() % 9);
                s.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
            }
            s.p[axis] = draw.uniform(-16, 16);
            s.tile[axis] = 2 + static_cast<float>(draw.word() % 5);
        }
        s.frequency = draw.word() % 16 == 0 ? 0 : draw.uniform(-6, 6);
        s.animated = draw.word() % 2;
        s.time = draw.uniform(-3, 3);
        s.seed = draw.word();
    }
    Differences of;
    const auto answers = sampler.answers(count, Part::all);
    for (std::size_t i = 0; i < count; ++i) {
        const Sample& s = sampler.samples()[i];
        const Answer& a = answers[i];
        const double few = 3 * test::tolerance(std::abs(double{s.frequency}));
        const noise::LatticePlace place{s.cell[0],   s.cell[1],   s.local[0],  s.local[1],      s.radius[0],
                                        s.radius[1], s.period[0], s.period[1], s.animated != 0, s.time};
        const auto field = noise::lattice_isotropic(place, s.frequency, s.seed);
        const double steep = few * slope_deviation(s.frequency);
        for (const int part : {0, 1}) {
            const auto part_of = [&](std::complex<double> z) { return part ? z.imag() : z.real(); };
            of["by place"].see(a.value[part], part_of(field.value), few, s);
            of["by place, gradient"].see(a.slope_x[part], part_of(field.slope_x), steep, s);
            of["by place, gradient"].see(a.slope_y[part], part_of(field.slope_y), steep, s);
        }
        of["filtered by a point"].see(a.placed_filtered, a.value[1], few, s);
        const auto here = reference_at(s.p[0], s.p[1], s);
        // A position of 16 is rounded by 6e-7, which its waves multiply.
        const double far = few + 2e-5 * (1 + std::abs(double{s.frequency}));
        of["gabor_noise_isotropic"].see(a.noise, here.value.imag(), far, s);
        of["gabor_noise_isotropic, gradient"].see(a.gradient[0], a.noise, 1e-6, s);
        of["gabor_noise_isotropic, gradient"].see(a.gradient[1], here.slope_x.imag(),
                                                  far * slope_deviation(s.frequency), s);
        of["gabor_noise_isotropic, gradient"].see(a.gradient[2], here.slope_y.imag(),
                                                  far * slope_deviation(s.frequency), s);
        noise::LatticePlace repeated;
        repeated.local_x = 1.5 * std::fmod(s.p[0], s.tile[0]);
        repeated.local_y = 1.5 * std::fmod(s.p[1], s.tile[1]);
        repeated.period_x = static_cast<std::int32_t>(std::floor(1.5f * s.tile[0] + 0.5f));
        repeated.period_y = static_cast<std::int32_t>(std::floor(1.5f * s.tile[1] + 0.5f));
        repeated.radius_x = repeated.period_x / double{s.tile[0]};
        repeated.radius_y = repeated.period_y / double{s.tile[1]};
        repeated.local_x *= repeated.radius_x / 1.5;
        repeated.local_y *= repeated.radius_y / 1.5;
        of["gabor_noise_isotropic, tiled"].see(
            a.tiled, noise::lattice_isotropic(repeated, s.frequency, s.seed).value.imag(), far, s);
    }
    test::check(of, 6);
}

TEST_CASE("isotropic noise and its gradient are normal at fixed places", "[law]") {
    const vulkan::Device device;
    constexpr std::size_t per_batch = 1 << 17;
    Sampler sampler(device, per_batch);
    Draw draw(62);
    for (const float frequency : {0.0f, 1.0f, 4.0f}) {
        const double slope = slope_deviation(frequency);
        for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {0.5f, 0.5f}, {0.25f, 0.0f}}) {
            test::Figure noise, sum(std::sqrt(2.0)), d_x(slope), both(std::sqrt(2.0) * slope),
                mixed(std::sqrt(2.0) * slope);
            const auto batches = static_cast<int>(std::ceil(test::law_samples() / 2 / per_batch));
            for (int batch = 0; batch < batches; ++batch) {
                for (Sample& s : sampler.samples()) {
                    s = {{draw.cell(), draw.cell()}, {x, y}};
                    s.frequency = frequency;
                    s.seed = draw.word();
                }
                for (const Answer& a : sampler.answers(per_batch, Part::field)) {
                    noise.add(a.value[1]);
                    sum.add(double{a.value[0]} + a.value[1]);
                    d_x.add(a.slope_x[1]);
                    both.add(double{a.slope_x[1]} + a.slope_y[1]);
                    mixed.add(slope * a.value[1] + a.slope_x[1]);
                }
            }
            fmt::print("isotropic, frequency {}, at ({}, {})\n", frequency, x, y);
            noise.check("noise");
            sum.check("noise and quadrature");
            d_x.check("d/dx");
            both.check("d/dx + d/dy");
            mixed.check("noise + d/dx");
        }
    }
}

// The covariance is the transform of the spectrum: J_0(2 pi F |lag|) of an even ring, times that of the
// windows.
TEST_CASE("the covariance of isotropic noise is that of an even ring of waves, in every direction", "[law]") {
    const vulkan::Device device;
    constexpr std::size_t per_batch = 1 << 17;
    Sampler sampler(device, per_batch);
    Draw draw(63);
    Largest covariances;
    const auto batches = static_cast<int>(std::ceil(test::law_samples() / 8 / per_batch));
    for (const float frequency : {0.5f, 2.0f, 5.0f}) {
        for (const double turns : {0.25, 0.6, 1.1}) {
            for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 90.0}) {
                const double angle = degrees * pi / 180;
                const std::array lag{turns / frequency * std::cos(angle),
                                     turns / frequency * std::sin(angle)};
                statistics::Moments products;
                for (int batch = 0; batch < batches; ++batch) {
                    for (std::size_t i = 0; i < per_batch; i += 2) {
                        Sample s{{draw.cell(), draw.cell()}, {draw.uniform(0, 1), draw.uniform(0, 1)}};
                        s.frequency = frequency;
                        s.seed = draw.word();
                        sampler.samples()[i] = s;
                        for (std::size_t axis = 0; axis < 2; ++axis)
                            s.local[axis] += static_cast<float>(1.5 * lag[axis]);
                        sampler.samples()[i + 1] = s;
                    }
                    const auto answers = sampler.answers(per_batch, Part::field);
                    for (std::size_t i = 0; i < per_batch; i += 2)
                        for (const int part : {0, 1})
                            products.add(answers[i].value[part] * answers[i + 1].value[part]);
                }
                const double expected = std::cyl_bessel_j(0.0, 2 * pi * turns) *
                                        noise::hann_correlation(lag[0]) * noise::hann_correlation(lag[1]);
                const double error = std::sqrt(products.variance() / static_cast<double>(products.count()));
                covariances.see(products.mean(), expected, 4.5 * error, [&] {
                    return fmt::format("frequency {}, {} turns away at {} degrees", frequency, turns,
                                       degrees);
                });
                CHECK(error < 0.01);
            }
        }
    }
    covariances.check("covariances, in 4.5 standard errors");
}

TEST_CASE("isotropic noise is filtered within 2 % up to 0.3 radii, and within 4 % up to 0.4", "[filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 600;
    Sampler sampler(device, count);
    Draw draw(64);
    for (const auto& [axis, most] : {std::array{0.1, 0.006}, {0.3, 0.02}, {0.4, 0.04}}) {
        for (const float frequency : {0.0f, 1.0f, 3.0f}) {
            for (const double ratio : {1.0, 0.3}) {
                for (Sample& s : sampler.samples()) {
                    s = {};
                    s.p[0] = draw.uniform(-20, 20);
                    s.p[1] = draw.uniform(-20, 20);
                    s.frequency = frequency;
                    s.seed = draw.word();
                    set_pixel(s, axis / 2, ratio, draw.uniform(0, 3.2f));
                }
                double squares = 0;
                const auto answers = sampler.answers(count, Part::filtered);
                for (std::size_t i = 0; i < count; ++i)
                    squares += std::pow(answers[i].filtered[0] - filtered_reference(sampler.samples()[i]), 2);
                const double error = std::sqrt(squares / count);
                fmt::print("  pixel of {} radii, ratio {}, frequency {}: rms error {:.4f}\n", axis, ratio,
                           frequency, error);
                CHECK(error < most);
            }
        }
    }
}

TEST_CASE("isotropic noise has the variance that it says a pixel leaves", "[filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 1 << 17;
    Sampler sampler(device, count);
    Draw draw(65);
    Largest variances;
    for (const double deviation : {0.02, 0.1, 0.2, 0.5, 2.0}) {
        for (const float frequency : {0.0f, 0.5f, 2.0f}) {
            for (const double ratio : {1.0, 0.4, 0.0}) {
                for (Sample& s : sampler.samples()) {
                    s = {};
                    s.p[0] = draw.uniform(-50, 50);
                    s.p[1] = draw.uniform(-50, 50);
                    s.frequency = frequency;
                    s.seed = draw.word();
                    set_pixel(s, deviation, ratio, draw.uniform(0, 3.2f));
                }
                double squares = 0;
                const auto answers = sampler.answers(count, Part::filtered);
                for (const Answer& a : answers)
                    squares += double{a.filtered[0]} * a.filtered[0];
                const double kept = 1 - double{answers[0].filtered[1]};
                variances.see(squares / count, kept, 0.01 + 4 * kept * std::sqrt(2.0 / count), [&] {
                    return fmt::format("deviation {}, ratio {}, frequency {}", deviation, ratio, frequency);
                });
            }
        }
    }
    variances.check("variance left");
}
