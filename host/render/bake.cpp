#include "render/bake.hpp"

#include "noise/variance.hpp"
#include "render/axis.hpp"

#include "passes/bake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

constexpr std::uint32_t group = 32; // local_size_x of passes/bake.comp

std::vector<Run> runs_along(const Picture& picture, int side, int first, int count, int longest) {
    const double radius = axis_along(picture, side).radius;
    return make_runs(first, count, radius / picture.scale, radius, longest);
}

Block block_for(const vulkan::Device& device, const noise::Recipe& recipe) {
    return device.info().kind == "CPU" ? cpu_block : gpu_block(recipe);
}

BakePush make_push(const Picture& picture) {
    const noise::Recipe& recipe = noise::find_recipe(picture.recipe);
    const double radians = std::remainder(picture.orientation, 360.0) * std::numbers::pi / 180;
    const double wave_x = picture.frequency * std::cos(radians);
    const double wave_y = picture.frequency * std::sin(radians);
    const double column_turn = 2 * std::numbers::pi * wave_x / picture.scale;
    const double row_turn = 2 * std::numbers::pi * wave_y / picture.scale;
    BakePush push{};
    push.wave_x = static_cast<float>(wave_x);
    push.wave_y = static_cast<float>(wave_y);
    push.column_turn_x = static_cast<float>(std::cos(column_turn));
    push.column_turn_y = static_cast<float>(std::sin(column_turn));
    push.row_turn_x = static_cast<float>(std::cos(row_turn));
    push.row_turn_y = static_cast<float>(std::sin(row_turn));
    const Axis x = axis_along(picture, picture.width);
    const Axis y = axis_along(picture, picture.height);
    push.radius_x = static_cast<float>(x.radius);
    push.radius_y = static_cast<float>(y.radius);
    push.period_x = x.period;
    push.period_y = y.period;
    push.time = static_cast<float>(picture.time - std::floor(picture.time));
    // The variance is in proportion to the number of impulses per unit area.
    push.amplitude = static_cast<float>(
        recipe.radius /
        std::sqrt(x.radius * y.radius * noise::variance(recipe, picture.frequency, radians, picture.time)));
    push.pixel = static_cast<float>(1 / picture.scale);
    push.seed = picture.seed;
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
    return {noise::visited_impulses(recipe) > 9 ? 2 : 4, 16};
}

vulkan::Pass make_bake_pass(const vulkan::Device& device, const Picture& picture, int block_columns,
                            int fixed_rows) {
    const noise::Recipe& recipe = noise::find_recipe(picture.recipe);
    const auto of_recipe = recipe_constants(recipe);
    std::vector<std::uint32_t> constants(of_recipe.begin(), of_recipe.end());
    constants.push_back(vulkan::constant(noise::visited_cells(recipe)));
    constants.push_back(vulkan::constant(block_columns));
    constants.push_back(vulkan::constant(fixed_rows));
    constants.push_back(picture.quadrature);
    constants.push_back(picture.gradient);
    return {device, bake_spirv, {3, sizeof(BakePush), fixed_rows > 0}, constants};
}

bool Bake::can_fill(const Picture& picture) {
    return picture.lobes.empty() && picture.frequency_spread == 0 && picture.orientation_spread == 0 &&
           picture.paint.empty() && picture.view == "flat" && !picture.filter && !picture.phasor &&
           picture.values == 1;
}

Bake::Bake(const vulkan::Device& device, const Picture& picture, const image::Window& region)
    : block_(block_for(device, noise::find_recipe(picture.recipe))), height_(region.height),
      column_runs_(runs_along(picture, picture.width, region.x, region.width, block_.columns)),
      row_runs_(runs_along(picture, picture.height, region.y, region.height, block_.rows)),
      pass_(make_bake_pass(device, picture, block_.columns)), columns_(upload(device, column_runs_)),
      rows_(upload(device, row_runs_)), push_(make_push(picture)) {
    push_.width = region.width;
    push_.column_runs = static_cast<std::uint32_t>(column_runs_.size());
}

std::vector<Filler::Band> Bake::bands(int most_rows) const {
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
    BakePush push = push_;
    push.first_row = band.first_row;
    push.height = band.rows;
    push.first_row_run = static_cast<std::uint32_t>(band.first_run);
    job.submit(push, {(push.column_runs + group - 1) / group, static_cast<std::uint32_t>(band.runs)}, copy);
}

} // namespace gabor::render
