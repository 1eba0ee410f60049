#pragma once

#include "viewer/session.hpp"

#include <array>
#include <string_view>

namespace gabor::viewer {

/// The ends of the names of pictures that hold no parameters of a noise, in small letters.
inline constexpr std::array<std::string_view, 3> photograph_endings{".png", ".jpg", ".jpeg"};

/// Whether that is the name of such a picture.
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
