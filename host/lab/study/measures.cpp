#include "study/measures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace gabor::study {

namespace {

constexpr std::uint64_t batch = 1 << 20; // values

// Calls `visit` with the values of whole instances, many instances at a time.
void for_each_batch(std::span<Noise> sum, const Grid& grid, const Piece::Range& instances, std::uint32_t seed,
                    const std::function<void(std::span<const float>)>& visit) {
    const std::uint64_t per_batch = batch >> 2 * grid.bits;
    std::vector<float> total;
    std::vector<float> part;
    for (std::uint64_t first = instances.begin; first < instances.end; first += per_batch) {
        const std::size_t count =
            static_cast<std::size_t>(std::min(per_batch, instances.end - first) << 2 * grid.bits);
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

Piece::Range Piece::of(std::uint64_t samples) const {
    const auto at = [&](int i) {
        return samples * static_cast<std::uint64_t>(i) / static_cast<std::uint64_t>(count);
    };
    return {at(index), at(index + 1)};
}

ValueStatistics measure_values(std::span<Noise> sum, std::uint64_t samples, std::uint32_t seed,
                               const Piece& piece) {
    ValueStatistics result;
    for_each_batch(sum, {}, piece.of(samples), seed, [&](std::span<const float> values) {
        result.moments.add(values);
        result.gaussianity.add(values);
    });
    return result;
}

statistics::InstanceStationarity measure_windows(std::span<Noise> sum, std::uint64_t windows,
                                                 std::uint32_t seed, const Piece& piece) {
    constexpr Grid grid{4, 2, true};
    constexpr std::size_t pixels = std::size_t{1} << 2 * grid.bits;
    statistics::InstanceStationarity result;
    for_each_batch(sum, grid, piece.of(windows), seed, [&](std::span<const float> values) {
        for (; !values.empty(); values = values.subspan(pixels))
            result.add(values.first(pixels));
    });
    return result;
}

PlaceStatistics measure_places(std::span<Noise> sum, double cell, std::uint64_t instances, std::uint32_t seed,
                               const Piece& piece) {
    constexpr std::uint64_t side = 8;
    PlaceStatistics result;
    const Piece::Range places = piece.of(side * side);
    for (std::uint64_t place = places.begin; place < places.end; ++place) {
        const auto coordinate = [&](std::uint64_t index) {
            return cell * (static_cast<double>(index) + 0.5) / static_cast<double>(side);
        };
        const Grid grid{.random = false, .shift = {coordinate(place % side), coordinate(place / side)}};
        statistics::Moments moments;
        statistics::Gaussianity law;
        for_each_batch(sum, grid, {0, instances}, seed, [&](std::span<const float> values) {
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
                                  std::uint32_t seed, const Piece& piece) {
    const Grid grid{6, side, false};
    const std::size_t pixels = std::size_t{1} << 2 * grid.bits;
    std::vector<double> means;
    for_each_batch(sum, grid, piece.of(instances), seed, [&](std::span<const float> values) {
        for (; !values.empty(); values = values.subspan(pixels)) {
            const auto window = values.first(pixels);
            means.push_back(std::reduce(window.begin(), window.end(), 0.0) / static_cast<double>(pixels));
        }
    });
    return means;
}

std::vector<double> picture_seconds(std::span<Noise> noises, int bits, std::uint64_t timings,
                                    const Piece& piece) {
    std::vector<float> pixels(std::size_t{1} << 2 * bits);
    std::vector<double> seconds;
    const Piece::Range rounds = piece.of(timings);
    for (std::uint64_t round = rounds.begin; round < rounds.end; ++round)
        for (Noise& noise : noises)
            seconds.push_back(noise.fill(pixels, picture_grid(bits), 0, 1, 1));
    return seconds;
}

std::vector<double> median_seconds(std::span<const double> rounds, std::size_t noises) {
    std::vector<double> medians;
    for (std::size_t noise = 0; noise < noises; ++noise) {
        std::vector<double> times;
        for (std::size_t i = noise; i < rounds.size(); i += noises)
            times.push_back(rounds[i]);
        medians.push_back(statistics::quantile(times, 0.5));
    }
    return medians;
}

std::vector<float> picture(Noise& noise, int bits, std::uint32_t seed, double scale) {
    std::vector<float> pixels(std::size_t{1} << 2 * bits);
    noise.fill(pixels, picture_grid(bits, scale), 0, seed, 1);
    return pixels;
}

} // namespace gabor::study
