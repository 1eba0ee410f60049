#pragma once

#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"
#include "viewer/background.hpp"
#include "viewer/extent.hpp"

#include <array>
#include <cstdint>
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

constexpr int histogram_bars = 64;
constexpr double histogram_end = 4; ///< standard deviations

/// What has been measured of one noise so far.
struct Measurements {
    statistics::Moments moments; ///< of values at random points of independent instances
    statistics::Gaussianity gaussianity;
    statistics::Estimate cvm; ///< the index of `gaussianity`
    std::array<std::uint64_t, histogram_bars> histogram{};
    std::optional<MeasuredSpectrum> spectrum;
};

/// Measures in the background what the window shows.
class Measurer {
  public:
    /// Forgets everything but the spectrum, which stays in view until there is another.
    void reset();
    /// Adds the first channel of each pixel, except where the channel `coverage` is 0; -1 excepts none.
    /// Call this and the next only when idle.
    void add_samples(std::span<const float> values, int channels, int coverage);
    /// Replaces the spectrum by that of a flat picture. `scale`: pixels per kernel radius.
    void add_picture(std::span<const float> values, int channels, Extent extent, double scale);

    /// Collects the last result. Returns true when nothing is running.
    bool idle();
    const Measurements& measured() const { return measured_; }

  private:
    Measurements measured_;
    Measurements part_;    ///< belongs to the thread while it runs
    bool pending_ = false; ///< `part_` is not yet in `measured_`
    Background work_;
};

} // namespace gabor::viewer
