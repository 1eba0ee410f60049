#pragma once

#include "viewer/document.hpp"
#include "viewer/window.hpp"

#include <string>

namespace gabor::viewer {

/// Returns GLSL that uses the drop-in to draw what a view of `extent` pixels shows. Its functions take the
/// centre of a pixel, measured from the upper left corner, or a point and a normal of a body: noise_of_view
/// returns a Noise, which shaders/passes/sum.glsl declares, and colour_of_view its colour; in space, the
/// names end in _of_body. Materials, terrain and fitted photographs have only a colour.
std::string snippet(const Document& document, Extent extent);

} // namespace gabor::viewer
