#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Labels a view that is zoomed or tiled.
/// `refining`: for how many seconds the view has been getting finer.
void view_overlay(const Session& session, double refining);
/// Shows the values under the pointer, at the upper right of a view of this width.
void reading_overlay(const Session& session, float width);
/// Shows messages at the bottom of a view of that size.
void message_overlay(const Session& session, float width, float height);

/// Asks the session's question, if there is one.
void question_window(Session& session);

} // namespace gabor::viewer
