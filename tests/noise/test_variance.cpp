#include "noise/variance.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

using namespace gabor;
using std::numbers::pi;

namespace {

double integrate(const std::function<double(double)>& f, double from, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, 12, 1e-13);
}

double window_squared(const noise::Recipe& recipe, double x) {
    const double u = 1 - x * x;
    const double q = u * u * (recipe.window[0] + recipe.window[1] * u + recipe.window[2] * u * u);
    return q * q;
}

constexpr noise::Recipe sines{"sines", 3, 1.5f, 0.2f, 2, {0.5f, 1.5f, -1}, ""};

} // namespace

TEST_CASE("the window's energy agrees with quadrature", "[noise]") {
    const noise::Recipe recipe =
        GENERATE(noise::find_recipe("one"), noise::find_recipe("pure"), noise::find_recipe("paper"), sines);
    const double a = GENERATE(0.0, 1e-4, 0.1, 0.9999, 1.0, 3.0, 5.9, 6.1, 20.0, 120.0, 800.0);
    const double expected =
        integrate([&](double x) { return window_squared(recipe, x) * std::cos(a * x); }, -1, 1);
    INFO("recipe " << recipe.name << ", a = " << a);
    CHECK(noise::window_energy(recipe, a) == Approx(expected).margin(1e-12));
    CHECK(noise::window_energy(recipe, -a) == Approx(expected).margin(1e-12));
}

TEST_CASE("the variance at any time agrees with Campbell's theorem, integrated by quadrature", "[noise]") {
    const noise::Recipe recipe =
        GENERATE(noise::find_recipe("one"), noise::find_recipe("pure"), noise::find_recipe("paper"), sines);
    const double frequency = GENERATE(0.1, 0.5, 1.0, 4.0), time = GENERATE(0.0, 0.13);
    const double orientation = GENERATE(0.0, 30.0, 45.0, 200.0) * pi / 180;
    // The mean square of the sine over the phases of impulses, which turn 1 to 4 times per period.
    const auto square = [&](double x, double y) {
        if (recipe.phases != 2)
            return 0.5;
        const double wave = frequency * (x * std::cos(orientation) + y * std::sin(orientation));
        double sum = 0;
        for (int turns = 1; turns <= 4; ++turns)
            sum += std::pow(std::sin(2 * pi * (wave + turns * time)), 2);
        return sum / 4;
    };
    const double energy = integrate(
        [&](double y) {
            return window_squared(recipe, y) *
                   integrate([&](double x) { return window_squared(recipe, x) * square(x, y); }, -1, 1);
        },
        -1, 1);
    const double magnitude_squared = (1 + std::pow(double{recipe.weight_floor}, 2)) / 2;
    const double density = recipe.impulses * double{recipe.radius} * recipe.radius;
    INFO("recipe " << recipe.name << ", frequency " << frequency << ", orientation " << orientation
                   << ", time " << time);
    CHECK(noise::variance(recipe, frequency, orientation, time) ==
          Approx(density * magnitude_squared * energy).epsilon(1e-9));
}
