#pragma once

#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <string>

namespace gabor::viewer {

/// GLSL that draws what a view of `extent` pixels shows, with the drop-in: functions of the pixel's centre,
/// counted from the upper left corner, and of a body of the place and the normal. One has the quantity that
/// the output is made of, noise_of_view, gradient_of_view, complex_of_view or removed_of_view, and
/// colour_of_view its colours; a noise in colours has the latter alone.
std::string snippet(const Document& document, Extent extent);

} // namespace gabor::viewer
