#pragma once

#include "viewer/file_stamp.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::viewer {

/// What became of a shader: its SPIR-V, or the compiler's first complaint as "file:line: message".
struct Compiled {
    std::vector<std::uint32_t> spirv;
    std::string error;
};

struct EmbeddedShader {
    std::string_view path; ///< relative to shaders/
    std::string_view text;
};

/// The shaders as they were when the program was built.
std::span<const EmbeddedShader> embedded_shaders();

/// Compiles shaders from a folder, or those that were built in, and notes which files they are made of.
class ShaderCompiler {
  public:
    /// `folder`: empty for those built in. Throws RequestError where a folder has no gabor_noise.glsl.
    explicit ShaderCompiler(std::filesystem::path folder);
    ~ShaderCompiler();
    ShaderCompiler(const ShaderCompiler&) = delete;
    ShaderCompiler& operator=(const ShaderCompiler&) = delete;

    /// `path`: relative to shaders/, as are the files that it includes, unless they stand beside it; PATH@N
    /// is PATH with GABOR_TAPS N, and PATH@NAME with GABOR_OF_NAME, GABOR_MATERIAL gabor_NAME and its
    /// filtered form. The stage is told by PATH's extension.
    Compiled compile(std::string_view path);

    /// Whether any file that was read has another time or size than it had then. Asking takes note: the next
    /// answer is about changes from here on.
    bool changed();
    /// Whether all that was read is as it was when the program was built.
    bool as_built() const;

  private:
    friend class Includer;
    bool read(const std::string& path, std::string& text);

    std::filesystem::path folder_;
    struct File {
        FileStamp stamp;
        bool as_built;
    };
    std::map<std::string, File> read_;
};

} // namespace gabor::viewer
