#pragma once

#include "lattice.hpp"
#include "reference/sum.hpp"

namespace gabor::test {

inline noise::Vector<3> random_unit(Draw& draw) {
    return noise::unit(wide(draw.uniform<gabor_vec3>(-1, 1)));
}

/// Arguments of functions in space. The steps to the next pixels, dx and dy, determine the filter.
struct Sample3d {
    noise::Place<3> place;
    gabor_vec3 p{0, 0, 0}; ///< position in kernel radii, for functions that take one
    float frequency = 2;
    gabor_vec3 direction{1, 0, 0}, normal{0, 0, 1}, dx{0, 0, 0}, dy{0, 0, 0};
    std::uint32_t seed = 0;
};

inline std::string to_string(const Sample3d& s) {
    return fmt::format("{}, position {}, frequency {}, direction {}, normal {}, pixel {}, {}, seed {}",
                       to_string(s.place), wide(s.p), s.frequency, wide(s.direction), wide(s.normal),
                       wide(s.dx), wide(s.dy), s.seed);
}

/// Converts the sample's place to the drop-in's type.
template <typename Functions>
typename Functions::GaborPlace3d place_of(Functions&, const Sample3d& s, bool filtered = false) {
    const auto& [cell, local, radius, period, animated, time] = s.place;
    return {{cell[0], cell[1], cell[2]},
            narrow(local),
            narrow(radius),
            {period[0], period[1], period[2]},
            animated,
            static_cast<float>(time),
            filtered,
            s.dx,
            s.dy};
}

} // namespace gabor::test
