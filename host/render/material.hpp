#pragma once

#include <array>
#include <string_view>

namespace gabor::render {

/// The materials of gabor_materials.glsl, as its functions are called after their prefix, with - for _.
constexpr std::array<std::string_view, 12> materials{"wood",  "fabric",  "leather",       "marble",
                                                     "sand",  "ripples", "brushed-metal", "scratches",
                                                     "zebra", "bark",    "carbon-fibre",  "strata"};

/// In place of a material's name: the noise itself.
constexpr std::string_view no_material = "none";

/// Of a material's pixels: base colour, height and so on as in GaborMaterial, and its look under a lamp.
constexpr std::array<std::string_view, 9> material_channels{
    "R", "G", "B", "height", "roughness", "metalness", "lit.R", "lit.G", "lit.B"};

} // namespace gabor::render
