#include "study/variant.hpp"

#include "vulkan/pass.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace gabor::study {

namespace {

double second_moment(Law law, double floor) {
    switch (law) {
    case Law::uniform:
        return (1 + floor + floor * floor) / 3;
    case Law::two_point:
        return (1 + floor * floor) / 2;
    default:
        return 2;
    }
}

double fourth_moment(Law law, double floor) {
    switch (law) {
    case Law::uniform:
        return (1 + floor + floor * floor + std::pow(floor, 3) + std::pow(floor, 4)) / 5;
    case Law::two_point:
        return (1 + std::pow(floor, 4)) / 2;
    default:
        return 8;
    }
}

// The mean over [0, 1)^2, which is also an integral.
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

std::string_view name(Law law) {
    constexpr std::array names{"uniform", "two_point", "rayleigh"};
    return names[static_cast<std::size_t>(law)];
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
            constant(static_cast<int>(variant.law)),
            real(variant.floor),
            constant(static_cast<int>(variant.window.shape)),
            real(variant.window.c[0]),
            real(variant.window.c[1]),
            real(variant.window.c[2])};
}

double variance(const Variant& variant) {
    const double energy =
        4 * mean_over_cell(512, [&](double x, double y) { return std::pow(value(variant.window, x, y), 2); });
    return variant.impulses * variant.radius * variant.radius * second_moment(variant.law, variant.floor) *
           energy / 2;
}

double visited(const Variant& variant) {
    return variant.impulses * std::pow(2 * variant.radius + 1, 2);
}

// With a2 and a4 the second and fourth moments of the window over one cell, seen from a place, the fourth
// cumulant is the sum over cells of N (3/8 E[w^4] a4 - 3 (E[w^2] a2 / 2)^2), and 0 on average over the places
// where E[w^4] / E[w^2]^2 = 2 sum a2^2 / sum a4.
double mesokurtic_floor(const Variant& variant) {
    const int reach = static_cast<int>(std::ceil(variant.radius)) + 1;
    double squares = 0;
    double fourths = 0;
    mean_over_cell(4, [&](double px, double py) {
        for (int row = -reach; row <= reach; ++row) {
            const double shift = variant.lattice == Lattice::brick && row % 2 != 0 ? 0.5 : 0;
            for (int column = -reach; column <= reach; ++column) {
                const auto moment = [&](int power) {
                    return mean_over_cell(16, [&](double x, double y) {
                        return std::pow(value(variant.window, (px - column - shift - x) / variant.radius,
                                              (py - row - y) / variant.radius),
                                        power);
                    });
                };
                squares += std::pow(moment(2), 2);
                fourths += moment(4);
            }
        }
        return 0.0;
    });
    const double wanted = 2 * squares / fourths;
    double low = 0;
    double high = 1;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        const double ratio =
            fourth_moment(variant.law, middle) / std::pow(second_moment(variant.law, middle), 2);
        (ratio > wanted ? low : high) = middle;
    }
    return low;
}

} // namespace gabor::study
