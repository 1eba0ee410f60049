#pragma once

#include "image/exr.hpp"

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace gabor::image {

/// Converts an Imath box.
inline Rect to_rect(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

/// Throws RequestError, "cannot join: WHAT".
[[noreturn]] void refuse_join(std::string_view what);

/// A picture in one file, or in several files that hold its regions.
class ExrMosaic {
  public:
    /// Opens a single file. Throws RequestError if it cannot be read.
    explicit ExrMosaic(const std::filesystem::path& path);
    /// Opens regions of one picture, written by ExrWriter, in any order. Throws RequestError if a file is not
    /// such a region, if regions differ in more than their position, or if they overlap or leave a gap.
    explicit ExrMosaic(std::span<const std::filesystem::path> paths);

    /// One file and its data window.
    struct Region {
        std::filesystem::path path;
        Imath::Box2i window;
        int threads; ///< threads that may decode it
    };

    /// Returns the regions sorted by their upper left corners.
    const std::vector<Region>& regions() const { return regions_; }
    /// Returns the header that the whole picture would have in one file.
    const Imf::Header& header() const { return header_; }

    /// Reads rows `first` to `last` into `frame`. Rows must be read in order. Throws RequestError if a file
    /// is damaged.
    void read(const Imf::FrameBuffer& frame, int first, int last);

  private:
    // A region being read.
    struct Open {
        const Region* region;
        std::unique_ptr<Imf::InputFile> file;
    };

    std::vector<Region> regions_;
    Imf::Header header_;
    std::size_t opened_ = 0; ///< number of regions opened so far
    std::vector<Open> open_;
};

} // namespace gabor::image
