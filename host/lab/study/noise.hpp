#pragma once

#include "noise/recipe.hpp"
#include "study/ingredients.hpp"
#include "study/variant.hpp"
#include "vulkan/pass.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gabor::study {

/// A square grid of 2^bits x 2^bits positions in every instance, row by row, at the centres of pixels. With
/// `bits` 0, it is a single position.
struct Grid {
    unsigned bits = 0;
    double side = 0;               ///< length of a side in kernel radii
    bool random = true;            ///< whether it starts at a random position in a cell, not at its corner
    std::array<double, 2> shift{}; ///< offset of the start, in kernel radii
};

/// A noise on the device, scaled to a given variance.
class Noise {
  public:
    Noise(const vulkan::Device& device, const Ingredients& ingredients, const PlaneWave& wave = {},
          double variance = 1);
    Noise(const vulkan::Device& device, const Variant& variant, const PlaneWave& wave = {},
          double variance = 1);

    /// The drop-in's noise, with variance 1.
    Noise(const vulkan::Device& device, const noise::Recipe& recipe, const PlaneWave& wave = {});

    /// Computes the values of consecutive instances, from `first` on. `place_seed` determines where
    /// random grids start. Returns the time on the device in seconds; NaN if it cannot be measured.
    double fill(std::span<float> values, const Grid& grid, std::uint32_t first, std::uint32_t noise_seed,
                std::uint32_t place_seed);

  private:
    Noise(const vulkan::Device& device, std::span<const std::uint32_t> spirv,
          std::span<const std::uint32_t> constants, const PlaneWave& wave, double amplitude,
          double cells_per_radius);

    PlaneWave wave_;
    double amplitude_;
    double cells_per_radius_;
    vulkan::Pass pass_;
    vulkan::Buffer values_;
    std::optional<vulkan::Buffer> staging_; ///< used if the host cannot read the device's memory
    vulkan::Job job_;
};

/// The position of an impulse, in cells.
struct Point {
    float x;
    float y;
};

/// The impulses of each cell; cells are in row order.
using PointSet = std::vector<std::vector<Point>>;

/// Returns the impulses of `side` x `side` cells, starting at the origin.
PointSet point_set(const vulkan::Device& device, const Ingredients& ingredients, int side,
                   std::uint32_t seed);

} // namespace gabor::study
