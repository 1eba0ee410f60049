#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Whether that is the name of a picture that holds no parameters of a noise.
bool is_photograph(const std::filesystem::path& path);

/// Fits a noise to a photograph, and shows both.
void open_photograph(Session& session, const std::string& path);

/// Takes what was fitted, or says why nothing was; for every frame.
void go_on_fitting(Session& session);

/// Whether the window shows the photograph beside the noise.
bool shows_photograph(const Session& session);

/// The function of the noise that was fitted, where the document still has it.
std::optional<std::string> fitted_glsl(const Session& session);

/// The photograph's section of the panel.
void photograph_panel(Session& session);

/// The names of both, and the line between them, on a view of that size.
void photograph_overlay(const Session& session, float width, float height);

} // namespace gabor::viewer
