#pragma once

#include "reference/lattice.hpp"

#include <cstdint>
#include <vector>

namespace gabor::noise {

/// A sum of independent noises, in double precision.
template <std::size_t N>
class Sum {
  public:
    struct Term {
        double weight;
        Lattice<N> noise;
        Vector<N> radius; ///< radii of its kernel
    };

    Sum() = default;
    Sum(const Lattice<N>& noise) { add(1, noise); }

    void add(double weight, const Lattice<N>& noise, const Vector<N>& radius = filled<N>(1)) {
        terms_.push_back({weight, noise, radius});
    }
    const std::vector<Term>& terms() const { return terms_; }

    /// A term whose kernel radius is not 1 has its own nodes: 3/2 per radius or, with a period, about as
    /// many, so that the period holds a whole number of nodes, at least 3.
    Field<N> field(const Place<N>& place) const;

    /// The noise after a Gaussian filter of covariance (dx dx^T + dy dy^T) / 4, by quadrature of the noise
    /// times the normal density.
    Field<N> filtered(const Place<N>& place, const Vector<N>& dx, const Vector<N>& dy) const;

    /// The share of the noise's variance that the same filter removes, by quadrature of the covariance.
    double removed(const Place<N>& place, const Vector<N>& dx, const Vector<N>& dy) const;

  private:
    std::vector<Term> terms_;
};

/// The correlation between two points x apart along an axis, for noise with Hann's window h: the integral of
/// h(t) h(t + x) divided by that of h^2.
double hann_correlation(double x);

/// The principal axes of the filter of Sum::filtered. Their lengths are its standard deviations.
template <std::size_t N>
std::array<Vector<N>, 2> principal_axes(const Vector<N>& dx, const Vector<N>& dy);

/// Like GaborLobe in shaders/gabor_spectrum.glsl, with the seed of the lobe's own noise.
struct SpectrumLobe {
    double frequency = 4; ///< cycles per unit of length
    double orientation = 0;
    Vector<2> radius{1, 1}; ///< radii of its kernel along x and y
    double power = 1;
    std::uint32_t seed = 0;
};
Sum<2> spectrum(const std::vector<SpectrumLobe>& lobes);

/// The lobes whose sum has waves within `orientation_spread` radians of the orientation and within a relative
/// `frequency_spread` of the frequency.
std::vector<SpectrumLobe> spread_lobes(double frequency, double orientation, double frequency_spread,
                                       double orientation_spread, std::uint32_t seed);

/// The noises of gabor_noise_surface and gabor_noise_surface_isotropic. Normals and directions have length 1.
Sum<3> surface_noise(const Vector<3>& normal, double frequency, const Vector<3>& direction,
                     std::uint32_t seed);
Sum<3> isotropic_surface_noise(const Vector<3>& normal, double frequency, std::uint32_t seed);

} // namespace gabor::noise
