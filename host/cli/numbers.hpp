#pragma once

#include "error.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace gabor::cli {

/// A whole number or a decimal number that fills the text. Throws RequestError naming the option and what it
/// takes.
template <typename T>
T parse_number(std::string_view option, std::string_view text, std::string_view accepted) {
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end)
        throw RequestError(fmt::format("{} '{}': it takes {}", option, text, accepted));
    return value;
}

/// `count` whole numbers between separators, as in 1024x768 or 0,0,64,64.
template <std::size_t count>
std::array<int, count> parse_integers(std::string_view option, std::string_view text, char separator,
                                      std::string_view accepted) {
    std::array<int, count> values;
    std::string_view rest = text;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t length = i + 1 < count ? rest.find(separator) : rest.size();
        if (length == std::string_view::npos)
            throw RequestError(fmt::format("{} '{}': it takes {}", option, text, accepted));
        try {
            values[i] = parse_number<int>(option, rest.substr(0, length), accepted);
        } catch (const RequestError&) {
            throw RequestError(fmt::format("{} '{}': it takes {}", option, text, accepted));
        }
        rest.remove_prefix(i + 1 < count ? length + 1 : length);
    }
    return values;
}

} // namespace gabor::cli
