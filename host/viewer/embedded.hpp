#pragma once

#include <span>
#include <string_view>

namespace gabor::viewer {

/// The bytes of a file in the program: presets.jpg, or a shader that Copy GLSL adds to a noise.
std::span<const unsigned char> embedded(std::string_view name);

} // namespace gabor::viewer
