#include "viewer/drawing.hpp"

#include "noise/spectrum.hpp"

#include "passes/line.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace gabor::viewer {

namespace {

// The highest frequency, in cycles per pixel of the picture.
double highest_frequency(const render::Request& request, const render::Paint& paint) {
    if (!request.paint.empty())
        return render::highest_frequency(paint) / request.scale;
    return std::ranges::max(noise::waves(request.lobes, request.seed), {}, &noise::Wave::frequency)
               .frequency /
           request.scale;
}

} // namespace

Drawing drawing_of(const Document& document) {
    render::Request request = document.request;
    request.quadrature = request.gradient = request.phasor = false;
    request.values = 1;
    return {with_output(request, document.output), is_lit(document) && !render::has_material(request) &&
                                                       std::holds_alternative<render::Body>(request.view)};
}

render::Viewport viewport_of(const Drawing& drawing, const Camera& camera, Extent extent, int stride) {
    return {.camera = camera,
            .width = extent.width,
            .height = extent.height,
            .region = {0, 0, (extent.width + stride - 1) / stride, (extent.height + stride - 1) / stride},
            .stride = stride,
            .blocks = render::Blocks::fixed,
            .normals = drawing.normals};
}

int coarsest_stride(const Drawing& drawing, const render::Paint& paint, double zoom) {
    constexpr int coarsest = 16;
    constexpr int coarsest_baked = 4; // blocks are still full then
    constexpr double least_per_wave = 3;
    const render::Request& request = drawing.request;
    const bool blocks = uses_blocks(request, viewport_of(drawing, {{}, {}, zoom}, {1, 1}));
    int stride = blocks ? coarsest_baked : coarsest;
    if (request.filter || render::has_terrain(request) || !render::is_flat(request.view) ||
        (request.paint.empty() && !request.quadrature))
        return stride;
    const double pixels = zoom / highest_frequency(request, paint); // in the shortest wave
    while (stride > 1 && pixels < least_per_wave * stride)
        stride /= 2;
    return stride;
}

render::Request value_request(const Drawing& drawing) {
    render::Request request = drawing.request;
    // Other instances, times and scales have the same statistics.
    request.seed = 0;
    request.time = 0;
    request.scale = 32;
    request.filter = request.quadrature = request.gradient = request.phasor = false;
    request.paint.clear();
    request.colour.reset();
    if (render::in_perspective(request))
        request.view = render::Plane();
    return request;
}

render::Plan random_points(render::Request request, Extent grid, std::uint32_t draw) {
    request.seed = draw * 0x9e3779b1u;
    const double widest = std::ranges::max(request.lobes, {}, &noise::Lobe::longest_radius).longest_radius();
    if (render::in_space(request)) {
        // Points too far apart to share a kernel, at all places of a cell, and on bodies at all normals.
        request.width = grid.width;
        request.height = grid.height;
        request.scale = 1 / ((4 + std::numbers::phi) * widest);
        const double share = std::fmod(draw * std::numbers::phi, 1.0);
        if (auto* body = std::get_if<render::Body>(&request.view)) {
            body->yaw = 360 * std::fmod(draw * std::numbers::sqrt2, 1.0);
            body->pitch = noise::degrees(std::asin(2 * share - 1));
        } else {
            request.view = render::Slice{share};
        }
    }
    render::Plan plan = render::plan(request, {.camera = {},
                                               .width = grid.width,
                                               .height = grid.height,
                                               .region = {0, 0, grid.width, grid.height},
                                               .blocks = render::Blocks::none});
    if (render::in_space(request))
        return plan;
    // Too far apart to share a kernel: a diameter and a cell.
    std::mt19937 generator(draw);
    const auto lines = [&](int count, int side, std::size_t axis) {
        std::vector<double> cells; // per kernel radius
        for (const auto& radius : noise::radii(noise::waves(request.lobes, request.seed)))
            cells.push_back(render::axis_along(request, side, radius[axis]).radius / radius[axis]);
        const double cell = 1 / std::ranges::min(cells);
        const double apart = std::ceil(2 * widest / cell) + 2;
        std::vector<passes::Line> points;
        for (int i = 0; i < count; ++i) {
            const double within = static_cast<double>(generator() >> 8) * 0x1p-24;
            for (const double per_radius : cells) {
                const double at = (i * apart + within) * cell * per_radius;
                points.push_back(
                    {static_cast<std::int32_t>(std::floor(at)), static_cast<float>(at - std::floor(at))});
            }
        }
        return render::bytes_of(points);
    };
    plan.tables[0] = lines(grid.width, request.width, 0);
    plan.tables[1] = lines(grid.height, request.height, 1);
    return plan;
}

Tiling tiling_of(const Document& document, Extent view) {
    const render::Request& request = document.request;
    const int parts = std::gcd(request.width, request.height);
    const auto fitting = [&](int side, int available) { return available / 2 / (side / parts); };
    const int kept = std::clamp(
        std::min(fitting(request.width, view.width), fitting(request.height, view.height)), 1, parts);
    Tiling tiling;
    tiling.tile = {request.width / parts * kept, request.height / parts * kept};
    tiling.camera = render::default_camera(request);
    tiling.camera.zoom = static_cast<double>(kept) / parts;
    const double scale = request.scale * tiling.camera.zoom;
    const auto moved = [&](const Coordinate& from, const Coordinate& to, int side) {
        const double by = (static_cast<double>(to.whole - from.whole) + (to.part - from.part)) * scale;
        return static_cast<float>(std::floor(by - side * std::floor(by / side)));
    };
    tiling.moved = {moved(tiling.camera.x, document.camera.x, tiling.tile.width),
                    moved(tiling.camera.y, document.camera.y, tiling.tile.height)};
    return tiling;
}

} // namespace gabor::viewer
