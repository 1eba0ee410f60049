#pragma once

#include <filesystem>
#include <string_view>

namespace gabor::image {

/// Throws RequestError, "cannot read PATH: WHAT", with control characters removed.
[[noreturn]] void refuse_exr(const std::filesystem::path& path, std::string_view what);

/// Throws RequestError for a truncated or damaged file; `how` is OpenEXR's message.
[[noreturn]] void refuse_damaged_exr(const std::filesystem::path& path, std::string_view how);

/// Returns how many threads may decode the file. Throws RequestError if the file is not safe to open.
int inspect_exr(const std::filesystem::path& path);

} // namespace gabor::image
