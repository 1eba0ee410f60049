#pragma once

#include "viewer/session.hpp"

#include <imgui.h>

#include <span>
#include <vector>

namespace gabor::viewer {

/// Draws the panel beside the view and handles its input. Sizes are in Dear ImGui's units.
void side_panel(Session& session);
/// Draws the button that shows the panel again, at the lower right of the window.
void unfold_button(Session& session);
/// Draw parts of the panel, and windows over it.
void spectrum_panel(Session& session);
void ramp_editor(Session& session);
void help_window(Session& session);
void question_window(Session& session);
/// Labels a view that is zoomed or tiled.
void view_overlay(const Session& session);
/// Shows the values under the pointer, at the upper right of a view of this width.
void reading_overlay(const Session& session, float width);
/// Shows messages at the bottom of a view of that size.
void message_overlay(const Session& session, float width, float height);

/// Handles keys, and the mouse over a view of this size, unless a panel has taken them.
void handle_input(Session& session, float width, float height);

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

/// The label of a parameter's control.
std::string label_of(std::string_view name);

/// Draws text on a picture. Breaks lines wider than `wrap` unless that is 0.
void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour, float wrap = 0);

/// Explains the last item once the pointer rests on it. The text is left of the panel, so it covers no
/// control.
void tooltip(std::string_view text);
/// Whether a key, given by GLFW's number, was pressed in this frame, or repeats because it is held.
bool pressed(int key, bool repeat = false);
/// Whether any key was pressed in this frame.
bool key_went_down();

/// Small pictures of the presets that come with the program, as one picture of square cells, row by row in
/// the order of render::presets(). Each is in the middle of its cell. `tools/gallery` draws presets.jpg.
struct PresetPictures {
    static constexpr int side = 128; ///< side of a thumbnail, in pixels
    static constexpr int cell = 144;
    static constexpr int columns = 7;

    Extent extent;
    std::vector<float> colours; ///< red, green and blue of each pixel, from 0 to 1
};

/// Decodes the pictures on the first call.
const PresetPictures& preset_pictures();

/// Where the window shows pictures of presets, in Dear ImGui's units.
struct Gallery {
    struct Picture {
        std::size_t preset; ///< index in render::presets()
        ImVec2 corner;
    };

    float picture_side = 0;
    float top = 0; ///< where the field for searching ends
    std::vector<Picture> pictures = {};
};

/// Labels the pictures in a view of that size, in groups that can be searched, and opens the preset whose
/// picture is clicked.
Gallery gallery_window(Session& session, float width, float height);

} // namespace gabor::viewer
