// Compares every function of gabor_sparse.glsl with the double-precision reference. Also compares the noise's
// distribution over independent instances with theory.

#include "compare.hpp"
#include "reference/reference.hpp"
#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"

#include "gabor_sparse.hpp" // for gabor_vec2

#include <vector>

using namespace gabor;
using noise::Reference;
using test::Differences;
using test::Largest;
using test::Random;
using test::slope_tolerance;
using test::tolerance;

namespace {

// gabor_sparse.glsl translated to C++. Each class has the functions for one choice of the macros as members.
#include "sparse_macros.h"
struct One {
    const noise::Recipe recipe = noise::find_recipe("one");
#include "gabor_sparse.hpp"
};

#include "sparse_macros.h"
#define GABOR_CELLS_PER_RADIUS 1.5f
#define GABOR_WEIGHT_FLOOR 0.5f
#define GABOR_WINDOW gabor_vec3(1, -1, 1)
struct Pure {
    const noise::Recipe recipe = noise::find_recipe("pure");
#include "gabor_sparse.hpp"
};

#include "sparse_macros.h"
#define GABOR_IMPULSES 2
#define GABOR_WEIGHT_FLOOR 1.0f
#define GABOR_PHASES 2
#define GABOR_WINDOW gabor_vec3(1, 0, 0)
struct Paper {
    const noise::Recipe recipe = noise::find_recipe("paper");
#include "gabor_sparse.hpp"
};

#include "sparse_macros.h"
#define GABOR_IMPULSES 3
#define GABOR_CELLS_PER_RADIUS 1.06f
#define GABOR_WEIGHT_FLOOR 0.2f
#define GABOR_PHASES 4
#define GABOR_WINDOW gabor_vec3(0.5f, 1.5f, -1)
struct Uneven { // unlike the published recipes in every value
    const noise::Recipe recipe{"uneven", 3, 1.06f, 0.2f, 4, {0.5f, 1.5f, -1}, ""};
#include "gabor_sparse.hpp"
};

// Runs a check for each published recipe.
template <typename Check>
void for_recipes(const Check& check) {
    check(One());
    check(Pure());
    check(Paper());
}

template <typename Functions>
auto place_of(Functions&, const noise::Place<2>& p) {
    return typename Functions::GaborPlace{{p.cell[0], p.cell[1]},
                                          {static_cast<float>(p.local[0]), static_cast<float>(p.local[1])},
                                          {static_cast<float>(p.radius[0]), static_cast<float>(p.radius[1])},
                                          {p.period[0], p.period[1]},
                                          static_cast<float>(p.time)};
}

// Draws a position up to 10^6 from the origin, or in any cell. One coordinate in four is on or next to a
// multiple of 1/2, where windows and cells may end.
noise::Place<2> any_place(Random& random, const noise::Recipe& recipe) {
    const double reach = std::exp2(random.uniform(0, 20));
    const bool far = random.word() % 2;
    noise::Place<2> place;
    place.radius.fill(recipe.radius);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        float local = random.uniform(-reach, reach);
        if (random.one_in(4))
            local = random.one_in(2) ? 0.5f * std::round(2 * local) : random.edge(local, 0.5f);
        if (far) {
            place.cell[axis] = random.cell();
            local -= std::floor(local);
        }
        place.local[axis] = local;
    }
    return place;
}

struct Sample {
    noise::Place<2> place;
    gabor_vec2 p;
    float frequency, orientation;
    std::uint32_t seed;
};

std::string to_string(const Sample& s) {
    return fmt::format("{}, time {}, p ({}, {}), frequency {}, orientation {}, seed {}",
                       test::to_string(s.place), s.place.time, s.p.x, s.p.y, s.frequency, s.orientation,
                       s.seed);
}

template <typename Functions>
void compare(Functions n) {
    constexpr int count = 1 << 11;
    Random random(1);
    Differences of;
    for (int batch = 0; batch < 34; ++batch) {
        // Frequencies cover 0.1 to 64 evenly in octaves. At the first frequency, the shader switches from a
        // power series to a recurrence.
        const float frequency = batch == 0 ? 0.63662f : 0.1f * static_cast<float>(std::exp2(batch * 0.28281));
        const float orientation =
            batch % 4 == 0 ? static_cast<float>(batch / 4) * 0.78539816f : random.uniform(-8, 8);
        const std::uint32_t seed = batch == 1 ? 0 : random.word();
        const Reference reference(n.recipe, frequency, orientation, seed);
        const auto kernel = n.gabor_kernel(frequency, orientation);
        const double tight = tolerance(frequency), loose = slope_tolerance(frequency);
        // At low frequency, a sine kernel is small, so normalization makes its quadrature large.
        const double larger = n.recipe.phases == 2 ? std::max(1.0, 2.0 / frequency) : 1;
        for (int i = 0; i < count; ++i) {
            Sample s{any_place(random, n.recipe), {0, 0}, frequency, orientation, seed};
            for (int axis = 0; axis < 2; ++axis)
                s.p[axis] =
                    static_cast<float>(s.place.local[static_cast<std::size_t>(axis)]) / n.recipe.radius;
            const auto place = place_of(n, s.place);
            const noise::Field<2> expected = reference.field(s.place);
            const auto field = n.gabor_field(place, kernel, seed);
            of["gabor_field"].see(field.noise, expected.value.imag(), tight, s);
            see(of["gabor_field, complex"], of["gabor_field, gradients"], field, expected, tight * larger,
                loose * larger, s);
            of["gabor_field, gradient"].see(field.gradient.x, expected.slope[0].imag(), loose, s);
            of["gabor_field, gradient"].see(field.gradient.y, expected.slope[1].imag(), loose, s);
            of["gabor_noise_at"].see(n.gabor_noise_at(place.cell, place.local, kernel, seed),
                                     expected.value.imag(), tight, s);
            of["gabor_unorm"].see(n.gabor_unorm(field.noise), std::clamp(0.5 + 0.25 * field.noise, 0.0, 1.0),
                                  1e-6, s);
            const gabor_vec2 phasor = n.gabor_turns_intensity({field.noise, field.quadrature});
            const std::complex<double> turned = std::polar(double{phasor.y}, 2 * std::numbers::pi * phasor.x);
            see(of["gabor_turns_intensity"], gabor_vec2(field.quadrature, field.noise), turned,
                2e-5 * std::max(1.0f, phasor.y), s);
            CHECK((phasor.x >= 0 && phasor.x < 1));

            const noise::Field<2> here = reference.field(
                noise::place_at(n.recipe, 0, 0, s.p.x * n.recipe.radius, s.p.y * n.recipe.radius));
            of["gabor_noise"].see(n.gabor_noise(s.p, frequency, orientation, seed), here.value.imag(), tight,
                                  s);
            see(of["gabor_noise_quadrature"], n.gabor_noise_quadrature(s.p, frequency, orientation, seed),
                test::noise_and_quadrature(here.value), tight * larger, s);
            see_gradient(of["gabor_noise_gradient"], of["gabor_noise_gradient"],
                         n.gabor_noise_gradient(s.p, frequency, orientation, seed), here, tight, loose, s);
        }
    }
    fmt::print("{}: largest differences in units of the tolerance\n", n.recipe.name);
    test::check(of, 10);
}

} // namespace

TEST_CASE("the sparse noise, its quadrature and its gradient agree with the reference", "[sparse][oracle]") {
    for_recipes([](auto n) { compare(n); });
    compare(Uneven());
}

TEST_CASE("periods of the sparse noise in space and time agree with the reference", "[sparse][oracle]") {
    Random random(5);
    for_recipes([&](auto n) {
        const float radius = n.recipe.radius;
        Differences of;
        for (int batch = 0; batch < 8; ++batch) {
            const float frequency = random.uniform(1.5, 8), orientation = random.uniform(-8, 8);
            const std::uint32_t seed = random.word();
            const Reference reference(n.recipe, frequency, orientation, seed);
            const double tight = 2 * tolerance(frequency); // impulses are fewer and larger
            // A position is rounded by 10^-6, and the wave turns by 2 pi F per radius.
            const double rounded = 3e-5 * (1 + frequency);
            for (int i = 0; i < 1 << 10; ++i) {
                Sample s{any_place(random, n.recipe), random.uniform<gabor_vec2>(-8, 8), frequency,
                         orientation, seed};
                s.place.time = random.uniform(-2, 2);
                s.place.period = {static_cast<std::int32_t>(random.word() % 100),
                                  static_cast<std::int32_t>(2 + random.word() % 5)};
                s.place.radius = {radius * random.uniform(0.5, 1), radius * random.uniform(0.5, 1)};
                const noise::Field<2> expected = reference.field(s.place);
                const auto field =
                    n.gabor_field(place_of(n, s.place), n.gabor_kernel(frequency, orientation), seed);
                of["gabor_field"].see(field.noise, expected.value.imag(), tight, s);
                of["gabor_field, gradient"].see(field.gradient.x, expected.slope[0].imag(),
                                                2 * slope_tolerance(frequency), s);
                of["gabor_field, gradient"].see(field.gradient.y, expected.slope[1].imag(),
                                                2 * slope_tolerance(frequency), s);

                noise::Place<2> still = noise::place_at(n.recipe, 0, 0, s.p.x * radius, s.p.y * radius);
                still.time = s.place.time;
                of["gabor_noise_animated"].see(n.gabor_noise_animated(s.p, static_cast<float>(s.place.time),
                                                                      frequency, orientation, seed),
                                               reference(still), rounded, s);
                const gabor_vec2 period(random.uniform(1, 20), random.uniform(1, 3)); // clamped to 2
                noise::Place<2> tile;
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    const float length = std::max(2.0f, period[static_cast<int>(axis)]);
                    tile.period[axis] = static_cast<std::int32_t>(std::floor(length * radius));
                    tile.radius[axis] = double(tile.period[axis]) / length;
                    tile.local[axis] = double{s.p[static_cast<int>(axis)]} * tile.radius[axis];
                }
                of["gabor_noise_tiled"].see(n.gabor_noise_tiled(s.p, period, frequency, orientation, seed),
                                            reference(tile), rounded, s);
            }
        }
        fmt::print("{}, with periods; largest differences in units of the tolerance\n", n.recipe.name);
        test::check(of, 4);
    });
}

// A central difference errs by h^2 / 6 times the third derivative, which is (2 pi F)^3 times a few sigma.
template <std::size_t N>
void check_gradient(Random& random, const auto& reference) {
    noise::Place<N> place;
    for (std::size_t axis = 0; axis < N; ++axis) // sometimes on the edge of a cell or window
        place.local[axis] = std::floor(random.uniform(-8, 8) * 256) / 256;
    for (std::size_t axis = 0; axis < N; ++axis) {
        constexpr double h = 0x1p-14;
        noise::Place<N> before = place, after = place;
        before.local[axis] -= h;
        after.local[axis] += h;
        const auto difference = reference.field(after).value - reference.field(before).value;
        REQUIRE(reference.field(place).slope[axis].imag() ==
                Approx(difference.imag() / (2 * h) * place.radius[axis]).margin(5e-4));
    }
}

TEST_CASE("gradients of the reference equal its finite differences", "[sparse][lattice][space][oracle]") {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        for (const char* recipe : {"one", "pure", "paper"})
            check_gradient<2>(random, Reference(noise::find_recipe(recipe), 3, 0.7, 9));
        for (const int taps : {2, 3, 4})
            check_gradient<2>(random, noise::wave_noise(taps, noise::wave_along(3, 0.7), random.word()));
        check_gradient<3>(random, noise::wave_noise(3, noise::Vector<3>{2, -1, 2}, random.word()));
    }
}

TEST_CASE("a phase of the sparse noise is below 1, however little below a whole turn", "[sparse]") {
    One n;
    for (int bit = 1; bit < 120; ++bit) {
        const float below = -std::exp2(static_cast<float>(-bit)),
                    phase = n.gabor_turns_intensity({below, 1}).x;
        CHECK((phase >= 0.5f && phase < 1));
    }
}

TEST_CASE("frequencies outside the range are clamped", "[sparse]") {
    One n;
    const auto noise = [&](float frequency) { return n.gabor_noise({3.3f, 4.8f}, frequency, 0.3f, 5); };
    for (const float low : {0.0f, -0.0f, 1e-30f})
        CHECK(noise(low) == noise(1e-6f));
    CHECK(noise(-3) == noise(3));
    CHECK(std::isfinite(noise(1e30f)));
    CHECK(std::isfinite(noise(std::numeric_limits<float>::infinity())));
}

// By quadrature of the characteristic functions, the cvm of `one` is 0.01 and that of `pure` 0.007. That of
// `paper` is 2^18 (kurtosis / 24)^2 * 0.1429, where 0.1429 is the integral of (phi He_3)^2 dPhi. Its exact
// excess kurtosis follows from Campbell's theorem, by quadrature, and from the effect of stratification.
TEST_CASE("the sparse noises have variance 1, also in tiles, and the predicted kurtosis and cvm",
          "[sparse][law]") {
    const auto check = [](auto n, double excess_kurtosis, double most_cvm) {
        constexpr int count = 1 << 21;
        Random random(3), random_tiles(4);
        const auto kernel = n.gabor_kernel(4, 0.3f);
        statistics::Moments moments, tiled;
        statistics::Gaussianity gaussianity;
        for (int i = 0; i < count; ++i) {
            const float value = n.gabor_noise_at({random.cell(), random.cell()},
                                                 random.uniform<gabor_vec2>(0, 1), kernel, random.word());
            moments.add(value);
            gaussianity.add(value);
            if (i % 2)
                tiled.add(n.gabor_noise_tiled(random_tiles.uniform<gabor_vec2>(0, 8),
                                              random_tiles.uniform<gabor_vec2>(2, 4), 3, 0.3f,
                                              random_tiles.word()));
        }
        const statistics::Estimate cvm = gaussianity.index();
        fmt::print("{}: variance {:.5f}, excess kurtosis {:.4f}, cvm {:.3f} [{:.3f}, {:.3f}]\n",
                   n.recipe.name, moments.variance(), moments.excess_kurtosis(), cvm.value, cvm.low,
                   cvm.high);
        // four standard errors
        for (const statistics::Moments& each : {moments, tiled}) {
            const double values = static_cast<double>(each.count());
            CHECK(each.mean() == Approx(0).margin(4 / std::sqrt(values)));
            CHECK(each.variance() == Approx(1).margin(4 * std::sqrt(2 / values)));
        }
        CHECK(moments.excess_kurtosis() == Approx(excess_kurtosis).margin(4 * std::sqrt(24.0 / count)));
        CHECK(cvm.low < most_cvm);
    };
    check(One(), 0.0315, 0.01);
    check(Pure(), 0.0131, 0.007);
    check(Paper(), -0.0325, 0.07);
}
