#pragma once

#include "viewer/window.hpp"

#include <filesystem>
#include <functional>

namespace gabor::viewer {

/// Draws into an image of its own and writes it as a PNG. `draw` records, with the render pass not yet begun
/// when `prepare` is called. Throws RequestError where the device has no images of that size.
void screenshot(const vulkan::Device& device, Extent extent, const std::filesystem::path& path,
                const std::function<void(vk::CommandBuffer)>& prepare,
                const std::function<void(vk::CommandBuffer)>& draw);

} // namespace gabor::viewer
