#pragma once

#include "noise/recipe.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace gabor {

/// A pass that includes passes/recipe.glsl, compiled for each drop-in.
struct RecipeModules {
    std::span<const std::uint32_t> sparse;
    std::array<std::span<const std::uint32_t>, 3> lattice; ///< modules for 2, 3 and 4 taps

    std::span<const std::uint32_t> of(const noise::Recipe& recipe) const {
        return recipe.is_lattice() ? lattice.at(static_cast<std::size_t>(recipe.taps - 2)) : sparse;
    }
};

} // namespace gabor
