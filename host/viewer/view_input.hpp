#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Moves the camera and answers short cuts, by what Dear ImGui has seen of mouse and keyboard in this frame.
/// `width`, `height`: of the picture in the window; `density`: pixels of the framebuffer per unit of those.
/// Returns whether the window is to close.
bool view_input(Session& session, float width, float height, float density);

} // namespace gabor::viewer
