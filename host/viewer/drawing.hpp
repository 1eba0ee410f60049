#pragma once

#include "render/plan.hpp"
#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <array>
#include <cstdint>

namespace gabor::viewer {

/// What the window draws of a document, from any camera.
struct Drawing {
    render::Request request; ///< with the channels of the output
    bool normals = false;    ///< as in render::Viewport
    bool operator==(const Drawing&) const = default;
};

/// The drawing of a document, with the channels of its output.
Drawing drawing_of(const Document& document);

/// The viewport of a camera in a view of `extent` pixels.
render::Viewport viewport_of(const Drawing& drawing, const Camera& camera, Extent extent, int stride = 1);

/// The largest stride, a power of two, while the view moves. Phases, which do not fade with their wave, and
/// painted noise keep at least three values per wave.
int coarsest_stride(const Drawing& drawing, const render::Paint& paint, double zoom);

/// Four copies of a tileable picture, two by two, to look for seams.
struct Tiling {
    Extent tile;                  ///< pixels of a copy
    Camera camera;                ///< that shows one copy
    std::array<float, 2> moved{}; ///< pixels of the window, from 0 to the side of a tile
    bool operator==(const Tiling&) const = default;
};

/// Copies as large as fit the view, in whole pixels, but no larger than the picture; sides without a common
/// divisor keep their size. They move with the document's camera.
Tiling tiling_of(const Document& document, Extent view);

} // namespace gabor::viewer
