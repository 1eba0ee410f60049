#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gabor::statistics {

/// Overlapping squares of a picture that passes by row after row, seen under a Hann window: what Welch's
/// method averages over (Welch, 1967). Holds as many rows as a segment has.
class Segments {
  public:
    /// At most `hop` pixels apart, or 64 along each axis of a larger picture, and spread evenly from the
    /// first pixel to the last, so that no border is left out. At least `side` pixels each way.
    Segments(int width, int height, int channels, int side, int hop);

    /// The next row, the channels of each pixel side by side. Returns the first columns of the segments that
    /// end with it.
    std::span<const int> add_row(std::span<const float> row);

    /// One channel of such a segment under the window, its rows `stride` values apart.
    void weigh(int left, int channel, std::span<float> into, int stride) const;

    int side() const { return side_; }
    /// Where segments begin along each axis.
    const std::vector<int>& columns() const { return columns_; }
    const std::vector<int>& lines() const { return lines_; }
    /// Of the segments that are complete.
    std::size_t count() const { return columns_.size() * band_; }
    /// The sum of the window's squares along one axis; the window is a product of two.
    double window_power() const;

  private:
    int width_;
    int channels_;
    int side_;
    std::vector<int> columns_; ///< where segments begin
    std::vector<int> lines_;
    std::vector<float> window_;
    std::vector<float> rows_; ///< row y of the picture in place y % side
    int row_ = 0;
    std::size_t band_ = 0; ///< bands of segments that are complete
};

} // namespace gabor::statistics
