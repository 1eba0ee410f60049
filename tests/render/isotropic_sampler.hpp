#pragma once

#include "sampler.hpp"

#include "passes/sample_isotropic.h"

#include <cmath>
#include <numbers>

namespace gabor::test {

/// As in passes/sample_isotropic.comp.
struct IsotropicSample {
    std::int32_t cell[2]{};
    float local[2]{};
    float radius[2]{1.5f, 1.5f};
    std::int32_t period[2]{};
    float p[2]{};
    float tile[2]{4, 4};
    float dx[2]{};
    float dy[2]{};
    float frequency = 1;
    float time = 0;
    std::int32_t animated = 0;
    std::uint32_t seed = 0;
};

struct IsotropicAnswer {
    float value[2];
    float slope_x[2];
    float slope_y[2];
    float filtered[2];
    float gradient[3];
    float noise;
    float tiled;
    float placed_filtered;
    float padding[2];
};

/// Selects the answers to compute.
enum class Part : std::int32_t { all, field, filtered };

inline std::string to_string(const IsotropicSample& s) {
    return fmt::format(
        "cell ({}, {}) + ({}, {}), radius ({}, {}), period ({}, {}), p ({}, {}), tile ({}, {}), "
        "footprint ({}, {}), ({}, {}), frequency {}, time {}, seed {}",
        s.cell[0], s.cell[1], s.local[0], s.local[1], s.radius[0], s.radius[1], s.period[0], s.period[1],
        s.p[0], s.p[1], s.tile[0], s.tile[1], s.dx[0], s.dx[1], s.dy[0], s.dy[1], s.frequency,
        s.animated ? s.time : 0, s.seed);
}

struct IsotropicSampler : Probe<IsotropicSample, IsotropicAnswer> {
    IsotropicSampler(const vulkan::Device& device, std::size_t capacity)
        : Probe(device, capacity, sample_isotropic_spirv, {}) {}

    auto answers(std::size_t count, Part part) { return Probe::answers(count, static_cast<Wanted>(part)); }
};

/// The standard deviation of a part of the gradient: half of 4 pi^2 F^2 from the waves, pi^2 / 3 from the
/// windows.
inline double isotropic_slope(double frequency) {
    using std::numbers::pi;
    return std::sqrt(2 * pi * pi * frequency * frequency + pi * pi / 3);
}

} // namespace gabor::test
