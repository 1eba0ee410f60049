#include "viewer/window.hpp"

#include "error.hpp"

#include <vulkan/vulkan.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace gabor::viewer {

namespace {

std::string last_error;

constexpr Extent least{480, 320};

void note_error(int, const char* text) {
    last_error = text;
}

// The part of a screen that the desktop leaves for windows.
struct WorkArea {
    int x = 0;
    int y = 0;
    Extent extent{16384, 16384};
};

WorkArea work_area(GLFWmonitor* monitor) {
    WorkArea area;
    if (monitor)
        glfwGetMonitorWorkarea(monitor, &area.x, &area.y, &area.extent.width, &area.extent.height);
    return area;
}

// On Wayland, windows are measured in units that the desktop scales, but GLFW states work areas in pixels,
// and windows cannot choose their place.
bool on_wayland() {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    return std::any_of(names, names + count,
                       [](std::string_view name) { return name == "VK_KHR_wayland_surface"; });
}

// The work area on which a point lies, or else the primary screen's.
WorkArea work_area_at(int x, int y) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        const WorkArea area = work_area(monitors[i]);
        if (x >= area.x && y >= area.y && x < area.x + area.extent.width && y < area.y + area.extent.height)
            return area;
    }
    return work_area(glfwGetPrimaryMonitor());
}

std::string no_display() {
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value;
    };
    if (is_set("WAYLAND_DISPLAY") && !is_set("DISPLAY"))
        return fmt::format("cannot use the Wayland display ({}): install libglfw3-wayland in place of "
                           "libglfw3, or start Xwayland",
                           last_error);
    return fmt::format("there is no display ({}): start gabor-viewer on a desktop", last_error);
}

} // namespace

Window::Window(const Placement& placement) {
    glfwSetErrorCallback(note_error);
    if (!glfwInit())
        throw std::runtime_error(no_display());
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = glfwCreateWindow(least.width, least.height, "Gabor noise", nullptr, nullptr);
    if (!window_ || !glfwVulkanSupported()) {
        const std::string why = window_ ? "no Vulkan driver found: " + vulkan::how_to_get_a_driver()
                                        : fmt::format("cannot open a window for Vulkan: {}", last_error);
        if (window_)
            glfwDestroyWindow(window_);
        glfwTerminate();
        throw RequestError(why);
    }
    const bool placed = placement.x >= 0 && placement.y >= 0 && !on_wayland();
    WorkArea area = placed ? work_area_at(placement.x, placement.y) : work_area(glfwGetPrimaryMonitor());
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor(); monitor && on_wayland()) {
        float x = 1;
        float y = 1;
        glfwGetMonitorContentScale(monitor, &x, &y);
        area.extent = {static_cast<int>(static_cast<float>(area.extent.width) / x),
                       static_cast<int>(static_cast<float>(area.extent.height) / y)};
    }
    const auto fitting = [this](int units, int most) {
        return std::min(static_cast<int>(std::lround(units * unit())), most);
    };
    const Extent size{fitting(placement.width, area.extent.width),
                      fitting(placement.height, area.extent.height)};
    glfwSetWindowSizeLimits(window_, std::min(least.width, size.width), std::min(least.height, size.height),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowSize(window_, size.width, size.height);
    if (placed)
        glfwSetWindowPos(window_, std::clamp(placement.x, area.x, area.x + area.extent.width - size.width),
                         std::clamp(placement.y, area.y, area.y + area.extent.height - size.height));
    if (placement.maximized)
        glfwMaximizeWindow(window_);
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
        glfwSetWindowMonitor(window_, nullptr, to.x, to.y, static_cast<int>(std::lround(to.width * unit())),
                             static_cast<int>(std::lround(to.height * unit())), GLFW_DONT_CARE);
    }
}

Placement Window::placement() const {
    return glfwGetWindowMonitor(window_) ? before_full_screen_ : windowed();
}

Placement Window::windowed() const {
    Placement placement;
    glfwGetWindowPos(window_, &placement.x, &placement.y);
    Extent size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    placement.width = static_cast<int>(std::lround(size.width / unit()));
    placement.height = static_cast<int>(std::lround(size.height / unit()));
    placement.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
    return placement;
}

double Window::unit() const {
    Extent size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    const int across = pixels().width;
    const double per_size =
        across > 0 && size.width > 0 ? 1.0 * across / size.width : 1.0; // 1 on X11, the scale on Wayland
    return std::clamp(double{std::max(x, y)}, 0.5, 4.0) / per_size;
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
    const float by_height = std::clamp(
        static_cast<float>(work_area(glfwGetPrimaryMonitor()).extent.height) / usual_height, 1.0f, 2.0f);
    return stated == 1 && glfwGetPrimaryMonitor() ? by_height : std::clamp(stated, 0.5f, 4.0f);
}

bool Window::take_close_request() {
    const bool asked = glfwWindowShouldClose(window_) != 0;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return asked;
}

} // namespace gabor::viewer
