#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

// Each draws itself, and changes the session by what is done to it.
void noise_panel(Session& session);
void spectrum_panel(Session& session);
void output_panel(Session& session);
void measurements_panel(Session& session);
void take_home_panel(Session& session);
void help_window(Session& session);
/// On the picture itself: names and times of the sides, notes, and what is wrong with a shader.
/// `width`: of the picture, in Dear ImGui's units.
void overlay(const Session& session, float width, float height);

/// A question mark's worth of words over the item before.
void tip(const char* text);

} // namespace gabor::viewer
