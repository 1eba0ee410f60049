#pragma once

#include "render/plan.hpp"
#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <cstdint>

namespace gabor::viewer {

/// What the window draws of a document, wherever its camera is.
struct Drawing {
    render::Request request; ///< with the channels that the output needs
    bool normals = false;    ///< as render::Viewport has it
    bool operator==(const Drawing&) const = default;
};

/// The drawing of a document: its request with the channels of its output.
Drawing drawing_of(const Document& document);

/// What the camera shows of it in `extent` pixels.
render::Viewport viewport_of(const Drawing& drawing, const Camera& camera, Extent extent, int stride = 1);

/// The most pixels, a power of two, that a value may stand for while the view moves. Phases, which do not
/// fade with their wave, and what is painted keep at least three values to each wave.
int coarsest_stride(const Drawing& drawing, const render::Paint& paint, double zoom);

/// The same noise, its value alone, sharp, and on a plane from above: for the statistics of its values.
render::Request value_request(const Drawing& drawing);

/// Values of a `value_request` at points that are independent of each other, of an instance that `draw`
/// tells. Where a ray meets no body their channel `A` is 0.
render::Plan random_points(render::Request request, Extent grid, std::uint32_t draw);

} // namespace gabor::viewer
