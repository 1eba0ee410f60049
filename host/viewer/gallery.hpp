#pragma once

#include "viewer/session.hpp"

#include <imgui.h>

#include <vector>

namespace gabor::viewer {

/// Small pictures of the presets that come with the program, as one picture of square cells, row by row in
/// the order of render::presets(). Each is in the middle of its cell. `tools/gallery` draws presets.jpg.
struct PresetPictures {
    static constexpr int side = 128; ///< side of a thumbnail, in pixels
    static constexpr int cell = 144;
    static constexpr int columns = 7;

    Extent extent;
    std::vector<float> colours; ///< red, green and blue of each pixel, from 0 to 1
};

/// Decodes the pictures on the first call.
const PresetPictures& preset_pictures();

/// Where the window shows pictures of presets, in Dear ImGui's units.
struct Gallery {
    struct Picture {
        std::size_t preset; ///< index in render::presets()
        ImVec2 corner;
    };

    float picture_side = 0;
    float top = 0; ///< where the field for searching ends
    std::vector<Picture> pictures = {};
};

/// Labels the pictures in a view of that size, in groups that can be searched, and opens the preset whose
/// picture is clicked.
Gallery gallery_window(Session& session, float width, float height);

} // namespace gabor::viewer
