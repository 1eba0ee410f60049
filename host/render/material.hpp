#pragma once

#include "render/request.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace gabor::render {

/// The materials of gabor_materials.glsl: the names of its functions without the prefix, with - in place of
/// _.
constexpr std::array<std::string_view, 12> materials{"wood",  "fabric",  "leather",       "marble",
                                                     "sand",  "ripples", "brushed-metal", "scratches",
                                                     "zebra", "bark",    "carbon-fibre",  "strata"};

/// The parameters of the request's material or erosion, laid out like their struct in a std430 buffer. Holds
/// the bits of integers.
std::vector<float> struct_values(const Request& request);

/// Channels of a material's pixels: the members of GaborMaterial, the lit colour, and the slopes of the
/// height along x and y, which bodies lack.
constexpr std::array<std::string_view, 11> material_channels{
    "R", "G", "B", "height", "roughness", "metalness", "lit.R", "lit.G", "lit.B", "slope.x", "slope.y"};
constexpr std::size_t lit_channel = 6; ///< index of lit.R in material_channels and terrain_channels

/// Channels of a terrain's pixels. Height and the colours have the same indices as for a material.
constexpr std::array<std::string_view, 11> terrain_channels{
    "R", "G", "B", "height", "slope.x", "slope.y", "lit.R", "lit.G", "lit.B", "ridge", "erosion"};

} // namespace gabor::render
