#pragma once

#include "noise/recipe.hpp"
#include "reference/lattice.hpp"

#include <cstdint>

namespace gabor::noise {

/// The position (cell + local) / R, in kernel radii, in a recipe's noise without periods.
Place<2> place_at(const Recipe& recipe, std::int32_t cell_x, std::int32_t cell_y, double local_x,
                  double local_y);

/// The word that holds everything about an impulse: y in its cell (bits 0 to 22), x (8 to 30), phase (0 to 7)
/// and magnitude (31).
std::uint32_t impulse_word(std::int32_t cell_x, std::int32_t cell_y, int index, std::uint32_t seed);

/// The oracle: the noise in double precision, written from the equations and not from the shader.
class Reference {
  public:
    /// `frequency` is in cycles per kernel radius, `orientation` in radians.
    Reference(const Recipe& recipe, double frequency, double orientation, std::uint32_t seed);

    Field<2> field(const Place<2>& place) const;

    double operator()(const Place<2>& place) const { return field(place).value.imag(); }

  private:
    Recipe recipe_;
    double frequency_;
    double orientation_;
    mutable double time_ = 0;  // of the last place
    mutable double deviation_; // at that time
    std::uint32_t seed_;
};

} // namespace gabor::noise
