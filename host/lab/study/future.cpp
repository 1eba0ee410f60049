// The paper's open questions: no weights, regular grids with random phases, and several kernels of similar
// frequency.

#include "study/figures.hpp"
#include "study/measures.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gabor::study {

namespace {

// The sine kernel without weights, and with Bernoulli weights for comparison.
Table unweighted(const vulkan::Device& device, const Effort& effort) {
    Table table{"future_unweighted",
                "points,weights,kernel,envelope,N,frequency,samples,variance,cvm,cvm_low,cvm_high,"
                "places_interdecile,places_chance,mean_largest,mean_chance,contrast_interdecile",
                {}};
    for (const double frequency : {0.5, 1.0, 2.0, 4.0})
        for (const Weights weights : {Weights::none, Weights::bernoulli})
            for (const Points points : {Points::stratified, Points::jittered})
                for (const int n : {1, 2, 4}) {
                    const Ingredients noise{points, weights, Kernel::sine, Envelope::gaussian, n, 0};
                    table.rows.push_back(
                        {fmt::format("{},{:g},{}", csv_fields(noise), frequency, effort.samples),
                         n * (static_cast<double>(effort.samples) + 64 * static_cast<double>(effort.places) +
                              256 * static_cast<double>(effort.windows)),
                         [&device, noise, frequency, effort](std::uint32_t seed) -> Numbers {
                             Noise made(device, noise, PlaneWave{frequency});
                             const auto sum = single(made);
                             const ValueStatistics values = measure_values(sum, effort.samples, seed);
                             const double variance = values.moments.variance();
                             const statistics::Estimate cvm = values.gaussianity.index(std::sqrt(variance));
                             const statistics::ProcessStationarity places =
                                 measure_places(sum, 1, effort.places, seed).stationarity;
                             return {variance,
                                     cvm.value,
                                     cvm.low,
                                     cvm.high,
                                     places.variance().interdecile,
                                     places.chance_interdecile(),
                                     places.largest_mean(),
                                     places.chance_largest_mean(),
                                     measure_windows(sum, effort.windows, seed).contrast().interdecile};
                         }});
                }
    return table;
}

// Impulses at the nodes of a grid or at random positions, with random phases alone or with complex normal
// amplitudes.
Table grids(const vulkan::Device& device, const Effort& effort) {
    Table table{"future_grids", std::string(recipe_columns), {}};
    for (const Window& window :
         {Window{"u2", Shape::separable, {1, 0, 0}}, Window{"u2(1-u+u2)", Shape::separable, {1, -1, 1}},
          Window{"gaussian", Shape::gaussian}})
        for (const double radius : {1.0, 1.5, 2.0})
            for (const double jitter : {0.0, 1.0})
                for (const Magnitudes magnitudes : {Magnitudes::two_point, Magnitudes::rayleigh})
                    table.rows.push_back(recipe_row(
                        device, {window, 1, radius, Lattice::square, magnitudes, 1, jitter}, effort));
    return table;
}

// The sum of K recommended noises with N impulses per cell, whose frequencies are one step apart.
Table kernels(const vulkan::Device& device, const Effort& effort) {
    Table table{"future_kernels", "kernels,step,N,samples,cvm,cvm_low,cvm_high,contrast_interdecile", {}};
    for (const int count : {1, 2, 3, 6})
        for (const double step : {0.0, 0.1, 0.3, 1.0})
            for (const int n : {1, 2})
                table.rows.push_back(
                    {fmt::format("{},{:g},{},{}", count, step, n, effort.samples),
                     count * n *
                         (static_cast<double>(effort.samples) + 256 * static_cast<double>(effort.windows)),
                     [&device, count, step, n, effort](std::uint32_t seed) -> Numbers {
                         Ingredients ingredients = recommended;
                         ingredients.impulses = n;
                         std::vector<Noise> sum;
                         for (int i = 0; i < count; ++i)
                             sum.emplace_back(device, ingredients, PlaneWave{4 + i * step}, 1.0 / count);
                         const statistics::Estimate cvm =
                             measure_values(sum, effort.samples, seed).gaussianity.index();
                         return {cvm.value, cvm.low, cvm.high,
                                 measure_windows(sum, effort.windows, seed).contrast().interdecile};
                     }});
    return table;
}

} // namespace

Tables future(const vulkan::Device& device, const Effort& effort) {
    return {unweighted(device, effort), grids(device, effort), kernels(device, effort)};
}

} // namespace gabor::study
