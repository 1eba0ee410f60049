// Gaussianity against impulses visited and spectral purity: which recipes does no other beat?

#include "study/figures.hpp"
#include "study/recipe_rows.hpp"

#include <algorithm>
#include <array>

namespace gabor::study {

namespace {

constexpr std::array windows{
    Window{"u2", Shape::separable, {1, 0, 0}},
    Window{"u2(1.5-0.5u)", Shape::separable, {1.5, -0.5, 0}},
    Window{"u2(2-u)", Shape::separable, {2, -1, 0}},
    Window{"u2(3-4.5u+2.5u2)", Shape::separable, {3, -4.5, 2.5}},
    Window{"u2(1-u+u2)", Shape::separable, {1, -1, 1}},
    Window{"radial u2", Shape::radial, {1, 0, 0}},
    Window{"radial u2(1.5-0.5u)", Shape::radial, {1.5, -0.5, 0}},
    Window{"gaussian", Shape::gaussian},
};
constexpr double most_visited = 20;

// Columns of `recipe_columns` that are measured.
enum Column : std::size_t {
    visits = 0,
    cvm_high = 3,
    places_interdecile = 5,
    places_chance = 6,
    sidelobe = 8
};

bool beats(const Numbers& a, const Numbers& b) {
    bool better = false;
    for (const std::size_t column : {visits, cvm_high, sidelobe}) {
        if (a[column] > b[column])
            return false;
        better |= a[column] < b[column];
    }
    return better;
}

void mark_pareto(std::vector<Numbers>& rows) {
    const std::vector<Numbers> all = rows;
    for (Numbers& row : rows) {
        const auto stationary = [](const Numbers& r) {
            return r[places_interdecile] < 0.05 + r[places_chance];
        };
        const bool beaten =
            std::ranges::any_of(all, [&](const Numbers& r) { return stationary(r) && beats(r, row); });
        row.push_back(stationary(row) && !beaten);
    }
}

} // namespace

Tables frontier(const vulkan::Device& device, const Effort& effort) {
    Table table{"frontier", std::string(recipe_columns), {}, "pareto", mark_pareto};
    table.rows.push_back(seminal_row(device, effort));
    for (const Window& window : windows)
        for (const int n : {1, 2})
            for (const double radius : effort.radii)
                for (const Lattice lattice : {Lattice::square, Lattice::brick}) {
                    Variant variant{window, n, radius, lattice};
                    if (visited(variant) > most_visited)
                        continue;
                    table.rows.push_back(recipe_row(device, variant, effort)); // Bernoulli
                    for (const Law law : {Law::uniform, Law::two_point}) {
                        variant.law = law;
                        variant.floor = best_floor(variant);
                        if (variant.floor < 1)
                            table.rows.push_back(recipe_row(device, variant, effort));
                    }
                }
    return {table};
}

} // namespace gabor::study
