#pragma once

#include "viewer/extent.hpp"

#include <vector>

namespace gabor::viewer {

/// Small pictures of the presets that come with the program, as one picture of square cells, row by row in
/// the order of render::presets(). Each is in the middle of its cell. `tools/gallery` draws presets.jpg.
struct PresetPictures {
    static constexpr int side = 128; ///< side of a small picture, in pixels
    static constexpr int cell = 144;
    static constexpr int columns = 7;

    Extent extent;
    std::vector<float> colours; ///< red, green and blue of each pixel, from 0 to 1
};

/// Decodes the pictures on the first call.
const PresetPictures& preset_pictures();

} // namespace gabor::viewer
