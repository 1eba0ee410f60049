#pragma once

#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"
#include "study/noise.hpp"
#include "study/spread.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::study {

// Each measures the sum of several noises, with another seed each: `seed` decides everything.

/// One value at a random place of each of `samples` independent instances.
struct OneValue {
    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
};

/// `deviation`: the standard deviation to compare the law with.
OneValue measure_values(std::span<Noise> sum, std::uint64_t samples, std::uint32_t seed,
                        double deviation = 1);

/// The mean and the contrast of windows of one kernel diameter, each of another instance, 16 x 16 pixels
/// each. The contrast is the variance in the window [TNVT19, figure 4].
struct Windows {
    Spread contrast;
    double deviation = 0;   ///< median of the square root of the contrast
    double mean_median = 0; ///< of the windows' means
    double mean_range = 0;  ///< from the first to the last decile of the windows' means
};

Windows measure_windows(std::span<Noise> sum, std::uint64_t windows, std::uint32_t seed);

/// The variance and the mean at each of 8 x 8 places of a cell, over many instances [TNVT19, 3.2].
struct Places {
    Spread variance;
    double variance_chance = 0; ///< the interdecile that chance alone would give
    double largest_mean = 0;    ///< of their magnitudes
    double mean_chance = 0;     ///< what chance alone exceeds in one case of twenty
};

/// `cell`: its side in kernel radii.
Places measure_places(std::span<Noise> sum, double cell, std::uint64_t instances, std::uint32_t seed);

/// The mean of a whole instance, 64 x 64 pixels on a square of `side` kernel radii from a cell's corner, for
/// each of many instances.
std::vector<double> measure_means(std::span<Noise> sum, double side, std::uint64_t instances,
                                  std::uint32_t seed);

} // namespace gabor::study
