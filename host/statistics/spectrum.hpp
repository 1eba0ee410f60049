#pragma once

#include "statistics/lobe.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gabor::statistics {

/// The power spectrum of a picture that passes by row after row, as an average over overlapping square
/// segments under a Hann window (Welch, 1967), at least half overlapping unless the picture is so large that
/// 64 x 64 segments are enough. Holds as many rows as a segment has, at most 128 MiB.
class Spectrum {
  public:
    /// Throws std::invalid_argument for pictures without a `segment_side`.
    Spectrum(int width, int height);
    ~Spectrum();
    Spectrum(Spectrum&&) noexcept;

    /// The next row, `width` values. The mean should have been subtracted: it would be power at frequency 0.
    void add_row(std::span<const float> row);

    /// The averaged periodogram, in the order that `summarize` takes. Call after the last row.
    std::vector<double> periodogram() const;

    /// The side of the segments, in pixels.
    int side() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The side of the segments for a picture: a power of 2, at most 512 and half the shorter side. Nothing for
/// pictures of less than 16 x 16 pixels.
std::optional<int> segment_side(int width, int height);

} // namespace gabor::statistics
