#pragma once

// What plan.cpp, bake.cpp and erosion.cpp share.

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
/// filtered as a pixel of its size. `frequency`: cycles per kernel radius.
float share_left(const Request& request, const Viewport& viewport, double frequency);

/// Scales a wave, in grey and in colour.
template <typename Wave>
void fade(Wave& wave, float share) {
    wave.amplitude *= share;
    for (passes::vec2& weight : wave.weights)
        weight = {share * weight.x, share * weight.y};
}

/// The parameters of an erosion as passes read them.
Bytes erosion_table(const Erosion& erosion);

/// The request's colour, or zeros if it has none.
passes::PixelsColour colour_of(const Request& request);

/// Sets a lobe's weights in the colour, or leaves zeros if there is none.
void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe);

} // namespace gabor::render
