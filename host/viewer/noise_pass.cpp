#include "viewer/noise_pass.hpp"

#include "noise/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gabor::viewer {

namespace {

constexpr double least_baked_cell = 8; // pixels: blocks are of one cell

NoisePass of_drop_in(const render::Request& request) {
    NoisePass pass;
    pass.request = request;
    pass.channels = render::channels(request);
    if (render::in_space(request)) {
        pass.shader = render::solid_pass(request);
        pass.constants = render::solid_constants(request);
    } else {
        pass.shader = render::recipe_pass("pixels", request.recipe);
        pass.constants = render::pixels_constants(request);
    }
    return pass;
}

// The same block by block, where that can be done and is faster. One block serves all scales: each other
// would be a pipeline of its own.
NoisePass baked(NoisePass pass, double zoom, bool cpu) {
    const render::Request& request = pass.request;
    const double cell = request.scale * zoom / double{request.recipe.radius}; // pixels
    if (render::in_space(request) || request.colour || !render::Bake::can_fill(request) ||
        cell < least_baked_cell)
        return pass;
    const render::Block block = !cpu                          ? render::gpu_block(request.recipe)
                                : request.recipe.is_lattice() ? render::Block{12, 32}
                                                              : render::cpu_block;
    pass.block = {block.columns, block.rows};
    pass.shader = render::recipe_pass("bake", request.recipe);
    pass.constants = render::bake_constants(request, block.columns);
    return pass;
}

NoisePass of_material(const render::Request& request) {
    NoisePass pass;
    pass.request = request;
    pass.channels = render::channels(request);
    pass.shader = render::pass_of(request);
    pass.constants = render::material_constants(request);
    return pass;
}

// Cells per kernel radius of the picture along each axis, for each table of lines.
struct Cells {
    std::vector<double> x;
    std::vector<double> y;
};

Cells cells_of(const NoisePass& noise) {
    const render::Request& request = noise.request;
    Cells cells;
    for (const double radius : render::pixels_tables(request)) {
        const auto along = [&](int side) {
            return render::axis_along(request, side, radius).radius / radius;
        };
        cells.x.push_back(along(request.width));
        cells.y.push_back(along(request.height));
    }
    return cells;
}

// The highest frequency in the picture, in cycles per pixel of it.
double highest_frequency(const render::Request& request, const render::Paint& paint) {
    if (!request.paint.empty())
        return render::highest_frequency(paint) / request.scale;
    return std::ranges::max(noise::waves(request.lobes, request.seed), {}, &noise::Wave::frequency)
               .frequency /
           request.scale;
}

// How much of a wave of that many cycles per pixel is left in a value that stands for `pixels` x `pixels` of
// them, where the picture has points: it is seen through the filter of a pixel of its size, that no wave
// shows as another one.
float left_of_wave(double frequency, double pixels) {
    const double variance = std::max(pixels * pixels - 1, 0.0) / 4;
    return static_cast<float>(std::exp(-2 * std::pow(std::numbers::pi * frequency, 2) * variance));
}

// Leaves a share of a wave, in grey and in colour.
template <typename Wave>
void reduce(Wave& wave, float share) {
    wave.amplitude *= share;
    for (passes::vec2& weight : wave.weights)
        weight = {share * weight.x, share * weight.y};
}

// A slice of noise in space that begins where the camera is, to a whole value.
passes::SolidPush solid_push(const NoisePass& noise, const Camera& camera, Extent extent, int stride) {
    passes::SolidPush push = render::solid_push(noise.request, extent.width, extent.height, stride);
    if (std::holds_alternative<render::Slice>(noise.request.view)) {
        const auto first = [&](const Coordinate& middle, int pixels) {
            const double at =
                (static_cast<double>(middle.whole) + middle.part) * noise.request.scale * camera.zoom;
            return static_cast<int>(std::clamp(std::round((at - pixels / 2.0) / stride), -1e9, 1e9));
        };
        push.pixel /= static_cast<float>(camera.zoom);
        push.first_column = first(camera.x, extent.width);
        push.first_row = first(camera.y, extent.height);
    }
    return push;
}

// The light stands still over the view, as over a picture of the request's size.
passes::MaterialPush material_push(const NoisePass& noise, const Camera& camera, Extent extent, int stride) {
    const render::Request& request = noise.request;
    passes::MaterialPush push = render::material_push(request, extent.width, extent.height, stride);
    const bool flat = is_flat(request.view);
    const double pixel = 1 / (request.scale * camera.zoom);
    const auto corner = [&](const Coordinate& middle, int pixels) {
        return static_cast<float>(static_cast<double>(middle.whole) +
                                  (middle.part - (flat ? pixels / 2.0 * pixel : 0)));
    };
    push.corner = {corner(camera.x, extent.width), corner(camera.y, extent.height)};
    if (flat) {
        push.pixel = static_cast<float>(stride * pixel);
        push.size = {static_cast<float>(request.width * camera.zoom / stride),
                     static_cast<float>(request.height * camera.zoom / stride)};
    } else if (render::in_perspective(request)) {
        push.pixel /= static_cast<float>(camera.zoom);
    }
    return push;
}

// In perspective: the camera's cell in each table, and the place in the picture, `middle` of so many pixels
// from its edge.
void add_pixels(std::vector<passes::Line>& points, const std::vector<passes::Line>& camera, int pixels,
                double middle) {
    for (int i = 0; i < pixels; ++i)
        for (const passes::Line& at : camera)
            points.push_back({at.cell, static_cast<float>(i + 0.5 - middle)});
}

std::vector<passes::Line> axis_points(const Coordinate& coordinate, double by,
                                      const std::vector<double>& cells) {
    std::vector<passes::Line> points;
    for (const double radius : cells)
        points.push_back(axis_point(coordinate, by, radius));
    return points;
}

} // namespace

std::pair<std::int32_t, double> axis_place(const Coordinate& coordinate, double by, double radius) {
    const long double far = static_cast<long double>(coordinate.whole) * radius;
    const long double base = std::floor(far);
    const double cells = static_cast<double>(far - base) + (coordinate.part + by) * radius;
    const double whole = std::floor(cells);
    const auto cell = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(whole);
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(cell)), cells - whole};
}

passes::Line axis_point(const Coordinate& coordinate, double by, double radius) {
    const auto [cell, place] = axis_place(coordinate, by, radius);
    return {cell, static_cast<float>(place)};
}

void add_points(std::vector<passes::Line>& points, const Coordinate& middle, int pixels, double scale,
                int stride, const std::vector<double>& radii) {
    const int count = (pixels + stride - 1) / stride;
    for (int i = 0; i < count; ++i)
        std::ranges::copy(axis_points(middle, ((i + 0.5) * stride - pixels / 2.0) / scale, radii),
                          std::back_inserter(points));
}

void NoisePass::add_normal() {
    constants.push_back(1);
    channels.insert(channels.end() - 1, {"normal.x", "normal.y", "normal.z", "gradient.z"});
}

NoisePass noise_pass(const Document& document, bool cpu) {
    render::Request request = document.request;
    request.quadrature = request.gradient = request.phasor = false;
    request.values = 1;
    if (render::has_material(request))
        return of_material(request);
    NoisePass pass = baked(of_drop_in(with_output(request, document.output)), document.camera.zoom, cpu);
    if (document.output == Output::lit && std::holds_alternative<render::Body>(request.view))
        pass.add_normal();
    return pass;
}

int coarsest_stride(const NoisePass& noise, const render::Paint& paint, double zoom) {
    constexpr int coarsest = 16;
    constexpr int coarsest_baked = 4; // where blocks are still full
    constexpr double least_per_wave = 3;
    const render::Request& request = noise.request;
    int stride = noise.block ? coarsest_baked : coarsest;
    if (request.filter || !is_flat(request.view) || (request.paint.empty() && !request.quadrature))
        return stride;
    const double pixels = zoom / highest_frequency(request, paint); // of the shortest wave
    while (stride > 1 && pixels < least_per_wave * stride)
        stride /= 2;
    return stride;
}

NoisePass value_pass(const NoisePass& noise) {
    render::Request request = noise.request;
    // Other instances, times and scales have the same statistics.
    request.seed = 0;
    request.time = 0;
    request.scale = 32;
    request.filter = request.quadrature = request.gradient = request.phasor = false;
    request.paint.clear();
    request.colour.reset();
    if (render::in_perspective(request))
        request.view = render::Plane();
    return of_drop_in(request);
}

GridInput view_grid(const NoisePass& noise, const Camera& camera, Extent extent, int stride,
                    const render::Paint& paint) {
    const render::Request& request = noise.request;
    const Extent grid{(extent.width + stride - 1) / stride, (extent.height + stride - 1) / stride};
    if (render::has_material(request))
        return {grid, MaterialInput{material_push(noise, camera, extent, stride)}};
    // Cycles per kernel radius of the picture. Where a filter is asked for, it has the size of the value.
    const auto left = [&](double frequency) {
        return request.filter ? 1 : left_of_wave(frequency / request.scale, stride / camera.zoom);
    };
    if (render::in_space(request)) {
        SolidInput input{solid_push(noise, camera, extent, stride), render::solid_waves(request),
                         render::pixels_colour(request)};
        input.push.waves = static_cast<int>(input.waves.size());
        if (is_flat(request.view))
            for (passes::SolidWave& wave : input.waves)
                reduce(wave, left(double{wave.frequency} / double{wave.radius}));
        return {grid, std::move(input)};
    }
    const double scale = request.scale * camera.zoom;
    if (noise.block) {
        const auto axis = [&](const Coordinate& middle, int pixels, int values) {
            return render::BakeAxis{0, values, scale / stride, [=](double cells) {
                                        return axis_place(middle, -pixels / 2.0 / scale, cells);
                                    }};
        };
        render::BakeTables tables =
            render::make_bake_tables(request, axis(camera.x, extent.width, grid.width),
                                     axis(camera.y, extent.height, grid.height), [&](double) {
                                         return render::Block{noise.block->width, noise.block->height};
                                     });
        for (const render::BakeTables::Grid& each : tables.grids)
            for (passes::BakeWave& wave :
                 std::span(tables.waves).subspan(each.push.first_wave, each.push.wave_count))
                wave.amplitude *= left(std::hypot(wave.wave.x, wave.wave.y) * each.push.stretch);
        return {grid, std::move(tables)};
    }
    PixelsInput input{render::pixels_push(request, extent.width, extent.height),
                      {},
                      {},
                      render::pixels_waves(request, paint)};
    passes::PixelsPush& push = input.push;
    push.waves = static_cast<int>(input.waves.size());
    push.pixel /= static_cast<float>(camera.zoom);
    const Cells cells = cells_of(noise);
    if (render::in_perspective(request)) {
        const std::vector<passes::Line> x = axis_points(camera.x, 0, cells.x);
        const std::vector<passes::Line> y = axis_points(camera.y, 0, cells.y);
        for (passes::PixelsWave& wave : input.waves) {
            const auto table = static_cast<std::size_t>(wave.table);
            wave.camera = {x.at(table).local, y.at(table).local};
        }
        // A coarse one is a picture of fewer pixels.
        push.focal_length /= static_cast<float>(stride);
        add_pixels(input.columns, x, grid.width, extent.width / 2.0 / stride);
        add_pixels(input.rows, y, grid.height, render::sky_rows(extent.height) / stride);
    } else {
        push.pixel *= static_cast<float>(stride);
        if (request.paint.empty())
            for (passes::PixelsWave& wave : input.waves)
                reduce(wave, left(double{wave.frequency} / double{wave.radius}));
        add_points(input.columns, camera.x, extent.width, scale, stride, cells.x);
        add_points(input.rows, camera.y, extent.height, scale, stride, cells.y);
    }
    // The paint lies over the picture, whose corner is the origin of the plane.
    const auto paint_corner = [&](const Coordinate& middle, int side, int pixels, int samples) {
        const double at = (static_cast<double>(middle.whole) + middle.part) * scale - pixels / 2.0;
        return static_cast<float>(at * samples / (side * camera.zoom));
    };
    push.paint_size = {paint.width, paint.height};
    const auto paint_scale = [&](int samples, int side) {
        return static_cast<float>(stride * static_cast<double>(samples) / (side * camera.zoom));
    };
    push.paint_scale = {paint_scale(paint.width, request.width), paint_scale(paint.height, request.height)};
    push.paint_corner = {paint_corner(camera.x, request.width, extent.width, paint.width),
                         paint_corner(camera.y, request.height, extent.height, paint.height)};
    input.colour = render::pixels_colour(request);
    return {grid, std::move(input)};
}

GridInput random_grid(const NoisePass& noise, Extent grid, std::uint32_t draw) {
    render::Request request = noise.request;
    request.seed = draw * 0x9e3779b1u;
    const double widest = std::ranges::max(request.lobes, {}, &noise::Lobe::radius).radius;
    if (render::in_space(request)) {
        // Points further apart than two impulses of one kernel can be, at all places of a cell; on bodies at
        // all normals.
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
        SolidInput input{render::solid_push(request, grid.width, grid.height), render::solid_waves(request)};
        input.push.waves = static_cast<int>(input.waves.size());
        return {grid, std::move(input)};
    }
    // Further apart than two impulses of one kernel can be: a diameter and a cell.
    const Cells cells = cells_of(noise);
    std::mt19937 generator(draw);
    const auto fill = [&](std::vector<passes::Line>& points, int count, const std::vector<double>& radii) {
        const double cell = 1 / std::ranges::min(radii);
        const double apart = std::ceil(2 * widest / cell) + 2;
        for (int i = 0; i < count; ++i) {
            const double within = static_cast<double>(generator() >> 8) * 0x1p-24;
            for (const double radius : radii) {
                const double at = (i * apart + within) * cell * radius;
                points.push_back(
                    {static_cast<std::int32_t>(std::floor(at)), static_cast<float>(at - std::floor(at))});
            }
        }
    };
    PixelsInput input{render::pixels_push(request, grid.width, grid.height),
                      {},
                      {},
                      render::pixels_waves(request, render::Paint())};
    input.push.waves = static_cast<int>(input.waves.size());
    fill(input.columns, grid.width, cells.x);
    fill(input.rows, grid.height, cells.y);
    return {grid, std::move(input)};
}

} // namespace gabor::viewer
