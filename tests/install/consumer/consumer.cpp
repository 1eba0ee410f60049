// Runs a compute shader that fills 256 x 256 floats, and writes them to a file: consumer SHADER.spv
// VALUES.raw

#include <vulkan/vulkan_raii.hpp>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

constexpr std::uint32_t side = 256;
constexpr vk::DeviceSize bytes = side * side * sizeof(float);

int main(int, char** argv) {
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<char> spirv{std::istreambuf_iterator<char>(file), {}};

    const vk::raii::Context context;
    const vk::ApplicationInfo application("consumer", 1, nullptr, 0, VK_API_VERSION_1_1);
    const vk::raii::Instance instance(context, vk::InstanceCreateInfo({}, &application));
    const vk::raii::PhysicalDevices devices(instance);
    const vk::raii::PhysicalDevice& physical = devices.front();
    std::uint32_t family = 0;
    while (!(physical.getQueueFamilyProperties().at(family).queueFlags & vk::QueueFlagBits::eCompute))
        ++family;
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue_info({}, family, 1, &priority);
    const vk::raii::Device device(physical, vk::DeviceCreateInfo({}, queue_info));
    const vk::raii::Queue queue(device, family, 0);

    const vk::raii::Buffer buffer(device,
                                  vk::BufferCreateInfo({}, bytes, vk::BufferUsageFlagBits::eStorageBuffer));
    const vk::MemoryRequirements needs = buffer.getMemoryRequirements();
    const auto visible = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
    const vk::PhysicalDeviceMemoryProperties memories = physical.getMemoryProperties();
    std::uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1) ||
           (memories.memoryTypes.at(type).propertyFlags & visible) != visible)
        ++type;
    const vk::raii::DeviceMemory memory(device, vk::MemoryAllocateInfo(needs.size, type));
    buffer.bindMemory(*memory, 0);

    const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eStorageBuffer, 1,
                                                 vk::ShaderStageFlagBits::eCompute);
    const vk::raii::DescriptorSetLayout set_layout(device, vk::DescriptorSetLayoutCreateInfo({}, binding));
    const vk::raii::PipelineLayout layout(device, vk::PipelineLayoutCreateInfo({}, *set_layout));
    const vk::raii::ShaderModule module(
        device, {{}, spirv.size(), reinterpret_cast<const std::uint32_t*>(spirv.data())});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
    const vk::raii::Pipeline pipeline(device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout));

    const vk::DescriptorPoolSize pool_size(vk::DescriptorType::eStorageBuffer, 1);
    const vk::raii::DescriptorPool descriptors(
        device,
        vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, pool_size));
    const vk::raii::DescriptorSets sets(device, vk::DescriptorSetAllocateInfo(*descriptors, *set_layout));
    const vk::DescriptorBufferInfo whole(*buffer, 0, VK_WHOLE_SIZE);
    device.updateDescriptorSets(
        vk::WriteDescriptorSet(*sets.front(), 0, 0, vk::DescriptorType::eStorageBuffer, {}, whole), {});

    const vk::raii::CommandPool pool(device, vk::CommandPoolCreateInfo({}, family));
    const vk::raii::CommandBuffers buffers(device, {*pool, vk::CommandBufferLevel::ePrimary, 1});
    const vk::raii::CommandBuffer& commands = buffers.front();
    commands.begin(vk::CommandBufferBeginInfo());
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, *sets.front(), {});
    commands.dispatch(side / 8, side / 8, 1);
    const vk::MemoryBarrier written(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             written, {}, {});
    commands.end();
    const vk::raii::Fence fence(device, vk::FenceCreateInfo());
    queue.submit(vk::SubmitInfo({}, {}, *commands), *fence);
    if (device.waitForFences(*fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()) !=
        vk::Result::eSuccess)
        throw std::runtime_error("the device did not finish");

    std::ofstream(argv[2], std::ios::binary)
        .write(static_cast<const char*>(memory.mapMemory(0, bytes)), bytes);
}
