#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::image {

/// A rectangle of pixels. x grows to the right, y downwards, as in the file.
struct Window {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// The names that `ExrWriter::Description::compression` may have, in the order in which help texts list them.
std::span<const std::string_view> compression_names();

/// Writes 32-bit float scanlines from top to bottom. The file appears under its name at `commit`; a writer
/// destroyed before that leaves nothing behind and an older file of that name untouched.
class ExrWriter {
  public:
    struct Description {
        Window picture;                    ///< EXR's display window: the whole picture
        Window window;                     ///< EXR's data window: the part of it in this file
        std::vector<std::string> channels; ///< one float channel each
        std::string_view compression = "none";
        std::string parameters;    ///< stored as the string attribute `gabor`
        std::string software = {}; ///< likewise as `software`, if there is any: what made the pixels
    };

    /// Throws RequestError for an unknown compression or a path that cannot be created.
    ExrWriter(const std::filesystem::path& path, const Description& description);
    ~ExrWriter();
    ExrWriter(ExrWriter&&) noexcept;

    /// Appends whole rows; `pixels` interleaves the channels and holds rows * width * channels values.
    /// Throws std::runtime_error when the disk fails.
    void write_rows(std::span<const float> pixels);

    /// Publishes the file under its name. Every row must have been written. Throws std::runtime_error when
    /// the disk fails.
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Writes a texture as renderers want it: tiles of 64 x 64 pixels, and after the picture itself every level
/// down to a single pixel, each with half the sides of the one before, rounded down. Its attributes are those
/// that OpenImageIO's maketx gives a texture. The file appears at `commit`, as ExrWriter's does.
class ExrTextureWriter {
  public:
    struct Description {
        int width = 0;
        int height = 0;
        std::vector<std::string> channels;
        bool half = false;     ///< 16-bit floats, else 32-bit ones
        bool periodic = false; ///< repeats, else is black beyond its edges
        std::string_view compression = "none";
        std::string parameters; ///< as those of ExrWriter
        std::string software;
    };

    /// Throws RequestError as ExrWriter does.
    ExrTextureWriter(const std::filesystem::path& path, const Description& description);
    ~ExrTextureWriter();
    ExrTextureWriter(ExrTextureWriter&&) noexcept;

    /// Appends whole rows of the level that is next to be complete. Throws std::runtime_error when the disk
    /// fails.
    void write_rows(std::span<const float> pixels);

    /// Publishes the file. All levels must have been written. Throws std::runtime_error when the disk fails.
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Puts the regions that ExrWriter wrote of one picture together, into the file that it would have written of
/// the whole at once. Regions as wide as the picture, whose compressed blocks are also those of the whole,
/// are copied as they are; others are decoded, a few rows at a time. `advance` is called with the number of
/// pixels that were written; what it throws ends everything, and leaves no file. Returns the picture. Throws
/// RequestError where a file is no such region, differs from the others in anything but its place, or where
/// they overlap or leave a gap.
Window join_exr(std::span<const std::filesystem::path> regions, const std::filesystem::path& output,
                const std::function<void(std::uint64_t)>& advance);

/// Reads one channel or more of a flat EXR, scanline or tiled, band by band, half or float, as float; or of a
/// picture that is in several files.
class ExrReader {
  public:
    /// Without a channel name: `Y`, else `R`, else the first float or half channel.
    /// Throws RequestError when the file is missing, truncated, not an EXR, has no such channel, or is larger
    /// than 65536 x 65536 pixels.
    explicit ExrReader(const std::filesystem::path& path, const std::optional<std::string>& channel = {});
    /// A picture of regions as join_exr takes them, in any order, or a single file with all that it holds.
    explicit ExrReader(std::span<const std::filesystem::path> paths,
                       const std::optional<std::string>& channel = {});
    /// Several channels, which `read_rows` interleaves, of regions that cover their picture.
    ExrReader(std::span<const std::filesystem::path> paths, const std::vector<std::string>& channels);
    ~ExrReader();
    ExrReader(ExrReader&&) noexcept;

    const Window& picture() const;
    const Window& window() const;
    const std::string& channel() const;
    /// Whether the file has one of that name too.
    bool has_channel(const std::string& name) const;
    /// The `gabor` attribute, empty where the file has none.
    const std::string& parameters() const;
    /// The `software` attribute, likewise.
    const std::string& software() const;
    /// As ExrWriter's description has it; empty for one that it does not take.
    std::string_view compression() const;

    /// The next rows, at most `rows` and `window().height` in all, top to bottom; empty after the last.
    /// The span stays valid until the next call. Throws RequestError when the data is damaged.
    std::span<const float> read_rows(int rows);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace gabor::image
