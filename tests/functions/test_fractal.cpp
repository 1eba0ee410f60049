// Compares fractal noise with the double-precision reference, and checks its law, spectrum, filter and
// continuity.

#include "law.hpp"
#include "noise.hpp"
#include "reference/fractal.hpp"

#include <limits>

using namespace gabor;
using noise::Fractal;
using noise::Vector;
using std::numbers::pi;
using test::Largest;
using test::n;
using test::narrow;
using test::place_of;
using test::Random;
using Drop = test::Lattice3;

namespace {

template <std::size_t N>
struct Sample {
    noise::Place<N> place;
    noise::Pixel<N> pixel;
    Fractal fractal;
    std::uint32_t seed = 7;
};

template <std::size_t N>
std::string to_string(const Sample<N>& s) {
    const Fractal& f = s.fractal;
    return fmt::format(
        "{}, pixel {} {}, octaves {}, gain {}, lacunarity {}, turn {}, basis {}, shape {}, seed {}",
        test::to_string(s.place), s.pixel.dx, s.pixel.dy, f.octaves, f.gain, f.lacunarity, f.turn, f.perlin,
        static_cast<int>(f.shape), s.seed);
}

Drop::GaborFractal narrow_fractal(const Fractal& f) {
    const auto at = [](double value) { return static_cast<float>(value); };
    return {at(f.octaves),
            at(f.gain),
            at(f.lacunarity),
            at(f.turn),
            f.perlin ? GABOR_PERLIN : GABOR_SMOOTH,
            f.shape == Fractal::Shape::fbm      ? GABOR_FBM
            : f.shape == Fractal::Shape::billow ? GABOR_BILLOW
                                                : GABOR_RIDGED};
}

auto plain(const Sample<2>& s) {
    return n.gabor_fractal_noise(place_of(n, s.place), narrow_fractal(s.fractal), s.seed);
}
auto plain(const Sample<3>& s) {
    return n.gabor_fractal_noise_3d(place_of(n, s.place), narrow_fractal(s.fractal), s.seed);
}
auto filtered(const Sample<2>& s) {
    return n.gabor_fractal_noise_filtered(place_of(n, s.place), narrow(s.pixel.dx), narrow(s.pixel.dy),
                                          narrow_fractal(s.fractal), s.seed);
}
auto filtered(const Sample<3>& s) {
    return n.gabor_fractal_noise_3d_filtered(place_of(n, s.place), narrow(s.pixel.dx), narrow(s.pixel.dy),
                                             narrow_fractal(s.fractal), s.seed);
}
auto warped(const Sample<2>& s, bool filter, float strength) {
    const auto fractal = narrow_fractal(s.fractal);
    return filter ? n.gabor_warp_filtered(place_of(n, s.place), narrow(s.pixel.dx), narrow(s.pixel.dy),
                                          strength, fractal, s.seed)
                  : n.gabor_warp(place_of(n, s.place), strength, fractal, s.seed);
}
auto warped(const Sample<3>& s, bool filter, float strength) {
    const auto fractal = narrow_fractal(s.fractal);
    return filter ? n.gabor_warp_3d_filtered(place_of(n, s.place), narrow(s.pixel.dx), narrow(s.pixel.dy),
                                             strength, fractal, s.seed)
                  : n.gabor_warp_3d(place_of(n, s.place), strength, fractal, s.seed);
}

// The covariance of removed slopes: xx, yy, zz, then xy, xz, yz.
auto lost_of(const Drop::GaborFractalNoise& f) {
    return std::array{f.lost.x, f.lost.y, f.lost.z};
}
auto lost_of(const Drop::GaborWarp& f) {
    return std::array{f.lost.x, f.lost.y, f.lost.z};
}
auto lost_of(const auto& f) {
    return std::array{f.lost.x, f.lost.y, f.lost.z, f.lost_mixed.x, f.lost_mixed.y, f.lost_mixed.z};
}

template <std::size_t N>
noise::FractalNoise<N> reference(const Sample<N>& s, bool filter) {
    return filter ? noise::fractal_noise<N>(s.place, s.pixel, s.fractal, s.seed)
                  : noise::fractal_noise<N>(s.place, s.fractal, s.seed);
}

// The deviation of a component of the gradient: what a pixel as large as allowed removes.
template <std::size_t N>
double slope_deviation(Sample<N> s) {
    s.fractal.shape = Fractal::Shape::fbm;
    for (std::size_t axis = 0; axis < N; ++axis) {
        s.pixel.dx[axis] = 1e9;
        s.pixel.dy[axis] = axis % 2 ? 1e9 : -1e9;
    }
    const auto lost = reference(s, true).lost;
    double sum = 0;
    for (std::size_t axis = 0; axis < N; ++axis)
        sum += lost[axis] / N;
    return std::sqrt(sum);
}

template <std::size_t N>
noise::Pixel<N> random_pixel(Random& random, double deviation) {
    noise::Pixel<N> pixel;
    const bool line = random.one_in(4);
    for (std::size_t axis = 0; axis < N; ++axis) {
        pixel.dx[axis] = static_cast<float>(deviation) * random.uniform(-2, 2);
        pixel.dy[axis] = line ? 0.5 * pixel.dx[axis] : static_cast<float>(deviation) * random.uniform(-2, 2);
    }
    return pixel;
}

// A sample anywhere, whose octaves do not depend on the rounding of floats.
template <std::size_t N>
Sample<N> drawn(Random& random) {
    Sample<N> s;
    do {
        s.place = test::any_lattice_place<N>(random, 3);
        bool tiled = false;
        for (std::int32_t& period : s.place.period) {
            period = period == 0 || random.one_in(4) ? 0 : 4 + period % 12;
            tiled |= period != 0;
        }
        for (std::size_t axis = 0; axis < N; ++axis)
            if (tiled && s.place.period[axis] == 0) // where no cell is far
                s.place.cell[axis] %= 5;
        s.fractal = {.octaves = random.one_in(4) ? 1 : random.uniform(1, 6),
                     .gain = random.one_in(8) ? 0 : random.uniform(0.3, 1),
                     .lacunarity = random.word() % 2 ? 2 : random.uniform(1, 2.5),
                     .turn = random.word() % 2 ? 0.64350111f : random.uniform(-7, 7),
                     .perlin = random.word() % 2 == 0,
                     .shape = Fractal::Shape{static_cast<int>(random.word() % 3)}};
    } while (noise::rounding_margin(s.place, s.fractal) < 0.02);
    s.pixel = random_pixel<N>(random, random.one_in(16) ? 0 : std::exp2(random.uniform(-8, 2)));
    s.seed = random.word();
    return s;
}

// How much finer the finest octave is than the first. The rounding of positions changes gradients in
// proportion.
double finest(const Fractal& f) {
    return std::pow(f.lacunarity, std::ceil(f.octaves) - 1);
}

template <std::size_t N>
void compare(int count) {
    Random random(N);
    test::Differences of;
    std::size_t creases = 0;
    for (int i = 0; i < count; ++i) {
        const Sample<N> s = drawn<N>(random);
        const double slope = slope_deviation(s);
        const bool rough = s.fractal.shape != Fractal::Shape::fbm;
        for (const bool filter : {false, true}) {
            const auto wanted = reference(s, filter);
            const auto found = filter ? filtered(s) : plain(s);
            const std::string name = filter  ? rough ? "filtered shapes" : "filtered fBm"
                                     : rough ? "shapes"
                                             : "fBm";
            // Filtered shapes have the error of gabor_uniform.
            const double tolerance = filter && rough ? 2e-4 : 1e-5;
            of[name].see(found.noise, wanted.noise, (filter && rough ? 1e-4 : 1e-5) * slope, s);
            of["removed"].see(found.removed, wanted.removed, 3e-5, s); // shapes by a fit of |n|
            if (wanted.crease < 0.01) {
                ++creases;
                continue;
            }
            const double slopes =
                tolerance * slope * std::max(1.0, finest(s.fractal)) / (filter && rough ? wanted.crease : 1);
            test::see(of[name + "'s gradient"], found.gradient, wanted.gradient, slopes, s);
            const auto lost = lost_of(found);
            for (std::size_t k = 0; k < lost.size(); ++k)
                of[rough ? "lost by shapes" : "lost"].see(lost[k], wanted.lost[k],
                                                          (rough ? 16 : 1) * slopes * slope, s);
        }
    }
    fmt::print("{} of {} at a crease\n", creases, 2 * count);
    CHECK(creases < static_cast<std::size_t>(count) / 5);
    test::check(of, 11);
}

// Compares gradients of the reference with differences of its values.
template <std::size_t N>
void check_gradient(int count) {
    Random random(10 + N);
    Largest largest;
    for (int i = 0; i < count; ++i) {
        const Sample<N> s = drawn<N>(random);
        const double slope = slope_deviation(s), step = 1e-6;
        const bool filter = i % 2;
        const auto field = reference(s, filter);
        if (field.crease < 1e-3)
            continue;
        for (std::size_t axis = 0; axis < N; ++axis) {
            const auto beside = [&](double distance) {
                Sample<N> moved = s;
                moved.place.local[axis] += distance * s.place.radius[axis];
                return reference(moved, filter).noise;
            };
            largest.see((beside(step) - beside(-step)) / (2 * step), field.gradient[axis],
                        1e-4 * slope * finest(s.fractal) / std::min(1.0, 10 * field.crease), s);
        }
    }
    largest.check(fmt::format("{} axes", N));
}

// Compares a warp with its reference, and its derivatives with differences of the reference.
template <std::size_t N>
void check_warp(int count) {
    Random random(20 + N);
    test::Differences of;
    for (int i = 0; i < count; ++i) {
        Sample<N> s = drawn<N>(random);
        s.fractal.shape = Fractal::Shape::fbm;
        const bool filter = i % 2;
        const float strength = random.uniform(0, 1);
        const double slope = slope_deviation(s), step = 1e-6;
        const auto field = [&](std::size_t axis, std::size_t along, double distance) {
            Sample<N> part = s;
            part.seed = noise::lattice_derived_seed(s.seed, static_cast<int>(axis));
            part.place.local[along] += distance * s.place.radius[along];
            return reference(part, filter);
        };
        const auto warp = warped(s, filter, strength);
        noise::Symmetric<N> lost{};
        for (std::size_t axis = 0; axis < N; ++axis) {
            const int a = static_cast<int>(axis);
            const auto here = field(axis, 0, 0);
            for (std::size_t k = 0; k < lost.size(); ++k)
                lost[k] += strength * strength / N * here.lost[k];
            of["place"].see(warp.place.local[a],
                            s.place.local[axis] + strength * here.noise * s.place.radius[axis], 2e-5 * slope,
                            s);
            for (std::size_t along = 0; along < N; ++along) {
                const double difference =
                    (field(axis, along, step).noise - field(axis, along, -step).noise) / (2 * step);
                const auto by = [&] {
                    if constexpr (N == 3)
                        return along == 0 ? warp.dx : along == 1 ? warp.dy : warp.dz;
                    else
                        return along == 0 ? warp.dx : warp.dy;
                }();
                of["derivatives"].see(by[a], (axis == along) + strength * difference,
                                      1e-4 * slope * finest(s.fractal), s);
            }
        }
        const auto found = lost_of(warp);
        for (std::size_t k = 0; k < lost.size(); ++k)
            of["lost"].see(found[k], lost[k], 1e-5 * slope * slope * finest(s.fractal), s);
        CHECK((warp.place.evolution == static_cast<float>(s.place.time) &&
               warp.place.cells_per_radius.y == static_cast<float>(s.place.radius[1])));
    }
    test::check(of, 3);
}

// ---- The law

// A sample at a fixed offset from a node of the first octave, in any cell.
template <std::size_t N>
Sample<N> instance(Random& random, const Fractal& fractal, const Vector<N>& local) {
    Sample<N> s;
    for (std::int32_t& cell : s.place.cell)
        cell = random.cell();
    s.place.local = local;
    s.fractal = fractal;
    s.seed = random.word();
    return s;
}

void set_period(auto& place, Random& random) {
    for (std::int32_t& period : place.period)
        period = 4 + static_cast<std::int32_t>(random.word() % 9);
    for (double& radius : place.radius)
        radius *= random.uniform(0.8, 1.25);
}

// Checks mean and variance of values at each of a few places: a 1 % error of one of them is six standard
// errors, and most fail.
template <std::size_t N>
void check_moments(const std::string& title, const std::vector<Vector<N>>& places, const auto& value) {
    const double each = test::law_samples() / 2;
    statistics::Moments all;
    double mean = 0, variance = 0;
    for (const Vector<N>& place : places) {
        statistics::Moments moments;
        for (double i = 0; i < each; ++i)
            moments.add(value(place));
        mean = std::max(mean, std::abs(moments.mean()));
        variance = std::max(variance, std::abs(moments.variance() - 1));
        all.merge(moments);
    }
    fmt::print("  {}: mean {:.5f}, variance {:.5f}; at worst {:.5f} and 1 +- {:.5f}\n", title, all.mean(),
               all.variance(), mean, variance);
    INFO(title);
    CHECK(std::abs(all.mean()) < 0.005);
    CHECK(std::abs(all.variance() - 1) < 0.005);
    CHECK(mean < 0.008);
    CHECK(variance < 0.01);
}

const std::vector<Vector<2>> in_cell{{0, 0}, {0.5, 0.5}, {0.5, 0}, {0.2, 0.7}};
const std::vector<Vector<3>> in_cube{{0, 0, 0}, {0.5, 0.5, 0.5}, {0.2, 0.7, 0}};

// ---- The filter

// The root mean square of the difference of a filtered octave from a mean of the plain one, weighted by the
// pixel's Gaussian. The pixel has two deviations and is turned.
template <std::size_t N>
double filter_error(Fractal fractal, double deviation, double ratio, double angle, int places) {
    Random random(41);
    double square = 0;
    for (int i = 0; i < places; ++i) {
        Sample<N> s = instance<N>(random, fractal, {});
        for (double& local : s.place.local)
            local = random.uniform(0, 1);
        for (std::int32_t& cell : s.place.cell)
            cell %= 1000;
        s.pixel.dx = {2 * deviation * std::cos(angle), 2 * deviation * std::sin(angle)};
        s.pixel.dy = {-2 * ratio * deviation * std::sin(angle), 2 * ratio * deviation * std::cos(angle)};
        double mean = 0, total = 0;
        const double step = std::min(0.5, 0.25 / deviation); // in deviations
        const int most = static_cast<int>(4 / step), across = ratio == 0 ? 0 : most;
        for (int y = -across; y <= across; ++y)
            for (int x = -most; x <= most; ++x) {
                const double weight = std::exp(-0.5 * step * step * (x * x + y * y));
                Sample<N> moved = s;
                for (std::size_t axis = 0; axis < N; ++axis)
                    moved.place.local[axis] +=
                        1.5 * 0.5 * step * (x * s.pixel.dx[axis] + y * s.pixel.dy[axis]);
                mean += weight * plain(moved).noise;
                total += weight;
            }
        square += std::pow(filtered(s).noise - mean / total, 2) / places;
    }
    return std::sqrt(square);
}

// The window u or v of smooth or Perlin noise, exactly filtered, times the window of the filter, integrated
// over distances. This is the mean over places of their correlation.
double window_correlation(bool perlin, std::size_t odd, double variance) {
    constexpr double step = 1.0 / 64;
    const double deviation = std::sqrt(variance);
    double sum = 0;
    for (double d = -2 + step / 2; d < 2; d += step) {
        double exact = 0, total = 0;
        const double along = std::min(0.125, 0.05 / deviation);
        for (double t = -5; t <= 5; t += along) {
            const double weight = std::exp(-0.5 * t * t);
            exact += weight * noise::fractal_windows(perlin, 0, d + t * deviation)[odd];
            total += weight;
        }
        sum += step * exact / total * noise::fractal_windows(perlin, variance, d)[odd];
    }
    return sum;
}

// ---- The spectrum

// The power of a noise's octaves within 22.5 degrees of the axes, over the power around the diagonals.
double axes_to_diagonals(bool perlin, int octaves) {
    constexpr double step = 1.0 / 64, between = 1.0 / 64, end = 3;
    std::vector<Vector<2>> spectrum; // of u and v, for frequencies in cycles per node spacing
    for (double f = step / 2; f < end; f += step) {
        Vector<2> sums{};
        for (double d = -2 + between / 2; d < 2; d += between)
            for (std::size_t odd = 0; odd < 2; ++odd)
                sums[odd] += between * noise::fractal_windows(perlin, 0, d)[odd] *
                             (odd ? std::sin(2 * pi * f * d) : std::cos(2 * pi * f * d));
        spectrum.push_back({sums[0] * sums[0], sums[1] * sums[1]});
    }
    double axes = 0, diagonals = 0;
    const auto count = static_cast<int>(spectrum.size());
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count && std::hypot(x, y) < count; ++x) {
            const auto [even_x, odd_x] = spectrum[static_cast<std::size_t>(x)];
            const auto [even_y, odd_y] = spectrum[static_cast<std::size_t>(y)];
            const double power = perlin ? odd_x * even_y + even_x * odd_y : even_x * even_y;
            for (int i = 0; i < octaves; ++i) // each is turned against the previous one
                (std::cos(4 * (std::atan2(y + 0.5, x + 0.5) - i * Fractal().turn)) > 0 ? axes : diagonals) +=
                    power * std::pow(0.25, i);
        }
    return axes / diagonals;
}

} // namespace

TEST_CASE("fractal noise and its gradient agree with the reference", "[fractal][oracle]") {
    compare<2>(1 << 14);
    compare<3>(1 << 11);
}

TEST_CASE("the reference's gradients of fractal noise are differences of its values", "[fractal][oracle]") {
    check_gradient<2>(1 << 11);
    check_gradient<3>(1 << 8);
}

TEST_CASE("short functions of fractal noise are those of places", "[fractal]") {
    Random random(51);
    test::Differences of;
    for (int i = 0; i < 1 << 12; ++i) {
        const auto p = random.uniform<gabor_vec2>(-9, 9);
        const auto q = random.uniform<gabor_vec3>(-9, 9);
        Sample<2> s{test::lattice_place(3, p), {}, {}, random.word()};
        Sample<3> solid{test::lattice_place(3, q), {}, {}, s.seed};
        of["gabor_smooth"].see(n.gabor_smooth(p, s.seed), reference(s, false).noise, 2e-5, s);
        s.fractal.perlin = solid.fractal.perlin = true;
        for (double& local : s.place.local)
            local *= 1.186;
        for (double& local : solid.place.local)
            local *= 1.186;
        of["gabor_perlin"].see(n.gabor_perlin(p, s.seed), reference(s, false).noise, 4e-5, s);
        of["gabor_perlin_3d"].see(n.gabor_perlin_3d(q, s.seed), reference(solid, false).noise, 4e-5, solid);
        s.place = test::lattice_place(3, p);
        solid.place = test::lattice_place(3, q);
        s.fractal = solid.fractal = {.octaves = random.uniform(1, 5), .gain = random.uniform(0.3, 0.7)};
        const auto octaves = static_cast<float>(s.fractal.octaves), gain = static_cast<float>(s.fractal.gain);
        of["gabor_fbm"].see(n.gabor_fbm(p, octaves, gain, s.seed), reference(s, false).noise, 1e-4, s);
        of["gabor_fbm_3d"].see(n.gabor_fbm_3d(q, octaves, gain, s.seed), reference(solid, false).noise, 1e-4,
                               solid);
        s.fractal.shape = Fractal::Shape::billow;
        of["gabor_billow"].see(n.gabor_billow(p, octaves, gain, s.seed), reference(s, false).noise, 1e-4, s);
        s.fractal.shape = Fractal::Shape::ridged;
        of["gabor_ridged"].see(n.gabor_ridged(p, octaves, gain, s.seed), reference(s, false).noise, 1e-4, s);
    }
    test::check(of, 7);
}

TEST_CASE("a warp moves along two or three noises, and its derivatives are those of the place",
          "[fractal][oracle]") {
    check_warp<2>(1 << 11);
    check_warp<3>(1 << 8);
}

TEST_CASE("a gradient at a warped place becomes one at the place by the warp's derivatives", "[fractal]") {
    Random random(53);
    Largest largest;
    constexpr float step = 0x1p-9f;
    for (int i = 0; i < 1 << 12; ++i) {
        Sample<2> s = instance<2>(random, {.octaves = 1}, {});
        const std::uint32_t seed = random.word();
        const auto at = [&](float x, float y) {
            Sample<2> moved = s;
            moved.place.local = {0.3 + 1.5 * x, 0.4 + 1.5 * y};
            return warped(moved, false, 0.3f);
        };
        const auto see = [&](const auto& warp) {
            return n.gabor_fractal_noise(warp.place, narrow_fractal(s.fractal), seed);
        };
        const auto warp = at(0, 0);
        const gabor_vec2 g = see(warp).gradient;
        largest.see(g.x * warp.dx.x + g.y * warp.dx.y,
                    (see(at(step, 0)).noise - see(at(-step, 0)).noise) / (2 * step), 0.02, s);
        largest.see(g.x * warp.dy.x + g.y * warp.dy.y,
                    (see(at(0, step)).noise - see(at(0, -step)).noise) / (2 * step), 0.02, s);
    }
    largest.check("gradient");
}

TEST_CASE("tiles of fractal noise repeat without a seam", "[fractal]") {
    Random random(55);
    Largest largest;
    constexpr double step = 0x1p-12; // from the seam, in node spacings
    for (int i = 0; i < 1 << 13; ++i) {
        Sample<2> s = drawn<2>(random);
        if (s.place.period[0] == 0)
            continue;
        s.place.cell[0] = 0;
        const auto at = [&](double local) {
            Sample<2> moved = s;
            moved.place.local[0] = local;
            return filtered(moved).noise;
        };
        // Gradients exceed six deviations nowhere.
        largest.see(at(3.0 * s.place.period[0] - step), at(step), 8 * step * slope_deviation(s), s);
    }
    largest.check("beside a seam");
}

TEST_CASE("fBm is normal at each of 4 x 4 points of a cell, and of 4 x 4 x 4 in 3D", "[fractal][law]") {
    struct {
        const char* name;
        Fractal fractal;
        double deviation = 0; // of the pixel, in kernel radii
        bool period = false, evolves = false;
    } const noises[]{{"a smooth octave", {.octaves = 1}},
                     {"Perlin noise", {.octaves = 1, .perlin = true}},
                     {"five octaves", {.octaves = 5}},
                     {"12.5 octaves", {.octaves = 12.5, .gain = 0.9, .lacunarity = 1.8}},
                     {"2.3 octaves of Perlin noise", {.octaves = 2.3, .gain = 0.3, .perlin = true}},
                     {"a filtered octave", {.octaves = 1}, 0.3},
                     {"filtered Perlin noise", {.octaves = 2, .perlin = true}, 0.2},
                     {"periods, at any time", {.octaves = 2}, 0, true, true}};
    const auto check = [&](const auto& places, double share, const auto& noise) {
        constexpr std::size_t N = std::tuple_size_v<std::decay_t<decltype(places[0])>>;
        const auto& [name, fractal, deviation, period, evolves] = noise;
        Random random(61);
        test::Laws laws(places);
        laws.add(share * test::law_samples(), [&, fractal = fractal, deviation = deviation, period = period,
                                               evolves = evolves](std::size_t k) {
            Sample<N> s = instance<N>(random, fractal, places[k]);
            if (period)
                set_period(s.place, random);
            s.place.time = evolves ? random.uniform(0, 1) : 0;
            if (deviation == 0)
                return std::array{plain(s).noise};
            s.pixel = random_pixel<N>(random, deviation);
            const auto field = filtered(s);
            return std::array{field.noise / std::sqrt(1 - field.removed)};
        });
        laws.check(fmt::format("{}, {} axes", name, N));
    };
    for (const auto& noise : noises)
        check(test::places_of_cell<2>(4), 0.5, noise);
    for (const auto& noise : {noises[0], noises[1], noises[2], noises[6]})
        check(test::places_of_cell<3>(4), 0.5, noise);
}

TEST_CASE("billows and ridges have mean 0 and variance 1 at any place, period and time, and under any pixel",
          "[fractal][law]") {
    using enum Fractal::Shape;
    Random random(63);
    const auto of = [&](const Fractal& fractal) {
        return
            [&, fractal](const auto& place) { return double{plain(instance(random, fractal, place)).noise}; };
    };
    check_moments("a billow", in_cell, of({.octaves = 1, .shape = billow}));
    check_moments("a ridge of Perlin noise", in_cell, of({.octaves = 1, .perlin = true, .shape = ridged}));
    check_moments("a billow in 3D", in_cube, of({.octaves = 1, .shape = billow}));
    check_moments("a ridge of Perlin noise in 3D", in_cube,
                  of({.octaves = 1, .perlin = true, .shape = ridged}));
    check_moments("ridges", in_cell, of({.octaves = 5.5, .gain = 0.9, .lacunarity = 1.8, .shape = ridged}));
    check_moments("billows with periods, at any time", in_cell, [&](const Vector<2>& place) {
        auto s = instance(random, {.octaves = 2.5, .gain = 0.3, .perlin = true, .shape = billow}, place);
        set_period(s.place, random);
        s.place.time = random.uniform(0, 1);
        return double{plain(s).noise};
    });
    for (const double deviation : {0.02, 0.2, 0.5})
        for (const bool perlin : {false, true}) {
            // The mean must not change with the pixel; the variance is that of what is left.
            check_moments(fmt::format("{} under pixels of deviation {}", perlin ? "Perlin ridges" : "billows",
                                      deviation),
                          in_cell, [&](const Vector<2>& place) {
                              Sample<2> s = instance(
                                  random, {.octaves = 2, .perlin = perlin, .shape = perlin ? ridged : billow},
                                  place);
                              const double turn = 0.4;
                              s.pixel = {{2 * deviation * std::cos(turn), 2 * deviation * std::sin(turn)},
                                         {-deviation * std::sin(turn), deviation * std::cos(turn)}};
                              const auto field = filtered(s);
                              return field.noise / std::sqrt(1 - double{field.removed});
                          });
        }
}

TEST_CASE("filtered windows have the correlations with exactly filtered ones that the filter assumes",
          "[fractal][filter]") {
    test::Differences of;
    for (double variance = 1.0 / 64; variance < 20; variance *= 1.25) {
        const std::string where = fmt::format("variance {}", variance);
        const auto [even, odd] = noise::fractal_kept(variance);
        of["smooth u"].see(even, window_correlation(false, 0, variance), 0.0065, where);
        of["Perlin's u"].see(even, window_correlation(true, 0, variance), 0.0065, where);
        of["Perlin's v"].see(odd, window_correlation(true, 1, variance), 0.0065, where);
    }
    test::check(of, 3);
}

TEST_CASE("filtered octaves are close to the mean of the noise over each pixel", "[fractal][filter]") {
    struct {
        double deviation;                     // of the pixel, in kernel radii
        std::array<double, 2> smooth, perlin; // errors under ellipses, and lines between the axes
    } const sizes[]{{0.02, {0.0015, 0.0015}, {0.002, 0.002}},
                    {0.1, {0.022, 0.022}, {0.027, 0.033}},
                    {0.3, {0.09, 0.14}, {0.14, 0.19}},
                    {1, {0.25, 0.38}, {0.21, 0.57}},
                    {3, {0.18, 0.35}, {0.12, 0.36}}};
    struct {
        double ratio, angle;
    } const shapes[]{{1, 0}, {0.5, 0.4}, {0, pi / 4}};
    for (const auto& [deviation, smooth, perlin] : sizes)
        for (const auto& [ratio, angle] : shapes)
            for (const bool of_perlin : {false, true}) {
                const double bound = (of_perlin ? perlin : smooth)[ratio == 0];
                const Fractal fractal{.octaves = 1, .perlin = of_perlin};
                const double plane =
                                 filter_error<2>(fractal, deviation, ratio, angle, deviation > 1 ? 100 : 600),
                             solid =
                                 filter_error<3>(fractal, deviation, ratio, angle, deviation > 1 ? 50 : 150);
                fmt::print("{}, deviation {} x {} at {:.2f}: rms error {:.4f}, in 3D {:.4f}, of {}\n",
                           of_perlin ? "Perlin" : "smooth", deviation, ratio, angle, plane, solid, bound);
                CHECK(plane <= bound);
                CHECK(solid <= bound);
            }
}

TEST_CASE("five octaves of smooth noise have the same power along the axes and the diagonals within 3 %",
          "[fractal]") {
    const auto check = [](const char* name, double ratio, double expected, double within) {
        fmt::print("{}: {:.4f}\n", name, ratio);
        CHECK(std::abs(ratio - expected) < within);
    };
    check("a smooth octave", axes_to_diagonals(false, 1), 0.967, 0.002);
    check("a Perlin octave", axes_to_diagonals(true, 1), 0.92, 0.005);
    check("five smooth octaves", axes_to_diagonals(false, 5), 1, 0.03);
    check("five Perlin octaves", axes_to_diagonals(true, 5), 1, 0.06);
}

TEST_CASE(
    "fractal noise and gradients of fBm have no jumps as a pixel moves, grows or turns, or octaves fade in",
    "[fractal][filter]") {
    Random random(71);
    test::Differences of;
    const auto see = [&](auto sample, int paths) {
        using Any = decltype(sample);
        for (int path = 0; path < paths; ++path) {
            Any s = sample;
            for (double& local : s.place.local)
                local = random.uniform(-3, 3);
            s.seed = random.word();
            s.fractal = {.octaves = path % 2 ? 1.0 : 2.0,
                         .perlin = path / 2 % 2 == 0,
                         .shape = Fractal::Shape{path % 5 % 3}};
            const auto first = random_pixel<std::tuple_size_v<decltype(s.place.local)>>(
                random, std::exp2(random.uniform(-5, 0)));
            const double angle = random.uniform(-2, 2);
            const auto moved = [&](double t) {
                Any at = s;
                at.pixel = first;
                if (path % 3 == 0)
                    at.place.local[0] += t;
                for (std::size_t axis = 0; axis < at.place.local.size(); ++axis) {
                    auto &x = at.pixel.dx[axis], &y = at.pixel.dy[axis];
                    if (path % 3 == 1)
                        x *= std::exp2(2 * t), y *= std::exp2(2 * t);
                    if (path % 3 == 2)
                        std::tie(x, y) = std::pair(std::cos(angle * t) * x - std::sin(angle * t) * y,
                                                   std::sin(angle * t) * x + std::cos(angle * t) * y);
                }
                return at;
            };
            // A crease of billows is a steep change of slope where little is filtered.
            const float scale = s.fractal.shape == Fractal::Shape::fbm ? 1 : 0.1f;
            test::check_path(of, path, 1 << 15, [&](double t) { return scale * filtered(moved(t)).noise; });
            if (s.fractal.shape == Fractal::Shape::fbm) {
                test::check_path(of, path, 1 << 13,
                                 [&](double t) { return 0.02f * filtered(moved(t)).gradient.x; });
                test::check_path(of, 0, 1 << 13, [&](double t) {
                    Any at = s;
                    at.place.local[1] += t;
                    return 0.02f * plain(at).gradient.y;
                });
            }
        }
    };
    see(Sample<2>(), 60);
    see(Sample<3>(), 30);
    test::check(of, 3);
    Largest fades;
    for (int i = 0; i < 1 << 14; ++i) {
        Sample<2> s = drawn<2>(random);
        s.fractal.octaves = 1 + std::floor(random.uniform(1, 5));
        const double here = plain(s).noise;
        s.fractal.octaves = std::nextafter(static_cast<float>(s.fractal.octaves), 9.0f);
        fades.see(plain(s).noise, here, 1e-5, s);
    }
    fades.check("in octaves");
}

TEST_CASE("gabor_uniform is the normal distribution function, and its slope the density",
          "[fractal][uniform]") {
    Largest rank, slope;
    for (double x = -14; x <= 14; x += 1.0 / 512) {
        const std::string where = fmt::format("{}", x);
        const auto noise = static_cast<float>(x);
        rank.see(n.gabor_uniform(noise), 0.5 * std::erfc(-x / std::numbers::sqrt2), 2.1e-5, where);
        slope.see(n.gabor_uniform_slope(noise), std::exp(-0.5 * x * x) / std::sqrt(2 * pi), 1e-7, where);
    }
    rank.check("rank");
    slope.check("density");
    CHECK(n.gabor_uniform(std::numeric_limits<float>::infinity()) == 1);
    CHECK(n.gabor_uniform(-std::numeric_limits<float>::infinity()) < 1e-9f);
}
