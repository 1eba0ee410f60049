#include "system/new_file.hpp"
#include "system/hidden_name.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <unistd.h>
#include <utility>

namespace gabor::system {

namespace fs = std::filesystem;

namespace {

constexpr mode_t everyone = 0666; // the umask applies

[[noreturn]] void fail() {
    throw std::system_error(errno, std::generic_category());
}

/// Calls `claim` with hidden names beside `target` until it does not fail with EEXIST. Returns the last name
/// and the result of `claim`, which is negative, with errno set, for any other error.
template <class Claim>
std::pair<fs::path, int> claim_name(const fs::path& target, Claim claim) {
    for (;;) {
        fs::path name = hidden_name(target);
        const int result = claim(name.c_str());
        if (result >= 0 || errno != EEXIST)
            return {std::move(name), result};
    }
}

/// Opens an unnamed file in `folder`. Returns a negative value if the file cannot be created, or could not be
/// given a name later.
int open_nameless([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
    if (::access("/proc/self/fd", X_OK) == 0)
        return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, everyone);
#endif
    return -1;
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
    for (const fs::path& name : hidden_files(target)) {
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
        if (descriptor < 0)
            continue;
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            ::unlink(name.c_str());
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

struct NewFile::State {
    fs::path target;    ///< file to replace; empty when writing in place
    fs::path temporary; ///< hidden name; empty while the file has no name
    int descriptor = -1;
    bool sequential = false;

    ~State() {
        if (descriptor >= 0)
            ::close(descriptor);
        if (!temporary.empty())
            ::unlink(temporary.c_str());
    }
};

NewFile::NewFile(fs::path target, bool in_place) : state_(std::make_unique<State>()) {
    State& file = *state_;
    if (in_place) {
        file.descriptor = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
        if (file.descriptor < 0)
            fail();
        file.sequential = ::lseek(file.descriptor, 0, SEEK_CUR) < 0;
        return;
    }
    file.target = std::move(target);
    file.descriptor = open_nameless(folder_of(file.target));
    if (file.descriptor >= 0) {
        ::flock(file.descriptor, LOCK_EX);
        return;
    }
    fs::path name;
    std::tie(name, file.descriptor) = claim_name(file.target, open_locked);
    if (file.descriptor < 0)
        fail();
    file.temporary = std::move(name);
}

NewFile::~NewFile() = default;

bool NewFile::sequential() const {
    return state_->sequential;
}

std::size_t NewFile::write(std::uint64_t position, std::span<const std::byte> bytes) {
    for (;;) {
        const ssize_t written = state_->sequential ? ::write(state_->descriptor, bytes.data(), bytes.size())
                                                   : ::pwrite(state_->descriptor, bytes.data(), bytes.size(),
                                                              static_cast<off_t>(position));
        if (written >= 0)
            return static_cast<std::size_t>(written);
        if (errno != EINTR)
            fail();
    }
}

void NewFile::publish() {
    State& file = *state_;
    if (file.target.empty()) {
        ::close(std::exchange(file.descriptor, -1));
        return;
    }
    if (::fsync(file.descriptor) != 0)
        fail();
    bool published = false;
    if (file.temporary.empty()) {
        const std::string data = fmt::format("/proc/self/fd/{}", file.descriptor);
        const auto link_as = [&](const char* name) {
            return ::linkat(AT_FDCWD, data.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
        };
        published = link_as(file.target.c_str()) == 0;
        if (!published) {
            // Only a named file can replace another, so the new file briefly has a hidden name.
            auto [name, result] = claim_name(file.target, link_as);
            if (result < 0)
                fail();
            file.temporary = std::move(name);
        }
    }
    if (!published) {
        if (::rename(file.temporary.c_str(), file.target.c_str()) != 0)
            fail();
        file.temporary.clear();
        remove_abandoned(file.target);
    }
    sync_folder(folder_of(file.target));
    ::close(std::exchange(file.descriptor, -1));
}

bool is_device(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

bool is_pipe(const fs::path& path) {
    std::error_code ignored;
    return fs::is_fifo(path, ignored);
}

} // namespace gabor::system
