#pragma once

#include "noise/recipe.hpp"
#include "vulkan/pass.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gabor::bench {

/// A noise that the benchmark fills a picture with, one pixel per invocation.
struct Subject {
    std::string name;
    double visited = 0; ///< impulses visited for each pixel; 0 where there are none
    std::span<const std::uint32_t> spirv;
    const noise::Recipe* recipe = nullptr; ///< of the drop-in
    std::uint32_t mean_impulses = 0;       ///< of the seminal noise and the advice; 0 for all others
    bool advice = false;
    std::uint32_t entry = 0; ///< which function, as in passes/bench/recipe.comp or space.comp

    /// Whether it is a Gabor noise by itself, whose law is worth measuring.
    bool is_gabor() const { return visited > 0 && entry == 0; }
};

/// Seminal noise, the paper's advice written plainly, every recipe of the drop-in, gradient noise, and
/// writing alone.
std::vector<Subject> subjects();

/// What a pass is made for: to fill a picture, to evaluate random places of independent instances, or to ask
/// what it compiles to.
enum class Use { picture, samples, statistics };

vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use,
                       bool native_sine = false);

} // namespace gabor::bench
