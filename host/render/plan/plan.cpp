#include "render/plan/plan.hpp"

#include "render/plan/plan_parts.hpp"
#include "render/request/material.hpp"

#include "passes/fractal_interface.h"
#include "passes/line.h"
#include "passes/material_interface.h"
#include "passes/ocean_interface.h"
#include "passes/pixels_interface.h"
#include "passes/solid_interface.h"
#include "passes/terrain_interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

constexpr double least_baked_cell = 8; // in pixels; smaller cells would make blocks too small

std::uint32_t view_constant(const Request& request) {
    constexpr std::array views{passes::view_flat,   passes::view_horizon, passes::view_slice, // by projection
                               passes::view_sphere, passes::view_torus,   passes::view_landscape};
    return is_pattern(request.kind) || !request.view.is_flat()
               ? views.at(static_cast<std::size_t>(request.view.projection))
               : passes::view_terrain;
}

// The constants of a noise. `channels` are the picture's.
Constants constants_of(const Request& request, std::span<const std::string> channels) {
    Constants constants{};
    std::ranges::copy(recipe_constants(drawing_recipe(request)), constants.begin());
    constants[passes::view_id] = view_constant(request);
    constants[passes::filter_id] = request.filter;
    constants[passes::painted_id] = !request.paint.empty();
    constants[passes::channels_id] = static_cast<std::uint32_t>(channels.size());
    for (const auto& [id, name] : std::initializer_list<std::pair<std::uint32_t, std::string_view>>{
             {passes::quadrature_id, "quadrature"},
             {passes::gradient_id, "gradient.x"},
             {passes::phasor_id, "phase"},
             {passes::normal_id, "normal.x"},
             {passes::coverage_id, "A"},
             {passes::removed_id, "removed"}})
        constants[id] = vulkan::constant(channel_index(channels, name));
    constants[passes::animated_id] = wrapped_evolution(request) != 0;
    constants[passes::coloured_id] = request.colour.has_value();
    constants[passes::tiled_id] = request.view.tileable;
    return constants;
}

// Makes a step with one invocation per value.
template <typename Push>
Step step_of(std::string shader, const Constants& constants, const Push& push, std::uint32_t group) {
    const int side = static_cast<int>(group);
    return {std::move(shader), constants, bytes_of(push), push.width, {side, side}, {}};
}

// ---- The plane, pixel by pixel ----

// Returns the length of a pixel in kernel radii. In perspective, returns the height of the camera above the
// plane, chosen so that the bottom row has the request's scale.
double pixel_length(const Request& request, int height) {
    return (request.view.has_horizon() ? height - 0.5 - sky_rows(height) : 1) / request.scale;
}

// Returns the positions of pixels along an axis (0 for x, 1 for y), each as a cell and an offset in it, once
// for each kernel radius. In perspective, every cell is the camera's, and the offsets are in pixels from the
// middle of the horizon.
std::vector<passes::Line> lines(const Request& request, const Viewport& viewport, std::size_t axis) {
    const bool horizon = request.view.has_horizon();
    const Side side = side_of(request, viewport, axis);
    const Coordinate start = horizon ? side.middle : side.edge();
    const double origin =
        axis == 0 ? side.view / 2.0 : sky_rows(side.view); // pixels from the edge of the view
    struct Table {
        std::int32_t cell;
        double place; // offset of the view's corner in its cell
        double step;  // cells per value
    };
    std::vector<Table> tables;
    for (const auto& radii : noise::radii(noise::waves(request.lobes, request.seed))) {
        const double cells = axis_along(request, side.picture, radii[axis]).radius;
        const auto [cell, place] = cell_at(start, cells / radii[axis]);
        tables.push_back({cell, place, cells / (side.scale * radii[axis]) * side.stride});
    }
    std::vector<passes::Line> result;
    for (int i = side.first; i < side.first + side.count; ++i)
        for (const Table& table : tables) {
            const double here =
                horizon ? i + 0.5 - origin / side.stride : table.place + (i + 0.5) * table.step;
            const double carried = horizon ? 0 : std::floor(here);
            result.push_back(
                {static_cast<std::int32_t>(static_cast<std::uint32_t>(table.cell) +
                                           static_cast<std::uint32_t>(static_cast<std::int64_t>(carried))),
                 static_cast<float>(here - carried)});
        }
    return result;
}

// Painted noise has as many waves as its highest frequency needs.
std::vector<passes::PixelsWave> pixels_waves(const Request& request, const Viewport& viewport,
                                             const Paint& paint) {
    std::vector<noise::Lobe> lobes = request.lobes;
    double unit = 1;                                 // unit of the paint's frequencies
    if (!request.paint.empty() && !paint.relative) { // paint requires a single lobe
        unit = std::clamp(highest_frequency(request, paint), 1e-3, 1e6);
        lobes.front().frequency = unit;
        lobes.front().orientation = 0;
    }
    const std::vector<noise::Wave> waves = noise::waves(lobes, request.seed);
    const auto tables = noise::radii(noise::waves(request.lobes, request.seed));
    std::vector<passes::PixelsWave> result;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const noise::Wave& wave = waves[i];
        const auto [radius_x, radius_y] = wave.radius;
        const Axis x = axis_along(request, request.width, radius_x);
        const Axis y = axis_along(request, request.height, radius_y);
        const auto camera = [&](const Coordinate& at, double cells) {
            return request.view.has_horizon() ? static_cast<float>(cell_at(at, cells).second) : 0.0f;
        };
        passes::PixelsWave& made = result.emplace_back(passes::PixelsWave{
            .nodes = vec2_of(x.radius, y.radius),
            .period = {x.period, y.period},
            .camera = {camera(viewport.camera.x, x.radius / radius_x),
                       camera(viewport.camera.y, y.radius / radius_y)},
            .frequency = static_cast<float>(wave.frequency / unit * radius_x),
            .orientation = static_cast<float>(wave.angle),
            .radius = vec2_of(wave.radius),
            .amplitude = static_cast<float>(std::sqrt(wave.share)),
            .seed = wave.seed,
            .table = static_cast<int>(std::ranges::find(tables, wave.radius) - tables.begin()),
            .weights = {}});
        put_weights(made.weights, request, i); // in colour, each lobe has one wave
        if (!request.view.has_horizon() && request.paint.empty())
            fade(made, share_left(request, viewport, wave.frequency));
    }
    return result;
}

// The largest number of waves that passes/pixels.comp unrolls.
constexpr std::size_t few_waves = 16;

// Sets bits for the waves that need only the narrow or only the wide form of the filter.
void choose_filters(Constants& constants, const std::vector<passes::PixelsWave>& waves, float pixel,
                    float radius) {
    constexpr float margin = 0.01f; // for rounding
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const passes::PixelsWave& wave = waves[i];
        const float deviation =
            0.5f * pixel / radius * std::max(wave.nodes.x / wave.radius.x, wave.nodes.y / wave.radius.y);
        const float wide_share = 100 * deviation - 9; // as in gabor_impl_wide_share of gabor_filter.glsl
        constants[passes::narrow_waves_id] |= std::uint32_t{wide_share < -margin} << i;
        constants[passes::wide_waves_id] |= std::uint32_t{wide_share > 1 + margin} << i;
    }
}

// Stretches the paint over the picture, whose corner is the origin of the plane.
void put_paint(passes::PixelsPush& push, const Request& request, const Viewport& viewport,
               const Paint& paint) {
    const auto scale = [&](const Side& side, int samples) {
        return static_cast<float>(side.stride * samples / (side.picture * viewport.camera.zoom));
    };
    const auto corner = [](const Side& side) {
        return static_cast<float>(side.edge().value() * side.scale / side.stride + side.first);
    };
    const Side x = side_of(request, viewport, 0);
    const Side y = side_of(request, viewport, 1);
    push.paint_size = {paint.width, paint.height};
    push.paint_scale = {scale(x, paint.width), scale(y, paint.height)};
    push.paint_corner = {corner(x) * push.paint_scale.x, corner(y) * push.paint_scale.y};
}

void plan_pixels(Plan& plan, const Request& request, const Viewport& viewport, const Paint& paint) {
    const auto stride = static_cast<float>(viewport.stride);
    const std::vector<passes::PixelsWave> waves = pixels_waves(request, viewport, paint);
    auto push = push_of<passes::PixelsPush>({0, 0, plan.width, plan.height}); // tables cover the region
    push.time = wrapped_evolution(request);
    push.pixel =
        static_cast<float>(pixel_length(request, viewport.height)) / static_cast<float>(viewport.camera.zoom);
    if (!request.view.has_horizon())
        push.pixel *= stride;
    push.focal_length = static_cast<float>(viewport.width) / stride; // in units of stride pixels
    push.waves = static_cast<int>(waves.size());
    push.tables = static_cast<int>(noise::radii(noise::waves(request.lobes, request.seed)).size());
    put_paint(push, request, viewport, paint);
    plan.tables = {bytes_of(lines(request, viewport, 0)), bytes_of(lines(request, viewport, 1)),
                   bytes_of(waves), bytes_of(paint.samples), bytes_of(colour_of(request))};
    Constants constants = constants_of(request, plan.channels);
    const bool window = viewport.blocks == Blocks::fixed;
    // A driver may take a tenth of a second to compile each filtered wave: too long to wait for each new
    // wave.
    if (waves.size() <= (window && request.filter ? 1 : few_waves)) {
        constants[passes::few_waves_id] = vulkan::constant(push.waves);
        // Not in a window, where each scale would need its own pipeline.
        if (request.filter && !request.view.has_horizon() && !window)
            choose_filters(constants, waves, push.pixel, request.recipe.radius);
    }
    plan.steps = {step_of(recipe_pass("pixels", request.recipe), constants, push, passes::pixels_group)};
}

// ---- Fractal noise ----

void plan_fractal(Plan& plan, const Request& request, const Viewport& viewport) {
    const Fractal& fractal = request.fractal;
    const Axis x = axis_along(request, request.width, 1), y = axis_along(request, request.height, 1);
    auto push = push_of<passes::FractalPush>({0, 0, plan.width, plan.height}); // tables cover the region
    push.nodes = vec2_of(x.radius, y.radius);
    push.period = {x.period, y.period};
    push.pixel =
        static_cast<float>(pixel_length(request, viewport.height)) / static_cast<float>(viewport.camera.zoom);
    if (request.view.has_horizon()) {
        push.camera = {static_cast<float>(cell_at(viewport.camera.x, x.radius).second),
                       static_cast<float>(cell_at(viewport.camera.y, y.radius).second)};
        push.focal_length = static_cast<float>(viewport.width) / static_cast<float>(viewport.stride);
    } else {
        push.pixel *= static_cast<float>(viewport.stride);
    }
    push.time = wrapped_evolution(request);
    push.octaves = static_cast<float>(fractal.octaves);
    push.gain = static_cast<float>(fractal.gain);
    push.lacunarity = static_cast<float>(fractal.lacunarity);
    push.turn = static_cast<float>(noise::radians(fractal.turn));
    push.warp = static_cast<float>(fractal.warp);
    push.seed = request.seed;
    Constants constants = constants_of(request, plan.channels);
    constants[passes::basis_id] = vulkan::constant(fractal.basis);
    constants[passes::shape_id] = vulkan::constant(fractal.shape - 1);
    constants[passes::warped_id] = fractal.warp != 0;
    plan.tables = {bytes_of(lines(request, viewport, 0)), bytes_of(lines(request, viewport, 1))};
    plan.steps = {step_of("fractal", constants, push, passes::fractal_group)};
}

// ---- Bodies and slices ----

// The side of a pixel in the plane at distance 1 from the eye, such that a sphere of radius 1 at distance 4
// leaves a margin of 1/20 along the shorter side.
double pixel_side(int shorter_side) {
    return 2 * 1.05 * std::tan(std::asin(0.25)) / shorter_side;
}

// The radius of the sphere in kernel radii. Its nearest point is at distance 3, where a unit of length covers
// 1 / (3 pixel_side) pixels.
double sphere_radius(const Request& request) {
    return 1 / (3 * pixel_side(std::min(request.width, request.height)) * request.scale);
}

// Sets the push constants of passes/body.glsl.
template <typename Push>
void push_body(Push& push, const Request& request, const Viewport& viewport) {
    const Orbit& orbit = request.view.orbit;
    push.pixel = static_cast<float>(pixel_side(std::min(viewport.width, viewport.height)) * viewport.stride /
                                    orbit.zoom);
    push.unit = static_cast<float>(sphere_radius(request));
    push.yaw = direction(noise::radians(std::remainder(orbit.yaw, 360.0)));
    push.pitch = direction(noise::radians(orbit.pitch));
}

passes::vec2 half(const Viewport& viewport) {
    return vec2_of(viewport.width / 2.0 / viewport.stride, viewport.height / 2.0 / viewport.stride);
}

void plan_solid(Plan& plan, const Request& request, const Viewport& viewport) {
    std::vector<passes::SolidWave> waves;
    for (const noise::Wave& wave : noise::waves(request.lobes, request.seed, true)) {
        passes::SolidWave& made = waves.emplace_back(
            passes::SolidWave{.direction = direction(wave.angle),
                              .frequency = static_cast<float>(wave.frequency * wave.radius[0]),
                              .radius = static_cast<float>(wave.radius[0]),
                              .amplitude = static_cast<float>(std::sqrt(wave.share)),
                              .seed = wave.seed,
                              .isotropic = wave.isotropic,
                              .weights = {}});
        put_weights(made.weights, request, waves.size() - 1); // in colour, each lobe has one wave
        if (request.view.is_flat())
            fade(made, share_left(request, viewport, wave.frequency));
    }
    auto push = push_of<passes::SolidPush>(viewport.region);
    push.center = half(viewport);
    push.time = wrapped_evolution(request);
    push.waves = static_cast<int>(waves.size());
    if (request.view.projection == Projection::slice) {
        // Rounds to whole values, so that the same points are sampled wherever the view is.
        const auto first = [&](std::size_t axis) {
            const Side side = side_of(request, viewport, axis);
            const double at = side.middle.value() * request.scale * viewport.camera.zoom;
            return static_cast<int>(std::clamp(std::round((at - side.view / 2.0) / side.stride), -1e9, 1e9));
        };
        push.first_column += first(0);
        push.first_row += first(1);
        push.pixel =
            static_cast<float>(viewport.stride / request.scale) / static_cast<float>(viewport.camera.zoom);
        push.depth = static_cast<float>(request.view.depth);
    } else {
        push_body(push, request, viewport);
        push.share =
            1.0f / static_cast<float>(viewport.stride); // filters over one pixel, so noise stays visible
    }
    Constants constants = constants_of(request, plan.channels);
    constants[passes::isotropic_id] = std::ranges::any_of(request.lobes, is_isotropic);
    constants[passes::directed_id] = !std::ranges::all_of(request.lobes, is_isotropic);
    plan.tables = {bytes_of(waves), bytes_of(colour_of(request))};
    plan.steps = {step_of(request.view.along_surface() ? "solid@surface" : "solid", constants, push,
                          passes::solid_group)};
}

// ---- Materials ----

// Plans a material. In flat views, the light stays fixed relative to the view.
void plan_material(Plan& plan, const Request& request, const Viewport& viewport) {
    const bool flat = request.view.is_flat();
    const double zoom = viewport.camera.zoom;
    const Side x = side_of(request, viewport, 0);
    const Side y = side_of(request, viewport, 1);
    auto push = push_of<passes::MaterialPush>(viewport.region);
    push.center = half(viewport);
    push.seed = request.seed;
    push.lamp = vec2_of(light_direction(request));
    const auto size = [&](const Side& side) {
        return (flat ? side.picture * zoom : side.view) / side.stride;
    };
    push.size = vec2_of(size(x), size(y));
    const auto corner = [&](const Side& side) { return (flat ? side.edge() : side.middle).value(); };
    push.corner = vec2_of(corner(x), corner(y));
    if (request.view.has_horizon()) {
        push.sky = static_cast<float>(sky_rows(viewport.height) / viewport.stride);
        push.pixel = static_cast<float>(pixel_length(request, viewport.height)) / static_cast<float>(zoom);
    } else if (flat) {
        push.pixel = static_cast<float>(viewport.stride * (1 / x.scale));
    } else {
        push_body(push, request, viewport);
    }
    Constants constants{};
    constants[passes::filter_id] = request.filter;
    constants[passes::view_id] = view_constant(request);
    constants[passes::tiled_id] = request.view.tileable;
    constants[passes::environment_id] = vulkan::constant(request.environment);
    constants[passes::boards_id] = request.boards;
    constants[passes::coat_id] = request.coat;
    constants[passes::finish_id] = request.finish;
    constants[passes::unlit_id] = !viewport.lit;
    plan.tables = {bytes_of(struct_values(request))};
    std::string function = request.material;
    std::ranges::replace(function, '-', '_');
    plan.steps = {step_of("material@" + function, constants, push, passes::material_group)};
}

// ---- Terrain ----

void plan_terrain(Plan& plan, const Request& request, const Viewport& viewport) {
    const Orbit& orbit = request.view.orbit;
    const bool perspective = !request.view.is_flat();
    auto push = push_of<passes::TerrainPush>(viewport.region);
    push.seed = request.seed;
    push.water = static_cast<float>(request.water_level);
    push.sun = vec2_of(light_direction(request));
    push.unit = static_cast<float>(terrain_unit(request));
    push.reach = static_cast<float>(erosion_reach(request));
    // In perspective, the camera looks at the middle of what the terrain view shows.
    const Camera looked_at = default_camera(from_above(request));
    const Coordinate x = perspective ? looked_at.x : side_of(request, viewport, 0).edge();
    const Coordinate y = perspective ? looked_at.y : side_of(request, viewport, 1).edge();
    push.cell = {cell_at(x, 1).first, cell_at(y, 1).first};
    push.corner = vec2_of(x.part, y.part);
    push.pixel = static_cast<float>(viewport.stride / (request.scale * viewport.camera.zoom));
    if (request.view.tileable)
        push.period = vec2_of(request.width / request.scale, request.height / request.scale);
    if (perspective) {
        const double side = std::max(viewport.width, viewport.height);
        push.center = half(viewport);
        push.center.y *= 1.3f; // leaves room for the sky
        push.yaw = direction(noise::radians(std::remainder(orbit.yaw, 360.0)));
        push.pitch = direction(noise::radians(std::max(orbit.pitch, 0.0)));
        push.distance =
            static_cast<float>(focal_ratio(orbit.focal_length) * std::max(request.width, request.height) /
                               request.scale / orbit.zoom);
        push.pixel = static_cast<float>(viewport.stride / (focal_ratio(orbit.focal_length) * side));
    }
    Constants constants{};
    constants[passes::view_id] = view_constant(request);
    constants[passes::cover_id] = vulkan::constant(request.cover);
    constants[passes::lakes_id] = request.water_level > -hill_reach;
    constants[passes::unlit_id] = !viewport.lit;
    plan.tables = {bytes_of(struct_values(request))};
    plan.steps = {step_of("terrain", constants, push, passes::terrain_group)};
}

// ---- The sea ----

void plan_sea(Plan& plan, const Request& request, const Viewport& viewport) {
    const Sea& sea = request.sea;
    const Orbit& orbit = request.view.orbit;
    const double second = std::floor(sea.seconds), side = std::max(viewport.width, viewport.height);
    auto push = push_of<passes::OceanPush>(viewport.region);
    push.center = half(viewport);
    push.yaw = direction(noise::radians(std::remainder(orbit.yaw, 360.0)));
    push.pitch = direction(noise::radians(orbit.pitch));
    push.sun = vec2_of(light_direction(request));
    push.altitude = static_cast<float>(orbit.altitude);
    push.pixel = static_cast<float>(viewport.stride / (orbit.zoom * focal_ratio(orbit.focal_length) * side));
    push.second = static_cast<int>(second);
    push.fraction = static_cast<float>(sea.seconds - second);
    push.seed = request.seed;
    plan.tables = {ocean_table(request)};
    plan.steps = {step_of("ocean", Constants{}, push, passes::ocean_group)};
}

} // namespace

std::array<std::uint32_t, passes::window_id + 3> recipe_constants(const noise::Recipe& recipe) {
    using vulkan::constant;
    std::array<std::uint32_t, passes::window_id + 3> constants{};
    constants[passes::impulses_id] = constant(recipe.impulses);
    constants[passes::radius_id] = constant(recipe.radius);
    constants[passes::weight_floor_id] = constant(recipe.weight_floor);
    constants[passes::phases_id] = constant(recipe.phases);
    for (std::size_t i = 0; i < recipe.window.size(); ++i)
        constants[passes::window_id + i] = constant(recipe.window[i]);
    return constants;
}

std::string recipe_pass(std::string_view pass, const noise::Recipe& recipe) {
    return recipe.is_lattice() ? fmt::format("{}@{}", pass, recipe.taps) : std::string(pass);
}

int channel_index(std::span<const std::string> channels, std::string_view name) {
    const auto found = std::ranges::find(channels, name);
    return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
}

float wrapped_evolution(const Request& request) {
    return static_cast<float>(request.evolution - std::floor(request.evolution));
}

double highest_frequency(const Request& request, const Paint& paint) {
    float highest = 0;
    for (std::size_t i = 0; i < paint.samples.size(); i += 2)
        highest = std::max(highest, std::abs(paint.samples[i]));
    return paint.relative ? highest * request.lobes.front().frequency : double{highest};
}

float share_left(const Request& request, const Viewport& viewport, double frequency) {
    if (request.filter)
        return 1;
    const double side = viewport.stride / viewport.camera.zoom; // pixels along a value's side
    const double variance = std::max(side * side - 1, 0.0) / 4;
    return static_cast<float>(
        std::exp(-2 * std::pow(std::numbers::pi * frequency / request.scale, 2) * variance));
}

passes::PixelsColour colour_of(const Request& request) {
    const noise::Colour colour = request.colour.value_or(noise::Colour());
    const auto vector = [](double x, double y, double z) {
        return passes::vec4{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 0};
    };
    const auto& h = colour.histogram;
    passes::PixelsColour result{};
    for (std::size_t n = 0; n < h[0].size(); ++n)
        result.histogram[n] = vector(h[0][n], h[1][n], h[2][n]);
    result.mean = vector(colour.mean[0], colour.mean[1], colour.mean[2]);
    for (std::size_t i = 0; i < colour.mixing.size(); ++i)
        result.mixing[i] = vector(colour.mixing[i][0], colour.mixing[i][1], colour.mixing[i][2]);
    return result;
}

void put_weights(passes::vec2 (&weights)[3], const Request& request, std::size_t lobe) {
    if (!request.colour)
        return;
    std::ranges::transform(
        request.colour->weights.at(lobe), weights,
        [](const noise::Colour::Weight& weight) { return vec2_of(weight.quadrature, weight.noise); });
}

Viewport viewport_of(const Request& request, const image::Rect& region) {
    return {.camera = default_camera(request),
            .width = request.width,
            .height = request.height,
            .region = region};
}

bool uses_blocks(const Request& request, const Viewport& viewport) {
    if (viewport.blocks == Blocks::none || request.kind != Kind::noise || !request.view.is_flat() ||
        !request.paint.empty() || request.filter || request.phasor)
        return false;
    // In isotropic noise in space, each node has its own wave, so the pixels of a block share nothing.
    if (request.view.in_space() && std::ranges::any_of(request.lobes, is_isotropic))
        return false;
    const double cell = request.scale * viewport.camera.zoom / double{drawing_recipe(request).radius};
    return viewport.blocks == Blocks::fitted ||
           (!request.view.in_space() && !request.colour && cell >= least_baked_cell);
}

Plan plan(const Request& request, const Viewport& viewport, const Paint& paint, DeviceKind device) {
    Plan plan{channels(request, viewport.normals), viewport.region.width, viewport.region.height, {}, {}};
    switch (request.kind) {
    case Kind::sea:
        plan_sea(plan, request, viewport);
        break;
    case Kind::terrain:
        plan_terrain(plan, request, viewport);
        break;
    case Kind::material:
        plan_material(plan, request, viewport);
        break;
    case Kind::fractal:
        plan_fractal(plan, request, viewport);
        break;
    case Kind::noise:
        if (uses_blocks(request, viewport))
            plan_bake(plan, request, viewport, device, constants_of(request, plan.channels));
        else if (request.view.in_space())
            plan_solid(plan, request, viewport);
        else
            plan_pixels(plan, request, viewport, paint);
    }
    return plan;
}

Band band_at(const Plan& plan, int first_row, int most_rows) {
    const Step& step = plan.steps.front();
    if (step.runs.empty()) {
        if (most_rows > step.group.rows) // leave no work group partly empty
            most_rows -= most_rows % step.group.rows;
        return {first_row, std::min(most_rows, plan.height - first_row)};
    }
    // A band consists of whole runs of the first step. Runs of other steps that cross a band's edge are
    // evaluated in both bands.
    Band band{first_row, 0};
    for (const auto& [first, count] : step.runs) {
        const int rows = std::min(first + count, plan.height) - first_row;
        if (rows > 0 && (band.rows == 0 || rows <= most_rows))
            band.rows = rows;
    }
    return band;
}

int most_rows_of_a_band(const Plan& plan, int most_rows) {
    for (const auto& [first, count] : plan.steps.front().runs)
        most_rows = std::max(most_rows, count);
    return std::min(most_rows, plan.height);
}

} // namespace gabor::render
