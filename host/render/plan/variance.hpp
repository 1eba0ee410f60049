#pragma once

#include "render/request/request.hpp"

#include <optional>
#include <string_view>

namespace gabor::render {

/// The theoretical variance of a channel that is normally distributed around 0. Returns nothing if the
/// channel is not normal, or if its variance differs between pixels or has no closed form here.
std::optional<double> known_variance(const Request& request, std::string_view channel);

} // namespace gabor::render
