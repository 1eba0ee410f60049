#include "viewer/canvas.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace gabor::viewer {

namespace {

constexpr std::uint32_t group = 8; // local_size of shaders/viewer/grid.glsl
constexpr int coarsest_stride = 16;
constexpr int sample_columns = 1024;
constexpr int most_sample_rows = 256;

bool same(const Canvas::Request& a, const Canvas::Request& b) {
    return std::memcmp(&a.push, &b.push, sizeof a.push) == 0 && a.camera == b.camera && a.scale == b.scale &&
           a.extent == b.extent;
}

vulkan::Memory result_memory(const vulkan::Device& device) {
    return device.unified() ? vulkan::Memory::readback : vulkan::Memory::device;
}

} // namespace

Canvas::Grid::Grid(const vulkan::Device& device)
    : values(device, 4, result_memory(device)), places(device, 8, vulkan::Memory::upload) {}

void Canvas::Grid::resize(const vulkan::Device& device, const vulkan::Pass& pass, std::size_t bytes,
                          std::size_t axes) {
    job.reset();
    if (values.size() < bytes) {
        values = vulkan::Buffer(device, bytes, result_memory(device));
        if (!device.unified())
            staging.emplace(device, bytes, vulkan::Memory::readback);
    }
    if (places.size() < axes * sizeof(AxisPlace))
        places = vulkan::Buffer(device, axes * sizeof(AxisPlace), vulkan::Memory::upload);
    job.emplace(device, pass, vulkan::Job::Buffers{values, places});
}

Canvas::Canvas(const vulkan::Device& device, const Subject& subject, const std::vector<std::uint32_t>& spirv)
    : device_(device), subject_(subject), pass_(make_pass(device, subject, spirv)),
      grids_{Grid(device), Grid(device)}, samples_(device) {}

void Canvas::replace(const std::vector<std::uint32_t>& spirv) {
    for (Grid* grid : {&grids_[0], &grids_[1], &samples_})
        grid->job.reset();
    pass_ = make_pass(device_, subject_, spirv);
    stale_ = true;
    next_row_ = -1;
}

void Canvas::start(Grid& grid, const Request& request, int stride) {
    const auto cells = [&](int pixels) { return (pixels + stride - 1) / stride; };
    grid.grid = {cells(request.extent.width), cells(request.extent.height)};
    grid.stride = stride;
    std::vector<AxisPlace> places;
    add_places(places, request.camera.x, request.extent.width, request.scale, stride, subject_.radius());
    add_places(places, request.camera.y, request.extent.height, request.scale, stride, subject_.radius());
    const auto values = static_cast<std::size_t>(grid.grid.width) * static_cast<std::size_t>(grid.grid.height) *
                        static_cast<std::size_t>(subject_.channels);
    grid.resize(device_, pass_, values * sizeof(float), places.size());
    std::ranges::copy(places, grid.places.as<AxisPlace>().begin());
    next_row_ = 0;
}

// Fills up to `rows` rows from the next one on.
void Canvas::fill(Grid& grid, FieldPush push, int rows) {
    using Clock = std::chrono::steady_clock;
    push.stride = static_cast<float>(grid.stride);
    push.width = static_cast<std::uint32_t>(grid.grid.width);
    push.height = static_cast<std::uint32_t>(grid.grid.height);
    push.first_row = static_cast<std::uint32_t>(next_row_);
    const int end = std::min(next_row_ + rows, grid.grid.height);
    push.end_row = static_cast<std::uint32_t>(end);
    const auto filled = static_cast<std::uint32_t>(end - next_row_);
    std::optional<vulkan::Job::Copy> copy;
    if (grid.staging && end == grid.grid.height)
        copy.emplace(vulkan::Job::Copy{grid.values, *grid.staging, grid.values.size()});
    const Clock::time_point before = Clock::now();
    grid.job->submit(push, {(push.width + group - 1) / group, (filled + group - 1) / group}, copy);
    grid.job->wait();
    // Not by the device's own clock: lavapipe stops it before the work is done.
    const double seconds = std::chrono::duration<double>(Clock::now() - before).count();
    const double pixels = static_cast<double>(filled) * grid.grid.width;
    if (pixels >= 4096)
        cost_ = 0.7 * cost_ + 0.3 * std::max(seconds / pixels, 1e-12);
    next_row_ = end == grid.grid.height ? -1 : end;
}

int Canvas::coarsest(const Request& request, double seconds) const {
    const double whole = cost_ * request.extent.width * request.extent.height;
    int stride = 1;
    while (stride < coarsest_stride && whole / (stride * stride) > seconds)
        stride *= 2;
    return stride;
}

bool Canvas::work(const Request& request, double seconds) {
    if (stale_ || !same(request, shown_)) {
        shown_ = request;
        stale_ = false;
        start(grids_[1 - front_], request, coarsest(request, seconds));
        Grid& behind = grids_[1 - front_];
        fill(behind, request.push, behind.grid.height);
        front_ = 1 - front_;
        return front().stride > 1;
    }
    if (front().stride <= 1)
        return false;
    Grid& behind = grids_[1 - front_];
    if (next_row_ < 0)
        start(behind, request, front().stride / 2);
    const double rows = seconds / (cost_ * behind.grid.width);
    fill(behind, request.push, std::max(static_cast<int>(group), static_cast<int>(std::min(rows, 1e5))));
    if (next_row_ < 0)
        front_ = 1 - front_;
    return front().stride > 1;
}

void Canvas::finish(const Request& request) {
    while (work(request, 0.1)) {
    }
}

std::span<const float> Canvas::sample(const FieldPush& push, std::uint32_t first, double seconds) {
    const int rows = std::clamp(static_cast<int>(seconds / (cost_ * sample_columns)), 1, most_sample_rows);
    const int drawing = next_row_;
    const auto values = static_cast<std::size_t>(sample_columns * most_sample_rows * subject_.channels);
    if (!samples_.job)
        samples_.resize(device_, pass_, values * sizeof(float), sample_columns + most_sample_rows);
    samples_.grid = {sample_columns, rows};
    next_row_ = 0;
    FieldPush random = push;
    random.sampling = 1;
    random.first_sample = first;
    fill(samples_, random, rows);
    next_row_ = drawing;
    return (samples_.staging ? *samples_.staging : samples_.values)
        .as<float>()
        .first(static_cast<std::size_t>(sample_columns * rows * subject_.channels));
}

std::span<const float> Canvas::pixels() {
    Grid& grid = front();
    const auto count = static_cast<std::size_t>(grid.grid.width) * static_cast<std::size_t>(grid.grid.height) *
                       static_cast<std::size_t>(subject_.channels);
    return (grid.staging ? *grid.staging : grid.values).as<float>().first(count);
}

} // namespace gabor::viewer
