#pragma once

#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <string>

namespace gabor::viewer {

/// GLSL for the material that a view of `extent` pixels shows: a function of the pixel's centre, counted from
/// the upper left corner; of a body, a function of the place and the normal.
std::string material_snippet(const Document& document, Extent extent);

} // namespace gabor::viewer
