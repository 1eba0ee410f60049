#pragma once

#include <span>
#include <string_view>

namespace gabor::viewer {

struct EmbeddedShader {
    std::string_view path; ///< relative to shaders/
    std::string_view text;
};

/// The shaders that Copy GLSL can add to a noise.
std::span<const EmbeddedShader> embedded_shaders();

} // namespace gabor::viewer
