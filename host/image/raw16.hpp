#pragma once

#include "image/output_file.hpp"
#include "image/picture.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace gabor::image {

/// Opens a .r16 file: heights of 16 bits, the low byte first, row by row from the top and without a header.
/// Returns 0 to 1. Throws RequestError unless it holds exactly width x height of them.
std::unique_ptr<PictureReader> open_raw16(const std::filesystem::path& path, int width, int height);

/// Writes such a file. Like ExrWriter, it shows nothing under the name before `commit`.
class Raw16Writer {
  public:
    /// Throws RequestError for a path that cannot be created.
    explicit Raw16Writer(const std::filesystem::path& path) : file_(path) {}

    /// Appends values in [0, 1], clamped outside; NaN is written as 0. Throws std::runtime_error when the
    /// disk fails.
    void write_rows(std::span<const float> values);
    /// Publishes the file. Throws std::runtime_error when the disk fails.
    void commit() { file_.commit(); }

  private:
    OutputFile file_;
    std::vector<std::byte> bytes_;
};

} // namespace gabor::image
