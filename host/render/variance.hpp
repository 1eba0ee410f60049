#pragma once

#include "render/request.hpp"

#include <optional>
#include <string_view>

namespace gabor::render {

/// The theoretical variance of a channel that is normally distributed around 0. Nothing if it is not normal,
/// varies from pixel to pixel, or has no closed form here.
std::optional<double> known_variance(const Request& request, std::string_view channel);

} // namespace gabor::render
