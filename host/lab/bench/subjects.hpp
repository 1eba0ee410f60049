#pragma once

#include "noise/recipe.hpp"
#include "passes/bench/bench_interface.h"
#include "vulkan/pass.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::bench {

/// A noise to time. Its pass includes passes/bench/bench.glsl and computes one pixel per invocation.
struct Subject {
    std::string name;
    double visited = 0; ///< impulses visited per pixel; 0 if there are none
    std::span<const std::uint32_t> spirv;
    const noise::Recipe* recipe = nullptr;   ///< the drop-in's recipe; null for other noises
    std::vector<std::uint32_t> options = {}; ///< the pass's own specialization constants
    bool measure_cvm = false;                ///< whether to measure the Gaussianity of its values
    bool has_loops = false; ///< whether compilers keep its loops, so that its code cannot be counted
    /// The number of octaves, which is also the last of `options`; 0 if there is no loop over octaves.
    int octaves = 0;
    std::vector<std::byte> table = {}; ///< contents of the pass's uniform buffer; empty if it has none
};

/// The noises that others are compared with, named as in docs/benchmark.html.
inline constexpr std::string_view perlin_yardstick = "Perlin noise";
inline constexpr std::string_view simplex_yardstick = "simplex noise";
inline constexpr std::string_view advice_yardstick = "the paper's advice, 18 kernels";
inline constexpr std::string_view seminal_yardstick = "the seminal noise, 183 kernels";
inline constexpr std::string_view dense_yardstick = "the seminal noise, 270 kernels";

/// All subjects, in the order of the report.
std::vector<Subject> subjects();

/// The size, scale and frequency of a timed picture.
struct Setting {
    int side;         ///< pixels
    double scale;     ///< pixels per kernel radius
    double frequency; ///< cycles per kernel radius
};

/// The setting that all comparisons use.
constexpr Setting base_setting{1024, 32, 4};
constexpr double base_orientation = 40; ///< degrees

/// The use of a pass: to be timed, to sample random points of independent instances, or to report the
/// compiler's statistics.
enum class Use : std::uint32_t {
    timing = passes::use_timing,
    samples = passes::use_samples,
    statistics = passes::use_statistics
};

/// Each invocation of a timed pass computes the square of this many values.
constexpr int timed_side = 4;

/// Makes the pass of a subject.
vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use);

/// Submits `job`, which runs a subject's pass.
void submit(vulkan::Job& job, const Setting& setting, std::uint32_t seed);

} // namespace gabor::bench
