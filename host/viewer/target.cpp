#include "viewer/target.hpp"

#include "error.hpp"
#include "image/png.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gabor::viewer {

namespace {

vk::raii::SurfaceKHR make_surface(const vulkan::Device& device, GLFWwindow* window) {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(*device.state().instance, window, nullptr, &surface) != VK_SUCCESS)
        throw std::runtime_error("Vulkan cannot draw into this window");
    return {device.state().instance, surface};
}

constexpr vk::Format target_format = vk::Format::eB8G8R8A8Unorm;

// A render pass with one colour attachment, cleared first.
vk::raii::RenderPass make_render_pass(const vk::raii::Device& device, vk::ImageLayout final_layout) {
    const vk::AttachmentDescription colour({}, target_format, vk::SampleCountFlagBits::e1,
                                           vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eStore,
                                           vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                           vk::ImageLayout::eUndefined, final_layout);
    const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
    using ShaderStage = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    const std::array dependencies{
        vk::SubpassDependency(VK_SUBPASS_EXTERNAL, 0, ShaderStage::eColorAttachmentOutput,
                              ShaderStage::eColorAttachmentOutput, {}, Access::eColorAttachmentWrite),
        vk::SubpassDependency(0, VK_SUBPASS_EXTERNAL, ShaderStage::eColorAttachmentOutput,
                              ShaderStage::eTransfer, Access::eColorAttachmentWrite, Access::eTransferRead)};
    return {device, vk::RenderPassCreateInfo({}, colour, subpass, dependencies)};
}

RenderTarget make_target(const vk::raii::Device& device, vk::RenderPass pass, vk::Image image,
                         Extent extent) {
    RenderTarget target;
    target.image = image;
    target.extent = extent;
    target.view = vk::raii::ImageView(
        device, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, target_format, {},
                                        {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    target.framebuffer = vk::raii::Framebuffer(
        device, vk::FramebufferCreateInfo({}, pass, *target.view, static_cast<std::uint32_t>(extent.width),
                                          static_cast<std::uint32_t>(extent.height), 1));
    return target;
}

} // namespace

Commands::Commands(const vulkan::Device& device)
    : state_(device.state()),
      pool_(state_.device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, state_.family}),
      buffer_(std::move(
          vk::raii::CommandBuffers(state_.device, {*pool_, vk::CommandBufferLevel::ePrimary, 1}).front())) {}

void Commands::run(const std::function<void(vk::CommandBuffer)>& record) const {
    buffer_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record(*buffer_);
    buffer_.end();
    state_.queue.submit(vk::SubmitInfo({}, {}, *buffer_));
    state_.queue.waitIdle();
}

Swapchain::Swapchain(const vulkan::Device& device, GLFWwindow* window)
    : device_(device), surface_(make_surface(device, window)),
      pass_(make_render_pass(device.state().device, vk::ImageLayout::ePresentSrcKHR)),
      acquired_(device.state().device, vk::SemaphoreCreateInfo()),
      done_(device.state().device, vk::FenceCreateInfo()) {
    const vulkan::Device::State& state = device.state();
    const auto formats = state.physical.getSurfaceFormatsKHR(*surface_);
    if (!state.physical.getSurfaceSupportKHR(state.family, *surface_) ||
        std::ranges::none_of(formats,
                             [](const vk::SurfaceFormatKHR& f) { return f.format == target_format; }))
        throw std::runtime_error(
            fmt::format("{} cannot show 8-bit BGRA pictures in this window", device.info().name));
    Extent extent;
    glfwGetFramebufferSize(window, &extent.width, &extent.height);
    rebuild(extent);
}

Swapchain::~Swapchain() {
    device_.state().device.waitIdle();
}

void Swapchain::wait() {
    if (!under_way_)
        return;
    under_way_ = false;
    const vk::raii::Device& logical = device_.state().device;
    while (logical.waitForFences(*done_, VK_TRUE, std::numeric_limits<std::uint64_t>::max()) ==
           vk::Result::eTimeout) {
    }
    logical.resetFences(*done_);
}

void Swapchain::rebuild(Extent wanted) {
    const vulkan::Device::State& state = device_.state();
    wait();
    state.device.waitIdle(); // presentation may still use images and semaphores
    const vk::SurfaceCapabilitiesKHR can = state.physical.getSurfaceCapabilitiesKHR(*surface_);
    vk::Extent2D extent = can.currentExtent;
    if (extent.width == std::numeric_limits<std::uint32_t>::max())
        extent = vk::Extent2D(std::clamp(static_cast<std::uint32_t>(wanted.width), can.minImageExtent.width,
                                         can.maxImageExtent.width),
                              std::clamp(static_cast<std::uint32_t>(wanted.height), can.minImageExtent.height,
                                         can.maxImageExtent.height));
    targets_.clear();
    extent_ = {static_cast<int>(extent.width), static_cast<int>(extent.height)};
    if (extent.width == 0 || extent.height == 0)
        return;
    std::uint32_t count = can.minImageCount + 1;
    if (can.maxImageCount)
        count = std::min(count, can.maxImageCount);
    const auto alpha = can.supportedCompositeAlpha & vk::CompositeAlphaFlagBitsKHR::eOpaque
                           ? vk::CompositeAlphaFlagBitsKHR::eOpaque
                           : vk::CompositeAlphaFlagBitsKHR::eInherit;
    const vk::raii::SwapchainKHR old = std::move(swapchain_);
    swapchain_ = vk::raii::SwapchainKHR(
        state.device, vk::SwapchainCreateInfoKHR(
                          {}, *surface_, count, target_format, vk::ColorSpaceKHR::eSrgbNonlinear, extent, 1,
                          vk::ImageUsageFlagBits::eColorAttachment, vk::SharingMode::eExclusive, {},
                          can.currentTransform, alpha, vk::PresentModeKHR::eFifo, VK_TRUE, *old));
    drawn_.clear();
    for (const VkImage image : swapchain_.getImages()) {
        targets_.push_back(make_target(state.device, *pass_, image, extent_));
        drawn_.emplace_back(state.device, vk::SemaphoreCreateInfo());
    }
}

const RenderTarget* Swapchain::acquire(Extent wanted) {
    wait();
    if (wanted != extent_ || targets_.empty())
        rebuild(wanted);
    if (targets_.empty())
        return nullptr;
    try {
        const auto [result, index] =
            swapchain_.acquireNextImage(std::numeric_limits<std::uint64_t>::max(), *acquired_);
        current_ = index;
        return &targets_[index];
    } catch (const vk::OutOfDateKHRError&) {
        rebuild(wanted);
        return nullptr; // skips this frame
    }
}

void Swapchain::present(vk::CommandBuffer commands) {
    const vk::raii::Queue& queue = device_.state().queue;
    const vk::PipelineStageFlags stage = vk::PipelineStageFlagBits::eColorAttachmentOutput;
    queue.submit(vk::SubmitInfo(*acquired_, stage, commands, *drawn_[current_]), *done_);
    under_way_ = true;
    try {
        if (queue.presentKHR({*drawn_[current_], *swapchain_, current_}) == vk::Result::eSuboptimalKHR)
            extent_ = {};
    } catch (const vk::OutOfDateKHRError&) {
        extent_ = {};
    }
}

void save_png(const vulkan::Device& device, Extent extent, const std::filesystem::path& path,
              const std::function<void(vk::CommandBuffer)>& prepare,
              const std::function<void(vk::CommandBuffer)>& draw) {
    const vulkan::Device::State& state = device.state();
    const auto width = static_cast<std::uint32_t>(extent.width);
    const auto height = static_cast<std::uint32_t>(extent.height);
    const std::uint32_t largest = state.physical.getProperties().limits.maxFramebufferWidth;
    if (width > largest || height > largest)
        throw RequestError(
            fmt::format("a screenshot of {} x {} pixels is too large: {} draws at most {} x {}", width,
                        height, device.info().name, largest, largest));
    const vk::raii::Image image(
        state.device,
        vk::ImageCreateInfo({}, vk::ImageType::e2D, target_format, {width, height, 1}, 1, 1,
                            vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                            vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc));
    const vk::MemoryRequirements needs = image.getMemoryRequirements();
    const vk::raii::DeviceMemory memory(
        state.device, {needs.size, vulkan::memory_type(state, needs.memoryTypeBits,
                                                       vk::MemoryPropertyFlagBits::eDeviceLocal)});
    image.bindMemory(*memory, 0);
    const vk::raii::RenderPass pass = make_render_pass(state.device, vk::ImageLayout::eTransferSrcOptimal);
    const RenderTarget target = make_target(state.device, *pass, *image, extent);
    const vulkan::Buffer pixels(device, std::size_t{4} * width * height, vulkan::Memory::readback);

    Commands(device).run([&](vk::CommandBuffer commands) {
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
    });

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
