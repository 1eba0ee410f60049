#pragma once

#include "noise/recipe.hpp"
#include "reference/field.hpp"

#include <cstdint>

namespace gabor::noise {

/// Where to evaluate the noise, like GaborPlace in shaders/gabor_noise.glsl.
struct Place {
    std::int32_t cell_x = 0;
    std::int32_t cell_y = 0;
    float local_x = 0;
    float local_y = 0;
    float radius_x = 1; ///< cells per kernel radius
    float radius_y = 1;
    std::int32_t period_x = 0; ///< in cells, 0 for none
    std::int32_t period_y = 0;
    float time = 0;
};

/// The place (cell + local) / R kernel radii of a recipe's noise without periods.
Place place_at(const Recipe& recipe, std::int32_t cell_x, std::int32_t cell_y, float local_x, float local_y);

/// The word that holds everything about an impulse: y in its cell (bits 0 to 22), x (8 to 30), phase (0 to 7)
/// and magnitude (31).
std::uint32_t impulse_word(std::int32_t cell_x, std::int32_t cell_y, int index, std::uint32_t seed);

/// The oracle: the noise in double precision, from the equations and not from the shader.
class Reference {
  public:
    /// `frequency` is in cycles per kernel radius, `orientation` in radians.
    Reference(const Recipe& recipe, double frequency, double orientation, std::uint32_t seed);

    using Field = noise::Field;

    Field field(const Place& place) const;

    double operator()(const Place& place) const { return field(place).value.imag(); }

  private:
    Recipe recipe_;
    double frequency_;
    double orientation_;
    double deviation_;
    std::uint32_t seed_;
};

} // namespace gabor::noise
