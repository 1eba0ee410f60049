#pragma once

#include "render/plan/plan.hpp"
#include "viewer/document.hpp"
#include "viewer/window.hpp"

#include <array>

namespace gabor::viewer {

/// What the window draws of a document, whatever the camera.
struct Drawing {
    render::Request request; ///< includes the channels of the output
    bool normals = false;    ///< `normals` of render::Viewport
    bool operator==(const Drawing&) const = default;
};

/// The drawing of a document, with the channels of its output.
Drawing drawing_of(const Document& document);

/// The viewport of a camera in a view of `extent` pixels.
render::Viewport viewport_of(const Drawing& drawing, const Camera& camera, Extent extent, int stride = 1);

/// The largest stride while the view moves, a power of two. Phases and unfiltered painted noise do not fade
/// when waves become too short, so they keep at least three values per wave.
int coarsest_stride(const Drawing& drawing, const render::Paint& paint, double zoom);

/// Four copies of a tileable picture, two by two, to look for seams.
struct Tiling {
    Extent tile;                  ///< pixels of a copy
    Camera camera;                ///< camera that shows one copy
    std::array<float, 2> moved{}; ///< offset in window pixels, from 0 to the side of a tile
    bool operator==(const Tiling&) const = default;
};

/// Makes the copies as large as the view allows, in whole pixels, but no larger than the picture. Pictures
/// whose sides have no common divisor keep their size. The copies move with the document's camera.
Tiling tiling_of(const Document& document, Extent view);

} // namespace gabor::viewer
