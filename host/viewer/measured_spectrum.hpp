#pragma once

#include "viewer/background.hpp"
#include "viewer/extent.hpp"

#include <optional>
#include <span>
#include <vector>

namespace gabor::viewer {

/// The power spectrum of the picture in the window: `side` x `side` cells of `step` x `step` cycles per
/// kernel radius. Frequency 0 is in the middle, where four cells meet.
struct MeasuredSpectrum {
    int side = 0;
    double step = 0;
    std::vector<float> decibels; ///< row by row, relative to the strongest
};

/// Measures the spectrum in the background.
class SpectrumMeter {
  public:
    /// Measures the first channel of a flat picture's pixels. `scale`: pixels per kernel radius. Call only
    /// when idle.
    void start(std::span<const float> values, std::size_t channels, Extent extent, double scale);
    /// Collects the last result. Returns true when nothing is running.
    bool idle();
    /// The last result; none before the first.
    const std::optional<MeasuredSpectrum>& measured() const { return measured_; }

  private:
    std::optional<MeasuredSpectrum> measured_;
    std::optional<MeasuredSpectrum> next_; ///< belongs to the thread while it runs
    Background work_;
};

} // namespace gabor::viewer
