#pragma once

#include <span>
#include <string_view>

namespace gabor::viewer {

/// The bytes of a file embedded in the program: presets.jpg, or a shader that "Copy code" includes.
std::span<const unsigned char> embedded(std::string_view name);

} // namespace gabor::viewer
