#pragma once

#include "viewer/window.hpp"
#include "vulkan/state.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace gabor::viewer {

/// An image that can be drawn into, one of a swapchain or one to read back.
struct Target {
    vk::Image image;
    vk::raii::ImageView view = nullptr;
    vk::raii::Framebuffer framebuffer = nullptr;
    Extent extent;
};

/// How both kinds of target are drawn into: one colour attachment, cleared.
vk::raii::RenderPass make_render_pass(const vk::raii::Device& device, vk::Format format,
                                      vk::ImageLayout final_layout);
Target make_target(const vk::raii::Device& device, vk::RenderPass pass, vk::Image image, vk::Format format,
                   Extent extent);

constexpr vk::Format target_format = vk::Format::eB8G8R8A8Unorm;

/// The images of a window, made anew whenever its size changes.
class Swapchain {
  public:
    Swapchain(const vulkan::Device& device, GLFWwindow* window);
    ~Swapchain();

    vk::RenderPass render_pass() const { return *pass_; }
    std::uint32_t images() const { return static_cast<std::uint32_t>(targets_.size()); }

    /// The image to draw into next; nothing where the window has no pixels just now.
    const Target* acquire(Extent wanted);
    /// Submits what draws into it, and shows it.
    void present(vk::CommandBuffer commands);
    /// Waits until the last submission has been drawn.
    void wait();

  private:
    void rebuild(Extent wanted);

    const vulkan::Device& device_;
    vk::raii::SurfaceKHR surface_;
    vk::raii::RenderPass pass_;
    vk::raii::SwapchainKHR swapchain_ = nullptr;
    std::vector<Target> targets_;
    vk::raii::Semaphore acquired_;
    std::vector<vk::raii::Semaphore> drawn_; ///< one for each image: presentation holds on to it
    vk::raii::Fence done_;
    bool under_way_ = false;
    std::uint32_t current_ = 0;
    Extent extent_;
};

/// Draws into an image of its own and writes it as a PNG. `draw` records, with the render pass not yet begun
/// when `prepare` is called.
/// Throws RequestError where the device has no images of that size.
void save_png(const vulkan::Device& device, Extent extent, const std::filesystem::path& path,
              const std::function<void(vk::CommandBuffer)>& prepare,
              const std::function<void(vk::CommandBuffer)>& draw);

} // namespace gabor::viewer
