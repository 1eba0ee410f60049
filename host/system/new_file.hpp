#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace gabor::system {

/// A file that is hidden until it is published. Every function throws std::system_error if it fails.
///
/// Linux: if the file system supports O_TMPFILE, the file has no name, so that even a killed process leaves
/// nothing behind. Otherwise, and for an instant while an existing file is replaced, it is a hidden file
/// `.NAME.gabor-` plus eight digits in the same folder. The writer locks it (flock); the next writer of NAME
/// removes hidden files that nobody has locked.
///
/// Windows: the hidden file is marked for deletion until it is published, so that a killed process leaves
/// nothing behind, but for an instant while the file gets its name. Nobody else can open it.
class NewFile {
  public:
    /// Opens a hidden file beside `target`, or, if `in_place`, the device or pipe `target` itself.
    NewFile(std::filesystem::path target, bool in_place);
    /// Removes the file unless it was published.
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// Whether it is a pipe or the like, which is written in order.
    bool sequential() const;
    /// Writes some of the bytes, at least one, and returns how many. A sequential file ignores the position.
    std::size_t write(std::uint64_t position, std::span<const std::byte> bytes);
    /// Flushes to disk and gives the file its name, replacing an existing file atomically. Closes it.
    void publish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Whether the path leads to a device or a pipe, which must be written in place.
bool is_device(const std::filesystem::path& path);
/// Whether the path leads to a pipe.
bool is_pipe(const std::filesystem::path& path);

} // namespace gabor::system
