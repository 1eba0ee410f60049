// Runs compute shaders on the device that VK_ICD_FILENAMES selects, and prints the device's name. Each fills
// pictures of 256 floats by a number of rows: scene_vulkan ROWS PICTURES SHADER.spv VALUES.raw ...

#include "vulkan/device.hpp"
#include "vulkan/pass.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>

int main(int, char** argv) {
    using namespace gabor::vulkan;
    const Device device;
    const auto rows = static_cast<std::uint32_t>(std::stoul(*++argv));
    const Buffer values(device, std::stoul(*++argv) * rows * 256 * sizeof(float), Memory::readback);
    while (*++argv != nullptr) {
        std::ifstream file(*argv, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
        std::vector<std::uint32_t> spirv(bytes.size() / sizeof(std::uint32_t));
        std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(spirv.data()));

        const Pass pass(device, spirv, {});
        Job job(device, pass, {values});
        const Job::Dispatch dispatch{{}, {.x = 256 / 8, .y = rows}};
        job.submit(std::span(&dispatch, 1));
        job.wait();
        std::ofstream(*++argv, std::ios::binary)
            .write(values.as<const char>().data(), static_cast<std::streamsize>(values.size()));
    }
    std::cout << device.info().name << '\n';
    return validation_messages() == 0 ? 0 : 1;
}
