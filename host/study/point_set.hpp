#pragma once

#include "study/ingredients.hpp"
#include "vulkan/device.hpp"

#include <cstdint>
#include <vector>

namespace gabor::study {

/// A place in cells.
struct Point {
    float x;
    float y;
};

/// The impulses of each cell, row by row of cells.
using PointSet = std::vector<std::vector<Point>>;

/// Of a square of `side` x `side` cells, from the cell at the origin on.
PointSet point_set(const vulkan::Device& device, const Ingredients& ingredients, int side,
                   std::uint32_t seed);

} // namespace gabor::study
