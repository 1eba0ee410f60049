#include "noise/variance.hpp"
#include "render/plan_parts.hpp"

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

// `scale` is in values per kernel radius.
passes::BakeWave make_wave(const Request& request, std::size_t index, const noise::Wave& wave, const Axis& x,
                           const Axis& y, double scale) {
    const noise::Recipe recipe = drawing_recipe(request);
    const std::array<double, 2> turns = wave.in_kernels();
    // The variance of sparse noise is proportional to its impulses per unit area.
    const double normalized =
        recipe.is_lattice()
            ? 1
            : recipe.radius / std::sqrt(x.radius * y.radius *
                                        noise::variance(recipe, wave.frequency * wave.radius[0], wave.angle,
                                                        request.time));  // sparse kernels are round
    const double amplitude = request.colour ? 1 : std::sqrt(wave.share); // colours use weights instead
    constexpr double tau = 2 * std::numbers::pi;
    passes::BakeWave result{vec2_of(turns),
                            direction(tau * (turns[0] / (scale * wave.radius[0]))),
                            direction(tau * (turns[1] / (scale * wave.radius[1]))),
                            static_cast<float>(amplitude * normalized),
                            wave.seed,
                            {}};
    put_weights(result.weights, request, index);
    return result;
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
    const std::vector<noise::Wave> waves = noise::waves(request.lobes, request.seed, in_space(request));
    const double values_per_radius = request.scale * viewport.camera.zoom / viewport.stride;
    const image::Rect& region = viewport.region;
    std::vector<passes::Run> columns;
    std::vector<passes::Run> rows;
    std::vector<passes::BakeWave> wave_table;
    for (const std::array<double, 2>& radius : noise::radii(waves)) {
        const Axis x = axis_along(request, request.width, radius[0]);
        const Axis y = axis_along(request, request.height, radius[1]);
        const Block block = block_for(recipe, device, viewport.blocks, values_per_radius * radius[0]);
        const auto runs = [&](const Axis& axis, double radius_along, const Coordinate& corner, int first,
                              int count, int longest) {
            // The lattice's windows stretch with its nodes to fit a period.
            const double reach = recipe.is_lattice() ? double{recipe.radius} : axis.radius;
            const auto [cell, place] = cell_at(corner, axis.radius / radius_along);
            std::vector<passes::Run> made = make_runs(
                first, count, axis.radius / (values_per_radius * radius_along), reach, longest, place);
            for (passes::Run& run : made) // cells wrap around at 2^31
                run.cell = static_cast<std::int32_t>(static_cast<std::uint32_t>(run.cell) +
                                                     static_cast<std::uint32_t>(cell));
            return made;
        };
        const std::vector<passes::Run> across =
            runs(x, radius[0], corner_of(viewport.camera.x, viewport.width, request, viewport), region.x,
                 region.width, block.columns);
        const std::vector<passes::Run> down =
            runs(y, radius[1], corner_of(viewport.camera.y, viewport.height, request, viewport), region.y,
                 region.height, block.rows);
        auto push = push_of<passes::BakePush>(
            {0, 0, region.width, region.height}); // runs count pixels from the region's corner
        push.radius = vec2_of(x.radius, y.radius);
        push.period = {x.period, y.period};
        push.time = wrapped_time(request);
        push.stretch = vec2_of(1 / radius[0], 1 / radius[1]);
        push.pixel = vec2_of(1 / (values_per_radius * radius[0]), 1 / (values_per_radius * radius[1]));
        if (const Slice* slice = std::get_if<Slice>(&request.view)) {
            const double nodes = double{recipe.radius};
            const double place = slice->depth / radius[0] * nodes;
            push.first_slice = static_cast<int>(std::floor(place - nodes)) + 1;
            push.slice_offset = static_cast<float>(place - push.first_slice - 1);
        }
        push.first_wave = static_cast<std::uint32_t>(wave_table.size());
        for (std::size_t i = 0; i < waves.size(); ++i)
            if (waves[i].radius == radius) {
                passes::BakeWave wave = make_wave(request, i, waves[i], x, y, values_per_radius);
                wave.amplitude *= share_left(request, viewport, waves[i].frequency);
                wave_table.push_back(wave);
            }
        push.wave_count = static_cast<std::uint32_t>(wave_table.size()) - push.first_wave;
        push.first_column_run = static_cast<std::uint32_t>(columns.size());
        push.column_runs = static_cast<std::uint32_t>(across.size());
        push.first_run = static_cast<std::uint32_t>(rows.size());
        columns.insert(columns.end(), across.begin(), across.end());
        rows.insert(rows.end(), down.begin(), down.end());

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
    if (request.colour) {
        Step& step = plan.steps.emplace_back();
        step.shader = "bake_colour";
        step.constants[passes::channels_id] = vulkan::constant(static_cast<int>(plan.channels.size()));
        step.push = plan.steps.front().push;
        step.across = region.width;
        step.group = {passes::bake_group, 1};
    }
    plan.tables = {bytes_of(columns), bytes_of(rows), bytes_of(wave_table), bytes_of(colour_of(request))};
}

} // namespace gabor::render
