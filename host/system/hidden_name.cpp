#include "system/hidden_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <random>
#include <system_error>

namespace gabor::system {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t digits = 8;

std::string hidden_stem(const fs::path& target) {
    std::string name = target.filename().string();
    std::size_t length = std::min<std::size_t>(name.size(), 200); // names are limited to 255 bytes
    while (length < name.size() && (static_cast<unsigned char>(name[length]) & 0xc0u) == 0x80)
        --length; // not inside a letter of UTF-8
    name.resize(length);
    return fmt::format(".{}.gabor-", name);
}

} // namespace

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

fs::path hidden_name(const fs::path& target) {
    std::random_device random;
    return folder_of(target) / fmt::format("{}{:0{}x}", hidden_stem(target), random(), digits);
}

std::vector<fs::path> hidden_files(const fs::path& target) {
    const std::string stem = hidden_stem(target);
    std::vector<fs::path> found;
    std::error_code ignored;
    for (fs::directory_iterator entry(folder_of(target), ignored), end; entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (name.size() == stem.size() + digits && name.starts_with(stem) &&
            std::all_of(name.end() - digits, name.end(),
                        [](unsigned char digit) { return std::isxdigit(digit); }))
            found.push_back(entry->path());
    }
    return found;
}

} // namespace gabor::system
