#pragma once

#include "system/new_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

namespace gabor::image {

/// A file that appears under its name only when it is complete: a system::NewFile with messages for users.
///
/// A symbolic link is kept, and its target replaced. Existing files that are not regular, such as /dev/null
/// or a FIFO, are written to directly.
class OutputFile {
  public:
    /// Throws RequestError if no file with that name can be created.
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes at the current position. Throws std::runtime_error, naming the file, if writing fails; after
    /// that, `commit` fails too.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
    std::uint64_t position() const { return position_; }
    /// Sets the position of the next write. Throws std::runtime_error if the file is a pipe and the position
    /// changes.
    void seek(std::uint64_t position);

    /// Flushes to disk and publishes the file, replacing an existing one atomically.
    void commit();

    const std::filesystem::path& path() const { return path_; }

  private:
    [[noreturn]] void fail(std::error_code error) const;

    std::filesystem::path path_;
    std::optional<system::NewFile> file_;
    std::uint64_t position_ = 0;
    std::error_code error_; ///< of the last failed write
};

/// A folder for output files. The destructor removes the folder again if it was created here and is empty.
class OutputFolder {
  public:
    /// Creates the folder unless it exists. Throws RequestError if that fails.
    explicit OutputFolder(std::filesystem::path path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

  private:
    std::filesystem::path path_;
    bool created_;
};

} // namespace gabor::image
