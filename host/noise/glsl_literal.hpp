#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

namespace gabor::noise {

/// The shortest GLSL literal for a float.
inline std::string literal(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

/// A literal for a vector of `size` floats.
template <typename Number, std::size_t size>
std::string literal(const std::array<Number, size>& vector) {
    std::string components;
    for (const Number component : vector)
        components += (components.empty() ? "" : ", ") + literal(double{component});
    return fmt::format("vec{}({})", size, components);
}

/// Formats GLSL. Writes values that are not integers or text as literals; a struct of x and y is a vector.
template <typename... Values>
std::string glsl(std::string_view text, const Values&... values) {
    const auto written = []<typename T>(const T& value) {
        if constexpr (std::is_integral_v<T> || std::is_convertible_v<T, std::string_view>)
            return value;
        else if constexpr (requires { value.x; })
            return literal(std::array{value.x, value.y});
        else
            return literal(value);
    };
    return fmt::format(fmt::runtime(text), written(values)...);
}

} // namespace gabor::noise
