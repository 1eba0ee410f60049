#include "noise/recipe.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gabor::noise {

namespace {

constexpr std::array known{
    Recipe{"one", 1, 1.0f, 0.675f, 256, {3, -4.5f, 2.5f}, "one impulse per cell, the fastest"},
    Recipe{"pure", 1, 1.5f, 0.5f, 256, {1, -1, 1}, "the lowest sidelobes"},
    Recipe{"paper", 2, 1.0f, 1.0f, 2, {1, 0, 0}, "the paper's advice"},
};

} // namespace

std::span<const Recipe> recipes() {
    return known;
}

const Recipe& find_recipe(std::string_view name) {
    const auto found = std::ranges::find(known, name, &Recipe::name);
    if (found != known.end())
        return *found;
    std::vector<std::string_view> names;
    std::ranges::transform(known, std::back_inserter(names), &Recipe::name);
    throw RequestError(fmt::format("unknown recipe '{}': the recipes are {}", name, fmt::join(names, ", ")));
}

int visited_cells(const Recipe& recipe) {
    return static_cast<int>(std::ceil(2 * recipe.radius)) + 1;
}

int visited_impulses(const Recipe& recipe) {
    return visited_cells(recipe) * visited_cells(recipe) * recipe.impulses;
}

} // namespace gabor::noise
