#include "study/variant.hpp"

#include "vulkan/pass.hpp"

#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace gabor::study {

namespace {

// Returns E[magnitude^power] for `power` 2, 4 or 6.
double magnitude_moment(Magnitudes magnitudes, double floor, int power) {
    switch (magnitudes) {
    case Magnitudes::uniform: {
        double sum = 0;
        for (int k = 0; k <= power; ++k)
            sum += std::pow(floor, k);
        return sum / (power + 1);
    }
    case Magnitudes::two_point:
        return (1 + std::pow(floor, power)) / 2;
    default:
        return std::pow(2, power / 2) * std::tgamma(1 + power / 2);
    }
}

// Returns the mean of f over [0, 1)^2, which equals its integral.
double mean_over_cell(int nodes, const std::function<double(double, double)>& f) {
    double sum = 0;
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i)
            sum += f((i + 0.5) / nodes, (j + 0.5) / nodes);
    return sum / (nodes * nodes);
}

} // namespace

std::string_view name(Lattice lattice) {
    return lattice == Lattice::square ? "square" : "brick";
}

std::string_view name(Magnitudes magnitudes) {
    constexpr std::array names{"uniform", "two_point", "rayleigh"};
    return names[static_cast<std::size_t>(magnitudes)];
}

std::string_view name(Shape shape) {
    constexpr std::array names{"separable", "radial", "gaussian"};
    return names[static_cast<std::size_t>(shape)];
}

double value(const Window& window, double x, double y) {
    const auto polynomial = [&](double square) {
        const double u = std::max(1 - square, 0.0);
        return u * u * (window.c[0] + u * (window.c[1] + u * window.c[2]));
    };
    const double square = x * x + y * y;
    switch (window.shape) {
    case Shape::separable:
        return polynomial(x * x) * polynomial(y * y);
    case Shape::radial:
        return polynomial(square);
    default:
        return square <= 1 ? std::exp(-std::numbers::pi * square) : 0;
    }
}

std::vector<std::uint32_t> constants(const Variant& variant) {
    using vulkan::constant;
    const auto real = [](double x) { return constant(static_cast<float>(x)); };
    return {constant(variant.impulses),
            real(variant.radius),
            constant(static_cast<int>(variant.lattice)),
            real(variant.jitter),
            constant(static_cast<int>(variant.magnitudes)),
            real(variant.floor),
            constant(static_cast<int>(variant.window.shape)),
            real(variant.window.c[0]),
            real(variant.window.c[1]),
            real(variant.window.c[2])};
}

double variance(const Variant& variant) {
    const double energy =
        4 * mean_over_cell(512, [&](double x, double y) { return std::pow(value(variant.window, x, y), 2); });
    return variant.impulses * variant.radius * variant.radius *
           magnitude_moment(variant.magnitudes, variant.floor, 2) * energy / 2;
}

double visited(const Variant& variant) {
    return variant.impulses * std::pow(2 * variant.radius + variant.jitter, 2);
}

// Let a_k be the moments of the window over one cell, seen from a point. One impulse has the moments m2 =
// E[w^2] a2 / 2, m4 = E[w^4] a4 3/8, m6 = E[w^6] a6 5/16 and the cumulants m4 - 3 m2^2 and m6 - 15 m4 m2 + 30
// m2^3; cumulants of impulses add up. By Edgeworth's series F - Phi = -phi (k4 He3 / 24 + k6 He5 / 720), and
// for normal x of variance 1/3 (with a density proportional to phi^3) E[He3^2] = 14/9, E[He3 He5] = -160/27,
// E[He5^2] = 680/27.
double best_floor(const Variant& variant) {
    const int reach = static_cast<int>(std::ceil(variant.radius)) + 1;
    double a2 = 0;
    double a4 = 0;
    double a6 = 0;
    double a2a2 = 0;
    double a4a2 = 0;
    double a2a2a2 = 0;
    constexpr int places = 4;
    for (int place = 0; place < places * places; ++place) {
        const double px = (place % places + 0.5) / places;
        const double py = (place / places + 0.5) / places;
        for (int row = -reach; row <= reach; ++row) {
            const double shift = variant.lattice == Lattice::brick && row % 2 != 0 ? 0.5 : 0;
            for (int column = -reach; column <= reach; ++column) {
                const auto moment = [&](int power) {
                    return mean_over_cell(16,
                                          [&](double x, double y) {
                                              return std::pow(
                                                  value(variant.window,
                                                        (px - column - shift - x) / variant.radius,
                                                        (py - row - y) / variant.radius),
                                                  power);
                                          }) /
                           (places * places);
                };
                const double second = moment(2);
                const double fourth = moment(4);
                a2 += second;
                a4 += fourth;
                a6 += moment(6);
                a2a2 += second * second * (places * places);
                a4a2 += fourth * second * (places * places);
                a2a2a2 += std::pow(second * (places * places), 3) / (places * places);
            }
        }
    }
    double best = 1;
    double least = std::numeric_limits<double>::infinity();
    for (int thousandth = 1000; thousandth >= 0; --thousandth) {
        const double floor = thousandth / 1000.0;
        const double w2 = magnitude_moment(variant.magnitudes, floor, 2) / 2;
        const double w4 = magnitude_moment(variant.magnitudes, floor, 4) * 3 / 8;
        const double w6 = magnitude_moment(variant.magnitudes, floor, 6) * 5 / 16;
        const double n = variant.impulses;
        const double power = n * w2 * a2;
        const double k4 = n * (w4 * a4 - 3 * w2 * w2 * a2a2) / (power * power) / 24;
        const double k6 =
            n * (w6 * a6 - 15 * w4 * w2 * a4a2 + 30 * std::pow(w2, 3) * a2a2a2) / std::pow(power, 3) / 720;
        const double index = k4 * k4 * 14 / 9 - 2 * k4 * k6 * 160 / 27 + k6 * k6 * 680 / 27;
        if (index < least) {
            least = index;
            best = floor;
        }
    }
    return best;
}

namespace {

constexpr double step = 0.01; // cycles per kernel radius
constexpr double highest = 8; // cycles per kernel radius
constexpr int nodes = 500;

double node(int i) {
    return (i + 0.5) / nodes;
}

// Returns the Fourier transform of a separable window along an axis, or the Hankel transform of a round one.
double transform(const std::function<double(double)>& q, bool separable, double frequency) {
    double sum = 0;
    for (int i = 0; i < nodes; ++i) {
        const double x = node(i);
        const double phase = 2 * std::numbers::pi * frequency * x;
        sum += q(x) * (separable ? std::cos(phase) : x * boost::math::cyl_bessel_j(0, phase));
    }
    return sum / nodes;
}

} // namespace

SpectralPurity spectral_purity(const Window& window) {
    return spectral_purity([&](double x) { return value(window, x, 0); }, window.shape == Shape::separable);
}

SpectralPurity spectral_purity(const std::function<double(double)>& q, bool separable) {
    std::vector<double> power;
    for (double f = 0; f < highest; f += step)
        power.push_back(std::pow(transform(q, separable, f), 2));
    std::size_t end = 1;
    while (power[end + 1] < power[end])
        ++end;
    const double sidelobe = *std::max_element(power.begin() + static_cast<std::ptrdiff_t>(end), power.end());

    // By Parseval's theorem, the window itself gives the total power; what exceeds the lobe's power is
    // outside the lobe. Where a is the result of `transform`, 4 integral(a^2) df = integral(q^2) dx along a
    // separable window's axis, and (2 pi)^2 integral(a^2 f) df = integral(q^2 r) dr for a round window.
    double lobe = 0;
    double whole = 0;
    for (std::size_t i = 0; i < end; ++i) {
        const double f = (static_cast<double>(i) + 0.5) * step;
        lobe +=
            (power[i] + power[i + 1]) / 2 * step * (separable ? 4 : std::pow(2 * std::numbers::pi, 2) * f);
    }
    for (int i = 0; i < nodes; ++i)
        whole += std::pow(q(node(i)), 2) * (separable ? 1 : node(i)) / nodes;
    const double share = separable ? std::pow(lobe / whole, 2) : lobe / whole;
    return {10 * std::log10(sidelobe / power[0]), 1 - share};
}

} // namespace gabor::study
