#pragma once

#include "render/request/request.hpp"

#include "passes/channels.h"

#include <array>
#include <string_view>
#include <vector>

namespace gabor::render {

/// The materials of gabor_materials.glsl: the names of its functions without the prefix, with - in place of
/// _.
constexpr std::array<std::string_view, 11> materials{"wood", "fabric",        "leather",   "marble",
                                                     "sand", "brushed-metal", "scratches", "zebra",
                                                     "bark", "carbon-fibre",  "strata"};

/// The parameters of the request's material, erosion or sea, laid out like their struct in a std430 buffer.
/// Holds the bits of integers.
std::vector<float> struct_values(const Request& request);

using passes::material_channels, passes::terrain_channels;

} // namespace gabor::render
