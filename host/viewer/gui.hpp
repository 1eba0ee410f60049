#pragma once

#include "viewer/window.hpp"
#include "vulkan/state.hpp"

#include <filesystem>

struct ImDrawData;

namespace gabor::viewer {

/// Dear ImGui in a window, with its style and font.
class Gui {
  public:
    /// `scale`: size of panels and text relative to the desktop's.
    Gui(const vulkan::Device& device, const Window& window, vk::RenderPass pass, std::uint32_t images,
        float scale);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Changes the scale; the font keeps its first resolution.
    void set_scale(float scale);
    /// Begins a frame with the input since the last one.
    void begin();
    /// Ends the frame; `draw` then records it inside a render pass.
    void end();
    void draw(vk::CommandBuffer commands) const;

  private:
    vk::raii::DescriptorPool descriptors_;
    float density_;
    float scale_;               ///< the current one
    float font_scale_;          ///< of the font
    std::vector<int> released_; ///< keys to release after this frame
};

} // namespace gabor::viewer
