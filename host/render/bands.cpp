#include "render/bands.hpp"

#include "noise/variance.hpp"
#include "vulkan/pass.hpp"

#include "passes/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

namespace gabor::render {

namespace {

constexpr std::size_t band_bytes = std::size_t{16} << 20;
constexpr int block_rows = 32;     // the most rows that one EXR compression block holds
constexpr std::uint32_t group = 8; // local_size of passes/render.comp

struct Place {
    std::int32_t cell;
    float local;
};

struct Push {
    float wave_x;
    float wave_y;
    float amplitude;
    std::uint32_t seed;
    std::uint32_t width;
    std::uint32_t first_row;
    std::uint32_t row_count;
};

// The places of pixels first, first + 1, ... along one axis.
vulkan::Buffer place_table(const vulkan::Device& device, int first, int count, double cells_per_pixel) {
    vulkan::Buffer table(device, static_cast<std::size_t>(count) * sizeof(Place), vulkan::Memory::upload);
    const std::span<Place> places = table.as<Place>();
    for (int i = 0; i < count; ++i) {
        const double position = (first + i + 0.5) * cells_per_pixel;
        const double cell = std::floor(position);
        places[static_cast<std::size_t>(i)] = {static_cast<std::int32_t>(cell),
                                               static_cast<float>(position - cell)};
    }
    return table;
}

// A band's memory on the device, and the job that fills it.
struct Band {
    vulkan::Buffer result;
    std::optional<vulkan::Buffer> staging; // where the host cannot read the device's memory
    vulkan::Job job;

    Band(const vulkan::Device& device, const vulkan::Pass& pass, const vulkan::Buffer& columns,
         const vulkan::Buffer& rows, std::size_t bytes)
        : result(device, bytes, device.unified() ? vulkan::Memory::readback : vulkan::Memory::device),
          job(device, pass, {columns, rows, result}) {
        if (!device.unified())
            staging.emplace(device, bytes, vulkan::Memory::readback);
    }

    void submit(const Push& push) {
        const vulkan::Groups groups{(push.width + group - 1) / group, (push.row_count + group - 1) / group};
        std::optional<vulkan::Job::Copy> copy;
        if (staging)
            copy.emplace(vulkan::Job::Copy{result, *staging, std::size_t{4} * push.width * push.row_count});
        job.submit(push, groups, copy);
    }

    const float* pixels() const { return (staging ? *staging : result).as<float>().data(); }
};

} // namespace

std::array<std::uint32_t, 7> recipe_constants(const noise::Recipe& recipe) {
    using vulkan::constant;
    return {constant(recipe.impulses), constant(recipe.radius),    constant(recipe.weight_floor),
            constant(recipe.phases),   constant(recipe.window[0]), constant(recipe.window[1]),
            constant(recipe.window[2])};
}

Times render_bands(const vulkan::Device& device, const Picture& picture, const image::Window& region,
                   const std::function<void(std::span<const float>)>& sink) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const noise::Recipe& recipe = noise::find_recipe(picture.recipe);
    const vulkan::Pass pass(device, render_spirv, {3, sizeof(Push)}, recipe_constants(recipe));

    const double cells_per_pixel = recipe.radius / picture.scale;
    const vulkan::Buffer columns = place_table(device, region.x, region.width, cells_per_pixel);
    const vulkan::Buffer rows = place_table(device, region.y, region.height, cells_per_pixel);

    const std::size_t row_bytes = 4 * static_cast<std::size_t>(region.width);
    const std::size_t limit = std::min<std::size_t>(band_bytes, device.info().storage_buffer);
    const int fitting = static_cast<int>(limit / row_bytes) / block_rows * block_rows;
    const int band_rows = std::min(region.height, std::max(block_rows, fitting));
    std::array<Band, 2> bands{Band(device, pass, columns, rows, band_rows * row_bytes),
                              Band(device, pass, columns, rows, band_rows * row_bytes)};

    const double radians = std::remainder(picture.orientation, 360.0) * std::numbers::pi / 180;
    Push push{};
    push.wave_x = static_cast<float>(picture.frequency * std::cos(radians));
    push.wave_y = static_cast<float>(picture.frequency * std::sin(radians));
    push.amplitude = static_cast<float>(1 / std::sqrt(noise::variance(recipe, picture.frequency, radians)));
    push.seed = picture.seed;
    push.width = static_cast<std::uint32_t>(region.width);

    const auto height_at = [&](int row) { return std::min(band_rows, region.height - row); };
    const auto submit = [&](Band& band, int row) {
        push.first_row = static_cast<std::uint32_t>(row);
        push.row_count = static_cast<std::uint32_t>(height_at(row));
        band.submit(push);
    };

    Times times;
    submit(bands[0], 0);
    times.first_dispatch = std::chrono::duration<double>(Clock::now() - start).count();
    std::size_t current = 0;
    for (int row = 0; row < region.height; row += band_rows, current ^= 1) {
        Band& band = bands[current];
        times.gpu += band.job.wait();
        if (row + band_rows < region.height)
            submit(bands[current ^ 1], row + band_rows);
        sink({band.pixels(),
              static_cast<std::size_t>(height_at(row)) * static_cast<std::size_t>(region.width)});
    }
    return times;
}

} // namespace gabor::render
