#pragma once

// gabor_noise.glsl and the drop-ins that need it, translated to C++. Each class has the functions for one
// number of taps as members. tests/render/test_golden.cpp checks that the device computes the same values.

#include "compare.hpp"
#include "reference/sum.hpp"

#include "gabor_noise.hpp" // for gabor_vec2 and gabor_vec3

#include <type_traits>

namespace gabor::test {

namespace { // each source compiles its own copy, with its own compiler options

#undef GABOR_TAPS
#undef GABOR_NOISE_HPP
struct Lattice2 {
    static constexpr int taps = 2;
#define GABOR_TAPS 2
#define GABOR_LOBES 3
#include "gabor_noise.hpp"

#include "gabor_erosion.hpp"
#include "gabor_spectrum.hpp"
};

#undef GABOR_TAPS
#undef GABOR_NOISE_HPP
#undef GABOR_EROSION_HPP
#undef GABOR_SPECTRUM_HPP
struct Lattice4 {
    static constexpr int taps = 4;
#define GABOR_TAPS 4
#include "gabor_noise.hpp"

#include "gabor_erosion.hpp"
#include "gabor_spectrum.hpp"
};

#undef GABOR_TAPS
#undef GABOR_NOISE_HPP
#undef GABOR_EROSION_HPP
#undef GABOR_SPECTRUM_HPP
struct Lattice3 {
    static constexpr int taps = 3;
#include "gabor_noise.hpp"

#include "gabor_erosion.hpp"
#include "gabor_spectrum.hpp"

#include "gabor_filter.hpp"

#include "gabor_noise_3d.hpp"

#include "gabor_filter_3d.hpp"

#include "gabor_fractal.hpp"

    /// A direction map with a jump across the line x + y = 1.
    static gabor_vec2 map_at(gabor_vec2 p) {
        return p.x + p.y > 1 ? gabor_vec2(1.5f, 0.25f * p.y) : gabor_vec2(-0.5f * p.x, 2);
    }
#define GABOR_DIRECTION(p) map_at(p)
#include "gabor_direction.hpp"
};

} // namespace

/// The drop-ins' types in N dimensions.
template <std::size_t N>
using Floats = std::conditional_t<N == 2, gabor_vec2, gabor_vec3>;
template <std::size_t N>
using PlaceOf = std::conditional_t<N == 2, Lattice3::GaborPlace, Lattice3::GaborPlace3d>;
template <std::size_t N>
using FieldOf = std::conditional_t<N == 2, Lattice3::GaborField, Lattice3::GaborField3d>;

inline noise::Vector<2> wide(gabor_vec2 v) {
    return {v.x, v.y};
}
inline noise::Vector<3> wide(gabor_vec3 v) {
    return {v.x, v.y, v.z};
}
template <std::size_t N>
Floats<N> narrow(const noise::Vector<N>& v) {
    Floats<N> result;
    for (std::size_t axis = 0; axis < N; ++axis)
        result[static_cast<int>(axis)] = static_cast<float>(v[axis]);
    return result;
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
    for (int i = 0; i < std::min(lobes.count, GABOR_LOBES); ++i) {
        const auto& [frequency, orientation, radius, power] = lobes.lobe[i];
        all.push_back({frequency, orientation, wide(radius), power, noise::lattice_derived_seed(seed, i)});
    }
    return all;
}

/// Converts a place to the drop-in's type.
template <typename Functions, std::size_t N>
auto place_of(Functions& n, const noise::Place<N>& place) {
    const auto& [cell, local, radius, period, time] = place;
    auto result = [&] {
        if constexpr (N == 2)
            return n.gabor_place({cell[0], cell[1]}, narrow(local));
        else
            return n.gabor_place_3d({cell[0], cell[1], cell[2]}, narrow(local));
    }();
    result.cells_per_radius = narrow(radius);
    for (std::size_t axis = 0; axis < N; ++axis)
        result.period[static_cast<int>(axis)] = period[axis];
    result.evolution = static_cast<float>(time);
    return result;
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

/// The place that a tiled function computes from p, if the axis has a period. `p` and `tile` are in kernel
/// radii.
template <typename Vector>
auto lattice_tile(int taps, const Vector& p, const Vector& tile) {
    auto place = lattice_place(taps, p);
    for (std::size_t axis = 0; axis < place.local.size(); ++axis) {
        const double period = tile[static_cast<int>(axis)], turns = p[static_cast<int>(axis)] / period;
        if (period == 0)
            continue;
        const int nodes = std::max(static_cast<int>(std::floor(period * 0.5 * taps + 0.5)), taps);
        place.period[axis] = nodes;
        place.radius[axis] = nodes / period;
        place.local[axis] = (turns - std::floor(turns)) * nodes;
    }
    return place;
}

/// Draws a position near the origin or in any cell, with or without a period, still or animated. Nearly half
/// of all coordinates are on or next to a multiple of 1/2, where windows and cells may end.
template <std::size_t N>
noise::Place<N> any_lattice_place(Random& random, int taps) {
    noise::Place<N> place;
    for (std::size_t axis = 0; axis < N; ++axis) {
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
    place.time = random.word() % 2 ? random.uniform(-2, 2) : 0;
    return place;
}

/// The arguments of a noise. All vectors are exactly representable in floats.
template <std::size_t N>
struct Sample {
    noise::Place<N> place;
    float frequency = 0;
    noise::Vector<N> direction{};
    noise::Vector<3> normal{0, 0, 1};
    noise::Vector<N> dx{}, dy{}; ///< the steps to the next pixels
    std::uint32_t seed = 0;

    noise::Vector<N> wave() const { return noise::scaled(frequency, noise::unit(direction)); }
};

template <std::size_t N>
std::string to_string(const Sample<N>& s) {
    return fmt::format("{}, frequency {}, direction {}, normal {}, pixel {}, {}, seed {}", to_string(s.place),
                       s.frequency, s.direction, s.normal, s.dx, s.dy, s.seed);
}

/// A sample anywhere within any cell.
template <std::size_t N>
Sample<N> somewhere(Random& random, double frequency) {
    Sample<N> s;
    for (std::size_t axis = 0; axis < N; ++axis) {
        s.place.cell[axis] = random.cell();
        s.place.local[axis] = random.uniform(0, 1);
    }
    s.frequency = static_cast<float>(frequency);
    s.direction = wide(narrow(random_unit<N>(random)));
    s.normal = wide(narrow(random_unit<3>(random)));
    s.seed = random.word();
    return s;
}

namespace {

Lattice3 n;

/// A noise with and without the filter, and its reference.
template <std::size_t N>
struct Noise {
    const char* name;
    FieldOf<N> (*plain)(PlaceOf<N>, const Sample<N>&);
    FieldOf<N> (*averaged)(PlaceOf<N>, Floats<N> dx, Floats<N> dy, const Sample<N>&);
    noise::Sum<N> (*reference)(const Sample<N>&);

    FieldOf<N> field(const Sample<N>& s) const { return plain(place_of(n, s.place), s); }
    FieldOf<N> filtered(const Sample<N>& s) const {
        return averaged(place_of(n, s.place), narrow(s.dx), narrow(s.dy), s);
    }
};

template <std::size_t N>
noise::Sum<N> wave_of(const Sample<N>& s) {
    return noise::wave_noise(3, s.wave(), s.seed);
}

constexpr Noise<2> plane{
    "in the plane", [](auto place, const auto& s) { return n.gabor_field(place, narrow(s.wave()), s.seed); },
    [](auto place, auto dx, auto dy, const auto& s) {
        return n.gabor_field_filtered(place, dx, dy, narrow(s.wave()), s.seed);
    },
    wave_of<2>};
constexpr Noise<2> isotropic{
    "isotropic in the plane",
    [](auto place, const auto& s) { return n.gabor_field_isotropic(place, s.frequency, s.seed); },
    [](auto place, auto dx, auto dy, const auto& s) {
        return n.gabor_field_isotropic_filtered(place, dx, dy, s.frequency, s.seed);
    },
    [](const auto& s) -> noise::Sum<2> { return noise::isotropic_noise(s.frequency, s.seed); }};
constexpr Noise<3> solid{
    "in 3D", [](auto place, const auto& s) { return n.gabor_field_3d(place, narrow(s.wave()), s.seed); },
    [](auto place, auto dx, auto dy, const auto& s) {
        return n.gabor_field_3d_filtered(place, dx, dy, narrow(s.wave()), s.seed);
    },
    wave_of<3>};
constexpr Noise<3> surface{
    "on a surface",
    [](auto place, const auto& s) {
        return n.gabor_field_surface(place, narrow(s.normal), s.frequency, narrow(s.direction), s.seed);
    },
    [](auto place, auto dx, auto dy, const auto& s) {
        return n.gabor_field_surface_filtered(place, dx, dy, narrow(s.normal), s.frequency,
                                              narrow(s.direction), s.seed);
    },
    [](const auto& s) {
        return noise::surface_noise(noise::unit(s.normal), s.frequency, noise::unit(s.direction), s.seed);
    }};
constexpr Noise<3> isotropic_3d{
    "isotropic in 3D",
    [](auto place, const auto& s) { return n.gabor_field_3d_isotropic(place, s.frequency, s.seed); },
    [](auto place, auto dx, auto dy, const auto& s) {
        return n.gabor_field_3d_isotropic_filtered(place, dx, dy, s.frequency, s.seed);
    },
    [](const auto& s) -> noise::Sum<3> { return noise::isotropic_noise_3d(s.frequency, s.seed); }};
constexpr Noise<3> isotropic_surface{
    "isotropic on a surface",
    [](auto place, const auto& s) {
        return n.gabor_field_surface_isotropic(place, narrow(s.normal), s.frequency, s.seed);
    },
    [](auto place, auto dx, auto dy, const auto& s) {
        return n.gabor_field_surface_isotropic_filtered(place, dx, dy, narrow(s.normal), s.frequency, s.seed);
    },
    [](const auto& s) { return noise::isotropic_surface_noise(noise::unit(s.normal), s.frequency, s.seed); }};

} // namespace

/// The standard deviation of one component of the gradient of isotropic noise in the plane. The waves
/// contribute 2 pi^2 F^2 to its square, and the windows pi^2 / 3.
inline double isotropic_slope(double frequency) {
    using std::numbers::pi;
    return std::sqrt(2 * pi * pi * frequency * frequency + pi * pi / 3);
}

} // namespace gabor::test
