#pragma once

#include <span>
#include <vector>

namespace gabor::statistics {

/// What a power spectrum comes down to. Frequencies are in cycles per pixel.
struct SpectrumSummary {
    double power = 0;          ///< of all frequencies together: the variance, by Parseval's theorem
    double peak_frequency = 0; ///< where the lobe is strongest
    double peak_orientation =
        0;                  ///< of the wave vector there: degrees in [0, 180) from +x towards +y, downwards
    double bandwidth = 0;   ///< full width at half maximum of `radial`, broadened by `resolution`
    double resolution = 0;  ///< full width at half maximum that a plane wave shows
    double correlation = 0; ///< pixels further apart than this are taken to be independent
    double radial_step = 0; ///< radial[k] is around the frequency k * radial_step
    std::vector<double> radial; ///< power per annulus; they add up to `power`

    bool operator==(const SpectrumSummary&) const = default;
};

/// Of a picture's periodogram from segments of side * side pixels, side being a power of 2: `side` rows for
/// fy (negative ones last) of side / 2 + 1 columns for fx >= 0, each the part of the variance that is in its
/// cell of 1 / side^2 square cycles per pixel.
SpectrumSummary summarize(std::span<const double> periodogram, int side);

} // namespace gabor::statistics
