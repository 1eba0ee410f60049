#pragma once

#include "viewer/window.hpp"

#include <string>
#include <vector>

namespace gabor::viewer {

constexpr float least_ui_scale = 0.5f;
constexpr float most_ui_scale = 4;

/// What the viewer remembers, in viewer.json in the user's configuration folder.
struct Settings {
    Placement placement;
    bool panels = true;
    float ui_scale = 1;
    std::string document = {}; ///< document of the last session, as JSON; empty for none
    std::string preset_path = {};
    std::string export_path = {};
    std::vector<std::string> recent = {};
    int unsaved_by = 0; ///< id of a process whose changes were neither saved nor discarded; 0 for none

    bool operator==(const Settings&) const = default;
};

/// Returns the defaults if viewer.json is missing or cannot be read.
Settings load_settings();
/// Replaces viewer.json atomically. Returns why it cannot, in one line; empty if it has.
std::string save_settings(const Settings& settings);

} // namespace gabor::viewer
