#include "viewer/screenshot.hpp"

#include "error.hpp"
#include "image/png.hpp"

#include <fmt/format.h>

#include <vector>

namespace gabor::viewer {

namespace {

std::uint32_t device_memory(const vulkan::Device::State& device, std::uint32_t allowed) {
    const vk::PhysicalDeviceMemoryProperties properties = device.physical.getMemoryProperties();
    for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i)
        if ((allowed >> i & 1) &&
            properties.memoryTypes[i].propertyFlags & vk::MemoryPropertyFlagBits::eDeviceLocal)
            return i;
    throw std::runtime_error(fmt::format("{} has no memory for pictures", device.info.name));
}

} // namespace

void screenshot(const vulkan::Device& device, Extent extent, const std::filesystem::path& path,
                const std::function<void(vk::CommandBuffer)>& prepare,
                const std::function<void(vk::CommandBuffer)>& draw) {
    const vulkan::Device::State& state = device.state();
    const auto width = static_cast<std::uint32_t>(extent.width);
    const auto height = static_cast<std::uint32_t>(extent.height);
    const std::uint32_t largest = state.physical.getProperties().limits.maxFramebufferWidth;
    if (width > largest || height > largest)
        throw RequestError(fmt::format("a screenshot of {} x {} pixels: {} draws up to {} x {}", width,
                                       height, device.info().name, largest, largest));
    const vk::raii::Image image(
        state.device,
        vk::ImageCreateInfo({}, vk::ImageType::e2D, target_format, {width, height, 1}, 1, 1,
                            vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                            vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc));
    const vk::MemoryRequirements needs = image.getMemoryRequirements();
    const vk::raii::DeviceMemory memory(state.device,
                                        {needs.size, device_memory(state, needs.memoryTypeBits)});
    image.bindMemory(*memory, 0);
    const vk::raii::RenderPass pass =
        make_render_pass(state.device, target_format, vk::ImageLayout::eTransferSrcOptimal);
    const Target target = make_target(state.device, *pass, *image, target_format, extent);
    const vulkan::Buffer pixels(device, std::size_t{4} * width * height, vulkan::Memory::readback);

    const vk::raii::CommandPool pool(state.device, {vk::CommandPoolCreateFlagBits::eTransient, state.family});
    const vk::raii::CommandBuffers buffers(state.device, {*pool, vk::CommandBufferLevel::ePrimary, 1});
    const vk::CommandBuffer commands = *buffers.front();
    commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    prepare(commands);
    const vk::ClearValue black(vk::ClearColorValue(std::array{0.0f, 0.0f, 0.0f, 1.0f}));
    commands.beginRenderPass({*pass, *target.framebuffer, {{0, 0}, {width, height}}, black},
                             vk::SubpassContents::eInline);
    draw(commands);
    commands.endRenderPass();
    commands.copyImageToBuffer(
        *image, vk::ImageLayout::eTransferSrcOptimal, *pixels.state().buffer,
        vk::BufferImageCopy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, {width, height, 1}));
    commands.pipelineBarrier(
        vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost, {},
        vk::MemoryBarrier(vk::AccessFlagBits::eTransferWrite, vk::AccessFlagBits::eHostRead), {}, {});
    commands.end();
    state.queue.submit(vk::SubmitInfo({}, {}, commands));
    state.queue.waitIdle();

    image::PngWriter png(path, extent.width, extent.height, 3);
    std::vector<float> row(std::size_t{3} * width);
    const std::span<const std::uint8_t> bytes = pixels.as<std::uint8_t>();
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                row[3 * x + c] = static_cast<float>(bytes[4 * (y * width + x) + 2 - c]) / 255.0f;
        png.write_rows(row);
    }
    png.commit();
}

} // namespace gabor::viewer
