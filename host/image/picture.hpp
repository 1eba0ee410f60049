#pragma once

#include "image/georeference.hpp"

#include <bit>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::image {

/// A picture with one or three channels, read row by row so that memory does not grow with its height.
class PictureReader {
  public:
    struct Format {
        int width = 0;
        int height = 0;
        int channels = 0;    ///< 1, or 3 for red, green, blue
        bool alpha = false;  ///< whether the file also has alpha
        bool linear = false; ///< linear light instead of sRGB; true for an EXR unless it says otherwise
        int bits = 8;        ///< per value in the file; 32 for floats, and for integers that are heights
        int left = 0;        ///< of an EXR's data window
        int top = 0;
        double scale = 1; ///< of heights: height = offset + scale * value
        double offset = 0;
        std::optional<float> missing = {}; ///< value of pixels without a height, if the file states it
        GeoTags geo = {};                  ///< where a map lies
        int orientation = 1;               ///< EXIF's; always 1 in pictures from `open_picture`
        std::string profile = {};          ///< name of the ICC profile, unless its colours are sRGB's
    };

    virtual ~PictureReader() = default;
    const Format& format() const { return format_; }

    /// Reads the next row, with interleaved channels: values as in the file if `bits` is 32, else values from
    /// 0 to 1. Throws RequestError, naming the file, if it is damaged or truncated.
    virtual void read_row(std::span<float> row) = 0;

    /// The alpha of each pixel in the last row read; empty without an alpha channel.
    std::span<const float> alpha() const { return alpha_; }

  protected:
    void set_format(const Format& format) {
        format_ = format;
        alpha_.resize(format.alpha ? static_cast<std::size_t>(format.width) : 0);
    }

    /// Fills a row with values from `next`, which returns each pixel's channels and then its alpha, if any.
    template <typename Next>
    void fill(std::span<float> row, Next next) {
        const auto channels = static_cast<std::size_t>(format_.channels);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = next();
            if (!alpha_.empty() && (i + 1) % channels == 0)
                alpha_[i / channels] = next();
        }
    }

  private:
    Format format_;
    std::vector<float> alpha_;
};

/// Opens a PNG, JPEG, TGA, TIFF or OpenEXR file, a numpy array, or a map in ESRI's text format; the content,
/// not the name, decides the format. EXIF data in a PNG or JPEG turn and mirror the picture. If an EXR has a
/// channel named `channel`, reads only that. Throws RequestError for other formats, with `hint` at the end of
/// the message, for colours other than grey or RGB, and for unreadable files.
std::unique_ptr<PictureReader> open_picture(const std::filesystem::path& path,
                                            const std::string& channel = {}, std::string_view hint = {});

/// Throws RequestError with the message "cannot read 'PATH': REASON".
[[noreturn]] void refuse_picture(const std::filesystem::path& path, std::string_view reason);

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Opens a regular file. Throws RequestError for anything else: opening a FIFO would block.
File open_file(const std::filesystem::path& path);

/// Each of these reads a file of its format, as it is stored. `path` names it in messages.
std::unique_ptr<PictureReader> open_png(const std::filesystem::path& path, File file);
std::unique_ptr<PictureReader> open_jpeg(const std::filesystem::path& path, File file);
/// The same for a JPEG in memory, which must outlive the reader.
std::unique_ptr<PictureReader> open_jpeg(const std::filesystem::path& path,
                                         std::span<const unsigned char> memory);
/// Returns null if the file is not a TGA.
std::unique_ptr<PictureReader> open_tga(const std::filesystem::path& path, File file);
/// Reads a TIFF's first picture: grey or RGB, with or without alpha, of integers or floats. Floats, signed
/// integers, those of 32 bits, and all of a GeoTIFF are heights or linear light; the reader returns others as
/// values from 0 to 1.
std::unique_ptr<PictureReader> open_tiff(const std::filesystem::path& path);
/// Reads heights from ESRI's text format.
std::unique_ptr<PictureReader> open_asc(const std::filesystem::path& path, File file);
/// Reads a numpy array of two dimensions, whose values are heights.
std::unique_ptr<PictureReader> open_npy(const std::filesystem::path& path, File file);

/// Reads heights in red, green and blue: `terrarium`, or Mapbox's Terrain-RGB. Transparent pixels have none.
std::unique_ptr<PictureReader> open_encoded(const std::filesystem::path& path, bool terrarium);
/// Opens a file of heights without a header, row by row from the top. The heights are 16-bit integers, which
/// the reader returns as values from 0 to 1, or floats if the file is twice as long. Throws RequestError for
/// any other length.
std::unique_ptr<PictureReader> open_raw(const std::filesystem::path& path, int width, int height,
                                        std::endian order);
/// Returns the order in which such a file's neighbours differ less: big if by far, else little.
std::endian byte_order_of(const std::filesystem::path& path, int width, int height);
/// Reads heights as SRTM stores them: 16-bit integers, high byte first, without a header. The file's name has
/// its longitude and latitude, and it is a square unless `size` says otherwise.
std::unique_ptr<PictureReader> open_hgt(const std::filesystem::path& path,
                                        std::optional<std::array<int, 2>> size);

} // namespace gabor::image
