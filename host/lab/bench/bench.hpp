#pragma once

#include "statistics/gaussianity.hpp"
#include "vulkan/device.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gabor::bench {

/// Quartiles of repeated timings, in seconds.
struct Quartiles {
    double median = 0;
    double lower = 0;
    double upper = 0;
};

/// One timed noise.
struct Row {
    std::string name;
    double visited = 0; ///< impulses visited per pixel; 0 if there are none
    int side = 0;       ///< side of the square picture, in pixels; for a noise, the square root of its values
    double scale = 0;   ///< pixels per kernel radius
    double frequency = 0;
    Quartiles seconds;   ///< time for the whole picture: a GPU's clock, or the CPU time of each core
    double pipeline = 0; ///< seconds to create the pipeline, the first time in this process
    std::optional<statistics::Estimate> cvm; ///< cvm of the noise; absent if not measured

    double nanoseconds_per_pixel() const { return seconds.median * 1e9 / side / side; }
};

struct Report {
    std::vector<Row> base;   ///< everything at one size, scale and frequency
    std::vector<Row> trends; ///< the first recipe at other sizes, scales and frequencies
};

struct Effort {
    int repetitions = 21;
    int side = 1024;
    int sample_batches = 16; ///< batches of 2^20 samples for each cvm
};

/// Times all noises in one process, interleaved, after a warm-up. Calls `step` after each measurement;
/// `step` may throw to abort. Throws RequestError on a device without timestamps.
Report run(const vulkan::Device& device, const Effort& effort, const std::function<void()>& step);

/// Returns how many times `run` calls `step`.
int steps(const Effort& effort);

/// The compiler's statistics for a pipeline, from VK_KHR_pipeline_executable_properties.
struct Code {
    std::string name;
    double instructions = 0; ///< instructions per pixel
    double throughput = 0;   ///< estimated inverse throughput, cycles per pixel
    int registers = 0;       ///< vector registers per invocation
    double seconds = 0;      ///< CPU time that the driver takes to compile it
};

/// Returns statistics for everything that the benchmark times, except the seminal noise, whose loops have
/// random lengths. The code is compiled but never run, so RADV's null device gives the same figures on every
/// machine. A bake's loop over rows counts as many times as it runs in a full block. Throws RequestError on a
/// device without VK_KHR_pipeline_executable_properties.
std::vector<Code> measure_code(const vulkan::Device& device);

/// Returns statistics for compute shaders in SPIR-V files that write one storage buffer.
std::vector<Code> measure_code(const vulkan::Device& device, const std::vector<std::string>& files);

} // namespace gabor::bench
