#include "viewer/window.hpp"

#include "error.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gabor::viewer {

namespace {

std::string last_error;

void note_error(int, const char* text) {
    last_error = text;
}

} // namespace

Window::Window(const Placement& placement, bool visible) {
    glfwSetErrorCallback(note_error);
    if (!glfwInit())
        throw std::runtime_error(fmt::format("no display to open a window on ({}): it takes a desktop, or "
                                             "xvfb-run for pictures without one",
                                             last_error));
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_MAXIMIZED, placement.maximized);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_ = glfwCreateWindow(placement.width, placement.height, "Gabor noise", nullptr, nullptr);
    if (!window_ || !glfwVulkanSupported()) {
        if (window_)
            glfwDestroyWindow(window_);
        glfwTerminate();
        throw std::runtime_error(fmt::format("cannot open a window that Vulkan draws into: {}", last_error));
    }
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (placement.x >= 0 && placement.y >= 0)
        glfwSetWindowPos(window_, placement.x, placement.y);
    if (visible)
        glfwShowWindow(window_);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

vulkan::Presentation Window::presentation() const {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    return {{names, names + count},
            [](VkInstance_T* instance, VkPhysicalDevice_T* physical, std::uint32_t family) {
                return glfwGetPhysicalDevicePresentationSupport(instance, physical, family) == GLFW_TRUE;
            }};
}

Placement Window::placement() const {
    Placement placement;
    glfwGetWindowPos(window_, &placement.x, &placement.y);
    glfwGetWindowSize(window_, &placement.width, &placement.height);
    placement.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
    return placement;
}

Extent Window::pixels() const {
    Extent extent;
    glfwGetFramebufferSize(window_, &extent.width, &extent.height);
    return extent;
}

bool Window::shown() const {
    const Extent extent = pixels();
    return extent.width > 0 && extent.height > 0 && !glfwGetWindowAttrib(window_, GLFW_ICONIFIED) &&
           glfwGetWindowAttrib(window_, GLFW_VISIBLE);
}

float Window::density() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(std::max(x, y), 0.5f, 4.0f);
}

bool Window::close_asked() const {
    return glfwWindowShouldClose(window_) != 0;
}

vk::raii::RenderPass make_render_pass(const vk::raii::Device& device, vk::Format format,
                                      vk::ImageLayout final_layout) {
    const vk::AttachmentDescription colour({}, format, vk::SampleCountFlagBits::e1,
                                           vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eStore,
                                           vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                           vk::ImageLayout::eUndefined, final_layout);
    const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
    using Stage = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    const std::array dependencies{
        vk::SubpassDependency(VK_SUBPASS_EXTERNAL, 0, Stage::eColorAttachmentOutput,
                              Stage::eColorAttachmentOutput, {}, Access::eColorAttachmentWrite),
        vk::SubpassDependency(0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput, Stage::eTransfer,
                              Access::eColorAttachmentWrite, Access::eTransferRead)};
    return {device, vk::RenderPassCreateInfo({}, colour, subpass, dependencies)};
}

Target make_target(const vk::raii::Device& device, vk::RenderPass pass, vk::Image image, vk::Format format,
                   Extent extent) {
    Target target;
    target.image = image;
    target.extent = extent;
    target.view =
        vk::raii::ImageView(device, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format, {},
                                                            {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    target.framebuffer = vk::raii::Framebuffer(
        device, vk::FramebufferCreateInfo({}, pass, *target.view, static_cast<std::uint32_t>(extent.width),
                                          static_cast<std::uint32_t>(extent.height), 1));
    return target;
}

namespace {

vk::raii::SurfaceKHR make_surface(const vulkan::Device& device, GLFWwindow* window) {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(*device.state().instance, window, nullptr, &surface) != VK_SUCCESS)
        throw std::runtime_error("Vulkan cannot draw into this window");
    return {device.state().instance, surface};
}

} // namespace

Swapchain::Swapchain(const vulkan::Device& device, GLFWwindow* window)
    : device_(device), surface_(make_surface(device, window)),
      pass_(make_render_pass(device.state().device, target_format, vk::ImageLayout::ePresentSrcKHR)),
      acquired_(device.state().device, vk::SemaphoreCreateInfo()),
      done_(device.state().device, vk::FenceCreateInfo()) {
    const vulkan::Device::State& state = device.state();
    const auto formats = state.physical.getSurfaceFormatsKHR(*surface_);
    if (!state.physical.getSurfaceSupportKHR(state.family, *surface_) ||
        std::ranges::none_of(formats,
                             [](const vk::SurfaceFormatKHR& f) { return f.format == target_format; }))
        throw std::runtime_error(
            fmt::format("{} cannot show 8-bit BGRA pictures in this window", device.info().name));
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    rebuild({width, height});
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
    state.device.waitIdle(); // presentation too holds on to images and semaphores
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
        targets_.push_back(make_target(state.device, *pass_, image, target_format, extent_));
        drawn_.emplace_back(state.device, vk::SemaphoreCreateInfo());
    }
}

const Target* Swapchain::acquire(Extent wanted) {
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
        return nullptr; // the next frame will be shown
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

} // namespace gabor::viewer
