#pragma once

#include "vulkan/device.hpp"

#include <string>
#include <vector>

namespace gabor::bench {

/// What a device's compiler makes of a pipeline, from VK_KHR_pipeline_executable_properties.
struct Code {
    std::string name;
    double instructions = 0; ///< per pixel
    double throughput = 0;   ///< estimated inverse throughput, cycles per pixel
    int registers = 0;       ///< vector registers of an invocation
};

/// The code of everything that the benchmark times, but for the seminal noise, whose loops end at random. It
/// is compiled and never run, so the device need not exist: RADV's null device gives the same figures on
/// every machine. A bake's loop over rows is counted as often as it runs in a full block. Throws RequestError
/// on a device that does not tell.
std::vector<Code> measure_code(const vulkan::Device& device);

} // namespace gabor::bench
