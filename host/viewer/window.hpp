#pragma once

#include "viewer/extent.hpp"
#include "vulkan/device.hpp"

struct GLFWwindow;

namespace gabor::viewer {

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
    Placement placement() const; ///< of the window, also while it fills the screen
    bool full_screen() const;
    void set_full_screen(bool full);
    Extent pixels() const; ///< of the framebuffer
    bool shown() const;    ///< neither minimized nor hidden
    float density() const; ///< how much larger than usual the desktop wants text
    /// Whether somebody has asked to close it since the last call.
    bool take_close_request();

  private:
    Placement windowed() const;

    GLFWwindow* window_ = nullptr;
    Placement before_full_screen_;
};

} // namespace gabor::viewer
