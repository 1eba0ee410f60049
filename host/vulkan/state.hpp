#pragma once

// The Vulkan objects behind the other headers, for this folder and for the viewer, which draws with them.

#include "vulkan/buffer.hpp"
#include "vulkan/device.hpp"
#include "vulkan/pass.hpp"

#include <vulkan/vulkan_raii.hpp>

namespace gabor::vulkan {

/// Required memory properties of buffers that the host reads or writes.
inline constexpr vk::MemoryPropertyFlags coherent =
    vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;

/// The members of Device, in order of creation.
struct Device::State {
    vk::raii::Context context;
    vk::raii::Instance instance;
    vk::raii::DebugUtilsMessengerEXT messenger;
    vk::raii::PhysicalDevice physical;
    DeviceInfo info;
    std::uint32_t family = 0;
    vk::raii::Device device;
    vk::raii::Queue queue;
    double timestamp_seconds = 0;     ///< length of a timestamp's tick
    std::uint64_t timestamp_mask = 0; ///< valid bits of a timestamp
    bool unified = false;
    bool executable_properties = false; ///< whether VK_KHR_pipeline_executable_properties is enabled
};

/// Returns the first allowed memory type with the `required` flags and, if possible, the `preferred` ones.
std::uint32_t memory_type(const Device::State& device, std::uint32_t allowed,
                          vk::MemoryPropertyFlags required, vk::MemoryPropertyFlags preferred = {});

/// The members of Buffer.
struct Buffer::State {
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::Buffer buffer = nullptr;
    std::span<std::byte> mapped;
    std::size_t bytes = 0;
};

/// The members of Pass.
struct Pass::State {
    vk::raii::DescriptorSetLayout set_layout = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline pipeline = nullptr;
    Interface interface;
    double seconds = 0;
};

} // namespace gabor::vulkan
