#pragma once

#include <algorithm>
#include <array>
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
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    std::uint64_t pixels() const {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    }
    bool operator==(const Rect&) const = default;
};

/// The accepted values of `ExrHeader::compression`: all lossless.
inline constexpr std::array<std::string_view, 5> exr_compressions{"none", "rle", "zips", "zip", "piz"};

/// The contents of an EXR's header.
struct ExrHeader {
    /// A mip-mapped texture in tiles of 64 x 64 pixels. Each level halves both sides of the previous one,
    /// rounded down, until a single pixel is left. The attributes match those of OpenImageIO's maketx.
    struct Texture {
        bool periodic = false; ///< whether the texture repeats; otherwise it is black beyond its edges
    };

    Rect picture;                      ///< EXR's display window: the whole picture
    Rect window;                       ///< EXR's data window: the part of the picture in this file
    std::vector<std::string> channels; ///< names of the channels, 32-bit floats
    std::string parameters = {};       ///< stored as the string attribute `gabor`
    std::string software = {};         ///< the program and driver; stored as `software` unless empty
    /// The colour space of R, G and B, stored as OpenImageIO's `oiio:ColorSpace` unless empty.
    std::string colour_space = {};
    std::string compression = "none"; ///< one of exr_compressions
    /// If set, writes a texture; the window must be the whole picture at 0, 0.
    std::optional<Texture> texture = {};
    std::vector<std::string> halves = {}; ///< the channels that are stored as 16-bit floats
    /// If set, the picture shows this many metres from left to right, and lengths among the channels are in
    /// metres: the attributes `gabor.width` and `gabor.unit`.
    std::optional<double> metres = {};
};

/// Writes a picture as scanlines, or a texture. The file appears under its name at `commit`;
/// destroying the writer earlier leaves nothing behind and keeps an existing file.
class ExrWriter {
  public:
    /// Throws RequestError for a path that cannot be created.
    ExrWriter(const std::filesystem::path& path, const ExrHeader& header);
    ~ExrWriter();
    ExrWriter(ExrWriter&&) noexcept;

    /// Appends whole rows from top to bottom; `pixels` interleaves the channels. The rows of a texture's
    /// level follow those of the previous level. Throws std::runtime_error if writing fails.
    void write_rows(std::span<const float> pixels);

    /// Publishes the file after the last row. Throws std::runtime_error if writing fails.
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Receives the number of pixels finished since the last call. May throw to abort the work.
using Advance = std::function<void(std::uint64_t)>;

/// Reads half or float channels of a flat EXR, scanline or tiled, as floats, band by band. The picture may be
/// spread over several files.
class ExrReader {
  public:
    /// Reads `channels`, interleaved; if none are given, reads `Y`, else `R`, else the first float or half
    /// channel. Throws RequestError when the file is missing, truncated or not an EXR, lacks a channel, or is
    /// larger than 65536 x 65536 pixels.
    explicit ExrReader(const std::filesystem::path& path, const std::vector<std::string>& channels = {});
    /// Reads regions of one picture, written by ExrWriter, in any order; without `channels`, reads all
    /// channels. Throws RequestError if a file is not such a region, if regions differ in more than their
    /// position, or if they overlap or leave a gap.
    explicit ExrReader(std::span<const std::filesystem::path> paths,
                       const std::vector<std::string>& channels = {});
    ~ExrReader();
    ExrReader(ExrReader&&) noexcept;

    /// Returns the header that a single file with the whole picture would have. Its channels are those that
    /// are read, and `texture` is not set.
    const ExrHeader& header() const { return header_; }
    bool has_channel(const std::string& name) const;

    /// Returns the next `rows` rows, or as many as are left; empty after the last. The span is valid until
    /// the next call. Throws RequestError when the data is damaged.
    std::span<const float> read_rows(int rows);

    /// Passes all rows to `use`, in bands of about a million pixels.
    template <typename Use>
    void read_bands(Use use) {
        const int rows = std::max(1, (1 << 20) / header_.window.width);
        for (auto band = read_rows(rows); !band.empty(); band = read_rows(rows))
            use(band);
    }

  private:
    struct State;
    ExrHeader header_;
    std::unique_ptr<State> state_;
};

} // namespace gabor::image
