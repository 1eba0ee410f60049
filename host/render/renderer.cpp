#include "render/renderer.hpp"

#include "render/bake.hpp"
#include "render/material.hpp"
#include "render/pixels.hpp"
#include "render/solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>

namespace gabor::render {

namespace {

constexpr std::size_t band_bytes = std::size_t{16} << 20;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// A band's memory on the device, and the job that fills it.
class BandBuffer {
  public:
    BandBuffer(const vulkan::Device& device, const RegionRenderer& renderer, std::size_t bytes)
        : result_(device, bytes, device.unified() ? vulkan::Memory::readback : vulkan::Memory::device),
          job_(renderer.job(device, result_)) {
        if (!device.unified())
            staging_.emplace(device, bytes, vulkan::Memory::readback);
    }

    void submit(const RegionRenderer& renderer, const RegionRenderer::Band& band, std::size_t values) {
        values_ = values;
        std::optional<vulkan::Job::Copy> copy;
        if (staging_)
            copy.emplace(vulkan::Job::Copy{result_, *staging_, values * sizeof(float)});
        renderer.submit(job_, band, copy);
    }

    double wait() { return job_.wait(); }
    std::span<const float> values() const {
        return (staging_ ? *staging_ : result_).as<float>().first(values_);
    }

  private:
    vulkan::Buffer result_;
    std::optional<vulkan::Buffer> staging_; // where the host cannot read the device's memory
    vulkan::Job job_;
    std::size_t values_ = 0;
};

} // namespace

Axis axis_along(const Request& request, int side, double radius) {
    const double cells = double{drawing_recipe(request).radius};
    const Plane* plane = std::get_if<Plane>(&request.view);
    if (!plane || !plane->tileable)
        return {cells, 0};
    const double scale = request.scale * radius;
    const double period = std::floor(side / scale * cells);
    return {period / side * scale, static_cast<std::int32_t>(period)};
}

float wrapped_time(const Request& request) {
    return static_cast<float>(request.time - std::floor(request.time));
}

std::vector<RegionRenderer::Band> RegionRenderer::bands_of_rows(int height, int most_rows) {
    std::vector<Band> bands;
    for (int row = 0; row < height; row += most_rows)
        bands.push_back({row, std::min(most_rows, height - row)});
    return bands;
}

std::string pass_of(const Request& request) {
    if (has_material(request)) {
        std::string function = request.material;
        std::ranges::replace(function, '-', '_');
        return "passes/material.comp@" + function;
    }
    if (Bake::can_fill(request))
        return recipe_pass("bake", drawing_recipe(request));
    return in_space(request) ? solid_pass(request) : recipe_pass("pixels", request.recipe);
}

std::unique_ptr<RegionRenderer> make_renderer(const vulkan::Device& device, const Request& request,
                                              const image::Window& region, Code code) {
    if (has_material(request))
        return std::make_unique<Material>(device, request, region, code);
    if (Bake::can_fill(request))
        return std::make_unique<Bake>(device, request, region, code);
    if (in_space(request))
        return std::make_unique<Solid>(device, request, region, code);
    return std::make_unique<Pixels>(device, request, region, code);
}

Times render_region(const vulkan::Device& device, const Request& request, const image::Window& region,
                    const std::function<void(std::span<const float>)>& sink, Code code) {
    const Clock::time_point start = Clock::now();
    const std::unique_ptr<RegionRenderer> renderer = make_renderer(device, request, region, code);
    const double ready = seconds_since(start);
    Times times = render_region(device, *renderer, request, region, sink);
    times.first_dispatch += ready;
    return times;
}

Times render_region(const vulkan::Device& device, const RegionRenderer& renderer, const Request& request,
                    const image::Window& region, const std::function<void(std::span<const float>)>& sink) {
    const Clock::time_point start = Clock::now();
    const std::size_t row_values = static_cast<std::size_t>(region.width) * channels(request).size();
    const std::size_t limit = std::min<std::size_t>(band_bytes, device.info().storage_buffer);
    const int fitting = std::max(1, static_cast<int>(limit / (row_values * sizeof(float))));
    const std::vector<RegionRenderer::Band> bands = renderer.bands(fitting);
    const auto values = [&](const RegionRenderer::Band& band) {
        return static_cast<std::size_t>(band.rows) * row_values;
    };
    const int most_rows = std::ranges::max(bands, {}, &RegionRenderer::Band::rows).rows;
    const std::size_t bytes = static_cast<std::size_t>(most_rows) * row_values * sizeof(float);
    std::array<BandBuffer, 2> buffers{BandBuffer(device, renderer, bytes),
                                      BandBuffer(device, renderer, bytes)};

    Times times;
    buffers[0].submit(renderer, bands[0], values(bands[0]));
    times.first_dispatch = seconds_since(start);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const Clock::time_point before = Clock::now();
        times.gpu += buffers[i % 2].wait();
        times.waiting += seconds_since(before);
        if (i + 1 < bands.size())
            buffers[(i + 1) % 2].submit(renderer, bands[i + 1], values(bands[i + 1]));
        sink(buffers[i % 2].values());
    }
    return times;
}

} // namespace gabor::render
