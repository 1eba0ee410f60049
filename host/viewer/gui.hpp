#pragma once

#include "viewer/window.hpp"
#include "vulkan/state.hpp"

#include <filesystem>

struct ImDrawData;

namespace gabor::viewer {

/// Dear ImGui on a window: its style, its font at the desktop's density, and its drawing.
class Gui {
  public:
    Gui(const vulkan::Device& device, const Window& window, vk::RenderPass pass, std::uint32_t images);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Begins a frame with the input that the window has had since the last.
    void begin();
    /// Ends it; then `draw` may record what it came to, inside a render pass.
    void end();
    void draw(vk::CommandBuffer commands) const;

  private:
    vk::raii::DescriptorPool descriptors_;
    std::vector<int> released_; ///< keys held down for this frame alone
};

} // namespace gabor::viewer
