#pragma once

#include "image/exr.hpp"
#include "render/heightmap.hpp"
#include "render/renderer.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::render {

/// Maps noise from -2...2 to 0...1, as gabor_unorm does in GLSL.
constexpr float unorm(float noise) {
    return 0.5f + 0.25f * noise;
}

/// Encodes linear light as sRGB (IEC 61966-2-1), clamped to [0, 1].
float srgb(float light);

constexpr int most_frames = 9999;

/// Returns frame `frame` of an animation that takes one period in `frames` frames.
Request frame_of(Request request, int frame, int frames);

/// Numbers the files of several frames: NAME.exr becomes NAME.0001.exr.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame, int frames);

/// How long each part of rendering a file took, in seconds.
struct FileTimes {
    Times rendering;
    double writing = 0;
    double closing = 0; ///< flushing to disk

    FileTimes& operator+=(const FileTimes& other);
};

/// Names version, device and driver for a file's header. If these agree, so do the pixels.
std::string software(const vulkan::Device& device);

/// Describes the EXR with a region of a picture. `software` is what made it.
image::ExrWriter::Description exr_description(const Request& request, const image::Rect& region,
                                              const std::string& software);

struct Files {
    std::optional<std::filesystem::path> exr;
    std::optional<std::filesystem::path> png;            ///< a picture to look at
    std::optional<std::filesystem::path> heightmap = {}; ///< heights of the terrain view
    std::optional<Elevation> elevation = {}; ///< range of the heightmap; by default the full possible range
    std::string_view compression = "none";
    /// If set, converts a band to the red, green and blue, from 0 to 1, that the PNG shows.
    std::function<std::span<const float>(std::span<const float>)> colours = {};
    bool normals = false; ///< `colours` needs them: see Viewport
};

/// Renders `region` of a checked request to files. Calls `advance` with the number of pixels in each band
/// before writing it; if `advance` throws, no file is left.
FileTimes render_file(const vulkan::Device& device, const Request& request, const image::Rect& region,
                      const Files& files, const std::function<void(std::uint64_t)>& advance);

} // namespace gabor::render
