#pragma once

#include "image/exr.hpp"
#include "image/output_file.hpp"
#include "image/png.hpp"
#include "image/raw16.hpp"
#include "render/erosion.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::cli {

/// Gullies as options state them: a preset, and its members that are set one by one.
struct GullyOptions {
    std::string preset = "alps";
    std::vector<std::optional<double>> members; ///< of render::Erosion, in the order of its table

    void add_to(CLI::App& command);
    /// The gullies where hills are `hill` wide. Throws RequestError for an unknown preset or a number out of
    /// range.
    render::Erosion erosion(double hill) const;
};

inline constexpr double preset_hill = 4; ///< the width of the hills that presets are for

/// Whether a file's name ends so, in small or capital letters.
bool has_extension(const std::filesystem::path& path, std::string_view extension);

/// Heights that 0 and 65535 stand for in files of 16 bits.
struct Elevation {
    double low;
    double high;
};

/// Throws RequestError unless `region` has no numbers, for all of it, or X, Y, WIDTH and HEIGHT within the
/// picture.
image::Rect region_within(const std::vector<int>& region, int width, int height);

/// A heightmap of 16 bits, PNG or .r16, with a file beside it that says what its numbers mean.
class HeightWriter {
  public:
    HeightWriter(const std::filesystem::path& path, const image::Rect& region, Elevation elevation,
                 double pixel);

    /// Takes rows with the channels of render::erosion_channels.
    void write_rows(std::span<const float> eroded);
    void commit();

  private:
    Elevation elevation_;
    image::OutputFile scale_;
    std::optional<image::PngWriter> png_;
    std::optional<image::Raw16Writer> raw_;
    std::vector<float> levels_;
};

} // namespace gabor::cli
