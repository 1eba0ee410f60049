#pragma once

#include "reference/lattice.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace gabor::noise {

/// Like GaborLobe in shaders/gabor_spectrum.glsl, with the seed of the lobe's own noise.
struct SpectrumLobe {
    double frequency = 4; ///< cycles per unit of length
    double orientation = 0;
    std::array<double, 2> radius{1, 1}; ///< radii of its kernel along x and y
    double power = 1;
    std::uint32_t seed = 0;
};

/// The lobes whose sum has waves within `orientation_spread` radians of the orientation and within a relative
/// `frequency_spread` of the frequency.
std::vector<SpectrumLobe> spread_lobes(double frequency, double orientation, double frequency_spread,
                                       double orientation_spread, std::uint32_t seed);

/// The oracle: a sum of lattice noises in double precision, from the equations and not from the shader.
class Spectrum {
  public:
    explicit Spectrum(std::vector<SpectrumLobe> lobes) : lobes_(std::move(lobes)) {}

    /// Slopes are per unit of length.
    using Field = noise::Field;

    Field field(double x, double y) const;

    /// The same at a place. A lobe whose kernel radius is not 1 has its own nodes: 3/2 per radius, or as many
    /// as put a whole number, at least 3, into a period.
    Field field(const LatticePlace& place) const;

    using Vector = std::array<double, 2>;

    /// The noise through a normal filter of covariance (dx dx^T + dy dy^T) / 4, by quadrature of the noise
    /// against the normal density.
    Field filtered(double x, double y, Vector dx, Vector dy) const;

    /// The share of its variance that the same filter removes, by quadrature of the noise's covariance.
    double removed(Vector dx, Vector dy) const;

  private:
    std::vector<SpectrumLobe> lobes_;
};

} // namespace gabor::noise
