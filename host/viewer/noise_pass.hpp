#pragma once

#include "render/material.hpp"
#include "render/pixels.hpp"
#include "render/solid.hpp"
#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include "viewer/ingredients_interface.h"

#include <string>
#include <variant>
#include <vector>

namespace gabor::viewer {

/// The point `by` kernel radii from a coordinate. `radius`: cells per kernel radius. Cells wrap around at
/// 2^31, as the drop-in's do.
passes::Line axis_point(const Coordinate& coordinate, double by, double radius);

/// The points along an axis of a view of `pixels` pixels, `scale` pixels per kernel radius, `stride` pixels
/// apart: the first in the middle of the first `stride` pixels. Each is there for all `radii`, side by side.
void add_points(std::vector<passes::Line>& points, const Coordinate& middle, int pixels, double scale,
                int stride, const std::vector<double>& radii);

/// The compute pass that evaluates the noise of one pane.
struct NoisePass {
    std::string shader; ///< as ShaderCompiler::compile takes it
    std::vector<std::uint32_t> constants;
    render::Request request;                       ///< with the channels that the output needs
    std::optional<study::Ingredients> ingredients; ///< where it is no noise of the drop-in
    std::string name;
    double visited = 0; ///< impulses or nodes for each pixel; the mean where their number is random
    std::vector<std::string> channels;

    int channel_count() const { return static_cast<int>(channels.size()); }
    /// Whether both are evaluated by the same pipeline.
    bool same_pipeline(const NoisePass& other) const {
        return shader == other.shader && constants == other.constants && request.paint == other.request.paint;
    }
    bool operator==(const NoisePass&) const = default;
    /// Of noise on a body, what its light needs beside the gradient: `normal.x`, `normal.y` and `normal.z`,
    /// and `gradient.z`, along the picture's right and down and to the eye.
    void add_normal();
};

/// The passes of a document: the picture's, and in the split view that of the compared noise.
std::vector<NoisePass> noise_passes(const Document& document);

/// The same noise on a plane, its value alone: for the statistics of its values.
NoisePass value_pass(const NoisePass& noise);

/// What a pass is given to fill a grid of values.
struct GridInput {
    std::variant<passes::PixelsPush, passes::IngredientsPush, passes::SolidPush, passes::MaterialPush> push;
    Extent grid;
    std::vector<passes::Line> columns; ///< with the rows: where the values are, but for noise in space
    std::vector<passes::Line> rows;
    std::variant<std::vector<passes::PixelsWave>, std::vector<passes::SolidWave>> waves; ///< their sum
    passes::PixelsColour colour = {};
};

/// Values `stride` pixels apart of what the camera sees in a view of `extent` pixels.
GridInput view_grid(const NoisePass& noise, const Camera& camera, Extent extent, int stride,
                    const render::Paint& paint);

/// Values of a `value_pass` at points that are independent of each other, of an instance that `draw` tells.
GridInput random_grid(const NoisePass& noise, Extent grid, std::uint32_t draw);

} // namespace gabor::viewer
