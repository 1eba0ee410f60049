#pragma once

#include "noise/recipe.hpp"

#include <array>
#include <complex>
#include <cstdint>

namespace gabor::noise {

using Vector3 = std::array<double, 3>;

/// The recipe with the lowest sidelobes, as noise::recipe_3d.
const Recipe& pure_recipe_3d();

/// Variance of sum_i q(d.x) q(d.y) q(d.z) sin(2 pi (f_i.d + phase_i)) by Campbell's theorem: the number
/// of impulses per unit volume times the mean energy of the kernels, whatever the f_i.
double variance_3d(const Recipe& recipe);

/// s^2 of the Gaussian exp(-x^2 / (2 s^2)) with the second moment of the recipe's window.
double window_variance(const Recipe& recipe);

/// Where to evaluate: as GaborPlace3d in shaders/gabor_noise_3d.glsl.
struct Place3d {
    std::array<std::int32_t, 3> cell{};
    std::array<float, 3> local{};
    std::array<float, 3> radius{1, 1, 1}; ///< cells per kernel radius
    std::array<std::int32_t, 3> period{}; ///< in cells, 0 for none
    float time = 0;
};

/// The wave vectors of the impulses, and the footprint through which they are seen.
struct Waves {
    Vector3 direction{};  ///< unit vector along the waves of all impulses, or 0 where each has its own
    Vector3 normal{};     ///< unit vector of a surface to which they are tangent, or 0
    double frequency = 1; ///< cycles per kernel radius
    Vector3 dx{};         ///< from one pixel to the next, in kernel radii; 0 for no footprint
    Vector3 dy{};
};

/// What the bits of an impulse's word mean.
struct Impulse3d {
    explicit Impulse3d(std::uint32_t word);

    Vector3 place; ///< in its cell
    double phase;  ///< turns
    int tempo;     ///< turns of the phase in a period of time
    Vector3 direction;
};

/// The word of impulse `index` in a cell.
std::uint32_t impulse_word_3d(const std::array<std::int32_t, 3>& cell, int index, std::uint32_t seed);

/// The noise in space in double precision, from the equations and not from the shader: the oracle.
class Reference3d {
  public:
    Reference3d(const Recipe& recipe, const Waves& waves, std::uint32_t seed);

    /// The noise as a complex number, whose imaginary part is the noise itself, and its gradient per kernel
    /// radius while the waves stay as they are.
    struct Field {
        std::complex<double> value;
        std::array<std::complex<double>, 3> slope;
    };

    Field field(const Place3d& place) const;

    double operator()(const Place3d& place) const { return field(place).value.imag(); }

  private:
    Recipe recipe_;
    Waves waves_;
    std::array<Vector3, 3> shift_; ///< D in the shader's gabor_filtered_3d
    double damping_;               ///< 2 pi^2 s^2 there
    double amplitude_;
    std::uint32_t seed_;
};

} // namespace gabor::noise
