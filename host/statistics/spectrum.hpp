#pragma once

#include "statistics/segments.hpp"
#include "statistics/transform.hpp"

#include <optional>
#include <span>
#include <vector>

namespace gabor::statistics {

/// The power spectrum of a picture, averaged over square segments under a Hann window (Welch, 1967). Segments
/// overlap by at least half, except in pictures so large that 64 x 64 segments are enough. The picture is
/// read row by row; only as many rows as a segment has are kept in memory, at most 128 MiB.
class Spectrum {
  public:
    /// `side` is the side of the segments, from `segment_side`.
    Spectrum(int width, int height, int side);

    /// Adds the next row of `width` values. Subtract the mean first, or it counts as power at frequency 0.
    void add_row(std::span<const float> row);

    /// Returns the averaged periodogram in the order that `summarize` takes. Call it after the last row.
    std::vector<double> periodogram() const;

    int side() const { return segments_.side(); }

  private:
    Segments segments_;
    FourierTransform transform_;
    std::vector<float> segment_;
    std::vector<double> power_;
};

/// Returns the side of the segments for a picture: a power of 2, at most 512 and at most half the shorter
/// side. Returns nothing for pictures below 16 x 16 pixels.
std::optional<int> segment_side(int width, int height);

/// The strongest frequency of a spectrum.
struct SpectralPeak {
    double frequency = 0;   ///< cycles per pixel
    double orientation = 0; ///< direction of the wave vector: degrees clockwise from right, in [0, 180)

    bool operator==(const SpectralPeak&) const = default;
};

/// Summary of a power spectrum. Frequencies are in cycles per pixel.
struct SpectrumSummary {
    double power = 0;                 ///< sum over all frequencies: the variance (Parseval)
    std::optional<SpectralPeak> peak; ///< absent if indistinguishable from frequency 0
    double bandwidth = 0;             ///< full width at half maximum of `radial`, broadened by `resolution`
    double resolution = 0;            ///< full width at half maximum of a plane wave
    double radial_step = 0;           ///< radial[k] is the power around frequency k * radial_step
    std::vector<double> radial;       ///< power per annulus; its sum is `power`

    bool operator==(const SpectrumSummary&) const = default;
};

/// Summarizes a picture's periodogram from segments of side * side pixels, where side is a power of 2. The
/// periodogram has `side` rows for fy (negative ones last) and side / 2 + 1 columns for fx >= 0. Each value
/// is the variance in a cell with sides of 1 / side cycles per pixel.
SpectrumSummary summarize(std::span<const double> periodogram, int side);

} // namespace gabor::statistics
