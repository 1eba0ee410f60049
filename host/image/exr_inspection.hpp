#pragma once

#include <filesystem>
#include <string_view>

namespace gabor::image {

/// Throws RequestError, "cannot read PATH: WHAT". Names from a foreign file do not break its line.
[[noreturn]] void refuse_exr(const std::filesystem::path& path, std::string_view what);

/// The same of a truncated or damaged file; `how` is what OpenEXR said.
[[noreturn]] void refuse_damaged_exr(const std::filesystem::path& path, std::string_view how);

/// How many threads may decode the file, if it is safe to open at all: throws RequestError where it is not.
int inspect_exr(const std::filesystem::path& path);

} // namespace gabor::image
