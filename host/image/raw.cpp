#include "error.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace gabor::image {

namespace {

class Raw : public PictureReader {
  public:
    Raw(const std::filesystem::path& path, int width, int height, bool floats)
        : path_(path), file_(open_file(path)), floats_(floats),
          bytes_((floats ? 4 : 2) * static_cast<std::size_t>(width)) {
        const std::uintmax_t size = std::filesystem::file_size(path);
        const std::uintmax_t wanted = bytes_.size() * static_cast<std::uintmax_t>(height);
        if (size != wanted)
            throw RequestError(fmt::format("'{}' has {} bytes, but {} x {} heights of {} bits take {}",
                                           path.string(), size, width, height, floats ? 32 : 16, wanted));
        set_format({width, height, 1, false, floats, floats ? 32 : 16});
    }

    void read_row(std::span<float> row) override {
        if (std::fread(bytes_.data(), 1, bytes_.size(), file_.get()) != bytes_.size())
            refuse_picture(path_, "it ends early");
        fill(row, [this, at = bytes_.data()]() mutable {
            std::uint32_t value = 0;
            for (unsigned shift = 0; shift < (floats_ ? 32u : 16u); shift += 8)
                value |= static_cast<std::uint32_t>(*at++) << shift;
            return floats_ ? std::bit_cast<float>(value) : static_cast<float>(value) / 65535.0f;
        });
    }

  private:
    std::filesystem::path path_;
    File file_;
    bool floats_;
    std::vector<std::uint8_t> bytes_;
};

} // namespace

std::unique_ptr<PictureReader> open_raw(const std::filesystem::path& path, int width, int height,
                                        bool floats) {
    return std::make_unique<Raw>(path, width, height, floats);
}

} // namespace gabor::image
