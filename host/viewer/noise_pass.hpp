#pragma once

#include "render/bake.hpp"
#include "render/material.hpp"
#include "render/pixels.hpp"
#include "render/solid.hpp"
#include "viewer/document.hpp"
#include "viewer/extent.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gabor::viewer {

/// The point `by` kernel radii from a coordinate: its cell and the place in it. `radius`: cells per kernel
/// radius. Cells wrap around at 2^31, as the drop-in's do.
std::pair<std::int32_t, double> axis_place(const Coordinate& coordinate, double by, double radius);
passes::Line axis_point(const Coordinate& coordinate, double by, double radius);

/// The points along an axis of a view of `pixels` pixels, `scale` pixels per kernel radius, `stride` pixels
/// apart: the first in the middle of the first `stride` pixels. Each is there for all `radii`, side by side.
void add_points(std::vector<passes::Line>& points, const Coordinate& middle, int pixels, double scale,
                int stride, const std::vector<double>& radii);

/// The compute pass that evaluates the picture in the window.
struct NoisePass {
    std::string shader; ///< as compile_shader takes it
    std::vector<std::uint32_t> constants;
    std::optional<Extent> block; ///< of passes/bake.comp, where it is that
    render::Request request;     ///< with the channels that the output needs
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

/// The pass of a document. `cpu`: whether the device is one.
NoisePass noise_pass(const Document& document, bool cpu = true);

/// The same noise, its value alone, sharp, and on a plane from above: for the statistics of its values.
NoisePass value_pass(const NoisePass& noise);

/// What passes/pixels.comp reads.
struct PixelsInput {
    passes::PixelsPush push;
    std::vector<passes::Line> columns;
    std::vector<passes::Line> rows;
    std::vector<passes::PixelsWave> waves;
    passes::PixelsColour colour = {};
};

/// What passes/solid.comp reads.
struct SolidInput {
    passes::SolidPush push;
    std::vector<passes::SolidWave> waves;
    passes::PixelsColour colour = {};
};

/// What passes/material.comp reads.
struct MaterialInput {
    passes::MaterialPush push;
};

/// The most pixels, a power of two, that a value may stand for while the view moves. Phases, which do not
/// fade with their wave, and what is painted keep at least three values to each wave.
int coarsest_stride(const NoisePass& noise, const render::Paint& paint, double zoom);

/// What a pass is given to fill a grid of values.
struct GridInput {
    Extent grid;
    std::variant<PixelsInput, SolidInput, MaterialInput, render::BakeTables> of;
};

/// Values `stride` pixels apart of what the camera sees in a view of `extent` pixels. Where they stand for
/// more than a pixel of the picture their waves are filtered by as much, but for what is painted and for
/// views in perspective that are not.
GridInput view_grid(const NoisePass& noise, const Camera& camera, Extent extent, int stride,
                    const render::Paint& paint);

/// Values of a `value_pass` at points that are independent of each other, of an instance that `draw` tells.
/// Where a ray meets no body their channel `A` is 0.
GridInput random_grid(const NoisePass& noise, Extent grid, std::uint32_t draw);

} // namespace gabor::viewer
