#pragma once

#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "image/picture.hpp"
#include "image/png.hpp"
#include "image/tiff_writer.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace gabor::render {

/// Tells whether a file has this extension, ignoring case.
bool has_extension(const std::filesystem::path& path, const char* extension);

/// Heights that 0 and 65535 stand for in 16-bit files.
struct Elevation {
    double low;
    double high;
};

/// What HeightWriter wrote beside a heightmap.
struct MapScale {
    std::optional<Elevation> elevation; ///< of 16-bit files
    std::array<double, 2> extent;       ///< width and height of the map in the unit of its heights
    std::optional<float> missing;       ///< the value in the file of pixels without a height
};

/// What is beside this heightmap, if anything.
std::optional<MapScale> scale_beside(const std::filesystem::path& map);

/// What a heightmap's values mean.
struct HeightFormat {
    Elevation elevation;          ///< of 16-bit files
    bool full_range = false;      ///< 16-bit files span the heights that there are, instead of `elevation`
    std::array<double, 2> pixel;  ///< its sides, in the unit of heights
    std::optional<float> missing; ///< the height of pixels that have none; 0 stands for it in 16-bit files
    image::GeoTags geo;           ///< of a TIFF
    image::ExrHeader exr; ///< of an EXR, except for its channels; its compression is that of a TIFF, too
};

/// The extensions of heightmaps: 16-bit integers in .png, .r16 and .raw, 32-bit floats in .r32, .exr and
/// .tif.
inline constexpr std::array height_extensions{".png", ".r16", ".raw", ".r32", ".exr", ".tif", ".tiff"};

/// Tells whether a file is a TIFF by its name.
bool is_tiff(const std::filesystem::path& path);
/// Tells whether files of this name hold 16-bit integers, and thus need a range of heights.
bool is_16_bit(const std::filesystem::path& path);

/// Writes a heightmap and, except for a TIFF, a JSON file beside it with its size, extent, range of heights,
/// and the value of pixels without a height.
class HeightWriter {
  public:
    /// Throws RequestError unless the name has one of `height_extensions`.
    HeightWriter(const std::filesystem::path& path, const image::Rect& region, HeightFormat format);

    /// Writes rows of pixels with `channels` channels; `height` is the index of the channel with the heights.
    void write_rows(std::span<const float> rows, std::size_t channels, std::size_t height);
    void commit();

  private:
    void write_heights();
    void write_scale();
    bool is_missing(float height) const;

    image::Rect region_;
    HeightFormat format_;
    std::optional<image::OutputFile> scale_;
    std::optional<image::PngWriter> png_;
    std::optional<image::OutputFile> raw_;
    std::optional<image::TiffWriter> tiff_;
    std::optional<image::ExrWriter> exr_;
    bool floats_ = false;        ///< of raw_
    image::File waiting_;        ///< all heights, until their range is known
    Elevation found_;            ///< the range of the heights so far
    std::vector<float> heights_; ///< to write
    std::vector<std::byte> bytes_;
};

/// Writes masks of an eroded map to a folder: a 16-bit PNG of each, masks.exr with the height and all of
/// them, and masks.json with the size, the extent, the height of pixels that have none, and the values that 0
/// and 65535 stand for in each PNG. The masks are ridge and crease, the slope in degrees, the erosion, and
/// the shares of grass, scree, rock and snow.
class MaskWriter {
  public:
    /// `header` describes the EXR, except for its channels; `pixel` has the sides of a pixel in the unit of
    /// heights, `missing` is the height of pixels that have none, and `reach` the most that erosion changes a
    /// height. Creates the folder; throws RequestError if it cannot.
    MaskWriter(const std::filesystem::path& folder, image::ExrHeader header,
               const std::array<double, 2>& pixel, std::optional<float> missing, double reach);

    /// Writes rows of pixels with all of passes::erosion_channels.
    void write_rows(std::span<const float> rows);
    void commit();

  private:
    struct Mask {
        double low; // the values that 0 and 65535 stand for
        double high;
        image::PngWriter png;
    };

    image::OutputFolder folder_;
    image::OutputFile scale_;
    std::vector<Mask> masks_;
    std::optional<image::ExrWriter> exr_;
};

} // namespace gabor::render
