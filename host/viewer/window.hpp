#pragma once

#include "vulkan/device.hpp"

struct GLFWwindow;

namespace gabor::viewer {

/// The size of a window, a view or a picture, in pixels.
struct Extent {
    int width = 0;
    int height = 0;
    bool operator==(const Extent&) const = default;
};

/// Position of a window on the desktop, and its size in units that look equally large at each resolution:
/// pixels at 96 dpi.
struct Placement {
    int x = -1; ///< -1 lets the desktop decide
    int y = -1;
    int width = 1440;
    int height = 900;
    bool maximized = false;
    bool operator==(const Placement&) const = default;
};

/// A GLFW window on the screen and no larger than it. Throws std::runtime_error if there is no display, and
/// RequestError if there is no Vulkan driver that can draw on it.
class Window {
  public:
    explicit Window(const Placement& placement);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    vulkan::Presentation presentation() const;
    Placement placement() const; ///< placement of the window when it is not full screen
    void set_full_screen(bool full);
    Extent pixels() const; ///< size of the framebuffer
    bool shown() const;    ///< whether it is neither minimized nor hidden
    float density() const; ///< the desktop's text scale, or one that suits the screen's height
    /// Whether the user has asked to close the window since the last call.
    bool take_close_request();

  private:
    Placement windowed() const;
    double unit() const; ///< the desktop's measure of a unit of Placement

    GLFWwindow* window_ = nullptr;
    Placement before_full_screen_;
};

} // namespace gabor::viewer
