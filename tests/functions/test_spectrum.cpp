// Compares lobes, spreads and the filter of gabor_spectrum.glsl with the double-precision reference.

#include "lattice.hpp"
#include "reference/sum.hpp"
#include "statistics/gaussianity.hpp"

#include <array>
#include <vector>

using namespace gabor;
using test::Differences;
using test::Draw;
using test::Largest;
using test::Pixel;

namespace {

constexpr double pi = std::numbers::pi;

test::Lattice3 n;

struct Sample {
    gabor_vec2 p{0, 0};
    Pixel pixel;
    float frequency = 0, orientation = 0, frequency_spread = 0, orientation_spread = 0;
    std::uint32_t seed = 0;
    test::Lattice3::GaborLobes lobes{};
    noise::Place<2> place;

    gabor_vec2 filtered() const {
        return n.gabor_noise_filtered(p, pixel.dx, pixel.dy, frequency, orientation, seed);
    }

    std::vector<noise::SpectrumLobe> reference_lobes() const {
        std::vector<noise::SpectrumLobe> all;
        for (const auto& l : lobes.lobe)
            all.push_back({l.frequency,
                           l.orientation,
                           {l.radius.x, l.radius.y},
                           l.power,
                           noise::lattice_lobe_seed(seed, static_cast<int>(all.size()))});
        return all;
    }
    noise::Sum<2> wave() const {
        return noise::wave_noise(3, noise::wave_along(frequency, orientation), seed);
    }
    noise::Sum<2> spread() const {
        return noise::spectrum(
            noise::spread_lobes(frequency, orientation, frequency_spread, orientation_spread, seed));
    }
    noise::Place<2> here() const { return test::lattice_place(3, p); }
    noise::Field<2> filtered_by(const noise::Sum<2>& sum) const {
        return sum.filtered(here(), test::wide(pixel.dx), test::wide(pixel.dy));
    }
    double removed_by(const noise::Sum<2>& sum) const {
        return sum.removed(here(), test::wide(pixel.dx), test::wide(pixel.dy));
    }
};

std::string to_string(const Sample& s) {
    std::string lobes;
    for (const auto& l : s.lobes.lobe)
        lobes +=
            fmt::format(" ({} {} {} {} {})", l.frequency, l.orientation, l.radius.x, l.radius.y, l.power);
    return fmt::format("({}, {}), {}, frequency {} +- {}, orientation {} +- {}, seed {}, lobes{}, {}", s.p.x,
                       s.p.y, test::to_string(s.pixel), s.frequency, s.frequency_spread, s.orientation,
                       s.orientation_spread, s.seed, lobes, test::to_string(s.place));
}

// Draws one wave at any place up to `reach`.
Sample somewhere(Draw& draw, double reach, double frequency) {
    Sample s;
    s.p = draw.uniform<gabor_vec2>(-reach, reach);
    s.frequency = static_cast<float>(frequency);
    s.orientation = draw.uniform(-3, 3);
    s.seed = draw.word();
    return s;
}

// Draws a round, thin, diagonal or degenerate pixel with deviations from 1/256 to 2^largest.
Pixel any_pixel(Draw& draw, double largest) {
    const double deviation = std::exp2(draw.uniform(-8, largest));
    const double ratio = draw.one_in(3) ? 0 : std::exp2(draw.uniform(-6, 0));
    const double angle = draw.one_in(3) ? draw.word() % 8 * pi / 4 : draw.uniform(-4, 4);
    Pixel pixel(deviation, ratio, angle);
    if (draw.one_in(4)) // nearly parallel steps
        for (int k = 0; k < 2; ++k)
            pixel.dy[k] = pixel.dx[k] * 0.1f * (1 + draw.uniform(-1e-3, 1e-3));
    return pixel;
}

// A wave contributes 4 pi^2 F^2, and the window pi^2 / 3 along each axis.
double gradient_variance(double frequency, std::array<double, 2> radius) {
    return 4 * pi * pi * frequency * frequency +
           pi * pi / 3 * (std::pow(radius[0], -2) + std::pow(radius[1], -2));
}

} // namespace

TEST_CASE("lobes and spreads on the lattice agree with the reference", "[spectrum][oracle]") {
    Draw draw(31);
    Differences of;
    for (int i = 0; i < 1 << 12; ++i) {
        const float reach = std::exp2(draw.uniform(0, 8));
        const bool most = draw.one_in(64); // more waves than are used
        Sample s = somewhere(draw, reach, most ? 20 : draw.uniform(0, 6));
        for (int axis = 0; axis < 2; ++axis)
            if (draw.one_in(4))
                s.p[axis] = std::round(s.p[axis]) / 1.5f;
        s.orientation = draw.uniform(-8, 8);
        s.frequency_spread = draw.word() % 2 ? draw.uniform(0, most ? 1 : 0.5) : 0;
        s.orientation_spread = draw.uniform(most ? 1.4 : 0, pi / 2);
        s.lobes.count = 6; // lobes beyond GABOR_LOBES are unused
        for (auto& lobe : s.lobes.lobe)
            lobe = n.gabor_lobe_elliptical(
                draw.uniform(0, 8), draw.uniform(-8, 8),
                {std::exp2(draw.uniform(-1.5, 1.5)), std::exp2(draw.uniform(-1.5, 1.5))},
                &lobe != s.lobes.lobe && draw.one_in(8) ? 0 : draw.uniform(0.1, 3));
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
        const noise::Field<2> sum = noise::spectrum(s.reference_lobes()).field(s.here());
        of["gabor_noise_lobes"].see(n.gabor_noise_lobes(s.p, s.lobes, s.seed), sum.value.imag(), tolerance,
                                    s);
        see(of["gabor_noise_lobes"], n.gabor_noise_lobes_complex(s.p, s.lobes, s.seed), sum.value, tolerance,
            s);
        see_gradient(of["gabor_noise_lobes"], of["gabor_noise_lobes, gradient"],
                     n.gabor_noise_lobes_gradient(s.p, s.lobes, s.seed), sum, tolerance, 60 * tolerance, s);
    }
    test::check(of, 4);
}

TEST_CASE("spreads, lobes and the filter agree with the reference in tiles, far cells and time",
          "[spectrum][oracle]") {
    Draw draw(37);
    Differences of;
    for (int i = 0; i < 1 << 10; ++i) {
        Sample s = somewhere(draw, 0, draw.uniform(0, 4));
        s.orientation = draw.uniform(-8, 8);
        s.frequency_spread = draw.word() % 2 ? draw.uniform(0, 0.5) : 0;
        s.orientation_spread = draw.uniform(0, 0.5);
        s.lobes.count = 3;
        for (auto& lobe : s.lobes.lobe) {
            const bool standard = &lobe == s.lobes.lobe;
            lobe = n.gabor_lobe_elliptical(draw.uniform(0, 4), draw.uniform(-3, 3),
                                           {standard ? 1 : std::exp2(draw.uniform(-1, 1)),
                                            standard ? 1 : std::exp2(draw.uniform(-1, 1))},
                                           draw.uniform(0.1, 1));
        }
        const gabor_vec2 period(draw.word() % 2 ? draw.uniform(3, 12) : 0,
                                draw.word() % 2 ? draw.uniform(3, 12) : 0);
        auto place = n.gabor_place_tiled({0, 0}, period);
        place.local = draw.uniform<gabor_vec2>(0, 1);
        // Far cells are exact with a period, and without one if all lobes have the same kernel radius.
        for (int axis = 0; axis < 2; ++axis)
            place.cell[axis] =
                static_cast<std::int32_t>(draw.word() % 2 ? draw.word() & 0x7fffff00u : draw.word() % 16);
        place.animated = true;
        place.time = draw.uniform(0, 1);
        s.place = {{place.cell.x, place.cell.y}, test::wide(place.local)};
        s.place.animated = true;
        s.place.time = place.time;
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
        see(of["gabor_field_filtered without a footprint"],
            of["gabor_field_filtered without a footprint, gradient"], filtered, s.wave().field(s.place), 1e-4,
            3e-3, s);
        if (place.cell.x < 16 && place.cell.y < 16)
            see(of["gabor_field_lobes"], n.gabor_field_lobes(place, s.lobes, s.seed).value,
                noise::spectrum(s.reference_lobes()).field(s.place).value, 2e-4, s);
    }
    test::check(of, 4);
}

TEST_CASE("the filter agrees with quadrature of the noise", "[spectrum][oracle][filter]") {
    constexpr int count = 600;
    Draw draw(36);
    struct Error {
        double squares = 0;
        int count = 0;
        Largest removed;
        double slope_squares = 0;
        double four_squares = 0;
        int four_count = 0;
        // `variance` is that of the unfiltered gradient, both components together
        void see(gabor_vec2 found, gabor_vec4 gradient, double variance, const noise::Sum<2>& exact,
                 const Sample& s) {
            const noise::Field<2> field = s.filtered_by(exact);
            squares += std::pow(found.x - field.value.imag(), 2);
            slope_squares += (std::pow(gradient.y - field.slope[0].imag(), 2) +
                              std::pow(gradient.z - field.slope[1].imag(), 2)) /
                             variance;
            ++count;
            removed.see(found.y, s.removed_by(exact), 0.0105, s);
            CHECK(gradient.x == Approx(found.x).margin(1e-5));
            CHECK(gradient.w == Approx(found.y).margin(1e-6));
        }
        void see_four(const Sample& s) {
            float four_removed;
            const gabor_vec4 four = n.gabor_noise_four_filtered(s.p, s.pixel.dx, s.pixel.dy, s.frequency,
                                                                s.orientation, s.seed, four_removed);
            for (int c = 0; c < 4; ++c) {
                Sample one = s;
                one.seed = c ? noise::lattice_lobe_seed(s.seed, -c) : s.seed;
                four_squares += std::pow(four[c] - one.filtered_by(one.wave()).value.imag(), 2) / 4;
            }
            ++four_count;
            CHECK(four.x == Approx(s.filtered().x).margin(1e-5));
            CHECK(four_removed == Approx(s.filtered().y).margin(1e-6));
        }
        void check(const char* name, double bound, double slope_bound) const {
            const double rmse = std::sqrt(squares / count);
            const double slope_rmse = std::sqrt(slope_squares / count);
            fmt::print("  {}: RMSE {:.2f} % of the deviation in {} places, {:.2f} % of the gradient's\n",
                       name, 100 * rmse, count, 100 * slope_rmse);
            CHECK(count > 50);
            CHECK(rmse <= bound);
            CHECK(slope_rmse <= slope_bound);
            removed.check("  removed variance");
        }
        void check_four(double bound) const {
            const double rmse = std::sqrt(four_squares / four_count);
            fmt::print("  four noises: RMSE {:.2f} %\n", 100 * rmse);
            CHECK(rmse > 0);
            CHECK(rmse <= bound);
        }
    };
    Error small, large, lobes;
    for (int i = 0; i < count; ++i) {
        Sample s = somewhere(draw, 50, draw.one_in(4) ? 0 : draw.uniform(0, 2));
        s.pixel = any_pixel(draw, -1);
        s.lobes.count = 3;
        for (auto& lobe : s.lobes.lobe) // wide kernels keep their relative filter small
            lobe = n.gabor_lobe_elliptical(draw.uniform(0, 2), draw.uniform(-3, 3),
                                           draw.uniform<gabor_vec2>(1, 2), draw.uniform(0, 1));
        const auto& [dx, dy] = s.pixel;
        Error& error = std::hypot(dx.x, dx.y, std::hypot(dy.x, dy.y)) < 1.0 / 3 ? small : large;
        const gabor_vec4 gradient =
            n.gabor_noise_filtered_gradient(s.p, dx, dy, s.frequency, s.orientation, s.seed);
        error.see(s.filtered(), gradient, gradient_variance(s.frequency, {1, 1}), s.wave(), s);
        if (i % 4 == 0) {
            error.see_four(s);
            const auto sum = s.reference_lobes();
            double variance = 0, power = 0;
            for (const noise::SpectrumLobe& lobe : sum) {
                variance += lobe.power * gradient_variance(lobe.frequency, lobe.radius);
                power += lobe.power;
            }
            lobes.see(n.gabor_noise_lobes_filtered(s.p, dx, dy, s.lobes, s.seed),
                      n.gabor_noise_lobes_filtered_gradient(s.p, dx, dy, s.lobes, s.seed), variance / power,
                      noise::spectrum(sum), s);
        }
    }
    // Over twelve seeds, noises have 0.14 to 0.20 %, 0.54 to 0.69 % and 0.19 to 0.36 %, and gradients 0.7 to
    // 1.3 %, 1.4 to 2.1 % and 0.4 to 0.7 %.
    small.check("deviations up to 1/6", 0.0025, 0.015);
    small.check_four(0.0025);
    large.check("deviations up to 1/2", 0.0085, 0.024);
    large.check_four(0.0085);
    lobes.check("three lobes", 0.005, 0.008);
}

TEST_CASE("the filter agrees with quadrature where windows end", "[spectrum][oracle][filter]") {
    constexpr int count = 300;
    Draw draw(41);
    double squares = 0;
    Largest values;
    for (int i = 0; i < count; ++i) {
        Sample s = somewhere(draw, 50, draw.uniform(0, 2));
        for (int axis = 0; axis < 2; ++axis)
            s.p[axis] = (std::round(s.p[axis]) + 0.5f + draw.uniform(-0.03, 0.03)) / 1.5f;
        s.pixel = any_pixel(draw, -3.5);
        const double exact = s.filtered_by(s.wave()).value.imag();
        squares += std::pow(s.filtered().x - exact, 2) / count;
        values.see(s.filtered().x, exact, 0.04, s);
    }
    fmt::print("  RMSE {:.3f} % of the deviation\n", 100 * std::sqrt(squares));
    CHECK(std::sqrt(squares) < 0.004);
    values.check("filtered");
}

TEST_CASE("the filter errs by at most 1 % up to a third of a radius, and 2 % up to a radius",
          "[spectrum][filter][law]") {
    constexpr int count = 40;
    Draw draw(32);
    fmt::print("  RMSE and largest error in percent of the deviation\n");
    for (const double deviation : {0.08, 1.0 / 6, 0.354, 0.5}) {
        for (const auto& [ratio, angle] :
             {std::pair(1.0, 0.0), {0.3, pi / 8}, {0.3, 2.0}, {0.0, 0.0}, {0.0, pi / 8}, {0.0, pi / 4}}) {
            for (const double frequency : {0.0, 0.25, 0.5, 1.0, 2.0}) {
                double squares = 0, largest = 0;
                Largest removed;
                for (int i = 0; i < count; ++i) {
                    Sample s = somewhere(draw, 50, frequency);
                    s.pixel = Pixel(deviation, ratio, angle);
                    const gabor_vec2 found = s.filtered();
                    const double error = found.x - s.filtered_by(s.wave()).value.imag();
                    squares += error * error;
                    largest = std::max(largest, std::abs(error));
                    if (i % 10 == 0)
                        removed.see(found.y, s.removed_by(s.wave()), 0.0105, s);
                }
                const double rmse = std::sqrt(squares / count);
                fmt::print("  deviation {:.3f} x {:.1f} at {:.2f}, frequency {:4}: {:.2f} {:.2f}\n",
                           deviation, ratio, angle, frequency, 100 * rmse, 100 * largest);
                CHECK(rmse <= (deviation < 0.17 ? 0.01 : 0.02));
                removed.check("  removed variance");
            }
        }
    }
}

// Along a path, the filtered noise changes by about its slope times the step. If the path is as dense as
// single precision allows, any other change is rounding or a jump.
TEST_CASE("the filtered noise has no jumps as the footprint moves, grows or turns", "[spectrum][filter]") {
    constexpr int steps = 1 << 14;
    Draw draw(33);
    Differences of;
    for (int path = 0; path < 90; ++path) {
        const Sample s = somewhere(draw, 8, path % 3 == 0 ? draw.uniform(0, 1) : draw.uniform(0, 5));
        const Pixel pixel = any_pixel(draw, 1);
        const double deviation = std::exp2(draw.uniform(-6, 0));
        const double ratio = path % 2 ? draw.uniform(0, 1) : 0;
        const double direction = draw.uniform(-4, 4);
        test::check_path(of, path, steps, [&](double t) {
            Sample here = s;
            here.pixel = pixel;
            if (path % 3 == 0) { // 2 kernel radii
                here.p.x += static_cast<float>(2 * t * std::cos(direction));
                here.p.y += static_cast<float>(2 * t * std::sin(direction));
            } else if (path % 3 == 1) // together, the paths cover all sizes from 1/256 to 2
                here.pixel = Pixel(std::exp2(-8 + 9 * (path / 3 + t) / 30), ratio, direction);
            else
                here.pixel = Pixel(deviation, ratio, pi * t);
            return here.filtered().x;
        });
    }
    test::check(of, 3);
}

// A lobe of variance 1/12 along each axis keeps d^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F), where S is
// the footprint's covariance and d the determinant of 1 + 2/3 pi^2 S.
TEST_CASE("the removed variance agrees with the formula", "[spectrum][filter][oracle]") {
    Draw draw(40);
    Largest removed;
    for (int i = 0; i < 1 << 12; ++i) {
        Sample s = somewhere(draw, 0, draw.uniform(0, 3));
        s.pixel = any_pixel(draw, 1);
        const double k = 2 * pi * pi / 3;
        const auto& [dx, dy] = s.pixel;
        const double xx = (double{dx.x} * dx.x + double{dy.x} * dy.x) / 4;
        const double yy = (double{dx.y} * dx.y + double{dy.y} * dy.y) / 4;
        const double xy = (double{dx.x} * dx.y + double{dy.x} * dy.y) / 4;
        const double d = (1 + k * xx) * (1 + k * yy) - k * xy * k * xy;
        // S (1 + k S)^-1 = (1 - (1 + k S)^-1) / k
        const double x = s.frequency * std::cos(double{s.orientation});
        const double y = s.frequency * std::sin(double{s.orientation});
        const double inverse = ((1 + k * yy) * x * x - 2 * k * xy * x * y + (1 + k * xx) * y * y) / d;
        const double exponent = 4 * pi * pi * (x * x + y * y - inverse) / k;
        removed.see(s.filtered().y, 1 - std::exp(-exponent) / std::sqrt(d), 1e-5, s);
    }
    removed.check("removed variance");
}

// For a long, thin footprint, the exponent is a small difference of large products.
TEST_CASE("the removed variance is between 0 and 1 for footprints of any length", "[spectrum][filter]") {
    Draw draw(38);
    for (int i = 0; i < 1 << 14; ++i) {
        Sample s = somewhere(draw, 0, std::exp2(draw.uniform(-3, 5)));
        s.pixel = Pixel(std::exp2(draw.uniform(-2, 8.9)), 0, s.orientation + pi / 2);
        INFO(to_string(s));
        REQUIRE((s.filtered().y >= 0 && s.filtered().y <= 1));
    }
}

TEST_CASE("filtered noise has the original variance minus the removed share", "[spectrum][filter][law]") {
    constexpr int count = 1 << 17;
    Draw draw(34);
    Largest variances;
    for (const bool isotropic : {false, true})
        for (const double deviation : {0.02, 0.05, 1.0 / 6, 0.3, 0.5, 1.0, 2.0})
            for (const double frequency : {0.0, 0.6, 1.5}) {
                Sample s = somewhere(draw, 0, frequency);
                s.pixel = Pixel(deviation, draw.uniform(0, 1), draw.uniform(-3, 3));
                const auto filtered = [&] {
                    return isotropic ? n.gabor_noise_isotropic_filtered(s.p, s.pixel.dx, s.pixel.dy,
                                                                        s.frequency, s.seed)
                                     : s.filtered();
                };
                double squares = 0;
                for (int i = 0; i < count; ++i) {
                    s.p = draw.uniform<gabor_vec2>(0, 64);
                    s.seed = draw.word();
                    squares += std::pow(filtered().x, 2);
                }
                const double kept = 1 - filtered().y;
                variances.see(squares / count, kept, 0.01 + 4 * kept * std::sqrt(2.0 / count), s);
            }
    variances.check("variance left");
}

// The power spectrum of Hann's window, normalized to power 1.
static double hann_power(double k) {
    if (std::abs(k) < 1e-9)
        return 4.0 / 3;
    if (std::abs(std::abs(k) - 0.5) < 1e-9)
        return 1.0 / 3;
    const double transform = std::sin(2 * pi * k) / (2 * pi * k * (1 - 4 * k * k));
    return transform * transform * 4 / 3;
}

TEST_CASE("isotropic noise has the same power in every direction within 5 %", "[spectrum]") {
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
        double mean = 0;
        for (const double power : powers)
            mean += power / directions;
        Largest largest;
        for (std::size_t i = 0; i < powers.size(); ++i)
            largest.see(powers[i] / mean, 1, 0.05, [&] { return fmt::format("{} degrees", i); });
        CHECK(std::abs(2 * pi * mean - 1) < 0.01);
        largest.check(fmt::format("frequency {}, {} lobes", frequency, lobes.size()));
    }
}

TEST_CASE("a spread changes little with its frequency, even where lobes appear or vanish", "[spectrum]") {
    constexpr float step = 1e-5f;
    Draw draw(39);
    Largest change;
    for (int i = 0; i < 1 << 11; ++i) {
        Sample s = somewhere(draw, 2, 0);
        s.orientation_spread = draw.uniform(0.4, pi / 2);
        const double quarters = s.orientation_spread / (pi / 2);
        const double count = 1 + draw.word() % 20 + (draw.word() % 2 ? 0.8 : 1.0);
        s.frequency = static_cast<float>((count - 0.8 - 0.6 * quarters) / (4.44 * quarters)) - step / 2;
        const auto spread = [&](float frequency) {
            return n.gabor_noise_spread(s.p, frequency, s.orientation, 0, s.orientation_spread, s.seed);
        };
        change.see(spread(s.frequency + step), spread(s.frequency), 1.5e-3, s);
    }
    change.check("change of a spread as its frequency rises by 0.00001");
}
