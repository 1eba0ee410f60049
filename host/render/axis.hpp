#pragma once

#include "render/picture.hpp"

namespace gabor::render {

/// The cells along a side of a picture: the recipe's, or as many whole ones as fit a tileable picture.
struct Axis {
    double radius;       ///< cells per kernel radius
    std::int32_t period; ///< in cells, 0 for none
};

Axis axis_along(const Picture& picture, int side);

} // namespace gabor::render
