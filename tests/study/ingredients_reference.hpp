#pragma once

#include "study/ingredients.hpp"
#include "study/noise.hpp"

#include <cstdint>
#include <vector>

namespace gabor::test {

struct Impulse {
    double x; ///< cells
    double y;
    double weight;
    double phase; ///< turns
};

/// The impulses of a cell, in double precision and from the definitions: the Sobol points from direction
/// numbers, the hexagons from the lattice by brute force.
std::vector<Impulse> cell_impulses(const study::Ingredients& ingredients, std::int32_t cell_x,
                                   std::int32_t cell_y, std::uint32_t seed);

/// The sum over all cells that can be reached, without K.
double ingredients_sum(const study::Ingredients& ingredients, const study::PlaneWave& wave, double x,
                       double y, std::uint32_t seed);

/// A value of passes/ingredients.comp: where it is, and of which instance.
struct Place {
    double x;
    double y;
    std::uint32_t seed;
};

Place random_place(std::uint32_t instance, std::uint32_t noise_seed, std::uint32_t place_seed);

} // namespace gabor::test
