#include "noise/recipe.hpp"

#include "noise/glsl_literal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace gabor::noise {

namespace {

constexpr Recipe lattice(std::string_view name, int taps, std::string_view is) {
    return {name, 1, 0.5f * static_cast<float>(taps), 0, 0, {}, is, taps};
}

// The lattice recipes come first, then the sparse ones. The first of each kind is its drop-in's default.
constexpr std::array known{
    lattice("lattice", 3, "exactly normal at every point, the best compromise"),
    lattice("lattice-2", 2, "two nodes along each axis, the fastest"),
    lattice("lattice-4", 4, "four nodes along each axis; its covariance depends least on the position"),
    Recipe{"one", 1, 1.0f, 0.675f, 256, {3, -4.5f, 2.5f}, "one random impulse per cell"},
    Recipe{"pure", 1, 1.5f, 0.5f, 256, {1, -1, 1}, "the lowest sidelobes"},
    Recipe{"paper", 2, 1.0f, 1.0f, 2, {1, 0, 0}, "the paper's advice"},
};

} // namespace

std::span<const Recipe> recipes() {
    return known;
}

std::span<const Recipe> sparse_recipes() {
    const auto first = std::ranges::find(known, 0, &Recipe::taps);
    return {first, known.end()};
}

std::string_view drop_in(const Recipe& recipe) {
    return recipe.is_lattice() ? "gabor_noise.glsl" : "gabor_sparse.glsl";
}

const Recipe& find_recipe(std::string_view name) {
    const auto found = std::ranges::find(known, name, &Recipe::name);
    if (found == known.end())
        throw std::out_of_range(fmt::format("no recipe is called '{}'", name));
    return *found;
}

std::vector<Macro> macros(const Recipe& recipe) {
    const auto all = [](const Recipe& r) -> std::vector<Macro> {
        if (r.is_lattice())
            return {{"GABOR_TAPS", fmt::to_string(r.taps)}};
        return {{"GABOR_IMPULSES", fmt::to_string(r.impulses)},
                {"GABOR_CELLS_PER_RADIUS", literal(r.radius)},
                {"GABOR_WEIGHT_FLOOR", literal(r.weight_floor)},
                {"GABOR_PHASES", fmt::to_string(r.phases)},
                {"GABOR_WINDOW", literal(r.window)}};
    };
    const std::vector<Macro> standard = all(recipe.is_lattice() ? known.front() : sparse_recipes().front());
    std::vector<Macro> macros = all(recipe);
    std::erase_if(macros, [&](const Macro& own) { return std::ranges::count(standard, own) > 0; });
    return macros;
}

int visited_cells(const Recipe& recipe) {
    if (recipe.is_lattice())
        return recipe.taps;
    return static_cast<int>(std::ceil(2 * recipe.radius)) + 1;
}

int visited_impulses(const Recipe& recipe) {
    return visited_cells(recipe) * visited_cells(recipe) * recipe.impulses;
}

} // namespace gabor::noise
