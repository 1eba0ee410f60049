#include "bench/subjects.hpp"

#include "render/bake.hpp"

#include "passes/bench/bench_interface.h"
#include "passes/bench/gradient.h"
#include "passes/bench/recipe.h"
#include "passes/bench/recipe_lattice_2.h"
#include "passes/bench/recipe_lattice_3.h"
#include "passes/bench/recipe_lattice_4.h"
#include "passes/bench/seminal.h"
#include "passes/bench/simplex.h"
#include "passes/bench/space.h"
#include "passes/bench/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gabor::bench {

namespace {

constexpr render::RecipeModules modules{
    recipe_spirv, {recipe_lattice_2_spirv, recipe_lattice_3_spirv, recipe_lattice_4_spirv}};

// The options of passes/bench/seminal.comp: impulses per cell, the paper's advice, hoisted.
void add_published(std::vector<Subject>& all) {
    for (const auto& [name, hoisted] : {std::pair{"seminal, N = 30", 0u}, std::pair{seminal_yardstick, 1u}})
        all.push_back({name, 270, seminal_spirv, nullptr, {30, 0, hoisted}, true, true});
    for (const auto& [name, hoisted] :
         {std::pair{"the paper's advice, N = 2, plain", 0u}, std::pair{advice_yardstick, 1u}})
        all.push_back({name, 18, seminal_spirv, nullptr, {2, 1, hoisted}, true});
}

// The option of passes/bench/recipe.comp is the function.
void add_drop_in(std::vector<Subject>& all) {
    for (const noise::Recipe& recipe : noise::recipes())
        all.push_back({fmt::format("gabor_noise, {}", recipe.name),
                       static_cast<double>(noise::visited_impulses(recipe)),
                       modules.of(recipe),
                       &recipe,
                       {0},
                       true});
    constexpr std::array functions{"gradient", "complex and phasor", "tiled",   "animated", "four",
                                   "spread",   "lobes, 3",           "filtered"};
    constexpr std::size_t of_sparse = 4; // the first functions
    for (const noise::Recipe* recipe : {&noise::recipes().front(), &noise::sparse_recipes().front()}) {
        for (std::size_t i = 0; i < (recipe->is_lattice() ? functions.size() : of_sparse); ++i)
            all.push_back({fmt::format("gabor_noise_{}, {}", functions.at(i), recipe->name),
                           static_cast<double>(noise::visited_impulses(*recipe)),
                           modules.of(*recipe),
                           recipe,
                           {static_cast<std::uint32_t>(i + 1)}});
    }
}

// The option of passes/bench/space.comp is the function; each visits 3 x 3 x 3 nodes.
void add_space(std::vector<Subject>& all) {
    std::uint32_t function = 0;
    for (const char* name :
         {"gabor_noise_3d", "gabor_noise_3d_isotropic", "gabor_noise_3d_gradient", "gabor_noise_surface",
          "gabor_noise_surface_isotropic", "gabor_noise_3d_filtered"})
        all.push_back({name, 27, space_spirv, nullptr, {++function}});
}

} // namespace

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    add_published(all);
    add_drop_in(all);
    add_space(all);
    all.push_back({"gradient noise", 0, gradient_spirv});
    all.push_back({"simplex noise", 0, simplex_spirv});
    all.push_back({"writing alone", 0, write_spirv});
    return all;
}

vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use) {
    // A shader ignores the ids that it does not name.
    std::vector<std::uint32_t> constants(20, 0);
    if (subject.recipe)
        std::ranges::copy(render::recipe_constants(*subject.recipe), constants.begin());
    constants[passes::sampling_id] = use == Use::samples;
    std::ranges::copy(subject.options, constants.begin() + passes::option_id);
    return {device, subject.spirv, {1, sizeof(passes::BenchPush), use == Use::statistics}, constants};
}

} // namespace gabor::bench
