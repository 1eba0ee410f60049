#include "viewer/shader_compiler.hpp"

#include <fmt/format.h>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace gabor::viewer {

namespace {

const EmbeddedShader* find(std::string_view path) {
    const auto found = std::ranges::find(embedded_shaders(), path, &EmbeddedShader::path);
    return found == embedded_shaders().end() ? nullptr : &*found;
}

// Finds included files beside the shader, or from the top of the folder.
class Includer : public glslang::TShader::Includer {
  public:
    IncludeResult* includeLocal(const char* name, const char* from, std::size_t) override {
        const std::filesystem::path beside = std::filesystem::path(from).parent_path() / name;
        for (const std::string& path : {beside.lexically_normal().string(), std::string(name)})
            if (const EmbeddedShader* shader = find(path))
                return new IncludeResult(path, shader->text.data(), shader->text.size(), nullptr);
        return nullptr;
    }

    void releaseInclude(IncludeResult* result) override { delete result; }
};

EShLanguage language_of(std::string_view path) {
    return path.ends_with(".vert")   ? EShLangVertex
           : path.ends_with(".frag") ? EShLangFragment
                                     : EShLangCompute;
}

// glslang reports "ERROR: file:line: 'token' : message"; the first such line matters most.
std::string first_error(const std::string& log) {
    constexpr std::string_view prefix = "ERROR: ";
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(prefix))
            return line.substr(prefix.size());
    return log.substr(0, log.find('\n'));
}

} // namespace

std::vector<std::uint32_t> compile_shader(std::string_view path) {
    static const bool initialized = glslang::InitializeProcess();
    if (!initialized)
        throw std::runtime_error("cannot start the shader compiler");
    const std::string name(path);
    const EShLanguage language = language_of(name);
    const EmbeddedShader* found = find(name);
    if (!found)
        throw std::runtime_error(fmt::format("no shader is named {}", name));
    const char* source = found->text.data();
    const int length = static_cast<int>(found->text.size());
    const char* label = name.c_str();
    glslang::TShader shader(language);
    shader.setStringsWithLengthsAndNames(&source, &length, &label, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 110);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    Includer includer;
    constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), 450, false, messages, includer))
        throw std::runtime_error(first_error(shader.getInfoLog()));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages))
        throw std::runtime_error(fmt::format("{}: {}", name, first_error(program.getInfoLog())));
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(language), spirv);
    return spirv;
}

} // namespace gabor::viewer
