#pragma once

#include "noise/recipe.hpp"
#include "vulkan/pass.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gabor::bench {

/// A noise that the benchmark fills a picture with, one pixel per invocation, by a pass that includes
/// passes/bench/bench.glsl.
struct Subject {
    std::string name;
    double visited = 0; ///< impulses visited for each pixel; 0 where there are none
    std::span<const std::uint32_t> spirv;
    const noise::Recipe* recipe = nullptr;   ///< of the drop-in
    std::vector<std::uint32_t> options = {}; ///< the pass's own specialization constants
    bool measure_cvm = false;                ///< whether to measure how Gaussian its values are
    bool random_loops = false;               ///< its loops end at random, so that its code cannot be counted
};

/// What others are compared with: the same noises as published, written plainly but with everything that all
/// impulses share computed once.
inline constexpr const char* seminal_yardstick = "seminal, N = 30, hoisted";
inline constexpr const char* advice_yardstick = "the paper's advice, N = 2, hoisted";

/// All of them, in the order of the report.
std::vector<Subject> subjects();

/// What a pass is made for: to fill a picture, to evaluate random places of independent instances, or to ask
/// what it compiles to.
enum class Use { picture, samples, statistics };

/// The pass of a subject.
vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use);

} // namespace gabor::bench
