#include "render/output/texture.hpp"

#include "error.hpp"
#include "image/exr.hpp"
#include "render/request/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gabor::render {

void check_texture(const Request& request, const image::Rect& region) {
    if (!is_pattern(request.kind) || request.view.projection != Projection::flat)
        throw RequestError("a texture requires --view flat, with noise or a material");
    if (!std::has_single_bit(static_cast<unsigned>(region.width)) ||
        !std::has_single_bit(static_cast<unsigned>(region.height)))
        throw RequestError(fmt::format("a texture of {} x {} pixels: each side must be a power of two",
                                       region.width, region.height));
    if (region.x % region.width != 0 || region.y % region.height != 0 || request.width % region.width != 0 ||
        request.height % region.height != 0)
        throw RequestError(fmt::format("a texture with --region {},{},{},{}: the region must be one of the "
                                       "equal tiles that make up the picture of {} x {} pixels",
                                       region.x, region.y, region.width, region.height, request.width,
                                       request.height));
}

int drawn_levels(const image::Rect& region) {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::min(region.width, region.height))));
}

// Pixel centres are at (i + 0.5) / scale, so this is the same noise in larger pixels.
Request texture_level(Request request, int level) {
    request.filter = true;
    request.width >>= level;
    request.height >>= level;
    request.scale = std::ldexp(request.scale, -level);
    return request;
}

std::vector<float> halved(std::span<const float> level, int width, int height, std::size_t channels) {
    const int x_step = width > 1 ? 2 : 1;
    const int y_step = height > 1 ? 2 : 1;
    std::vector<float> half;
    half.reserve(level.size() / static_cast<std::size_t>(x_step * y_step));
    for (int y = 0; y < height; y += y_step)
        for (int x = 0; x < width; x += x_step)
            for (std::size_t c = 0; c < channels; ++c) {
                float sum = 0;
                for (int j = 0; j < y_step; ++j)
                    for (int i = 0; i < x_step; ++i)
                        sum += level[static_cast<std::size_t>((y + j) * width + x + i) * channels + c];
                half.push_back(sum / static_cast<float>(x_step * y_step));
            }
    return half;
}

namespace {

image::ExrWriter make_writer(const std::filesystem::path& path, const Request& request,
                             const image::Rect& region, bool half, const std::string& made_by) {
    const image::Rect whole{0, 0, region.width, region.height};
    image::ExrHeader header = exr_header(request, whole, made_by);
    header.picture = whole;
    const bool tile =
        request.view.tileable && region.width == request.width && region.height == request.height;
    header.texture = image::ExrHeader::Texture{tile};
    if (half)
        header.halves = header.channels;
    return {path, header};
}

// Passes the rows of all levels to `write`. `draw` draws a level.
void write_levels(const image::Rect& region, std::size_t channels, const Sink& write,
                  const std::function<void(int level, const Sink&)>& draw) {
    int level = 0;
    for (; level + 1 < drawn_levels(region); ++level)
        draw(level, write);
    // After a level with one row or column, pixels are not square, so the smaller levels average pairs.
    std::vector<float> line;
    draw(level, [&](std::span<const float> values) {
        write(values);
        line.insert(line.end(), values.begin(), values.end());
    });
    while (line.size() > channels) {
        line = halved(line, static_cast<int>(line.size() / channels), 1, channels);
        write(line);
    }
}

} // namespace

void render_texture(const vulkan::Device& device, const Request& request, const image::Rect& region,
                    const std::filesystem::path& path, bool half, const image::Advance& advance) {
    const std::size_t channels = render::channels(request).size();
    image::ExrWriter writer = make_writer(path, request, region, half, software(device));

    const auto write = [&](std::span<const float> values) {
        advance(values.size() / channels);
        writer.write_rows(values);
    };
    const Paint paint = load_paint(request.paint);
    Renderer renderer(device);
    write_levels(region, channels, write, [&](int level, const Sink& take) {
        const Request here = texture_level(request, level);
        const image::Rect window{region.x >> level, region.y >> level, region.width >> level,
                                 region.height >> level};
        renderer.set(plan(here, viewport_of(here, window), paint, kind_of(device)));
        render_plan(device, renderer, take);
    });
    writer.commit();
}

image::Rect join_texture(std::span<const std::filesystem::path> regions, const std::filesystem::path& output,
                         bool half, const image::Advance& advance) {
    constexpr std::string_view accepted =
        "expected regions of one picture's levels, from gabor texture --level";
    // The files of each level, largest level first.
    std::map<std::pair<int, int>, std::vector<std::filesystem::path>, std::greater<>> levels;
    for (const std::filesystem::path& path : regions) {
        const image::Rect picture = image::ExrReader(path).header().picture;
        levels[{picture.width, picture.height}].push_back(path);
    }
    const std::filesystem::path first = levels.begin()->second.front();
    const image::ExrHeader whole = image::ExrReader(first).header();
    const Request request = from_json(whole.parameters);
    if (!request.filter)
        throw RequestError(fmt::format("cannot join: '{}' is not filtered; {}", first.string(), accepted));
    check_texture(request, whole.picture);
    const std::vector<std::string> names = channels(request);
    image::ExrWriter writer = make_writer(output, request, whole.picture, half, whole.software);
    const auto write = [&](std::span<const float> values) {
        advance(values.size() / names.size());
        writer.write_rows(values);
    };
    write_levels(whole.picture, names.size(), write, [&](int level, const Sink& take) {
        const Request here = texture_level(request, level);
        const auto found = levels.find({here.width, here.height});
        if (found == levels.end())
            throw RequestError(fmt::format("cannot join: there is no region of level {} ({} x {} pixels); {}",
                                           level, here.width, here.height, accepted));
        image::ExrReader reader(std::span(found->second), names);
        if (reader.header().parameters != to_json(here) || reader.header().software != whole.software)
            throw RequestError(fmt::format(
                "cannot join: '{}' is not level {} of '{}', or was rendered by another version or driver; {}",
                found->second.front().string(), level, first.string(), accepted));
        reader.read_bands(take);
        levels.erase(found);
    });
    if (!levels.empty())
        throw RequestError(fmt::format("cannot join: '{}' is not a level of '{}'; {}",
                                       levels.begin()->second.front().string(), first.string(), accepted));
    writer.commit();
    return whole.picture;
}

} // namespace gabor::render
