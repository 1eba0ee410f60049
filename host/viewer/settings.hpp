#pragma once

#include "viewer/window.hpp"

#include <string>
#include <vector>

namespace gabor::viewer {

constexpr float least_ui_scale = 0.5f;
constexpr float most_ui_scale = 4;

/// What the viewer remembers from one time to the next, in viewer.json in the user's configuration folder.
struct Settings {
    Placement placement;
    bool panels = true;
    float ui_scale = 1;
    std::string document; ///< JSON of the last session's; empty for none
    std::string preset_path;
    std::string export_path;
    std::vector<std::string> recent;
};

/// The defaults where nothing is remembered, or nothing that can be read.
Settings load_settings();
/// Does nothing where there is no place to write to.
void save_settings(const Settings& settings);

} // namespace gabor::viewer
