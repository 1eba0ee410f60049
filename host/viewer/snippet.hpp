#pragma once

#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <string>

namespace gabor::viewer {

/// Returns GLSL that draws what a view of `extent` pixels shows, using the drop-in. Its functions take the
/// pixel's centre, counted from the upper left corner, or for a body the place and the normal. noise_of_view,
/// gradient_of_view, complex_of_view or removed_of_view has the quantity shown, colour_of_view its colours; a
/// noise in colours has only the latter.
std::string snippet(const Document& document, Extent extent);

} // namespace gabor::viewer
