#pragma once

// Helpers for testing the randomness of hash words.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace gabor::test {

/// The number of draws per statistic: GABOR_DRAWS, or 2 * 10^6 if it is not set.
inline std::uint64_t draws() {
    const char* text = std::getenv("GABOR_DRAWS");
    return text ? std::strtoull(text, nullptr, 10) : 2'000'000;
}

/// The largest deviation allowed, in standard deviations. A few thousand values do not exceed it by chance.
constexpr double far = 5.5;

/// Pearson's chi-square against equal counts, converted to a standard normal value.
inline double chi_square(const std::vector<std::uint64_t>& counts) {
    double total = 0, squares = 0;
    for (const std::uint64_t count : counts) {
        total += static_cast<double>(count);
        squares += static_cast<double>(count) * static_cast<double>(count);
    }
    const double bins = static_cast<double>(counts.size()), freedom = bins - 1;
    // Wilson and Hilferty's cube root, accurate for few degrees of freedom too.
    const double root = std::cbrt((squares * bins / total - total) / freedom);
    return (root - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
}

} // namespace gabor::test
