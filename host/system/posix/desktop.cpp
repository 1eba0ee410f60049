#include "system/desktop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>

namespace gabor::system {

namespace fs = std::filesystem;

namespace {

fs::path environment(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

} // namespace

#ifdef __APPLE__

const std::string_view how_to_get_vulkan =
    "install vulkan-loader and a driver (brew install vulkan-loader molten-vk)";
const std::string_view how_to_get_a_driver = "install one (brew install molten-vk)";

#else

const std::string_view how_to_get_vulkan =
    "install libvulkan1 and a driver (mesa-vulkan-drivers has one that needs no GPU)";
const std::string_view how_to_get_a_driver = "install one (mesa-vulkan-drivers has one that needs no GPU)";

#endif

fs::path home_folder() {
    return environment("HOME");
}

fs::path settings_folder() {
    if (fs::path folder = environment("XDG_CONFIG_HOME"); !folder.empty())
        return folder;
    const fs::path home = home_folder();
    return home.empty() ? home : home / ".config";
}

std::vector<std::string> drives() {
    return {};
}

Font sans_font() {
    for (const char* path : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                             "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                             "/System/Library/Fonts/Helvetica.ttc"}) // the last on macOS
        if (fs::exists(path))
            return {path, 0};
    return {};
}

// Asks fontconfig for the font that has most of the characters.
std::vector<Font> fonts_with(const std::vector<unsigned>& characters) {
    constexpr std::size_t enough = 64; // this many characters identify a script
    const std::size_t asked = std::min(characters.size(), enough);
    const std::string command = fmt::format("fc-match --format '%{{index}} %{{file}}' ':charset={:x}' 2>&-",
                                            fmt::join(std::span(characters).first(asked), " "));
    std::string said(4096, '\0');
#ifdef __GLIBC__
    constexpr const char* mode = "re"; // e: programs started later do not inherit the pipe
#else
    constexpr const char* mode = "r";
#endif
    if (std::FILE* const pipe = ::popen(command.c_str(), mode)) {
        said.resize(std::fread(said.data(), 1, said.size(), pipe));
        ::pclose(pipe);
    }
    const std::size_t space = said.find(' ');
    if (space == std::string::npos)
        return {};
    return {{said.substr(space + 1), std::atoi(said.c_str())}};
}

} // namespace gabor::system
