#include "statistics/picture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gabor::statistics {

PictureStatistics::PictureStatistics(int width, int height, double mean)
    : mean_(mean), centred_(static_cast<std::size_t>(width)) {
    if (const std::optional<int> side = segment_side(width, height))
        spectrum_.emplace(width, height, *side);
}

void PictureStatistics::add_rows(std::span<const float> pixels) {
    for (; !pixels.empty(); pixels = pixels.subspan(centred_.size())) {
        const auto row = pixels.first(centred_.size());
        not_finite_ += add_finite(moments_, row);
        std::ranges::transform(row, centred_.begin(), [&](float value) {
            return std::isfinite(value) ? static_cast<float>(value - mean_) : 0.0f;
        });
        if (spectrum_)
            spectrum_->add_row(centred_);
    }
}

PictureReport PictureStatistics::report() const {
    PictureReport report{not_finite_, moments_, {}};
    if (spectrum_)
        report.spectrum = summarize(spectrum_->periodogram(), spectrum_->side());
    return report;
}

std::uint64_t add_finite(Moments& moments, std::span<const float> pixels) {
    std::vector<float> finite;
    std::ranges::copy_if(pixels, std::back_inserter(finite),
                         [](float value) { return std::isfinite(value); });
    moments.add(finite);
    return pixels.size() - finite.size();
}

} // namespace gabor::statistics
