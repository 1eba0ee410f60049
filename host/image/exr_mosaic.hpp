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

/// In other words.
inline Window to_window(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

/// Throws RequestError, "cannot join: WHAT".
[[noreturn]] void refuse_join(std::string_view what);

/// A picture that is read from a file, or from several that hold regions of it.
class ExrMosaic {
  public:
    /// A file with all that it holds. Throws RequestError where it cannot be read.
    explicit ExrMosaic(const std::filesystem::path& path);
    /// Regions that ExrWriter wrote of one picture, in any order. Throws RequestError where a file is no such
    /// region, differs from the others in anything but its place, or where they overlap or leave a gap.
    explicit ExrMosaic(std::span<const std::filesystem::path> paths);

    /// A region, or a file by itself.
    struct Region {
        std::filesystem::path path;
        Imath::Box2i window;
        int threads; ///< that may decode it
    };

    /// In the order of their upper left corners.
    const std::vector<Region>& regions() const { return regions_; }
    /// Of the whole picture, as if it were in one file.
    const Imf::Header& header() const { return header_; }

    /// Reads rows into the slices of `frame`. Rows must follow those that were read before.
    /// Throws RequestError where a file is damaged.
    void read(const Imf::FrameBuffer& frame, int first, int last);

  private:
    // A region that is being read.
    struct Open {
        const Region* region;
        std::unique_ptr<Imf::InputFile> file;
    };

    std::vector<Region> regions_;
    Imf::Header header_;
    std::size_t opened_ = 0; ///< how many regions were
    std::vector<Open> open_;
};

} // namespace gabor::image
