#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace gabor::noise {

/// Solid and surface noise of shaders/gabor_lattice_3d.glsl in double precision, from the equations and not
/// from the shader: the oracle.
class Lattice3d {
  public:
    using Vector = std::array<double, 3>;

    /// Where to evaluate: as GaborPlace3d.
    struct Place {
        std::array<std::int32_t, 3> cell{};
        std::array<float, 3> local{};
        std::array<float, 3> radius{1.5f, 1.5f, 1.5f}; ///< nodes per kernel radius
        std::array<std::int32_t, 3> period{};          ///< in nodes, 0 for none
        float time = 0;                                ///< in periods of time, for animated noise
    };

    /// The noise as a complex number, whose imaginary part is the noise itself, and its gradient per kernel
    /// radius.
    struct Field {
        std::complex<double> value;
        std::array<std::complex<double>, 3> slope;
    };

    /// `wave` in cycles per kernel radius.
    Lattice3d(const Vector& wave, std::uint32_t seed, bool animated = false);

    Field field(const Place& place) const;

    /// The noise through a normal filter of covariance (dx dx^T + dy dy^T) / 4, by quadrature of the noise.
    Field filtered(const Place& place, const Vector& dx, const Vector& dy) const;

    /// The share of its variance that the same filter removes, by quadrature of the noise's covariance.
    double removed(const Place& place, const Vector& dx, const Vector& dy) const;

  private:
    using Complex = std::complex<double>;
    class Nodes;

    /// At an offset from the place, in node spacings.
    Field field(const Place& place, const Vector& offset, const Nodes& nodes) const;

    Vector wave_;
    std::uint32_t seed_;
    bool animated_;
};

/// One noise of a sum of independent ones.
struct WeightedWave {
    double weight;
    Lattice3d::Vector wave;
    std::uint32_t seed;
};

/// The sums of gabor_noise_3d_isotropic, gabor_noise_surface and gabor_noise_surface_isotropic. Normals and
/// directions have length 1.
std::vector<WeightedWave> isotropic_waves(double frequency, std::uint32_t seed);
std::vector<WeightedWave> surface_waves(const Lattice3d::Vector& normal, double frequency,
                                        const Lattice3d::Vector& direction, std::uint32_t seed);
std::vector<WeightedWave> surface_isotropic_waves(const Lattice3d::Vector& normal, double frequency,
                                                  std::uint32_t seed);

} // namespace gabor::noise
