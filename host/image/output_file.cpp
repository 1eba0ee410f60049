#include "image/output_file.hpp"

#include "error.hpp"
#include "system/hidden_name.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace gabor::image {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, std::string_view what) {
    throw RequestError(fmt::format("cannot write {}: {}", path.string(), what));
}

/// Follows symbolic links to a file that may not exist.
fs::path resolve(fs::path path) {
    while (fs::is_symlink(fs::symlink_status(path)))
        path = path.parent_path() / fs::read_symlink(path);
    return path;
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
    const bool in_place = system::is_device(path_);
    const fs::path target = in_place ? path_ : resolve(path_);
    try {
        file_.emplace(target, in_place);
    } catch (const std::system_error& failure) {
        const std::string reason = failure.code().message();
        refuse(path_, in_place ? reason
                               : fmt::format("folder {}: {}; expected a file in an existing, writable folder",
                                             system::folder_of(target).string(), reason));
    }
}

OutputFile::~OutputFile() = default;

void OutputFile::write(std::span<const std::byte> bytes) {
    try {
        while (!bytes.empty()) {
            const std::size_t written = file_->write(position_, bytes);
            position_ += written;
            bytes = bytes.subspan(written);
        }
    } catch (const std::system_error& failure) {
        error_ = failure.code();
        fail(error_);
    }
}

void OutputFile::seek(std::uint64_t position) {
    if (file_->sequential() && position != position_)
        fail(std::make_error_code(std::errc::invalid_seek));
    position_ = position;
}

void OutputFile::commit() {
    if (error_)
        fail(error_);
    try {
        file_->publish();
    } catch (const std::system_error& failure) {
        fail(failure.code());
    }
}

void OutputFile::fail(std::error_code error) const {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path_.string(), error.message()));
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
