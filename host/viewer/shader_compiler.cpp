#include "viewer/shader_compiler.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

namespace gabor::viewer {

/// Finds what a shader includes, beside it or from the top of the folder.
class Includer : public glslang::TShader::Includer {
  public:
    explicit Includer(ShaderCompiler& shaders) : compiler_(shaders) {}

    IncludeResult* includeLocal(const char* name, const char* from, std::size_t) override {
        const std::filesystem::path beside = std::filesystem::path(from).parent_path() / name;
        for (const std::string& path : {beside.lexically_normal().string(), std::string(name)}) {
            auto text = std::make_unique<std::string>();
            if (compiler_.read(path, *text)) {
                const std::string& kept = *text;
                return new IncludeResult(path, kept.data(), kept.size(), text.release());
            }
        }
        return nullptr;
    }

    void releaseInclude(IncludeResult* result) override {
        if (result)
            delete static_cast<std::string*>(result->userData);
        delete result;
    }

  private:
    ShaderCompiler& compiler_;
};

namespace {

EShLanguage language_of(std::string_view path) {
    return path.ends_with(".vert")   ? EShLangVertex
           : path.ends_with(".frag") ? EShLangFragment
                                     : EShLangCompute;
}

// glslang says "ERROR: file:line: 'token' : message"; the first such line is the cause of the rest.
std::string first_error(const std::string& log) {
    constexpr std::string_view prefix = "ERROR: ";
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(prefix))
            return line.substr(prefix.size());
    return log.substr(0, log.find('\n'));
}

// As shaders/CMakeLists.txt compiles its passes.
std::string macros_of(std::string_view variant) {
    if (std::isdigit(static_cast<unsigned char>(variant.front())) != 0)
        return fmt::format("#define GABOR_TAPS {}\n", variant);
    return fmt::format("#define GABOR_OF_{0}\n#define GABOR_MATERIAL gabor_{0}\n"
                       "#define GABOR_MATERIAL_FILTERED gabor_{0}_filtered\n",
                       variant);
}

} // namespace

ShaderCompiler::ShaderCompiler(std::filesystem::path folder) : folder_(std::move(folder)) {
    if (!folder_.empty() && !std::filesystem::exists(folder_ / "gabor_noise.glsl"))
        throw RequestError(fmt::format("--shaders '{}': it takes a folder with gabor_noise.glsl, such as the "
                                       "folder shaders of the sources",
                                       folder_.string()));
    glslang::InitializeProcess();
}

ShaderCompiler::~ShaderCompiler() {
    glslang::FinalizeProcess();
}

bool ShaderCompiler::read(const std::string& path, std::string& text) {
    const auto built_in = std::ranges::find(embedded_shaders(), path, &EmbeddedShader::path);
    const bool known = built_in != embedded_shaders().end();
    if (folder_.empty()) {
        if (known)
            text = built_in->text;
        return known;
    }
    std::ifstream file(folder_ / path, std::ios::binary);
    if (!file)
        return false;
    text.assign(std::istreambuf_iterator<char>(file), {});
    read_[path] = {file_stamp(folder_ / path), known && built_in->text == text};
    return true;
}

bool ShaderCompiler::changed() {
    bool any = false;
    for (auto& [path, known] : read_) {
        const FileStamp now = file_stamp(folder_ / path);
        any |= now != known.stamp;
        known.stamp = now;
    }
    return any;
}

bool ShaderCompiler::as_built() const {
    return std::ranges::all_of(read_, [](const auto& file) { return file.second.as_built; });
}

Compiled ShaderCompiler::compile(std::string_view path) {
    const std::size_t at = path.find('@');
    const std::string name(path.substr(0, at));
    const std::string preamble = at == path.npos ? "" : macros_of(path.substr(at + 1));
    const EShLanguage language = language_of(name);
    std::string text;
    if (!read(name, text))
        return {{}, fmt::format("{}: there is no such shader", name)};
    const char* source = text.c_str();
    const int length = static_cast<int>(text.size());
    const char* label = name.c_str();
    glslang::TShader shader(language);
    shader.setStringsWithLengthsAndNames(&source, &length, &label, 1);
    shader.setPreamble(preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 110);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    Includer includer(*this);
    constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), 450, false, messages, includer))
        return {{}, first_error(shader.getInfoLog())};
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages))
        return {{}, fmt::format("{}: {}", name, first_error(program.getInfoLog()))};
    Compiled result;
    glslang::GlslangToSpv(*program.getIntermediate(language), result.spirv);
    return result;
}

} // namespace gabor::viewer
