#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gabor::system {

/// The user's folder; empty if it is unknown.
std::filesystem::path home_folder();
/// The folder for settings of programs; empty if it is unknown.
std::filesystem::path settings_folder();
/// The folders above all others, such as Windows' drives; empty if there is only one.
std::vector<std::string> drives();

/// A font's file, and the font's index in it.
using Font = std::pair<std::string, int>;
/// The desktop's sans-serif font; an empty name if there is none.
Font sans_font();
/// Fonts that may have these characters, which `sans_font` lacks: the first that has one draws it.
std::vector<Font> fonts_with(const std::vector<unsigned>& characters);

/// What a user must install to get a Vulkan loader and a driver, or only a driver.
extern const std::string_view how_to_get_vulkan, how_to_get_a_driver;

} // namespace gabor::system
