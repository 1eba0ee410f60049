// Replaces host/vulkan to simulate a machine without Vulkan, so that requests stop where they need a device.

#include "error.hpp"
#include "vulkan/buffer.hpp"

#include <stdexcept>

namespace gabor::vulkan {

namespace {

[[noreturn]] void refuse() {
    throw RequestError("there is no device here");
}

} // namespace

struct Device::State {};
struct Buffer::State {};

std::vector<DeviceInfo> devices() {
    refuse();
}

int validation_messages() {
    return 0;
}

bool out_of_memory(const std::error_code&) {
    return false;
}

Device::Device(const std::string&, const Presentation&) {
    refuse();
}
Device::~Device() = default;
Device::Device(Device&&) noexcept = default;

const DeviceInfo& Device::info() const {
    refuse();
}

bool Device::unified() const {
    refuse();
}

Buffer::Buffer(const Device&, std::size_t, Memory) {
    refuse();
}
Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;

std::size_t Buffer::size() const {
    refuse();
}

std::span<std::byte> Buffer::mapped() const {
    refuse();
}

} // namespace gabor::vulkan
