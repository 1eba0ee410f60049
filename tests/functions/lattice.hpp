#pragma once

// gabor_lattice.glsl and the drop-ins that need it, translated to C++. For each number of taps, a class has
// their functions as members. tests/golden shows that devices and translations give the same values.

#include "compare.hpp"
#include "reference/lattice.hpp"

#include "gabor_lattice.hpp" // for its vectors

namespace gabor::test {

namespace { // each file compiles its own copy, with its own options

#undef GABOR_TAPS
#undef GABOR_LATTICE_HPP
struct Lattice2 {
    static constexpr int taps = 2;
#define GABOR_TAPS 2
#include "gabor_lattice.hpp"

#include "gabor_erosion.hpp"
};

#undef GABOR_TAPS
#undef GABOR_LATTICE_HPP
#undef GABOR_EROSION_HPP
struct Lattice4 {
    static constexpr int taps = 4;
#define GABOR_TAPS 4
#include "gabor_lattice.hpp"
};

#undef GABOR_TAPS
#undef GABOR_LATTICE_HPP
struct Lattice3 {
    static constexpr int taps = 3;
#define GABOR_LOBES 3
#include "gabor_lattice.hpp"

#include "gabor_erosion.hpp"
#include "gabor_spectrum.hpp"

#include "gabor_lattice_3d.hpp"

    /// A map with a jump.
    static gabor_vec2 map_at(gabor_vec2 p) {
        return p.x + p.y > 1 ? gabor_vec2(1.5f, 0.25f * p.y) : gabor_vec2(-0.5f * p.x, 2);
    }
#define GABOR_DIRECTION(p) map_at(p)
#include "gabor_direction.hpp"
};

} // namespace

/// Converts a place to the drop-in's type.
template <typename Functions>
auto place_of(Functions&, const noise::LatticePlace& place) {
    return typename Functions::GaborPlace{
        {place.cell_x, place.cell_y},
        {static_cast<float>(place.local_x), static_cast<float>(place.local_y)},
        {static_cast<float>(place.radius_x), static_cast<float>(place.radius_y)},
        {place.period_x, place.period_y},
        place.animated,
        static_cast<float>(place.time)};
}

/// A place without a period.
inline noise::LatticePlace lattice_place(int taps, double local_x, double local_y, std::int32_t cell_x = 0,
                                         std::int32_t cell_y = 0) {
    return {cell_x, cell_y, local_x, local_y, 0.5 * taps, 0.5 * taps};
}

/// The place of p, in kernel radii, in noise that repeats after `tile`.
inline noise::LatticePlace lattice_tile(int taps, gabor_vec2 p, gabor_vec2 tile) {
    noise::LatticePlace place;
    const auto along = [&](double at, double period, double& local, double& radius, std::int32_t& nodes) {
        nodes = std::max(static_cast<std::int32_t>(std::floor(period * 0.5 * taps + 0.5)), taps);
        radius = nodes / period;
        local = (at / period - std::floor(at / period)) * nodes;
    };
    along(p.x, tile.x, place.local_x, place.radius_x, place.period_x);
    along(p.y, tile.y, place.local_y, place.radius_y, place.period_y);
    return place;
}

/// Draws a place near the origin or in any cell, with or without a period, at rest or at any time. One
/// coordinate in four is on or next to a cell border, where a window ends.
inline noise::LatticePlace any_lattice_place(Draw& draw, int taps) {
    noise::LatticePlace place;
    const auto along = [&](std::int32_t& cell, double& local, double& radius, std::int32_t& period) {
        cell = draw.word() % 2 ? draw.cell() : static_cast<std::int32_t>(draw.uniform(-5, 5));
        float at = draw.uniform(-2, 3);
        if (draw.one_in(4))
            at = 0.5f * std::round(2 * at);
        if (draw.one_in(4))
            at = draw.edge(at, 0.5f);
        local = at;
        radius = 0.5f * static_cast<float>(taps) * draw.uniform(0.8, 1.3);
        period = draw.word() % 2 ? taps + static_cast<std::int32_t>(draw.word() % 50) : 0;
    };
    along(place.cell_x, place.local_x, place.radius_x, place.period_x);
    along(place.cell_y, place.local_y, place.radius_y, place.period_y);
    place.animated = draw.word() % 2;
    place.time = draw.uniform(-2, 2);
    return place;
}

inline std::string to_string(const noise::LatticePlace& p) {
    return fmt::format("cell ({}, {}) + ({}, {}), radius ({}, {}), period ({}, {}), time {}", p.cell_x,
                       p.cell_y, p.local_x, p.local_y, p.radius_x, p.radius_y, p.period_x, p.period_y,
                       p.animated ? p.time : 0);
}

/// A pixel's steps in the plane, in kernel radii.
struct Pixel {
    gabor_vec2 dx{0, 0}, dy{0, 0};

    Pixel() = default;
    Pixel(gabor_vec2 x, gabor_vec2 y) : dx(x), dy(y) {}
    /// A pixel with the standard deviations `deviation` and `deviation * ratio`, with its longer axis at an
    /// angle.
    Pixel(double deviation, double ratio, double angle)
        : dx(static_cast<float>(2 * deviation * std::cos(angle)),
             static_cast<float>(2 * deviation * std::sin(angle))),
          dy(-static_cast<float>(ratio) * dx.y, static_cast<float>(ratio) * dx.x) {}
};

inline std::string to_string(const Pixel& pixel) {
    return fmt::format("pixel ({}, {}), ({}, {})", pixel.dx.x, pixel.dx.y, pixel.dy.x, pixel.dy.y);
}

/// The standard deviation of one component of the gradient of isotropic noise. The waves contribute half of
/// 4 pi^2 F^2 to its square, the windows pi^2 / 3.
inline double isotropic_slope(double frequency) {
    using std::numbers::pi;
    return std::sqrt(2 * pi * pi * frequency * frequency + pi * pi / 3);
}

} // namespace gabor::test
