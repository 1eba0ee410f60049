#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Draws the panel beside the view and handles its input. Sizes are in Dear ImGui's units.
void side_panel(Session& session);
/// Draws the button that shows the panel again, at the lower right of the window.
void unfold_button(Session& session);

} // namespace gabor::viewer
