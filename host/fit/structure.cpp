#include "fit/structure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gabor::fit {

Structure::Structure(int width) : row_(static_cast<std::size_t>(width)) {
    for (std::vector<float>& row : rows_)
        row.resize(row_.size() - 1);
    derivatives_.resize(row_.size() - 3);
}

// Derivatives are taken from means of 2 x 2 pixels, which suppress the noise of single pixels and prefer no
// direction.
void Structure::add_row(std::span<const float> row) {
    std::swap(rows_[2], rows_[1]);
    std::swap(rows_[1], rows_[0]);
    for (std::size_t x = 0; x + 1 < row_.size(); ++x)
        rows_[0][x] = (row_[x] + row_[x + 1] + row[x] + row[x + 1]) / 4;
    std::ranges::copy(row, row_.begin());
    if (++count_ < 4)
        return;
    const auto& below = rows_[0];
    const auto& here = rows_[1];
    const auto& above = rows_[2];
    const auto add = [&](statistics::Moments& moments, auto derivative) {
        for (std::size_t x = 0; x < derivatives_.size(); ++x)
            derivatives_[x] = derivative(x + 1);
        const auto end =
            std::remove_if(derivatives_.begin(), derivatives_.end(), [](float d) { return std::isnan(d); });
        moments.add(std::span(derivatives_.begin(), end));
    };
    add(across_, [&](std::size_t x) { return here[x + 1] - here[x - 1]; });
    add(down_, [&](std::size_t x) { return below[x] - above[x]; });
    add(laplacian_,
        [&](std::size_t x) { return here[x - 1] + here[x + 1] + below[x] + above[x] - 4 * here[x]; });
}

double Structure::excess() const {
    // A derivative that is 0 everywhere has no kurtosis, which fmax passes over; a negative excess only means
    // that there are few waves.
    const double kurtosis = std::fmax(across_.excess_kurtosis(), down_.excess_kurtosis());
    return std::fmax(0, std::fmax(kurtosis, 2 * std::abs(laplacian_.skewness())));
}

} // namespace gabor::fit
