#include "error.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <system_error>

namespace gabor::image {

namespace {

class Raw16 : public PictureReader {
  public:
    Raw16(const std::filesystem::path& path, int width, int height)
        : path_(path), file_(path, std::ios::binary) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(path, error);
        if (error || !file_)
            refuse_picture(path, error ? error.message() : "it cannot be opened");
        const std::uintmax_t wanted =
            std::uintmax_t{2} * static_cast<unsigned>(width) * static_cast<unsigned>(height);
        if (size != wanted)
            throw RequestError(fmt::format("'{}' has {} bytes, but {} x {} 16-bit heights take {}",
                                           path.string(), size, width, height, wanted));
        format_ = {width, height, 1, false};
        bytes_.resize(2 * static_cast<std::size_t>(width));
    }

    void read_row(std::span<float> row) override {
        if (!file_.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size())))
            refuse_picture(path_, "it ends early");
        const char* at = bytes_.data();
        fill(row, [&at] {
            const auto low = static_cast<std::uint8_t>(at[0]), high = static_cast<std::uint8_t>(at[1]);
            at += 2;
            return static_cast<float>(256 * high + low) / 65535.0f;
        });
    }

  private:
    std::filesystem::path path_;
    std::ifstream file_;
    std::vector<char> bytes_;
};

} // namespace

std::unique_ptr<PictureReader> open_raw16(const std::filesystem::path& path, int width, int height) {
    return std::make_unique<Raw16>(path, width, height);
}

} // namespace gabor::image
