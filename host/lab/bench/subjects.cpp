#include "bench/subjects.hpp"

#include "recipe_modules.hpp"
#include "render/plan/plan.hpp"
#include "render/plan/plan_parts.hpp"

#include "passes/bench/erosion.h"
#include "passes/bench/erosion_lattice_2.h"
#include "passes/bench/fractal.h"
#include "passes/bench/recipe.h"
#include "passes/bench/recipe_lattice_2.h"
#include "passes/bench/recipe_lattice_3.h"
#include "passes/bench/recipe_lattice_4.h"
#include "passes/bench/space.h"
#include "passes/bench/water.h"
#include "passes/bench/yardsticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gabor::bench {

namespace {

constexpr RecipeModules modules{recipe_spirv,
                                {recipe_lattice_2_spirv, recipe_lattice_3_spirv, recipe_lattice_4_spirv}};

// Adds the functions of passes/bench/yardsticks.comp, in the order of their numbers.
void add_yardsticks(std::vector<Subject>& all) {
    auto add = [&all, number = 0u](std::string_view name, double kernels, bool has_loops = false) mutable {
        all.push_back({std::string(name), kernels, yardsticks_spirv, nullptr, {number++}});
        all.back().has_loops = has_loops;
        all.back().measure_cvm =
            name == advice_yardstick || name == seminal_yardstick || name == dense_yardstick;
    };
    add(perlin_yardstick, 0);
    add("Perlin noise and gradient", 0);
    add("Perlin fBm and gradient, 5 octaves", 0);
    add(simplex_yardstick, 0);
    add(advice_yardstick, 18);
    add("Gabor noise of 72 kernels", 72, true);
    add("phasor noise, 144 kernels", 144, true);
    add("stripes of 16 random splats", 16, true);
    add(seminal_yardstick, 183, true);
    add(dense_yardstick, 270, true);
}

// The options are those of passes/bench/erosion.comp: splats and octaves.
Subject eroded(std::string name, std::span<const std::uint32_t> spirv, bool splats) {
    Subject subject{std::move(name), 0, spirv, nullptr, {splats, 5}};
    subject.octaves = 5;
    return subject;
}

// Adds functions of passes/bench/recipe.comp, in the order of their numbers. Sparse recipes have only the
// first `of_sparse`.
void add_drop_in(std::vector<Subject>& all) {
    static constexpr std::array names{"noise",          "noise_gradient", "noise_quadrature and phasor",
                                      "noise_tiled",    "noise_animated", "noise_spread",
                                      "field_lobes, 3", "noise_filtered", "noise_isotropic"};
    constexpr std::uint32_t of_sparse = 5;
    const auto add = [&all](const noise::Recipe& recipe, std::uint32_t number) {
        all.push_back({fmt::format("gabor_{}, {}", names[number], recipe.name),
                       static_cast<double>(noise::visited_impulses(recipe)),
                       modules.of(recipe),
                       &recipe,
                       {number}});
    };
    for (const noise::Recipe& recipe : noise::recipes()) {
        add(recipe, 0);
        all.back().measure_cvm = true;
    }
    for (std::uint32_t number = 1; number < names.size(); ++number)
        add(noise::recipes().front(), number);
    for (std::uint32_t number = 1; number < of_sparse; ++number)
        add(noise::sparse_recipes().front(), number);
}

// Adds the functions of passes/bench/space.comp, numbered from 1. Each sums 3 x 3 x 3 nodes.
void add_space(std::vector<Subject>& all) {
    std::uint32_t number = 0;
    for (const char* name :
         {"gabor_noise_3d", "gabor_noise_3d_isotropic", "gabor_field_3d", "gabor_noise_surface",
          "gabor_field_surface_isotropic", "gabor_field_3d_filtered"})
        all.push_back({name, 27, space_spirv, nullptr, {++number}});
}

// Adds the functions of passes/bench/fractal.comp, in the order of their numbers. The last option is the
// number of octaves. The code of sums leaves out what turns an octave.
void add_fractal(std::vector<Subject>& all) {
    auto add = [&all, number = 0u](std::string name, int octaves) mutable {
        all.push_back(
            {std::move(name), 0, fractal_spirv, nullptr, {number++, std::max<std::uint32_t>(octaves, 1)}});
        all.back().octaves = octaves;
    };
    add("gabor_smooth", 0);
    add("gabor_perlin", 0);
    add("gabor_perlin and gradient", 0);
    for (const char* name :
         {"gabor_fbm", "gabor_fbm and gradient", "gabor_fbm and gradient, filtered", "gabor_fbm_3d"})
        add(fmt::format("{}, 5 octaves", name), 5);
}

// Adds the functions of passes/bench/water.comp, in the order of their numbers.
void add_water(std::vector<Subject>& all) {
    std::uint32_t number = 0;
    render::Request sea;
    sea.kind = render::Kind::sea;
    for (const char* name : {"gabor_water", "gabor_water_filtered", "gabor_water, height alone",
                             "gabor_water_filtered and gabor_foam"}) {
        all.push_back({name, 36, water_spirv, nullptr, {number++}});
        all.back().has_loops = true;
        all.back().table = render::ocean_table(sea);
    }
}

} // namespace

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    add_drop_in(all);
    add_space(all);
    all.push_back(eroded("gabor_eroded, 5 octaves, 3 taps", erosion_spirv, false));
    all.push_back(eroded("gabor_eroded, 5 octaves, 2 taps", erosion_lattice_2_spirv, false));
    all.push_back(eroded("erosion with 16 random splats, 5 octaves", erosion_spirv, true));
    add_fractal(all);
    add_water(all);
    add_yardsticks(all);
    return all;
}

vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use) {
    std::vector<std::uint32_t> constants(20, 0);
    if (subject.recipe)
        std::ranges::copy(render::recipe_constants(*subject.recipe), constants.begin());
    constants[passes::use_id] = static_cast<std::uint32_t>(use);
    std::ranges::copy(subject.options, constants.begin() + passes::option_id);
    const std::uint32_t buffers = subject.table.empty() ? 1 : 2;
    return {device,
            subject.spirv,
            {buffers, sizeof(passes::BenchPush), use == Use::statistics, buffers == 2, use == Use::timing},
            constants};
}

void submit(vulkan::Job& job, const Setting& setting, std::uint32_t seed) {
    const auto side = static_cast<std::uint32_t>(setting.side);
    const passes::BenchPush push{static_cast<float>(setting.frequency),
                                 static_cast<float>(noise::radians(base_orientation)),
                                 static_cast<float>(1 / setting.scale),
                                 seed,
                                 side,
                                 side,
                                 timed_side * timed_side};
    const std::uint32_t count = (side + passes::bench_group - 1) / passes::bench_group;
    job.submit(push, {count, count});
}

} // namespace gabor::bench
