#pragma once

#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <string>

namespace gabor::viewer {

/// Returns GLSL that uses the drop-in to draw what a view of `extent` pixels shows. Its functions take the
/// centre of a pixel, measured from the upper left corner, or a place and a normal on a body. noise_of_view,
/// gradient_of_view, relief_of_view, complex_of_view or removed_of_view returns the quantity shown, and
/// colour_of_view its colour. A fitted photograph has only colour_of_view.
std::string snippet(const Document& document, Extent extent);

} // namespace gabor::viewer
