#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gabor::statistics {

/// Overlapping squares of a picture under a Hann window, for Welch's method (Welch, 1967). The picture is
/// read row by row; only as many rows as a segment has are kept in memory.
class Segments {
  public:
    /// Segments are at most `hop` pixels apart, but there are at most 64 along each axis. They are spread
    /// evenly from the first pixel to the last, including both. The picture must have at least `side` pixels
    /// along each axis.
    Segments(int width, int height, int channels, int side, int hop);

    /// Adds the next row, with interleaved channels. Returns the leftmost column of each segment that ends
    /// with this row.
    std::span<const int> add_row(std::span<const float> row);

    /// Writes one channel of a segment that add_row returned, multiplied by the window, with rows `stride`
    /// values apart.
    void copy_windowed(int left, int channel, std::span<float> into, int stride) const;

    int side() const { return side_; }
    /// Returns where segments begin along each axis.
    const std::vector<int>& columns() const { return columns_; }
    const std::vector<int>& lines() const { return lines_; }
    /// Returns the number of complete segments.
    std::size_t count() const { return columns_.size() * band_; }
    /// The sum of the squared window along one axis; the window is a product of two factors, one per axis.
    double window_power() const;

  private:
    int width_;
    int channels_;
    int side_;
    std::vector<int> columns_; ///< where segments begin
    std::vector<int> lines_;
    std::vector<float> window_;
    std::vector<float> rows_; ///< row y of the picture is at y % side
    int row_ = 0;
    std::size_t band_ = 0; ///< number of complete bands of segments
};

} // namespace gabor::statistics
