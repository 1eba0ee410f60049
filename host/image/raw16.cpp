#include "error.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace gabor::image {

namespace {

class Raw16 : public PictureReader {
  public:
    Raw16(const std::filesystem::path& path, int width, int height)
        : path_(path), file_(open_file(path)), bytes_(2 * static_cast<std::size_t>(width)) {
        const std::uintmax_t size = std::filesystem::file_size(path);
        const std::uintmax_t wanted = bytes_.size() * static_cast<std::uintmax_t>(height);
        if (size != wanted)
            throw RequestError(fmt::format("'{}' has {} bytes, but {} x {} 16-bit heights take {}",
                                           path.string(), size, width, height, wanted));
        set_format({width, height, 1, false});
    }

    void read_row(std::span<float> row) override {
        if (std::fread(bytes_.data(), 1, bytes_.size(), file_.get()) != bytes_.size())
            refuse_picture(path_, "it ends early");
        fill(row, [at = bytes_.data()]() mutable {
            const int low = *at++;
            return static_cast<float>(256 * *at++ + low) / 65535.0f;
        });
    }

  private:
    std::filesystem::path path_;
    File file_;
    std::vector<std::uint8_t> bytes_;
};

} // namespace

std::unique_ptr<PictureReader> open_raw16(const std::filesystem::path& path, int width, int height) {
    return std::make_unique<Raw16>(path, width, height);
}

} // namespace gabor::image
