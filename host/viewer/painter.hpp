#pragma once

#include "viewer/canvas.hpp"
#include "viewer/show.hpp"
#include "viewer/tiling.hpp"
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

/// Shows a canvas through a colour map: shaders/viewer/show.vert and show.frag.
class Painter {
  public:
    Painter(const vulkan::Device& device, vk::RenderPass pass);

    /// Makes the values of a canvas visible to `paint`; outside a render pass, once what was painted before
    /// has been drawn.
    void prepare(vk::CommandBuffer commands);
    /// Records the drawing of a canvas, inside a render pass. `tiling`: how copies of it stand in the middle
    /// of the area, where it is that of a tile.
    void paint(vk::CommandBuffer commands, const Canvas& canvas, const Area& area, const Document& document,
               const std::optional<Tiling>& tiling = {});

    /// The same of red, green and blue of each cell of a grid, `stride` pixels apart, whose corner is at
    /// `origin` in the framebuffer.
    void paint_colours(vk::CommandBuffer commands, const vulkan::Buffer& colours, Extent grid,
                       std::array<float, 2> origin, float stride, const Area& within);

  private:
    vk::Pipeline pipeline(const ShowConstants& constants);
    void draw(vk::CommandBuffer commands, const vulkan::Buffer& values, const ShowConstants& constants,
              const passes::ShowPush& push, const Area& area, std::size_t index);

    const vulkan::Device& device_;
    vk::raii::DescriptorSetLayout set_layout_;
    vk::raii::PipelineLayout layout_;
    vk::raii::DescriptorPool pool_;
    std::vector<vk::raii::DescriptorSet> sets_;
    vk::RenderPass pass_;
    vk::raii::ShaderModule vertex_;
    vk::raii::ShaderModule fragment_;
    std::map<ShowConstants, vk::raii::Pipeline> pipelines_; ///< made when first wanted
};

} // namespace gabor::viewer
