#pragma once

#include "lattice.hpp"
#include "reference/lattice_3d.hpp"

#include <fmt/ranges.h>

namespace gabor::test {

inline noise::Lattice3d::Vector wide(gabor_vec3 v) {
    return {v.x, v.y, v.z};
}

inline gabor_vec3 narrow(const noise::Lattice3d::Vector& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

inline noise::Lattice3d::Vector scaled(double s, const noise::Lattice3d::Vector& v) {
    return {s * v[0], s * v[1], s * v[2]};
}

inline noise::Lattice3d::Vector unit(const noise::Lattice3d::Vector& v) {
    return scaled(1 / std::hypot(v[0], v[1], v[2]), v);
}

inline noise::Lattice3d::Vector unit(gabor_vec3 v) {
    return unit(wide(v));
}

inline noise::Lattice3d::Vector random_unit(Draw& draw) {
    return unit(draw.uniform<gabor_vec3>(-1, 1));
}

/// Arguments of functions in space. The steps of a pixel are those of the filter.
struct Sample3d {
    noise::Lattice3d::Place place;
    gabor_vec3 p{0, 0, 0}; ///< position in kernel radii, for functions that take one
    float frequency = 2;
    gabor_vec3 direction{1, 0, 0}, normal{0, 0, 1}, dx{0, 0, 0}, dy{0, 0, 0};
    std::uint32_t seed = 0;
};

inline std::string to_string(const Sample3d& s) {
    const auto numbers = [](gabor_vec3 v) { return std::array{v.x, v.y, v.z}; };
    return fmt::format(
        "cell {} + {}, radius {}, period {}, time {}, position {}, frequency {}, direction {}, "
        "normal {}, pixel {}, {}, seed {}",
        s.place.cell, s.place.local, s.place.radius, s.place.period, s.place.time, numbers(s.p), s.frequency,
        numbers(s.direction), numbers(s.normal), numbers(s.dx), numbers(s.dy), s.seed);
}

/// The place that functions of a position compute from it.
inline noise::Lattice3d::Place lattice_place(gabor_vec3 p) {
    return {{}, {p.x * 1.5f, p.y * 1.5f, p.z * 1.5f}};
}

/// Converts the sample's place to the drop-in's type.
template <typename Functions>
typename Functions::GaborPlace3d place_of(Functions&, const Sample3d& s, bool animated = false,
                                          bool filtered = false) {
    const auto& [cell, local, radius, period, time] = s.place;
    return {{cell[0], cell[1], cell[2]},
            {local[0], local[1], local[2]},
            {radius[0], radius[1], radius[2]},
            {period[0], period[1], period[2]},
            animated,
            time,
            filtered,
            s.dx,
            s.dy};
}

} // namespace gabor::test
