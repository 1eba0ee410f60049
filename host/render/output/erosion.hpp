#pragma once

#include "image/exr.hpp"
#include "image/picture.hpp"
#include "render/output/renderer.hpp"

#include "passes/channels.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace gabor::render {

/// A heightmap to erode.
struct HeightMap {
    /// Opens the heights, starting at the first row.
    std::function<std::unique_ptr<image::PictureReader>()> open;
    int width = 0;
    int height = 0;
    int channels = 1; ///< 3 for grey that is stored as red, green and blue
    double scale = 1; ///< height = offset + scale * value read
    double offset = 0;
    std::array<double, 2> pixel{1, 1}; ///< its sides along x and y, in the unit of heights
    bool tileable = false;
    std::optional<float> missing = {}; ///< the value of pixels without a height
    /// Of a tile of a larger world: its first pixel in the world, which nodes and gullies then keep to.
    std::optional<std::array<int, 2>> world = {};

    std::array<double, 2> extent() const { return {pixel[0] * width, pixel[1] * height}; }
};

/// The nodes of a spline along an axis of a map. Pixel i is phase + (i + 0.5) nodes / pixels after node 0.
struct SplineAxis {
    double nodes = 1;
    double pixels = 1;
    double phase = 0;
    int intervals = 3; ///< between nodes, which together hold all pixels
};

/// A heightmap smoothed by a cubic B-spline: gullies follow its slope.
struct SmoothedMap {
    std::array<SplineAxis, 2> axes{};
    std::vector<float> heights;   ///< of nodes -1 to intervals + 1 along x, then along y
    double slope = 0;             ///< rms
    std::array<float, 2> range{}; ///< lowest and highest height of the map
};

/// Reads a map and smooths it with nodes about `spacing` pixels apart along x, and as far apart along y.
/// Throws RequestError for a map that is damaged or has heights that are not finite or stand for missing
/// ones, and names the pixel.
SmoothedMap smoothed(const HeightMap& map, double spacing);

/// The rms slope of the hills of gabor_terrain, for which presets are made, and the side of a map in units of
/// p.
constexpr double preset_slope = 0.637, preset_side = 8;

using passes::erosion_channels;

/// Plans the erosion of a region with the seed and the erosion of a request for terrain, whose parameters
/// mean the same for every map: maps have an rms slope of `preset_slope`, and `side` of the unit of heights,
/// usually the map's width, count as `preset_side`. `cover` adds the channels grass, scree, rock and snow:
/// their shares of the ground, as the terrain view mixes its colours for heights from -1 to 1.
Plan erosion_plan(const HeightMap& map, const SmoothedMap& smoothed, double side, const Request& request,
                  const image::Rect& region, bool cover);

/// Erodes a region band by band, so that memory use does not grow with the map's height, and passes the rows
/// to `write`, with interleaved channels. Eroding the whole map gives the region the same pixels.
void erode(const vulkan::Device& device, const HeightMap& map, const SmoothedMap& smoothed, double side,
           const Request& request, const image::Rect& region, bool cover, const Sink& write);

/// How much erosion may change a height of a map.
double erosion_reach(const SmoothedMap& smoothed, double side, const Request& request);

} // namespace gabor::render
