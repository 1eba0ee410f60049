#pragma once

#include "render/file.hpp"

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace gabor::render {

/// How a texture is kept.
struct TextureFormat {
    std::string_view compression = "none";
    bool half = false; ///< 16-bit floats
};

/// Throws RequestError unless `region` can be a texture: seen flat through the filter, its sides powers of
/// two, and its corner and the picture's sides multiples of them.
void check_texture(const Request& request, const image::Rect& region);

/// How many levels of such a region are drawn, down to a single row or column; those below are averages.
int drawn_levels(const image::Rect& region);

/// The picture that level `level` of a picture's texture is.
Request texture_level(Request request, int level);

/// Renders `region` of a checked request as a mip-mapped texture, a picture of its own: each level as the
/// filter of a pixel of its own size sees the noise, instead of an average of the level before. `advance` as
/// for render_file.
FileTimes render_texture(const vulkan::Device& device, const Request& request, const image::Rect& region,
                         const std::filesystem::path& path, const TextureFormat& format,
                         const std::function<void(std::uint64_t)>& advance);

/// Pixels of all levels, about: a quarter more, a sixteenth, and so on.
constexpr std::uint64_t texture_pixels(std::uint64_t of_first_level) {
    return of_first_level + of_first_level / 3;
}

/// Makes of all drawn levels of a picture, each rendered as texture_level has it, whole or in regions, the
/// file that render_texture would have written, in the regions' compression; returns the picture. Throws
/// RequestError where files are none of one picture's levels, or do not cover all of them.
image::Rect join_texture(std::span<const std::filesystem::path> regions, const std::filesystem::path& output,
                         bool half, const std::function<void(std::uint64_t)>& advance);

} // namespace gabor::render
