#include "viewer/painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "display_frag.h"
#include "display_vert.h"

namespace gabor::viewer {

namespace {

constexpr std::size_t canvas_set = 0; // index of a descriptor set
constexpr std::size_t colours_set = 1;
constexpr std::size_t most_pipelines = 16;

Area intersection(const Area& a, const Area& b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

vk::raii::DescriptorSetLayout make_set_layout(const vk::raii::Device& device) {
    const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eStorageBuffer, 1,
                                                 vk::ShaderStageFlagBits::eFragment);
    return {device, vk::DescriptorSetLayoutCreateInfo({}, binding)};
}

vk::raii::PipelineLayout make_layout(const vk::raii::Device& device, vk::DescriptorSetLayout set) {
    const vk::PushConstantRange push(vk::ShaderStageFlagBits::eFragment, 0, sizeof(passes::DisplayPush));
    return {device, vk::PipelineLayoutCreateInfo({}, set, push)};
}

vk::raii::DescriptorPool make_pool(const vk::raii::Device& device) {
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, colours_set + 1);
    return {device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                 colours_set + 1, size)};
}

vk::raii::ShaderModule make_module(const vk::raii::Device& device, std::span<const std::uint32_t> spirv) {
    return {device, {{}, spirv.size_bytes(), spirv.data()}};
}

vk::raii::Pipeline make_pipeline(const vk::raii::Device& device, vk::PipelineLayout layout,
                                 vk::RenderPass pass, vk::ShaderModule vertex, vk::ShaderModule fragment,
                                 const DisplayConstants& constants) {
    std::vector<vk::SpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < constants.size(); ++i)
        entries.emplace_back(i, i * 4, 4);
    const vk::SpecializationInfo specialization(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                                sizeof constants, constants.data());
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, fragment, "main",
                                          &specialization)};
    const vk::PipelineVertexInputStateCreateInfo no_input;
    const vk::PipelineInputAssemblyStateCreateInfo triangles({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.lineWidth = 1;
    const vk::PipelineMultisampleStateCreateInfo single({}, vk::SampleCountFlagBits::e1);
    using C = vk::ColorComponentFlagBits;
    vk::PipelineColorBlendAttachmentState opaque;
    opaque.colorWriteMask = C::eR | C::eG | C::eB | C::eA;
    const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, opaque);
    const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamic_states);
    return {device, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &no_input, &triangles, nullptr, &viewport, &raster,
                                           &single, nullptr, &blend, &dynamic, layout, pass, 0)};
}

} // namespace

Painter::Painter(const vulkan::Device& device, vk::RenderPass pass)
    : device_(device), set_layout_(make_set_layout(device.state().device)),
      layout_(make_layout(device.state().device, *set_layout_)), pool_(make_pool(device.state().device)),
      pass_(pass), vertex_(make_module(device.state().device, display_vert_spirv)),
      fragment_(make_module(device.state().device, display_frag_spirv)) {
    const std::vector<vk::DescriptorSetLayout> layouts(colours_set + 1, *set_layout_);
    vk::raii::DescriptorSets sets(device.state().device, vk::DescriptorSetAllocateInfo(*pool_, layouts));
    for (vk::raii::DescriptorSet& set : sets)
        sets_.push_back(std::move(set));
}

vk::Pipeline Painter::pipeline(const DisplayConstants& constants) {
    const auto found = pipelines_.find(constants);
    if (found != pipelines_.end())
        return *found->second;
    return *pipelines_
                .emplace(constants, make_pipeline(device_.state().device, *layout_, pass_, *vertex_,
                                                  *fragment_, constants))
                .first->second;
}

void Painter::prepare(vk::CommandBuffer commands) {
    if (pipelines_.size() > most_pipelines) // lavapipe takes a megabyte for each
        pipelines_.clear();
    commands.pipelineBarrier(
        vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eFragmentShader, {},
        vk::MemoryBarrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eShaderRead), {}, {});
}

void Painter::paint(vk::CommandBuffer commands, const Canvas& canvas, const Area& area,
                    const Document& document, const std::optional<Tiling>& tiling) {
    const double zoom = tiling ? tiling->camera.zoom : document.camera.zoom;
    passes::DisplayPush push = display_push(document, canvas.stride(), zoom);
    Area visible = area;
    push.size = {static_cast<float>(area.width), static_cast<float>(area.height)};
    push.origin = {static_cast<float>(area.x), static_cast<float>(area.y)};
    if (tiling) {
        const auto [width, height] = tiling->tile;
        const Area copies{area.x + area.width / 2 - width, area.y + area.height / 2 - height, 2 * width,
                          2 * height};
        visible = intersection(area, copies);
        push.size = {static_cast<float>(width), static_cast<float>(height)};
        push.origin = {static_cast<float>(copies.x) - tiling->moved[0],
                       static_cast<float>(copies.y) - tiling->moved[1]};
    }
    push.grid = {canvas.grid().width, canvas.grid().height};
    push.stride = static_cast<float>(canvas.stride());
    const bool coarse = canvas.stride() > 1;
    bind(commands, canvas.values(),
         display_constants(document, canvas.channels(), coarse, tiling.has_value()), canvas_set);
    draw(commands, push, visible);
}

void Painter::paint_colours(vk::CommandBuffer commands, const vulkan::Buffer& colours, Extent grid,
                            float stride, const std::vector<PlacedColours>& pieces) {
    const auto pixel = [](float at) { return static_cast<int>(std::lround(std::clamp(at, -1e9f, 1e9f))); };
    const auto end = [&](float first, int cells) {
        return pixel(first + static_cast<float>(cells) * stride);
    };
    bind(commands, colours, colours_constants(), colours_set);
    for (const auto& [origin, within] : pieces) {
        const int left = pixel(origin[0]);
        const int top = pixel(origin[1]);
        const Area visible = intersection(
            within, {left, top, end(origin[0], grid.width) - left, end(origin[1], grid.height) - top});
        if (visible.width <= 0 || visible.height <= 0)
            continue;
        passes::DisplayPush push{};
        push.origin = {origin[0], origin[1]};
        push.grid = {grid.width, grid.height};
        push.stride = stride;
        draw(commands, push, visible);
    }
}

void Painter::bind(vk::CommandBuffer commands, const vulkan::Buffer& values,
                   const DisplayConstants& constants, std::size_t index) {
    const vk::raii::DescriptorSet& set = sets_.at(index);
    const vk::DescriptorBufferInfo buffer(*values.state().buffer, 0, VK_WHOLE_SIZE);
    device_.state().device.updateDescriptorSets(
        vk::WriteDescriptorSet(*set, 0, 0, vk::DescriptorType::eStorageBuffer, {}, buffer), {});
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline(constants));
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, *set, {});
}

void Painter::draw(vk::CommandBuffer commands, const passes::DisplayPush& push, const Area& area) {
    commands.pushConstants<passes::DisplayPush>(*layout_, vk::ShaderStageFlagBits::eFragment, 0, push);
    commands.setViewport(0,
                         vk::Viewport(static_cast<float>(area.x), static_cast<float>(area.y),
                                      static_cast<float>(area.width), static_cast<float>(area.height), 0, 1));
    commands.setScissor(0, vk::Rect2D({area.x, area.y}, {static_cast<std::uint32_t>(area.width),
                                                         static_cast<std::uint32_t>(area.height)}));
    commands.draw(3, 1, 0, 0);
}

} // namespace gabor::viewer
