#include "statistics/picture.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::statistics {

namespace {

bool is_finite(float value) {
    return std::isfinite(value);
}

/// Calls visit(first, run) for each run of finite pixels; returns how many pixels are not finite.
template <typename Visit>
std::uint64_t for_finite_runs(std::span<const float> pixels, Visit visit) {
    std::uint64_t finite = 0;
    auto end = pixels.begin();
    while (end != pixels.end()) {
        const auto begin = std::find_if(end, pixels.end(), is_finite);
        end = std::find_if_not(begin, pixels.end(), is_finite);
        if (begin == end)
            break;
        visit(begin - pixels.begin(), std::span(begin, end));
        finite += static_cast<std::uint64_t>(end - begin);
    }
    return pixels.size() - finite;
}

} // namespace

PictureStatistics::PictureStatistics(int width, int height, double mean)
    : mean_(mean), centred_(static_cast<std::size_t>(width)) {
    if (const std::optional<int> side = segment_side(width, height))
        spectrum_.emplace(width, height, *side);
}

void PictureStatistics::add_rows(std::span<const float> pixels) {
    for (; !pixels.empty(); pixels = pixels.subspan(centred_.size())) {
        std::ranges::fill(centred_, 0.0f);
        const auto row = pixels.first(centred_.size());
        not_finite_ += for_finite_runs(row, [&](std::ptrdiff_t first, std::span<const float> run) {
            moments_.add(run);
            std::ranges::transform(run, centred_.begin() + first,
                                   [&](float value) { return static_cast<float>(value - mean_); });
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
    return for_finite_runs(pixels, [&](std::ptrdiff_t, std::span<const float> run) { moments.add(run); });
}

} // namespace gabor::statistics
