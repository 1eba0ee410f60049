// Checks over independent instances that the lattice's noises, in the plane, in space and on surfaces, are
// normal at each point and jointly.

#include "law.hpp"
#include "noise.hpp"

#include <boost/math/distributions/normal.hpp>
#include <fmt/ranges.h>

using namespace gabor;
using std::numbers::pi;
using std::numbers::sqrt2;
using test::Laws;
using test::place_of;
using test::Random;
using test::Sample3d;
using test::Statistic;
using test::sum_of;
using Vector = noise::Vector<3>;

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
void check_joint(Functions n) {
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
                         const auto complex = n.gabor_noise_complex(p, fixed_frequency, orientation, seed);
                         const auto phasor = n.gabor_phasor(complex);
                         const auto gradient = n.gabor_noise_gradient(p, fixed_frequency, orientation, seed);
                         const auto four = n.gabor_noise_four(p, fixed_frequency, orientation, seed);
                         return std::array{complex.x, complex.y, gradient.y, gradient.z, phasor.x,
                                           phasor.y,  four.x,    four.y,     four.z,     four.w};
                     },
                     {sum_of("noise", 1, {{1}}),
                      sum_of("quadrature", 1, {{0}}),
                      sum_of("noise + quadrature", sqrt2, {{0}, {1}}),
                      sum_of("d/dx", x, {{2}}),
                      sum_of("d/dy", y, {{3}}),
                      {"phase, mapped to normal", 1, [&](std::span<const float> a) { return normal(a[4]); }},
                      {"intensity, mapped to normal", 1,
                       [&](std::span<const float> a) { return -normal(std::exp(-0.5 * a[5] * a[5])); }},
                      sum_of("four, first + second", sqrt2, {{6}, {7}}),
                      sum_of("four, third - fourth", sqrt2, {{8}, {9, -1}}),
                      sum_of("four, the sum", 2, {{6}, {7}, {8}, {9}})});
    test::check_laws(half,
                     [&] {
                         const gabor_vec2 p = anywhere(random), tile = random.uniform<gabor_vec2>(0.3, 4.3);
                         const std::uint32_t seed = random.word();
                         return std::array{n.gabor_noise_tiled(p, tile, fixed_frequency, orientation, seed),
                                           n.gabor_noise_animated(p, random.uniform(0, 1), fixed_frequency,
                                                                  orientation, seed)};
                     },
                     {sum_of("tiles of any period", 1, {{0}}), sum_of("at any time", 1, {{1}})});
    for (int lag = 1; lag < 10; lag += 2) {
        const double angle = 0.7 * lag, length = 0.08 * (lag + 1);
        const gabor_vec2 step(static_cast<float>(length * std::cos(angle)),
                              static_cast<float>(length * std::sin(angle)));
        const double turns =
            fixed_frequency * (step.x * std::cos(orientation) + step.y * std::sin(orientation));
        check_pairs(fmt::format("lag ({:.2f}, {:.2f})", step.x, step.y),
                    noise::hann_correlation(step.x) * noise::hann_correlation(step.y) *
                        std::cos(2 * pi * turns),
                    [&] {
                        const gabor_vec2 p = random.uniform<gabor_vec2>(0, 100);
                        const std::uint32_t seed = random.word();
                        return std::array{n.gabor_noise(p, fixed_frequency, orientation, seed),
                                          n.gabor_noise(p + step, fixed_frequency, orientation, seed)};
                    });
    }
}

// ---- In space

test::Lattice3 n;

// Returns a sample at an offset from the corner of any cell.
Sample3d solid_sample(Random& random, const std::array<float, 3>& local) {
    Sample3d sample;
    sample.place.cell = {random.cell(), random.cell(), random.cell()};
    sample.place.local = {local[0], local[1], local[2]};
    sample.frequency = 1;
    sample.direction = {0.6f, 0.48f, 0.64f};
    sample.seed = random.word();
    return sample;
}

Sample3d moved(Sample3d sample, const std::array<double, 3>& nodes) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        sample.place.local[axis] += nodes[axis];
    return sample;
}

auto field_of(const Sample3d& s) {
    return n.gabor_field_3d(place_of(n, s.place), s.frequency, s.direction, s.seed);
}

// Returns the quadrature, the noise and the noise's slopes.
std::array<float, 5> numbers_of(const test::Lattice3::GaborField3d& field) {
    return {field.quadrature, field.noise, field.gradient.x, field.gradient.y, field.gradient.z};
}

// The covariance of the noise at two points that are `lag` node spacings apart, from the nodes whose windows
// reach both.
double covariance(const Sample3d& sample, const std::array<double, 3>& lag) {
    double product = 1, turns = 0;
    const Vector direction = noise::unit(test::wide(sample.direction));
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

TEST_CASE("the lattice noise is normal at each of 16 x 16 points of a cell, and of 4 x 4 x 4 in space",
          "[law]") {
    const auto in_plane = [](auto functions) {
        return [functions](const auto& place, float frequency, const auto& direction,
                           std::uint32_t seed) mutable {
            const auto kernel =
                functions.gabor_kernel_wave(test::narrow(noise::scaled(frequency, direction)));
            const auto [x, y] = functions.gabor_field(place_of(functions, place), kernel, seed).value;
            return std::array{x, y};
        };
    };
    check_cell<2>(3, 16, in_plane(test::Lattice3()));
    check_cell<2>(4, 16, in_plane(test::Lattice4()));
    check_cell<3>(3, 4, [](const auto& place, float frequency, const auto& direction, std::uint32_t seed) {
        const auto field = n.gabor_field_3d(place_of(n, place), frequency, test::narrow(direction), seed);
        return std::array{field.quadrature, field.noise};
    });
}

TEST_CASE("the lattice noise, its gradient, quadrature and phasor, the noises of gabor_noise_four, and "
          "values at pairs of points are jointly normal",
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
    std::vector<std::array<float, 3>> normals;
    for (int i = 0; i < 32; ++i) {
        const gabor_vec3 normal = test::narrow(test::random_unit<3>(random));
        normals.push_back({normal.x, normal.y, normal.z});
    }
    for (const bool isotropic : {false, true}) {
        Laws laws(normals);
        laws.add(test::law_samples() / 4, [&](std::size_t k) {
            Sample3d s =
                solid_sample(random, {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
            s.normal = {normals[k][0], normals[k][1], normals[k][2]};
            s.direction = test::narrow(test::random_unit<3>(random));
            if (random.word() % 2) // near the normal, where the function switches to another direction
                s.direction = s.normal + 0.45f * s.direction;
            const auto field =
                isotropic
                    ? n.gabor_field_surface_isotropic(place_of(n, s.place), s.normal, s.frequency, s.seed)
                    : n.gabor_field_surface(place_of(n, s.place), s.normal, s.frequency, s.direction, s.seed);
            return std::array{field.quadrature, field.noise};
        });
        laws.check(isotropic ? "surface, isotropic" : "surface");
    }
}

TEST_CASE("lattice noise in space is jointly normal with its gradient and quadrature, at pairs of points, "
          "and in gabor_noise_3d_four",
          "[law]") {
    Random random(41);
    for (const auto& place : {std::array{0.0f, 0.0f, 0.0f}, {0.5f, 0.5f, 0.5f}, {0.25f, 0.5f, 0.0f}}) {
        const Vector wave = noise::unit(test::wide(solid_sample(random, place).direction));
        // sum h'^2 = pi^2 / 4 * 3/2 and sum h^2 = 9/8 along an axis, so d/dx has the variance pi^2 / 3 +
        // (2 pi F_x)^2, the covariance 4 pi^2 F_x F_y with d/dy, and 2 pi F_x with the quadrature.
        const auto slope = [&](std::size_t axis) {
            return std::hypot(pi / std::sqrt(3), 2 * pi * wave[axis]);
        };
        const double x = slope(0), y = slope(1), z = slope(2);
        fmt::print("at {}\n", place);
        test::check_laws(
            quarter, [&] { return numbers_of(field_of(solid_sample(random, place))); },
            {sum_of("noise", 1, {{1}}), sum_of("quadrature", 1, {{0}}),
             sum_of("their sum", sqrt2, {{0}, {1}}), sum_of("d/dx", x, {{2}}), sum_of("d/dy", y, {{3}}),
             sum_of("d/dz", z, {{4}}),
             sum_of("d/dx + d/dy", std::sqrt(2 + 8 * pi * pi * wave[0] * wave[1] / (x * y)),
                    {{2, 1 / x}, {3, 1 / y}}),
             sum_of("quadrature + d/dx", std::sqrt(2 + 4 * pi * wave[0] / x), {{0}, {2, 1 / x}})});
    }
    for (const auto& lag : {std::array{0.3, 0.0, 0.0}, {0.0, 0.7, 0.7}, {0.5, -0.5, 1.0}, {1.5, 0.0, 0.4}}) {
        const std::array local{0.25f, 0.5f, 0.0f};
        check_pairs(fmt::format("lag {}", lag), covariance(solid_sample(random, local), lag), [&] {
            const Sample3d s = solid_sample(random, local);
            return std::array{field_of(s).noise, field_of(moved(s, lag)).noise};
        });
    }
    fmt::print("four at a node\n");
    test::check_laws(
        quarter,
        [&] {
            const gabor_vec3 node(2.0f / 3 * static_cast<float>(random.word() % 99), 2, 4);
            const auto four = n.gabor_noise_3d_four(node, 1, {0.6f, 0.48f, 0.64f}, random.word());
            return std::array{four.x, four.y, four.z, four.w};
        },
        {sum_of("first + second", sqrt2, {{0}, {1}}), sum_of("third - fourth", sqrt2, {{2}, {3, -1}}),
         sum_of("all four", 2, {{0}, {1}, {2}, {3}})});
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
                    return std::array{field.value.x, field.value.y, field.slope_x.y, field.slope_y.y};
                },
                of_isotropic(test::isotropic_slope(frequency), {{2}}, {3}));
        }
    }
}

TEST_CASE("isotropic noise in space and on surfaces and its gradient are normal at fixed points", "[law]") {
    constexpr std::array node{0.0f, 0.0f, 0.0f}, middle{0.5f, 0.5f, 0.5f}, other{0.25f, 0.5f, 0.0f};
    struct Where {
        const char* name;
        std::array<float, 3> place;
        gabor_vec3 normal{0, 0, 0}; // normal of the surface, if any
    };
    for (const auto& [name, place, normal] :
         {Where{"in space, at a node", node}, Where{"in space, elsewhere", other},
          Where{"at a pole", node, {0, 0, 1}}, Where{"between two frames", middle, {0.6f, 0, 0.8f}}}) {
        Random random(42);
        // The variance of the derivative along an axis or a tangent is pi^2 / 3 from the windows, plus 4/3
        // pi^2 F^2 in space or 2 pi^2 F^2 on a surface from the waves. One tangent is in the x-z plane, the
        // other is the y axis.
        const bool on_surface = normal.z != 0;
        const double slope = std::sqrt(pi * pi / 3 + pi * pi * (on_surface ? 2 : 4.0 / 3));
        const double x = on_surface ? normal.z : 1, z = on_surface ? -normal.x : 0;
        fmt::print("isotropic {}\n", name);
        test::check_laws(
            quarter,
            [&, place = place, normal = normal] {
                const Sample3d s = solid_sample(random, place);
                return numbers_of(
                    on_surface ? n.gabor_field_surface_isotropic(place_of(n, s.place), normal, 1, s.seed)
                               : n.gabor_field_3d_isotropic(place_of(n, s.place), 1, s.seed));
            },
            of_isotropic(slope, {{2, x}, {4, z}}, {3}));
    }
}

// The covariance is that of the windows times the transform of the spectrum: J_0(t) for a uniform ring, and
// sin(t) / t for a uniform shell, with t = 2 pi F |lag|.
TEST_CASE("the covariance of isotropic noise is that of a uniform ring or shell of waves, in every direction",
          "[law]") {
    Random random(35);
    test::Largest plane, space;
    const auto check = [&](test::Largest& largest, double frequency, double turns, auto lag, double spectrum,
                           const auto& pair) {
        const std::string name =
            fmt::format("frequency {}, {} turns away, along {:.2f}", frequency, turns, fmt::join(lag, " "));
        double expected = spectrum;
        for (double& along : lag) {
            along *= turns / frequency;
            expected *= noise::hann_correlation(along);
            along *= 1.5; // nodes
        }
        test::check_covariance(
            largest, [&] { return pair(lag, static_cast<float>(frequency)); }, expected, name);
    };
    for (const double frequency : {0.5, 5.0})
        for (const double turns : {0.25, 0.6})
            for (const double degrees : {0.0, 15.0, 45.0})
                check(plane, frequency, turns,
                      std::array{std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)},
                      std::cyl_bessel_j(0.0, 2 * pi * turns), [&](const auto& lag, float f) {
                          auto place =
                              n.gabor_place({random.cell(), random.cell()}, random.uniform<gabor_vec2>(0, 1));
                          const std::uint32_t seed = random.word();
                          const auto first = n.gabor_field_isotropic(place, f, seed).value;
                          place.local = place.local +
                                        gabor_vec2(static_cast<float>(lag[0]), static_cast<float>(lag[1]));
                          const auto second = n.gabor_field_isotropic(place, f, seed).value;
                          return std::array{first.x, first.y, second.x, second.y};
                      });
    for (const double frequency : {0.5, 3.0})
        for (const double turns : {0.25, 0.7})
            for (const Vector& direction :
                 {Vector{1, 0, 0}, noise::unit(Vector{1, -1, 1}), noise::unit(Vector{1, 2, 3})})
                check(space, frequency, turns, direction, std::sin(2 * pi * turns) / (2 * pi * turns),
                      [&](const Vector& lag, float f) {
                          const Sample3d s = solid_sample(
                              random, {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
                          const auto first = n.gabor_field_3d_isotropic(place_of(n, s.place), f, s.seed);
                          const auto second =
                              n.gabor_field_3d_isotropic(place_of(n, moved(s, lag).place), f, s.seed);
                          return std::array{first.quadrature, first.noise, second.quadrature, second.noise};
                      });
    plane.check("in the plane, in units of 4.5 standard errors");
    space.check("in space, in units of 4.5 standard errors");
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
                return std::array{field.value.y, field.slope_x.y, field.slope_y.y};
            },
            {sum_of("noise", 1, {{0}}), sum_of("d/dx", sx, {{1}}), sum_of("d/dy", sy, {{2}}),
             sum_of("d/dx + d/dy", std::sqrt(2 + 2 * xy / (sx * sy)), {{1, 1 / sx}, {2, 1 / sy}}),
             sum_of("noise + d/dx", sqrt2, {{0}, {1, 1 / sx}}),
             sum_of("noise + d/dy", sqrt2, {{0}, {2, 1 / sy}})});
    }
}
