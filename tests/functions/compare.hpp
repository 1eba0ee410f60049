#pragma once

// Draws arguments for the drop-ins' functions, and compares their results with the double-precision
// reference.

#include "largest.hpp"
#include "reference/lattice.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <random>

namespace gabor::test {

/// The tolerance of a value: 1e-5 up to frequency 4, and proportional to the frequency above, where the
/// rounding of the phase dominates.
inline double tolerance(double frequency) {
    return 1e-5 * std::max(1.0, frequency / 4);
}

/// The tolerance of a derivative, which grows with the frequency.
inline double slope_tolerance(double frequency) {
    return tolerance(frequency) * (2 * std::numbers::pi * frequency + 2);
}

class Random {
  public:
    explicit Random(unsigned seed) : random_(seed) {}

    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    std::int32_t cell() { return static_cast<std::int32_t>(random_()); }
    bool one_in(unsigned n) { return word() % n == 0; }
    float uniform(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }

    /// Returns a vector of uniform numbers.
    template <typename Vector>
    Vector uniform(double low, double high) {
        Vector v;
        for (std::size_t axis = 0; axis < sizeof(Vector) / sizeof(float); ++axis)
            v[static_cast<int>(axis)] = uniform(low, high);
        return v;
    }

    /// Returns a float next to the multiple of `step` nearest to x, where a window or cell may end.
    float edge(float x, float step = 1) {
        return std::nextafter(step * std::round(x / step), word() % 2 ? 1e9f : -1e9f);
    }

  private:
    std::mt19937 random_;
};

template <std::size_t N>
std::string to_string(const noise::Place<N>& p) {
    return fmt::format("cell {} + {}, radius {}, period {}, time {}", p.cell, p.local, p.radius, p.period,
                       p.time);
}

// ---- Comparisons. They are templates because each class of translated functions has its own types.

/// Compares a complex number, whose imaginary part is the noise.
template <typename Place>
void see(Largest& largest, const auto& value, std::complex<double> expected, double tolerance,
         const Place& place) {
    largest.see(value.x, expected.real(), tolerance, place);
    largest.see(value.y, expected.imag(), tolerance, place);
}

/// Compares a field.
template <std::size_t N, typename Place>
void see(Largest& values, Largest& slopes, const auto& field, const noise::Field<N>& expected,
         double tolerance, double slope_tolerance, const Place& place) {
    values.see(field.noise, expected.value.imag(), tolerance, place);
    values.see(field.quadrature, expected.value.real(), tolerance, place);
    for (std::size_t axis = 0; axis < N; ++axis) {
        const int i = static_cast<int>(axis);
        slopes.see(field.gradient[i], expected.slope[axis].imag(), slope_tolerance, place);
        slopes.see(field.quadrature_gradient[i], expected.slope[axis].real(), slope_tolerance, place);
    }
}

/// The noise and its quadrature, as gabor_noise_quadrature returns them.
inline std::array<double, 2> noise_and_quadrature(std::complex<double> value) {
    return {value.imag(), value.real()};
}

/// Compares a noise and its gradient, given as (noise, d/dx, d/dy).
template <typename Place>
void see_gradient(Largest& values, Largest& slopes, const auto& gradient, const noise::Field<2>& expected,
                  double tolerance, double slope_tolerance, const Place& place) {
    values.see(gradient.x, expected.value.imag(), tolerance, place);
    slopes.see(gradient.y, expected.slope[0].imag(), slope_tolerance, place);
    slopes.see(gradient.z, expected.slope[1].imag(), slope_tolerance, place);
}

/// Compares the components of a vector.
template <std::size_t count, typename Place>
void see(Largest& largest, const auto& vector, const std::array<double, count>& expected, double tolerance,
         const Place& place) {
    for (std::size_t c = 0; c < count; ++c)
        largest.see(vector[static_cast<int>(c)], expected[c], tolerance, place);
}

/// Checks that a function has no jump as a pixel's position, size or rotation changes along a path. A step of
/// a smooth function equals the mean of the steps before and after it, to second order.
template <typename Value>
void check_path(Differences& of, int path, int steps, const Value& value) {
    Largest& largest = of[path % 3 == 0 ? "in position" : path % 3 == 1 ? "in size" : "in rotation"];
    std::array<double, 4> last{};
    for (int i = 0; i < steps; ++i) {
        last = {last[1], last[2], last[3], double{value(static_cast<double>(i) / steps)}};
        if (i > 2)
            largest.see(last[2], last[1] + 0.5 * ((last[1] - last[0]) + (last[3] - last[2])), 1e-4,
                        [&] { return fmt::format("step {} of path {}", i, path); });
    }
}

} // namespace gabor::test
