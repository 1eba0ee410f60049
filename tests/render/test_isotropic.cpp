// Compares isotropic noise of gabor_spectrum.glsl on the device with the double-precision reference.

#include "isotropic_sampler.hpp"
#include "oracle.hpp"
#include "reference/lattice.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;

namespace {

using Sample = test::IsotropicSample;
using Answer = test::IsotropicAnswer;
using Sampler = test::IsotropicSampler;
using test::Part;

// The reference at a position in kernel radii.
noise::Lattice::Field reference_at(double x, double y, const Sample& s) {
    noise::LatticePlace place;
    place.local_x = 1.5 * x;
    place.local_y = 1.5 * y;
    return noise::lattice_isotropic(place, s.frequency, s.seed);
}

// The reference averaged over the sample's pixel: a sum over a grid of four deviations each way.
double filtered_reference(const Sample& s) {
    constexpr int steps = 10;
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

} // namespace

TEST_CASE("isotropic noise agrees with the reference in any cell, with any period, at any time", "[oracle]") {
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
        const double steep = few * test::isotropic_slope(s.frequency);
        for (const int part : {0, 1}) {
            const auto part_of = [&](std::complex<double> z) { return part ? z.imag() : z.real(); };
            of["by place"].see(a.value[part], part_of(field.value), few, s);
            of["by place, gradient"].see(a.slope_x[part], part_of(field.slope_x), steep, s);
            of["by place, gradient"].see(a.slope_y[part], part_of(field.slope_y), steep, s);
        }
        of["filtered by a point"].see(a.placed_filtered, a.value[1], few, s);
        const auto here = reference_at(s.p[0], s.p[1], s);
        // A position near 16 is rounded by 6e-7, which the waves multiply.
        const double far = few + 2e-5 * (1 + std::abs(double{s.frequency}));
        of["gabor_noise_isotropic"].see(a.noise, here.value.imag(), far, s);
        of["gabor_noise_isotropic, gradient"].see(a.gradient[0], a.noise, 1e-6, s);
        of["gabor_noise_isotropic, gradient"].see(a.gradient[1], here.slope_x.imag(),
                                                  far * test::isotropic_slope(s.frequency), s);
        of["gabor_noise_isotropic, gradient"].see(a.gradient[2], here.slope_y.imag(),
                                                  far * test::isotropic_slope(s.frequency), s);
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

TEST_CASE("isotropic noise is filtered within 2 % up to 0.3 radii, and within 4 % up to 0.4", "[filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 150;
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

TEST_CASE("filtered isotropic noise has the variance that its removed share implies", "[filter]") {
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
