#pragma once

#include "viewer/session.hpp"

#include <array>
#include <string_view>

namespace gabor::viewer {

/// Extensions of pictures that cannot hold parameters, in lower case.
inline constexpr std::array<std::string_view, 3> photograph_endings{".png", ".jpg", ".jpeg"};

/// Whether a file has one of these extensions.
bool is_photograph(const std::filesystem::path& path);

/// Fits a noise to a photograph, and shows both.
void open_photograph(Session& session, const std::string& path);

/// Uses a finished fit, or reports why it failed. Call it in each frame.
void poll_fitter(Session& session);

/// Whether the window shows the photograph beside its noise.
bool shows_photograph(const Session& session);

/// The GLSL function of the fitted noise; nothing if the document no longer shows that noise.
std::optional<std::string> fitted_glsl(const Session& session);

/// The photograph's section of the panel.
void photograph_panel(Session& session);

/// Labels photograph and noise, and draws the line between them, on a view of that size.
void photograph_overlay(const Session& session, float width, float height);

} // namespace gabor::viewer
