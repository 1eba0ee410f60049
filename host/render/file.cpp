#include "render/file.hpp"

#include "image/exr.hpp"
#include "image/png.hpp"
#include "render/material.hpp"
#include "render/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace gabor::render {

namespace {

float as_is(float value) {
    return value;
}

} // namespace

float srgb(float light) {
    light = std::clamp(light, 0.0f, 1.0f);
    return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

std::string software(const vulkan::Device& device) {
    return fmt::format("gabor {}, {}, {}", GABOR_VERSION, device.info().name, device.info().driver);
}

FileTimes& FileTimes::operator+=(const FileTimes& other) {
    rendering.waiting += other.rendering.waiting;
    rendering.gpu += other.rendering.gpu;
    writing += other.writing;
    closing += other.closing;
    return *this;
}

FileTimes render_file(const vulkan::Device& device, const Request& request, const image::Window& region,
                      const Files& files, const std::function<void(std::uint64_t)>& advance) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const std::vector<std::string> names = channels(request);
    std::optional<image::ExrWriter> exr;
    if (files.exr)
        exr.emplace(*files.exr,
                    image::ExrWriter::Description{
                        .picture = {0, 0, request.width, request.height},
                        .window = region,
                        .channels = names,
                        .compression = files.compression,
                        .parameters = to_json(request),
                        .software = software(device) + (files.code.empty() ? "" : ", with other shaders")});
    // Colour, where there are as many noises; of a material its look.
    const bool coloured = files.colours || has_material(request) || request.colour || request.values >= 3;
    const std::size_t colours = coloured ? 3 : 1;
    const std::size_t first = has_material(request) ? material_channels.size() - colours : 0;
    const auto show = has_material(request) ? srgb : request.colour ? as_is : unorm;
    std::optional<image::PngWriter> png;
    if (files.png)
        png.emplace(*files.png, region.width, region.height, static_cast<int>(colours));

    FileTimes times;
    std::vector<float> shown;
    times.rendering = render_region(
        device, request, region,
        [&](std::span<const float> values) {
            advance(values.size() / names.size());
            const Clock::time_point before = Clock::now();
            if (exr)
                exr->write_rows(values);
            if (png && files.colours) {
                png->write_rows(files.colours(values));
            } else if (png) {
                shown.clear();
                for (std::size_t i = 0; i < values.size(); i += names.size())
                    for (std::size_t k = first; k < first + colours; ++k)
                        shown.push_back(show(values[i + k]));
                png->write_rows(shown);
            }
            times.writing += seconds_since(before);
        },
        files.code);
    advance(0);
    const Clock::time_point before = Clock::now();
    if (exr)
        exr->commit();
    if (png)
        png->commit();
    times.closing = seconds_since(before);
    return times;
}

} // namespace gabor::render
