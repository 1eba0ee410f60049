#pragma once

#include "statistics/moments.hpp"
#include "statistics/spectrum.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gabor::statistics {

struct PictureReport {
    std::uint64_t not_finite = 0;            ///< NaN and infinite pixels, excluded from everything else
    Moments moments;                         ///< moments of all other pixels
    std::optional<SpectrumSummary> spectrum; ///< absent below 16 x 16 pixels

    bool operator==(const PictureReport&) const = default;
};

/// Statistics of a picture that is read row by row. Memory grows with the width, not the height.
class PictureStatistics {
  public:
    /// `mean` is subtracted before the spectrum is computed; `add_finite` can find it in an earlier pass.
    PictureStatistics(int width, int height, double mean);

    /// Adds the next complete rows.
    void add_rows(std::span<const float> pixels);

    /// Returns the statistics; call it after the last row.
    PictureReport report() const;

  private:
    double mean_;
    std::uint64_t not_finite_ = 0;
    Moments moments_;
    std::optional<Spectrum> spectrum_;
    std::vector<float> centred_; ///< one row minus the mean, with 0 for values that are not finite
};

/// Adds the finite `pixels` and returns how many are not finite.
std::uint64_t add_finite(Moments& moments, std::span<const float> pixels);

} // namespace gabor::statistics
