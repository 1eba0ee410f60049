#include "system/new_file.hpp"
#include "system/hidden_name.hpp"
#include "system/windows/windows.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gabor::system {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 255; // in units of UTF-16

// FileRenameInfoEx and its flags, which Windows 10 has since 2016, and not every compiler's headers.
constexpr auto rename_info_ex = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22);
constexpr DWORD replace_if_exists = 1, posix_semantics = 2, ignore_readonly_attribute = 0x40;

/// Opens a file that only this handle can change or delete. Returns null, with the last error set, if that
/// fails.
Handle open(const fs::path& path, DWORD access, DWORD creation) {
    const HANDLE handle = ::CreateFileW(path.c_str(), access, FILE_SHARE_READ, nullptr, creation,
                                        FILE_ATTRIBUTE_NORMAL, nullptr);
    return Handle(handle == INVALID_HANDLE_VALUE ? nullptr : handle);
}

/// Sets whether Windows deletes the file when its last handle is closed, even if the process is killed.
bool delete_on_close(HANDLE file, bool wanted) {
    FILE_DISPOSITION_INFO info{};
    info.DeleteFile = wanted;
    return ::SetFileInformationByHandle(file, FileDispositionInfo, &info, sizeof info);
}

/// Renames the file, and replaces an existing one. Returns false, with the last error set, if that fails.
bool rename(HANDLE file, const fs::path& to, FILE_INFO_BY_HANDLE_CLASS kind, DWORD flags) {
    const std::wstring name = fs::absolute(to).wstring();
    std::vector<std::byte> bytes(sizeof(FILE_RENAME_INFO) + sizeof(wchar_t) * name.size());
    auto& info = *reinterpret_cast<FILE_RENAME_INFO*>(bytes.data());
    std::memcpy(&info, &flags, sizeof flags); // ReplaceIfExists or, in the newer kind, the flags
    info.FileNameLength = static_cast<DWORD>(sizeof(wchar_t) * name.size());
    std::memcpy(info.FileName, name.c_str(), sizeof(wchar_t) * (name.size() + 1));
    return ::SetFileInformationByHandle(file, kind, &info, static_cast<DWORD>(bytes.size()));
}

/// Replaces even a file that is read-only, as on other systems, or open in a program that permits it.
bool replace(HANDLE file, const fs::path& target) {
    if (rename(file, target, rename_info_ex, replace_if_exists | posix_semantics | ignore_readonly_attribute))
        return true;
    // Not every file system, server and version of Windows knows this.
    if (rename(file, target, FileRenameInfo, TRUE))
        return true;
    const DWORD error = ::GetLastError();
    const DWORD attributes = ::GetFileAttributesW(target.c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES || !(attributes & FILE_ATTRIBUTE_READONLY) ||
        !::SetFileAttributesW(target.c_str(), attributes & ~static_cast<DWORD>(FILE_ATTRIBUTE_READONLY))) {
        ::SetLastError(error);
        return false;
    }
    if (rename(file, target, FileRenameInfo, TRUE))
        return true;
    const DWORD last = ::GetLastError();
    ::SetFileAttributesW(target.c_str(), attributes);
    ::SetLastError(last);
    return false;
}

/// The path as Windows reads it: devices such as NUL become \\.\NUL.
std::wstring full_path(const fs::path& path) {
    std::wstring full(::GetFullPathNameW(path.c_str(), 0, nullptr, nullptr), L'\0');
    full.resize(::GetFullPathNameW(path.c_str(), static_cast<DWORD>(full.size()), full.data(), nullptr));
    return full;
}

} // namespace

struct NewFile::State {
    fs::path target; ///< file to replace; empty when writing in place
    Handle file = nullptr;
    bool sequential = false;
};

NewFile::NewFile(fs::path target, bool in_place) : state_(std::make_unique<State>()) {
    State& file = *state_;
    if (in_place) {
        file.file = open(target, GENERIC_WRITE, OPEN_EXISTING);
        if (!file.file)
            fail();
        file.sequential = ::GetFileType(file.file.get()) == FILE_TYPE_PIPE;
        return;
    }
    if (target.filename().native().size() > longest_name)
        fail(ERROR_FILENAME_EXCED_RANGE);
    file.target = std::move(target);
    do
        file.file = open(hidden_name(file.target), GENERIC_WRITE | DELETE, CREATE_NEW);
    while (!file.file && ::GetLastError() == ERROR_FILE_EXISTS);
    if (!file.file)
        fail();
    delete_on_close(file.file.get(), true); // if the file system cannot, the next writer removes the file
}

NewFile::~NewFile() {
    if (state_->file && !state_->target.empty())
        delete_on_close(state_->file.get(), true);
}

bool NewFile::sequential() const {
    return state_->sequential;
}

std::size_t NewFile::write(std::uint64_t position, std::span<const std::byte> bytes) {
    constexpr std::size_t most = 1 << 30; // WriteFile counts in 32 bits
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(position);
    place.OffsetHigh = static_cast<DWORD>(position >> 32);
    DWORD written = 0;
    if (!::WriteFile(state_->file.get(), bytes.data(), static_cast<DWORD>(std::min(bytes.size(), most)),
                     &written, state_->sequential ? nullptr : &place))
        fail();
    return written;
}

void NewFile::publish() {
    State& file = *state_;
    if (!file.target.empty()) {
        if (!::FlushFileBuffers(file.file.get()))
            fail();
        delete_on_close(file.file.get(), false);
        // Another writer may just be closing the target, and scanners open new files for an instant.
        for (int tries = 1; !replace(file.file.get(), file.target); ++tries) {
            const DWORD error = ::GetLastError();
            if (tries == 20 || (error != ERROR_ACCESS_DENIED && error != ERROR_SHARING_VIOLATION))
                fail(error);
            ::Sleep(50);
        }
        // Remove what a process left that was killed while it named its file. Open files stay.
        for (const fs::path& name : hidden_files(std::exchange(file.target, {})))
            ::DeleteFileW(name.c_str());
    }
    file.file.reset();
}

bool is_device(const fs::path& path) {
    return full_path(path).starts_with(L"\\\\.\\");
}

bool is_pipe(const fs::path& path) {
    return full_path(path).starts_with(L"\\\\.\\pipe\\");
}

} // namespace gabor::system
