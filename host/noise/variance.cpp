#include "noise/variance.hpp"

#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

// integral over [-1, 1] of (1 - x^2)^n cos(a x) dx = 2^(n+1) n! j_n(a) / a^n: Poisson's integral,
// DLMF 10.54.1. Below a = 2 the power series of j_n, DLMF 10.53.1, where the quotient would lose digits.
double cosine_integral(unsigned n, double a) {
    const double scale = std::ldexp(std::tgamma(n + 1.0), static_cast<int>(n) + 1);
    if (std::abs(a) >= 2)
        return scale * std::sph_bessel(n, std::abs(a)) / std::pow(std::abs(a), n);
    double term = 1;
    for (unsigned odd = 3; odd <= 2 * n + 1; odd += 2)
        term /= odd;
    double sum = 0;
    for (int k = 1; k < 25; ++k) {
        sum += term;
        term *= -a * a / (2.0 * k * (2.0 * n + 2.0 * k + 1.0));
    }
    return scale * sum;
}

} // namespace

double window_energy(const Recipe& recipe, double a) {
    double energy = 0;
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
            energy += double{recipe.window[i]} * recipe.window[j] * cosine_integral(4 + i + j, a);
    return energy;
}

double variance(const Recipe& recipe, double frequency, double orientation, double time) {
    constexpr double pi = std::numbers::pi;
    const double density = recipe.impulses * double{recipe.radius} * recipe.radius;
    const double power = (1 + double{recipe.weight_floor} * recipe.weight_floor) / 2;
    const double whole = window_energy(recipe, 0);
    // The mean of sin^2 over four or more phases is 1/2. Over two half a turn apart it is (1 - cos) / 2, and
    // where time has turned them, the mean of that over the turns.
    double oscillating = 0;
    if (recipe.phases == 2) {
        const double a = 4 * pi * frequency;
        oscillating = window_energy(recipe, a * std::cos(orientation)) *
                      window_energy(recipe, a * std::sin(orientation));
        double turned = 0;
        for (int tempo = 1; tempo <= 4; ++tempo)
            turned += std::cos(4 * pi * tempo * time) / 4;
        oscillating *= turned;
    }
    return density * power * (whole * whole - oscillating) / 2;
}

} // namespace gabor::noise
