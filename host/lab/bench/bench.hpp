#pragma once

#include "statistics/estimate.hpp"
#include "vulkan/device.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gabor::bench {

/// Of the seconds of a measurement that was repeated.
struct Quartiles {
    double median = 0;
    double lower = 0;
    double upper = 0;
};

/// One thing that was timed.
struct Row {
    std::string name;
    double visited = 0; ///< impulses visited for each pixel; 0 where there are none
    int side = 0;       ///< pixels of the square picture along a side
    double scale = 0;   ///< pixels per kernel radius
    double frequency = 0;
    Quartiles seconds;   ///< on the device's own clock, for the whole picture
    double pipeline = 0; ///< seconds to create the pipeline, the first time in this process
    std::optional<statistics::Estimate> cvm; ///< of its values; absent where it is not measured

    double nanoseconds_per_pixel() const { return seconds.median * 1e9 / side / side; }
};

struct Report {
    std::vector<Row> base;   ///< everything at one size, scale and frequency
    std::vector<Row> trends; ///< what the first recipe costs at other sizes, scales and frequencies
};

struct Effort {
    int repetitions = 21;
    int side = 1024;
    int sample_batches = 16; ///< of 2^20 samples for each cvm
};

/// Runs everything in one process, interleaved, after a warm-up. `step` is called after each measurement, for
/// progress and to be interrupted by throwing. Throws RequestError on a device that cannot tell times.
Report run(const vulkan::Device& device, const Effort& effort, const std::function<void()>& step);

/// How often `run` calls `step`.
int steps(const Effort& effort);

/// What a device's compiler makes of a pipeline, from VK_KHR_pipeline_executable_properties.
struct Code {
    std::string name;
    double instructions = 0; ///< per pixel
    double throughput = 0;   ///< estimated inverse throughput, cycles per pixel
    int registers = 0;       ///< vector registers of an invocation
};

/// The code of everything that the benchmark times, except the seminal noise, whose loops end at random. It
/// is compiled and never run, so the device need not exist: RADV's null device gives the same figures on
/// every machine. A bake's loop over rows is counted as often as it runs in a full block. Throws RequestError
/// on a device without that extension.
std::vector<Code> measure_code(const vulkan::Device& device);

} // namespace gabor::bench
