// Checks over independent instances that the lattice's noises, in the plane, in 3D and on surfaces, are
// normal at each point and jointly.

#include "law.hpp"
#include "noise.hpp"

#include <boost/math/distributions/normal.hpp>
#include <fmt/ranges.h>

using namespace gabor;
using std::numbers::pi;
using std::numbers::sqrt2;
using test::Laws;
using test::n;
using test::place_of;
using test::Random;
using test::Statistic;
using test::sum_of;
using Vector = noise::Vector<3>;
using Sample = test::Sample<3>;

namespace {

constexpr double half = 0.5, quarter = 0.25; // shares of the samples

// Checks noise of any direction, with and without periods, at side^N points of a cell. `values` returns the
// noise and its quadrature.
template <std::size_t N>
void check_cell(int taps, std::size_t side, auto values) {
    const auto places = test::places_of_cell<N>(side);
    Random random(30);
    Laws all(places);
    for (const float frequency : {0.0f, 0.05f, 0.7f, 1.5f, 4.0f, 30.0f}) {
        const bool periodic = frequency == 1.5f;
        Laws laws(places);
        laws.add(test::law_samples() / 8, [&](std::size_t k) {
            noise::Place<N> place;
            place.local = places[k];
            for (std::size_t axis = 0; axis < N; ++axis) {
                place.cell[axis] = random.cell();
                place.radius[axis] = 0.5 * taps * (periodic ? random.uniform(0.8, 1.25) : 1);
                place.period[axis] = periodic ? taps + static_cast<std::int32_t>(random.word() % 9) : 0;
            }
            return values(place, frequency, test::random_unit<N>(random), random.word());
        });
        laws.check(
            fmt::format("{} taps, {} axes, frequency {}{}", taps, N, frequency, periodic ? ", periods" : ""));
        all.merge(laws);
    }
    all.check("all waves");
}

// ---- In the plane

constexpr float fixed_frequency = 1.5;
constexpr float orientation = 0.4f;

gabor_vec2 anywhere(Random& random) {
    return random.uniform<gabor_vec2>(0, 1000);
}

// Checks that pairs of values have a joint normal distribution with this covariance.
void check_pairs(const std::string& name, double covariance, const auto& pair) {
    fmt::print("{}\n", name);
    test::check_laws(quarter, pair,
                     {sum_of("sum", std::sqrt(2 + 2 * covariance), {{0}, {1}}),
                      sum_of("difference", std::sqrt(2 - 2 * covariance), {{0}, {1, -1}})});
}

template <typename Functions>
void check_joint(Functions functions) {
    // E[n_x^2] = (2 pi F_x)^2 + sum h'^2 / sum h^2, where the last term is pi^2 / 3.
    const double x = std::hypot(2 * pi * fixed_frequency * std::cos(orientation), pi / std::sqrt(3));
    const double y = std::hypot(2 * pi * fixed_frequency * std::sin(orientation), pi / std::sqrt(3));
    const auto normal = [](double u) {
        return quantile(boost::math::normal(), std::clamp(u, 1e-9, 1 - 1e-9));
    };
    Random random(14);
    test::check_laws(half,
                     [&] {
                         const gabor_vec2 p = anywhere(random);
                         const std::uint32_t seed = random.word();
                         const auto both =
                             functions.gabor_noise_quadrature(p, fixed_frequency, orientation, seed);
                         const auto phasor = functions.gabor_turns_intensity(both);
                         const auto gradient =
                             functions.gabor_noise_gradient(p, fixed_frequency, orientation, seed);
                         return std::array{both.x, both.y, gradient.y, gradient.z, phasor.x, phasor.y};
                     },
                     {sum_of("noise", 1, {{0}}),
                      sum_of("quadrature", 1, {{1}}),
                      sum_of("noise + quadrature", sqrt2, {{0}, {1}}),
                      sum_of("d/dx", x, {{2}}),
                      sum_of("d/dy", y, {{3}}),
                      {"phase, mapped to normal", 1, [&](std::span<const float> a) { return normal(a[4]); }},
                      {"intensity, mapped to normal", 1,
                       [&](std::span<const float> a) { return -normal(std::exp(-0.5 * a[5] * a[5])); }}});
    test::check_laws(
        half,
        [&] {
            const gabor_vec2 p = anywhere(random), tile = random.uniform<gabor_vec2>(0.3, 4.3);
            const std::uint32_t seed = random.word();
            return std::array{
                functions.gabor_noise_tiled(p, tile, fixed_frequency, orientation, seed),
                functions.gabor_noise_animated(p, random.uniform(0, 1), fixed_frequency, orientation, seed)};
        },
        {sum_of("tiles of any period", 1, {{0}}), sum_of("at any time", 1, {{1}})});
    for (int lag = 1; lag < 10; lag += 2) {
        const double angle = 0.7 * lag, length = 0.08 * (lag + 1);
        const gabor_vec2 step(static_cast<float>(length * std::cos(angle)),
                              static_cast<float>(length * std::sin(angle)));
        const double turns =
            fixed_frequency * (step.x * std::cos(orientation) + step.y * std::sin(orientation));
        check_pairs(
            fmt::format("lag ({:.2f}, {:.2f})", step.x, step.y),
            noise::hann_correlation(step.x) * noise::hann_correlation(step.y) * std::cos(2 * pi * turns),
            [&] {
                const gabor_vec2 p = random.uniform<gabor_vec2>(0, 100);
                const std::uint32_t seed = random.word();
                return std::array{functions.gabor_noise(p, fixed_frequency, orientation, seed),
                                  functions.gabor_noise(p + step, fixed_frequency, orientation, seed)};
            });
    }
}

// ---- In 3D

// Returns a sample at an offset from the corner of any cell.
Sample solid_sample(Random& random, const Vector& local) {
    Sample sample;
    sample.place.cell = {random.cell(), random.cell(), random.cell()};
    sample.place.local = local;
    sample.frequency = 1;
    sample.direction = {0.6, 0.48, 0.64};
    sample.seed = random.word();
    return sample;
}

Sample moved(Sample sample, const Vector& nodes) {
    sample.place.local = noise::sum(1, sample.place.local, 1, nodes);
    return sample;
}

// Returns the quadrature, the noise and the noise's slopes.
std::array<float, 5> numbers_of(const test::Lattice3::GaborField3d& field) {
    return {field.quadrature, field.noise, field.gradient.x, field.gradient.y, field.gradient.z};
}

// The covariance of the noise at two points that are `lag` node spacings apart, from the nodes whose windows
// reach both.
double covariance(const Sample& sample, const Vector& lag) {
    double product = 1, turns = 0;
    const Vector direction = noise::unit(sample.direction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto window = [](double nodes) { return noise::lattice_window(3, nodes / 1.5).value; };
        double sum = 0;
        for (double node = -3; node <= 5; ++node)
            sum +=
                window(sample.place.local[axis] - node) * window(sample.place.local[axis] + lag[axis] - node);
        product *= sum / noise::lattice_energy(3);
        turns += sample.frequency * direction[axis] * lag[axis] / 1.5;
    }
    return product * std::cos(2 * pi * turns);
}

// Statistics of a noise (number 1), its quadrature (number 0) and two components of its gradient, whose
// deviation is `slope`. They show whether all are jointly normal.
std::vector<Statistic> of_isotropic(double slope, const std::vector<test::Term>& dx, test::Term dy) {
    std::vector<test::Term> both = dx, mixed = dx;
    both.push_back(dy);
    mixed.push_back({1, slope});
    return {sum_of("noise", 1, {{1}}),
            sum_of("quadrature", 1, {{0}}),
            sum_of("their sum", sqrt2, {{0}, {1}}),
            sum_of("d/dx", slope, dx),
            sum_of("d/dy", slope, {dy}),
            sum_of("d/dx + d/dy", sqrt2 * slope, both),
            sum_of("noise + d/dx", sqrt2 * slope, mixed)};
}

} // namespace

TEST_CASE("the lattice noise is normal at each of 16 x 16 points of a cell, and of 4 x 4 x 4 in 3D",
          "[law]") {
    const auto in_plane = [](auto functions) {
        return [functions](const auto& place, float frequency, const auto& direction,
                           std::uint32_t seed) mutable {
            const auto field = functions.gabor_field(place_of(functions, place),
                                                     test::narrow(noise::scaled(frequency, direction)), seed);
            return std::array{field.quadrature, field.noise};
        };
    };
    check_cell<2>(3, 16, in_plane(test::Lattice3()));
    check_cell<2>(4, 16, in_plane(test::Lattice4()));
    check_cell<3>(3, 4, [](const auto& place, float frequency, const auto& direction, std::uint32_t seed) {
        const auto field =
            test::solid.field({.place = place, .frequency = frequency, .direction = direction, .seed = seed});
        return std::array{field.quadrature, field.noise};
    });
}

TEST_CASE("the lattice noise, its gradient, quadrature and phasor, and values at pairs of points are jointly "
          "normal",
          "[law]") {
    check_joint(test::Lattice3());
    check_joint(test::Lattice4());
}

TEST_CASE("the lattice noise at two times is jointly normal with correlation cos^2(pi lag)", "[law]") {
    Random random(15);
    for (const float lag : {0.05f, 0.16f, 0.25f, 0.5f}) {
        check_pairs(fmt::format("time lag {}", lag), std::pow(std::cos(pi * lag), 2), [&] {
            const gabor_vec2 p = anywhere(random);
            const float time = random.uniform(0, 1);
            const std::uint32_t seed = random.word();
            return std::array{n.gabor_noise_animated(p, time, fixed_frequency, orientation, seed),
                              n.gabor_noise_animated(p, time + lag, fixed_frequency, orientation, seed)};
        });
    }
}

TEST_CASE("surface noise on the lattice is normally distributed for every surface normal", "[law]") {
    Random random(32);
    std::vector<Vector> normals;
    for (int i = 0; i < 32; ++i)
        normals.push_back(test::random_unit<3>(random));
    for (const auto& noise : {test::surface, test::isotropic_surface}) {
        Laws laws(normals);
        laws.add(test::law_samples() / 4, [&](std::size_t k) {
            Sample s = test::somewhere<3>(random, 1);
            s.normal = normals[k];
            if (random.word() % 2) // near the normal, where the function switches to another direction
                s.direction = noise::sum(1, s.normal, 0.45, s.direction);
            const auto field = noise.field(s);
            return std::array{field.quadrature, field.noise};
        });
        laws.check(noise.name);
    }
}

TEST_CASE("lattice noise in 3D is jointly normal with its gradient and quadrature, and at pairs of points",
          "[law]") {
    Random random(41);
    for (const Vector& place : {Vector{0, 0, 0}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0}}) {
        const Vector wave = solid_sample(random, place).wave();
        // sum h'^2 = pi^2 / 4 * 3/2 and sum h^2 = 9/8 along an axis, so d/dx has the variance pi^2 / 3 +
        // (2 pi F_x)^2, the covariance 4 pi^2 F_x F_y with d/dy, and 2 pi F_x with the quadrature.
        const auto slope = [&](std::size_t axis) {
            return std::hypot(pi / std::sqrt(3), 2 * pi * wave[axis]);
        };
        const double x = slope(0), y = slope(1), z = slope(2);
        fmt::print("at {}\n", place);
        test::check_laws(
            quarter, [&] { return numbers_of(test::solid.field(solid_sample(random, place))); },
            {sum_of("noise", 1, {{1}}), sum_of("quadrature", 1, {{0}}),
             sum_of("their sum", sqrt2, {{0}, {1}}), sum_of("d/dx", x, {{2}}), sum_of("d/dy", y, {{3}}),
             sum_of("d/dz", z, {{4}}),
             sum_of("d/dx + d/dy", std::sqrt(2 + 8 * pi * pi * wave[0] * wave[1] / (x * y)),
                    {{2, 1 / x}, {3, 1 / y}}),
             sum_of("quadrature + d/dx", std::sqrt(2 + 4 * pi * wave[0] / x), {{0}, {2, 1 / x}})});
    }
    for (const Vector& lag : {Vector{0.3, 0, 0}, {0, 0.7, 0.7}, {0.5, -0.5, 1}, {1.5, 0, 0.4}}) {
        const Vector local{0.25, 0.5, 0};
        check_pairs(fmt::format("lag {}", lag), covariance(solid_sample(random, local), lag), [&] {
            const Sample s = solid_sample(random, local);
            return std::array{test::solid.field(s).noise, test::solid.field(moved(s, lag)).noise};
        });
    }
}

TEST_CASE("isotropic noise in the plane and its gradient are normal at fixed points", "[law]") {
    Random random(62);
    for (const float frequency : {0.0f, 1.0f, 4.0f}) {
        for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {0.5f, 0.5f}, {0.25f, 0.0f}}) {
            fmt::print("isotropic, frequency {}, at ({}, {})\n", frequency, x, y);
            test::check_laws(
                quarter,
                [&, x = x, y = y] {
                    const auto field = n.gabor_field_isotropic(
                        n.gabor_place({random.cell(), random.cell()}, {x, y}), frequency, random.word());
                    return std::array{field.quadrature, field.noise, field.gradient.x, field.gradient.y};
                },
                of_isotropic(test::isotropic_slope(frequency), {{2}}, {3}));
        }
    }
}

TEST_CASE("isotropic noise in 3D and on surfaces and its gradient are normal at fixed points", "[law]") {
    constexpr Vector node{0, 0, 0}, middle{0.5, 0.5, 0.5}, other{0.25, 0.5, 0};
    struct Where {
        const char* name;
        Vector place;
        Vector normal{0, 0, 0}; // normal of the surface, if any
    };
    for (const auto& [name, place, normal] :
         {Where{"in 3D, at a node", node}, Where{"in 3D, elsewhere", other},
          Where{"at a pole", node, {0, 0, 1}}, Where{"between two frames", middle, {0.6, 0, 0.8}}}) {
        Random random(42);
        // The variance of the derivative along an axis or a tangent is pi^2 / 3 from the windows, plus 4/3
        // pi^2 F^2 in 3D or 2 pi^2 F^2 on a surface from the waves. One tangent is in the x-z plane, the
        // other is the y axis.
        const bool on_surface = normal[2] != 0;
        const double slope = std::sqrt(pi * pi / 3 + pi * pi * (on_surface ? 2 : 4.0 / 3));
        const double x = on_surface ? normal[2] : 1, z = on_surface ? -normal[0] : 0;
        fmt::print("isotropic {}\n", name);
        test::check_laws(
            quarter,
            [&, place = place, normal = normal] {
                Sample s = solid_sample(random, place);
                s.normal = normal;
                return numbers_of((on_surface ? test::isotropic_surface : test::isotropic_3d).field(s));
            },
            of_isotropic(slope, {{2, x}, {4, z}}, {3}));
    }
}

// The covariance is that of the windows times the transform of the spectrum: J_0(t) for a uniform ring, and
// sin(t) / t for a uniform shell, with t = 2 pi F |lag|.
TEST_CASE("the covariance of isotropic noise is that of a uniform ring or shell of waves, in every direction",
          "[law]") {
    Random random(35);
    test::Largest plane, solid;
    const auto check = [&](test::Largest& largest, double frequency, double turns, auto lag, double spectrum,
                           const auto& noise) {
        const std::string name =
            fmt::format("frequency {}, {} turns away, along {:.2f}", frequency, turns, fmt::join(lag, " "));
        double expected = spectrum;
        for (double& along : lag) {
            along *= turns / frequency;
            expected *= noise::hann_correlation(along);
            along *= 1.5; // nodes
        }
        const auto pair = [&] {
            auto s = test::somewhere<std::tuple_size_v<decltype(lag)>>(random, frequency);
            const auto first = noise.field(s);
            s.place.local = noise::sum(1, s.place.local, 1, lag);
            const auto second = noise.field(s);
            return std::array{first.quadrature, first.noise, second.quadrature, second.noise};
        };
        test::check_covariance(largest, pair, expected, name);
    };
    for (const double frequency : {0.5, 5.0})
        for (const double turns : {0.25, 0.6})
            for (const double degrees : {0.0, 15.0, 45.0})
                check(plane, frequency, turns,
                      std::array{std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)},
                      std::cyl_bessel_j(0.0, 2 * pi * turns), test::isotropic);
    for (const double frequency : {0.5, 3.0})
        for (const double turns : {0.25, 0.7})
            for (const Vector& direction :
                 {Vector{1, 0, 0}, noise::unit(Vector{1, -1, 1}), noise::unit(Vector{1, 2, 3})})
                check(solid, frequency, turns, direction, std::sin(2 * pi * turns) / (2 * pi * turns),
                      test::isotropic_3d);
    plane.check("in the plane, in units of 4.5 standard errors");
    solid.check("in 3D, in units of 4.5 standard errors");
}

// The value has variance 1, and the gradient has the covariance
//     sum (grad h grad h^T + 4 pi^2 h^2 F F^T) / (sum h^2)^2.
TEST_CASE("noise with a different wave at each node is normal at every point", "[law]") {
    Random random(3);
    for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {0.5f, 0.5f}, {0.25f, -0.4f}, {-0.5f, 0.1f}}) {
        test::Lattice3::GaborWaves waves;
        double xx = 0, yy = 0, xy = 0;
        for (int k = 0; k < 9; ++k) {
            waves.wave[k] = random.uniform<gabor_vec2>(-1.5, 1.5);
            const double dx = double{x} - std::floor(x + 0.5f) - k % 3 + 1;
            const double dy = double{y} - std::floor(y + 0.5f) - k / 3 + 1;
            const auto across = noise::lattice_window(3, dx / 1.5),
                       along = noise::lattice_window(3, dy / 1.5);
            const double hx = across.slope * along.value, hy = across.value * along.slope;
            const double turns = 2 * pi * across.value * along.value;
            const double fx = turns * waves.wave[k].x, fy = turns * waves.wave[k].y;
            constexpr double energy = 81.0 / 64; // (sum h^2)^2
            xx += (hx * hx + fx * fx) / energy;
            yy += (hy * hy + fy * fy) / energy;
            xy += (hx * hy + fx * fy) / energy;
        }
        const double sx = std::sqrt(xx), sy = std::sqrt(yy);
        fmt::print("along a map, at ({}, {})\n", x, y);
        test::check_laws(
            quarter,
            [&, x = x, y = y] {
                const auto field = n.gabor_field_waves(n.gabor_place({12, 12}, {x, y}), waves, random.word());
                return std::array{field.noise, field.gradient.x, field.gradient.y};
            },
            {sum_of("noise", 1, {{0}}), sum_of("d/dx", sx, {{1}}), sum_of("d/dy", sy, {{2}}),
             sum_of("d/dx + d/dy", std::sqrt(2 + 2 * xy / (sx * sy)), {{1, 1 / sx}, {2, 1 / sy}}),
             sum_of("noise + d/dx", sqrt2, {{0}, {1, 1 / sx}}),
             sum_of("noise + d/dy", sqrt2, {{0}, {2, 1 / sy}})});
    }
}
