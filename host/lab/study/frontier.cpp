// The Pareto front of recipes: Gaussianity, number of impulses summed, and spectral purity.

#include "study/figures.hpp"
#include "study/lattice.hpp"
#include "study/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gabor::study {

namespace {

constexpr std::array window_functions{
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

// Indices of measured columns of `recipe_columns`.
enum Column : std::size_t {
    visits = 0,
    places_interdecile = 5,
    places_chance = 6,
    sidelobe = 8,
    cvm_places_high = 12
};

bool dominates(const Numbers& a, const Numbers& b) {
    bool better = false;
    for (const std::size_t column : {visits, cvm_places_high, sidelobe}) {
        if (a[column] > b[column])
            return false;
        better |= a[column] < b[column];
    }
    return better;
}

// Measures all criteria of a noise: the columns of `recipe_columns` that follow the key. `cell` is a cell's
// side in kernel radii.
Numbers criteria(Noise noise, const SpectralPurity& purity, double visits, double cell, const Effort& effort,
                 std::uint32_t seed) {
    const std::span<Noise> sum = single(noise);
    const ValueStatistics values = measure_values(sum, effort.samples, seed);
    const PlaceStatistics places = measure_places(sum, cell, effort.places, seed);
    const statistics::Estimate cvm = values.gaussianity.index();
    const statistics::Estimate at_places = places.mean_cvm();
    return {visits,
            cvm.value,
            cvm.low,
            cvm.high,
            values.moments.variance(),
            places.stationarity.variance().interdecile,
            places.stationarity.chance_interdecile(),
            measure_windows(sum, effort.windows, seed).contrast().interdecile,
            purity.sidelobe,
            purity.outside,
            at_places.value,
            at_places.low,
            at_places.high};
}

double cost(double visits, const Effort& effort) {
    return visits * (static_cast<double>(effort.samples) + 64 * static_cast<double>(effort.places) +
                     256 * static_cast<double>(effort.windows));
}

} // namespace

Row recipe_row(const vulkan::Device& device, const Variant& variant, const Effort& effort) {
    const double visits = visited(variant);
    return {fmt::format("{},{},{},{:.3f},{:g},{},{:g},{}", variant.window.name, name(variant.lattice),
                        name(variant.magnitudes), variant.floor, variant.jitter, variant.impulses,
                        variant.radius, effort.samples),
            cost(visits, effort), [&device, variant, visits, effort](std::uint32_t seed) {
                return criteria(Noise(device, variant), spectral_purity(variant.window), visits,
                                1 / variant.radius, effort, seed);
            }};
}

Row lattice_row(const vulkan::Device& device, const noise::Recipe& recipe, const Effort& effort) {
    const double visits = noise::visited_impulses(recipe);
    return {fmt::format("lattice {} taps,square,normal,0.000,0,1,{:g},{}", recipe.taps, recipe.radius,
                        effort.samples),
            cost(visits, effort), [&device, recipe, visits, effort](std::uint32_t seed) {
                const auto window = [&](double x) { return lattice_window(recipe.taps, x); };
                return criteria(Noise(device, recipe), spectral_purity(window, true), visits,
                                1 / double{recipe.radius}, effort, seed);
            }};
}

Row seminal_row(const vulkan::Device& device, const Effort& effort) {
    const Ingredients seminal;
    const double visits = 9 * seminal.impulses;
    return {fmt::format("gaussian,poisson,uniform_signed,0.000,1,{},1,{}", seminal.impulses, effort.samples),
            cost(visits, effort), [&device, seminal, visits, effort](std::uint32_t seed) {
                return criteria(Noise(device, seminal), spectral_purity({"gaussian", Shape::gaussian}),
                                visits, 1, effort, seed);
            }};
}

void mark_pareto(std::vector<Numbers>& rows) {
    const std::vector<Numbers> all = rows;
    for (Numbers& row : rows) {
        const auto stationary = [](const Numbers& r) {
            return r[places_interdecile] < 0.05 + r[places_chance];
        };
        const bool dominated =
            std::ranges::any_of(all, [&](const Numbers& r) { return stationary(r) && dominates(r, row); });
        row.push_back(stationary(row) && !dominated);
    }
}

Tables frontier(const vulkan::Device& device, const Effort& effort) {
    Table table{"frontier", std::string(recipe_columns), {}, "pareto", mark_pareto};
    table.rows.push_back(seminal_row(device, effort));
    for (const noise::Recipe& recipe : noise::recipes())
        if (recipe.is_lattice())
            table.rows.push_back(lattice_row(device, recipe, effort));
    for (const Window& window : window_functions)
        for (const int n : {1, 2})
            for (const double radius : effort.radii)
                for (const Lattice lattice : {Lattice::square, Lattice::brick}) {
                    Variant variant{window, n, radius, lattice};
                    if (visited(variant) > most_visited)
                        continue;
                    table.rows.push_back(recipe_row(device, variant, effort)); // with Bernoulli weights
                    for (const Magnitudes magnitudes : {Magnitudes::uniform, Magnitudes::two_point}) {
                        variant.magnitudes = magnitudes;
                        variant.floor = best_floor(variant);
                        if (variant.floor < 1)
                            table.rows.push_back(recipe_row(device, variant, effort));
                    }
                }
    return {table};
}

} // namespace gabor::study
