#include "render/bake.hpp"

#include "noise/variance.hpp"

#include "passes/bake.h"
#include "passes/bake_lattice_2.h"
#include "passes/bake_lattice_3.h"
#include "passes/bake_lattice_4.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

constexpr RecipeModules modules{bake_spirv,
                                {bake_lattice_2_spirv, bake_lattice_3_spirv, bake_lattice_4_spirv}};

std::vector<passes::Run> runs_along(const Request& request, int side, int first, int count, int longest) {
    const double radius = axis_along(request, side).radius;
    // The lattice's windows stretch with its nodes to fit a period.
    return make_runs(first, count, radius / request.scale,
                     request.recipe.is_lattice() ? double{request.recipe.radius} : radius, longest);
}

// A lattice's cells are narrow, and to begin a block is most of its cost: few blocks of even width.
Block block_for(const vulkan::Device& device, const Request& request) {
    if (device.info().kind != "CPU")
        return gpu_block(request.recipe);
    if (!request.recipe.is_lattice())
        return cpu_block;
    const double cell = std::ceil(request.scale / double{request.recipe.radius}); // pixels
    return {static_cast<int>(std::ceil(cell / std::ceil(cell / 12))), 32};
}

passes::vec2 turn(double turns) {
    const double angle = 2 * std::numbers::pi * turns;
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

passes::BakePush make_push(const Request& request) {
    const noise::Recipe& recipe = request.recipe;
    const noise::Lobe& lobe = request.lobes.front();
    const double wave_x = lobe.frequency * std::cos(lobe.angle());
    const double wave_y = lobe.frequency * std::sin(lobe.angle());
    passes::BakePush push{};
    push.wave = {static_cast<float>(wave_x), static_cast<float>(wave_y)};
    push.column_turn = turn(wave_x / request.scale);
    push.row_turn = turn(wave_y / request.scale);
    const Axis x = axis_along(request, request.width);
    const Axis y = axis_along(request, request.height);
    push.radius = {static_cast<float>(x.radius), static_cast<float>(y.radius)};
    push.period = {x.period, y.period};
    push.time = wrapped_time(request);
    // The sparse noise's variance is in proportion to the number of impulses per unit area.
    push.amplitude =
        recipe.is_lattice()
            ? 1.0f
            : static_cast<float>(recipe.radius / std::sqrt(x.radius * y.radius *
                                                           noise::variance(recipe, lobe.frequency,
                                                                           lobe.angle(), request.time)));
    push.pixel = static_cast<float>(1 / request.scale);
    push.seed = request.seed;
    return push;
}

} // namespace

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

std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest) {
    const auto position = [&](int pixel) { return (pixel + 0.5) * cells_per_pixel; };
    const auto cell_of = [&](int pixel) {
        return static_cast<std::int32_t>(std::floor(position(pixel) - radius));
    };
    // The first pixel that visits no cell before this one: an estimate, which rounding may have put one off.
    const auto start_of = [&](std::int32_t cell) {
        int pixel = static_cast<int>(std::ceil((cell + radius) / cells_per_pixel - 0.5));
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

vulkan::Pass make_bake_pass(const vulkan::Device& device, const Request& request, int block_columns,
                            int fixed_rows) {
    const auto of_recipe = recipe_constants(request.recipe);
    std::vector<std::uint32_t> constants(of_recipe.begin(), of_recipe.end());
    constants.push_back(vulkan::constant(noise::visited_cells(request.recipe)));
    constants.push_back(vulkan::constant(block_columns));
    constants.push_back(vulkan::constant(fixed_rows));
    constants.push_back(request.quadrature);
    constants.push_back(request.gradient);
    constants.push_back(wrapped_time(request) != 0);
    return {device, modules.of(request.recipe), {3, sizeof(passes::BakePush), fixed_rows > 0}, constants};
}

bool Bake::can_fill(const Request& request) {
    return is_one_wave(request) && request.paint.empty() && std::holds_alternative<Plane>(request.view) &&
           !request.filter && !request.phasor && request.values == 1;
}

Bake::Bake(const vulkan::Device& device, const Request& request, const image::Window& region)
    : block_(block_for(device, request)), height_(region.height),
      column_runs_(runs_along(request, request.width, region.x, region.width, block_.columns)),
      row_runs_(runs_along(request, request.height, region.y, region.height, block_.rows)),
      pass_(make_bake_pass(device, request, block_.columns)), columns_(upload(device, column_runs_)),
      rows_(upload(device, row_runs_)), push_(make_push(request)) {
    push_.width = region.width;
    push_.column_runs = static_cast<std::uint32_t>(column_runs_.size());
}

std::vector<RegionRenderer::Band> Bake::bands(int most_rows) const {
    std::vector<Band> bands;
    for (std::size_t run = 0; run < row_runs_.size(); ++run) {
        const int begin = std::max(row_runs_[run].first, 0);
        const int end = std::min(row_runs_[run].first + row_runs_[run].count, height_);
        if (bands.empty() || end - bands.back().first_row > most_rows)
            bands.push_back({begin, 0, run, 0});
        bands.back().rows = end - bands.back().first_row;
        ++bands.back().runs;
    }
    return bands;
}

vulkan::Job Bake::job(const vulkan::Device& device, const vulkan::Buffer& result) const {
    return {device, pass_, {columns_, rows_, result}};
}

void Bake::submit(vulkan::Job& job, const Band& band, const std::optional<vulkan::Job::Copy>& copy) const {
    passes::BakePush push = push_;
    push.first_row = band.first_row;
    push.height = band.rows;
    push.first_row_run = static_cast<std::uint32_t>(band.first_run);
    job.submit(push,
               {groups(static_cast<int>(push.column_runs), passes::bake_group),
                static_cast<std::uint32_t>(band.runs)},
               copy);
}

} // namespace gabor::render
