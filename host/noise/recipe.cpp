#include "noise/recipe.hpp"

#include "noise/glsl_literal.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
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

constexpr int most_impulses = 16;
constexpr float largest_radius = 3;

// Tells whether the sparse noise accepts these values.
bool acceptable(const Recipe& recipe) {
    const auto& c = recipe.window;
    // A window without energy cannot be normalized.
    const double energy = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]);
    return recipe.impulses >= 1 && recipe.impulses <= most_impulses && recipe.radius >= 1 &&
           recipe.radius <= largest_radius && recipe.weight_floor >= 0 && recipe.weight_floor <= 1 &&
           recipe.phases >= 2 && recipe.phases <= 256 &&
           std::has_single_bit(static_cast<unsigned>(recipe.phases)) && energy >= 0.01 && energy <= 100;
}

std::string fields(const Recipe& recipe) {
    return fmt::format("N={},R={},A={},phases={},window={}:{}:{}", recipe.impulses, recipe.radius,
                       recipe.weight_floor, recipe.phases, recipe.window[0], recipe.window[1],
                       recipe.window[2]);
}

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

Recipe find_recipe(std::string_view text) {
    const auto found = std::ranges::find(known, text, &Recipe::name);
    if (found != known.end())
        return *found;
    Recipe own{"custom", 0, 0, 0, 0, {}, "given by its values"};
    const std::string copy(text);
    int length = 0;
    const int read =
        std::sscanf(copy.c_str(), "N=%d,R=%f,A=%f,phases=%d,window=%f:%f:%f%n", &own.impulses, &own.radius,
                    &own.weight_floor, &own.phases, &own.window[0], &own.window[1], &own.window[2], &length);
    if (read == 7 && static_cast<std::size_t>(length) == copy.size() && acceptable(own)) {
        const auto same = std::ranges::find(sparse_recipes(), fields(own), fields);
        return same == sparse_recipes().end() ? own : *same;
    }
    throw RequestError(fmt::format("'{}': expected {}", text, accepted_recipes()));
}

std::string accepted_recipes() {
    std::vector<std::string_view> names;
    std::ranges::transform(known, std::back_inserter(names), &Recipe::name);
    return fmt::format(
        "{}, or a recipe like {} with N from 1 to {}, R from 1 to {}, A from 0 to 1, and 2, 4, 8 ... "
        "or 256 phases",
        fmt::join(names, ", "), fields(sparse_recipes().front()), most_impulses, largest_radius);
}

std::string to_string(const Recipe& recipe) {
    if (recipe.is_lattice())
        return std::string(recipe.name);
    const auto same = std::ranges::find(sparse_recipes(), fields(recipe), fields);
    return same == sparse_recipes().end() ? fields(recipe) : std::string(same->name);
}

std::vector<Macro> macros(const Recipe& recipe) {
    const auto all = [](const Recipe& r) -> std::vector<Macro> {
        if (r.is_lattice())
            return {{"GABOR_TAPS", fmt::to_string(r.taps)}};
        return {{"GABOR_IMPULSES", fmt::to_string(r.impulses)},
                {"GABOR_RADIUS", literal(r.radius)},
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
