#pragma once

#include "noise/recipe.hpp"

#include <cstdint>

namespace gabor::noise {

/// A position as shaders/gabor_noise.glsl takes it: (cell + local) / R kernel radii.
struct Position {
    std::int32_t cell_x = 0;
    std::int32_t cell_y = 0;
    float local_x = 0;
    float local_y = 0;
};

/// The word that holds everything about an impulse: y in its cell (bits 0 to 22), x (8 to 30), phase (0 to 7)
/// and magnitude (31).
std::uint32_t impulse_word(std::int32_t cell_x, std::int32_t cell_y, int index, std::uint32_t seed);

/// The noise in double precision, from the equations and not from the shader: the oracle.
class Reference {
  public:
    /// `frequency` in cycles per kernel radius, `orientation` in radians.
    Reference(const Recipe& recipe, double frequency, double orientation, std::uint32_t seed);

    double operator()(const Position& position) const;

  private:
    Recipe recipe_;
    double wave_x_;
    double wave_y_;
    double deviation_;
    std::uint32_t seed_;
};

} // namespace gabor::noise
