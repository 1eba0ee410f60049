#pragma once

#include "viewer/window.hpp"
#include "vulkan/state.hpp"

#include <filesystem>

struct ImDrawData;

namespace gabor::viewer {

/// Dear ImGui on a window: its style, its font at the desktop's density, and its drawing.
class Gui {
  public:
    /// `scale`: how much larger panels and text are than the desktop asks for.
    Gui(const vulkan::Device& device, const Window& window, vk::RenderPass pass, std::uint32_t images,
        float scale);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Another scale; letters are as sharp as the first one had them.
    void set_scale(float scale);
    /// Begins a frame with the input that the window has had since the last.
    void begin();
    /// Ends it; then `draw` may record what it came to, inside a render pass.
    void end();
    void draw(vk::CommandBuffer commands) const;

  private:
    vk::raii::DescriptorPool descriptors_;
    float density_;
    float scale_;               ///< as it is now
    float font_scale_;          ///< that the font was made for
    std::vector<int> released_; ///< keys held down for this frame alone
};

} // namespace gabor::viewer
