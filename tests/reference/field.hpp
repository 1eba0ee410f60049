#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace gabor::noise {

/// The noise in the plane as a complex number, whose imaginary part is the noise itself, and its gradient per
/// kernel radius.
struct Field {
    std::complex<double> value;
    std::complex<double> slope_x;
    std::complex<double> slope_y;
    std::array<double, 4> four{}; ///< independent noises, first the noise itself; lattice noise only

    /// Adds a noise whose kernel radii along x and y are `radius` times those of this one.
    void add(double weight, const Field& other, std::array<double, 2> radius = {1, 1}) {
        value += weight * other.value;
        slope_x += weight / radius[0] * other.slope_x;
        slope_y += weight / radius[1] * other.slope_y;
        for (std::size_t i = 0; i < four.size(); ++i)
            four[i] += weight * other.four[i];
    }

    Field scaled(double by) const {
        Field result;
        result.add(by, *this);
        return result;
    }
};

} // namespace gabor::noise
