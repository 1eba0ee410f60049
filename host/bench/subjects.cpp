#include "bench/subjects.hpp"

#include "render/bake.hpp"

#include "passes/bench/bench_interface.h"
#include "passes/bench/gradient.h"
#include "passes/bench/recipe.h"
#include "passes/bench/seminal.h"
#include "passes/bench/space.h"
#include "passes/bench/write.h"

#include <fmt/format.h>

#include <algorithm>

namespace gabor::bench {

std::vector<Subject> subjects() {
    std::vector<Subject> all{
        {"seminal, N = 30", 270, seminal_spirv, nullptr, 30, false},
        {"the paper's advice, N = 2, plain", 18, seminal_spirv, nullptr, 2, true},
    };
    for (const noise::Recipe& recipe : noise::recipes())
        all.push_back({fmt::format("gabor_noise, {}", recipe.name),
                       static_cast<double>(noise::visited_impulses(recipe)), recipe_spirv, &recipe, 0,
                       false});
    const noise::Recipe& one = noise::recipes().front();
    std::uint32_t entry = 0;
    for (const char* function : {"gradient", "complex and phasor", "four", "tiled", "animated", "spread",
                                 "lobes, 3", "lobes, 16", "filtered"})
        all.push_back({fmt::format("gabor_noise_{}, {}", function, one.name),
                       static_cast<double>(noise::visited_impulses(one)), recipe_spirv, &one, 0, false,
                       ++entry});
    entry = 0; // of passes/bench/space.comp, where 3 x 3 x 3 cells are visited
    for (const char* function : {"gabor_noise_3d", "gabor_noise_3d_isotropic", "gabor_noise_3d_gradient",
                                 "gabor_noise_surface", "gabor_noise_surface_isotropic"})
        all.push_back({function, 27, space_spirv, nullptr, 0, false, ++entry});
    all.push_back({"gradient noise", 0, gradient_spirv, nullptr, 0, false});
    all.push_back({"writing alone", 0, write_spirv, nullptr, 0, false});
    return all;
}

vulkan::Pass make_pass(const vulkan::Device& device, const Subject& subject, Use use, bool native_sine) {
    // Ids 0 to 6 are the recipe's, 20 its sine; what a shader does not name it does not see.
    std::vector<std::uint32_t> constants(21, 0);
    if (subject.recipe)
        std::ranges::copy(render::recipe_constants(*subject.recipe), constants.begin());
    constants[7] = use == Use::samples;
    constants[8] = subject.mean_impulses;
    constants[9] = subject.advice;
    constants[10] = subject.entry;
    constants[20] = native_sine;
    return {device, subject.spirv, {1, sizeof(passes::BenchPush), use == Use::statistics}, constants};
}

} // namespace gabor::bench
