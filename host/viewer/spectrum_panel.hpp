#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Draws the frequency plane with the lobes, their list and the controls of the chosen one.
void spectrum_panel(Session& session);

} // namespace gabor::viewer
