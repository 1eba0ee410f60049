#include "viewer/canvas.hpp"

#include "seconds.hpp"

#include <algorithm>

namespace gabor::viewer {

ValueGrid::ValueGrid(const vulkan::Device& device)
    : device_(device), values_(device, 4, render::values_memory(device)) {}

void ValueGrid::start(const render::Renderer& renderer) {
    job_.reset();
    const render::Plan& plan = renderer.plan();
    extent_ = {plan.width, plan.height};
    count_ =
        static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(plan.height) * plan.channels.size();
    next_row_ = 0;
    const std::size_t bytes = count_ * sizeof(float);
    if (values_.size() < bytes) {
        values_ = vulkan::Buffer(device_, bytes, render::values_memory(device_));
        if (!device_.unified())
            staging_.emplace(device_, bytes, vulkan::Memory::readback);
    }
    job_.emplace(renderer.job(values_));
}

void ValueGrid::fill(const render::Renderer& renderer, int rows, double& cost) {
    const int first = next_row_;
    const int filled = std::min(rows, extent_.height - first);
    const bool whole = first + filled == extent_.height;
    std::optional<vulkan::Job::Copy> copy;
    if (staging_ && whole)
        copy.emplace(vulkan::Job::Copy{values_, *staging_, count_ * sizeof(float)});
    const Clock::time_point before = Clock::now();
    renderer.submit(*job_, {first, filled}, first * extent_.width, copy);
    job_->wait();
    next_row_ = whole ? -1 : first + filled;
    // Does not use the device's clock, because lavapipe stops it before the work is done.
    if (const double values = static_cast<double>(filled) * extent_.width; values >= 4096)
        cost = 0.7 * cost + 0.3 * std::max(seconds_since(before) / values, 1e-12);
}

std::span<const float> ValueGrid::read() {
    return (staging_ ? *staging_ : values_).as<float>().first(count_);
}

Canvas::Canvas(const vulkan::Device& device)
    : renderer_(device), grids_{ValueGrid(device), ValueGrid(device)} {}

void Canvas::load_paint(const std::string& path) {
    if (path != paint_path_)
        paint_ = render::load_paint(path);
    paint_path_ = path;
}

void Canvas::start(ValueGrid& grid, int stride) {
    renderer_.set(render::plan(drawing_.request, viewport_of(drawing_, camera_, extent_, stride), paint_,
                               render::kind_of(renderer_.device())));
    grid.start(renderer_);
}

bool Canvas::refine(const Drawing& drawing, const Camera& camera, Extent extent, double seconds) {
    ValueGrid& behind = grids_[1 - front_];
    if (stride_ == 0 || drawing != drawing_ || camera != camera_ || extent != extent_) {
        load_paint(drawing.request.paint);
        const double whole = cost_ * extent.width * extent.height;
        const int coarsest = coarsest_stride(drawing, paint_, camera.zoom);
        int stride = 1;
        while (stride < coarsest && whole / (stride * stride) > seconds)
            stride *= 2;
        draw(drawing, camera, extent, stride);
        return stride > 1;
    }
    if (stride_ <= 1)
        return false;
    const int next = std::max(stride_ / 4, 1); // halving would compute a quarter more values
    if (!behind.filling())
        start(behind, next);
    constexpr int least_rows = 8; // those of a work group
    const double rows = seconds / (cost_ * behind.extent().width);
    behind.fill(renderer_, std::max(least_rows, static_cast<int>(std::min(rows, 1e5))), cost_);
    if (!behind.filling()) {
        stride_ = next;
        front_ = 1 - front_;
    }
    return stride_ > 1;
}

void Canvas::draw(const Drawing& drawing, const Camera& camera, Extent extent, int stride) {
    load_paint(drawing.request.paint);
    drawing_ = drawing;
    camera_ = camera;
    extent_ = extent;
    ValueGrid& behind = grids_[1 - front_];
    start(behind, stride);
    behind.fill(renderer_, behind.extent().height, cost_);
    channels_ = renderer_.plan().channels;
    stride_ = stride;
    front_ = 1 - front_;
}

} // namespace gabor::viewer
