#include "viewer/canvas.hpp"

#include "viewer/shader_compiler.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace gabor::viewer {

namespace {

constexpr int rows_at_once = 8; ///< at least, of the passes' groups
constexpr int sample_columns = 256;
constexpr int most_sample_rows = 256;

vulkan::Memory result_memory(const vulkan::Device& device) {
    return device.unified() ? vulkan::Memory::readback : vulkan::Memory::device;
}

template <typename T>
void upload(const vulkan::Device& device, vulkan::Buffer& buffer, const std::vector<T>& values) {
    const std::size_t bytes = values.size() * sizeof(T);
    if (buffer.size() < bytes)
        buffer = vulkan::Buffer(device, bytes, vulkan::Memory::upload);
    std::ranges::copy(values, buffer.as<T>().begin());
}

// The buffers and the push constants of the passes.
vulkan::Pass::Interface interface_of(const NoisePass& noise) {
    if (render::has_material(noise.request))
        return {1, sizeof(passes::MaterialPush)};
    if (render::in_space(noise.request))
        return {3, sizeof(passes::SolidPush)};
    if (noise.block)
        return {5, sizeof(passes::BakePush)};
    return {6, sizeof(passes::PixelsPush)};
}

template <typename... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>; // clang 14 does not guess it

vulkan::Pass make_pass(const vulkan::Device& device, const NoisePass& noise) {
    return {device, compile_shader(noise.shader), interface_of(noise), noise.constants};
}

static_assert(passes::pixels_group == passes::solid_group && passes::pixels_group == passes::material_group);

} // namespace

void Cost::add(double seconds, double values) {
    if (values >= 4096)
        cost_ = 0.7 * cost_ + 0.3 * std::max(seconds / values, 1e-12);
}

ValueGrid::ValueGrid(const vulkan::Device& device, int channels)
    : device_(device), channels_(channels), values_(device, 4, result_memory(device)),
      columns_(device, 8, vulkan::Memory::upload), rows_(device, 8, vulkan::Memory::upload),
      waves_(device, 8, vulkan::Memory::upload),
      colour_(device, sizeof(passes::PixelsColour), vulkan::Memory::upload) {}

std::size_t ValueGrid::count() const {
    return static_cast<std::size_t>(input_.grid.width) * static_cast<std::size_t>(input_.grid.height) *
           static_cast<std::size_t>(channels_);
}

void ValueGrid::start(const vulkan::Pass& pass, GridInput input, const vulkan::Buffer& paint) {
    job_.reset();
    input_ = std::move(input);
    next_row_ = 0;
    const std::size_t bytes = count() * sizeof(float);
    if (values_.size() < bytes) {
        values_ = vulkan::Buffer(device_, bytes, result_memory(device_));
        if (!device_.unified())
            staging_.emplace(device_, bytes, vulkan::Memory::readback);
    }
    const auto lines = [&](const auto& of) {
        upload(device_, columns_, of.columns);
        upload(device_, rows_, of.rows);
        upload(device_, waves_, of.waves);
    };
    vulkan::Job::Buffers buffers;
    std::visit(Overloaded{[&](const PixelsInput& of) {
                              lines(of);
                              upload(device_, colour_, std::vector{of.colour});
                              buffers = {columns_, rows_, waves_, paint, colour_, values_};
                          },
                          [&](const SolidInput& of) {
                              upload(device_, waves_, of.waves);
                              upload(device_, colour_, std::vector{of.colour});
                              buffers = {waves_, values_, colour_};
                          },
                          [&](const MaterialInput&) { buffers = {values_}; },
                          [&](const render::BakeTables& of) {
                              lines(of);
                              buffers = {columns_, rows_, waves_, values_, colour_};
                          }},
               input_.of);
    job_.emplace(device_, pass, buffers);
}

void ValueGrid::fill(int rows, Cost& cost) {
    using Clock = std::chrono::steady_clock;
    const int first = next_row_;
    const int filled = std::min(rows, input_.grid.height - first);
    const bool whole = first + filled == input_.grid.height;
    std::optional<vulkan::Job::Copy> copy;
    if (staging_ && whole)
        copy.emplace(vulkan::Job::Copy{values_, *staging_, count() * sizeof(float)});
    const Clock::time_point before = Clock::now();
    const int before_first = first * input_.grid.width;
    const auto pushed = [&](auto push) {
        push.width = input_.grid.width;
        push.height = filled;
        push.first_row += first;
        push.before = before_first;
        job_->submit(
            push,
            {render::groups(push.width, passes::pixels_group), render::groups(filled, passes::pixels_group)},
            copy);
    };
    std::visit(Overloaded{[&](const render::BakeTables& of) {
                              of.submit(*job_, {first, filled}, before_first, copy);
                          },
                          [&](const auto& of) { pushed(of.push); }},
               input_.of);
    job_->wait();
    next_row_ = whole ? -1 : first + filled;
    // Not by the device's own clock: lavapipe stops it before the work is done.
    cost.add(std::chrono::duration<double>(Clock::now() - before).count(),
             static_cast<double>(filled) * input_.grid.width);
}

std::span<const float> ValueGrid::read() {
    return (staging_ ? *staging_ : values_).as<float>().first(count());
}

Canvas::Canvas(const vulkan::Device& device, const NoisePass& noise)
    : noise_(noise), paint_(render::load_paint(noise.request.paint)),
      paint_samples_(render::upload(device, paint_.samples)), device_(device),
      pass_(make_pass(device, noise)), grids_{ValueGrid(device, noise.channel_count()),
                                              ValueGrid(device, noise.channel_count())} {}

void Canvas::start(ValueGrid& grid, int stride) {
    grid.start(pass_, view_grid(noise_, camera_, extent_, stride, paint_), paint_samples_);
}

bool Canvas::refine(const NoisePass& noise, const Camera& camera, Extent extent, double seconds) {
    ValueGrid& behind = grids_[1 - front_];
    if (stride_ == 0 || noise != noise_ || camera != camera_ || extent != extent_) {
        noise_ = noise;
        const double whole = cost_.per_value() * extent.width * extent.height;
        const int coarsest = coarsest_stride(noise, paint_, camera.zoom);
        int stride = 1;
        while (stride < coarsest && whole / (stride * stride) > seconds)
            stride *= 2;
        draw(camera, extent, stride);
        return stride > 1;
    }
    if (stride_ <= 1)
        return false;
    if (!behind.filling())
        start(behind, stride_ / 2);
    const double rows = seconds / (cost_.per_value() * behind.extent().width);
    behind.fill(std::max(rows_at_once, static_cast<int>(std::min(rows, 1e5))), cost_);
    if (!behind.filling()) {
        stride_ /= 2;
        front_ = 1 - front_;
    }
    return stride_ > 1;
}

void Canvas::draw(const Camera& camera, Extent extent, int stride) {
    ValueGrid& behind = grids_[1 - front_];
    camera_ = camera;
    extent_ = extent;
    start(behind, stride);
    behind.fill(behind.extent().height, cost_);
    stride_ = stride;
    front_ = 1 - front_;
}

ValueSampler::ValueSampler(const vulkan::Device& device, NoisePass noise)
    : noise_(std::move(noise)), no_paint_(render::upload(device, render::Paint().samples)),
      pass_(make_pass(device, noise_)), grid_(device, noise_.channel_count()) {}

std::span<const float> ValueSampler::sample(std::uint32_t draw, double seconds) {
    const int rows = std::clamp(static_cast<int>(seconds / (cost_.per_value() * sample_columns)),
                                rows_at_once, most_sample_rows);
    grid_.start(pass_, random_grid(noise_, {sample_columns, rows}, draw), no_paint_);
    grid_.fill(rows, cost_);
    return grid_.read();
}

} // namespace gabor::viewer
