#pragma once

#include "reference/reference_3d.hpp"
#include "sampler.hpp"

#include "passes/sample_3d.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace gabor::test {

enum class Kind : std::int32_t { oriented, isotropic, surface, surface_isotropic };

/// As in passes/sample_3d.comp.
struct Sample3d {
    noise::Place3d place;
    float frequency = 4;
    std::array<float, 3> direction{1, 0, 0};
    std::array<float, 3> normal{0, 0, 1};
    std::array<float, 3> dx{};
    std::array<float, 3> dy{};
    std::array<float, 3> tile{4, 4, 4};
    std::array<float, 3> position{place.local[0] / place.radius[0], place.local[1] / place.radius[1],
                                  place.local[2] / place.radius[2]}; ///< of the functions of a position
    std::uint32_t seed = 0;
    Kind kind = Kind::oriented;
    std::int32_t index = 0;
};

struct Answer3d {
    float value[2];
    float slope[3][2];
    float at;
    float noise;
    float isotropic;
    float gradient[4];
    float complex[2];
    float tiled;
    float animated;
    float surface;
    float surface_isotropic;
    std::uint32_t word;
    std::array<float, 3> direction;
};

inline noise::Vector3 unit(const std::array<float, 3>& v) {
    const double length = std::hypot(double{v[0]}, double{v[1]}, double{v[2]});
    return {v[0] / length, v[1] / length, v[2] / length};
}

inline noise::Vector3 wide(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// The waves of a sample, were its kernel of that kind.
inline noise::Waves waves_of(const Sample3d& sample, Kind kind) {
    noise::Waves waves;
    waves.frequency = sample.frequency;
    if (kind == Kind::oriented || kind == Kind::surface)
        waves.direction = unit(sample.direction);
    if (kind == Kind::surface || kind == Kind::surface_isotropic)
        waves.normal = unit(sample.normal);
    return waves;
}

struct Sampler3d : Probe<Sample3d, Answer3d> {
    Sampler3d(const vulkan::Device& device, const noise::Recipe& recipe, std::size_t capacity)
        : Probe(device, capacity, sample_3d_spirv, constants_of(recipe)) {}

  private:
    static std::array<std::uint32_t, 5> constants_of(const noise::Recipe& recipe) {
        using vulkan::constant;
        return {constant(recipe.impulses), constant(recipe.radius), constant(recipe.window[0]),
                constant(recipe.window[1]), constant(recipe.window[2])};
    }
};

} // namespace gabor::test
