#include "fit/structure.hpp"

#include <algorithm>
#include <utility>

namespace gabor::fit {

Structure::Structure(int width) {
    for (std::vector<float>& row : rows_)
        row.resize(static_cast<std::size_t>(width));
}

// Differences two pixels apart of means of two pixels: no noise of single pixels, and no direction preferred.
void Structure::add_row(std::span<const float> row) {
    std::swap(rows_[2], rows_[1]);
    std::swap(rows_[1], rows_[0]);
    std::ranges::copy(row, rows_[0].begin());
    if (++count_ < 3)
        return;
    const std::size_t count = row.size() - 2;
    derivatives_.resize(count);
    for (std::size_t x = 0; x < count; ++x)
        derivatives_[x] = rows_[0][x + 2] + rows_[1][x + 2] - rows_[0][x] - rows_[1][x];
    across_.add(derivatives_);
    for (std::size_t x = 0; x < count; ++x)
        derivatives_[x] = rows_[0][x] + rows_[0][x + 1] - rows_[2][x] - rows_[2][x + 1];
    down_.add(derivatives_);
}

double Structure::excess_kurtosis() const {
    return std::max(across_.excess_kurtosis(), down_.excess_kurtosis());
}

} // namespace gabor::fit
