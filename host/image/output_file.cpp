#include "image/output_file.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fcntl.h>
#include <random>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <unistd.h>
#include <utility>

namespace gabor::image {

namespace fs = std::filesystem;

namespace {

constexpr mode_t everyone = 0666; // the umask applies

std::string reason(int error) {
    return std::generic_category().message(error);
}

[[noreturn]] void refuse(const fs::path& path, std::string_view what) {
    throw RequestError(fmt::format("cannot write {}: {}", path.string(), what));
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

/// Follows symbolic links to a file that may not exist.
fs::path resolve(fs::path path) {
    while (fs::is_symlink(fs::symlink_status(path)))
        path = path.parent_path() / fs::read_symlink(path);
    return path;
}

/// Returns the prefix of hidden names for `target`; eight hexadecimal digits follow.
std::string hidden_stem(const fs::path& target) {
    return fmt::format(".{}.gabor-",
                       target.filename().string().substr(0, 200)); // names are limited to 255 bytes
}

/// Calls `claim` with hidden names beside `target` until it does not fail with EEXIST. Returns the last name
/// and the result of `claim`, which is negative, with errno set, for any other error.
template <class Claim>
std::pair<fs::path, int> claim_name(const fs::path& target, Claim claim) {
    const std::string stem = hidden_stem(target);
    std::random_device random;
    for (;;) {
        fs::path name = folder_of(target) / fmt::format("{}{:08x}", stem, random());
        const int result = claim(name.c_str());
        if (result >= 0 || errno != EEXIST)
            return {std::move(name), result};
    }
}

/// Opens an unnamed file in `folder`. Returns a negative value if the file cannot be created, or could not be
/// given a name later.
int open_nameless(const fs::path& folder) {
    if (::access("/proc/self/fd", X_OK) != 0)
        return -1;
    return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, everyone);
}

/// Creates and locks the file `name`. If `remove_abandoned` deletes it before it is locked, the name
/// counts as taken.
int open_locked(const char* name) {
    const int descriptor = ::open(name, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, everyone);
    struct stat status {};
    if (descriptor < 0 || ::flock(descriptor, LOCK_EX) != 0 || ::fstat(descriptor, &status) != 0 ||
        status.st_nlink > 0)
        return descriptor;
    ::close(descriptor);
    errno = EEXIST;
    return -1;
}

/// Removes unlocked hidden files, which processes left behind when they were killed while writing `target`.
void remove_abandoned(const fs::path& target) {
    const std::string stem = hidden_stem(target);
    std::error_code ignored;
    for (fs::directory_iterator entry(folder_of(target), ignored), end; entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        if (name.size() != stem.size() + 8 || !name.starts_with(stem) ||
            !std::all_of(name.end() - 8, name.end(),
                         [](unsigned char digit) { return std::isxdigit(digit); }))
            continue;
        const int descriptor = ::open(entry->path().c_str(), O_WRONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
        if (descriptor < 0)
            continue;
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            ::unlink(entry->path().c_str());
        ::close(descriptor);
    }
}

/// Syncs the folder so that a rename survives a power cut. Failure is not an error: at worst the intact old
/// file comes back.
void sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::fsync(descriptor);
    ::close(descriptor);
}

} // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    const fs::file_status status = fs::status(path_, error);
    if (path_.empty())
        refuse(path_, "the name is empty; expected the path of a file");
    if (!path_.has_filename() || fs::is_directory(status))
        refuse(path_, "it is a folder; expected the path of a file");
    if (status.type() == fs::file_type::none)
        refuse(path_, error.message() + "; expected a file in an existing folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0)
            refuse(path_, reason(errno));
        sequential_ = ::lseek(descriptor_, 0, SEEK_CUR) < 0;
        return;
    }
    target_ = resolve(path_);
    const fs::path folder = folder_of(target_);
    descriptor_ = open_nameless(folder);
    if (descriptor_ >= 0) {
        ::flock(descriptor_, LOCK_EX);
        return;
    }
    std::tie(temporary_, descriptor_) = claim_name(target_, open_locked);
    if (descriptor_ < 0)
        refuse(path_, fmt::format("folder {}: {}; expected a file in an existing, writable folder",
                                  folder.string(), reason(errno)));
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (!temporary_.empty())
        ::unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written =
            sequential_ ? ::write(descriptor_, bytes.data(), bytes.size())
                        : ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(position_));
        if (written < 0) {
            if (errno == EINTR)
                continue;
            error_ = errno;
            fail(error_);
        }
        position_ += static_cast<std::uint64_t>(written);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void OutputFile::seek(std::uint64_t position) {
    if (sequential_ && position != position_)
        fail(ESPIPE);
    position_ = position;
}

void OutputFile::commit() {
    if (error_ != 0)
        fail(error_);
    if (!target_.empty())
        publish();
    ::close(std::exchange(descriptor_, -1));
}

void OutputFile::publish() {
    if (::fsync(descriptor_) != 0)
        fail(errno);
    if (temporary_.empty()) {
        const std::string data = fmt::format("/proc/self/fd/{}", descriptor_);
        const auto link_as = [&](const char* name) {
            return ::linkat(AT_FDCWD, data.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
        };
        if (link_as(target_.c_str()) == 0)
            return sync_folder(folder_of(target_));
        // Only a named file can replace another, so the new file briefly has a hidden name.
        const auto [name, result] = claim_name(target_, link_as);
        if (result < 0)
            fail(errno);
        temporary_ = name;
    }
    if (::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(errno);
    temporary_.clear();
    remove_abandoned(target_);
    sync_folder(folder_of(target_));
}

void OutputFile::fail(int error) const {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path_.string(), reason(error)));
}

OutputFolder::OutputFolder(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    created_ = fs::create_directory(path_, error);
    if (error)
        throw RequestError(fmt::format(
            "cannot create the folder '{}': {}; expected a folder, or a new name in an existing folder",
            path_.string(), error.message()));
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    if (created_)
        fs::remove(path_, ignored); // fails unless it is empty
}

} // namespace gabor::image
