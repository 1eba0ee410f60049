// Fluctuations of the windowed contrast against N, with both weights.

#include "study/figures.hpp"
#include "study/measures.hpp"

#include <fmt/format.h>

namespace gabor::study {

Tables figure4(const vulkan::Device& device, const Effort& effort) {
    // Contrasts are of noise with a standard deviation of 1/4, which keeps 95 % of the histogram in [0, 1].
    constexpr double shown = 0.25;
    Table table{
        "figure4",
        "points,weights,kernel,envelope,N,windows,variance_median,variance_interdecile,deviation_median",
        {}};
    for (const Weights weights : {Weights::bernoulli, Weights::uniform})
        for (const Points points : all_points)
            for (const int n : effort.impulses) {
                const Ingredients ingredients{.points = points, .weights = weights, .impulses = n};
                const std::uint64_t windows = effort.windows;
                table.rows.push_back(
                    {fmt::format("{},{}", key(ingredients), windows),
                     256.0 * n * static_cast<double>(windows),
                     [&device, ingredients, windows](std::uint32_t seed) -> Numbers {
                         Noise noise(device, ingredients);
                         const statistics::InstanceStationarity w =
                             measure_windows(std::span(&noise, 1), windows, seed);
                         return {w.contrast().median, w.contrast().interdecile, shown * w.median_deviation()};
                     }});
            }
    return {table};
}

} // namespace gabor::study
