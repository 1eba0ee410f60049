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

/// A literal for a struct of x and y.
template <typename Vector>
requires requires(const Vector& vector) {
    vector.y;
}
std::string literal(const Vector& vector) {
    return fmt::format("vec2({}, {})", literal(vector.x), literal(vector.y));
}

/// A literal for a vector of `size` floats, or for an array of `size` vectors.
template <typename Part, std::size_t size>
std::string literal(const std::array<Part, size>& parts) {
    std::string text;
    for (const Part& part : parts)
        text += (text.empty() ? "" : ", ") + literal(part);
    if constexpr (std::is_arithmetic_v<Part>)
        return fmt::format("vec{}({})", size, text);
    else
        return fmt::format("{}[{}]({})", text.substr(0, text.find('(')), size, text);
}

/// Formats GLSL. Writes integers and text as they are, and other values as literals.
template <typename... Values>
std::string glsl(std::string_view text, const Values&... values) {
    const auto written = []<typename T>(const T& value) {
        if constexpr (std::is_integral_v<T> || std::is_convertible_v<T, std::string_view>)
            return value;
        else
            return literal(value);
    };
    return fmt::format(fmt::runtime(text), written(values)...);
}

} // namespace gabor::noise
