#pragma once

#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <array>

namespace gabor::viewer {

/// Copies of a tileable picture side by side, two by two: a seam between them would show.
struct Tiling {
    Extent tile;                  ///< pixels of a copy
    Camera camera;                ///< that sees one
    std::array<float, 2> moved{}; ///< pixels of the window, from 0 to the side of a tile
    bool operator==(const Tiling&) const = default;
};

/// As large as fit the view, in whole pixels, but no larger than the picture: one whose sides have no common
/// divisor keeps its size. They are moved as the document's camera is.
Tiling tiling_of(const Document& document, Extent view);

} // namespace gabor::viewer
