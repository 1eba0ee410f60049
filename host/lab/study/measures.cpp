#include "study/measures.hpp"

#include "statistics/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace gabor::study {

namespace {

constexpr std::uint64_t batch = 1 << 20; // values per batch

// Calls `visit` with the values of whole instances, many instances at a time.
void for_each_batch(std::span<Noise> sum, const Grid& grid, std::uint64_t instances, std::uint32_t seed,
                    const std::function<void(std::span<const float>)>& visit) {
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
        visit(total);
    }
}

constexpr double pixels_per_radius = 32;

Grid picture_grid(int bits, double scale = pixels_per_radius) {
    return {static_cast<unsigned>(bits), std::ldexp(1 / scale, bits), false};
}

} // namespace

ValueStatistics measure_values(std::span<Noise> sum, std::uint64_t samples, std::uint32_t seed) {
    ValueStatistics result;
    for_each_batch(sum, {}, samples, seed, [&](std::span<const float> values) {
        result.moments.add(values);
        result.gaussianity.add(values);
    });
    return result;
}

statistics::InstanceStationarity measure_windows(std::span<Noise> sum, std::uint64_t windows,
                                                 std::uint32_t seed) {
    constexpr Grid grid{4, 2, true};
    constexpr std::size_t pixels = std::size_t{1} << 2 * grid.bits;
    statistics::InstanceStationarity result;
    for_each_batch(sum, grid, windows, seed, [&](std::span<const float> values) {
        for (; !values.empty(); values = values.subspan(pixels))
            result.add(values.first(pixels));
    });
    return result;
}

PlaceStatistics measure_places(std::span<Noise> sum, double cell, std::uint64_t instances,
                               std::uint32_t seed) {
    constexpr int side = 8;
    PlaceStatistics result;
    for (int place = 0; place < side * side; ++place) {
        const auto coordinate = [&](int index) { return cell * (index + 0.5) / side; };
        const Grid grid{.random = false, .shift = {coordinate(place % side), coordinate(place / side)}};
        statistics::Moments moments;
        statistics::Gaussianity law;
        for_each_batch(sum, grid, instances, seed, [&](std::span<const float> values) {
            moments.add(values);
            law.add(values);
        });
        result.stationarity.add(moments);
        result.cvm.push_back(law.index());
    }
    return result;
}

statistics::Estimate PlaceStatistics::mean_cvm() const {
    statistics::Estimate mean;
    const double share = 1 / static_cast<double>(cvm.size());
    for (const statistics::Estimate& place : cvm) {
        mean.value += share * place.value;
        mean.low += share * place.low;
        mean.high += share * place.high;
    }
    return mean;
}

std::vector<double> measure_means(std::span<Noise> sum, double side, std::uint64_t instances,
                                  std::uint32_t seed) {
    const Grid grid{6, side, false};
    const std::size_t pixels = std::size_t{1} << 2 * grid.bits;
    std::vector<double> means;
    for_each_batch(sum, grid, instances, seed, [&](std::span<const float> values) {
        for (; !values.empty(); values = values.subspan(pixels)) {
            const auto window = values.first(pixels);
            means.push_back(std::reduce(window.begin(), window.end(), 0.0) / static_cast<double>(pixels));
        }
    });
    return means;
}

std::vector<double> picture_seconds(std::span<Noise> noises, int bits, int timings) {
    std::vector<float> pixels(std::size_t{1} << 2 * bits);
    std::vector<std::vector<double>> rounds(noises.size());
    for (int round = 0; round < timings; ++round)
        for (std::size_t i = 0; i < noises.size(); ++i)
            rounds[i].push_back(noises[i].fill(pixels, picture_grid(bits), 0, 1, 1));
    std::vector<double> medians;
    for (const std::vector<double>& seconds : rounds)
        medians.push_back(statistics::quantile(seconds, 0.5));
    return medians;
}

std::vector<float> picture(Noise& noise, int bits, std::uint32_t seed, double scale) {
    std::vector<float> pixels(std::size_t{1} << 2 * bits);
    noise.fill(pixels, picture_grid(bits, scale), 0, seed, 1);
    return pixels;
}

} // namespace gabor::study
