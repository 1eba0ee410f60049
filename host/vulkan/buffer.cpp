#include "vulkan/state.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gabor::vulkan {

namespace {

// Each buffer has its own allocation, of at least this many bytes: a process has only a few large buffers.
constexpr vk::DeviceSize least_memory = 1 << 20;

} // namespace

std::uint32_t memory_type(const Device::State& device, std::uint32_t allowed,
                          vk::MemoryPropertyFlags required, vk::MemoryPropertyFlags preferred) {
    const vk::PhysicalDeviceMemoryProperties properties = device.physical.getMemoryProperties();
    for (const vk::MemoryPropertyFlags wanted : {required | preferred, required})
        for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i)
            if ((allowed >> i & 1) && (properties.memoryTypes[i].propertyFlags & wanted) == wanted)
                return i;
    throw std::runtime_error(fmt::format("{} has no suitable memory", device.info.name));
}

Buffer::Buffer(const Device& device, std::size_t bytes, Memory memory) : state_(std::make_unique<State>()) {
    using Flag = vk::MemoryPropertyFlagBits;
    using Usage = vk::BufferUsageFlagBits;
    const vk::raii::Device& logical = device.state().device;
    state_->bytes = bytes;
    state_->buffer = vk::raii::Buffer(
        logical, {{},
                  bytes,
                  Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eTransferSrc | Usage::eTransferDst});
    const vk::MemoryRequirements needs = state_->buffer.getMemoryRequirements();
    const bool host = memory != Memory::device;
    const vk::MemoryPropertyFlags preferred =
        memory == Memory::readback ? Flag::eHostCached | (device.unified() ? Flag::eDeviceLocal : Flag{})
                                   : vk::MemoryPropertyFlags(Flag::eDeviceLocal);
    const std::uint32_t type = memory_type(device.state(), needs.memoryTypeBits,
                                           host ? coherent : vk::MemoryPropertyFlags(), preferred);
    state_->memory = vk::raii::DeviceMemory(logical, {std::max(needs.size, least_memory), type});
    state_->buffer.bindMemory(*state_->memory, 0);
    if (host)
        state_->mapped = {static_cast<std::byte*>(state_->memory.mapMemory(0, VK_WHOLE_SIZE)), bytes};
}

Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;

std::size_t Buffer::size() const {
    return state_->bytes;
}

std::span<std::byte> Buffer::mapped() const {
    return state_->mapped;
}

} // namespace gabor::vulkan
