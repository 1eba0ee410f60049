#pragma once

#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"
#include "viewer/extent.hpp"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace gabor::viewer {

/// The power spectrum of the picture in the window: `side` x `side` cells of `step` x `step` cycles per
/// kernel radius, frequency 0 at the corner where the four middle ones meet.
struct MeasuredSpectrum {
    int side = 0;
    double step = 0;
    std::vector<float> decibels; ///< row by row, relative to the strongest
};

constexpr int histogram_bars = 64;
constexpr double histogram_end = 4; ///< standard deviations

/// What is known of one noise so far.
struct Measurements {
    statistics::Moments moments; ///< of values at random points of independent instances
    statistics::Estimate cvm;    ///< of the same
    std::array<std::uint64_t, histogram_bars> histogram{};
    std::optional<MeasuredSpectrum> spectrum;
};

/// Measures on a thread of its own what the window shows.
class MeasuringThread {
  public:
    MeasuringThread();
    ~MeasuringThread();

    /// Forgets what is known but for the spectrum, and what is still in the queue.
    void reset();
    /// `coverage`: the channel that tells with 0 which values are none; -1 where all are.
    void add_samples(std::span<const float> values, int channels, int coverage);
    /// The pixels of a flat picture. `scale`: pixels per kernel radius.
    void add_picture(std::span<const float> values, int channels, Extent extent, double scale);

    Measurements measured() const;
    bool idle() const;

  private:
    struct Task {
        std::uint64_t generation;
        std::vector<float> values;
        Extent extent; ///< of a picture; 0 x 0 for samples
        double scale = 1;
    };

    void post(Task task);
    void work();
    void measure(const Task& task);

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Task> tasks_;
    bool busy_ = false;
    bool ending_ = false;
    std::uint64_t generation_ = 0; ///< how often it was reset
    Measurements measured_;
    statistics::Gaussianity gaussianity_;
    std::thread thread_;
};

} // namespace gabor::viewer
