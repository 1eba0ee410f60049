#pragma once

#include <fmt/format.h>

#include <array>
#include <string>

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

} // namespace gabor::noise
