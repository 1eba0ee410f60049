#pragma once

#include "render/pixels.hpp"
#include "viewer/document.hpp"
#include "viewer/window.hpp"

#include <string>
#include <vector>

namespace gabor::viewer {

/// As in shaders/viewer/grid.glsl.
struct AxisPoint {
    std::int32_t cell;
    float local;
};

/// The place `by` kernel radii from a coordinate. `radius`: cells per kernel radius. Cells wrap around at
/// 2^31, as the drop-in's do.
AxisPoint axis_point(const Coordinate& coordinate, double by, double radius);

/// The points along an axis of a view of `pixels` pixels, `scale` pixels per kernel radius, `stride` pixels
/// apart: the first in the middle of the first `stride` pixels.
void add_points(std::vector<AxisPoint>& points, const Coordinate& middle, int pixels, double scale,
                int stride, double radius);

/// What passes/pixels.comp is told, and beyond that the viewer's own passes: shaders/viewer/view.glsl.
struct ViewPush {
    render::PixelsPush pixels;
    float amplitude;
    float stride;
    float yaw;
    float pitch;
};

/// Which noise one side of the view shows, in which way.
struct NoisePass {
    std::string shader;
    std::vector<std::uint32_t> constants;
    render::Picture picture; ///< with the channels that the view shows
    View view = View::plane;
    std::optional<study::Ingredients> ingredients; ///< where it is no noise of the drop-in
    std::string name;
    double visited = 0; ///< impulses for each pixel; the mean where their number is random
    int channels = 1;

    /// Whether both are filled by the same pass.
    bool same_pass(const NoisePass& other) const {
        return shader == other.shader && constants == other.constants && picture.paint == other.picture.paint;
    }
};

/// The noise_passes of a document: the picture, and its comparison in the split view.
std::vector<NoisePass> noise_passes(const Document& document);

/// The same noise, in a plane whatever the view: for the law of its values.
NoisePass in_plane(NoisePass noise);

/// What decides the pixels of a view beside its points.
struct ViewParameters {
    ViewPush push{};
    std::vector<render::PassLobe> lobes;
};

ViewParameters view_parameters(const NoisePass& noise, const Document& document, Extent extent);

/// Where the columns, and then the rows, of a view are whose values are `stride` pixels apart.
struct SamplePoints {
    std::vector<AxisPoint> columns;
    std::vector<AxisPoint> rows;
};

SamplePoints sample_points(const NoisePass& noise, const Document& document, Extent extent, int stride);

/// So many columns and rows at random within their cells, each pair of them independent of all others.
SamplePoints random_points(const NoisePass& noise, int columns, int rows, std::uint32_t draw);

} // namespace gabor::viewer
