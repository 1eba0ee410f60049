#include "viewer/preset_pictures.hpp"

#include "render/file.hpp"
#include "vulkan/device.hpp"

#include <algorithm>

namespace gabor::viewer {

namespace {

constexpr double least_pixels_per_wave = 4;

} // namespace

render::Request miniature(const render::Request& request, int side) {
    render::Request small = request;
    small.width = small.height = side;
    small.scale = request.scale * side / request.width;
    if (!render::has_material(request))
        for (const noise::Lobe& lobe : request.lobes)
            small.scale =
                std::max(small.scale, least_pixels_per_wave * lobe.frequency * (1 + lobe.frequency_spread));
    return small;
}

void PresetPictures::begin() {
    if (!colours_.empty())
        return;
    const Extent all = extent();
    colours_.assign(
        std::size_t{3} * static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height), 0);
    work_.start([this] { work(); }); // if it fails, presets show only their names
}

Extent PresetPictures::extent() {
    const int rows = (static_cast<int>(render::presets().size()) + columns - 1) / columns;
    return {columns * cell, rows * cell};
}

std::vector<float> PresetPictures::colours() const {
    const std::lock_guard lock(mutex_);
    return colours_;
}

void PresetPictures::work() {
    const vulkan::Device device(selector_);
    std::vector<float> shown;
    for (const render::Preset& preset : render::presets()) {
        const render::Request small = miniature(render::preset(preset.name), side);
        const auto channels = static_cast<std::size_t>(render::shown_channels(small));
        const auto index = static_cast<int>(drawn_);
        const int left = index % columns * cell + (cell - side) / 2;
        int row = index / columns * cell + (cell - side) / 2;
        render::render_region(device, small, {0, 0, side, side}, [&](std::span<const float> values) {
            work_.advance(0);
            render::show(small, values, shown);
            const std::lock_guard lock(mutex_);
            for (std::size_t i = 0; i < shown.size() / channels; ++i) {
                const auto column = static_cast<int>(i % side);
                float* const to =
                    &colours_[3 * static_cast<std::size_t>(row * extent().width + left + column)];
                for (std::size_t c = 0; c < 3; ++c)
                    to[c] = std::clamp(shown[i * channels + c % channels], 0.0f, 1.0f);
                row += column + 1 == side;
            }
        });
        ++drawn_;
    }
}

} // namespace gabor::viewer
