#pragma once

#include <imgui.h>

namespace gabor::viewer {

/// A slider whose number stands where its grab is not. For float and int.
template <typename T>
bool slider(const char* label, T& value, T low, T high, const char* format, ImGuiSliderFlags flags = 0);

} // namespace gabor::viewer
