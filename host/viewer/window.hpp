#pragma once

#include "vulkan/state.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace gabor::viewer {

struct Extent {
    int width = 0;
    int height = 0;
    bool operator==(const Extent&) const = default;
};

/// Where a window was, to have it there again. In the units of the desktop, not of pixels.
struct Placement {
    int x = -1; ///< -1: wherever the desktop puts it
    int y = -1;
    int width = 1440;
    int height = 900;
    bool maximized = false;
};

/// A window of GLFW. Throws std::runtime_error, in one line, where there is no display.
class Window {
  public:
    Window(const Placement& placement, bool visible);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    vulkan::Presentation presentation() const;
    Placement placement() const;
    Extent pixels() const; ///< of the framebuffer
    bool shown() const;    ///< neither minimized nor hidden
    float density() const; ///< how much larger than usual the desktop wants text
    bool close_asked() const;

  private:
    GLFWwindow* window_ = nullptr;
};

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

} // namespace gabor::viewer
