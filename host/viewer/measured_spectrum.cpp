#include "viewer/measured_spectrum.hpp"

#include "statistics/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gabor::viewer {

namespace {

// Mirrors the half plane of the periodogram into a whole plane with frequency 0 in the middle.
std::optional<MeasuredSpectrum> spectrum_of(std::span<const float> values, Extent extent, double scale) {
    if (!statistics::segment_side(extent.width, extent.height))
        return {};
    statistics::Spectrum spectrum(extent.width, extent.height);
    double mean = 0;
    for (const float value : values)
        mean += value;
    mean /= static_cast<double>(values.size());
    const auto width = static_cast<std::size_t>(extent.width);
    std::vector<float> row(width);
    for (std::size_t start = 0; start < values.size(); start += width) {
        std::ranges::transform(values.subspan(start, width), row.begin(),
                               [&](float value) { return static_cast<float>(value - mean); });
        spectrum.add_row(row);
    }
    const std::vector<double> half = spectrum.periodogram();
    const int side = spectrum.side();
    const auto power = [&](int fx, int fy) {
        if (fx < 0) {
            fx = -fx;
            fy = -fy;
        }
        const int rows = (fy + side) % side;
        return half[static_cast<std::size_t>(rows) * static_cast<std::size_t>(side / 2 + 1) +
                    static_cast<std::size_t>(fx)];
    };
    const double strongest = std::max(*std::ranges::max_element(half), 1e-30);
    MeasuredSpectrum result{side, scale / side, {}};
    result.decibels.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            result.decibels.push_back(static_cast<float>(
                10 * std::log10(std::max(power(x - side / 2, y - side / 2) / strongest, 1e-12))));
    return result;
}

} // namespace

void SpectrumMeter::start(std::span<const float> values, std::size_t channels, Extent extent, double scale) {
    std::vector<float> first;
    first.reserve(values.size() / channels);
    for (std::size_t i = 0; i < values.size(); i += channels)
        first.push_back(values[i]);
    work_.start([=, this, kept = std::move(first)] { next_ = spectrum_of(kept, extent, scale); });
}

bool SpectrumMeter::idle() {
    if (work_.running())
        return false;
    if (next_)
        measured_ = std::exchange(next_, {});
    return true;
}

} // namespace gabor::viewer
