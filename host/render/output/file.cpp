#include "render/output/file.hpp"

#include "error.hpp"
#include "image/png.hpp"
#include "render/request/material.hpp"
#include "render/request/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gabor::render {

namespace {

// Returns the number of channels in the PNG: 1 or 3.
int displayed_channels(const Request& request) {
    return is_surface(request.kind) || request.colour ? 3 : 1;
}

// Converts pixels to what a PNG shows, as values from 0 to 1: grey noise, colours from three noises or a
// photograph, or the lit material.
void to_display(const Request& request, std::span<const float> values, std::vector<float>& shown) {
    const std::size_t channels = render::channels(request).size();
    const auto kept = static_cast<std::size_t>(displayed_channels(request));
    const std::size_t first = is_surface(request.kind) ? passes::material_lit : 0;
    shown.clear();
    for (std::size_t i = 0; i < values.size(); i += channels)
        for (std::size_t k = i + first; k < i + first + kept; ++k)
            shown.push_back(is_surface(request.kind) ? srgb(values[k])
                            : request.colour         ? values[k]
                                                     : unorm(values[k]));
}

} // namespace

float srgb(float light) {
    light = std::clamp(light, 0.0f, 1.0f);
    return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

Request frame_of(Request request, int frame, int frames) {
    const double share = static_cast<double>(frame) / frames;
    if (request.kind == Kind::sea)
        request.sea.seconds += request.sea.loop_seconds > 0 ? request.sea.loop_seconds * share : frame / 25.0;
    else
        request.evolution += share;
    return request;
}

std::filesystem::path frame_path(const std::filesystem::path& path, int frame, int frames) {
    if (frames == 1)
        return path;
    return path.parent_path() /
           fmt::format("{}.{:04}{}", path.stem().string(), frame + 1, path.extension().string());
}

std::string software(const vulkan::Device& device) {
    return fmt::format("gabor {}, {}, {}", GABOR_VERSION, device.info().name, device.info().driver);
}

image::ExrHeader exr_header(const Request& request, const image::Rect& region, const std::string& software) {
    // Materials, terrain and seas are linear, a fit has the colour space of its photograph, and noise has
    // none.
    const bool linear = is_surface(request.kind) || (request.colour && request.colour->linear);
    return {.picture = {0, 0, request.width, request.height},
            .window = region,
            .channels = channels(request),
            .parameters = to_json(request),
            .software = software,
            .colour_space = linear           ? "lin_rec709"
                            : request.colour ? "sRGB"
                                             : ""};
}

void render_file(const vulkan::Device& device, const Request& request, const image::Rect& region,
                 const Files& files, const image::Advance& advance) {
    image::ExrHeader header = exr_header(request, region, software(device));
    header.compression = files.compression;
    const std::size_t kept = header.channels.size();
    const std::size_t channels = render::channels(request, files.normals).size();
    std::optional<image::ExrWriter> exr;
    if (files.exr)
        exr.emplace(*files.exr, header);
    std::optional<image::PngWriter> png;
    if (files.png)
        png.emplace(*files.png, region.width, region.height, files.colours ? 3 : displayed_channels(request));

    std::optional<HeightWriter> heights;
    if (files.heightmap) {
        if (request.kind != Kind::terrain || !request.view.is_flat())
            throw RequestError("--write-heightmap needs --view terrain");
        const double unit = terrain_unit(request);
        const double reach = unit * (hill_reach + erosion_reach(request));
        const double pixel = unit / request.scale;
        heights.emplace(
            *files.heightmap, region,
            HeightFormat{.elevation = files.elevation.value_or(Elevation{-reach, reach}),
                         .full_range = files.full_range,
                         .pixel = {pixel, pixel},
                         .missing = {},
                         .geo = image::moved(image::plain_tags({pixel, pixel}), region.x, region.y),
                         .exr = header});
    }

    std::vector<float> shown;
    std::vector<float> without_normals;
    const auto write = [&](std::span<const float> values) {
        advance(values.size() / channels);
        if (exr && files.normals) { // drops the normals, which precede the last channel
            without_normals.clear();
            for (std::size_t i = 0; i < values.size(); ++i)
                if (i % channels < kept - 1 || i % channels == channels - 1)
                    without_normals.push_back(values[i]);
            exr->write_rows(without_normals);
        } else if (exr) {
            exr->write_rows(values);
        }
        if (heights)
            heights->write_rows(values, channels, passes::terrain_height);
        if (png && files.colours) {
            png->write_rows(files.colours(values));
        } else if (png) {
            to_display(request, values, shown);
            png->write_rows(shown);
        }
    };
    render_region(device, request, region, write, files.normals);
    advance(0);
    if (exr)
        exr->commit();
    if (png)
        png->commit();
    if (heights)
        heights->commit();
}

} // namespace gabor::render
