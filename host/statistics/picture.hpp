#pragma once

#include "statistics/blocks.hpp"
#include "statistics/moments.hpp"
#include "statistics/spectrum.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gabor::statistics {

struct PictureReport {
    std::uint64_t not_finite = 0;            ///< pixels that are NaN or infinite, left out of everything else
    Moments moments;                         ///< of all other pixels
    std::optional<SpectrumSummary> spectrum; ///< absent below 16 x 16 pixels
    std::optional<BlockEstimates> blocks;    ///< absent when the picture is too small for its correlation

    bool operator==(const PictureReport&) const = default;
};

/// Statistics of a picture that passes by once, row after row. Memory grows with the width, not with the
/// height. The expected distribution must be known beforehand: `add_finite` measures what it is
/// fitted to, in a pass before.
class PictureStatistics {
  public:
    PictureStatistics(int width, int height, const NormalDistribution& expected);

    /// The next rows, whole ones.
    void add_rows(std::span<const float> pixels);

    /// Call after the last row.
    PictureReport report() const;

  private:
    void add_row(std::span<const float> row);

    int width_;
    NormalDistribution expected_;
    int row_ = 0;
    std::uint64_t not_finite_ = 0;
    Blocks blocks_;
    std::optional<Spectrum> spectrum_;
    std::vector<float> centred_; ///< one row, less the mean, with 0 for what is not finite
};

/// Adds those of `pixels` that are finite; returns how many are not.
std::uint64_t add_finite(Moments& moments, std::span<const float> pixels);

} // namespace gabor::statistics
