#pragma once

// Rows that are measured in pieces: what a piece has seen of its noises is kept as plain numbers, and merged
// with what the others have.

#include "study/measures.hpp"
#include "study/table.hpp"

#include <functional>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace gabor::study {

/// Of a row, whatever is measured. Few enough that what they keep is small, 4096 counts for Gaussianity each.
inline constexpr int pieces_per_row = 8;

/// Appends what a piece has measured. Counts are exact up to 2^53.
void write(Numbers& numbers, const ValueStatistics& values);
void write(Numbers& numbers, const statistics::InstanceStationarity& windows);
void write(Numbers& numbers, const PlaceStatistics& places);
void write(Numbers& numbers, const std::vector<double>& list);

/// Takes that from the front of the numbers of the next piece. Throws std::runtime_error where they are too
/// few.
void merge(ValueStatistics& values, std::span<const double>& numbers);
void merge(statistics::InstanceStationarity& windows, std::span<const double>& numbers);
void merge(PlaceStatistics& places, std::span<const double>& numbers);
void merge(std::vector<double>& list, std::span<const double>& numbers);

/// Noises that a row measures. Rows may share them: to make one takes longer than some rows.
using Noises = std::shared_ptr<std::vector<Noise>>;

/// One noise.
inline Noises alone(Noise noise) {
    auto noises = std::make_shared<std::vector<Noise>>();
    noises->push_back(std::move(noise));
    return noises;
}

/// Such a row: `noises` makes or has those that it measures, `measure` sees a piece of them, and `finish`
/// makes the row's numbers of all that the pieces have seen.
template <typename... Statistics>
Measurement
in_pieces(std::type_identity_t<std::function<Noises()>> noises,
          std::type_identity_t<
              std::function<std::tuple<Statistics...>(std::vector<Noise>&, std::uint32_t seed, const Piece&)>>
              measure,
          std::type_identity_t<std::function<Numbers(const Statistics&...)>> finish) {
    return {pieces_per_row,
            [noises, measure](std::uint32_t seed, std::span<const int> pieces) {
                const Noises all = noises();
                std::vector<Numbers> results;
                for (const int piece : pieces)
                    std::apply([&numbers = results.emplace_back()](
                                   const Statistics&... seen) { (write(numbers, seen), ...); },
                               measure(*all, seed, {piece, pieces_per_row}));
                return results;
            },
            [finish](std::span<const Numbers> pieces) {
                std::tuple<Statistics...> all;
                for (std::span<const double> numbers : pieces)
                    std::apply([&](Statistics&... seen) { (merge(seen, numbers), ...); }, all);
                return std::apply(finish, all);
            }};
}

} // namespace gabor::study
