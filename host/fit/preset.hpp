#pragma once

#include "fit/fit.hpp"
#include "render/request.hpp"

namespace gabor::fit {

/// The texture as a picture of the exemplar's size and scale.
render::Request request_of(const Exemplar& exemplar, const FittedNoise& fitted);

} // namespace gabor::fit
