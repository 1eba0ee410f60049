#pragma once

#include "render/request.hpp"

#include <optional>
#include <string_view>

namespace gabor::render {

/// The variance that theory gives to a channel of a picture, whose law is normal around 0. None where it is
/// not normal, varies from pixel to pixel, or has no closed form here.
std::optional<double> known_variance(const Request& request, std::string_view channel);

} // namespace gabor::render
