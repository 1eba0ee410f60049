#pragma once

#include "largest.hpp"
#include "reference/reference.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace gabor::test {

inline std::string to_string(const noise::Place& p) {
    return fmt::format("cell ({}, {}) + ({}, {}), radius ({}, {}), period ({}, {}), time {}", p.cell_x,
                       p.cell_y, p.local_x, p.local_y, p.radius_x, p.radius_y, p.period_x, p.period_y,
                       p.time);
}

/// 1e-5 up to frequency 4, proportional to it above: single precision limits the phase.
inline double tolerance(double frequency) {
    return 1e-5 * std::max(1.0, frequency / 4);
}

/// Derivatives scale with the frequency.
inline double slope_tolerance(double frequency) {
    return tolerance(frequency) * (2 * std::numbers::pi * frequency + 2);
}

class Draw {
  public:
    explicit Draw(unsigned seed) : random_(seed) {}

    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    std::int32_t cell() { return static_cast<std::int32_t>(random_()); }
    float uniform(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }

    /// Draws places in all quadrants up to 10^6, or in any cell; one coordinate in four is on or next to a
    /// cell's edge.
    noise::Place place(const noise::Recipe& recipe) {
        const float reach = std::exp2(uniform(0, 20));
        noise::Place p = noise::place_at(recipe, 0, 0, uniform(-reach, reach), uniform(-reach, reach));
        if (word() % 4 == 0)
            p.local_x = std::round(p.local_x);
        if (word() % 4 == 0)
            p.local_y = std::nextafter(std::round(p.local_y), word() % 2 ? 1e9f : -1e9f);
        if (word() % 2) {
            p.cell_x = cell();
            p.cell_y = cell();
            p.local_x -= std::floor(p.local_x);
            p.local_y -= std::floor(p.local_y);
        }
        return p;
    }

  private:
    std::mt19937 random_;
};

} // namespace gabor::test
