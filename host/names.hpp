#pragma once

#include "system/number.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gabor {

/// Returns the text in lower case.
inline std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Returns the name that equals `word` but for the case of letters, or `word` itself if there is none.
inline std::string_view in_any_case(std::string_view word, std::span<const std::string_view> names) {
    const auto found =
        std::ranges::find_if(names, [&](std::string_view name) { return lower(name) == lower(word); });
    return found == names.end() ? word : *found;
}

/// The edit distance between two words: how many letters to change, add or remove, or pairs to swap.
inline std::size_t edits(std::string_view from, std::string_view to) {
    std::vector<std::size_t> swapped, before,
        row(to.size() + 1); // for two letters less of `from`, one less, all
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= from.size(); ++i) {
        swapped = std::exchange(before, row);
        row[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t kept = before[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
            row[j] = std::min({kept, row[j - 1] + 1, before[j] + 1});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                row[j] = std::min(row[j], swapped[j - 2] + 1);
        }
    }
    return row.back();
}

/// How unlike a name is to a word: 0 if the name begins with it; 1 if a part of the name after a dot or a
/// hyphen does; more if a few letters differ. Returns nothing if the two have too little in common.
inline std::optional<std::size_t> unlikeness(std::string_view word, std::string_view name) {
    const std::string typed = lower(word), known = lower(name);
    if (typed.empty())
        return {};
    if (known.starts_with(typed))
        return 0;
    if (known.find('.' + typed) != known.npos || known.find('-' + typed) != known.npos)
        return 1;
    const std::size_t differ = edits(typed, known);
    return differ <= 2 && 3 * differ <= typed.size() ? std::optional(1 + differ) : std::nullopt;
}

/// Returns the number that the text is, if it is one.
inline std::optional<double> number_of(std::string_view text) {
    double number = 0;
    const auto [stop, error] = system::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Returns the names to suggest in place of an unknown word, at most three, in their order: those that are
/// most alike or, for a number, the next numbers below and above.
inline std::vector<std::string_view> similar(std::string_view word, std::span<const std::string_view> names) {
    constexpr std::size_t most = 3;
    std::vector<std::string_view> result;
    if (const std::optional<double> number = number_of(word)) {
        std::optional<double> below, above;
        for (const std::string_view name : names)
            if (const std::optional<double> each = number_of(name); each && *each < *number)
                below = std::max(*each, below.value_or(*each));
            else if (each)
                above = std::min(*each, above.value_or(*each));
        std::ranges::copy_if(names, std::back_inserter(result), [&](std::string_view name) {
            const std::optional<double> each = number_of(name);
            return each && (each == below || each == above);
        });
        return result;
    }
    std::optional<std::size_t> least;
    for (const std::string_view name : names)
        if (const auto each = unlikeness(word, name); each && (!least || *each < *least))
            least = each;
    for (const std::string_view name : names)
        if (least && unlikeness(word, name) == least && result.size() < most)
            result.push_back(name);
    return result;
}

/// Asks "did you mean A, B or C? ", with `prefix` before each name; empty if no name is similar to the word.
inline std::string did_you_mean(std::string_view word, std::span<const std::string_view> names,
                                std::string_view prefix = "") {
    const std::vector<std::string_view> suggested = similar(word, names);
    std::string text;
    for (std::size_t i = 0; i < suggested.size(); ++i) {
        text += i == 0 ? "did you mean " : i + 1 == suggested.size() ? " or " : ", ";
        text += prefix;
        text += suggested[i];
    }
    return text.empty() ? text : text + "? ";
}

/// The end of a message about an unknown word: "did you mean A? Expected A, B, C", with all names.
inline std::string expected(std::string_view word, std::span<const std::string_view> names) {
    std::string text = did_you_mean(word, names);
    std::string_view before = text.empty() ? "expected " : "Expected ";
    for (const std::string_view name : names) {
        text += before;
        text += name;
        before = ", ";
    }
    return text;
}

} // namespace gabor
