#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gabor::statistics {

/// The power spectrum of a picture that passes by row after row, as an average over overlapping square
/// segments under a Hann window (Welch, 1967), at least half overlapping unless the picture is so large that
/// 64 x 64 segments are enough. Holds as many rows as a segment has, at most 128 MiB.
class Spectrum {
  public:
    /// Throws std::invalid_argument for pictures without a `segment_side`.
    Spectrum(int width, int height);
    ~Spectrum();
    Spectrum(Spectrum&&) noexcept;

    /// The next row, `width` values. The mean should have been subtracted: it would be power at frequency 0.
    void add_row(std::span<const float> row);

    /// The averaged periodogram, in the order that `summarize` takes. Call after the last row.
    std::vector<double> periodogram() const;

    /// The side of the segments, in pixels.
    int side() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The side of the segments for a picture: a power of 2, at most 512 and half the shorter side. Nothing for
/// pictures of less than 16 x 16 pixels.
std::optional<int> segment_side(int width, int height);

/// Where a spectrum is strongest.
struct SpectralPeak {
    double frequency = 0;   ///< cycles per pixel
    double orientation = 0; ///< of the wave vector: degrees in [0, 180), from right towards down

    bool operator==(const SpectralPeak&) const = default;
};

/// The figures of a power spectrum. Frequencies are in cycles per pixel.
struct SpectrumSummary {
    double power = 0;                 ///< of all frequencies together: the variance, by Parseval's theorem
    std::optional<SpectralPeak> peak; ///< absent where it cannot be told from frequency 0
    double bandwidth = 0;             ///< full width at half maximum of `radial`, broadened by `resolution`
    double resolution = 0;            ///< full width at half maximum that a plane wave shows
    double correlation = 0;           ///< pixels further apart than this are taken to be independent
    double radial_step = 0;           ///< radial[k] is around the frequency k * radial_step
    std::vector<double> radial;       ///< power per annulus; they add up to `power`

    bool operator==(const SpectrumSummary&) const = default;
};

/// Of a picture's periodogram from segments of side * side pixels, side being a power of 2: `side` rows for
/// fy (negative ones last) of side / 2 + 1 columns for fx >= 0, each the part of the variance that is in its
/// cell of 1 / side^2 square cycles per pixel.
SpectrumSummary summarize(std::span<const double> periodogram, int side);

} // namespace gabor::statistics
