#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace gabor::image {

/// A file that appears under its name only when it is complete. If the file system supports O_TMPFILE, it has
/// no name until `commit`, so that even a killed process leaves nothing behind. Otherwise, and for an instant
/// while an existing file is replaced, it is a hidden file `.NAME.gabor-` plus eight digits in the same
/// folder. The writer locks it (flock); the next writer of NAME removes hidden files that nobody has locked.
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
    void publish();
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    std::filesystem::path target_;    ///< file to replace; empty when writing directly to `path_`
    std::filesystem::path temporary_; ///< hidden name; empty while the file has no name
    int descriptor_ = -1;
    bool sequential_ = false;
    std::uint64_t position_ = 0;
    int error_ = 0; ///< errno of the last failed write; 0 if none has failed
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
