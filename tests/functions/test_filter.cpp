// Compares the filters in the plane, in space and on surfaces with quadrature of the double-precision
// reference.

#include "noise.hpp"

#include <vector>

using namespace gabor;
using noise::cross;
using noise::dot;
using noise::length;
using noise::scaled;
using noise::sum;
using noise::unit;
using noise::Vector;
using std::numbers::pi;
using test::Differences;
using test::Largest;
using test::narrow;
using test::place_of;
using test::Random;
using test::random_unit;
using test::wide;

namespace {

test::Lattice3 n;

template <std::size_t N>
using Plane = std::array<Vector<N>, 2>; // two unit vectors at right angles

Plane<3> plane_across(const Vector<3>& normal) {
    const Vector<3> u =
        unit(cross(normal, std::abs(normal[0]) < 0.5 ? Vector<3>{1, 0, 0} : Vector<3>{0, 1, 0}));
    return {u, cross(normal, u)};
}

template <std::size_t N>
Plane<N> random_plane(Random& random) {
    if constexpr (N == 2)
        return {{{1, 0}, {0, 1}}};
    else
        return plane_across(random_unit<3>(random));
}

// Rotates the two vectors by an angle: within the plane or, in space, around the second vector.
Plane<2> turned(const Plane<2>& plane, double angle) {
    return {sum(std::cos(angle), plane[0], std::sin(angle), plane[1]),
            sum(-std::sin(angle), plane[0], std::cos(angle), plane[1])};
}
Plane<3> turned(const Plane<3>& plane, double angle) {
    return {sum(std::cos(angle), plane[0], std::sin(angle), cross(plane[0], plane[1])), plane[1]};
}

// The arguments of a filtered noise. All vectors are exactly representable in floats.
template <std::size_t N>
struct Sample {
    noise::Place<N> place;
    float frequency = 0;
    Vector<N> direction{};
    Vector<3> normal{0, 0, 1};
    Vector<N> dx{}, dy{}; // the steps to the next pixels
    std::uint32_t seed = 0;

    Vector<N> wave() const { return scaled(frequency, unit(direction)); }

    // Sets a pixel in a plane with the given deviation along one side and `ratio` times that along the other.
    void set_pixel(const Plane<N>& plane, double angle, double deviation, double ratio) {
        const double x = 2 * deviation * std::cos(angle), y = 2 * deviation * std::sin(angle);
        dx = wide(narrow(sum(x, plane[0], y, plane[1])));
        dy = wide(narrow(sum(-ratio * y, plane[0], ratio * x, plane[1])));
    }
    // Draws a square, thin, diagonal or degenerate pixel with deviations from 1/256 to 2^largest.
    void random_pixel(Random& random, double largest) {
        set_pixel(
            random_plane<N>(random), random.one_in(3) ? random.word() % 8 * pi / 4 : random.uniform(-4, 4),
            std::exp2(random.uniform(-8, largest)), random.one_in(3) ? 0 : std::exp2(random.uniform(-6, 0)));
        if (random.one_in(4)) // steps that are nearly parallel
            for (std::size_t axis = 0; axis < N; ++axis)
                dy[axis] = static_cast<float>(dx[axis]) * 0.1f * (1 + random.uniform(-1e-3, 1e-3));
    }
};

template <std::size_t N>
std::string to_string(const Sample<N>& s) {
    return fmt::format("{}, frequency {}, direction {}, normal {}, pixel {}, {}, seed {}",
                       test::to_string(s.place), s.frequency, s.direction, s.normal, s.dx, s.dy, s.seed);
}

template <std::size_t N>
Sample<N> somewhere(Random& random, double frequency) {
    Sample<N> s;
    for (std::size_t axis = 0; axis < N; ++axis) {
        s.place.cell[axis] = random.cell();
        s.place.local[axis] = random.uniform(0, 1);
    }
    s.frequency = static_cast<float>(frequency);
    s.direction = wide(narrow(random_unit<N>(random)));
    s.normal = wide(narrow(random_unit<3>(random)));
    s.seed = random.word();
    return s;
}

// The result of a filtered function: the noise with its gradient and, if the function returns it, the
// quadrature with its gradient.
template <std::size_t N>
struct Filtered {
    std::vector<std::array<double, N + 1>> parts;
    double removed;
};

// A filtered function and its reference.
template <std::size_t N>
struct Function;
template <>
struct Function<2> {
    const char* name;
    test::Lattice3::GaborField (*field)(test::Lattice3::GaborPlace, test::Lattice3::GaborFootprint,
                                        const Sample<2>&, float& removed);
    noise::Sum<2> (*reference)(const Sample<2>&);

    Filtered<2> operator()(const Sample<2>& s) const {
        float removed;
        const auto f = field(place_of(n, s.place), n.gabor_footprint(narrow(s.dx), narrow(s.dy)), s, removed);
        return {{{f.value.y, f.slope_x.y, f.slope_y.y}, {f.value.x, f.slope_x.x, f.slope_y.x}}, removed};
    }
};
template <>
struct Function<3> {
    const char* name;
    test::Lattice3::GaborField3d (*field)(test::Lattice3::GaborPlace3d, const Sample<3>&);
    noise::Sum<3> (*reference)(const Sample<3>&);

    Filtered<3> operator()(const Sample<3>& s) const {
        const auto f = field(place_of(n, s.place, true, narrow(s.dx), narrow(s.dy)), s);
        const auto &g = f.gradient, &h = f.quadrature_gradient;
        return {{{f.noise, g.x, g.y, g.z}, {f.quadrature, h.x, h.y, h.z}}, f.removed};
    }
};

template <std::size_t N>
noise::Sum<N> wave_of(const Sample<N>& s) {
    return noise::wave_noise(3, s.wave(), s.seed);
}

constexpr Function<2> plane{"in the plane",
                            [](auto place, auto footprint, const auto& s, float& removed) {
                                return n.gabor_field_filtered(place, n.gabor_kernel_wave(narrow(s.wave())),
                                                              footprint, s.seed, removed);
                            },
                            wave_of<2>};
constexpr Function<2> isotropic{
    "isotropic in the plane",
    [](auto place, auto footprint, const auto& s, float& removed) {
        return n.gabor_field_isotropic_filtered(place, s.frequency, footprint, s.seed, removed);
    },
    [](const auto& s) -> noise::Sum<2> { return noise::isotropic_noise(s.frequency, s.seed); }};
constexpr Function<3> space{"in space",
                            [](auto place, const auto& s) {
                                return n.gabor_field_3d(place, s.frequency, narrow(s.direction), s.seed);
                            },
                            wave_of<3>};
constexpr Function<3> surface{
    "on a surface",
    [](auto place, const auto& s) {
        return n.gabor_field_surface(place, narrow(s.normal), s.frequency, narrow(s.direction), s.seed);
    },
    [](const auto& s) {
        return noise::surface_noise(unit(s.normal), s.frequency, unit(s.direction), s.seed);
    }};
constexpr Function<3> isotropic_3d{
    "isotropic in space",
    [](auto place, const auto& s) { return n.gabor_field_3d_isotropic(place, s.frequency, s.seed); },
    [](const auto& s) -> noise::Sum<3> { return noise::isotropic_noise_3d(s.frequency, s.seed); }};
constexpr Function<3> isotropic_surface{
    "isotropic on a surface",
    [](auto place, const auto& s) {
        return n.gabor_field_surface_isotropic(place, narrow(s.normal), s.frequency, s.seed);
    },
    [](const auto& s) { return noise::isotropic_surface_noise(unit(s.normal), s.frequency, s.seed); }};

// The variance of the gradient: a wave contributes 4 pi^2 F^2, and the windows pi^2 / 3 along each axis that
// has 1.5 nodes per kernel radius.
template <std::size_t N>
double gradient_variance(double frequency, const Vector<N>& nodes) {
    double variance = 4 * pi * pi * frequency * frequency;
    for (const double per_radius : nodes)
        variance += std::pow(pi * per_radius / 1.5, 2) / 3;
    return variance;
}

// Errors relative to the deviations of the unfiltered noise and gradient.
template <std::size_t N>
class Error {
  public:
    void see(const Sample<N>& s, const Filtered<N>& found, const noise::Sum<N>& reference, double variance) {
        const noise::Field<N> exact = reference.filtered(s.place, s.dx, s.dy);
        for (std::size_t part = 0; part < found.parts.size(); ++part) {
            const auto difference = [&](std::size_t k, std::complex<double> value) {
                return found.parts[part][k] - (part == 0 ? value.imag() : value.real());
            };
            const double error = difference(0, exact.value);
            squares_ += error * error;
            largest_ = std::max(largest_, std::abs(error));
            for (std::size_t axis = 0; axis < N; ++axis)
                slope_squares_ += std::pow(difference(axis + 1, exact.slope[axis]), 2) / variance;
            ++count_;
        }
        if (count_ % 16 == 0)
            removed_.see(found.removed, reference.removed(s.place, s.dx, s.dy), N == 2 ? 0.0105 : 0.013, s);
    }
    void see(const Sample<N>& s, const Function<N>& function) {
        see(s, function(s), function.reference(s), gradient_variance(s.frequency, s.place.radius));
    }

    void check(const std::string& name, double bound, double slope_bound, double largest = 1) const {
        const double rmse = std::sqrt(squares_ / count_), slope_rmse = std::sqrt(slope_squares_ / count_);
        fmt::print("  {}: {:.3f} {:.2f}, gradient {:.2f}\n", name, 100 * rmse, 100 * largest_,
                   100 * slope_rmse);
        INFO(name);
        CHECK(count_ >= 20);
        CHECK(rmse <= bound);
        CHECK(largest_ <= largest);
        CHECK(slope_rmse <= slope_bound);
        removed_.check("  removed variance");
    }

  private:
    int count_ = 0;
    double squares_ = 0;
    double largest_ = 0;
    double slope_squares_ = 0;
    Largest removed_;
};

struct Bounds {
    double value, slope;
};

// Checks random pixels, with separate bounds for deviations up to 1/6 and up to 1/2.
template <std::size_t N>
void check_pixels(const Function<N>& function, bool periodic, Bounds of_small, Bounds of_large) {
    Random random(36);
    Error<N> small, large;
    for (int i = 0; i < 600; ++i) {
        Sample<N> s = somewhere<N>(random, random.one_in(4) ? 0 : random.uniform(0, 2));
        s.random_pixel(random, -1);
        for (std::size_t axis = 0; periodic && axis < N; ++axis) {
            s.place.period[axis] = 3 + static_cast<std::int32_t>(random.word() % 9);
            s.place.radius[axis] = 1.5f * random.uniform(0.8, 1);
        }
        (std::hypot(length(s.dx), length(s.dy)) < 1.0 / 3 ? small : large).see(s, function);
    }
    small.check(fmt::format("{}, deviations up to 1/6", function.name), of_small.value, of_small.slope);
    large.check(fmt::format("{}, deviations up to 1/2", function.name), of_large.value, of_large.slope);
}

struct Shape {
    double ratio, angle;
};
struct Size {
    double deviation, bound, slope_bound = 0.1;
};

// Checks pixels of each size and shape in a plane, at `count` points each.
template <std::size_t N>
void check_table(const Function<N>& function, int count, std::initializer_list<Size> sizes,
                 std::initializer_list<Shape> shapes, std::initializer_list<double> frequencies,
                 const auto& plane_of) {
    Random random(32);
    for (const auto& [deviation, bound, slope_bound] : sizes)
        for (const auto& [ratio, angle] : shapes)
            for (const double frequency : frequencies) {
                Error<N> error;
                for (int i = 0; i < count; ++i) {
                    Sample<N> s = somewhere<N>(random, frequency);
                    s.set_pixel(plane_of(s), angle, deviation, ratio);
                    error.see(s, function);
                }
                error.check(fmt::format("{}, deviation {:.3f} x {:.1f} at {:.2f}, frequency {}",
                                        function.name, deviation, ratio, angle, frequency),
                            bound, slope_bound);
            }
}

// Checks that the noise has no jumps as a pixel moves, grows or turns. Paths are sampled as densely as single
// precision allows, so a change that neither the slope nor rounding explains is a jump.
template <std::size_t N>
void check_paths(const Function<N>& function, int paths, int steps) {
    Random random(33);
    Differences of;
    for (int path = 0; path < paths; ++path) {
        Sample<N> sample = somewhere<N>(random, random.uniform(0, path % 2 ? 1 : 5));
        sample.place.cell = {};
        for (double& local : sample.place.local)
            local = random.uniform(-12, 12);
        const Plane<N> sides = random_plane<N>(random);
        const Vector<N> direction = random_unit<N>(random);
        const double angle = random.uniform(-4, 4), deviation = std::exp2(random.uniform(-6, 0)),
                     ratio = path % 4 < 2 ? random.uniform(0, 1) : 0;
        test::check_path(of, path, steps, [&](double t) {
            Sample<N> s = sample;
            s.set_pixel(sides, angle, deviation, ratio);
            if (path % 3 == 0) // moves by 3 node spacings, or 2 kernel radii
                s.place.local = wide(narrow(sum(1, s.place.local, 3 * t, direction)));
            else if (path % 3 == 1) // together, the paths cover all sizes from 1/256 to 2
                s.set_pixel(sides, angle, std::exp2(-8 + 9 * (path / 3 + t) * 3 / paths), ratio);
            else
                s.set_pixel(turned(sides, pi * t), angle, deviation, ratio);
            return static_cast<float>(function(s).parts[0][0]);
        });
    }
    test::check(of, 3);
}

template <std::size_t N>
void check_removed(const Function<N>& function) {
    Random random(48);
    Largest removed;
    for (int i = 0; i < 600; ++i) {
        Sample<N> s = somewhere<N>(random, random.uniform(0, 3));
        // The pixel does not always lie in the surface.
        if (N == 2 || random.word() % 2)
            s.random_pixel(random, 1);
        else if constexpr (N == 3)
            s.set_pixel(plane_across(s.normal), random.uniform(-3, 3), std::exp2(random.uniform(-5, 1)),
                        random.uniform(0, 1));
        removed.see(function(s).removed, function.reference(s).removed(s.place, s.dx, s.dy), 0.013, s);
    }
    removed.check(function.name);
}

} // namespace

// Over twelve seeds, the noise in the plane has an RMSE of 0.14 to 0.20 % for small pixels and of 0.54 to
// 0.69 % for large ones; for its gradient, 0.7 to 1.3 % and 1.4 to 2.1 %.
TEST_CASE("the filter agrees with quadrature of the noise", "[spectrum][space][oracle][filter]") {
    check_pixels(plane, false, {0.0025, 0.015}, {0.0085, 0.024});
    check_pixels(space, false, {0.005, 0.02}, {0.01, 0.03});
    check_pixels(space, true, {0.005, 0.02}, {0.01, 0.03});
    check_pixels(surface, false, {0.005, 0.02}, {0.01, 0.03});
}

TEST_CASE("the filter of lobes agrees with quadrature of the noise", "[spectrum][oracle][filter]") {
    Random random(37);
    Error<2> error;
    for (int i = 0; i < 150; ++i) {
        Sample<2> s = somewhere<2>(random, 0);
        const auto p = random.uniform<gabor_vec2>(-50, 50);
        s.place = test::lattice_place(3, p);
        s.random_pixel(random, -1);
        test::Lattice3::GaborLobes lobes;
        lobes.count = 3;
        for (auto& lobe : lobes.lobe) // wide kernels, so that pixels are small in comparison
            lobe = n.gabor_lobe_elliptical(random.uniform(0, 2), random.uniform(-3, 3),
                                           random.uniform<gabor_vec2>(1, 2), random.uniform(0, 1));
        const auto reference = test::reference_lobes(lobes, s.seed);
        double variance = 0, power = 0;
        for (const noise::SpectrumLobe& lobe : reference) {
            variance += lobe.power *
                        gradient_variance<2>(lobe.frequency, {1.5 / lobe.radius[0], 1.5 / lobe.radius[1]});
            power += lobe.power;
        }
        const gabor_vec4 found =
            n.gabor_noise_lobes_filtered_gradient(p, narrow(s.dx), narrow(s.dy), lobes, s.seed);
        error.see(s, {{{found.x, found.y, found.z}}, found.w}, noise::spectrum(reference), variance / power);
        const gabor_vec2 value = n.gabor_noise_lobes_filtered(p, narrow(s.dx), narrow(s.dy), lobes, s.seed);
        CHECK(value.x == Approx(found.x).margin(1e-5));
        CHECK(value.y == Approx(found.w).margin(1e-6));
    }
    error.check("three lobes", 0.005, 0.008);
}

TEST_CASE("the filter agrees with quadrature where windows end", "[spectrum][oracle][filter]") {
    Random random(41);
    Error<2> error;
    for (int i = 0; i < 300; ++i) {
        Sample<2> s = somewhere<2>(random, random.uniform(0, 2));
        for (double& local : s.place.local)
            local = 0.5f + random.uniform(-0.03, 0.03);
        s.random_pixel(random, -3.5);
        error.see(s, plane);
    }
    error.check("at the ends of windows", 0.004, 0.03, 0.04);
}

TEST_CASE("functions of a position are filtered like fields", "[spectrum][space][oracle][filter]") {
    Random random(43);
    Differences of;
    const auto see = [&](const char* name, gabor_vec2 found, const auto& field, const auto& at) {
        of[name].see(found.x, field.parts[0][0], 1e-4, at);
        of[name].see(found.y, field.removed, 1e-5, at);
    };
    for (int i = 0; i < 200; ++i) {
        Sample<2> s = somewhere<2>(random, random.uniform(0, 2));
        s.random_pixel(random, 0);
        const auto p = random.uniform<gabor_vec2>(-9, 9);
        s.place = test::lattice_place(3, p);
        const gabor_vec2 dx = narrow(s.dx), dy = narrow(s.dy);
        const float f = s.frequency, o = static_cast<float>(std::atan2(s.direction[1], s.direction[0]));
        const auto field = plane(s);
        see("gabor_noise_filtered", n.gabor_noise_filtered(p, dx, dy, f, o, s.seed), field, s);
        see("gabor_noise_isotropic_filtered", n.gabor_noise_isotropic_filtered(p, dx, dy, f, s.seed),
            isotropic(s), s);
        const gabor_vec4 found = n.gabor_noise_filtered_gradient(p, dx, dy, f, o, s.seed);
        see("gabor_noise_filtered_gradient", {found.x, found.w}, field, s);
        of["gabor_noise_filtered_gradient"].see(found.y, field.parts[0][1], 2e-3, s);
        of["gabor_noise_filtered_gradient"].see(found.z, field.parts[0][2], 2e-3, s);
        float removed;
        const gabor_vec4 four = n.gabor_noise_four_filtered(p, dx, dy, f, o, s.seed, removed);
        for (int c = 0; c < 4; ++c) {
            Sample<2> one = s;
            one.seed = c ? noise::lattice_lobe_seed(s.seed, -c) : s.seed;
            see("gabor_noise_four_filtered", {four[c], removed}, plane(one), one);
        }
    }
    for (int i = 0; i < 200; ++i) {
        Sample<3> s = somewhere<3>(random, random.uniform(0, 2));
        s.random_pixel(random, 0);
        const auto p = random.uniform<gabor_vec3>(-9, 9);
        s.place = test::lattice_place(3, p);
        const gabor_vec3 dx = narrow(s.dx), dy = narrow(s.dy), direction = narrow(s.direction);
        see("gabor_noise_3d_filtered", n.gabor_noise_3d_filtered(p, dx, dy, s.frequency, direction, s.seed),
            space(s), s);
        see("gabor_noise_3d_isotropic_filtered",
            n.gabor_noise_3d_isotropic_filtered(p, dx, dy, s.frequency, s.seed), isotropic_3d(s), s);
    }
    test::check(of, 6);
}

TEST_CASE("the filter in the plane errs by at most 1 % for pixels up to 1/3 radius, and 2 % up to 1 radius",
          "[spectrum][filter][law]") {
    check_table(plane, 40, {{0.08, 0.01}, {1.0 / 6, 0.01}, {0.354, 0.02}, {0.5, 0.02}},
                {{1, 0}, {0.3, pi / 8}, {0.3, 2}, {0, 0}, {0, pi / 8}, {0, pi / 4}}, {0, 0.25, 0.5, 1, 2},
                [](const auto&) {
                    return Plane<2>{{{1, 0}, {0, 1}}};
                });
}

// Of all pixel shapes, a diagonal line has the largest error: 1.81 % at frequency 0. Estimates from 300
// points vary by 4 % of that.
TEST_CASE("the filter in space errs by at most 1 % for pixels up to 1/3 radius, and 2 % up to 1 radius",
          "[space][filter][law]") {
    check_table(space, 300, {{1.0 / 6, 0.01}, {0.5, 0.02}}, {{0, 0.8}, {1, 0.8}}, {0, 0.5, 2},
                [](const auto&) {
                    return plane_across(unit(Vector<3>{1, 2, 3}));
                });
}

TEST_CASE("the filter of isotropic noise errs by at most 2 % for pixels up to 0.3 radii, and 4 % up to 0.4 "
          "radii in the plane",
          "[isotropic][space][filter]") {
    check_table(isotropic, 150, {{0.05, 0.006}, {0.15, 0.02}, {0.2, 0.04, 0.14}},
                {{1, 0}, {0.3, 0.5}, {0.3, 2}}, {0, 1, 3}, [](const auto&) {
                    return Plane<2>{{{1, 0}, {0, 1}}};
                });
    for (const auto& function : {isotropic_3d, isotropic_surface})
        check_table(function, 11, {{0.03, 0.02}, {0.15, 0.02}}, {{0, 0.5}, {1, 0.5}}, {0, 1, 2.5},
                    [](const auto& s) { return plane_across(unit(s.normal)); });
}

TEST_CASE("the variance that the filter removes from isotropic noise is right for any pixel",
          "[isotropic][space][filter]") {
    check_removed(isotropic);
    check_removed(isotropic_3d);
    check_removed(isotropic_surface);
}

// A Gaussian lobe of variance 1/12 along each axis keeps the share
//     d^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F)
// of its variance, where S is the pixel's covariance and d the determinant of 1 + 2/3 pi^2 S.
TEST_CASE("the variance that the filter removes agrees with the formula", "[spectrum][filter][oracle]") {
    Random random(40);
    Largest removed;
    for (int i = 0; i < 1 << 12; ++i) {
        Sample<2> s = somewhere<2>(random, random.uniform(0, 3));
        s.random_pixel(random, 1);
        double determinant = 1, exponent = 0;
        for (const Vector<2>& axis : noise::principal_axes(s.dx, s.dy)) {
            const double stretch = 1 + 2 * pi * pi / 3 * dot(axis, axis);
            determinant *= stretch;
            exponent += std::pow(2 * pi * s.frequency * dot(unit(s.direction), axis), 2) / stretch;
        }
        removed.see(plane(s).removed, 1 - std::exp(-exponent) / std::sqrt(determinant), 1e-5, s);
    }
    removed.check("removed variance");
}

// For a long, thin pixel, the exponent in the formula above is a small difference of large products.
TEST_CASE("the variance that the filter removes is between 0 and 1 for pixels of any length",
          "[spectrum][filter]") {
    Random random(38);
    for (int i = 0; i < 1 << 14; ++i) {
        Sample<2> s = somewhere<2>(random, std::exp2(random.uniform(-3, 5)));
        s.set_pixel(turned(random_plane<2>(random), std::atan2(s.direction[1], s.direction[0])), pi / 2,
                    std::exp2(random.uniform(-2, 8.9)), 0);
        const double removed = plane(s).removed;
        INFO(to_string(s));
        REQUIRE((removed >= 0 && removed <= 1));
    }
}

TEST_CASE("the filtered noise has no jumps as the pixel moves, grows or turns",
          "[spectrum][isotropic][space][filter]") {
    check_paths(plane, 90, 1 << 14);
    check_paths(space, 60, 1 << 13);
    check_paths(isotropic_3d, 60, 1 << 13);
}
