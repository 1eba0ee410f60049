#pragma once

#include "viewer/session.hpp"

#include <imgui.h>

namespace gabor::viewer {

/// The user interface: each function draws a part of it, and changes the session by what is done to it. Sizes
/// are in Dear ImGui's units.
void noise_panel(Session& session);
void spectrum_panel(Session& session);
void output_panel(Session& session);
void measurements_panel(Session& session);
void files_panel(Session& session);
void help_window(Session& session);
void question_window(Session& session);
/// On the picture itself: the names and times of the panes, messages, and what is wrong with a shader.
void overlay(const Session& session, float width, float height);

/// Keys, and the mouse over a picture of this size, where no panel takes them.
void handle_input(Session& session, float width, float height);

/// A slider over the usual part of a range, all of which can be typed; a double click sets it back. Returns
/// whether the value was changed.
bool number_slider(const char* label, double& value, const render::Range& range, const render::Range& usual,
                   double by_default);
/// Whether the slider of that label, drawn just now, is to go back: from a double click until the button is
/// released.
bool reset_asked(const char* label);

/// Text on a picture.
void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour);

/// Explains the item before once the pointer rests on it.
void tooltip(std::string_view text);

} // namespace gabor::viewer
