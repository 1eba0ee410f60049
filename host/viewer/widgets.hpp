#pragma once

#include "render/request/parameters.hpp"

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

namespace gabor::viewer {

/// The label of a parameter's control.
std::string label_of(std::string_view name);

/// Shows the share that is done, from 0 to 1.
void progress_bar(double done, float width);

/// A slider that shows its place as a line below its number, which a handle would hide. `flags` are Dear
/// ImGui's.
bool slider(const char* label, float& value, float low, float high, const char* format, int flags = 0);

/// A slider over the usual part of a range. Any value in the range can be typed, and a double click resets
/// the slider. Returns whether the value was changed.
bool number_slider(const char* label, double& value, const render::Range& range, const render::Range& usual,
                   double by_default);
/// Whether to reset the last slider, which has this label: true from a double click until the button is
/// released.
bool reset_asked(const char* label);

/// A drop-down list of names, with their explanations. Returns true when the user changes the selection.
bool choose_number(const char* label, std::size_t& number, std::span<const std::string_view> names,
                   std::span<const char* const> tips);

template <typename T> // an enumeration or a number
bool choose(const char* label, T& value, std::span<const std::string_view> names,
            std::span<const char* const> tips = {}) {
    auto number = static_cast<std::size_t>(value);
    const bool chosen = choose_number(label, number, names, tips);
    value = static_cast<T>(number);
    return chosen;
}

/// A colour's code, such as #7A3F10, and a button that opens a picker. Returns whether the colour was
/// changed. Throws RequestError when the user leaves the code and it is none.
bool colour_field(const char* label, std::array<float, 3>& colour);

/// Draws text on a picture. Breaks lines wider than `wrap` unless that is 0.
void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour, float wrap = 0);

/// Explains the last item once the pointer rests on it. The text is left of the panel, so it covers no
/// control.
void tooltip(std::string_view text);
/// Whether a key, given by GLFW's number, was pressed in this frame, or repeats because it is held.
bool pressed(int key, bool repeat = false);
/// Whether any key was pressed in this frame.
bool key_went_down();

} // namespace gabor::viewer
