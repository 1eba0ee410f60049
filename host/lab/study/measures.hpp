#pragma once

#include "statistics/gaussianity.hpp"
#include "statistics/moments.hpp"
#include "statistics/stationarity.hpp"
#include "study/noise.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gabor::study {

// Each measures the sum of several noises, with another seed each: `seed` decides everything. Pieces see what
// the whole sees, each a part of it.

/// One of equal pieces, counted from 0.
struct Piece {
    int index = 0;
    int count = 1;

    /// What is this piece's of so many samples: from `begin` to before `end`.
    struct Range {
        std::uint64_t begin;
        std::uint64_t end;
        std::uint64_t size() const { return end - begin; }
    };
    Range of(std::uint64_t samples) const;
};

/// What is seen of values.
struct ValueStatistics {
    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
};

/// One value at a random place of each of `samples` independent instances.
ValueStatistics measure_values(std::span<Noise> sum, std::uint64_t samples, std::uint32_t seed,
                               const Piece& piece = {});

/// Windows of one kernel diameter, each of another instance, 16 x 16 pixels each.
statistics::InstanceStationarity measure_windows(std::span<Noise> sum, std::uint64_t windows,
                                                 std::uint32_t seed, const Piece& piece = {});

/// 8 x 8 places of a cell, over many instances; pieces are of places. `cell`: its side in kernel radii.
struct PlaceStatistics {
    statistics::ProcessStationarity stationarity;
    std::vector<statistics::Estimate> cvm; ///< the index at each place

    /// The index averaged over the places; the interval is the average of theirs, which is wider than needed.
    statistics::Estimate mean_cvm() const;
};
PlaceStatistics measure_places(std::span<Noise> sum, double cell, std::uint64_t instances, std::uint32_t seed,
                               const Piece& piece = {});

/// The mean of a whole instance, 64 x 64 pixels on a square of `side` kernel radii from a cell's corner, for
/// each of many instances.
std::vector<double> measure_means(std::span<Noise> sum, double side, std::uint64_t instances,
                                  std::uint32_t seed, const Piece& piece = {});

/// Seconds on the device for a picture of 2^bits x 2^bits pixels, 32 to a kernel radius, in `timings` rounds
/// in which the noises take turns, so that what else the machine does touches all alike: noise by noise,
/// round by round.
std::vector<double> picture_seconds(std::span<Noise> noises, int bits, std::uint64_t timings,
                                    const Piece& piece = {});

/// Of each noise the median over the rounds.
std::vector<double> median_seconds(std::span<const double> rounds, std::size_t noises);

/// Such a picture, or one with as many pixels to a kernel radius as `scale` says: its pixels, row by row.
std::vector<float> picture(Noise& noise, int bits, std::uint32_t seed, double scale = 32);

} // namespace gabor::study
