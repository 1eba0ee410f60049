// The mean and variance at each position in a cell, and the means of whole instances.

#include "study/figures.hpp"
#include "study/measures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gabor::study {

namespace {

Row places_row(const vulkan::Device& device, const Ingredients& ingredients, std::uint64_t instances) {
    return {fmt::format("{},{}", csv_fields(ingredients), instances),
            64.0 * ingredients.impulses * static_cast<double>(instances),
            [&device, ingredients, instances](std::uint32_t seed) -> Numbers {
                Noise noise(device, ingredients);
                const statistics::ProcessStationarity places =
                    measure_places(single(noise), 1, instances, seed).stationarity;
                return {places.variance().median, places.variance().interdecile, places.chance_interdecile(),
                        places.largest_mean(), places.chance_largest_mean()};
            }};
}

Row mean_row(const vulkan::Device& device, const Ingredients& ingredients, std::uint64_t instances) {
    return {fmt::format("{},{},{}", csv_fields(ingredients), ingredients.period, instances),
            4096.0 * ingredients.impulses * static_cast<double>(instances),
            [&device, ingredients, instances](std::uint32_t seed) -> Numbers {
                Noise noise(device, ingredients);
                const std::vector<double> means = measure_means(single(noise), 3, instances, seed);
                const auto quantile = [&](double share) { return statistics::quantile(means, share); };
                constexpr double percent = 100.0 / 4; // percent of the value range: four standard deviations
                return {percent * quantile(0.5), percent * (quantile(0.9) - quantile(0.1)),
                        percent * std::max(quantile(1), -quantile(0))};
            }};
}

} // namespace

Tables stationarity(const vulkan::Device& device, const Effort& effort) {
    Table places{"stationarity",
                 "points,weights,kernel,envelope,N,instances,variance_median,variance_interdecile,"
                 "variance_chance,mean_largest,mean_chance",
                 {}};
    for (const Weights weights : {Weights::uniform, Weights::bernoulli})
        for (const Points points : all_points)
            for (const int n : {1, 2, 4, 16})
                places.rows.push_back(
                    places_row(device, {.points = points, .weights = weights, .impulses = n}, effort.places));

    Table means{"instance_mean",
                "points,weights,kernel,envelope,N,period,instances,mean_percent,interdecile_percent,"
                "largest_percent",
                {}};
    for (const int period : {0, 3})
        for (const Kernel kernel : {Kernel::cosine, Kernel::sine})
            for (const Envelope envelope : {Envelope::gaussian, Envelope::c1_separable}) {
                means.rows.push_back(
                    mean_row(device, {Points::stratified, Weights::bernoulli, kernel, envelope, 2, period},
                             effort.places / 64));
                means.rows.push_back(
                    mean_row(device, {Points::poisson, Weights::uniform, kernel, envelope, 30, period},
                             effort.places / 64));
            }
    return {places, means};
}

} // namespace gabor::study
