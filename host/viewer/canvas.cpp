#include "viewer/canvas.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace gabor::viewer {

namespace {

constexpr int group = 8; // local_size of passes/pixels.comp and of shaders/viewer/view.glsl, in x and y
constexpr int coarsest_stride = 16;
constexpr int sample_columns = 256;
constexpr int most_sample_rows = 256;

vulkan::Memory result_memory(const vulkan::Device& device) {
    return device.unified() ? vulkan::Memory::readback : vulkan::Memory::device;
}

std::size_t count(Extent grid, int channels) {
    return static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height) *
           static_cast<std::size_t>(channels);
}

template <typename T>
void upload(const vulkan::Device& device, vulkan::Buffer& buffer, const std::vector<T>& values) {
    const std::size_t bytes = values.size() * sizeof(T);
    if (buffer.size() < bytes)
        buffer = vulkan::Buffer(device, bytes, vulkan::Memory::upload);
    std::ranges::copy(values, buffer.as<T>().begin());
}

vulkan::Pass make_pass(const vulkan::Device& device, const NoisePass& noise, const Spirv& spirv) {
    return {device, spirv, {5, sizeof(ViewPush)}, noise.constants};
}

} // namespace

Canvas::Grid::Grid(const vulkan::Device& device)
    : values(device, 4, result_memory(device)), columns(device, 8, vulkan::Memory::upload),
      rows(device, 8, vulkan::Memory::upload), lobes(device, 8, vulkan::Memory::upload) {}

Canvas::Canvas(const vulkan::Device& device, const NoisePass& noise, const Spirv& spirv)
    : device_(device), noise_(noise), paint_(render::read_paint(noise.picture.paint)),
      paint_samples_(device, paint_.samples.size() * sizeof(float), vulkan::Memory::upload),
      pass_(make_pass(device, noise, spirv)), grids_{Grid(device), Grid(device)} {
    upload(device, paint_samples_, paint_.samples);
}

void Canvas::replace(const Spirv& spirv) {
    for (Grid& grid : grids_) {
        grid.job.reset();
        grid.next_row = -1;
    }
    pass_ = make_pass(device_, noise_, spirv);
    stale_ = true;
}

bool Canvas::same(const Request& a, const Request& b) {
    return std::memcmp(&a.parameters.push, &b.parameters.push, sizeof a.parameters.push) == 0 &&
           a.parameters.lobes == b.parameters.lobes && a.camera == b.camera && a.scale == b.scale &&
           a.extent == b.extent;
}

void Canvas::start(Grid& grid, const SamplePoints& points, int stride) {
    grid.job.reset();
    grid.grid = {static_cast<int>(points.columns.size()), static_cast<int>(points.rows.size())};
    grid.stride = stride;
    grid.next_row = 0;
    const std::size_t bytes = count(grid.grid, noise_.channels) * sizeof(float);
    if (grid.values.size() < bytes) {
        grid.values = vulkan::Buffer(device_, bytes, result_memory(device_));
        if (!device_.unified())
            grid.staging.emplace(device_, bytes, vulkan::Memory::readback);
    }
    upload(device_, grid.columns, points.columns);
    upload(device_, grid.rows, points.rows);
    upload(device_, grid.lobes, shown_.parameters.lobes);
    grid.job.emplace(device_, pass_,
                     vulkan::Job::Buffers{grid.columns, grid.rows, grid.lobes, paint_samples_, grid.values});
}

// Fills up to `rows` rows from the next one on.
void Canvas::fill(Grid& grid, int rows) {
    using Clock = std::chrono::steady_clock;
    const int first = grid.next_row;
    const int filled = std::min(rows, grid.grid.height - first);
    ViewPush push = shown_.parameters.push;
    push.stride = static_cast<float>(grid.stride);
    push.pixels.width = grid.grid.width;
    push.pixels.height = filled;
    push.pixels.first_row = first;
    push.pixels.before = first * grid.grid.width;
    std::optional<vulkan::Job::Copy> copy;
    if (grid.staging && first + filled == grid.grid.height)
        copy.emplace(vulkan::Job::Copy{grid.values, *grid.staging, grid.values.size()});
    const auto groups = [](int pixels) { return static_cast<std::uint32_t>((pixels + group - 1) / group); };
    const Clock::time_point before = Clock::now();
    grid.job->submit(push, {groups(grid.grid.width), groups(filled)}, copy);
    grid.job->wait();
    // Not by the device's own clock: lavapipe stops it before the work is done.
    const double seconds = std::chrono::duration<double>(Clock::now() - before).count();
    const double pixels = static_cast<double>(filled) * grid.grid.width;
    if (pixels >= 4096)
        cost_ = 0.7 * cost_ + 0.3 * std::max(seconds / pixels, 1e-12);
    grid.next_row = first + filled == grid.grid.height ? -1 : first + filled;
}

int Canvas::coarsest(double seconds) const {
    const double whole = cost_ * shown_.extent.width * shown_.extent.height;
    int stride = 1;
    while (stride < coarsest_stride && whole / (stride * stride) > seconds)
        stride *= 2;
    return stride;
}

bool Canvas::refine(const NoisePass& noise, const Document& document, Extent extent, double seconds) {
    noise_ = noise;
    Request request{view_parameters(noise, document, extent), document.camera, document.picture.scale,
                    extent};
    render::PixelsPush& push = request.parameters.push.pixels;
    push.paint_width = paint_.width;
    push.paint_height = paint_.height;
    const Camera home = default_camera(document);
    const auto paint_along = [&](const Coordinate& at, const Coordinate& from, int side, int view,
                                 int samples) {
        const double moved = static_cast<double>(at.whole - from.whole) + at.part - from.part;
        return static_cast<float>((moved * document.picture.scale + (side - view) / 2.0) * samples / side);
    };
    push.paint_x = paint_along(document.camera.x, home.x, document.picture.width, extent.width, paint_.width);
    push.paint_y =
        paint_along(document.camera.y, home.y, document.picture.height, extent.height, paint_.height);
    const auto begin = [&](Grid& grid, int stride) {
        shown_.parameters.push.pixels.paint_scale_x =
            static_cast<float>(stride * static_cast<double>(paint_.width) / document.picture.width);
        shown_.parameters.push.pixels.paint_scale_y =
            static_cast<float>(stride * static_cast<double>(paint_.height) / document.picture.height);
        start(grid, sample_points(noise, document, extent, stride), stride);
    };
    Grid& behind = grids_[1 - front_];
    // What depends on the stride is no part of the request.
    Request known = shown_;
    known.parameters.push.pixels.paint_scale_x = known.parameters.push.pixels.paint_scale_y = 0;
    if (stale_ || !same(request, known)) {
        shown_ = request;
        stale_ = false;
        begin(behind, coarsest(seconds));
        fill(behind, behind.grid.height);
        front_ = 1 - front_;
        return front().stride > 1;
    }
    if (front().stride <= 1)
        return false;
    if (behind.next_row < 0)
        begin(behind, front().stride / 2);
    const double rows = seconds / (cost_ * behind.grid.width);
    fill(behind, std::max(group, static_cast<int>(std::min(rows, 1e5))));
    if (behind.next_row < 0)
        front_ = 1 - front_;
    return front().stride > 1;
}

std::span<const float> Canvas::pixels() {
    Grid& grid = front();
    return (grid.staging ? *grid.staging : grid.values).as<float>().first(count(grid.grid, noise_.channels));
}

std::span<const float> ValueSampler::sample(const Document& document, std::uint32_t draw, double seconds) {
    const int rows =
        std::clamp(static_cast<int>(seconds / (canvas_.cost_ * sample_columns)), group, most_sample_rows);
    NoisePass noise = canvas_.noise_;
    noise.picture.frequency = document.picture.frequency;
    noise.picture.orientation = document.picture.orientation;
    noise.picture.lobes = document.picture.lobes;
    noise.picture.frequency_spread = document.picture.frequency_spread;
    noise.picture.orientation_spread = document.picture.orientation_spread;
    canvas_.shown_.parameters = view_parameters(noise, document, {sample_columns, rows});
    canvas_.shown_.parameters.push.pixels.seed = draw * 0x9e3779b1u;
    Canvas::Grid& grid = canvas_.front();
    canvas_.start(grid, random_points(noise, sample_columns, rows, draw), 1);
    canvas_.fill(grid, rows);
    return canvas_.pixels();
}

} // namespace gabor::viewer
