#pragma once

#include "viewer/window.hpp"
#include "vulkan/state.hpp"

#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include <array>
#include <set>
#include <string_view>

namespace gabor::viewer {

/// Dear ImGui in a window, with its style and fonts.
class Gui {
  public:
    /// `scale` is the size of panels and text, relative to the desktop's.
    Gui(const vulkan::Device& device, const Window& window, vk::RenderPass pass, std::uint32_t images,
        float scale);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Changes the scale, starting with the next frame.
    void set_scale(float scale);
    /// Loads the characters of a text from the desktop's fonts, starting with the next frame.
    void prepare(std::string_view text);
    /// Begins a frame with the input since the last frame, which the device must have finished drawing.
    void begin();
    /// Whether input is left for later frames.
    bool has_input() const;
    /// Ends the frame; `draw` then records it inside a render pass.
    void end();
    void draw(vk::CommandBuffer commands) const;

  private:
    void load_fonts();
    void take_press();

    const vulkan::Device& device_;
    GLFWwindow* window_;
    vk::RenderPass pass_;
    vk::raii::DescriptorPool descriptors_ = nullptr;
    ImGui_ImplVulkan_InitInfo info_{};
    float density_;
    float scale_;
    std::set<ImWchar> characters_; ///< characters to load besides those of western Europe
    bool loaded_ = false;          ///< whether the fonts are loaded, with all `characters_`
    int taken_in_ = 0;             ///< frame that last took a key or a button
    int released_ = 0;             ///< key to release in the next frame; 0 for none
    std::array<bool, IM_ARRAYSIZE(ImGuiIO::MouseDown)> buttons_{}; ///< buttons that are held down
    std::array<double, IM_ARRAYSIZE(ImGuiIO::MouseDown)> pressed_at_{};
};

} // namespace gabor::viewer
