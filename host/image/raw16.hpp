#pragma once

#include "image/output_file.hpp"
#include "image/picture.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace gabor::image {

/// Opens a .r16 file: 16-bit heights, low byte first, row by row from the top, without a header. The reader
/// returns values from 0 to 1. Throws RequestError unless the file has exactly width x height heights.
std::unique_ptr<PictureReader> open_raw16(const std::filesystem::path& path, int width, int height);

/// Writes a .r16 file. Like ExrWriter, it shows no file under that name before `commit`.
class Raw16Writer {
  public:
    /// Throws RequestError for a path that cannot be created.
    explicit Raw16Writer(const std::filesystem::path& path) : file_(path) {}

    /// Appends values, clamped to [0, 1]; NaN is written as 0. Throws std::runtime_error when the disk fails.
    void write_rows(std::span<const float> values);
    /// Publishes the file. Throws std::runtime_error when the disk fails.
    void commit() { file_.commit(); }

  private:
    OutputFile file_;
    std::vector<std::byte> bytes_;
};

} // namespace gabor::image
