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
void export_panel(Session& session);
void help_window(Session& session);
void question_window(Session& session);
/// On the picture: how the view differs from it.
void view_overlay(const Session& session);
/// At the foot of the view: messages.
void message_overlay(const Session& session, float height);

/// Keys, and the mouse over a picture of this size, where no panel takes them.
void handle_input(Session& session, float width, float height);

/// A slider over the usual part of a range, all of which can be typed; a double click sets it back. Returns
/// whether the value was changed.
bool number_slider(const char* label, double& value, const render::Range& range, const render::Range& usual,
                   double by_default);
/// Whether the slider of that label, drawn just now, is to go back: from a double click until the button is
/// released.
bool reset_asked(const char* label);

/// The controls of all parameters that no panel has a place for.
void other_parameters(Session& session);

/// What `draw` draws, with a tooltip; disabled where `dead` says why it has no effect.
void explained(std::string_view dead, std::string_view help, const std::function<void()>& draw);

/// Text on a picture.
void label(ImDrawList& draw, ImVec2 at, const std::string& text, ImU32 colour);

/// Explains the item before once the pointer rests on it.
void tooltip(std::string_view text);

} // namespace gabor::viewer
