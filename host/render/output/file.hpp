#pragma once

#include "image/exr.hpp"
#include "render/output/heightmap.hpp"
#include "render/output/renderer.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace gabor::render {

/// Maps noise from -2...2 to 0...1, as gabor_unorm does in GLSL.
constexpr float unorm(float noise) {
    return 0.5f + 0.25f * noise;
}

/// Encodes linear light as sRGB (IEC 61966-2-1), clamped to [0, 1].
float srgb(float light);

constexpr int most_frames = 9999;

/// Returns the request for one frame of an animation whose period is `frames` frames.
Request frame_of(Request request, int frame, int frames);

/// Numbers the files of several frames: NAME.exr becomes NAME.0001.exr.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame, int frames);

/// Returns the version, device and driver as text for a file's header. If all three are equal, so are the
/// pixels.
std::string software(const vulkan::Device& device);

/// Returns the header of an EXR file that holds a region of a picture. `software` names what rendered it.
image::ExrHeader exr_header(const Request& request, const image::Rect& region, const std::string& software);

struct Files {
    std::optional<std::filesystem::path> exr;
    std::optional<std::filesystem::path> png;            ///< a picture to look at
    std::optional<std::filesystem::path> heightmap = {}; ///< heights of the terrain view
    std::optional<Elevation> elevation = {}; ///< range of the heightmap; by default the full possible range
    bool full_range = false;                 ///< or whether it spans the heights that there are
    /// If set, converts a band to the red, green and blue values (0 to 1) that the PNG shows.
    std::function<std::span<const float>(std::span<const float>)> colours = {};
    std::string compression = "none"; ///< of the EXR: see image::exr_compressions
    bool normals = false;             ///< whether `colours` needs normals: see Viewport
};

/// Renders `region` of a checked request to files. Calls `advance` before it writes a band; if `advance`
/// throws, no file is left.
void render_file(const vulkan::Device& device, const Request& request, const image::Rect& region,
                 const Files& files, const image::Advance& advance);

} // namespace gabor::render
