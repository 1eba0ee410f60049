#include "study/study.hpp"

#include "error.hpp"
#include "study/figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace gabor::study {

namespace {

constexpr std::array known{
    Study{"figure1", "the point sets", figure1, nullptr},
    Study{"figure2", "Gaussianity against N", figure2, figure2_pictures},
    Study{"figure3", "N at which the seminal noise is as Gaussian as the sum with N impulses per cell",
          figure3, nullptr},
    Study{"figure4", "contrast of windows against N", figure4, nullptr},
    Study{"figure5", "time against N", figure5, nullptr},
    Study{"figure6", "a noise of six lobes, and its time", figure6, figure6_pictures},
    Study{"stationarity", "mean and variance by position in a cell, and means of instances", stationarity,
          nullptr},
    Study{"law", "distributions of single values, by position in a cell, and of pairs; covariance; spectra",
          law, law_pictures},
    Study{"frontier", "the Pareto front of recipes", frontier, nullptr},
    Study{"future", "the paper's open questions", future, nullptr},
};

} // namespace

Effort Effort::full() {
    return {.samples = 7 << 20,
            .windows = 1 << 13,
            .places = 7 << 14,
            .law = 1 << 20,
            .impulses = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 25, 30},
            .radii = {1, 1.06, 1.1, 1.25, 1.5},
            .picture_bits = 9,
            .timings = 9};
}

Effort Effort::quick() {
    return {.samples = 1 << 17,
            .windows = 1 << 9,
            .places = 1 << 11,
            .law = 1 << 12,
            .impulses = {1, 2, 4, 10, 30},
            .radii = {1},
            .picture_bits = 8,
            .timings = 3};
}

std::span<const Study> studies() {
    return known;
}

std::vector<Study> find_studies(std::string_view name) {
    if (name == "all")
        return {known.begin(), known.end()};
    if (const auto found = std::ranges::find(known, name, &Study::name); found != known.end())
        return {*found};
    std::vector<std::string_view> names;
    std::ranges::transform(known, std::back_inserter(names), &Study::name);
    throw RequestError(fmt::format("unknown study '{}': expected {} or all", name, fmt::join(names, ", ")));
}

} // namespace gabor::study
