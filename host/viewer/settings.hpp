#pragma once

#include "viewer/window.hpp"

namespace gabor::viewer {

/// What the viewer remembers from one time to the next, in viewer.json in the user's configuration folder.
struct Settings {
    Placement placement;
    bool panels = true;
};

/// The defaults where nothing is remembered, or nothing that can be read.
Settings load_settings();
/// Does nothing where there is no place to write to.
void save_settings(const Settings& settings);

} // namespace gabor::viewer
