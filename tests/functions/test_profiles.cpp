// Compares profiles, which draw stripes as waves of other shapes, and filtered stripes with their
// definitions.

#include "noise.hpp"
#include "reference/sum.hpp"

#include <vector>

using namespace gabor;
using test::Largest;
using test::n;
using test::Random;
using Profiles = std::array<double, 3>;

namespace {

// Unfiltered triangle, sawtooth and pulse at a phase, from their definitions.
Profiles sharp(double phase, double duty) {
    const double t = phase - std::floor(phase);
    return {1 - std::abs(2 * t - 1), t, t < duty ? 1.0 : 0.0};
}

Profiles averaged(double phase, double duty, double width) {
    constexpr int steps = 4000;
    Profiles sum{};
    for (int i = 0; i < steps; ++i) {
        const Profiles values = sharp(phase + width * ((i + 0.5) / steps - 0.5), duty);
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += values[c] / steps;
    }
    return sum;
}

} // namespace

TEST_CASE("profiles of stripes are averaged over the width that the stripes' length implies", "[profiles]") {
    Random random(3);
    test::Differences of;
    for (int i = 0; i < 4000; ++i) {
        const auto p = random.uniform<gabor_vec2>(-9, 9);
        const float duty = random.uniform(0, 1);
        // Half of the stripes are those of a noise, whose vectors have length 1; their width is 0.
        const bool unit = i % 2;
        const gabor_vec3 noise = n.gabor_stripes(p, 2.0f * p, 1e6f, random.word());
        const double width = unit ? 0 : random.uniform(0.02, 0.98), angle = std::atan2(noise.y, noise.x);
        const double length = unit ? 1 : std::sin(std::numbers::pi * width) / (std::numbers::pi * width);
        const gabor_vec2 z = unit ? gabor_vec2(noise.x, noise.y)
                                  : gabor_vec2(static_cast<float>(length * std::cos(angle)),
                                               static_cast<float>(length * std::sin(angle)));
        const double phase = angle / (2 * std::numbers::pi);
        const Profiles found{n.gabor_profile_triangle(z), n.gabor_profile_sawtooth(z),
                             n.gabor_profile_pulse(z, duty)};
        const Profiles expected = unit ? sharp(phase, duty) : averaged(phase, duty, width);
        const auto where = [&] { return fmt::format("phase {}, width {}, duty {}", phase, width, duty); };
        const auto turns_from = [&](double edge) { return std::abs(std::remainder(phase - edge, 1)); };
        for (std::size_t c = 0; c < 3; ++c) {
            // At the jumps of the sawtooth and the pulse, only the range is certain.
            const bool jump = unit && (((c == 1 || c == 2) && turns_from(0) < 0.002) ||
                                       (c == 2 && turns_from(duty) < 0.002));
            of[unit ? "stripes of a noise" : "shorter stripes"].see(found[c], jump ? 0.5 : expected[c],
                                                                    jump   ? 0.501
                                                                    : unit ? 0.003
                                                                           : 0.003 / width,
                                                                    where);
        }
    }
    test::check(of, 2);
}

// The expected values are the means of z min(1 / |z|, sharpness) and of |z|, where z is the filtered value
// plus sqrt(removed) times normal numbers.
TEST_CASE("filtered stripes are the mean of stripes over the removed noise", "[profiles]") {
    Random random(3);
    test::Differences of;
    std::mt19937 generator(5);
    std::normal_distribution<> normal;
    std::vector<std::complex<double>> normals(4000);
    for (std::complex<double>& z : normals)
        z = {normal(generator), normal(generator)};
    for (int i = 0; i < 200; ++i) {
        const auto p = random.uniform<gabor_vec2>(-9, 9), wave = random.uniform<gabor_vec2>(-1.5, 1.5),
                   dx = random.uniform<gabor_vec2>(-0.3, 0.3), dy = random.uniform<gabor_vec2>(-0.3, 0.3);
        const std::uint32_t seed = random.word();
        const float sharpness = random.uniform(1, 4);
        const auto where = [&] { return fmt::format("p ({}, {}), wave ({}, {})", p.x, p.y, wave.x, wave.y); };
        const auto field = n.gabor_field_filtered(n.gabor_place_at(p), dx, dy, wave, seed);
        const gabor_vec3 found = n.gabor_stripes_of(field, sharpness);
        const auto lattice = noise::wave_noise(3, test::wide(wave), seed);
        const noise::Sum<2> reference(lattice);
        const auto here = test::lattice_place(3, p);
        const auto value = reference.filtered(here, test::wide(dx), test::wide(dy)).value;
        const double share = reference.removed(here, test::wide(dx), test::wide(dy));
        std::array<double, 3> sum{};
        for (const std::complex<double>& z : normals) {
            const auto stripes = noise::lattice_stripes(value + std::sqrt(share) * z, sharpness);
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += stripes[c] / static_cast<double>(normals.size());
        }
        of["stripes"].see(found.x, sum[0], 0.1, where);
        of["stripes"].see(found.y, sum[1], 0.1, where);
        of["their intensity"].see(found.z, sum[2], 0.13, where);
    }
    test::check(of, 2);
}
