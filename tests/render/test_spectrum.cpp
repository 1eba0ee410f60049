// gabor_spectrum.glsl on the device: lobes, spreads and the filter, against the double-precision reference.

#include "noise/spectrum.hpp"
#include "oracle.hpp"
#include "sampler.hpp"

#include "passes/sample_spectrum.h"

#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace gabor;
using test::Draw;
using test::Largest;

namespace {

constexpr double pi = std::numbers::pi;

/// As in passes/sample_spectrum.comp.
struct Sample {
    float p[2];
    float dx[2];
    float dy[2];
    float frequency;
    float orientation;
    float frequency_spread;
    float orientation_spread;
    std::uint32_t seed;
    float padding;
    float lobes[12];
};

struct Answer {
    float filtered[2];
    float lobes_filtered[2];
    float lobes_complex[2];
    float spread_complex[2];
    float spread[3];
    float spread_alone;
    float lobes[3];
    float lobes_alone;
};

std::string to_string(const Sample& s) {
    return fmt::format("({}, {}), footprint ({}, {}), ({}, {}), frequency {} +- {}, orientation {} +- {}, "
                       "seed {}, lobes {}",
                       s.p[0], s.p[1], s.dx[0], s.dx[1], s.dy[0], s.dy[1], s.frequency, s.frequency_spread,
                       s.orientation, s.orientation_spread, s.seed, fmt::join(s.lobes, " "));
}

constexpr auto everything = static_cast<test::Wanted>(0);
constexpr auto filtered_only = static_cast<test::Wanted>(1);
constexpr auto spread_only = static_cast<test::Wanted>(2);

struct Sampler : test::Probe<Sample, Answer> {
    Sampler(const vulkan::Device& device, std::size_t capacity)
        : Probe(device, capacity, sample_spectrum_spirv, {}) {}
};

std::vector<noise::SpectrumLobe> lobes_of(const Sample& s) {
    std::vector<noise::SpectrumLobe> lobes;
    for (int i = 0; i < 3; ++i) {
        const float* l = s.lobes + 4 * i;
        lobes.push_back({l[0], l[1], l[2], l[3], noise::lobe_seed_of(s.seed, i)});
    }
    return lobes;
}

noise::Spectrum one_wave(const Sample& s) {
    return noise::Spectrum({{s.frequency, s.orientation, 1, 1, s.seed}});
}

// A footprint of standard deviations `deviation` and `ratio` times it, its longer axis at an angle.
void set_footprint(Sample& sample, double deviation, double ratio, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    sample.dx[0] = static_cast<float>(2 * deviation * c);
    sample.dx[1] = static_cast<float>(2 * deviation * s);
    sample.dy[0] = static_cast<float>(-2 * deviation * ratio * s);
    sample.dy[1] = static_cast<float>(2 * deviation * ratio * c);
}

} // namespace

TEST_CASE("lobes and spreads on the lattice agree with the reference", "[oracle]") {
    const vulkan::Device device;
    constexpr std::size_t count = 1 << 12;
    Sampler sampler(device, count);
    Draw draw(31);
    for (Sample& s : sampler.samples()) {
        s = {};
        const float reach = std::exp2(draw.uniform(0, 8));
        for (float& coordinate : s.p)
            coordinate = draw.word() % 4 ? draw.uniform(-reach, reach)
                                         : std::round(draw.uniform(-reach, reach)) / 1.5f;
        s.frequency = draw.uniform(0, 6);
        s.orientation = draw.uniform(-8, 8);
        s.frequency_spread = draw.word() % 2 ? draw.uniform(0, 0.5) : 0;
        s.orientation_spread = draw.uniform(0, static_cast<float>(pi / 2));
        s.seed = draw.word();
        for (int i = 0; i < 3; ++i) {
            s.lobes[4 * i] = draw.uniform(0, 8);
            s.lobes[4 * i + 1] = draw.uniform(-8, 8);
            s.lobes[4 * i + 2] = std::exp2(draw.uniform(-1.5, 1.5));
            s.lobes[4 * i + 3] = i && draw.word() % 8 == 0 ? 0 : draw.uniform(0.1f, 3);
        }
    }
    Largest spread, spread_slope, lobes, lobes_slope;
    const auto answers = sampler.answers(count, everything);
    for (std::size_t i = 0; i < count; ++i) {
        const Sample& s = sampler.samples()[i];
        const Answer& a = answers[i];
        // A position of 256 is rounded by 1.5e-5, in radii of 0.35 by three times that.
        const double size = std::max({1.0, std::abs(double{s.p[0]}), std::abs(double{s.p[1]})});
        const double tolerance = 1e-4 + 3e-6 * size * (1 + 6);
        const noise::Spectrum range(noise::spread_lobes(s.frequency, s.orientation, s.frequency_spread,
                                                        s.orientation_spread, s.seed));
        const noise::Spectrum::Field field = range.field(s.p[0], s.p[1]);
        spread.see(a.spread[0], field.value.imag(), tolerance, s);
        spread.see(a.spread_alone, field.value.imag(), tolerance, s);
        spread.see(a.spread_complex[0], field.value.real(), tolerance, s);
        spread.see(a.spread_complex[1], field.value.imag(), tolerance, s);
        spread_slope.see(a.spread[1], field.slope_x.imag(), 60 * tolerance, s);
        spread_slope.see(a.spread[2], field.slope_y.imag(), 60 * tolerance, s);
        const noise::Spectrum::Field sum = noise::Spectrum(lobes_of(s)).field(s.p[0], s.p[1]);
        lobes.see(a.lobes[0], sum.value.imag(), tolerance, s);
        lobes.see(a.lobes_alone, sum.value.imag(), tolerance, s);
        lobes.see(a.lobes_complex[0], sum.value.real(), tolerance, s);
        lobes.see(a.lobes_complex[1], sum.value.imag(), tolerance, s);
        lobes_slope.see(a.lobes[1], sum.slope_x.imag(), 60 * tolerance, s);
        lobes_slope.see(a.lobes[2], sum.slope_y.imag(), 60 * tolerance, s);
    }
    spread.check("gabor_noise_spread");
    spread_slope.check("  its gradient");
    lobes.check("gabor_noise_lobes");
    lobes_slope.check("  its gradient");
}

TEST_CASE("the filter agrees with quadrature of the noise", "[oracle][filter]") {
    const vulkan::Device device;
    constexpr std::size_t count = 40;
    Sampler sampler(device, count);
    Draw draw(32);
    fmt::print("  RMSE and largest error in 1 % of the deviation, error of the removed variance in 1 %\n");
    for (const double deviation : {0.02, 0.08, 0.1, 1.0 / 6, 0.25, 0.354, 0.5}) {
        for (const double ratio : {0.0, 0.3, 1.0}) {
            for (const double angle : {0.0, pi / 8, pi / 4, 2.0}) {
                if (ratio == 1 && angle != 0)
                    continue;
                for (const double frequency : {0.0, 0.25, 0.5, 1.0, 2.0}) {
                    double squares = 0;
                    double largest = 0;
                    double removed = 0;
                    for (Sample& s : sampler.samples()) {
                        s = {};
                        s.p[0] = draw.uniform(-50, 50);
                        s.p[1] = draw.uniform(-50, 50);
                        s.frequency = static_cast<float>(frequency);
                        s.orientation = draw.uniform(-3, 3);
                        s.seed = draw.word();
                        set_footprint(s, deviation, ratio, angle);
                    }
                    const auto answers = sampler.answers(count, filtered_only);
                    for (std::size_t i = 0; i < count; ++i) {
                        const Sample& s = sampler.samples()[i];
                        const noise::Spectrum exact = one_wave(s);
                        const double error = answers[i].filtered[0] - exact.filtered(s.p[0], s.p[1], {s.dx[0], s.dx[1]},
                                                                                     {s.dy[0], s.dy[1]});
                        squares += error * error;
                        largest = std::max(largest, std::abs(error));
                        if (i % 10 == 0)
                            removed = std::max(removed, std::abs(answers[i].filtered[1] -
                                                                 exact.removed({s.dx[0], s.dx[1]}, {s.dy[0], s.dy[1]})));
                    }
                    const double rmse = std::sqrt(squares / count);
                    fmt::print("  deviation {:.3f} x {:.1f} at {:.2f}, frequency {:4}: {:.2f} {:.2f}, {:.2f}\n", deviation,
                               ratio, angle, frequency, 100 * rmse, 100 * largest, 100 * removed);
                    CHECK(rmse <= (deviation < 0.17 ? 0.01 : 0.02));
                    CHECK(removed <= 0.0105);
                }
            }
        }
    }
}
