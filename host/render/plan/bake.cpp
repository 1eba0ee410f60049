#include "noise/variance.hpp"
#include "render/plan/plan_parts.hpp"

#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

// A GPU needs many small blocks whose impulses fit its registers. A CPU has few lanes and large caches, and
// spends most of a lattice block's time on setup, so large blocks of equal width are best. `scale` is in
// values per radius of the wave's kernels.
Block block_for(const noise::Recipe& recipe, DeviceKind device, Blocks blocks, double scale) {
    if (device == DeviceKind::gpu)
        return recipe.is_lattice() ? Block{8, 16} : Block{noise::visited_impulses(recipe) > 9 ? 2 : 4, 16};
    if (!recipe.is_lattice())
        return {8, 32};
    if (blocks == Blocks::fixed)
        return {12, 32};
    const double cell = std::ceil(scale / double{recipe.radius}); // pixels
    return {static_cast<int>(std::ceil(cell / std::ceil(cell / 12))), 32};
}

// Values per kernel radius.
double values_per_radius(const Request& request, const Viewport& viewport) {
    return request.scale * viewport.camera.zoom / viewport.stride;
}

// The factor that gives a wave the variance 1. The variance of sparse noise is proportional to its impulses
// per unit area.
double normalization(const Request& request, const noise::Wave& wave) {
    const noise::Recipe recipe = drawing_recipe(request);
    if (recipe.is_lattice())
        return 1;
    const Axis x = axis_along(request, request.width, wave.radius[0]);
    const Axis y = axis_along(request, request.height, wave.radius[1]);
    const double variance = noise::variance(recipe, wave.frequency * wave.radius[0], wave.angle,
                                            request.evolution); // sparse kernels are round
    return recipe.radius / std::sqrt(x.radius * y.radius * variance);
}

passes::BakeWave make_wave(const Request& request, const Viewport& viewport, const noise::Wave& wave,
                           std::size_t lobe) {
    const std::array<double, 2> turns = wave.in_kernels();
    const double amplitude = request.colour ? 1 : std::sqrt(wave.share); // colours use weights instead
    const auto turn = [&](std::size_t axis) {
        return direction(2 * std::numbers::pi *
                         (turns[axis] / (values_per_radius(request, viewport) * wave.radius[axis])));
    };
    passes::BakeWave made{.wave = vec2_of(turns),
                          .column_turn = turn(0),
                          .row_turn = turn(1),
                          .amplitude = static_cast<float>(amplitude * normalization(request, wave)),
                          .seed = wave.seed,
                          .weights = {}};
    made.amplitude *= share_left(request, viewport, wave.frequency);
    put_weights(made.weights, request, lobe);
    return made;
}

// Cuts the columns (axis 0) or rows (1) of the region into runs, for kernels of a radius.
std::vector<passes::Run> runs_along(const Request& request, const Viewport& viewport, std::size_t axis,
                                    double radius, int longest) {
    const Side side = side_of(request, viewport, axis);
    const Axis cells = axis_along(request, side.picture, radius);
    const noise::Recipe recipe = drawing_recipe(request);
    // The lattice's windows stretch with its nodes to fit a period.
    const double reach = recipe.is_lattice() ? double{recipe.radius} : cells.radius;
    const auto [cell, place] = cell_at(side.edge(), cells.radius / radius);
    std::vector<passes::Run> runs =
        make_runs(side.first, side.count, cells.radius / (values_per_radius(request, viewport) * radius),
                  reach, longest, place);
    for (passes::Run& run : runs) // cells wrap around at 2^31
        run.cell = static_cast<std::int32_t>(static_cast<std::uint32_t>(run.cell) +
                                             static_cast<std::uint32_t>(cell));
    return runs;
}

// The push constants for kernels of the given radii, except for the ranges in the tables.
passes::BakePush push_for(const Request& request, const Viewport& viewport,
                          const std::array<double, 2>& radius) {
    const Axis x = axis_along(request, request.width, radius[0]);
    const Axis y = axis_along(request, request.height, radius[1]);
    const double scale = values_per_radius(request, viewport);
    auto push = push_of<passes::BakePush>(
        {0, 0, viewport.region.width, viewport.region.height}); // runs count from the region's corner
    push.radius = vec2_of(x.radius, y.radius);
    push.period = {x.period, y.period};
    push.time = wrapped_evolution(request);
    push.stretch = vec2_of(1 / radius[0], 1 / radius[1]);
    push.pixel = vec2_of(1 / (scale * radius[0]), 1 / (scale * radius[1]));
    if (request.view.projection == Projection::slice) {
        const double nodes = double{drawing_recipe(request).radius};
        const double place = request.view.depth / radius[0] * nodes;
        push.first_slice = static_cast<int>(std::floor(place - nodes)) + 1;
        push.slice_offset = static_cast<float>(place - push.first_slice - 1);
    }
    return push;
}

// Appends to a table, and returns the index of the first new entry.
template <typename T>
std::uint32_t append(std::vector<T>& table, const std::vector<T>& entries) {
    table.insert(table.end(), entries.begin(), entries.end());
    return static_cast<std::uint32_t>(table.size() - entries.size());
}

// Turns the components that the steps before have summed into colours.
Step colour_step(const Plan& plan) {
    Step step{"bake_colour", {}, plan.steps.front().push, plan.width, {passes::bake_group, 1}, {}};
    step.constants[passes::channels_id] = vulkan::constant(static_cast<int>(plan.channels.size()));
    return step;
}

} // namespace

std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest,
                                   double origin) {
    const auto position = [&](int pixel) { return origin + (pixel + 0.5) * cells_per_pixel; };
    const auto cell_of = [&](int pixel) {
        return static_cast<std::int32_t>(std::floor(position(pixel) - radius));
    };
    // Estimates the first pixel that visits no cell before `cell`, then corrects for rounding.
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

void plan_bake(Plan& plan, const Request& request, const Viewport& viewport, DeviceKind device,
               const Constants& constants) {
    const noise::Recipe recipe = drawing_recipe(request);
    const std::vector<noise::Wave> waves = noise::waves(request.lobes, request.seed, request.view.in_space());
    std::vector<passes::Run> columns;
    std::vector<passes::Run> rows;
    std::vector<passes::BakeWave> wave_table;
    for (const std::array<double, 2>& radius : noise::radii(waves)) {
        const Block block =
            block_for(recipe, device, viewport.blocks, values_per_radius(request, viewport) * radius[0]);
        const auto across = runs_along(request, viewport, 0, radius[0], block.columns);
        const auto down = runs_along(request, viewport, 1, radius[1], block.rows);
        passes::BakePush push = push_for(request, viewport, radius);
        push.first_column_run = append(columns, across);
        push.column_runs = static_cast<std::uint32_t>(across.size());
        push.first_run = append(rows, down);
        push.first_wave = static_cast<std::uint32_t>(wave_table.size());
        for (std::size_t i = 0; i < waves.size(); ++i)
            if (waves[i].radius == radius)
                wave_table.push_back(make_wave(request, viewport, waves[i], i)); // in colour, a wave per lobe
        push.wave_count = static_cast<std::uint32_t>(wave_table.size()) - push.first_wave;

        Step& step = plan.steps.emplace_back();
        step.shader = recipe_pass("bake", recipe);
        step.constants = constants;
        step.constants[passes::visited_id] = vulkan::constant(noise::visited_cells(recipe));
        step.constants[passes::block_columns_id] = vulkan::constant(block.columns);
        step.constants[passes::sum_id] = waves.size() > 1;
        step.constants[passes::few_waves_id] = push.wave_count == 1;
        step.push = bytes_of(push);
        step.across = static_cast<int>(across.size());
        step.group = {passes::bake_group, 1};
        for (const passes::Run& run : down)
            step.runs.emplace_back(run.first, run.count);
    }
    if (request.colour)
        plan.steps.push_back(colour_step(plan));
    plan.tables = {bytes_of(columns), bytes_of(rows), bytes_of(wave_table), bytes_of(colour_of(request))};
}

} // namespace gabor::render
