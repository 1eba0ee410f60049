// The channels of the pixels that a pass writes, for GLSL and C++. A list applies CHANNEL(index, constant,
// names) to each scalar or vector: the index of its first channel, the constant for that index, and its
// channels' names. The channels of noise depend on the request; passes/noise_channels.glsl gets their indices
// from the host.

#ifndef GABOR_CHANNELS_H
#define GABOR_CHANNELS_H

#include "passes/interface.h"

// The members of GaborMaterial, the lit colour, and the slope of the height, which bodies lack.
#define GABOR_MATERIAL_CHANNELS(CHANNEL)                                                                     \
    CHANNEL(0, material_colour, ("R", "G", "B"))                                                             \
    CHANNEL(3, material_height, ("height"))                                                                  \
    CHANNEL(4, material_roughness, ("roughness"))                                                            \
    CHANNEL(5, material_metalness, ("metalness"))                                                            \
    CHANNEL(6, material_lit, ("lit.R", "lit.G", "lit.B"))                                                    \
    CHANNEL(9, material_slope, ("slope.x", "slope.y"))

// Height and the colours have the same indices as for a material.
#define GABOR_TERRAIN_CHANNELS(CHANNEL)                                                                      \
    CHANNEL(0, terrain_colour, ("R", "G", "B"))                                                              \
    CHANNEL(3, terrain_height, ("height"))                                                                   \
    CHANNEL(4, terrain_slope, ("slope.x", "slope.y"))                                                        \
    CHANNEL(6, terrain_lit, ("lit.R", "lit.G", "lit.B"))                                                     \
    CHANNEL(9, terrain_ridge, ("ridge"))                                                                     \
    CHANNEL(10, terrain_erosion, ("erosion"))

// Height and the colours have the same indices as for a material. `jacobian` is that of GaborWater.
#define GABOR_OCEAN_CHANNELS(CHANNEL)                                                                        \
    CHANNEL(0, ocean_colour, ("R", "G", "B"))                                                                \
    CHANNEL(3, ocean_height, ("height"))                                                                     \
    CHANNEL(4, ocean_slope, ("slope.x", "slope.y"))                                                          \
    CHANNEL(6, ocean_lit, ("lit.R", "lit.G", "lit.B"))                                                       \
    CHANNEL(9, ocean_jacobian, ("jacobian"))                                                                 \
    CHANNEL(10, ocean_foam, ("foam"))

// An eroded map. Other programs show Y, the height. `erosion` is the height that erosion added; the shares of
// the ground that follow it are optional.
#define GABOR_EROSION_CHANNELS(CHANNEL)                                                                      \
    CHANNEL(0, erosion_height, ("Y"))                                                                        \
    CHANNEL(1, erosion_slope, ("slope.x", "slope.y"))                                                        \
    CHANNEL(3, erosion_ridge, ("ridge"))                                                                     \
    CHANNEL(4, erosion_added, ("erosion"))                                                                   \
    CHANNEL(5, erosion_cover, ("grass", "scree", "rock", "snow"))

#define GABOR_CHANNEL_INDEX(index, constant, names) const int constant = index;

GABOR_INTERFACE_BEGIN

GABOR_MATERIAL_CHANNELS(GABOR_CHANNEL_INDEX)
GABOR_TERRAIN_CHANNELS(GABOR_CHANNEL_INDEX)
GABOR_OCEAN_CHANNELS(GABOR_CHANNEL_INDEX)
GABOR_EROSION_CHANNELS(GABOR_CHANNEL_INDEX)

const int material_coverage = material_slope; // of bodies, named A

GABOR_INTERFACE_END

#ifdef __cplusplus

#include <array>
#include <string_view>

#define GABOR_CHANNEL_NAMES(index, constant, names) GABOR_UNPARENTHESIZED names,
#define GABOR_UNPARENTHESIZED(...) __VA_ARGS__

namespace gabor::passes {

inline constexpr auto material_channels =
    std::to_array<std::string_view>({GABOR_MATERIAL_CHANNELS(GABOR_CHANNEL_NAMES)});
inline constexpr auto terrain_channels =
    std::to_array<std::string_view>({GABOR_TERRAIN_CHANNELS(GABOR_CHANNEL_NAMES)});
inline constexpr auto ocean_channels =
    std::to_array<std::string_view>({GABOR_OCEAN_CHANNELS(GABOR_CHANNEL_NAMES)});
inline constexpr auto erosion_channels =
    std::to_array<std::string_view>({GABOR_EROSION_CHANNELS(GABOR_CHANNEL_NAMES)});

} // namespace gabor::passes

#endif

#endif // GABOR_CHANNELS_H
