#pragma once

#include "reference/field.hpp"

#include <array>
#include <complex>
#include <cstdint>

namespace gabor::noise {

/// A node's window along one axis and its derivatives, at a distance d in units of its radius; 0 if |d| >= 1.
/// Hann's window is (1 + cos pi d) / 2. For two taps, it is c / sqrt(c^2 + (1 - c)^2), where
///     c = (1 - |d|)^2 (1 + 2 |d|).
struct LatticeWindow {
    double value = 0;
    double slope = 0;
    double curvature = 0; ///< for Hann's window only
};
LatticeWindow lattice_window(int taps, double d);

/// The sum of the squared windows along an axis, the same at every place.
double lattice_energy(int taps);

/// The word of the nodes that share an index along an axis (0 x, 1 y, 2 z), odd and with 24 bits.
std::uint32_t lattice_line_word(std::int32_t index, int axis, std::uint32_t seed);

/// The word of a node: its column's word times its row's.
std::uint32_t lattice_word(std::int32_t column, std::int32_t row, std::uint32_t seed);

/// The seed of lobe `index` in a sum of independent noises.
std::uint32_t lattice_lobe_seed(std::uint32_t seed, int index);

/// Maps u, uniform in [-1, 1], to a nearly normal value, which is one part of an amplitude.
double lattice_amplitude_part(double u);

/// The root mean square of the parts of all amplitudes.
double lattice_amplitude_deviation();

/// The complex amplitude of a word. One part comes from the whole word, the other from its low 20 bits.
std::complex<double> lattice_amplitude(std::uint32_t word);

/// The same at a time in an animation of period 1, as a mix with two more amplitudes derived from the word.
std::complex<double> lattice_amplitude(std::uint32_t word, double time);

/// Where to evaluate the noise, like GaborPlace in shaders/gabor_lattice.glsl.
struct LatticePlace {
    std::int32_t cell_x = 0;
    std::int32_t cell_y = 0;
    double local_x = 0;
    double local_y = 0;
    double radius_x = 1.5; ///< nodes per kernel radius
    double radius_y = 1.5;
    std::int32_t period_x = 0; ///< in nodes, 0 for none
    std::int32_t period_y = 0;
    bool animated = false;
    double time = 0;
};

/// The noise of shaders/gabor_lattice.glsl in double precision, from the equations and not from the shader:
///     n(p) = K Im sum_ij A_ij h(x - x_i) h(y - y_j) exp(2 pi i F.(p - c_ij)).
class Lattice {
  public:
    /// `taps` is GABOR_TAPS; `frequency` is in cycles per kernel radius, `orientation` in radians.
    Lattice(int taps, double frequency, double orientation, std::uint32_t seed);

    /// `wave` is in cycles per kernel radius.
    Lattice(int taps, std::array<double, 2> wave, std::uint32_t seed);

    using Field = noise::Field;

    Field field(const LatticePlace& place) const;

    /// The noise with three taps and a wave vector for each of the nine nodes around the place, row by row.
    using Waves = std::array<std::array<double, 2>, 9>;
    static Field field(const LatticePlace& place, const Waves& waves, std::uint32_t seed);

  private:
    int taps_;
    double wave_x_;
    double wave_y_;
    std::uint32_t seed_;
};

/// gabor_noise_isotropic in double precision; each of the nine nodes has three waves 60 degrees apart, turned
/// at random:
///     n(p) = K / sqrt(3) Im sum_c h(x - c_x) h(y - c_y) sum_m A_cm exp(2 pi i F u_cm.(p - c)).
Lattice::Field lattice_isotropic(const LatticePlace& place, double frequency, std::uint32_t seed);

/// Cosine, sine and intensity of a complex noise's stripes: the value divided by its length if the length
/// exceeds 1 / sharpness, otherwise `sharpness` times the value.
std::array<double, 3> lattice_stripes(std::complex<double> value, double sharpness);

} // namespace gabor::noise
