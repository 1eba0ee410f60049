#include "render/texture.hpp"

#include "error.hpp"
#include "image/exr.hpp"
#include "render/material.hpp"
#include "render/parameters.hpp"
#include "render/pixels.hpp"

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <vector>

namespace gabor::render {

namespace {

bool is_power_of_two(int side) {
    return std::has_single_bit(static_cast<unsigned>(side));
}

bool same_extent(const Request& request, const image::Window& region) {
    return region.width == request.width && region.height == request.height;
}

} // namespace

void check_texture(const Request& request, const image::Window& region) {
    if (!std::holds_alternative<Plane>(request.view))
        throw RequestError("--texture is for the view flat");
    if (!is_power_of_two(region.width) || !is_power_of_two(region.height))
        throw RequestError(fmt::format("--texture of {} x {} pixels: each side must be a power of two",
                                       region.width, region.height));
    if (region.x % region.width != 0 || region.y % region.height != 0 || request.width % region.width != 0 ||
        request.height % region.height != 0)
        throw RequestError(
            fmt::format("--texture with the region {},{},{},{}: it must be one of equal tiles of the picture "
                        "of {} x {} pixels",
                        region.x, region.y, region.width, region.height, request.width, request.height));
}

FileTimes render_texture(const vulkan::Device& device, const Request& request, const image::Window& region,
                         const std::filesystem::path& path, const TextureFormat& format,
                         const std::function<void(std::uint64_t)>& advance) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const std::vector<std::string> names = channels(request);
    image::ExrTextureWriter writer(
        path, {.width = region.width,
               .height = region.height,
               .channels = names,
               .half = format.half,
               .periodic = std::get<Plane>(request.view).tileable && same_extent(request, region),
               .compression = format.compression,
               .parameters = to_json(request),
               .software = software(device)});

    FileTimes times;
    const auto write = [&](std::span<const float> values) {
        advance(values.size() / names.size());
        const Clock::time_point before = Clock::now();
        writer.write_rows(values);
        times.writing += seconds_since(before);
    };
    const auto pass =
        has_material(request) ? Material::make_pass(device, request) : Pixels::make_pass(device, request);
    const auto renderer_of = [&](const Request& here,
                                 const image::Window& window) -> std::unique_ptr<RegionRenderer> {
        if (has_material(here))
            return std::make_unique<Material>(here, window, pass);
        return std::make_unique<Pixels>(device, here, window, pass);
    };
    std::vector<float> line; // a level of a single row or column
    int level = 0;
    for (; (region.width >> level) > 0 && (region.height >> level) > 0; ++level) {
        // Pixel centres are at (i + 0.5) / scale, so that this is the same noise under larger pixels.
        Request here = request;
        here.width >>= level;
        here.height >>= level;
        here.scale = std::ldexp(request.scale, -level);
        line.clear();
        const bool is_line = std::min(region.width, region.height) >> level == 1;
        const image::Window window{region.x >> level, region.y >> level, region.width >> level,
                                   region.height >> level};
        const Times rendering = render_region(device, *renderer_of(here, window), here, window,
                                              [&](std::span<const float> values) {
                                                  write(values);
                                                  if (is_line)
                                                      line.insert(line.end(), values.begin(), values.end());
                                              });
        if (level == 0)
            times.rendering.first_dispatch = rendering.first_dispatch;
        times.rendering.waiting += rendering.waiting;
        times.rendering.gpu += rendering.gpu;
    }
    // A line's levels have pixels that are no longer squares: averages of two.
    for (; std::max(region.width, region.height) >> level > 0; ++level) {
        for (std::size_t i = 0; i < line.size() / 2; ++i) {
            const std::size_t pixel = i / names.size();
            const std::size_t first = 2 * pixel * names.size() + i % names.size();
            line[i] = (line[first] + line[first + names.size()]) / 2;
        }
        line.resize(line.size() / 2);
        write(line);
    }
    const Clock::time_point before = Clock::now();
    writer.commit();
    times.closing = seconds_since(before);
    return times;
}

} // namespace gabor::render
