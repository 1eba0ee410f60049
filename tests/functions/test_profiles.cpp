// Compares profiles, which draw stripes as waves of other shapes, and filtered stripes with their
// definitions.

#include "noise.hpp"
#include "reference/sum.hpp"

#include <vector>

using namespace gabor;
using test::Largest;
using test::place_of;
using test::Random;
using Profiles = std::array<double, 5>;

namespace {

test::Lattice3 n;

// Unfiltered sine, triangle, sawtooth, pulse and ridges at a phase, from their definitions.
Profiles sharp(double phase, double duty) {
    const double t = phase - std::floor(phase);
    return {0.5 - 0.5 * std::cos(2 * std::numbers::pi * t), 1 - std::abs(2 * t - 1), t, t < duty ? 1.0 : 0.0,
            4 * t * (1 - t)};
}

Profiles averaged(double phase, double duty, double width) {
    constexpr int steps = 4000;
    Profiles sum{};
    for (int i = 0; i < steps; ++i) {
        const Profiles values = sharp(phase + width * ((i + 0.5) / steps - 0.5), duty);
        for (std::size_t c = 0; c < 5; ++c)
            sum[c] += values[c] / steps;
    }
    return sum;
}

} // namespace

TEST_CASE("profiles of a phase average over the given width, and profiles of stripes over the width that "
          "their length implies",
          "[profiles]") {
    Random random(3);
    Largest by_width, by_stripes;
    for (int i = 0; i < 2000; ++i) {
        const float phase = random.uniform(-3, 3), duty = random.uniform(0, 1);
        const float width = random.one_in(4) ? std::exp2(random.uniform(-9, 0)) : random.uniform(0, 1.2);
        const auto where = [&] { return fmt::format("phase {}, width {}, duty {}", phase, width, duty); };
        const double used = std::clamp(static_cast<double>(width), 0.001, 1.0);
        const Profiles expected = averaged(phase, duty, used);
        const Profiles found{n.gabor_profile_sine(phase, width), n.gabor_profile_triangle(phase, width),
                             n.gabor_profile_sawtooth(phase, width),
                             n.gabor_profile_pulse(phase, duty, width), n.gabor_profile_ridges(phase, width)};
        const double length = std::sin(std::numbers::pi * used) / (std::numbers::pi * used);
        const double angle = 2 * std::numbers::pi * phase;
        const gabor_vec2 z(static_cast<float>(length * std::cos(angle)),
                           static_cast<float>(length * std::sin(angle)));
        const Profiles stripes{n.gabor_stripes_sine(z), n.gabor_stripes_triangle(z),
                               n.gabor_stripes_sawtooth(z), n.gabor_stripes_pulse(z, duty),
                               n.gabor_stripes_ridges(z)};
        for (std::size_t c = 0; c < 5; ++c) {
            by_width.see(found[c], expected[c], 5e-4 + 1e-6 / used, where);
            if (used > 0.02 && used < 0.98) // elsewhere, the rounded length leaves width or phase uncertain
                by_stripes.see(stripes[c], expected[c], 0.003 / used, where);
        }
    }
    by_width.check("gabor_profile_...");
    by_stripes.check("gabor_stripes_sine ...");
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
        const gabor_vec4 found = n.gabor_stripes_filtered(p, dx, dy, wave, sharpness, seed);
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
        of["gabor_stripes_filtered"].see(found.x, sum[0], 0.1, where);
        of["gabor_stripes_filtered"].see(found.y, sum[1], 0.1, where);
        of["its intensity"].see(found.z, sum[2], 0.13, where);
        of["its removed variance"].see(found.w, share, 0.02, where);
        const auto stripes_at = [&](const noise::Place<2>& place) {
            return noise::lattice_stripes(lattice.field(place).value, sharpness);
        };
        see(of["gabor_stripes_filtered, pixel of size 0"],
            n.gabor_stripes_filtered(p, {0, 0}, {0, 0}, wave, sharpness, seed), stripes_at(here), 2e-4,
            where);
        const noise::Place<2> place = test::any_lattice_place(random, 3);
        const gabor_vec4 placed = n.gabor_stripes_filtered_at(
            place_of(n, place), wave, n.gabor_footprint({0, 0}, {0, 0}), sharpness, seed);
        see(of["gabor_stripes_filtered_at, pixel of size 0"], placed, stripes_at(place), 2e-4, where);
        of["gabor_stripes_filtered_at, pixel of size 0"].see(placed.w, 0, 1e-6, where);
    }
    test::check(of, 5);
}
