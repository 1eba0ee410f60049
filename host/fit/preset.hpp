#pragma once

#include "fit/fit.hpp"
#include "render/request.hpp"

namespace gabor::fit {

/// Returns the request that draws the texture with the exemplar's size and scale.
render::Request request_of(const Exemplar& exemplar, const FittedNoise& fitted);

} // namespace gabor::fit
