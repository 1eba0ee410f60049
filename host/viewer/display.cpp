#include "viewer/display.hpp"

#include "noise/spectrum.hpp"
#include "render/output/file.hpp"
#include "render/output/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "display_comp.h"

namespace gabor::viewer {

namespace {

// Values of output_shown in shaders/viewer/display.glsl that follow those of the enum Output: a picture in
// colour, and the first Look of a material.
constexpr std::int32_t coloured = 8;
constexpr std::int32_t first_look = 9;

// The channel that an output needs besides the noise. For a vector, the channel of its first component.
std::string_view companion(Output output) {
    switch (output) {
    case Output::gradient:
    case Output::lit:
        return "gradient.x";
    case Output::phase:
    case Output::intensity:
    case Output::phasor:
    case Output::lit_phasor:
        return "quadrature";
    case Output::variance:
        return "removed";
    case Output::value:
        break;
    }
    return "Y";
}

} // namespace

DisplayConstants display_constants(const Document& document, std::span<const std::string> channels,
                                   bool coarse, bool tiles, bool unlit) {
    const bool material = render::is_surface(document.request.kind);
    const int beside = render::channel_index(channels, material ? "slope.x" : companion(document.output));
    // Without a filter, all of the variance is left.
    const bool there = beside >= 0 || document.output == Output::variance;
    const bool colour = channels.front() == "R";
    const auto shown = material ? first_look + static_cast<std::int32_t>(document.look)
                       : colour ? coloured
                                : static_cast<std::int32_t>(there ? document.output : Output::value);
    DisplayConstants constants{};
    constants[passes::display_output_id] = shown;
    constants[passes::display_colours_id] = document.colours;
    constants[passes::display_channels_id] = static_cast<std::int32_t>(channels.size());
    constants[passes::display_companion_id] = std::max(beside, 0);
    constants[passes::display_normal_id] = render::channel_index(channels, "normal.x");
    constants[passes::display_coverage_id] = render::channel_index(channels, "A");
    constants[passes::display_coarse_id] = coarse;
    constants[passes::display_tiles_id] = tiles;
    constants[passes::display_profile_id] = document.profile;
    constants[passes::display_unlit_id] = unlit;
    constants[passes::display_environment_id] = document.request.environment;
    return constants;
}

DisplayConstants colours_constants() {
    DisplayConstants constants{};
    constants[passes::display_output_id] = coloured;
    constants[passes::display_channels_id] = 3;
    constants[passes::display_normal_id] = constants[passes::display_coverage_id] = -1; // none
    constants[passes::display_coarse_id] = true;
    return constants;
}

std::array<std::array<float, 4>, most_stops> stops_of(const Document& document) {
    std::array<std::array<float, 4>, most_stops> stops{};
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const auto& [at, colour] = document.ramp[std::min(i, document.ramp.size() - 1)];
        std::ranges::transform(
            std::array{colour[0], colour[1], colour[2], at}, stops[i].begin(),
            [](float part) { return std::round(255 * std::clamp(part, 0.0f, 1.0f)) / 255; });
    }
    return stops;
}

passes::DisplayPush display_push(const Document& document, double stride, double zoom) {
    passes::DisplayPush push{};
    push.stride = 1;
    push.contrast = document.contrast;
    const auto [right, down] = render::light_direction(document.request);
    push.lamp = {static_cast<float>(right), static_cast<float>(down)};
    push.deviation = static_cast<float>(slope_deviation(document.request));
    push.spacing = static_cast<float>(stride / (document.request.scale * zoom));
    if (document.request.kind == render::Kind::terrain) {
        const auto unit = static_cast<float>(render::terrain_unit(document.request));
        push.spacing *= unit;
        push.contrast *= 10 * unit; // mountains are ten times as high as the relief of materials
    }
    push.green = document.directx_normals ? -1.0f : 1.0f;
    push.turns = static_cast<float>(stripe_turns(document.request) / zoom);
    std::array<std::uint32_t, most_stops> stops{};
    std::ranges::transform(stops_of(document), stops.begin(), [](const std::array<float, 4>& stop) {
        const auto byte = [&](std::size_t part) {
            return static_cast<std::uint32_t>(std::lround(255 * stop[part]));
        };
        return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
    });
    push.ramp_low = {stops[0], stops[1], stops[2], stops[3]};
    push.ramp_high = {stops[4], stops[5], stops[6], stops[7]};
    return push;
}

double stripe_turns(const render::Request& request) {
    return request.lobes.front().frequency / request.scale;
}

double slope_deviation(const render::Request& request) {
    double variance = 0;
    for (const noise::Wave& wave : noise::waves(request.lobes, request.seed))
        variance += wave.share * std::pow(2 * std::numbers::pi * wave.frequency, 2) / 2;
    return std::sqrt(variance);
}

std::string reading(const Document& document, std::array<double, 2> from_middle,
                    std::span<const std::string> channels, std::span<const float> values) {
    const render::Request& request = document.request;
    // Outside a body, the coverage is 0; in the sky, all channels are 0.
    const auto covered = std::ranges::find(channels, "A") - channels.begin();
    const auto first = static_cast<std::size_t>(covered < std::ssize(values) ? covered : 0);
    if (!request.view.is_flat() && values[first] == 0)
        return {};
    std::string text;
    if (request.view.is_flat()) {
        const double scale = request.scale * document.camera.zoom;
        const auto place = [&](const Coordinate& middle, double from) {
            return static_cast<double>(middle.whole) + middle.part + from / scale;
        };
        text = fmt::format("at {:.2f}, {:.2f}", place(document.camera.x, from_middle[0]),
                           place(document.camera.y, from_middle[1]));
    }
    std::size_t i = 0;
    if (channels.front() == "R") {
        const bool linear = render::is_surface(request.kind);
        std::array<float, 3> shown{};
        for (; i < shown.size(); ++i)
            shown[i] = linear ? render::srgb(values[i]) : values[i];
        text += (text.empty() ? "" : "\n") + hex(shown);
    }
    for (; i < channels.size(); ++i)
        if (channels[i].find('.') == std::string::npos && channels[i] != "A") // skips components of vectors
            text += fmt::format("{}{} {:.3g}", text.empty() ? "" : "\n",
                                channels[i] == "Y" ? "value" : channels[i], values[i]);
    return text;
}

bool shows_plainly(const Document& document) {
    if (render::is_surface(document.request.kind))
        return document.look == Look::lit;
    if (document.request.colour && !document.request.view.in_space())
        return true;
    return document.output == Output::value && document.colours == 0 &&
           document.contrast == Document().contrast && !document.request.view.in_space();
}

FileColours::FileColours(const vulkan::Device& device, const Document& document,
                         std::span<const std::string> channels, bool unlit)
    : device_(device), pass_(device, display_comp_spirv, {2, sizeof(passes::DisplayPush)},
                             std::bit_cast<std::array<std::uint32_t, std::tuple_size_v<DisplayConstants>>>(
                                 display_constants(document, channels, false, false, unlit))),
      push_(display_push(document, 1, 1)), channels_(channels.size()),
      values_(device, 4, vulkan::Memory::upload), colours_(device, 4, vulkan::Memory::readback) {
    push_.grid = {document.request.width, document.request.height};
    push_.size = {static_cast<float>(push_.grid.x), static_cast<float>(push_.grid.y)};
}

std::span<const float> FileColours::of(std::span<const float> values) {
    const std::size_t pixels = values.size() / channels_;
    const std::size_t row = channels_ * static_cast<std::size_t>(push_.grid.x);
    if (values_.size() < values.size_bytes() + row * sizeof(float)) {
        values_ = vulkan::Buffer(device_, values.size_bytes() + row * sizeof(float), vulkan::Memory::upload);
        colours_ = vulkan::Buffer(device_, pixels * 3 * sizeof(float), vulkan::Memory::readback);
    }
    const std::span<const float> above = push_.first_row == 0 ? values.first(row) : std::span(last_row_);
    std::ranges::copy(above, values_.as<float>().begin());
    std::ranges::copy(values, values_.as<float>().begin() + static_cast<std::ptrdiff_t>(row));
    last_row_.assign(values.end() - static_cast<std::ptrdiff_t>(row), values.end());
    push_.count = static_cast<int>(pixels);
    vulkan::Job job(device_, pass_, {values_, colours_});
    job.submit(push_,
               {(static_cast<std::uint32_t>(pixels) + passes::display_group - 1) / passes::display_group});
    job.wait();
    push_.first_row = (push_.first_row + push_.count / push_.grid.x) % push_.grid.y; // 0 starts a new picture
    return colours_.as<float>().first(3 * pixels);
}

} // namespace gabor::viewer
