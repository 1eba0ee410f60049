#pragma once

#include "study/ingredients.hpp"
#include "study/noise.hpp"

#include <cstdint>
#include <vector>

namespace gabor::test {

struct Impulse {
    double x; ///< in cells
    double y;
    double weight;
    double phase; ///< in turns
};

/// The impulses of a cell in double precision, from the definitions: Sobol points from direction numbers, and
/// hexagons from the lattice by brute force.
std::vector<Impulse> cell_impulses(const study::Ingredients& ingredients, std::int32_t cell_x,
                                   std::int32_t cell_y, std::uint32_t seed);

/// The sum of all impulses within reach, without the normalization K.
double ingredients_sum(const study::Ingredients& ingredients, const study::PlaneWave& wave, double x,
                       double y, std::uint32_t seed);

/// The position and the instance's seed of a value that passes/ingredients.comp computes.
struct Place {
    double x;
    double y;
    std::uint32_t seed;
};

Place random_place(std::uint32_t instance, std::uint32_t noise_seed, std::uint32_t place_seed);

} // namespace gabor::test
