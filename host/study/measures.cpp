#include "study/measures.hpp"

#include "statistics/normal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace gabor::study {

namespace {

constexpr std::uint64_t batch = 1 << 20; // values

// Hands the values of whole instances to `take`, many instances at a time.
void for_each_batch(std::span<Noise> sum, const Grid& grid, std::uint64_t instances, std::uint32_t seed,
                    const std::function<void(std::span<const float>)>& take) {
    const std::uint64_t per_batch = batch >> 2 * grid.bits;
    std::vector<float> total;
    std::vector<float> part;
    for (std::uint64_t first = 0; first < instances; first += per_batch) {
        const std::size_t count =
            static_cast<std::size_t>(std::min(per_batch, instances - first) << 2 * grid.bits);
        total.assign(count, 0);
        part.resize(count);
        std::uint32_t noise_seed = seed;
        for (Noise& noise : sum) {
            noise.fill(part, grid, static_cast<std::uint32_t>(first), ++noise_seed, ~seed);
            std::ranges::transform(total, part, total.begin(), std::plus<>());
        }
        take(total);
    }
}

} // namespace

OneValue measure_values(std::span<Noise> sum, std::uint64_t samples, std::uint32_t seed, double deviation) {
    OneValue result{{}, statistics::Gaussianity(deviation)};
    for_each_batch(sum, {}, samples, seed, [&](std::span<const float> values) {
        result.moments.add(values);
        result.gaussianity.add(values);
    });
    return result;
}

Windows measure_windows(std::span<Noise> sum, std::uint64_t windows, std::uint32_t seed) {
    constexpr Grid grid{4, 2, true};
    constexpr std::size_t pixels = std::size_t{1} << 2 * grid.bits;
    std::vector<double> contrasts;
    std::vector<double> deviations;
    std::vector<double> means;
    for_each_batch(sum, grid, windows, seed, [&](std::span<const float> values) {
        for (; !values.empty(); values = values.subspan(pixels)) {
            statistics::Moments moments;
            moments.add(values.first(pixels));
            contrasts.push_back(moments.variance());
            deviations.push_back(std::sqrt(moments.variance()));
            means.push_back(moments.mean());
        }
    });
    return {spread(contrasts), quantile(deviations, 0.5), quantile(means, 0.5),
            quantile(means, 0.9) - quantile(means, 0.1)};
}

Places measure_places(std::span<Noise> sum, double cell, std::uint64_t instances, std::uint32_t seed) {
    const Grid grid{3, cell, false};
    std::vector<statistics::Moments> places(std::size_t{1} << 2 * grid.bits);
    for_each_batch(sum, grid, instances, seed, [&](std::span<const float> values) {
        for (std::size_t i = 0; i < values.size(); ++i)
            places[i % places.size()].add(values[i]);
    });
    Places result;
    statistics::Moments all;
    std::vector<double> variances;
    for (const statistics::Moments& place : places) {
        variances.push_back(place.variance());
        result.largest_mean = std::max(result.largest_mean, std::abs(place.mean()));
        all.merge(place);
    }
    result.variance = spread(variances);
    // A variance from n samples has the relative variance (excess kurtosis + 2) / n; its deciles are those of
    // a normal law.
    const double n = static_cast<double>(instances);
    result.variance_chance =
        2 * statistics::normal_quantile(0.9) * std::sqrt((all.excess_kurtosis() + 2) / n);
    const double count = static_cast<double>(places.size());
    result.mean_chance = statistics::normal_quantile(1 - 0.05 / (2 * count)) * std::sqrt(all.variance() / n);
    return result;
}

std::vector<double> measure_means(std::span<Noise> sum, double side, std::uint64_t instances,
                                  std::uint32_t seed) {
    const Grid grid{6, side, false};
    const std::size_t pixels = std::size_t{1} << 2 * grid.bits;
    std::vector<double> means;
    for_each_batch(sum, grid, instances, seed, [&](std::span<const float> values) {
        for (; !values.empty(); values = values.subspan(pixels))
            means.push_back(std::reduce(values.begin(), values.begin() + pixels, 0.0) /
                            static_cast<double>(pixels));
    });
    return means;
}

} // namespace gabor::study
