#include "render/bake.hpp"

#include "noise/variance.hpp"
#include "render/pixels.hpp"

#include "passes/bake.h"
#include "passes/bake_colour.h"
#include "passes/bake_lattice_2.h"
#include "passes/bake_lattice_3.h"
#include "passes/bake_lattice_4.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

constexpr RecipeModules bake_modules{bake_spirv,
                                     {bake_lattice_2_spirv, bake_lattice_3_spirv, bake_lattice_4_spirv}};

constexpr std::uint32_t bake_buffers = 5;

// A lattice's cells are narrow, and to begin a block is most of its cost: few blocks of even width.
// `scale`: pixels per radius of the kernels.
Block block_for(const vulkan::Device& device, const noise::Recipe& recipe, double scale) {
    if (device.info().kind != "CPU")
        return gpu_block(recipe);
    if (!recipe.is_lattice())
        return cpu_block;
    const double cell = std::ceil(scale / double{recipe.radius}); // pixels
    return {static_cast<int>(std::ceil(cell / std::ceil(cell / 12))), 32};
}

passes::vec2 turn(double turns) {
    const double angle = 2 * std::numbers::pi * turns;
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

// `scale`: pixels per radius of its kernels.
passes::BakeWave make_wave(const Request& request, std::size_t index, const noise::Wave& wave, const Axis& x,
                           const Axis& y, double scale) {
    const noise::Recipe recipe = drawing_recipe(request);
    const double frequency = wave.frequency * wave.radius;
    const double wave_x = frequency * std::cos(wave.angle);
    const double wave_y = frequency * std::sin(wave.angle);
    // The sparse noise's variance is in proportion to the number of impulses per unit area.
    const double normalized =
        recipe.is_lattice()
            ? 1
            : recipe.radius / std::sqrt(x.radius * y.radius *
                                        noise::variance(recipe, frequency, wave.angle, request.time));
    const double amplitude = request.colour ? 1 : std::sqrt(wave.share); // colours have weights
    passes::BakeWave result{{static_cast<float>(wave_x), static_cast<float>(wave_y)},
                            turn(wave_x / scale),
                            turn(wave_y / scale),
                            static_cast<float>(amplitude * normalized),
                            wave.seed,
                            {}};
    put_weights(result.weights, request, index);
    return result;
}

std::vector<noise::Wave> waves_of(const Request& request) {
    return in_space(request) ? noise::waves_in_space(request.lobes, request.seed)
                             : noise::waves(request.lobes, request.seed);
}

} // namespace

std::string recipe_pass(std::string_view name, const noise::Recipe& recipe) {
    const std::string path = fmt::format("passes/{}.comp", name);
    return recipe.is_lattice() ? fmt::format("{}@{}", path, recipe.taps) : path;
}

std::array<std::uint32_t, 7> recipe_constants(const noise::Recipe& recipe) {
    using vulkan::constant;
    return {constant(recipe.impulses), constant(recipe.radius),    constant(recipe.weight_floor),
            constant(recipe.phases),   constant(recipe.window[0]), constant(recipe.window[1]),
            constant(recipe.window[2])};
}

Block gpu_block(const noise::Recipe& recipe) {
    if (recipe.is_lattice())
        return {8, 16};
    return {noise::visited_impulses(recipe) > 9 ? 2 : 4, 16};
}

std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest,
                                   double origin) {
    const auto position = [&](int pixel) { return origin + (pixel + 0.5) * cells_per_pixel; };
    const auto cell_of = [&](int pixel) {
        return static_cast<std::int32_t>(std::floor(position(pixel) - radius));
    };
    // The first pixel that visits no cell before this one: an estimate, which rounding may have put one off.
    const auto start_of = [&](std::int32_t cell) {
        int pixel = static_cast<int>(std::ceil((cell + radius - origin) / cells_per_pixel - 0.5));
        while (cell_of(pixel) >= cell)
            --pixel;
        while (cell_of(pixel) < cell)
            ++pixel;
        return pixel;
    };

    std::vector<passes::Run> runs;
    const int start = start_of(cell_of(first));
    int pixel = start + (first - start) / longest * longest;
    while (pixel < first + count) {
        const std::int32_t cell = cell_of(pixel);
        int length = 1;
        while (length < longest && cell_of(pixel + length) == cell)
            ++length;
        runs.push_back({cell, static_cast<float>(position(pixel) - cell - 1), pixel - first, length});
        pixel += length;
    }
    return runs;
}

std::vector<std::uint32_t> bake_constants(const Request& request, int block_columns, int fixed_rows) {
    const noise::Recipe recipe = drawing_recipe(request);
    const auto of_recipe = recipe_constants(recipe);
    std::vector<std::uint32_t> constants(of_recipe.begin(), of_recipe.end());
    constants.push_back(vulkan::constant(noise::visited_cells(recipe)));
    constants.push_back(vulkan::constant(block_columns));
    constants.push_back(vulkan::constant(fixed_rows));
    constants.push_back(request.quadrature);
    constants.push_back(request.gradient);
    constants.push_back(wrapped_time(request) != 0);
    constants.push_back(waves_of(request).size() > 1);
    constants.push_back(request.colour.has_value());
    constants.push_back(in_space(request));
    return constants;
}

vulkan::Pass make_bake_pass(const vulkan::Device& device, const Request& request, int block_columns,
                            int fixed_rows, Code code) {
    return {device,
            code_or(code, bake_modules.of(drawing_recipe(request))),
            {bake_buffers, sizeof(passes::BakePush), fixed_rows > 0},
            bake_constants(request, block_columns, fixed_rows)};
}

bool Bake::can_fill(const Request& request) {
    const bool flat =
        std::holds_alternative<Plane>(request.view) ||
        (std::holds_alternative<Slice>(request.view) && std::ranges::none_of(request.lobes, is_isotropic));
    return request.paint.empty() && flat && !request.filter && !request.phasor && request.values == 1;
}

BakeTables make_bake_tables(const Request& request, const BakeAxis& across, const BakeAxis& down,
                            const std::function<Block(double)>& block_of) {
    const noise::Recipe recipe = drawing_recipe(request);
    const std::vector<noise::Wave> waves = waves_of(request);
    BakeTables tables;
    for (const double radius : noise::radii(waves)) {
        const Axis x = axis_along(request, request.width, radius);
        const Axis y = axis_along(request, request.height, radius);
        const double scale = across.scale * radius;
        const Block block = block_of(scale);
        // The lattice's windows stretch with its nodes to fit a period.
        const auto runs = [&](const Axis& axis, const BakeAxis& pixels, int longest) {
            const double reach = recipe.is_lattice() ? double{recipe.radius} : axis.radius;
            const auto [cell, place] =
                pixels.origin ? pixels.origin(axis.radius / radius) : std::pair(0, 0.0);
            std::vector<passes::Run> made =
                make_runs(pixels.first, pixels.count, axis.radius / scale, reach, longest, place);
            for (passes::Run& run : made) // cells wrap around at 2^31
                run.cell = static_cast<std::int32_t>(static_cast<std::uint32_t>(run.cell) +
                                                     static_cast<std::uint32_t>(cell));
            return made;
        };
        const std::vector<passes::Run> columns = runs(x, across, block.columns);
        const std::vector<passes::Run> rows = runs(y, down, block.rows);
        passes::BakePush push{};
        push.radius = {static_cast<float>(x.radius), static_cast<float>(y.radius)};
        push.period = {x.period, y.period};
        push.time = wrapped_time(request);
        push.pixel = static_cast<float>(1 / scale);
        push.stretch = static_cast<float>(1 / radius);
        if (const Slice* slice = std::get_if<Slice>(&request.view)) {
            const double nodes = double{recipe.radius};
            const double place = slice->depth / radius * nodes;
            push.first_slice = static_cast<int>(std::floor(place - nodes)) + 1;
            push.slice_offset = static_cast<float>(place - push.first_slice - 1);
        }
        push.first_wave = static_cast<std::uint32_t>(tables.waves.size());
        for (std::size_t i = 0; i < waves.size(); ++i)
            if (waves[i].radius == radius)
                tables.waves.push_back(make_wave(request, i, waves[i], x, y, scale));
        push.wave_count = static_cast<std::uint32_t>(tables.waves.size()) - push.first_wave;
        push.width = across.count;
        push.first_column_run = static_cast<std::uint32_t>(tables.columns.size());
        push.column_runs = static_cast<std::uint32_t>(columns.size());
        push.first_row_run = static_cast<std::uint32_t>(tables.rows.size());
        tables.columns.insert(tables.columns.end(), columns.begin(), columns.end());
        tables.rows.insert(tables.rows.end(), rows.begin(), rows.end());
        tables.grids.push_back({push, rows, block.columns});
    }
    return tables;
}

Bake::Bake(const vulkan::Device& device, const Request& request, const image::Window& region, Code code)
    : Bake(device,
           make_bake_tables(request, {region.x, region.width, request.scale, {}},
                            {region.y, region.height, request.scale, {}},
                            [&, recipe = drawing_recipe(request)](double scale) {
                                return block_for(device, recipe, scale);
                            }),
           pixels_colour(request), region.height) {
    for (BakeTables::Grid& grid : tables_.grids) {
        if (!passes_.contains(grid.block_columns))
            passes_.emplace(grid.block_columns, make_bake_pass(device, request, grid.block_columns, 0, code));
        grid.pass = &passes_.at(grid.block_columns);
    }
    if (request.colour)
        colouring_ = std::make_unique<vulkan::Pass>(
            device, bake_colour_spirv, vulkan::Pass::Interface{bake_buffers, sizeof(passes::BakePush)},
            std::vector{vulkan::constant(static_cast<int>(channels(request).size()))});
    tables_.colouring = colouring_.get();
}

Bake::Bake(const vulkan::Device& device, BakeTables tables, const passes::PixelsColour& colour, int height)
    : height_(height), tables_(std::move(tables)), columns_(upload(device, tables_.columns)),
      rows_(upload(device, tables_.rows)), waves_(upload(device, tables_.waves)),
      colour_(upload(device, std::vector{colour})) {}

// Of the first grid, whole runs; those of others that cross a band's edge are evaluated on both sides.
std::vector<RegionRenderer::Band> Bake::bands(int most_rows) const {
    std::vector<Band> bands;
    for (const passes::Run& run : tables_.grids.front().row_runs) {
        const int begin = std::max(run.first, 0);
        const int end = std::min(run.first + run.count, height_);
        if (bands.empty() || end - bands.back().first_row > most_rows)
            bands.push_back({begin, 0});
        bands.back().rows = end - bands.back().first_row;
    }
    return bands;
}

vulkan::Job Bake::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, passes_.begin()->second, {columns_, rows_, waves_, result, colour_}};
}

void Bake::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    tables_.submit(job, band, 0, copy);
}

void BakeTables::submit(vulkan::Job& job, const RegionRenderer::Band& band, int before,
                        const std::optional<vulkan::Job::Copy>& copy) const {
    std::vector<passes::BakePush> pushes;
    std::vector<vulkan::Job::Dispatch> dispatches;
    pushes.reserve(grids.size());
    for (const Grid& grid : grids) {
        const auto ends = [](const passes::Run& run) { return run.first + run.count; };
        const auto first = std::ranges::upper_bound(grid.row_runs, band.first_row, {}, ends);
        const auto last =
            std::ranges::lower_bound(grid.row_runs, band.first_row + band.rows, {}, &passes::Run::first);
        passes::BakePush& push = pushes.emplace_back(grid.push);
        push.first_row = band.first_row;
        push.height = band.rows;
        push.before = before;
        push.first_row_run += static_cast<std::uint32_t>(first - grid.row_runs.begin());
        dispatches.push_back({std::as_bytes(std::span(&push, 1)),
                              {groups(static_cast<int>(push.column_runs), passes::bake_group),
                               static_cast<std::uint32_t>(last - first)},
                              grid.pass});
    }
    if (colouring)
        dispatches.push_back(
            {dispatches.front().push,
             {groups(pushes.front().width, passes::bake_group), static_cast<std::uint32_t>(band.rows)},
             colouring});
    job.submit(dispatches, copy);
}

} // namespace gabor::render
