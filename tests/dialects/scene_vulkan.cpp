// Runs a compute shader that fills 256 x 257 floats on the device that VK_ICD_FILENAMES selects, prints the
// device's name and writes the floats to a file: scene_vulkan SHADER.spv VALUES.raw

#include "vulkan/device.hpp"
#include "vulkan/pass.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>

int main(int, char** argv) {
    using namespace gabor::vulkan;
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::uint32_t> spirv(bytes.size() / sizeof(std::uint32_t));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(spirv.data()));

    const Device device;
    const Pass pass(device, spirv, {});
    const Buffer values(device, 256 * 257 * sizeof(float), Memory::readback);
    Job job(device, pass, {values});
    const Job::Dispatch dispatch{{}, {.x = 256 / 8, .y = 257}};
    job.submit(std::span(&dispatch, 1));
    job.wait();

    std::cout << device.info().name << '\n';
    std::ofstream(argv[2], std::ios::binary)
        .write(values.as<const char>().data(), static_cast<std::streamsize>(values.size()));
    return validation_messages() == 0 ? 0 : 1;
}
