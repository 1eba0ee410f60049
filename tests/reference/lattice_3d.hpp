#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

namespace gabor::noise {

/// The oracle for solid and surface noise: shaders/gabor_lattice_3d.glsl in double precision, from the
/// equations and not from the shader.
class Lattice3d {
  public:
    using Vector = std::array<double, 3>;

    /// Where to evaluate the noise, like GaborPlace3d.
    struct Place {
        std::array<std::int32_t, 3> cell{};
        std::array<float, 3> local{};
        std::array<float, 3> radius{1.5f, 1.5f, 1.5f}; ///< nodes per kernel radius
        std::array<std::int32_t, 3> period{};          ///< in nodes, 0 for none
        float time = 0;                                ///< in periods of the animation
    };

    /// The noise as a complex number, whose imaginary part is the noise itself, and its gradient per kernel
    /// radius.
    struct Field {
        std::complex<double> value;
        std::array<std::complex<double>, 3> slope;
    };

    /// `wave` is in cycles per kernel radius.
    Lattice3d(const Vector& wave, std::uint32_t seed, bool animated = false);

    Field field(const Place& place) const;

    /// The noise through a normal filter of covariance (dx dx^T + dy dy^T) / 4, by quadrature of the noise.
    Field filtered(const Place& place, const Vector& dx, const Vector& dy) const;

    /// The share of its variance that the same filter removes, by quadrature of the noise's covariance.
    double removed(const Place& place, const Vector& dx, const Vector& dy) const;

  private:
    using Complex = std::complex<double>;
    class Nodes;

    /// The field at an offset from the place, in node spacings.
    Field field(const Place& place, const Vector& offset, const Nodes& nodes) const;

    Vector wave_;
    std::uint32_t seed_;
    bool animated_;
};

/// One noise in a sum of independent noises.
struct WeightedWave {
    double weight;
    Lattice3d::Vector wave;
    std::uint32_t seed;
};

/// The terms of gabor_noise_surface's sum. Normals and directions have length 1.
std::vector<WeightedWave> surface_waves(const Lattice3d::Vector& normal, double frequency,
                                        const Lattice3d::Vector& direction, std::uint32_t seed);

/// gabor_noise_3d_isotropic, or one of the two noises of gabor_noise_surface_isotropic. Each node of the
/// lattice has waves along its own frame:
///     n(p) = K Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
class Isotropic3d {
  public:
    using Vector = Lattice3d::Vector;
    using Frame = std::array<Vector, 3>;
    /// Two unit vectors at right angles to each other and to a surface's normal.
    using Tangents = std::array<Vector, 2>;

    Isotropic3d(double frequency, std::uint32_t seed, bool animated = false);
    Isotropic3d(double frequency, const Tangents& tangents, std::uint32_t seed, bool animated = false);

    /// The same as Lattice3d::field.
    Lattice3d::Field field(const Lattice3d::Place& place) const;
    Lattice3d::Field filtered(const Lattice3d::Place& place, const Vector& dx, const Vector& dy) const;
    double removed(const Lattice3d::Place& place, const Vector& dx, const Vector& dy) const;

  private:
    struct Wave {
        Vector wave;
        std::complex<double> amplitude;
    };
    struct Node {
        Vector index;
        std::vector<Wave> waves;
    };
    std::vector<Node> nodes(const Lattice3d::Place& place, const Vector& reach) const;
    Lattice3d::Field field(const Lattice3d::Place& place, const Vector& offset,
                           const std::vector<Node>& nodes) const;

    double frequency_;
    std::optional<Tangents> tangents_;
    std::uint32_t seed_;
    bool animated_;
};

/// The frame of a node of noise in space, from its word.
Isotropic3d::Frame isotropic_frame(std::uint32_t word);

/// One of the noises of gabor_noise_surface_isotropic. The normal has length 1.
struct WeightedIsotropic {
    double weight;
    Isotropic3d noise;
};
std::vector<WeightedIsotropic> surface_isotropic(const Lattice3d::Vector& normal, double frequency,
                                                 std::uint32_t seed, bool animated = false);

} // namespace gabor::noise
