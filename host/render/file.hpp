#pragma once

#include "render/bands.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

namespace gabor::render {

/// The values of a picture as shown in a PNG: the mean at 0.5, two standard deviations at the ends.
constexpr float shown(float value) {
    return 0.5f + 0.25f * value;
}

/// Where the time of rendering a file went, in seconds.
struct FileTimes {
    Times rendering;
    double writing = 0;
    double closing = 0; ///< until the file was on the disk

    FileTimes& operator+=(const FileTimes& other);
};

struct Files {
    std::filesystem::path exr;
    std::optional<std::filesystem::path> png; ///< of the noise, or in colour of three, to look at
    std::string_view compression = "none";
};

/// Renders `region` of a checked picture into an EXR, and into a PNG beside it. `advance` is called with the
/// number of pixels of each band before they are written; what it throws ends everything, and leaves no file.
FileTimes render_file(const vulkan::Device& device, const Picture& picture, const image::Window& region,
                      const Files& files, const std::function<void(std::uint64_t)>& advance);

} // namespace gabor::render
