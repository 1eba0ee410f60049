#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::viewer {

enum class Stage { vertex, fragment, compute };

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
class Shaders {
  public:
    /// `folder`: empty for those built in. Throws RequestError where a folder has no gabor_noise.glsl.
    explicit Shaders(std::filesystem::path folder);
    ~Shaders();
    Shaders(const Shaders&) = delete;
    Shaders& operator=(const Shaders&) = delete;

    /// `path`: relative to shaders/, as are the files that it includes, unless they stand beside it.
    Compiled compile(std::string_view path, Stage stage);

    /// Whether any file that was read has another time or size than it had then. Asking takes note: the next
    /// answer is about changes from here on.
    bool changed();

    const std::filesystem::path& folder() const { return folder_; }

  private:
    friend class Includer;
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };

    bool read(const std::string& path, std::string& text);
    Stamp stamp(const std::string& path) const;

    std::filesystem::path folder_;
    std::map<std::string, Stamp> read_;
};

} // namespace gabor::viewer
