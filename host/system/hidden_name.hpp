#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gabor::system {

/// The folder of a file; "." if the path has none.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// A random name beside `target` that is hidden on most systems: `.NAME.gabor-` plus eight hexadecimal
/// digits.
std::filesystem::path hidden_name(const std::filesystem::path& target);

/// The files beside `target` that have such names.
std::vector<std::filesystem::path> hidden_files(const std::filesystem::path& target);

} // namespace gabor::system
