#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Handles keys, and the mouse over a view of this size, unless a panel has taken them.
void handle_input(Session& session, float width, float height);

/// Lists the keys and what the mouse does.
void help_window(Session& session);

} // namespace gabor::viewer
