#include "noise/variance.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/hypergeometric_0F1.hpp>
#include <boost/math/special_functions/sinc.hpp>

#include <cmath>
#include <numbers>

namespace gabor::noise {

namespace {

// integral over [-1, 1] of (1 - x^2)^n cos(a x) dx = B(1/2, n + 1) 0F1(; n + 3/2; -a^2 / 4): Poisson's
// integral, DLMF 10.9.4 with 10.16.9.
double cosine_integral(unsigned n, double a) {
    return boost::math::beta(0.5, n + 1.0) * boost::math::hypergeometric_0F1(n + 1.5, -a * a / 4);
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
    // The mean of sin^2 over four or more phases is 1/2. Over two phases half a turn apart it is 1/2 minus
    // half the cosine of twice the angle; with time, phases turn 1 to 4 times, and this is averaged.
    double oscillating = 0;
    if (recipe.phases == 2) {
        const double a = 4 * pi * frequency;
        oscillating = window_energy(recipe, a * std::cos(orientation)) *
                      window_energy(recipe, a * std::sin(orientation));
        double turned = 0;
        for (int turns = 1; turns <= 4; ++turns)
            turned += std::cos(4 * pi * turns * time) / 4;
        oscillating *= turned;
    }
    return density * power * (whole * whole - oscillating) / 2;
}

// Let H be the transform of Hann's window: the power at a distance q from the wave is 4/3 H^2. The noise's
// variance is the integral over q of 4/3 H^2 exp(-4 pi^2 deviation^2 (frequency + q)^2); the slope's has the
// factor (2 pi (frequency + q))^2. Except for the filter's tails, the integrands' transforms end at 2 kernel
// radii, so a sum in steps of 1/10 equals the integral.
AxisVariance filtered_variance(double frequency, double deviation) {
    constexpr double tau = 2 * std::numbers::pi;
    constexpr double step = 0.1;
    const auto box = [](double q) { return boost::math::sinc_pi(tau * q); };
    AxisVariance left{};
    for (int k = -200; k <= 200; ++k) {
        const double q = step * k;
        const double hann = box(q) + (box(q - 0.5) + box(q + 0.5)) / 2;
        const double turn = tau * (frequency + q);
        const double power = 4.0 / 3 * step * hann * hann * std::exp(-turn * turn * deviation * deviation);
        left.noise += power;
        left.slope += power * turn * turn;
    }
    return left;
}

} // namespace gabor::noise
