#pragma once

#include "viewer/canvas.hpp"
#include "viewer/display.hpp"
#include "viewer/drawing.hpp"
#include "vulkan/state.hpp"

#include <array>
#include <map>
#include <optional>

namespace gabor::viewer {

/// A rectangle of a framebuffer, in pixels.
struct Area {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Where to paint a grid of colours in the framebuffer: the corner of the grid, and the pixels to paint.
struct PlacedColours {
    std::array<float, 2> origin;
    Area within;
};

/// Paints values through a colour map: shaders/viewer/display.vert and display.frag.
class Painter {
  public:
    Painter(const vulkan::Device& device, vk::RenderPass pass);

    /// Makes new values visible to `paint`. Call it outside a render pass, after earlier painting is done.
    void prepare(vk::CommandBuffer commands);
    /// Paints a canvas, inside a render pass. With `tiling`, repeats it as tiles in the middle of the area.
    void paint(vk::CommandBuffer commands, const Canvas& canvas, const Area& area, const Document& document,
               const std::optional<Tiling>& tiling = {});

    /// Paints pieces of a grid of red, green and blue, whose cells are `stride` pixels apart.
    void paint_colours(vk::CommandBuffer commands, const vulkan::Buffer& colours, Extent grid, float stride,
                       const std::vector<PlacedColours>& pieces);

  private:
    vk::Pipeline pipeline(const DisplayConstants& constants);
    void bind(vk::CommandBuffer commands, const vulkan::Buffer& values, const DisplayConstants& constants,
              std::size_t index);
    void draw(vk::CommandBuffer commands, const passes::DisplayPush& push, const Area& area);

    const vulkan::Device& device_;
    vk::raii::DescriptorSetLayout set_layout_;
    vk::raii::PipelineLayout layout_;
    vk::raii::DescriptorPool pool_;
    std::vector<vk::raii::DescriptorSet> sets_;
    vk::RenderPass pass_;
    vk::raii::ShaderModule vertex_;
    vk::raii::ShaderModule fragment_;
    std::map<DisplayConstants, vk::raii::Pipeline> pipelines_; ///< made on first use
};

} // namespace gabor::viewer
