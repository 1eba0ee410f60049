#pragma once

#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "image/png.hpp"

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

/// The heights of a map, and its width in the same unit.
struct MapScale {
    Elevation elevation;
    double extent;
};

/// What HeightWriter wrote beside this heightmap, if anything.
std::optional<MapScale> scale_beside(const std::filesystem::path& map);

/// Writes a 16-bit heightmap as PNG or .r16, and beside it a JSON file with its size and range of heights.
class HeightWriter {
  public:
    /// `pixel` is the width of a pixel in the unit of heights. Throws RequestError unless the name ends in
    /// .png or .r16.
    HeightWriter(const std::filesystem::path& path, const image::Rect& region, Elevation elevation,
                 double pixel);

    /// Writes rows of pixels with `channels` channels; `height` is the index of the channel with the heights.
    void write_rows(std::span<const float> rows, std::size_t channels, std::size_t height);
    void commit();

  private:
    Elevation elevation_;
    image::OutputFile scale_;
    std::optional<image::PngWriter> png_;
    std::optional<image::OutputFile> raw_;
    std::vector<float> levels_;
    std::vector<std::byte> bytes_;
};

/// Writes masks of an eroded map to a folder: a 16-bit PNG of each, masks.exr with all of them, and
/// masks.json with the size, the extent, and the values that 0 and 65535 stand for in each PNG. The masks are
/// ridge and crease, the slope in degrees, the erosion, and the shares of grass, scree, rock and snow.
class MaskWriter {
  public:
    /// `header` describes the EXR, except for its channels; `pixel` is the width of a pixel in the unit of
    /// heights, and `reach` the most that erosion changes a height. Creates the folder; throws RequestError
    /// if it cannot.
    MaskWriter(const std::filesystem::path& folder, image::ExrHeader header, double pixel, double reach);

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
