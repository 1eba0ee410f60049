#pragma once

#include "image/georeference.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace gabor::image {

/// Writes a GeoTIFF of 32-bit floats in one channel, from top to bottom. As with ExrWriter, the file appears
/// under its name at `commit`.
class TiffWriter {
  public:
    /// `missing` is the value of pixels without a height; `compressed` chooses Deflate with differences.
    /// Throws RequestError for a path that cannot be created.
    TiffWriter(const std::filesystem::path& path, int width, int height, const GeoTags& geo,
               std::optional<float> missing, bool compressed);
    ~TiffWriter();
    TiffWriter(TiffWriter&&) noexcept;

    /// Appends whole rows. Throws std::runtime_error if writing fails.
    void write_rows(std::span<const float> values);
    /// Publishes the file after the last row. Throws std::runtime_error if writing fails.
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace gabor::image
