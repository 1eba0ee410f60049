#pragma once

// What plan.cpp and bake.cpp share.

#include "noise/spectrum.hpp"
#include "render/plan.hpp"
#include "vulkan/pass.hpp"

#include "passes/colour.h"

namespace gabor::render {

/// The corner of the view along an axis: for the request's own picture exactly 0.
inline Coordinate corner_of(const Coordinate& middle, int pixels, const Request& request,
                            const Viewport& viewport) {
    return middle.moved(-pixels / 2.0 / (request.scale * viewport.camera.zoom));
}

/// The share of a wave's amplitude that is left in a value: without a filter of its own, one that stands for
/// several pixels is seen through the filter of a pixel of its size. `frequency`: cycles per kernel radius.
float share_left(const Request& request, const Viewport& viewport, double frequency);

/// Leaves a share of a wave, in grey and in colour.
template <typename Wave>
void fade(Wave& wave, float share) {
    wave.amplitude *= share;
    for (passes::vec2& weight : wave.weights)
        weight = {share * weight.x, share * weight.y};
}

/// What its colours are made of, zeros where there are none.
passes::PixelsColour colour_of(const Request& request);

/// Of a lobe, the weights of its quadrature and its noise in the components of these colours: zeros likewise.
void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe);

} // namespace gabor::render
