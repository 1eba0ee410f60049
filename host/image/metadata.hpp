#pragma once

#include "image/picture.hpp"

#include <cstdint>

namespace gabor::image {

/// Returns the orientation in EXIF data, which begins with its byte order: 1 to 8, or 1 if there is none.
int exif_orientation(std::span<const std::uint8_t> exif);

/// Returns the name of an ICC profile, or nothing if its colours are those of sRGB.
std::string foreign_profile(std::span<const std::uint8_t> icc);

/// Turns and mirrors a picture as its format's orientation demands, and keeps all of it in memory; returns an
/// upright picture as it is.
std::unique_ptr<PictureReader> upright(const std::filesystem::path& path,
                                       std::unique_ptr<PictureReader> picture);

} // namespace gabor::image
