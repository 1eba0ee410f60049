#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Edits the stops of the document's own colour map.
void ramp_editor(Session& session);

} // namespace gabor::viewer
