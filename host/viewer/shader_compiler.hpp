#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace gabor::viewer {

struct EmbeddedShader {
    std::string_view path; ///< relative to shaders/
    std::string_view text;
};

/// The shaders built into the program.
std::span<const EmbeddedShader> embedded_shaders();

/// Compiles a shader to SPIR-V. `path`: relative to shaders/; its extension is the stage. Throws
/// std::runtime_error with the first error, "file:line: message".
std::vector<std::uint32_t> compile_shader(std::string_view path);

} // namespace gabor::viewer
