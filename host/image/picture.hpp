#pragma once

#include <filesystem>
#include <memory>
#include <span>

namespace gabor::image {

/// A picture of one channel or three that is read row after row, so that memory does not grow with its
/// height.
class PictureReader {
  public:
    struct Format {
        int width = 0;
        int height = 0;
        int channels = 0;   ///< 1, or 3 for red, green, blue
        bool alpha = false; ///< whether there is an alpha channel too, which is not read
    };

    virtual ~PictureReader() = default;
    const Format& format() const { return format_; }

    /// The next row from the top, the channels of each pixel side by side: from 0 to 1 of PNG (8 and 16 bits)
    /// and JPEG, of EXR as they are. Throws RequestError, naming the file, where it is damaged or ends too
    /// early.
    virtual void read_row(std::span<float> row) = 0;

  protected:
    Format format_;
};

/// Opens a PNG, JPEG or OpenEXR file, whatever its name. Throws RequestError where it is none, where its
/// colours are other than grey or RGB, and where it cannot be read.
std::unique_ptr<PictureReader> open_picture(const std::filesystem::path& path);

/// The same of a file of that kind.
std::unique_ptr<PictureReader> open_png(const std::filesystem::path& path);
std::unique_ptr<PictureReader> open_jpeg(const std::filesystem::path& path);

} // namespace gabor::image
