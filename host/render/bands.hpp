#pragma once

#include "image/exr.hpp"
#include "render/picture.hpp"
#include "vulkan/device.hpp"

#include <functional>
#include <span>

namespace gabor::render {

struct Times {
    double first_dispatch = 0; ///< seconds from the call to the first submission
    double waiting = 0;        ///< seconds that the host waited for the device
    double gpu = 0;            ///< seconds that the passes took on the device, NaN where it cannot tell
};

/// Renders `region` of a checked picture from top to bottom and hands whole rows to `sink`, band by band:
/// while one band is taken the next is on the device. Memory does not grow with the height. What `sink`
/// throws ends it.
Times render_bands(const vulkan::Device& device, const Picture& picture, const image::Window& region,
                   const std::function<void(std::span<const float>)>& sink);

} // namespace gabor::render
