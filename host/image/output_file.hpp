#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace gabor::image {

/// A file that appears under its name only when it is complete. Until `commit` the data has no name at all
/// where the file system allows it (O_TMPFILE), so that even a killed process leaves nothing behind;
/// elsewhere, and for an instant while an older file is being replaced, it is the hidden file
/// `.NAME.gabor-` and eight digits in the same folder. The writer holds a lock (flock) on it, so that whoever
/// replaces NAME next knows one that a killed process has left, and removes it.
///
/// A symbolic link stays: what it points to is replaced. What exists and is no regular file, such as
/// /dev/null or a FIFO, is never replaced: the data goes straight into it.
class OutputFile {
  public:
    /// Throws RequestError when there can be no file of that name.
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    /// Writes at the current position. Throws std::runtime_error, naming the file, when the disk fails.
    void write(std::span<const std::byte> bytes);
    std::uint64_t position() const { return position_; }
    /// Throws std::runtime_error when the data goes into a pipe, which has only the current position.
    void seek(std::uint64_t position);

    /// Flushes to the disk and puts the file under its name, replacing an older one in a single step.
    void commit();

    /// The path as it was given.
    const std::filesystem::path& path() const { return path_; }

  private:
    void open();
    void publish();
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::filesystem::path target_;    ///< what to replace; empty when the data goes straight into `path_`
    std::filesystem::path temporary_; ///< empty while the data has no name
    int descriptor_ = -1;
    bool sequential_ = false;
    std::uint64_t position_ = 0;
};

/// The path, unless it is that of a pipe: throws RequestError. For formats that are not written in order.
const std::filesystem::path& not_a_pipe(const std::filesystem::path& path);

} // namespace gabor::image
