#pragma once

// gabor_noise.glsl and the drop-ins that need it, translated to C++. Each class has the functions for one
// number of taps as members. tests/render/test_golden.cpp checks that the device computes the same values.

#include "compare.hpp"
#include "reference/sum.hpp"

#include "gabor_noise.hpp" // for gabor_vec2 and gabor_vec3

namespace gabor::test {

namespace { // each source compiles its own copy, with its own compiler options

#undef GABOR_TAPS
#undef GABOR_NOISE_HPP
struct Lattice2 {
    static constexpr int taps = 2;
#define GABOR_TAPS 2
#include "gabor_noise.hpp"

#include "gabor_erosion.hpp"
};

#undef GABOR_TAPS
#undef GABOR_NOISE_HPP
#undef GABOR_EROSION_HPP
struct Lattice4 {
    static constexpr int taps = 4;
#define GABOR_TAPS 4
#include "gabor_noise.hpp"
};

#undef GABOR_TAPS
#undef GABOR_NOISE_HPP
struct Lattice3 {
    static constexpr int taps = 3;
#define GABOR_LOBES 3
#include "gabor_noise.hpp"

#include "gabor_erosion.hpp"
#include "gabor_spectrum.hpp"

#include "gabor_noise_3d.hpp"

    /// A direction map with a jump across the line x + y = 1.
    static gabor_vec2 map_at(gabor_vec2 p) {
        return p.x + p.y > 1 ? gabor_vec2(1.5f, 0.25f * p.y) : gabor_vec2(-0.5f * p.x, 2);
    }
#define GABOR_DIRECTION(p) map_at(p)
#include "gabor_direction.hpp"
};

} // namespace

inline noise::Vector<2> wide(gabor_vec2 v) {
    return {v.x, v.y};
}
inline noise::Vector<3> wide(gabor_vec3 v) {
    return {v.x, v.y, v.z};
}
inline gabor_vec2 narrow(const noise::Vector<2>& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1])};
}
inline gabor_vec3 narrow(const noise::Vector<3>& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

template <std::size_t N>
noise::Vector<N> random_unit(Random& random) {
    noise::Vector<N> v;
    for (double& coordinate : v)
        coordinate = random.uniform(-1, 1);
    return noise::unit(v);
}

/// Converts lobes to the reference's type.
inline std::vector<noise::SpectrumLobe> reference_lobes(const Lattice3::GaborLobes& lobes,
                                                        std::uint32_t seed) {
    std::vector<noise::SpectrumLobe> all;
    for (const auto& [frequency, orientation, radius, power] : lobes.lobe)
        all.push_back({frequency, orientation, wide(radius), power,
                       noise::lattice_lobe_seed(seed, static_cast<int>(all.size()))});
    return all;
}

/// Converts a place to the drop-in's type.
template <typename Functions>
auto place_of(Functions&, const noise::Place<2>& place) {
    const auto& [cell, local, radius, period, animated, time] = place;
    return typename Functions::GaborPlace{{cell[0], cell[1]},     narrow(local), narrow(radius),
                                          {period[0], period[1]}, animated,      static_cast<float>(time)};
}

/// Converts a place in space. With `filtered`, the noise is averaged over a pixel with the steps dx and dy.
template <typename Functions>
typename Functions::GaborPlace3d place_of(Functions&, const noise::Place<3>& place, bool filtered = false,
                                          gabor_vec3 dx = {0, 0, 0}, gabor_vec3 dy = {0, 0, 0}) {
    const auto& [cell, local, radius, period, animated, time] = place;
    return {{cell[0], cell[1], cell[2]},
            narrow(local),
            narrow(radius),
            {period[0], period[1], period[2]},
            animated,
            static_cast<float>(time),
            filtered,
            dx,
            dy};
}

/// The place that a function of a position p computes from p in single precision.
template <typename Vector>
auto lattice_place(int taps, const Vector& p) {
    noise::Place<sizeof(Vector) / sizeof(float)> place;
    for (std::size_t axis = 0; axis < place.local.size(); ++axis) {
        place.local[axis] = p[static_cast<int>(axis)] * (0.5f * static_cast<float>(taps));
        place.radius[axis] = 0.5 * taps;
    }
    return place;
}

/// The place that a tiled function computes from p. `p` and `tile` are in kernel radii.
template <typename Vector>
auto lattice_tile(int taps, const Vector& p, const Vector& tile) {
    auto place = lattice_place(taps, p);
    for (std::size_t axis = 0; axis < place.local.size(); ++axis) {
        const double period = tile[static_cast<int>(axis)], turns = p[static_cast<int>(axis)] / period;
        const int nodes = std::max(static_cast<int>(std::floor(period * 0.5 * taps + 0.5)), taps);
        place.period[axis] = nodes;
        place.radius[axis] = nodes / period;
        place.local[axis] = (turns - std::floor(turns)) * nodes;
    }
    return place;
}

/// Draws a position near the origin or in any cell, with or without a period, still or animated. Nearly half
/// of all coordinates are on or next to a multiple of 1/2, where windows and cells may end.
inline noise::Place<2> any_lattice_place(Random& random, int taps) {
    noise::Place<2> place;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        place.cell[axis] =
            random.word() % 2 ? random.cell() : static_cast<std::int32_t>(random.uniform(-5, 5));
        float at = random.uniform(-2, 3);
        if (random.one_in(4))
            at = 0.5f * std::round(2 * at);
        if (random.one_in(4))
            at = random.edge(at, 0.5f);
        place.local[axis] = at;
        place.radius[axis] = 0.5f * static_cast<float>(taps) * random.uniform(0.8, 1.3);
        place.period[axis] = random.word() % 2 ? taps + static_cast<std::int32_t>(random.word() % 50) : 0;
    }
    place.animated = random.word() % 2;
    place.time = random.uniform(-2, 2);
    return place;
}

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

/// The standard deviation of one component of the gradient of isotropic noise in the plane. The waves
/// contribute 2 pi^2 F^2 to its square, and the windows pi^2 / 3.
inline double isotropic_slope(double frequency) {
    using std::numbers::pi;
    return std::sqrt(2 * pi * pi * frequency * frequency + pi * pi / 3);
}

} // namespace gabor::test
