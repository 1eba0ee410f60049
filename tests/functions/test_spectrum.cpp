// Compares lobes, spreads and isotropic noise of gabor_spectrum.glsl with the double-precision reference.

#include "noise.hpp"

#include <boost/math/special_functions/sinc.hpp>

#include <array>
#include <numeric>
#include <vector>

using namespace gabor;
using test::Differences;
using test::Largest;
using test::place_of;
using test::Random;

namespace {

constexpr double pi = std::numbers::pi;

test::Lattice3 n;

struct Sample {
    gabor_vec2 p{0, 0}, tile{0, 0};
    float frequency = 0, orientation = 0, frequency_spread = 0, orientation_spread = 0;
    std::uint32_t seed = 0;
    test::Lattice3::GaborLobes lobes{};
    noise::Place<2> place;

    noise::Sum<2> spread() const {
        return noise::spectrum(
            noise::spread_lobes(frequency, orientation, frequency_spread, orientation_spread, seed));
    }
    noise::Sum<2> sum() const { return noise::spectrum(test::reference_lobes(lobes, seed)); }
    noise::Place<2> here() const { return test::lattice_place(3, p); }
};

std::string to_string(const Sample& s) {
    std::string lobes;
    for (const auto& l : s.lobes.lobe)
        lobes +=
            fmt::format(" ({} {} {} {} {})", l.frequency, l.orientation, l.radius.x, l.radius.y, l.power);
    return fmt::format(
        "({}, {}), tile ({}, {}), frequency {} +- {}, orientation {} +- {}, seed {}, lobes{}, {}", s.p.x,
        s.p.y, s.tile.x, s.tile.y, s.frequency, s.frequency_spread, s.orientation, s.orientation_spread,
        s.seed, lobes, test::to_string(s.place));
}

// Draws one wave, and a point with coordinates up to `reach`.
Sample somewhere(Random& random, double reach, double frequency) {
    Sample s;
    s.p = random.uniform<gabor_vec2>(-reach, reach);
    s.frequency = static_cast<float>(frequency);
    s.orientation = random.uniform(-3, 3);
    s.seed = random.word();
    return s;
}

} // namespace

TEST_CASE("lobes and spreads on the lattice agree with the reference", "[spectrum][oracle]") {
    Random random(31);
    Differences of;
    for (int i = 0; i < 1 << 12; ++i) {
        const float reach = std::exp2(random.uniform(0, 8));
        const bool most = random.one_in(64); // needs more waves than the function sums
        Sample s = somewhere(random, reach, most ? 20 : random.uniform(0, 6));
        for (int axis = 0; axis < 2; ++axis)
            if (random.one_in(4))
                s.p[axis] = std::round(s.p[axis]) / 1.5f;
        s.orientation = random.uniform(-8, 8);
        s.frequency_spread = random.word() % 2 ? random.uniform(0, most ? 1 : 0.5) : 0;
        s.orientation_spread = random.uniform(most ? 1.4 : 0, pi / 2);
        s.lobes.count = 6; // lobes beyond GABOR_LOBES are unused
        for (auto& lobe : s.lobes.lobe)
            lobe = n.gabor_lobe_elliptical(
                random.uniform(0, 8), random.uniform(-8, 8),
                {std::exp2(random.uniform(-1.5, 1.5)), std::exp2(random.uniform(-1.5, 1.5))},
                &lobe != s.lobes.lobe && random.one_in(8) ? 0 : random.uniform(0.1, 3));
        // A position near 256 is rounded by 1.5e-5, or by three times that in units of a radius of 0.35.
        const double size = std::max({1.0f, std::abs(s.p.x), std::abs(s.p.y)});
        const double tolerance = 1e-4 + 3e-6 * size * (1 + 6);
        const float f = s.frequency, o = s.orientation, df = s.frequency_spread, d = s.orientation_spread;
        const noise::Field<2> range = s.spread().field(s.here());
        of["gabor_noise_spread"].see(n.gabor_noise_spread(s.p, f, o, df, d, s.seed), range.value.imag(),
                                     tolerance, s);
        see(of["gabor_noise_spread"], n.gabor_noise_spread_complex(s.p, f, o, df, d, s.seed), range.value,
            tolerance, s);
        see_gradient(of["gabor_noise_spread"], of["gabor_noise_spread, gradient"],
                     n.gabor_noise_spread_gradient(s.p, f, o, df, d, s.seed), range, tolerance,
                     60 * tolerance, s);
        const noise::Field<2> sum = s.sum().field(s.here());
        of["gabor_noise_lobes"].see(n.gabor_noise_lobes(s.p, s.lobes, s.seed), sum.value.imag(), tolerance,
                                    s);
        see(of["gabor_noise_lobes"], n.gabor_noise_lobes_complex(s.p, s.lobes, s.seed), sum.value, tolerance,
            s);
        see_gradient(of["gabor_noise_lobes"], of["gabor_noise_lobes, gradient"],
                     n.gabor_noise_lobes_gradient(s.p, s.lobes, s.seed), sum, tolerance, 60 * tolerance, s);
    }
    test::check(of, 4);
}

TEST_CASE("spreads, lobes and the filter agree with the reference in tiles, in far cells and at any time",
          "[spectrum][oracle]") {
    Random random(37);
    Differences of;
    for (int i = 0; i < 1 << 10; ++i) {
        Sample s = somewhere(random, 0, random.uniform(0, 4));
        s.orientation = random.uniform(-8, 8);
        s.frequency_spread = random.word() % 2 ? random.uniform(0, 0.5) : 0;
        s.orientation_spread = random.uniform(0, 0.5);
        s.lobes.count = 3;
        for (auto& lobe : s.lobes.lobe) {
            const bool standard = &lobe == s.lobes.lobe;
            lobe = n.gabor_lobe_elliptical(random.uniform(0, 4), random.uniform(-3, 3),
                                           {standard ? 1 : std::exp2(random.uniform(-1, 1)),
                                            standard ? 1 : std::exp2(random.uniform(-1, 1))},
                                           random.uniform(0.1, 1));
        }
        const gabor_vec2 period(random.word() % 2 ? random.uniform(3, 12) : 0,
                                random.word() % 2 ? random.uniform(3, 12) : 0);
        auto place = n.gabor_place_tiled({0, 0}, period);
        place.local = random.uniform<gabor_vec2>(0, 1);
        // Far cells are exact with a period, and without a period if all lobes have the same kernel radius.
        for (int axis = 0; axis < 2; ++axis)
            place.cell[axis] = static_cast<std::int32_t>(random.word() % 2 ? random.word() & 0x7fffff00u
                                                                           : random.word() % 16);
        place.animated = true;
        place.moment = random.uniform(0, 1);
        s.place = {{place.cell.x, place.cell.y}, test::wide(place.local)};
        s.place.animated = true;
        s.place.time = place.moment;
        for (std::size_t axis = 0; axis < 2; ++axis)
            if (const double length = period[static_cast<int>(axis)]; length > 0) {
                s.place.period[axis] = static_cast<int>(std::floor(1.5 * length + 0.5));
                s.place.radius[axis] = s.place.period[axis] / length;
            }
        see(of["gabor_field_spread"],
            n.gabor_field_spread(place, s.frequency, s.orientation, s.frequency_spread, s.orientation_spread,
                                 s.seed)
                .value,
            s.spread().field(s.place).value, 1e-4, s);
        float removed;
        const auto filtered = n.gabor_field_filtered(place, n.gabor_kernel(s.frequency, s.orientation),
                                                     n.gabor_footprint({0, 0}, {0, 0}), s.seed, removed);
        see(of["gabor_field_filtered, pixel of size 0"],
            of["gabor_field_filtered, pixel of size 0, gradient"], filtered,
            noise::wave_noise(3, noise::wave_along(s.frequency, s.orientation), s.seed).field(s.place), 1e-4,
            3e-3, s);
        if (place.cell.x < 16 && place.cell.y < 16)
            see(of["gabor_field_lobes"], n.gabor_field_lobes(place, s.lobes, s.seed).value,
                s.sum().field(s.place).value, 2e-4, s);
    }
    test::check(of, 4);
}

TEST_CASE("isotropic noise agrees with the reference in any cell, with any period, at any time",
          "[isotropic][oracle]") {
    Random random(61);
    Differences of;
    for (int i = 0; i < 1 << 13; ++i) {
        Sample s = somewhere(random, 16, random.one_in(16) ? 0 : random.uniform(-6, 6));
        s.place = test::any_lattice_place(random, 3);
        s.tile = random.uniform<gabor_vec2>(2, 7);
        const double few = 3 * test::tolerance(std::abs(s.frequency));
        // A position near 16 is rounded by 6e-7, which the waves multiply.
        const double far = few + 2e-5 * (1 + std::abs(s.frequency));
        const double steep = test::isotropic_slope(s.frequency);
        const auto reference = noise::isotropic_noise(s.frequency, s.seed);
        const auto field = n.gabor_field_isotropic(place_of(n, s.place), s.frequency, s.seed);
        see(of["gabor_field_isotropic"], of["gabor_field_isotropic, gradient"], field,
            reference.field(s.place), few, few * steep, s);
        float removed;
        const auto filtered = n.gabor_field_isotropic_filtered(
            place_of(n, s.place), s.frequency, n.gabor_footprint({0, 0}, {0, 0}), s.seed, removed);
        of["gabor_field_isotropic_filtered, pixel of size 0"].see(filtered.value.y, field.value.y, few, s);
        const auto here = reference.field(s.here());
        of["gabor_noise_isotropic"].see(n.gabor_noise_isotropic(s.p, s.frequency, s.seed), here.value.imag(),
                                        far, s);
        see_gradient(of["gabor_noise_isotropic, gradient"], of["gabor_noise_isotropic, gradient"],
                     n.gabor_noise_isotropic_gradient(s.p, s.frequency, s.seed), here, far, far * steep, s);
        of["gabor_noise_isotropic, tiled"].see(
            n.gabor_noise_isotropic_tiled(s.p, s.tile, s.frequency, s.seed),
            reference.field(test::lattice_tile(3, s.p, s.tile)).value.imag(), 2 * far, s);
    }
    test::check(of, 6);
}

// The power spectrum of Hann's window, normalized to power 1.
static double hann_power(double k) {
    const auto box = [](double q) { return boost::math::sinc_pi(2 * pi * q); };
    return std::pow(box(k) + (box(k - 0.5) + box(k + 0.5)) / 2, 2) * 4 / 3;
}

TEST_CASE("a spread over all directions has the same power in each direction within 5 %", "[spectrum]") {
    for (const double frequency : {0.3, 0.5, 0.8, 1.0, 1.2, 1.5, 1.7, 2.0, 2.4, 3.0, 3.3, 4.0, 6.0, 8.0}) {
        const auto lobes = noise::spread_lobes(frequency, 0.2, 0, pi / 2, 1);
        std::vector<double> powers;
        constexpr int directions = 180;
        for (int i = 0; i < directions; ++i) {
            const double angle = pi * i / directions;
            double power = 0;
            for (double k = 0.025; k < frequency + 2; k += 0.05) {
                for (const noise::SpectrumLobe& lobe : lobes) {
                    for (const double sign : {-1.0, 1.0}) {
                        const double fx = k * std::cos(angle) - sign * frequency * std::cos(lobe.orientation);
                        const double fy = k * std::sin(angle) - sign * frequency * std::sin(lobe.orientation);
                        if (std::abs(fx) < 2 && std::abs(fy) < 2)
                            power += lobe.power / 2 * k * 0.05 * hann_power(fx) * hann_power(fy);
                    }
                }
            }
            powers.push_back(power);
        }
        const double mean = std::reduce(powers.begin(), powers.end()) / directions;
        Largest largest;
        for (std::size_t i = 0; i < powers.size(); ++i)
            largest.see(powers[i] / mean, 1, 0.05, [&] { return fmt::format("{} degrees", i); });
        CHECK(std::abs(2 * pi * mean - 1) < 0.01);
        largest.check(fmt::format("frequency {}, {} lobes", frequency, lobes.size()));
    }
}

TEST_CASE("a spread changes little with its frequency, even where lobes appear or vanish", "[spectrum]") {
    constexpr float step = 1e-5f;
    Random random(39);
    Largest change;
    for (int i = 0; i < 1 << 11; ++i) {
        Sample s = somewhere(random, 2, 0);
        s.orientation_spread = random.uniform(0.4, pi / 2);
        const double quarters = s.orientation_spread / (pi / 2);
        const double count = 1 + random.word() % 20 + (random.word() % 2 ? 0.8 : 1.0);
        s.frequency = static_cast<float>((count - 0.8 - 0.6 * quarters) / (4.44 * quarters)) - step / 2;
        const auto spread = [&](float frequency) {
            return n.gabor_noise_spread(s.p, frequency, s.orientation, 0, s.orientation_spread, s.seed);
        };
        change.see(spread(s.frequency + step), spread(s.frequency), 1.5e-3, s);
    }
    change.check("change in a spread when its frequency rises by 0.00001");
}
