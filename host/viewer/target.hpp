#pragma once

#include "viewer/window.hpp"
#include "vulkan/state.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace gabor::viewer {

/// An image to draw into: one of a swapchain, or one to read back.
struct RenderTarget {
    vk::Image image;
    vk::raii::ImageView view = nullptr;
    vk::raii::Framebuffer framebuffer = nullptr;
    Extent extent;
};

/// A command buffer with its pool.
class Commands {
  public:
    explicit Commands(const vulkan::Device& device);

    vk::CommandBuffer operator*() const { return *buffer_; }
    /// Records commands, submits them, and waits until the device has executed them.
    void run(const std::function<void(vk::CommandBuffer)>& record) const;

  private:
    const vulkan::Device::State& state_;
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer buffer_;
};

/// The images of a window, rebuilt when its size changes.
class Swapchain {
  public:
    Swapchain(const vulkan::Device& device, GLFWwindow* window);
    ~Swapchain();

    vk::RenderPass render_pass() const { return *pass_; }
    std::uint32_t images() const { return static_cast<std::uint32_t>(targets_.size()); }

    /// Returns the next image to draw into, or nothing while the window has no pixels.
    const RenderTarget* acquire(Extent wanted);
    /// Submits commands that draw into the acquired image, and shows the image.
    void present(vk::CommandBuffer commands);
    /// Waits for the last submission.
    void wait();

  private:
    void rebuild(Extent wanted);

    const vulkan::Device& device_;
    vk::raii::SurfaceKHR surface_;
    vk::raii::RenderPass pass_;
    vk::raii::SwapchainKHR swapchain_ = nullptr;
    std::vector<RenderTarget> targets_;
    vk::raii::Semaphore acquired_;
    /// One per image, because presentation may still be using the last frame's semaphore.
    std::vector<vk::raii::Semaphore> drawn_;
    vk::raii::Fence done_;
    bool under_way_ = false;
    std::uint32_t current_ = 0;
    Extent extent_;
};

/// Draws into a separate image and writes it as a PNG. Calls `prepare` before the render pass, and `draw`
/// inside it. Throws RequestError if the device has no images of that size.
void save_png(const vulkan::Device& device, Extent extent, const std::filesystem::path& path,
              const std::function<void(vk::CommandBuffer)>& prepare,
              const std::function<void(vk::CommandBuffer)>& draw);

} // namespace gabor::viewer
