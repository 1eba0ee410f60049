#pragma once

#include "render/renderer.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::render {

/// A noise as it is shown, as gabor_unorm in GLSL: the mean at 0.5, two standard deviations at 0 and 1.
constexpr float unorm(float noise) {
    return 0.5f + 0.25f * noise;
}

/// Light as it is shown: from linear to the values of sRGB (IEC 61966-2-1), within [0, 1].
float srgb(float light);

/// Shows pixels as a PNG does, from 0 to 1: the noise in grey, three of them or a photograph's colours as
/// colours, a material by its look.
void show(const Request& request, std::span<const float> values, std::vector<float>& shown);
/// How many values each pixel then has, 1 or 3.
int shown_channels(const Request& request);

constexpr int most_frames = 9999;

/// One of `frames` frames of the animation of a request, which takes a period.
Request frame_of(Request request, int frame, int frames);

/// NAME.exr becomes NAME.0001.exr for the first of several frames.
std::filesystem::path frame_path(const std::filesystem::path& path, int frame, int frames);

/// Where the time of rendering a file went, in seconds.
struct FileTimes {
    Times rendering;
    double writing = 0;
    double closing = 0; ///< until the file was on the disk

    FileTimes& operator+=(const FileTimes& other);
};

/// What rendered a picture, as its header says: pixels agree between files where this does.
std::string software(const vulkan::Device& device);

struct Files {
    std::optional<std::filesystem::path> exr;
    std::optional<std::filesystem::path> png; ///< of the noise, or in colour of three, to look at
    std::string_view compression = "none";
    /// Red, green and blue of a band's pixels, from 0 to 1, that the PNG is to show in place of that.
    std::function<std::span<const float>(std::span<const float>)> colours = {};
};

/// Renders `region` of a checked request into an EXR, a PNG or both. `advance` is called with the number of
/// pixels of each band before they are written; what it throws ends everything, and leaves no file.
FileTimes render_file(const vulkan::Device& device, const Request& request, const image::Rect& region,
                      const Files& files, const std::function<void(std::uint64_t)>& advance);

} // namespace gabor::render
