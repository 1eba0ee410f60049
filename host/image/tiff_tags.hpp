#pragma once

// Shared by the files that read and write TIFF.

#include <cstdint>

namespace gabor::image {

/// Tags of GeoTIFF and of GDAL that libtiff does not know.
inline constexpr std::uint32_t pixel_scale_tag = 33550, tie_points_tag = 33922, matrix_tag = 34264,
                               keys_tag = 34735, numbers_tag = 34736, text_tag = 34737, metadata_tag = 42112,
                               nodata_tag = 42113;

} // namespace gabor::image
