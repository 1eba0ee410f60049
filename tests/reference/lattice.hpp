#pragma once

#include "reference/vector.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace gabor::noise {

/// The hash that all noises share: multiplication by `spread`, an odd number, spreads small integers over 32
/// bits, and `mix` mixes the bits of a word with a salt.
constexpr std::uint32_t spread = 0x9e3779b1u;
std::uint32_t mix(std::uint32_t word, std::uint32_t salt);

/// The index of a node or cell modulo a period or, if that is 0, modulo 2^32.
std::int32_t wrapped(std::int64_t index, std::int32_t period);

/// The noise in N dimensions as a complex number, whose imaginary part is the noise itself, and its gradient
/// per kernel radius.
template <std::size_t N>
struct Field {
    std::complex<double> value;
    std::array<std::complex<double>, N> slope{};

    /// Adds a noise whose kernel radii are `radius` times those of this noise.
    void add(double weight, const Field& other, const Vector<N>& radius = filled<N>(1)) {
        value += weight * other.value;
        for (std::size_t axis = 0; axis < N; ++axis)
            slope[axis] += weight / radius[axis] * other.slope[axis];
    }
};

/// Where to evaluate the noise, like GaborPlace and GaborPlace3d in the shaders.
template <std::size_t N>
struct Place {
    std::array<std::int32_t, N> cell{};
    Vector<N> local{};
    Vector<N> radius = filled<N>(1.5);    ///< nodes or cells per kernel radius
    std::array<std::int32_t, N> period{}; ///< in nodes or cells, 0 for none
    double time = 0;                      ///< in periods of the animation, 0 for none
};

/// A node's window along one axis and its derivatives, at a distance d in units of its radius; 0 if |d| >= 1.
/// Hann's window is (1 + cos pi d) / 2. For two taps, it is c / sqrt(c^2 + (1 - c)^2), where
///     c = (1 - |d|)^2 (1 + 2 |d|).
struct LatticeWindow {
    double value = 0;
    double slope = 0;
    double curvature = 0; ///< for Hann's window only
};
LatticeWindow lattice_window(int taps, double d);

/// The sum of the squared windows along an axis, which is the same at every point.
double lattice_energy(int taps);

/// The hash word of all nodes that share this index along an axis (0 x, 1 y, 2 z). It is odd and has 24 bits.
std::uint32_t lattice_line_word(std::int32_t index, int axis, std::uint32_t seed);

/// The same for a lattice with another salt than a seed's.
std::uint32_t salted_line_word(std::int32_t index, int axis, std::uint32_t salt);

/// Combines the words of the lines through a node into the node's word.
std::uint32_t node_word(const std::array<std::uint32_t, 2>& lines);
std::uint32_t node_word(const std::array<std::uint32_t, 3>& lines);

/// Another word, independent of this one.
std::uint32_t next_word(std::uint32_t word);

/// The word of a node: its column's word times its row's.
std::uint32_t lattice_word(std::int32_t column, std::int32_t row, std::uint32_t seed);

/// The seed of lobe `index` in a sum of independent noises.
std::uint32_t lattice_derived_seed(std::uint32_t seed, int index);

/// Maps u, uniform in [-1, 1], to a nearly normal value, which is one part of an amplitude.
double lattice_amplitude_part(double u);

/// The root mean square of the parts of all amplitudes.
double lattice_amplitude_deviation();

/// The complex amplitude of a word at a time in an animation of period 1. One part comes from the whole word,
/// the other from its low 20 bits. At other times than 0, it is a mix with two more amplitudes that are
/// derived from the word.
std::complex<double> lattice_amplitude(std::uint32_t word, double time = 0);

/// A noise on a lattice of nodes c, each with waves F_cm of amplitudes A_cm, in double precision, written
/// from the equations and not from the shaders:
///     n(p) = K Im sum_c h(p - c) sum_m A_cm exp(2 pi i F_cm.(p - c)).
template <std::size_t N>
class Lattice {
  public:
    struct Wave {
        Vector<N> wave;     ///< cycles per kernel radius
        std::uint32_t word; ///< selects the amplitude
    };
    /// Adds the waves of a node. `lines` has the words of the lines through the node, one along each axis.
    /// `number` counts the nodes around a point, along x first, then along y.
    using Waves = std::function<void(const std::array<std::uint32_t, N>& lines, std::size_t number,
                                     std::vector<Wave>& waves)>;

    /// `taps` is GABOR_TAPS. `frequency` is that of the waves; `correlation` returns the waves' own
    /// correlation at an offset, without that of the windows.
    Lattice(int taps, std::uint32_t seed, Waves waves, double frequency = 0,
            std::function<double(const Vector<N>&)> correlation = {})
        : taps_(taps), seed_(seed), waves_(std::move(waves)), frequency_(frequency),
          correlation_(std::move(correlation)) {}

    Field<N> field(const Place<N>& place) const;

    double frequency() const { return frequency_; }
    double correlation(const Vector<N>& offset) const { return correlation_(offset); }

  private:
    int taps_;
    std::uint32_t seed_;
    Waves waves_;
    double frequency_;
    std::function<double(const Vector<N>&)> correlation_;
};

/// The noise of gabor_field and gabor_field_3d: the same wave at each node.
template <std::size_t N>
Lattice<N> wave_noise(int taps, const Vector<N>& wave, std::uint32_t seed);

/// The wave vector for a frequency and an orientation in radians.
Vector<2> wave_along(double frequency, double orientation);

/// The noise of gabor_field_waves: a wave for each of the nine nodes around a point, row by row.
Lattice<2> map_noise(const std::array<Vector<2>, 9>& waves, std::uint32_t seed);

/// The noise of gabor_noise_isotropic and gabor_noise_3d_isotropic: three waves at each node, evenly spread
/// and turned at random.
Lattice<2> isotropic_noise(double frequency, std::uint32_t seed, int taps = 3);
Lattice<3> isotropic_noise_3d(double frequency, std::uint32_t seed);

/// Isotropic noise on a surface whose tangent plane is spanned by two orthogonal unit vectors.
Lattice<3> tangent_noise(double frequency, const std::array<Vector<3>, 2>& tangents, std::uint32_t seed);

/// Cosine, sine and intensity of a complex noise's stripes: `sharpness` times the value, limited to length 1,
/// and the length of the value.
std::array<double, 3> lattice_stripes(std::complex<double> value, double sharpness);

} // namespace gabor::noise
