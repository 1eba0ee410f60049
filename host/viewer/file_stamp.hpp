#pragma once

#include <cstdint>
#include <filesystem>

namespace gabor::viewer {

/// Tells whether a file has changed since it was read or written.
struct FileStamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const FileStamp&) const = default;
};

/// Returns a file's stamp. Missing files have one too.
inline FileStamp file_stamp(const std::filesystem::path& path) {
    std::error_code ignored;
    return {std::filesystem::last_write_time(path, ignored), std::filesystem::file_size(path, ignored)};
}

} // namespace gabor::viewer
