#include "system/desktop.hpp"

#include "system/windows/windows.hpp"

#include <array>
#include <cstdlib>

namespace gabor::system {

namespace fs = std::filesystem;

namespace {

fs::path environment(const wchar_t* name) {
    const wchar_t* const value = ::_wgetenv(name);
    return value ? value : L"";
}

Font font(const char* name) {
    return {(environment(L"WINDIR") / "Fonts" / name).string(), 0};
}

} // namespace

const std::string_view how_to_get_vulkan =
    "install the newest driver from the maker of the GPU, which contains the loader, vulkan-1.dll";
const std::string_view how_to_get_a_driver = "install the newest one from the maker of the GPU";

fs::path home_folder() {
    return environment(L"USERPROFILE");
}

fs::path settings_folder() {
    return environment(L"APPDATA");
}

std::vector<std::string> drives() {
    std::vector<std::string> found;
    const DWORD present = ::GetLogicalDrives();
    for (unsigned i = 0; i < 26; ++i)
        if (present >> i & 1u)
            found.push_back({static_cast<char>('A' + i), ':', '\\'});
    return found;
}

Font sans_font() {
    for (const char* name : {"segoeui.ttf", "tahoma.ttf", "arial.ttf"})
        if (const Font found = font(name); fs::exists(found.first))
            return found;
    return {};
}

std::vector<Font> fonts_with(const std::vector<unsigned>&) {
    std::vector<Font> all;
    for (const char* name : {"YuGothM.ttc", // Japanese, and most Chinese characters
                             "msyh.ttc",    // Chinese
                             "malgun.ttf",  // Korean
                             "Nirmala.ttf", // the scripts of India; a .ttc since Windows 11
                             "Nirmala.ttc",
                             "LeelawUI.ttf", // Thai, Khmer, Lao
                             "ebrima.ttf",   // the scripts of Africa
                             "gadugi.ttf",   // Cherokee
                             "seguisym.ttf", // symbols
                             "arial.ttf"})   // Arabic and Hebrew
        all.push_back(font(name));
    return all;
}

} // namespace gabor::system
