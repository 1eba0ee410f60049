#pragma once

// The Vulkan objects behind the other headers; included in this folder, and by the viewer, which draws with
// them.

#include "vulkan/buffer.hpp"
#include "vulkan/device.hpp"
#include "vulkan/pass.hpp"

#include <vulkan/vulkan_raii.hpp>

namespace gabor::vulkan {

/// Throws RequestError where there is no Vulkan loader.
vk::raii::Context load_vulkan();

/// With the validation layers where GABOR_VALIDATION asks for them. Throws RequestError without a driver.
vk::raii::Instance make_instance(const vk::raii::Context& context, const Presentation& presentation);

/// Counts and prints what the validation layers say; null without them.
vk::raii::DebugUtilsMessengerEXT make_messenger(const vk::raii::Instance& instance);

/// What a buffer takes that the host reads or writes.
inline constexpr vk::MemoryPropertyFlags coherent =
    vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;

/// What Device owns, in the order of its making.
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
    std::uint64_t timestamp_mask = 0; ///< the bits of it that count
    bool unified = false;
    bool executable_properties = false; ///< VK_KHR_pipeline_executable_properties is enabled
};

/// What Buffer owns.
struct Buffer::State {
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::Buffer buffer = nullptr;
    std::span<std::byte> mapped;
    std::size_t bytes = 0;
};

/// What Pass owns.
struct Pass::State {
    vk::raii::DescriptorSetLayout set_layout = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline pipeline = nullptr;
    Interface interface;
};

} // namespace gabor::vulkan
