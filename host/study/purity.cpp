#include "study/purity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gabor::study {

namespace {

constexpr double step = 0.01; // cycles per radius
constexpr double highest = 8; // cycles per radius
constexpr int nodes = 500;

double node(int i) {
    return (i + 0.5) / nodes;
}

// The Fourier transform of a separable window along an axis, or of a round one, which is Hankel's.
double transform(const Window& window, double frequency) {
    using std::numbers::pi;
    double sum = 0;
    for (int i = 0; i < nodes; ++i) {
        const double x = node(i);
        const double phase = 2 * pi * frequency * x;
        sum += value(window, x, 0) *
               (window.shape == Shape::separable ? std::cos(phase) : x * std::cyl_bessel_j(0.0, phase));
    }
    return sum / nodes;
}

} // namespace

Purity purity(const Window& window) {
    const bool separable = window.shape == Shape::separable;
    std::vector<double> power;
    for (double f = 0; f < highest; f += step)
        power.push_back(std::pow(transform(window, f), 2));
    std::size_t end = 1;
    while (power[end + 1] < power[end])
        ++end;
    const double sidelobe = *std::max_element(power.begin() + static_cast<std::ptrdiff_t>(end), power.end());

    // By Parseval's theorem the whole power is that of the window; what is missing in the lobe is outside. On
    // a separable window's axis, 2 integral(a^2) df = integral(q^2) dx / 2; for a round one with Hankel's
    // transform, (2 pi)^2 integral(a^2 f) df = integral(w^2 r) dr.
    double lobe = 0;
    double whole = 0;
    for (std::size_t i = 0; i < end; ++i) {
        const double f = (static_cast<double>(i) + 0.5) * step;
        lobe +=
            (power[i] + power[i + 1]) / 2 * step * (separable ? 4 : std::pow(2 * std::numbers::pi, 2) * f);
    }
    for (int i = 0; i < nodes; ++i)
        whole += std::pow(value(window, node(i), 0), 2) * (separable ? 1 : node(i)) / nodes;
    const double share = separable ? std::pow(lobe / whole, 2) : lobe / whole;
    return {10 * std::log10(sidelobe / power[0]), 1 - share};
}

} // namespace gabor::study
