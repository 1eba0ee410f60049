#pragma once

#include "noise.hpp"

namespace gabor::test {

/// Arguments for the functions of noise in space.
struct Sample3d {
    noise::Place<3> place;
    gabor_vec3 p{0, 0, 0}; ///< position in kernel radii, for functions that take no place
    float frequency = 2;
    gabor_vec3 direction{1, 0, 0}, normal{0, 0, 1};
    std::uint32_t seed = 0;
};

inline std::string to_string(const Sample3d& s) {
    return fmt::format("{}, position {}, frequency {}, direction {}, normal {}, seed {}", to_string(s.place),
                       wide(s.p), s.frequency, wide(s.direction), wide(s.normal), s.seed);
}

} // namespace gabor::test
