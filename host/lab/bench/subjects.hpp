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
    int octaves = 0; ///< rounds of a loop that compilers keep; their number is the last option
};

/// What others are compared with: the same noises as published, written plainly but with everything that all
/// impulses share computed once.
inline constexpr const char* seminal_yardstick = "seminal, N = 30, hoisted";
inline constexpr const char* advice_yardstick = "the paper's advice, N = 2, hoisted";

/// All of them, in the order of the report.
std::vector<Subject> subjects();

/// The functions of passes/bench/recipe.comp, by their numbers there. A sparse recipe has them up to
/// `animated`, and those from `spread` on the lattice with 3 taps.
enum class Function : std::uint32_t {
    noise,
    gradient,
    complex_and_phasor,
    tiled,
    animated,
    four,
    spread,
    three_lobes,
    filtered,
    isotropic
};

/// The drop-in of a recipe, which the subject refers to.
Subject drop_in(const noise::Recipe& recipe, Function function);

/// The functions of passes/bench/space.comp, by their numbers there.
enum class SpaceFunction : std::uint32_t {
    noise = 1,
    isotropic,
    gradient,
    surface,
    surface_isotropic,
    filtered
};

/// A function of gabor_lattice_3d.glsl.
Subject in_space(SpaceFunction function);

/// The seminal noise, or the paper's advice, with so many impulses per cell, hoisted.
Subject seminal(int impulses);
Subject advice(int impulses);

/// What a picture is filled with.
struct Setting {
    int side;         ///< pixels
    double scale;     ///< pixels per kernel radius
    double frequency; ///< cycles per kernel radius
};

/// The setting that everything is compared at.
constexpr Setting base_setting{1024, 32, 4};
constexpr double base_orientation = 40; ///< degrees

/// What a pass is made for: to fill a picture, to evaluate random places of independent instances, or to ask
/// what it compiles to.
enum class Use { picture, samples, statistics };

/// The pass of a subject.
vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use);

/// Fills a square picture with a subject, again and again.
class Filling {
  public:
    /// `picture`: holds that many floats, and lives as long.
    Filling(const vulkan::Device& device, const Subject& subject, const Setting& setting,
            const vulkan::Buffer& picture);

    /// Seconds on the device's own clock, NaN where it has none.
    double run();

  private:
    Setting setting_;
    vulkan::Pass pass_;
    vulkan::Job job_;
};

/// Has `job`, of a subject's pass, fill a picture, or as many values.
void submit(vulkan::Job& job, const Setting& setting, std::uint32_t seed);

} // namespace gabor::bench
