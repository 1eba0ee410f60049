// Compares isotropic noise of gabor_spectrum.glsl with the double-precision reference.

#include "lattice.hpp"
#include "reference/sum.hpp"

#include <array>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;
using test::place_of;

namespace {

test::Lattice3 n;

struct Sample {
    noise::Place<2> place;
    gabor_vec2 p, tile;
    float frequency;
    std::uint32_t seed;
};

std::string to_string(const Sample& s) {
    return fmt::format("{}, p ({}, {}), tile ({}, {}), frequency {}, seed {}", test::to_string(s.place),
                       s.p.x, s.p.y, s.tile.x, s.tile.y, s.frequency, s.seed);
}

} // namespace

TEST_CASE("isotropic noise agrees with the reference in any cell, with any period, at any time",
          "[isotropic][oracle]") {
    Draw draw(61);
    Differences of;
    for (int i = 0; i < 1 << 13; ++i) {
        const Sample s{test::any_lattice_place(draw, 3), draw.uniform<gabor_vec2>(-16, 16),
                       draw.uniform<gabor_vec2>(2, 7), draw.one_in(16) ? 0 : draw.uniform(-6, 6),
                       draw.word()};
        const double few = 3 * test::tolerance(std::abs(s.frequency));
        // A position near 16 is rounded by 6e-7, which the waves multiply.
        const double far = few + 2e-5 * (1 + std::abs(s.frequency));
        const double steep = test::isotropic_slope(s.frequency);
        const auto field = n.gabor_field_isotropic(place_of(n, s.place), s.frequency, s.seed);
        see(of["gabor_field_isotropic"], of["gabor_field_isotropic, gradient"], field,
            noise::isotropic_noise(s.frequency, s.seed).field(s.place), few, few * steep, s);
        float removed;
        const auto filtered = n.gabor_field_isotropic_filtered(
            place_of(n, s.place), s.frequency, n.gabor_footprint({0, 0}, {0, 0}), s.seed, removed);
        of["filtered by a point"].see(filtered.value.y, field.value.y, few, s);
        const auto here = noise::isotropic_noise(s.frequency, s.seed).field(test::lattice_place(3, s.p));
        of["gabor_noise_isotropic"].see(n.gabor_noise_isotropic(s.p, s.frequency, s.seed), here.value.imag(),
                                        far, s);
        see_gradient(of["gabor_noise_isotropic, gradient"], of["gabor_noise_isotropic, gradient"],
                     n.gabor_noise_isotropic_gradient(s.p, s.frequency, s.seed), here, far, far * steep, s);
        of["gabor_noise_isotropic, tiled"].see(
            n.gabor_noise_isotropic_tiled(s.p, s.tile, s.frequency, s.seed),
            noise::isotropic_noise(s.frequency, s.seed)
                .field(test::lattice_tile(3, s.p, s.tile))
                .value.imag(),
            2 * far, s);
    }
    test::check(of, 6);
}

TEST_CASE("the filter of isotropic noise errs by at most 2 % up to 0.3 radii, and 4 % up to 0.4",
          "[isotropic][filter]") {
    constexpr int count = 150;
    Draw draw(64);
    for (const auto& [axis, most] : {std::array{0.1, 0.006}, {0.3, 0.02}, {0.4, 0.04}}) {
        for (const float frequency : {0.0f, 1.0f, 3.0f}) {
            for (const double ratio : {1.0, 0.3}) {
                double squares = 0;
                for (int i = 0; i < count; ++i) {
                    const auto p = draw.uniform<gabor_vec2>(-20, 20);
                    const std::uint32_t seed = draw.word();
                    const test::Pixel pixel(axis / 2, ratio, draw.uniform(0, 3.2));
                    const float found =
                        n.gabor_noise_isotropic_filtered(p, pixel.dx, pixel.dy, frequency, seed).x;
                    const noise::Sum<2> reference(noise::isotropic_noise(frequency, seed));
                    const noise::Field<2> exact = reference.filtered(
                        test::lattice_place(3, p), test::wide(pixel.dx), test::wide(pixel.dy));
                    squares += std::pow(found - exact.value.imag(), 2);
                }
                const double error = std::sqrt(squares / count);
                fmt::print("  pixel of {} radii, ratio {}, frequency {}: rms error {:.4f}\n", axis, ratio,
                           frequency, error);
                CHECK(error < most);
            }
        }
    }
}
