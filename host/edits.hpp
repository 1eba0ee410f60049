#pragma once

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

namespace gabor {

/// The edit distance between two words: how many letters to change, add or remove.
inline std::size_t edits(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t kept = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({kept, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

/// The names, those most similar to `word` first.
inline std::vector<std::string_view> nearest_first(std::string_view word,
                                                   std::vector<std::string_view> names) {
    std::ranges::stable_sort(names, {}, [&](std::string_view name) { return edits(word, name); });
    return names;
}

} // namespace gabor
