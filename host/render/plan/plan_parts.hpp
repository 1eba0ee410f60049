#pragma once

// Shared by plan.cpp, bake.cpp, erosion.cpp and ocean.cpp.

#include "noise/spectrum.hpp"
#include "render/plan/plan.hpp"
#include "vulkan/pass.hpp"

#include "passes/bake_interface.h"
#include "passes/colour.h"

#include <cmath>

namespace gabor::render {

/// Converts a vector to single precision.
inline passes::vec2 vec2_of(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}
inline passes::vec2 vec2_of(const std::array<double, 2>& v) {
    return vec2_of(v[0], v[1]);
}

/// The unit vector at an angle in radians.
inline passes::vec2 direction(double angle) {
    return vec2_of(std::cos(angle), std::sin(angle));
}

/// Returns push constants that are zero except for the region.
template <typename Push>
Push push_of(const image::Rect& region) {
    Push push{};
    push.first_column = region.x;
    push.first_row = region.y;
    push.width = region.width;
    push.height = region.height;
    return push;
}

/// A sea's GaborOcean, laid out as passes/ocean.comp reads it.
std::vector<std::byte> ocean_table(const Request& request);

/// What the plans of a picture need along an axis.
struct Side {
    int picture;       ///< pixels of the request's picture
    int view;          ///< pixels of the view
    int first;         ///< the region's first value
    int count;         ///< values in the region
    double scale;      ///< pixels per kernel radius
    double stride;     ///< pixels per value
    Coordinate middle; ///< of the view

    /// The edge of the view: exactly 0 for the picture that gabor render draws.
    Coordinate edge() const { return middle.moved(-view / 2.0 / scale); }
};

/// The side of a picture along x (0) or y (1).
inline Side side_of(const Request& request, const Viewport& viewport, std::size_t axis) {
    const auto& [camera, width, height, region, stride, blocks, normals, lit] = viewport;
    const double scale = request.scale * camera.zoom;
    return axis == 0 ? Side{request.width, width, region.x, region.width, scale, double(stride), camera.x}
                     : Side{request.height, height, region.y, region.height, scale, double(stride), camera.y};
}

/// Returns the share of a wave's amplitude that remains after antialiasing a value that stands for several
/// pixels, or 1 if the request has a filter, because the pass then filters. `frequency` is in cycles per
/// kernel radius.
float share_left(const Request& request, const Viewport& viewport, double frequency);

/// Scales a wave's amplitude and its colour weights.
template <typename Wave>
void fade(Wave& wave, float share) {
    wave.amplitude *= share;
    for (passes::vec2& weight : wave.weights)
        weight = {share * weight.x, share * weight.y};
}

/// The request's colour, or zeros if it has none.
passes::PixelsColour colour_of(const Request& request);

/// Sets a lobe's weights if the request has a colour.
void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe);

/// Covers the pixels first, ..., first + count - 1 with runs of at most `longest` pixels. Pixel i is centred
/// at origin + (i + 0.5) * cells_per_pixel cells and visits the cells within `radius`. The grid of cells
/// decides where runs start, so that all parts of a picture are cut alike; the first and last run may extend
/// past the range.
std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest,
                                   double origin = 0);

/// Plans passes/bake.comp, and passes/bake_colour.comp for colour. Waves whose kernels have the same radii
/// share a step, because they share their runs. `constants` holds the constants that depend on the request.
void plan_bake(Plan& plan, const Request& request, const Viewport& viewport, DeviceKind device,
               const Constants& constants);

} // namespace gabor::render
