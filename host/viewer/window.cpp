#include "viewer/window.hpp"

#include "error.hpp"

#include <vulkan/vulkan.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

namespace gabor::viewer {

namespace {

std::string last_error;

void note_error(int, const char* text) {
    last_error = text;
}

// The space that the desktop leaves for windows.
Extent screen() {
    Extent extent{16384, 16384};
    int x = 0;
    int y = 0;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
        glfwGetMonitorWorkarea(monitor, &x, &y, &extent.width, &extent.height);
    return extent;
}

} // namespace

Window::Window(const Placement& placement) {
    glfwSetErrorCallback(note_error);
    if (!glfwInit())
        throw std::runtime_error(
            fmt::format("there is no display ({}): start gabor-viewer on a desktop", last_error));
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_MAXIMIZED, placement.maximized);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    const Extent most = screen();
    window_ = glfwCreateWindow(std::min(placement.width, most.width), std::min(placement.height, most.height),
                               "Gabor noise", nullptr, nullptr);
    if (!window_ || !glfwVulkanSupported()) {
        if (window_)
            glfwDestroyWindow(window_);
        glfwTerminate();
        throw std::runtime_error(fmt::format("cannot open a window for Vulkan: {}", last_error));
    }
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (placement.x >= 0 && placement.y >= 0)
        glfwSetWindowPos(window_, placement.x, placement.y);
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

void Window::set_full_screen(bool full) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (full == (glfwGetWindowMonitor(window_) != nullptr) || !monitor)
        return;
    if (full) {
        before_full_screen_ = windowed();
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
        const Placement& to = before_full_screen_;
        glfwSetWindowMonitor(window_, nullptr, to.x, to.y, to.width, to.height, GLFW_DONT_CARE);
    }
}

Placement Window::placement() const {
    return glfwGetWindowMonitor(window_) ? before_full_screen_ : windowed();
}

Placement Window::windowed() const {
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
    // The height of a screen that needs no scaling, in pixels. Used if the desktop reports no scale.
    constexpr float usual_height = 1080;
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    const float stated = std::max(x, y);
    const float by_height = std::clamp(static_cast<float>(screen().height) / usual_height, 1.0f, 2.0f);
    return stated == 1 && glfwGetPrimaryMonitor() ? by_height : std::clamp(stated, 0.5f, 4.0f);
}

bool Window::take_close_request() {
    const bool asked = glfwWindowShouldClose(window_) != 0;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return asked;
}

} // namespace gabor::viewer
