#pragma once

#include <cstdint>
#include <filesystem>

namespace gabor::viewer {

/// What tells whether a file is still the one that was read or written.
struct FileStamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const FileStamp&) const = default;
};

/// A file that does not exist, or that an editor is about to replace, has a stamp of its own.
inline FileStamp file_stamp(const std::filesystem::path& path) {
    std::error_code ignored;
    return {std::filesystem::last_write_time(path, ignored), std::filesystem::file_size(path, ignored)};
}

} // namespace gabor::viewer
