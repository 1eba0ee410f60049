#pragma once

#include <fmt/format.h>

#include <string>

namespace gabor::noise {

/// The shortest GLSL literal for a float.
inline std::string literal(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

/// A literal for a vec2.
inline std::string vec2(double x, double y) {
    return fmt::format("vec2({}, {})", literal(x), literal(y));
}

/// A literal for a vec3.
inline std::string vec3(double x, double y, double z) {
    return fmt::format("vec3({}, {}, {})", literal(x), literal(y), literal(z));
}

} // namespace gabor::noise
