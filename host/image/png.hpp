#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace gabor::image {

/// Converts a value, clamped to [0, 1], to an integer of `bits` bits; NaN becomes 0.
std::uint32_t quantize(float value, int bits);

/// Writes an 8-bit or 16-bit PNG from top to bottom, grey for one channel and RGB for three. As with
/// ExrWriter, the file appears under its name at `commit`.
class PngWriter {
  public:
    /// Accepts up to 65536 pixels per side. Throws RequestError for a path that cannot be created.
    PngWriter(const std::filesystem::path& path, int width, int height, int channels, int bits = 8);
    ~PngWriter();
    PngWriter(PngWriter&&) noexcept;

    /// Appends whole rows of values, clamped to [0, 1]; NaN is written as 0. Throws std::runtime_error if
    /// writing fails.
    void write_rows(std::span<const float> values);
    /// Publishes the file after the last row. Throws std::runtime_error if writing fails.
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace gabor::image
