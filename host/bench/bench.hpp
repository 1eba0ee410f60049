#pragma once

#include "statistics/estimate.hpp"
#include "vulkan/device.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gabor::bench {

/// Seconds of one measurement, repeated: the median, and the quartiles as its spread.
struct Spread {
    double median = 0;
    double low = 0;
    double high = 0;
};

struct Row {
    std::string name;
    double visited = 0; ///< impulses visited for each pixel; 0 where there are none
    int side = 0;       ///< pixels of the square picture along a side
    double scale = 0;   ///< pixels per kernel radius
    double frequency = 0;
    Spread seconds;      ///< on the device's own clock, for the whole picture
    double pipeline = 0; ///< seconds to create the pipeline, the first time in this process
    std::optional<statistics::Estimate> cvm; ///< of its values; absent where it is no Gabor noise

    double nanoseconds_per_pixel() const { return seconds.median * 1e9 / side / side; }
};

struct Report {
    std::vector<Row> base;   ///< everything at one size, scale and frequency: what ratios are taken of
    std::vector<Row> trends; ///< what ours cost at other sizes, scales and frequencies
};

struct Effort {
    int repetitions = 21;
    int side = 1024;
    int sample_batches = 16; ///< of 2^20 samples for each law
};

/// Runs everything in one process, interleaved, after a warm-up. `step` is called after each measurement, for
/// progress and to be interrupted by throwing. Throws RequestError on a device that cannot tell times.
Report run(const vulkan::Device& device, const Effort& effort, const std::function<void()>& step);

/// How often `run` calls `step`.
int steps(const Effort& effort);

} // namespace gabor::bench
