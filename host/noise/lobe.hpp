#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gabor::noise {

/// Converts degrees, which users see, to radians, which GLSL takes.
constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// Converts radians to degrees.
constexpr double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Waves around one frequency and one orientation: part of a spectrum.
struct Lobe {
    double frequency = 4;          ///< cycles per kernel radius
    double orientation = 0;        ///< direction of the wave vector, in degrees clockwise from right
    double frequency_spread = 0;   ///< 0 to 1: frequencies are spread evenly over frequency * (1 +- this)
    double orientation_spread = 0; ///< 0 to 90 degrees (isotropic): directions are spread evenly over +- this
    double power = 1;              ///< relative to the other lobes
    /// The kernel's radius along x, relative to the default; inversely proportional to the bandwidth.
    double radius = 1;
    double stretch = 1; ///< the kernel's radius along y, divided by that along x

    std::array<double, 2> radii() const { return {radius, radius * stretch}; }
    double longest_radius() const { return radius * std::max(stretch, 1.0); }
    /// Tells whether all waves have the same frequency and orientation.
    bool is_one_wave() const { return frequency_spread == 0 && orientation_spread == 0; }
    /// Returns the orientation in radians, in [-pi, pi].
    double angle() const { return radians(std::remainder(orientation, 360.0)); }

    bool operator==(const Lobe&) const = default;
};

} // namespace gabor::noise
