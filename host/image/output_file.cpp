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
#include <unistd.h>
#include <utility>

namespace gabor::image {

namespace fs = std::filesystem;

namespace {

constexpr mode_t everyone = 0666; // less the umask, as for any new file

std::string reason(int error) {
    return std::generic_category().message(error);
}

[[noreturn]] void refuse(const fs::path& path, std::string_view what) {
    throw RequestError(fmt::format("cannot write {}: {}", path.string(), what));
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

/// The file that a chain of symbolic links ends at, whether it exists or not.
fs::path resolve(fs::path path) {
    while (fs::is_symlink(fs::symlink_status(path)))
        path = path.parent_path() / fs::read_symlink(path);
    return path;
}

/// What the hidden names of `target` begin with; eight hexadecimal digits follow.
std::string hidden_stem(const fs::path& target) {
    return fmt::format(".{}.gabor-",
                       target.filename().string().substr(0, 200)); // a name holds at most 255 bytes
}

/// Offers hidden names beside `target` to `claim` until one is not taken yet. Returns that name and what
/// `claim` made of it: negative, with errno set, when it failed for another reason.
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

/// A file without a name in `folder`, or negative where there is no such thing or no way to name it later.
int open_nameless(const fs::path& folder) {
    if (::access("/proc/self/fd", X_OK) != 0)
        return -1;
    return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, everyone);
}

/// Opens a new file under that name and locks it. A file that `remove_abandoned` took away before it was
/// locked counts as a name that is taken.
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

/// Removes what killed processes have left of earlier attempts to write `target`: hidden files of its that
/// nobody has locked any more.
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

/// Makes a rename last through a power cut. Without it the older file may come back, but whole: no error.
void sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::fsync(descriptor);
    ::close(descriptor);
}

} // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (!path_.has_filename())
        refuse(path_, path_.empty() ? "the name is empty; accepted is the path of a file"
                                    : "it is a folder; accepted is the path of a file");
    std::error_code error;
    const fs::file_status status = fs::status(path_, error);
    if (status.type() == fs::file_type::none)
        refuse(path_, error.message() + "; accepted is a file in an existing folder");
    if (fs::is_directory(status))
        refuse(path_, "it is a folder; accepted is the path of a file");

    if (!fs::exists(status) || fs::is_regular_file(status))
        target_ = resolve(path_);
    open();
}

void OutputFile::open() {
    if (target_.empty()) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0)
            refuse(path_, reason(errno));
        sequential_ = ::lseek(descriptor_, 0, SEEK_CUR) < 0;
        return;
    }
    const fs::path folder = folder_of(target_);
    descriptor_ = open_nameless(folder);
    if (descriptor_ >= 0) {
        ::flock(descriptor_, LOCK_EX);
        return;
    }
    auto [name, descriptor] = claim_name(target_, open_locked);
    if (descriptor < 0)
        refuse(path_,
               fmt::format("folder {}: {}; accepted is a file in an existing folder that can be written",
                           folder.string(), reason(errno)));
    temporary_ = std::move(name);
    descriptor_ = descriptor;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})), descriptor_(std::exchange(other.descriptor_, -1)),
      sequential_(other.sequential_), position_(other.position_) {}

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
            fail();
        }
        position_ += static_cast<std::uint64_t>(written);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void OutputFile::seek(std::uint64_t position) {
    if (sequential_ && position != position_) {
        errno = ESPIPE;
        fail();
    }
    position_ = position;
}

void OutputFile::commit() {
    if (!target_.empty())
        publish();
    ::close(std::exchange(descriptor_, -1));
}

void OutputFile::publish() {
    if (::fsync(descriptor_) != 0)
        fail();
    if (temporary_.empty()) {
        const std::string data = fmt::format("/proc/self/fd/{}", descriptor_);
        const auto link_as = [&](const char* name) {
            return ::linkat(AT_FDCWD, data.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
        };
        if (link_as(target_.c_str()) == 0)
            return sync_folder(folder_of(target_));
        // Only a file that has a name can replace another: for an instant there are two.
        auto [name, result] = claim_name(target_, link_as);
        if (result < 0)
            fail();
        temporary_ = std::move(name);
    }
    if (::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail();
    temporary_.clear();
    remove_abandoned(target_);
    sync_folder(folder_of(target_));
}

void OutputFile::fail() const {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path_.string(), reason(errno)));
}

const std::filesystem::path& not_a_pipe(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_fifo(path, ignored))
        throw RequestError(
            fmt::format("cannot write {}: it is a pipe; accepted is the path of a file", path.string()));
    return path;
}

} // namespace gabor::image
