#include "study/ingredients.hpp"

#include "vulkan/pass.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace gabor::study {

namespace {

using std::numbers::pi;

double integral(double low, double high, const std::function<double(double)>& f) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, low, high, 10, 1e-13);
}

double radial_envelope(Envelope envelope, double r) {
    switch (envelope) {
    case Envelope::gaussian:
        return std::exp(-pi * r * r);
    case Envelope::c0:
        return std::exp(-pi * r * r) - std::exp(-pi);
    default:
        return std::pow(1 - r * r, 2);
    }
}

// Integrates envelope(d)^power cos(2 pi k.d), with k = frequency omega.
double envelope_integral(Envelope envelope, double power, double frequency, double orientation) {
    if (envelope == Envelope::c1_separable) {
        const auto axis = [&](double k) {
            return integral(
                -1, 1, [&](double x) { return std::pow(1 - x * x, 2 * power) * std::cos(2 * pi * k * x); });
        };
        return axis(frequency * std::cos(orientation)) * axis(frequency * std::sin(orientation));
    }
    return integral(0, 1, [&](double r) {
        return 2 * pi * r * std::pow(radial_envelope(envelope, r), power) *
               boost::math::cyl_bessel_j(0, 2 * pi * std::abs(frequency) * r);
    });
}

double envelope_at(Envelope envelope, double x, double y) {
    if (envelope == Envelope::c1_separable)
        return std::pow(std::max(1 - x * x, 0.0) * std::max(1 - y * y, 0.0), 2);
    const double square = x * x + y * y;
    return square <= 1 ? radial_envelope(envelope, std::sqrt(square)) : 0;
}

// Returns the sign of cos 2x in the square and the fourth power of the wave: cos^2 x = (1 + cos 2x) / 2 and
// cos^4 x = (3 + 4 cos 2x + cos 4x) / 8. It is negative for the sine. With a random phase, only the constants
// remain.
double sign(Kernel kernel) {
    return kernel == Kernel::cosine ? 1 : kernel == Kernel::sine ? -1 : 0;
}

using Vector = std::array<double, 2>;

double dot(const Vector& u, const Vector& v) {
    return u[0] * v[0] + u[1] * v[1];
}

Vector subtract_multiple(const Vector& u, const Vector& v, double factor) {
    return {u[0] - factor * v[0], u[1] - factor * v[1]};
}

// Lagrange's reduction: makes a the shortest vector and b the shortest one independent of a.
void reduce(Vector& a, Vector& b) {
    for (;;) {
        if (dot(b, b) < dot(a, a))
            std::swap(a, b);
        const Vector shorter = subtract_multiple(b, a, std::round(dot(a, b) / dot(a, a)));
        if (dot(shorter, shorter) >= dot(b, b) - 1e-12)
            break;
        b = shorter;
    }
    if (dot(a, b) < 0)
        b = {-b[0], -b[1]};
}

// Returns the circumradius of the triangle 0, a, b, whose circumcentre is a corner of the hexagon.
double circumradius(const Vector& a, const Vector& b) {
    const double area = std::abs(a[0] * b[1] - a[1] * b[0]) / 2;
    const Vector c = subtract_multiple(b, a, 1);
    return std::sqrt(dot(a, a) * dot(b, b) * dot(c, c)) / (4 * area);
}

} // namespace

std::string_view name(Points points) {
    constexpr std::array names{"poisson",      "stratified", "jittered",
                               "jittered_hex", "sobol",      "scrambled_sobol"};
    return names[static_cast<std::size_t>(points)];
}

std::string_view name(Weights weights) {
    constexpr std::array names{"uniform", "bernoulli", "none"};
    return names[static_cast<std::size_t>(weights)];
}

std::string_view name(Kernel kernel) {
    constexpr std::array names{"cosine", "sine", "random_phase"};
    return names[static_cast<std::size_t>(kernel)];
}

std::string_view name(Envelope envelope) {
    constexpr std::array names{"gaussian", "c0", "c1_radial", "c1_separable"};
    return names[static_cast<std::size_t>(envelope)];
}

std::string csv_fields(const Ingredients& ingredients) {
    return fmt::format("{},{},{},{},{}", name(ingredients.points), name(ingredients.weights),
                       name(ingredients.kernel), name(ingredients.envelope), ingredients.impulses);
}

HexagonalLattice hexagonal_lattice(int n) {
    HexagonalLattice best;
    for (int step = 0; step < n; ++step) {
        Vector a{1.0 / n, static_cast<double>(step) / n};
        Vector b{0, 1};
        reduce(a, b);
        if (dot(a, a) > dot(best.a, best.a) + 1e-12)
            best = {step, a, b, std::max(0.0, circumradius(a, b) - 0.5 / n)};
    }
    // The Voronoi cell of a single point is the unit cell itself, so nothing overhangs.
    if (n == 1)
        best.overhang = 0;
    return best;
}

std::vector<std::uint32_t> constants(const Ingredients& ingredients) {
    using vulkan::constant;
    const HexagonalLattice hex = hexagonal_lattice(ingredients.impulses);
    const auto real = [](double value) { return constant(static_cast<float>(value)); };
    return {constant(ingredients.impulses),
            constant(static_cast<int>(ingredients.points)),
            constant(static_cast<int>(ingredients.weights)),
            constant(static_cast<int>(ingredients.kernel)),
            constant(static_cast<int>(ingredients.envelope)),
            constant(ingredients.period),
            constant(hex.step),
            real(hex.a[0]),
            real(hex.a[1]),
            real(hex.b[0]),
            real(hex.b[1]),
            real(hex.overhang)};
}

double variance(const Ingredients& ingredients, const PlaneWave& wave) {
    const double power = ingredients.weights == Weights::uniform ? 1.0 / 3 : 1;
    const auto energy = [&](double k) {
        return envelope_integral(ingredients.envelope, 2, k * wave.frequency, wave.orientation);
    };
    const double middle = sign(ingredients.kernel);
    return ingredients.impulses * power * (energy(0) + (middle == 0 ? 0 : middle * energy(2))) / 2;
}

double poisson_kurtosis(const Ingredients& ingredients, const PlaneWave& wave) {
    const double fourth = ingredients.weights == Weights::uniform ? 1.0 / 5 : 1;
    const auto moment = [&](double k) {
        return envelope_integral(ingredients.envelope, 4, k * wave.frequency, wave.orientation);
    };
    const double middle = sign(ingredients.kernel);
    const double waves = middle == 0 ? 0 : 4 * middle * moment(2) + moment(4);
    return ingredients.impulses * fourth * (3 * moment(0) + waves) / 8 /
           std::pow(variance(ingredients, wave), 2);
}

double stratified_kurtosis(const Ingredients& ingredients, const PlaneWave& wave) {
    constexpr int places = 6;
    constexpr int nodes = 48;
    const double second = ingredients.weights == Weights::uniform ? 1.0 / 3 : 1;
    const double fourth = ingredients.weights == Weights::uniform ? 1.0 / 5 : 1;
    const double kx = 2 * pi * wave.frequency * std::cos(wave.orientation);
    const double ky = 2 * pi * wave.frequency * std::sin(wave.orientation);
    double cumulant = 0;
    for (int place = 0; place < places * places; ++place) {
        for (int cell = 0; cell < 9; ++cell) {
            const double corner_x = cell % 3 - 1 - (place % places + 0.5) / places;
            const double corner_y = cell / 3 - 1 - (place / places + 0.5) / places;
            double m2 = 0;
            double m4 = 0;
            for (int node = 0; node < nodes * nodes; ++node) {
                const double x = corner_x + (node % nodes + 0.5) / nodes;
                const double y = corner_y + (node / nodes + 0.5) / nodes;
                const double phase = kx * x + ky * y;
                const double g = envelope_at(ingredients.envelope, x, y) *
                                 (ingredients.kernel == Kernel::sine ? std::sin(phase) : std::cos(phase));
                m2 += g * g;
                m4 += g * g * g * g;
            }
            m2 *= second / (nodes * nodes);
            m4 *= fourth / (nodes * nodes);
            cumulant += m4 - 3 * m2 * m2;
        }
    }
    return ingredients.impulses * cumulant / (places * places) / std::pow(variance(ingredients, wave), 2);
}

} // namespace gabor::study
