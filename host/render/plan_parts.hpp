#pragma once

// Shared by plan.cpp, bake.cpp and erosion.cpp.

#include "noise/spectrum.hpp"
#include "render/plan.hpp"
#include "vulkan/pass.hpp"

#include "passes/colour.h"

namespace gabor::render {

/// The corner of the view along an axis: exactly 0 for the picture that gabor render draws.
inline Coordinate corner_of(const Coordinate& middle, int pixels, const Request& request,
                            const Viewport& viewport) {
    return middle.moved(-pixels / 2.0 / (request.scale * viewport.camera.zoom));
}

/// The share of a wave's amplitude that a value keeps. An unfiltered value that stands for several pixels is
/// filtered like a pixel of that size. `frequency` is in cycles per kernel radius.
float share_left(const Request& request, const Viewport& viewport, double frequency);

/// Scales a wave, in grey and in colour.
template <typename Wave>
void fade(Wave& wave, float share) {
    wave.amplitude *= share;
    for (passes::vec2& weight : wave.weights)
        weight = {share * weight.x, share * weight.y};
}

/// The parameters of an erosion in the layout that passes read.
Bytes erosion_table(const Erosion& erosion);

/// The request's colour, or zeros if it has none.
passes::PixelsColour colour_of(const Request& request);

/// Sets a lobe's weights if the request has a colour.
void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe);

} // namespace gabor::render
