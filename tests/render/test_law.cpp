// The distributions of the noises of the lattice over independent instances, in the plane, in space and on
// surfaces: normal at each place and jointly. GABOR_LAW_SAMPLES sets the number of samples per statistic.

#include "isotropic_sampler.hpp"
#include "lattice_sampler.hpp"
#include "law.hpp"
#include "reference/normal_mean.hpp"
#include "sampler_lattice_3d.hpp"
#include "statistics/estimate.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace gabor;
using std::numbers::pi;
using std::numbers::sqrt2;
using test::Draw;
using test::Entry3d;
using test::Laws;
using test::Statistic;
using test::sum_of;
using test::Wanted;
using Vector = noise::Lattice3d::Vector;

namespace {

constexpr std::size_t per_batch = 1 << 17;
constexpr double half = 0.5, quarter = 0.25; // of the samples

// ---- Samples in another instance

template <typename Sample> // in the plane
Sample elsewhere(Sample sample, Draw& draw) {
    for (std::int32_t& cell : sample.cell)
        cell = draw.cell();
    sample.seed = draw.word();
    return sample;
}

test::LatticeSample3d elsewhere(test::LatticeSample3d sample, Draw& draw) {
    sample.place.cell = {draw.cell(), draw.cell(), draw.cell()};
    sample.seed = draw.word();
    return sample;
}

// The sample, and a second one `lag` nodes away.
template <typename Sample, typename Lag>
std::array<Sample, 2> pair(const Sample& sample, const Lag& lag) {
    std::array both{sample, sample};
    for (std::size_t axis = 0; axis < lag.size(); ++axis) {
        if constexpr (std::is_same_v<Sample, test::LatticeSample3d>)
            both[1].place.local[axis] += static_cast<float>(lag[axis]);
        else
            both[1].local[axis] += static_cast<float>(lag[axis]);
    }
    return both;
}

// ---- In the plane

constexpr float frequency = 1.5;
constexpr float orientation = 0.4f;

test::LatticeSample plane_sample(Draw& draw) {
    test::LatticeSample s{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        s.local[axis] = s.p[axis] = draw.uniform(0, 1000);
        s.radius[axis] = 1.5f;
        s.tile[axis] = draw.uniform(0.3, 4.3);
    }
    s.frequency = frequency;
    s.orientation = orientation;
    s.time = draw.uniform(0, 1);
    s.seed = draw.word();
    return s;
}

// The index of a LatticeAnswer member among its floats.
std::size_t number(auto test::LatticeAnswer::*member, std::size_t component = 0) {
    const test::LatticeAnswer answer{};
    return static_cast<std::size_t>(reinterpret_cast<const float*>(&(answer.*member)) -
                                    reinterpret_cast<const float*>(&answer)) +
           component;
}

// The sum and the difference of a number of two samples.
std::vector<Statistic> sum_and_difference(std::size_t first, std::size_t second, double covariance) {
    return {sum_of("sum", std::sqrt(2 + 2 * covariance), {{first}, {second}}),
            sum_of("difference", std::sqrt(2 - 2 * covariance), {{first}, {second, -1}})};
}

// ---- In space

test::LatticeSample3d solid_sample(const std::array<float, 3>& local) {
    test::LatticeSample3d sample;
    sample.place.local = local;
    sample.frequency = 1;
    sample.direction = {0.6f, 0.48f, 0.64f};
    return sample;
}

// The covariance of two places along the lattice's axes, from the windows of the nodes that reach both.
double covariance(const test::LatticeSample3d& sample, const std::array<float, 3>& lag) {
    double product = 1, turns = 0;
    const Vector direction = test::unit(sample.direction);
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

// Both parts of a noise and the gradient's components of equal deviation are jointly normal.
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

TEST_CASE("the lattice noise is normal at each of 16 x 16 places of a cell", "[law]") {
    const vulkan::Device device;
    struct Waves {
        float frequency, orientation;
        bool tiled;
    };
    const auto places = test::places_of_cell(16, 2);
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        Draw draw(8);
        Laws all(places);
        fmt::print("{} taps on {}\n", taps, device.info().name);
        for (const auto& [frequency, orientation, tiled] : {Waves{4, 0, false},
                                                            {4, 0.4f, false},
                                                            {4, 0.785398f, false},
                                                            {4, 1.1f, false},
                                                            {0, 0.4f, false},
                                                            {0.05f, 0.4f, false},
                                                            {0.7f, 0.4f, false},
                                                            {30, 0.4f, false},
                                                            {1.5f, 0.4f, true}}) {
            const auto sample = [&, frequency = frequency, orientation = orientation](std::size_t place) {
                test::LatticeSample s = elsewhere(plane_sample(draw), draw);
                s.frequency = frequency;
                s.orientation = orientation;
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    s.local[axis] = places[place][axis];
                    const auto least = static_cast<float>(taps);
                    const float nodes = std::max(std::floor(s.tile[axis] * 0.5f * least + 0.5f), least);
                    s.p[axis] =
                        (std::floor(nodes * draw.uniform(0, 1)) + s.local[axis]) * s.tile[axis] / nodes;
                }
                return s;
            };
            Laws laws(places);
            laws.add(sampler, tiled ? Wanted::moving : Wanted::at, test::law_samples() / 8, sample,
                     {number(tiled ? &test::LatticeAnswer::tiled : &test::LatticeAnswer::at)});
            laws.check(fmt::format("frequency {}, orientation {}{}", frequency, orientation,
                                   tiled ? ", tiles" : ""));
            all.merge(laws);
        }
        all.check("all waves");
    }
}

TEST_CASE("noise on the lattice in space is normal at each of 4 x 4 x 4 places of a cell", "[law]") {
    const vulkan::Device device;
    test::LatticeSampler3d sampler(device, per_batch, Entry3d::field);
    Draw draw(30);
    const auto places = test::places_of_cell(4, 3);
    Laws all(places);
    struct Waves {
        float frequency;
        bool tiled;
    };
    for (const auto& [frequency, tiled] :
         {Waves{0, false}, {0.7f, false}, {4, false}, {30, false}, {1.5f, true}}) {
        const auto sample = [&, frequency = frequency, tiled = tiled](std::size_t place) {
            test::LatticeSample3d s;
            s.frequency = frequency;
            s.direction = test::narrow(test::random_unit(draw));
            std::ranges::copy(places[place], s.place.local.begin());
            for (std::size_t axis = 0; tiled && axis < 3; ++axis) {
                s.place.period[axis] = 3 + static_cast<std::int32_t>(draw.word() % 9);
                s.place.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
            }
            return elsewhere(s, draw);
        };
        Laws laws(places);
        laws.add(sampler, Wanted::all, test::law_samples() / 8, sample, {0, 1});
        laws.check(fmt::format("frequency {}{}", frequency, tiled ? ", tiles" : ""));
        all.merge(laws);
    }
    all.check("all waves");
}

TEST_CASE("surface noise on the lattice is normally distributed for every surface normal", "[law]") {
    const vulkan::Device device;
    Draw draw(32);
    std::vector<std::array<float, 3>> normals(32);
    for (auto& normal : normals)
        normal = test::narrow(test::random_unit(draw));
    for (const Entry3d entry : {Entry3d::surface, Entry3d::surface_isotropic}) {
        test::LatticeSampler3d sampler(device, per_batch, entry);
        Laws laws(normals);
        const auto sample = [&](std::size_t k) {
            auto s = solid_sample({draw.uniform(0, 1), draw.uniform(0, 1), draw.uniform(0, 1)});
            s.normal = normals[k];
            s.direction = test::narrow(test::random_unit(draw));
            const bool near = draw.word() % 2; // near the normal, where another direction takes over
            for (std::size_t axis = 0; near && axis < 3; ++axis)
                s.direction[axis] = s.normal[axis] + 0.45f * s.direction[axis];
            return elsewhere(s, draw);
        };
        laws.add(sampler, Wanted::all, test::law_samples() / 4, sample, {0, 1});
        laws.check(entry == Entry3d::surface ? "surface" : "surface, isotropic");
    }
}

TEST_CASE("the lattice noise, its gradient, quadrature, phasor and four are jointly normal", "[law]") {
    const vulkan::Device device;
    // E[n_x^2] = (2 pi F_x)^2 + sum h'^2 / sum h^2, and the latter is pi^2 / 3.
    const double x = std::hypot(2 * pi * frequency * std::cos(orientation), pi / std::sqrt(3));
    const double y = std::hypot(2 * pi * frequency * std::sin(orientation), pi / std::sqrt(3));
    using A = test::LatticeAnswer;
    const std::size_t complex = number(&A::complex), gradient = number(&A::gradient), four = number(&A::four);
    const auto normal = [](double u) { return statistics::normal_quantile(std::clamp(u, 1e-9, 1 - 1e-9)); };
    const std::vector<Statistic> statistics{
        sum_of("noise", 1, {{complex + 1}}),
        sum_of("quadrature", 1, {{complex}}),
        sum_of("noise + quadrature", sqrt2, {{complex}, {complex + 1}}),
        sum_of("d/dx", x, {{gradient}}),
        sum_of("d/dy", y, {{gradient + 1}}),
        {"phase, made normal", 1,
         [&, phase = number(&A::phasor)](std::span<const float> a) { return normal(a[phase]); }},
        {"intensity, made normal", 1,
         [&, at = number(&A::phasor, 1)](std::span<const float> a) {
             return -normal(std::exp(-0.5 * a[at] * a[at]));
         }},
        sum_of("four, first + second", sqrt2, {{four}, {four + 1}}),
        sum_of("four, third - fourth", sqrt2, {{four + 2}, {four + 3, -1}}),
        sum_of("four, the sum", 2, {{four}, {four + 1}, {four + 2}, {four + 3}})};
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        Draw draw(9);
        fmt::print("{} taps on {}\n", taps, device.info().name);
        check_laws(
            sampler, half, Wanted::four, [&] { return std::array{plane_sample(draw)}; }, statistics);
    }
}

TEST_CASE("tiled and animated lattice noise are normal too", "[law]") {
    const vulkan::Device device;
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        Draw draw(10);
        check_laws(sampler, half, Wanted::moving, [&] { return std::array{plane_sample(draw)}; },
                   {sum_of("tiles of any period", 1, {{number(&test::LatticeAnswer::tiled)}}),
                    sum_of("at any time", 1, {{number(&test::LatticeAnswer::animated)}})});
    }
}

TEST_CASE("pairs of values of the lattice noise are jointly normal", "[law]") {
    const vulkan::Device device;
    const std::size_t at = number(&test::LatticeAnswer::at), next = sizeof(test::LatticeAnswer) / 4;
    for (const int taps : {3, 4}) {
        test::LatticeSampler sampler(device, taps, per_batch);
        Draw draw(11);
        for (int lag = 1; lag < 10; lag += 2) {
            const double angle = 0.7 * lag;
            const double x = 0.08 * (lag + 1) * std::cos(angle);
            const double y = 0.08 * (lag + 1) * std::sin(angle);
            const double turns = frequency * (x * std::cos(orientation) + y * std::sin(orientation));
            fmt::print("{} taps, lag ({:.2f}, {:.2f})\n", taps, x, y);
            check_laws(
                sampler, quarter, Wanted::at,
                [&] {
                    return pair(plane_sample(draw), std::array{x * taps / 2, y * taps / 2});
                },
                sum_and_difference(at, next + at,
                                   noise::hann_correlation(x) * noise::hann_correlation(y) *
                                       std::cos(2 * pi * turns)));
        }
    }
}

TEST_CASE("the lattice noise at two times is jointly normal with correlation cos^2(pi lag)", "[law]") {
    const vulkan::Device device;
    test::LatticeSampler sampler(device, 3, per_batch);
    Draw draw(13);
    const std::size_t at = number(&test::LatticeAnswer::animated), next = sizeof(test::LatticeAnswer) / 4;
    for (const float lag : {0.05f, 0.16f, 0.25f, 0.5f}) {
        fmt::print("time lag {}\n", lag);
        check_laws(
            sampler, quarter, Wanted::moving,
            [&] {
                std::array both{plane_sample(draw), test::LatticeSample{}};
                both[1] = both[0];
                both[1].time += lag;
                return both;
            },
            sum_and_difference(at, next + at, std::pow(std::cos(pi * lag), 2)));
    }
}

TEST_CASE("noise on the lattice in space is jointly normal with its gradient and quadrature, pairs of places "
          "and four noises are",
          "[law]") {
    const vulkan::Device device;
    test::LatticeSampler3d sampler(device, per_batch, Entry3d::field);
    Draw draw(41);
    for (const auto& place : {std::array{0.0f, 0.0f, 0.0f}, {0.5f, 0.5f, 0.5f}, {0.25f, 0.5f, 0.0f}}) {
        const test::LatticeSample3d sample = solid_sample(place);
        const Vector wave = test::unit(sample.direction);
        // sum h'^2 = pi^2 / 4 * 3/2 and sum h^2 = 9/8 along an axis, so a slope has the variance
        // pi^2 / 3 + (2 pi F)^2, and two of them covary by 4 pi^2 F_x F_y. d/dx of one part and the other
        // part itself covary by 2 pi F_x.
        const auto slope = [&](std::size_t axis) {
            return std::hypot(pi / std::sqrt(3), 2 * pi * wave[axis]);
        };
        const double x = slope(0), y = slope(1), z = slope(2);
        fmt::print("at {}\n", place);
        check_laws(sampler, quarter, Wanted::all, [&] { return std::array{elsewhere(sample, draw)}; },
                   {sum_of("noise", 1, {{1}}), sum_of("quadrature", 1, {{0}}),
                    sum_of("their sum", sqrt2, {{0}, {1}}), sum_of("d/dx", x, {{3}}),
                    sum_of("d/dy", y, {{5}}), sum_of("d/dz", z, {{7}}),
                    sum_of("d/dx + d/dy", std::sqrt(2 + 8 * pi * pi * wave[0] * wave[1] / (x * y)),
                           {{3, 1 / x}, {5, 1 / y}}),
                    sum_of("quadrature + d/dx", std::sqrt(2 + 4 * pi * wave[0] / x), {{0}, {3, 1 / x}})});
    }
    for (const auto& lag :
         {std::array{0.3f, 0.0f, 0.0f}, {0.0f, 0.7f, 0.7f}, {0.5f, -0.5f, 1.0f}, {1.5f, 0.0f, 0.4f}}) {
        const test::LatticeSample3d first = solid_sample({0.25f, 0.5f, 0});
        fmt::print("lag {}\n", lag);
        check_laws(
            sampler, quarter, Wanted::all, [&] { return pair(elsewhere(first, draw), lag); },
            sum_and_difference(1, 10, covariance(first, lag)));
    }
    fmt::print("four at a node\n");
    check_laws(sampler, quarter, Wanted::all,
               [&] {
                   std::array<test::LatticeSample3d, 4> four{};
                   four.fill(elsewhere(solid_sample({}), draw));
                   for (int channel = 1; channel < 4; ++channel)
                       four.at(static_cast<std::size_t>(channel)).seed =
                           noise::lattice_lobe_seed(four[0].seed, -channel);
                   return four;
               },
               {sum_of("first + second", sqrt2, {{1}, {10}}),
                sum_of("third - fourth", sqrt2, {{19}, {28, -1}}),
                sum_of("all four", 2, {{1}, {10}, {19}, {28}})});
}

TEST_CASE("isotropic noise in the plane and its gradient are normal at fixed places", "[law]") {
    const vulkan::Device device;
    test::IsotropicSampler sampler(device, per_batch);
    Draw draw(62);
    for (const float frequency : {0.0f, 1.0f, 4.0f}) {
        for (const auto& [x, y] : {std::array{0.0f, 0.0f}, {0.5f, 0.5f}, {0.25f, 0.0f}}) {
            fmt::print("isotropic, frequency {}, at ({}, {})\n", frequency, x, y);
            test::IsotropicSample sample{{}, {x, y}};
            sample.frequency = frequency;
            check_laws(
                sampler, half, test::Part::field, [&] { return std::array{elsewhere(sample, draw)}; },
                of_isotropic(test::isotropic_slope(frequency), {{3}}, {5}));
        }
    }
}

TEST_CASE("isotropic noise in space and on surfaces and its gradient are normal at fixed places", "[law]") {
    const vulkan::Device device;
    constexpr std::array node{0.0f, 0.0f, 0.0f}, middle{0.5f, 0.5f, 0.5f}, other{0.25f, 0.5f, 0.0f};
    struct Where {
        const char* name;
        Entry3d entry;
        std::array<float, 3> place;
        std::array<float, 3> normal{}; // of a surface
    };
    for (const auto& [name, entry, place, normal] :
         {Where{"in space, at a node", Entry3d::isotropic, node},
          Where{"in space, in a middle", Entry3d::isotropic, middle},
          Where{"in space, elsewhere", Entry3d::isotropic, other},
          Where{"on a surface", Entry3d::surface_isotropic, other, {0.8f, 0, 0.6f}},
          Where{"at a pole", Entry3d::surface_isotropic, node, {0, 0, 1}},
          Where{"between two frames", Entry3d::surface_isotropic, middle, {0.6f, 0, 0.8f}}}) {
        test::LatticeSampler3d sampler(device, per_batch, entry);
        Draw draw(42);
        // Variance of the derivative along any axis, or along a tangent: the waves contribute 4/3 pi^2 F^2 in
        // space and 2 pi^2 F^2 on a surface, the windows pi^2 / 3. One tangent is x, z; one y.
        const bool on_surface = entry == Entry3d::surface_isotropic;
        const double slope = std::sqrt(pi * pi / 3 + pi * pi * (on_surface ? 2 : 4.0 / 3));
        const double x = on_surface ? normal[2] : 1, z = on_surface ? -normal[0] : 0;
        fmt::print("isotropic {}\n", name);
        test::LatticeSample3d sample = solid_sample(place);
        sample.normal = normal;
        check_laws(
            sampler, half, Wanted::all, [&] { return std::array{elsewhere(sample, draw)}; },
            of_isotropic(slope, {{3, x}, {7, z}}, {5}));
    }
}

// The covariance is the transform of the spectrum, of an even ring J_0(t), of an even shell sin(t) / t, with
// t = 2 pi F |lag|, times that of the windows.
TEST_CASE("the covariance of isotropic noise is that of an even ring or shell of waves, in every direction",
          "[law]") {
    const vulkan::Device device;
    Draw draw(35);
    test::Largest plane, space;
    const auto check = [&](test::Largest& largest, auto& sampler, auto wanted, double frequency, double turns,
                           const auto& direction, const auto& sample_of, double spectrum) {
        auto lag = direction;
        double expected = spectrum;
        for (double& along : lag) {
            along *= turns / frequency;
            expected *= noise::hann_correlation(along);
            along *= 1.5; // nodes
        }
        check_covariance(
            largest, sampler, wanted,
            [&] {
                auto sample = elsewhere(sample_of(), draw);
                sample.frequency = static_cast<float>(frequency);
                return pair(sample, lag);
            },
            expected,
            fmt::format("frequency {}, {} turns away, along {:.2f}", frequency, turns,
                        fmt::join(direction, " ")));
    };
    test::IsotropicSampler in_plane(device, per_batch);
    test::LatticeSampler3d in_space(device, per_batch, Entry3d::isotropic);
    const auto anywhere = [&] { return draw.uniform(0, 1); };
    for (const double frequency : {0.5, 5.0})
        for (const double turns : {0.25, 0.6, 1.1})
            for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 90.0}) {
                const double angle = degrees * pi / 180;
                check(
                    plane, in_plane, test::Part::field, frequency, turns,
                    std::array{std::cos(angle), std::sin(angle)},
                    [&] {
                        return test::IsotropicSample{{}, {anywhere(), anywhere()}};
                    },
                    std::cyl_bessel_j(0.0, 2 * pi * turns));
            }
    for (const double frequency : {0.5, 3.0})
        for (const double turns : {0.25, 0.7, 1.2})
            for (const Vector& direction : {Vector{1, 0, 0},
                                            {0, 1, 0},
                                            {0, 0, 1},
                                            test::unit({1, 1, 0}),
                                            test::unit({1, -1, 1}),
                                            test::unit({0, 1, -1}),
                                            test::unit({1, 0, 1}),
                                            test::unit({1, 2, 3})})
                check(
                    space, in_space, Wanted::all, frequency, turns, direction,
                    [&] {
                        return solid_sample({anywhere(), anywhere(), anywhere()});
                    },
                    std::sin(2 * pi * turns) / (2 * pi * turns));
    plane.check("in the plane, in 4.5 standard errors");
    space.check("in space, in 4.5 standard errors");
}
