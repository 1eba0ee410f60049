#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gabor::image {

/// Where a map lies: the tags of a GeoTIFF, as stored (https://docs.ogc.org/is/19-008r4/19-008r4.html).
struct GeoTags {
    std::vector<double> pixel_scale;
    std::vector<double> tie_points;
    std::vector<double> matrix;
    std::vector<std::uint16_t> keys;
    std::vector<double> numbers; ///< of keys
    std::string text;            ///< of keys
    std::string unit;            ///< of heights, as GDAL states it; empty if it does not

    /// Whether any tag says where the map lies, or on which scale.
    bool exist() const {
        return !pixel_scale.empty() || !tie_points.empty() || !matrix.empty() || !keys.empty();
    }
};

/// The sides of a pixel, along rows and columns, in the unit of heights.
struct PixelSize {
    std::array<double, 2> sides;
    std::string unit;    ///< of heights: "m", "ft", "US survey ft", or empty if no tag tells
    std::string assumed; ///< what the tags leave open, and what this takes for it; empty if nothing
};

/// Degrees become lengths at the latitude of the map's middle, on the ellipsoid of WGS 84. Heights without a
/// unit have that of the map, or metres if the map is in degrees. Throws RequestError, with a reason, for
/// tags that cannot be understood.
PixelSize pixel_size(const GeoTags& tags, int width, int height);

/// The tags of a map in degrees whose first pixel has its centre at a longitude and latitude.
GeoTags degree_tags(double longitude, double latitude, double step_x, double step_y);

/// The tags of a map without a place, whose pixels have these sides.
GeoTags plain_tags(const std::array<double, 2>& sides);

/// The tags of the part of a map that begins at a pixel.
GeoTags moved(GeoTags tags, int x, int y);

} // namespace gabor::image
