// Compares lobes, spreads and isotropic noise of gabor_spectrum.glsl with the double-precision reference.

#include "noise.hpp"

#include <boost/math/special_functions/sinc.hpp>

#include <array>
#include <numeric>
#include <vector>

using namespace gabor;
using test::Differences;
using test::Largest;
using test::n;
using test::place_of;
using test::Random;

namespace {

constexpr double pi = std::numbers::pi;

struct Arguments {
    noise::Place<2> place;
    gabor_vec2 p{0, 0};
    float frequency = 0, orientation = 0, frequency_spread = 0, orientation_spread = 0;
    std::uint32_t seed = 0;
    test::Lattice3::GaborLobes lobes{};

    noise::Sum<2> spread() const {
        return noise::spectrum(
            noise::spread_lobes(frequency, orientation, frequency_spread, orientation_spread, seed));
    }
    noise::Sum<2> sum() const { return noise::spectrum(test::reference_lobes(lobes, seed)); }
};

std::string to_string(const Arguments& s) {
    std::string lobes;
    for (const auto& l : s.lobes.lobe)
        lobes += fmt::format(" ({} {} {} {} {})", l.cycles_per_unit, l.orientation, l.radius.x, l.radius.y,
                             l.power);
    return fmt::format("({}, {}), frequency {} +- {}, orientation {} +- {}, seed {}, lobes{}, {}", s.p.x,
                       s.p.y, s.frequency, s.frequency_spread, s.orientation, s.orientation_spread, s.seed,
                       lobes, test::to_string(s.place));
}

// Draws arguments at a point with coordinates up to `reach`.
Arguments drawn(Random& random, double reach, double frequency) {
    Arguments s;
    s.p = random.uniform<gabor_vec2>(-reach, reach);
    s.frequency = static_cast<float>(frequency);
    s.orientation = random.uniform(-8, 8);
    s.frequency_spread = random.word() % 2 ? random.uniform(0, 0.5) : 0;
    s.orientation_spread = random.uniform(0, pi / 2);
    s.seed = random.word();
    s.lobes.count = 1 + static_cast<int>(random.word() % 6); // lobes beyond it and GABOR_LOBES are unused
    for (auto& lobe : s.lobes.lobe)
        lobe = {random.uniform(0, 8),
                random.uniform(-8, 8),
                {std::exp2(random.uniform(-1.5, 1.5)), std::exp2(random.uniform(-1.5, 1.5))},
                &lobe != s.lobes.lobe && random.one_in(8) ? 0 : random.uniform(0.1, 3)};
    return s;
}

void see_spread(Differences& of, const Arguments& s, double tolerance) {
    see(of["gabor_field_spread"], of["gabor_field_spread, gradient"],
        n.gabor_field_spread(place_of(n, s.place), s.frequency, s.orientation, s.frequency_spread,
                             s.orientation_spread, s.seed),
        s.spread().field(s.place), tolerance, 60 * tolerance, s);
}

void see_lobes(Differences& of, const Arguments& s, double tolerance) {
    see(of["gabor_field_lobes"], of["gabor_field_lobes, gradient"],
        n.gabor_field_lobes(place_of(n, s.place), s.lobes, s.seed), s.sum().field(s.place), tolerance,
        60 * tolerance, s);
}

} // namespace

TEST_CASE("lobes and spreads on the lattice agree with the reference", "[spectrum][oracle]") {
    Random random(31);
    Differences of;
    for (int i = 0; i < 1 << 12; ++i) {
        const float reach = std::exp2(random.uniform(0, 8));
        const bool most = random.one_in(64); // needs more waves than the function sums
        Arguments s = drawn(random, reach, most ? 20 : random.uniform(0, 6));
        for (int axis = 0; axis < 2; ++axis)
            if (random.one_in(4))
                s.p[axis] = std::round(s.p[axis]) / 1.5f;
        if (most) {
            s.frequency_spread = random.uniform(0, 1);
            s.orientation_spread = random.uniform(1.4, pi / 2);
        }
        // A position near 256 is rounded by 1.5e-5, or by three times that in units of a radius of 0.35.
        const double size = std::max({1.0f, std::abs(s.p.x), std::abs(s.p.y)});
        const double tolerance = 1e-4 + 3e-6 * size * (1 + 6);
        s.place = test::lattice_place(3, s.p);
        see_spread(of, s, tolerance);
        see_lobes(of, s, tolerance);
        of["gabor_noise_spread"].see(n.gabor_noise_spread(s.p, s.frequency, s.orientation, s.frequency_spread,
                                                          s.orientation_spread, s.seed),
                                     s.spread().field(s.place).value.imag(), tolerance, s);
        of["gabor_noise_isotropic"].see(
            n.gabor_noise_isotropic(s.p, s.frequency, s.seed),
            noise::isotropic_noise(s.frequency, s.seed).field(s.place).value.imag(), tolerance, s);
    }
    test::check(of, 6);
}

TEST_CASE("lobes and spreads agree with the reference in tiles, in far cells and at any time",
          "[spectrum][oracle]") {
    Random random(37);
    Differences of;
    for (int i = 0; i < 1 << 10; ++i) {
        Arguments s = drawn(random, 0, random.uniform(0, 4));
        s.orientation_spread = random.uniform(0, 0.5);
        const gabor_vec2 period(random.word() % 2 ? random.uniform(3, 12) : 0,
                                random.word() % 2 ? random.uniform(3, 12) : 0);
        s.place = test::lattice_tile(3, gabor_vec2(0, 0), period);
        s.place.time = random.uniform(0, 1);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            s.place.cell[axis] = static_cast<std::int32_t>(random.word() % 16);
            s.place.local[axis] = random.uniform(0, 1);
        }
        see_lobes(of, s, 4e-4);
        for (std::int32_t& cell : s.place.cell)
            cell += static_cast<std::int32_t>(random.word() & 0x7fffff00u);
        see_spread(of, s, 1e-4);
        if (period.x > 0 && period.y > 0) // otherwise lobes round the position to a float
            see_lobes(of, s, 4e-4);
    }
    test::check(of, 4);
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
        Arguments s = drawn(random, 2, 0);
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
