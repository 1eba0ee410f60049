#pragma once

#include "render/request/request.hpp"

#include "passes/channels.h"

#include <array>
#include <string_view>
#include <vector>

namespace gabor::render {

#define GABOR_MATERIAL(function, Parameters, name) std::string_view(name),

/// The materials of gabor_materials.glsl: the names of its functions without the prefix, with - in place of
/// _.
constexpr std::array materials{
#include "render/request/material_rows.inc"
};

#undef GABOR_MATERIAL

/// The parameters of the request's material, erosion or sea, laid out like their struct in a std430 buffer.
/// Holds the bits of integers.
std::vector<float> struct_values(const Request& request);

using passes::material_channels, passes::terrain_channels;

} // namespace gabor::render
