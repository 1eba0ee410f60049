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

/// The shaders as they were when the program was built.
std::span<const EmbeddedShader> embedded_shaders();

/// SPIR-V of a shader. `path`: relative to shaders/; its extension tells the stage. Throws std::runtime_error
/// with the compiler's first complaint as "file:line: message".
std::vector<std::uint32_t> compile_shader(std::string_view path);

} // namespace gabor::viewer
