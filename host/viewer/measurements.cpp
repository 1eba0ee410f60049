#include "viewer/measurements.hpp"

#include "statistics/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace gabor::viewer {

namespace {

std::vector<float> first_channel(std::span<const float> values, int channels, int coverage = -1) {
    std::vector<float> result;
    result.reserve(values.size() / static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(channels))
        if (coverage < 0 || values[i + static_cast<std::size_t>(coverage)] > 0)
            result.push_back(values[i]);
    return result;
}

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

Measurements statistics_of(const std::vector<float>& values) {
    Measurements part;
    for (const float value : values) {
        if (!std::isfinite(value))
            continue;
        part.moments.add(value);
        part.gaussianity.add(value);
        const double bar = (value / histogram_end + 1) * histogram_bars / 2;
        if (bar >= 0 && bar < histogram_bars)
            ++part.histogram[static_cast<std::size_t>(bar)];
    }
    return part;
}

} // namespace

void Measurer::reset() {
    std::optional<MeasuredSpectrum> spectrum = std::move(measured_.spectrum);
    measured_ = Measurements();
    measured_.spectrum = std::move(spectrum);
    pending_ = false;
}

void Measurer::add_samples(std::span<const float> values, int channels, int coverage) {
    pending_ = true;
    work_.start([this, kept = first_channel(values, channels, coverage)] { part_ = statistics_of(kept); });
}

void Measurer::add_picture(std::span<const float> values, int channels, Extent extent, double scale) {
    pending_ = true;
    work_.start([=, this, kept = first_channel(values, channels)] {
        part_ = Measurements();
        part_.spectrum = spectrum_of(kept, extent, scale);
    });
}

bool Measurer::idle() {
    if (work_.running())
        return false;
    if (std::exchange(pending_, false)) {
        measured_.moments.merge(part_.moments);
        measured_.gaussianity.merge(part_.gaussianity);
        measured_.cvm = measured_.gaussianity.index();
        std::ranges::transform(measured_.histogram, part_.histogram, measured_.histogram.begin(),
                               std::plus());
        if (part_.spectrum)
            measured_.spectrum = std::move(part_.spectrum);
    }
    return true;
}

} // namespace gabor::viewer
