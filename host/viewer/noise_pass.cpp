#include "viewer/noise_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gabor::viewer {

namespace {

constexpr std::size_t along_surface = 2; ///< of the constants of passes/solid.comp
constexpr std::size_t perspective = 12;  ///< of those of viewer/ingredients.comp

bool in_perspective(const render::Request& request) {
    return std::holds_alternative<render::Horizon>(request.view);
}

NoisePass of_drop_in(const render::Request& request) {
    NoisePass pass;
    pass.request = request;
    pass.channels = render::channels(request);
    if (render::in_space(request)) {
        pass.shader = "passes/solid.comp";
        pass.constants = render::solid_constants(request, 0);
        pass.name = "in space";
        pass.visited = 27; // nodes of the lattice in space
    } else {
        const noise::Recipe recipe = render::drawing_recipe(request);
        pass.shader =
            recipe.is_lattice() ? fmt::format("passes/pixels.comp@{}", recipe.taps) : "passes/pixels.comp";
        pass.constants = render::pixels_constants(request);
        pass.name = noise::spelled_out(recipe);
        pass.visited = noise::visited_impulses(recipe);
        if (request.sum)
            pass.visited *= static_cast<double>(request.lobes.size());
    }
    return pass;
}

NoisePass of_ingredients(const render::Request& request, const study::Ingredients& ingredients) {
    NoisePass pass;
    pass.shader = "viewer/ingredients.comp";
    pass.request = request;
    pass.ingredients = ingredients;
    pass.channels = {"Y"};
    pass.constants = study::constants(ingredients);
    pass.constants.resize(perspective, 0);
    pass.constants.push_back(in_perspective(request));
    pass.name = ingredients == study::Ingredients{} ? "seminal"
                : ingredients == study::recommended ? "the paper's advice"
                                                    : study::key(ingredients);
    const double across = ingredients.points == study::Points::jittered_hex ? 4 : 3;
    pass.visited = across * across * ingredients.impulses;
    return pass;
}

// Cells per kernel radius along each axis.
struct Radius {
    double x = 1;
    double y = 1;
};

Radius radius_of(const NoisePass& noise) {
    if (noise.ingredients)
        return {};
    return {render::axis_along(noise.request, noise.request.width).radius,
            render::axis_along(noise.request, noise.request.height).radius};
}

passes::IngredientsPush ingredients_push(const NoisePass& noise, const passes::PixelsPush& pixels) {
    const noise::Lobe& lobe = noise.request.lobes.front();
    const study::Wave wave{lobe.frequency, lobe.angle()};
    return {.wave = {static_cast<float>(lobe.frequency * std::cos(lobe.angle())),
                     static_cast<float>(lobe.frequency * std::sin(lobe.angle()))},
            .camera = pixels.camera,
            .amplitude = static_cast<float>(1 / std::sqrt(study::variance(*noise.ingredients, wave))),
            .pixel = pixels.pixel,
            .focal_length = pixels.focal_length,
            .seed = pixels.seed,
            .width = pixels.width,
            .height = pixels.height,
            .first_row = 0,
            .before = 0};
}

// A slice of noise in space that begins where the camera is, to a whole value.
passes::SolidPush solid_push(const NoisePass& noise, const Camera& camera, Extent extent, int stride) {
    passes::SolidPush push = render::solid_push(noise.request, extent.width, extent.height, stride);
    if (std::holds_alternative<render::Slice>(noise.request.view)) {
        const auto first = [&](const Coordinate& middle, int pixels) {
            const double at = (static_cast<double>(middle.whole) + middle.part) * noise.request.scale;
            return static_cast<int>(std::clamp(std::round((at - pixels / 2.0) / stride), -1e9, 1e9));
        };
        push.first_column = first(camera.x, extent.width);
        push.first_row = first(camera.y, extent.height);
    }
    return push;
}

void add_pixels(std::vector<passes::Line>& points, int cell, int pixels, int stride, double middle) {
    for (int i = 0; i * stride < pixels; ++i)
        points.push_back({cell, static_cast<float>((i + 0.5) * stride - middle)});
}

} // namespace

passes::Line axis_point(const Coordinate& coordinate, double by, double radius) {
    const long double far = static_cast<long double>(coordinate.whole) * radius;
    const long double base = std::floor(far);
    const double cells = static_cast<double>(far - base) + (coordinate.part + by) * radius;
    const double whole = std::floor(cells);
    const auto cell = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(whole);
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(cell)), static_cast<float>(cells - whole)};
}

void add_points(std::vector<passes::Line>& points, const Coordinate& middle, int pixels, double scale,
                int stride, double radius) {
    const int count = (pixels + stride - 1) / stride;
    for (int i = 0; i < count; ++i)
        points.push_back(axis_point(middle, ((i + 0.5) * stride - pixels / 2.0) / scale, radius));
}

std::vector<NoisePass> noise_passes(const Document& document) {
    render::Request request = document.request;
    request.quadrature = request.gradient = request.phasor = false;
    request.values = 1;
    request = with_output(request, document.output);
    std::vector<NoisePass> passes{of_drop_in(request)};
    if (!document.comparison || render::in_space(request)) // where there is one recipe alone
        return passes;
    if (const auto* ingredients = std::get_if<study::Ingredients>(&*document.comparison)) {
        passes.push_back(of_ingredients(request, *ingredients));
    } else {
        request.recipe = std::get<noise::Recipe>(*document.comparison);
        passes.push_back(of_drop_in(request));
    }
    return passes;
}

NoisePass value_pass(const NoisePass& noise) {
    render::Request request = noise.request;
    // Other instances, times and scales have the same statistics.
    request.seed = 0;
    request.time = 0;
    request.scale = 32;
    request.filter = request.quadrature = request.gradient = false;
    request.paint.clear();
    if (render::in_space(request)) {
        request.view = render::Slice();
        NoisePass pass = of_drop_in(request);
        pass.constants[along_surface] = noise.constants[along_surface];
        return pass;
    }
    if (in_perspective(request))
        request.view = render::Plane();
    return noise.ingredients ? of_ingredients(request, *noise.ingredients) : of_drop_in(request);
}

GridInput view_grid(const NoisePass& noise, const Camera& camera, Extent extent, int stride,
                    const render::Paint& paint) {
    const render::Request& request = noise.request;
    GridInput input;
    input.grid = {(extent.width + stride - 1) / stride, (extent.height + stride - 1) / stride};
    if (render::in_space(request)) {
        input.push = solid_push(noise, camera, extent, stride);
        return input;
    }
    input.lobes = render::pixels_lobes(request);
    passes::PixelsPush push = render::pixels_push(request, extent.width, extent.height);
    push.width = input.grid.width;
    push.height = input.grid.height;
    const Radius radius = radius_of(noise);
    const passes::Line x = axis_point(camera.x, 0, radius.x);
    const passes::Line y = axis_point(camera.y, 0, radius.y);
    if (in_perspective(request)) {
        push.camera = {x.local, y.local};
        add_pixels(input.columns, x.cell, extent.width, stride, extent.width / 2.0);
        add_pixels(input.rows, y.cell, extent.height, stride, render::sky_rows(extent.height));
    } else {
        add_points(input.columns, camera.x, extent.width, request.scale, stride, radius.x);
        add_points(input.rows, camera.y, extent.height, request.scale, stride, radius.y);
    }
    // The paint lies over the picture, whose corner is the origin of the plane.
    const auto paint_corner = [&](const Coordinate& middle, int side, int pixels, int samples) {
        const double at = (static_cast<double>(middle.whole) + middle.part) * request.scale - pixels / 2.0;
        return static_cast<float>(at * samples / side);
    };
    push.paint_size = {paint.width, paint.height};
    push.paint_scale = {static_cast<float>(stride * static_cast<double>(paint.width) / request.width),
                        static_cast<float>(stride * static_cast<double>(paint.height) / request.height)};
    push.paint_corner = {paint_corner(camera.x, request.width, extent.width, paint.width),
                         paint_corner(camera.y, request.height, extent.height, paint.height)};
    if (noise.ingredients)
        input.push = ingredients_push(noise, push);
    else
        input.push = push;
    return input;
}

GridInput random_grid(const NoisePass& noise, Extent grid, std::uint32_t draw) {
    const std::uint32_t seed = draw * 0x9e3779b1u;
    GridInput input;
    input.grid = grid;
    if (render::in_space(noise.request)) {
        // Points further apart than two impulses of one kernel can be, at all places of a cell.
        render::Request apart = noise.request;
        apart.scale = 1 / (4 + std::numbers::phi);
        passes::SolidPush push = render::solid_push(apart, grid.width, grid.height);
        push.seed = seed;
        push.depth = static_cast<float>(std::fmod(draw * std::numbers::phi, 1.0));
        input.push = push;
        return input;
    }
    input.lobes = render::pixels_lobes(noise.request);
    passes::PixelsPush push = render::pixels_push(noise.request, grid.width, grid.height);
    push.seed = seed;
    push.width = grid.width;
    push.height = grid.height;
    // Further apart than two impulses of one kernel can be: a diameter and a cell.
    const Radius radius = radius_of(noise);
    const int apart = static_cast<int>(std::ceil(2 * std::max(radius.x, radius.y))) + 2;
    std::mt19937 generator(draw);
    const auto fill = [&](std::vector<passes::Line>& points, int count) {
        for (int i = 0; i < count; ++i)
            points.push_back({i * apart, static_cast<float>(generator() >> 8) * 0x1p-24f});
    };
    fill(input.columns, grid.width);
    fill(input.rows, grid.height);
    if (noise.ingredients)
        input.push = ingredients_push(noise, push);
    else
        input.push = push;
    return input;
}

} // namespace gabor::viewer
