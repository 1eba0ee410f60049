#pragma once

#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"
#include "statistics/stationarity.hpp"
#include "study/noise.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::study {

// Each function measures the sum of several noises with different seeds, all derived from `seed`.

/// Returns a sum with only one term.
inline std::span<Noise> single(Noise& noise) {
    return {&noise, 1};
}

/// The statistics of a set of values.
struct ValueStatistics {
    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
};

/// Measures one value at a random position in each of `samples` independent instances.
ValueStatistics measure_values(std::span<Noise> sum, std::uint64_t samples, std::uint32_t seed);

/// Measures windows of 16 x 16 pixels, one kernel diameter wide, each from a different instance.
statistics::InstanceStationarity measure_windows(std::span<Noise> sum, std::uint64_t windows,
                                                 std::uint32_t seed);

/// Statistics at 8 x 8 positions in a cell, over many instances.
struct PlaceStatistics {
    statistics::ProcessStationarity stationarity;
    std::vector<statistics::Estimate> cvm; ///< Cramér-von Mises index at each position

    /// The mean index over all positions. Its interval is the mean of the positions' intervals, which is
    /// wider than necessary.
    statistics::Estimate mean_cvm() const;
};
/// Measures values at positions in a cell, whose side is `cell` kernel radii.
PlaceStatistics measure_places(std::span<Noise> sum, double cell, std::uint64_t instances,
                               std::uint32_t seed);

/// Returns the mean of each instance over 64 x 64 pixels, on a square of `side` kernel radii that starts at a
/// cell's corner.
std::vector<double> measure_means(std::span<Noise> sum, double side, std::uint64_t instances,
                                  std::uint32_t seed);

/// Returns the device time of each noise, in seconds, for a picture of 2^bits x 2^bits pixels, 32 to a kernel
/// radius: the medians of `timings` interleaved rounds, so that other load affects all noises alike.
std::vector<double> picture_seconds(std::span<Noise> noises, int bits, int timings);

/// Returns the pixels of a picture of 2^bits x 2^bits pixels, row by row, with `scale` pixels per kernel
/// radius.
std::vector<float> picture(Noise& noise, int bits, std::uint32_t seed, double scale = 32);

} // namespace gabor::study
