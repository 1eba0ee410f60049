#pragma once

#include "reference/lattice.hpp"
#include "sampler.hpp"

#include "passes/sample_lattice_2.h"
#include "passes/sample_lattice_3.h"
#include "passes/sample_lattice_4.h"

namespace gabor::test {

/// Same layout as in passes/sample_lattice.glsl.
struct LatticeSample {
    std::int32_t cell[2];
    float local[2];
    float p[2]; ///< what the functions of a position see
    float radius[2];
    std::int32_t period[2];
    std::int32_t animated;
    float time;
    float frequency;
    float orientation;
    std::uint32_t seed;
    float tile[2]; ///< the periods of gabor_noise_tiled, kernel radii
    float sharpness = 0;
    float wave[2] = {};

    noise::LatticePlace place() const {
        return {cell[0],   cell[1],   local[0],  local[1],      radius[0],
                radius[1], period[0], period[1], animated != 0, time};
    }
};

inline std::string to_string(const LatticeSample& s) {
    return fmt::format(
        "cell ({}, {}) + ({}, {}), p ({}, {}), nodes per radius ({}, {}), period ({}, {}), "
        "time {} ({}), frequency {}, orientation {}, seed {}, tile ({}, {}), wave ({}, {}), sharpness {}",
        s.cell[0], s.cell[1], s.local[0], s.local[1], s.p[0], s.p[1], s.radius[0], s.radius[1], s.period[0],
        s.period[1], s.time, s.animated, s.frequency, s.orientation, s.seed, s.tile[0], s.tile[1], s.wave[0],
        s.wave[1], s.sharpness);
}

struct LatticeAnswer {
    float value[2];
    float slope_x[2];
    float slope_y[2];
    float complex[2];
    float phasor[2];
    float gradient[2];
    float noise;
    float gradient_noise;
    float tiled;
    float animated;
    float unorm;
    float at;
    std::uint32_t word;
    std::uint32_t padding;
    float four[4];
    float wave[4];
    float wave_complex[2];
    float wave_tiled;
    float stripes_tiled;
    float stripes[4];
};

struct LatticeSampler : Probe<LatticeSample, LatticeAnswer> {
    LatticeSampler(const vulkan::Device& device, int taps, std::size_t capacity)
        : Probe(device, capacity,
                taps == 2   ? std::span<const std::uint32_t>(sample_lattice_2_spirv)
                : taps == 3 ? std::span<const std::uint32_t>(sample_lattice_3_spirv)
                            : std::span<const std::uint32_t>(sample_lattice_4_spirv),
                {}) {}
};

} // namespace gabor::test
