#pragma once

#include "image/exr.hpp"
#include "image/picture.hpp"
#include "render/renderer.hpp"

#include "passes/channels.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace gabor::render {

/// A heightmap to erode. `pixel` is the width of a pixel in the unit of the heights.
struct HeightMap {
    /// Opens one channel of heights, starting at the first row.
    std::function<std::unique_ptr<image::PictureReader>()> open;
    int width = 0;
    int height = 0;
    double pixel = 1;
    double scale = 1; ///< height = offset + scale * value read
    double offset = 0;
    bool tileable = false;
};

using passes::erosion_channels;

/// Plans the erosion of a region with the seed and the erosion of a request for terrain.
Plan erosion_plan(const HeightMap& map, const Request& request, const image::Rect& region);

/// Erodes a region band by band, so that memory use does not grow with the map's height, and passes the rows
/// to `write`, with interleaved channels. Eroding the whole map gives the region the same pixels. Throws
/// RequestError for a map that is damaged or contains NaN or infinity.
void erode(const vulkan::Device& device, const HeightMap& map, const Request& request,
           const image::Rect& region, const Sink& write);

} // namespace gabor::render
