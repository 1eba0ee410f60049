#pragma once

#include "render/output/file.hpp"

#include <filesystem>
#include <span>

namespace gabor::render {

/// Throws RequestError unless `region` can be a texture: the view must be flat, the sides powers of two, and
/// the region one of the equal tiles that make up the picture.
void check_texture(const Request& request, const image::Rect& region);

/// The number of levels that are drawn, down to a single row or column. Smaller levels are averages.
int drawn_levels(const image::Rect& region);

/// The request that draws a level of a texture.
Request texture_level(Request request, int level);

/// Averages the pixels of a level to make the next mip level. Halves each side that is longer than 1.
std::vector<float> halved(std::span<const float> level, int width, int height, std::size_t channels);

/// Renders `region` of a checked request as a mip-mapped texture. Each drawn level is filtered for its own
/// pixel size, not averaged from the previous level. `half` stores 16-bit floats. `advance` is as for
/// render_file.
void render_texture(const vulkan::Device& device, const Request& request, const image::Rect& region,
                    const std::filesystem::path& path, bool half, const image::Advance& advance);

/// The approximate number of pixels in all levels.
constexpr std::uint64_t texture_pixels(std::uint64_t of_first_level) {
    return of_first_level + of_first_level / 3;
}

/// Assembles the drawn levels of a texture, each whole or in regions, into the file that render_texture would
/// have written. Returns the rectangle of the picture. Throws RequestError if a file is not a level of the
/// picture, or if a level is missing.
image::Rect join_texture(std::span<const std::filesystem::path> regions, const std::filesystem::path& output,
                         bool half, const image::Advance& advance);

} // namespace gabor::render
