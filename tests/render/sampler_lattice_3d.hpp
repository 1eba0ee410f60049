#pragma once

#include "reference/lattice_3d.hpp"
#include "sampler.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace gabor::test {

/// Same layout as in passes/sample_lattice_3d.comp.
struct LatticeSample3d {
    noise::Lattice3d::Place place;
    float frequency = 2;
    std::array<float, 3> direction{1, 0, 0};
    std::array<float, 3> normal{0, 0, 1};
    std::array<float, 3> dx{};
    std::array<float, 3> dy{};
    std::array<float, 3> p{};
    std::array<float, 3> tile{4, 4, 4};
    std::uint32_t seed = 0;
};

inline std::string to_string(const LatticeSample3d& s) {
    return fmt::format("cell {} + {}, radius {}, period {}, time {}, frequency {}, direction {}, normal {}, "
                       "footprint {}, {}, position {}, tile {}, seed {}",
                       s.place.cell, s.place.local, s.place.radius, s.place.period, s.place.time, s.frequency,
                       s.direction, s.normal, s.dx, s.dy, s.p, s.tile, s.seed);
}

struct LatticeAnswer3d {
    float value[9]; ///< of a field by place its value, its slopes and the variance removed
};

/// The functions by place and by position, numbered as in passes/sample_lattice_3d.comp.
enum class Entry3d : std::int32_t {
    field,
    isotropic,
    surface,
    surface_isotropic,
    noise,
    complex,
    gradient,
    four,
    tiled,
    animated,
    filtered,
    noise_isotropic,
    noise_isotropic_gradient,
    noise_isotropic_filtered,
    noise_surface,
    noise_surface_isotropic
};

/// The pass that evaluates it.
std::span<const std::uint32_t> spirv_of(Entry3d entry);

struct LatticeSampler3d : Probe<LatticeSample3d, LatticeAnswer3d> {
    LatticeSampler3d(const vulkan::Device& device, std::size_t capacity, Entry3d entry, bool filtered = false,
                     bool animated = false)
        : Probe(device, capacity, spirv_of(entry),
                std::array{std::uint32_t{filtered}, std::uint32_t{animated}}) {}
};

inline noise::Lattice3d::Vector wide(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

inline noise::Lattice3d::Vector unit(const std::array<float, 3>& v) {
    const double length = std::hypot(double{v[0]}, double{v[1]}, double{v[2]});
    return {v[0] / length, v[1] / length, v[2] / length};
}

inline std::array<float, 3> narrow(const noise::Lattice3d::Vector& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

inline noise::Lattice3d::Vector random_unit(Draw& draw) {
    return unit({draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)});
}

} // namespace gabor::test
